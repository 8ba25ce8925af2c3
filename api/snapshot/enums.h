// GLenums to pipeline types. The values are known to be valid: commands checked them.
#pragma once

#include <GL/gl.h>

#include "pipeline/draw/draw_state.h"

namespace gouraud::api {

static_assert(GL_POINTS == 0 && GL_POLYGON == 9 && GL_NEVER + 7 == GL_ALWAYS);

/// GL_POINTS .. GL_POLYGON.
constexpr pipeline::PrimitiveMode primitive_mode(GLenum mode) {
  return static_cast<pipeline::PrimitiveMode>(mode);
}

/// GL_NEVER .. GL_ALWAYS.
constexpr pipeline::CompareFunc compare_func(GLenum func) {
  return static_cast<pipeline::CompareFunc>(func - GL_NEVER);
}

constexpr pipeline::PolygonMode polygon_mode(GLenum mode) {
  return mode == GL_POINT  ? pipeline::PolygonMode::point
         : mode == GL_LINE ? pipeline::PolygonMode::line
                           : pipeline::PolygonMode::fill;
}

constexpr pipeline::CullMode cull_mode(GLenum face) {
  return face == GL_FRONT  ? pipeline::CullMode::front
         : face == GL_BACK ? pipeline::CullMode::back
                           : pipeline::CullMode::front_and_back;
}

constexpr std::uint8_t material_bits(GLenum parameter) {
  switch (parameter) {
    case GL_AMBIENT:
      return pipeline::material_ambient;
    case GL_DIFFUSE:
      return pipeline::material_diffuse;
    case GL_SPECULAR:
      return pipeline::material_specular;
    case GL_EMISSION:
      return pipeline::material_emission;
    default:
      return pipeline::material_ambient | pipeline::material_diffuse;
  }
}

}  // namespace gouraud::api
