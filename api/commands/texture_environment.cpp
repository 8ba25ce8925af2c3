// Takes parameters, gives those of a unit's environment [GL1.5 §3.8.13, Tables 3.22 to 3.26].
#include "api/commands/texture_environment.h"

#include "api/commands/clamped.h"
#include "api/commands/float_parameters.h"
#include "api/commands/state_rows.h"
#include "api/commands/texture_targets.h"

namespace gouraud::api {
namespace {

bool is_mode(GLenum mode) {
  return mode == GL_MODULATE || mode == GL_REPLACE || mode == GL_DECAL || mode == GL_BLEND || mode == GL_ADD ||
         mode == GL_COMBINE;
}

bool is_combine_function(GLenum function, bool of_alpha) {
  switch (function) {
    case GL_REPLACE:
    case GL_MODULATE:
    case GL_ADD:
    case GL_ADD_SIGNED:
    case GL_INTERPOLATE:
    case GL_SUBTRACT:
      return true;
    case GL_DOT3_RGB:
    case GL_DOT3_RGBA:
    case GL_DOT3_RGB_EXT:
    case GL_DOT3_RGBA_EXT:
      return !of_alpha;
    default:
      return false;
  }
}

bool is_source(GLenum source) {
  return source == GL_TEXTURE || source == GL_CONSTANT || source == GL_PRIMARY_COLOR || source == GL_PREVIOUS ||
         source - GL_TEXTURE0 < static_cast<GLenum>(max_texture_units);
}

bool is_operand(GLenum operand, bool of_alpha) {
  const bool color = operand == GL_SRC_COLOR || operand == GL_ONE_MINUS_SRC_COLOR;
  return operand == GL_SRC_ALPHA || operand == GL_ONE_MINUS_SRC_ALPHA || (color && !of_alpha);
}

/// Where a parameter of TEXTURE_ENV lies. `name` is null for the colour, the scales and what is no parameter.
struct Place {
  enum class Kind { mode, function, source, operand } kind = Kind::mode;
  GLenum* name = nullptr;
  bool of_alpha = false;

  bool allows(GLenum value) const {
    switch (kind) {
      case Kind::mode: return is_mode(value);
      case Kind::function: return is_combine_function(value, of_alpha);
      case Kind::source: return is_source(value);
      case Kind::operand: return is_operand(value, of_alpha);
    }
    return false;
  }
};

Place find_place(TextureEnvironmentParameters& e, GLenum pname) {
  using enum Place::Kind;
  if (pname - GL_SRC0_RGB < 3) return {source, &e.rgb.source[pname - GL_SRC0_RGB]};
  if (pname - GL_SRC0_ALPHA < 3) return {source, &e.alpha.source[pname - GL_SRC0_ALPHA], true};
  if (pname - GL_OPERAND0_RGB < 3) return {operand, &e.rgb.operand[pname - GL_OPERAND0_RGB]};
  if (pname - GL_OPERAND0_ALPHA < 3) return {operand, &e.alpha.operand[pname - GL_OPERAND0_ALPHA], true};
  switch (pname) {
    case GL_TEXTURE_ENV_MODE: return {mode, &e.mode};
    case GL_COMBINE_RGB: return {function, &e.rgb.function};
    case GL_COMBINE_ALPHA: return {function, &e.alpha.function, true};
    default: return {};
  }
}

GLenum set_environment(TextureEnvironmentParameters& e, GLenum pname, const GLfloat* params) {
  if (const Place place = find_place(e, pname); place.name != nullptr) {
    GLenum value = to_enum(params[0]);
    // [EXT_texture]: a number of its own for the same.
    if (place.kind == Place::Kind::mode && value == GL_REPLACE_EXT) value = GL_REPLACE;
    if (!place.allows(value)) return GL_INVALID_ENUM;
    *place.name = value;
    return GL_NO_ERROR;
  }
  switch (pname) {
    case GL_TEXTURE_ENV_COLOR:
      e.color = clamped(glm::vec4(params[0], params[1], params[2], params[3]));
      return GL_NO_ERROR;
    case GL_RGB_SCALE:
    case GL_ALPHA_SCALE:
      if (params[0] != 1.0f && params[0] != 2.0f && params[0] != 4.0f) return GL_INVALID_VALUE;
      (pname == GL_RGB_SCALE ? e.rgb : e.alpha).scale = params[0];
      return GL_NO_ERROR;
    default:
      return GL_INVALID_ENUM;
  }
}

/// The active unit's bit of PointGroup::coord_replace.
unsigned sprite_bit(const Context& context) { return 1u << context.state.texture.active_unit; }

/// [ARB_point_sprite]: a boolean, of the point group.
GLenum set_point_sprite(Context& context, GLenum pname, GLfloat value) {
  if (pname != GL_COORD_REPLACE_ARB) return GL_INVALID_ENUM;
  if (value != 0.0f && value != 1.0f) return GL_INVALID_VALUE;
  std::uint8_t& units = context.state.point.coord_replace;
  units = static_cast<std::uint8_t>(value != 0.0f ? units | sprite_bit(context) : units & ~sprite_bit(context));
  return GL_NO_ERROR;
}

GLenum set_parameter(Context& context, GLenum target, GLenum pname, const GLfloat* params) {
  TextureEnvironmentParameters& e = active_unit(context).environment;
  switch (target) {
    case GL_TEXTURE_ENV:
      return set_environment(e, pname, params);
    case GL_TEXTURE_FILTER_CONTROL:
      if (pname != GL_TEXTURE_LOD_BIAS) return GL_INVALID_ENUM;
      e.lod_bias = params[0];
      return GL_NO_ERROR;
    case GL_POINT_SPRITE_ARB:
      return set_point_sprite(context, pname, params[0]);
    default:
      return GL_INVALID_ENUM;
  }
}

template <class T, class Convert>
void get(Context& context, const char* command, GLenum target, GLenum pname, T* params, Convert convert) {
  TextureEnvironmentParameters& e = active_unit(context).environment;
  const auto give = [&](double value, ValueKind kind) { params[0] = convert(value, kind); };
  if (target == GL_TEXTURE_FILTER_CONTROL && pname == GL_TEXTURE_LOD_BIAS) return give(e.lod_bias, ValueKind::real);
  if (target == GL_POINT_SPRITE_ARB && pname == GL_COORD_REPLACE_ARB) {
    return give((context.state.point.coord_replace & sprite_bit(context)) != 0, ValueKind::boolean);
  }
  if (target == GL_TEXTURE_ENV) {
    if (const Place place = find_place(e, pname); place.name != nullptr) return give(*place.name, ValueKind::integer);
    if (pname == GL_RGB_SCALE) return give(e.rgb.scale, ValueKind::real);
    if (pname == GL_ALPHA_SCALE) return give(e.alpha.scale, ValueKind::real);
    if (pname == GL_TEXTURE_ENV_COLOR) {
      for (int i = 0; i < 4; ++i) params[i] = convert(e.color[i], ValueKind::normalized);
      return;
    }
  }
  context.record_error(GL_INVALID_ENUM, command, "target or pname is unknown");
}

}  // namespace

void TexEnvfv(Context& context, GLenum target, GLenum pname, const GLfloat* params) {
  const GLenum error = set_parameter(context, target, pname, params);
  if (error != GL_NO_ERROR) return context.record_error(error, "glTexEnv", "target, pname or its value is not allowed");
  context.change(dirty_textures);
}

void GetTexEnvfv(Context& context, GLenum target, GLenum pname, GLfloat* params) {
  get(context, "glGetTexEnvfv", target, pname, params,
      [](double value, ValueKind) { return static_cast<GLfloat>(value); });
}

void GetTexEnviv(Context& context, GLenum target, GLenum pname, GLint* params) {
  get(context, "glGetTexEnviv", target, pname, params, to_integer);
}

}  // namespace gouraud::api
