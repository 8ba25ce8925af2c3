// GLenums to pipeline types. The values are known to be valid: commands checked them.
#pragma once

#include <GL/gl.h>

#include "pipeline/draw/draw_state.h"

namespace gouraud::api {

static_assert(GL_POINTS == 0 && GL_POLYGON == 9 && GL_NEVER + 7 == GL_ALWAYS && GL_CLEAR + 15 == GL_SET);

/// GL_POINTS .. GL_POLYGON.
constexpr pipeline::PrimitiveMode primitive_mode(GLenum mode) {
  return static_cast<pipeline::PrimitiveMode>(mode);
}

/// GL_NEVER .. GL_ALWAYS.
constexpr pipeline::CompareFunc compare_func(GLenum func) {
  return static_cast<pipeline::CompareFunc>(func - GL_NEVER);
}

/// GL_CLEAR .. GL_SET.
constexpr pipeline::LogicOp logic_op(GLenum op) {
  return static_cast<pipeline::LogicOp>(op - GL_CLEAR);
}

constexpr pipeline::StencilOp stencil_op(GLenum op) {
  using enum pipeline::StencilOp;
  switch (op) {
    case GL_ZERO: return zero;
    case GL_REPLACE: return replace;
    case GL_INCR: return increment;
    case GL_DECR: return decrement;
    case GL_INVERT: return invert;
    case GL_INCR_WRAP: return increment_wrap;
    case GL_DECR_WRAP: return decrement_wrap;
    default: return keep;
  }
}

constexpr pipeline::AccumOp accum_op(GLenum op) {
  using enum pipeline::AccumOp;
  switch (op) {
    case GL_LOAD: return load;
    case GL_ADD: return add;
    case GL_MULT: return multiply;
    case GL_RETURN: return give_back;
    default: return accumulate;
  }
}

constexpr pipeline::BlendEquation blend_equation(GLenum mode) {
  using enum pipeline::BlendEquation;
  return mode == GL_MIN                     ? min
         : mode == GL_MAX                   ? max
         : mode == GL_FUNC_SUBTRACT         ? subtract
         : mode == GL_FUNC_REVERSE_SUBTRACT ? reverse_subtract
                                            : add;
}

constexpr pipeline::BlendFactor blend_factor(GLenum factor) {
  using enum pipeline::BlendFactor;
  switch (factor) {
    case GL_ONE: return one;
    case GL_SRC_COLOR: return source_color;
    case GL_ONE_MINUS_SRC_COLOR: return one_minus_source_color;
    case GL_DST_COLOR: return destination_color;
    case GL_ONE_MINUS_DST_COLOR: return one_minus_destination_color;
    case GL_SRC_ALPHA: return source_alpha;
    case GL_ONE_MINUS_SRC_ALPHA: return one_minus_source_alpha;
    case GL_DST_ALPHA: return destination_alpha;
    case GL_ONE_MINUS_DST_ALPHA: return one_minus_destination_alpha;
    case GL_CONSTANT_COLOR: return constant_color;
    case GL_ONE_MINUS_CONSTANT_COLOR: return one_minus_constant_color;
    case GL_CONSTANT_ALPHA: return constant_alpha;
    case GL_ONE_MINUS_CONSTANT_ALPHA: return one_minus_constant_alpha;
    case GL_SRC_ALPHA_SATURATE: return source_alpha_saturate;
    default: return zero;
  }
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

inline pipeline::FogMode fog_mode(GLenum mode) {
  return mode == GL_LINEAR ? pipeline::FogMode::linear : mode == GL_EXP2 ? pipeline::FogMode::exp2 : pipeline::FogMode::exp;
}

inline pipeline::TexgenMode texgen_mode(GLenum mode) {
  switch (mode) {
    case GL_OBJECT_LINEAR:
      return pipeline::TexgenMode::object_linear;
    case GL_SPHERE_MAP:
      return pipeline::TexgenMode::sphere_map;
    case GL_NORMAL_MAP:
      return pipeline::TexgenMode::normal_map;
    case GL_REFLECTION_MAP:
      return pipeline::TexgenMode::reflection_map;
    default:
      return pipeline::TexgenMode::eye_linear;
  }
}

}  // namespace gouraud::api
