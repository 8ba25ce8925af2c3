#include "api/commands/fog.h"

#include <optional>

#include "api/commands/clamped.h"
#include "api/commands/state_rows.h"

namespace gouraud::api {
namespace {

using enum ValueKind;

// The name that the float stands for, if it is one of these.
std::optional<GLenum> name_among(GLfloat value, std::initializer_list<GLenum> names) {
  for (const GLenum name : names) {
    if (value == static_cast<GLfloat>(name)) return name;
  }
  return std::nullopt;
}

constexpr StateRow rows[] = {
    {GL_FOG_COLOR, normalized, 4, [](const Context& c, StateValue& v) { set(v, c.state.fog.color); }},
    {GL_FOG_INDEX, real, 1, [](const Context& c, StateValue& v) { set(v, c.state.fog.index); }},
    {GL_FOG_DENSITY, real, 1, [](const Context& c, StateValue& v) { set(v, c.state.fog.density); }},
    {GL_FOG_START, real, 1, [](const Context& c, StateValue& v) { set(v, c.state.fog.start); }},
    {GL_FOG_END, real, 1, [](const Context& c, StateValue& v) { set(v, c.state.fog.end); }},
    {GL_FOG_MODE, integer, 1, [](const Context& c, StateValue& v) { set(v, c.state.fog.mode); }},
    {GL_FOG_COORD_SRC, integer, 1, [](const Context& c, StateValue& v) { set(v, c.state.fog.coordinate_source); }},
};

}  // namespace

std::span<const StateRow> fog_rows() {
  return rows;
}

void Fogfv(Context& context, GLenum pname, const GLfloat* params) {
  FogGroup& fog = context.state.fog;
  switch (pname) {
    case GL_FOG_MODE: {
      const auto mode = name_among(params[0], {GL_LINEAR, GL_EXP, GL_EXP2});
      if (!mode) return context.record_error(GL_INVALID_ENUM, "glFog", "no such fog mode");
      fog.mode = *mode;
      break;
    }
    case GL_FOG_COORD_SRC: {
      const auto source = name_among(params[0], {GL_FOG_COORD, GL_FRAGMENT_DEPTH});
      if (!source) return context.record_error(GL_INVALID_ENUM, "glFog", "no such source of fog coordinates");
      fog.coordinate_source = *source;
      break;
    }
    case GL_FOG_DENSITY:
      if (!(params[0] >= 0.0f)) return context.record_error(GL_INVALID_VALUE, "glFog", "the density is negative");
      fog.density = params[0];
      break;
    case GL_FOG_START:
      fog.start = params[0];
      break;
    case GL_FOG_END:
      fog.end = params[0];
      break;
    case GL_FOG_INDEX:
      fog.index = params[0];
      break;
    case GL_FOG_COLOR:
      fog.color = clamped(glm::vec4(params[0], params[1], params[2], params[3]));
      break;
    default:
      return context.record_error(GL_INVALID_ENUM, "glFog", "pname is unknown");
  }
  context.change(dirty_raster);
}

}  // namespace gouraud::api
