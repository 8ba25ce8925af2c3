// Takes parameters, gives those of texture objects [GL1.5 §3.8.4], with EXT_texture_filter_anisotropic,
// EXT_texture_lod_bias, ARB_texture_rectangle and ARB_texture_rg (depths as red).
#include "api/commands/texture_parameters.h"

#include <algorithm>

#include "api/commands/clamped.h"
#include "api/commands/float_parameters.h"
#include "api/commands/state_rows.h"
#include "api/commands/texture_targets.h"

namespace gouraud::api {
namespace {

bool is_wrap_mode(GLenum mode, TextureTarget target) {
  switch (mode) {
    case GL_CLAMP:
    case GL_CLAMP_TO_EDGE:
    case GL_CLAMP_TO_BORDER:
      return true;
    case GL_REPEAT:
    case GL_MIRRORED_REPEAT:
    case GL_MIRROR_CLAMP_EXT:
    case GL_MIRROR_CLAMP_TO_EDGE_EXT:
    case GL_MIRROR_CLAMP_TO_BORDER_EXT:
      return target != TextureTarget::rectangle;
    default:
      return false;
  }
}

bool is_min_filter(GLenum filter, TextureTarget target) {
  if (filter == GL_NEAREST || filter == GL_LINEAR) return true;
  return filter - GL_NEAREST_MIPMAP_NEAREST <= GL_LINEAR_MIPMAP_LINEAR - GL_NEAREST_MIPMAP_NEAREST &&
         target != TextureTarget::rectangle;
}

/// Sets an enum if it is one of the allowed ones.
bool set_enum(GLenum& parameter, GLenum value, bool allowed) {
  if (allowed) parameter = value;
  return allowed;
}

GLenum set_wrap(TextureParameters& p, std::size_t coordinate, GLenum mode, TextureTarget target) {
  return set_enum(p.wrap[coordinate], mode, is_wrap_mode(mode, target)) ? GL_NO_ERROR : GL_INVALID_ENUM;
}

GLenum set_level(GLint& level, GLfloat value, bool only_zero) {
  const GLint wanted = to_level(value);
  if (wanted < 0) return GL_INVALID_VALUE;
  if (only_zero && wanted != 0) return GL_INVALID_OPERATION;
  level = wanted;
  return GL_NO_ERROR;
}

/// The error, and nothing is changed, or GL_NO_ERROR.
GLenum set_parameter(TextureParameters& p, TextureTarget target, GLenum pname, const GLfloat* params) {
  const GLfloat value = params[0];
  const GLenum name = to_enum(value);
  const auto choose = [name](GLenum& parameter, bool allowed) -> GLenum {
    return set_enum(parameter, name, allowed) ? GL_NO_ERROR : GL_INVALID_ENUM;
  };
  const auto set_number = [value](float& parameter) -> GLenum {
    parameter = value;
    return GL_NO_ERROR;
  };
  switch (pname) {
    case GL_TEXTURE_WRAP_S: return set_wrap(p, 0, name, target);
    case GL_TEXTURE_WRAP_T: return set_wrap(p, 1, name, target);
    case GL_TEXTURE_WRAP_R: return set_wrap(p, 2, name, target);
    case GL_TEXTURE_MIN_FILTER: return choose(p.min_filter, is_min_filter(name, target));
    case GL_TEXTURE_MAG_FILTER: return choose(p.mag_filter, name == GL_NEAREST || name == GL_LINEAR);
    case GL_DEPTH_TEXTURE_MODE:
      return choose(p.depth_mode, name == GL_LUMINANCE || name == GL_INTENSITY || name == GL_ALPHA || name == GL_RED);
    case GL_TEXTURE_COMPARE_MODE: return choose(p.compare_mode, name == GL_NONE || name == GL_COMPARE_R_TO_TEXTURE);
    case GL_TEXTURE_COMPARE_FUNC: return choose(p.compare_func, name - GL_NEVER <= GL_ALWAYS - GL_NEVER);
    case GL_TEXTURE_BORDER_COLOR:
      p.border_color = clamped(glm::vec4(params[0], params[1], params[2], params[3]));
      return GL_NO_ERROR;
    case GL_TEXTURE_PRIORITY:
      p.priority = clamped(value);
      return GL_NO_ERROR;
    case GL_GENERATE_MIPMAP:
      p.generate_mipmap = value != 0.0f;
      return GL_NO_ERROR;
    case GL_TEXTURE_MIN_LOD: return set_number(p.min_lod);
    case GL_TEXTURE_MAX_LOD: return set_number(p.max_lod);
    case GL_TEXTURE_LOD_BIAS: return set_number(p.lod_bias);
    case GL_TEXTURE_BASE_LEVEL: return set_level(p.base_level, value, target == TextureTarget::rectangle);
    case GL_TEXTURE_MAX_LEVEL: return set_level(p.max_level, value, false);
    case GL_TEXTURE_MAX_ANISOTROPY_EXT:
      if (!(value >= 1.0f)) return GL_INVALID_VALUE;
      p.max_anisotropy = std::min(value, max_texture_anisotropy);
      return GL_NO_ERROR;
    default: return GL_INVALID_ENUM;
  }
}

struct Parameter {
  int count = 0;  ///< 0: no such parameter
  ValueKind kind = ValueKind::integer;
  StateValue value{};
};

template <class... Numbers>
Parameter parameter(ValueKind kind, Numbers... numbers) {
  Parameter result{sizeof...(numbers), kind};
  set(result.value, numbers...);
  return result;
}

Parameter find_parameter(const TextureParameters& p, GLenum pname) {
  using enum ValueKind;
  switch (pname) {
    case GL_TEXTURE_WRAP_S: return parameter(integer, p.wrap[0]);
    case GL_TEXTURE_WRAP_T: return parameter(integer, p.wrap[1]);
    case GL_TEXTURE_WRAP_R: return parameter(integer, p.wrap[2]);
    case GL_TEXTURE_MIN_FILTER: return parameter(integer, p.min_filter);
    case GL_TEXTURE_MAG_FILTER: return parameter(integer, p.mag_filter);
    case GL_DEPTH_TEXTURE_MODE: return parameter(integer, p.depth_mode);
    case GL_TEXTURE_COMPARE_MODE: return parameter(integer, p.compare_mode);
    case GL_TEXTURE_COMPARE_FUNC: return parameter(integer, p.compare_func);
    case GL_TEXTURE_BORDER_COLOR: {
      const glm::vec4& c = p.border_color;
      return parameter(normalized, c.x, c.y, c.z, c.w);
    }
    case GL_TEXTURE_PRIORITY: return parameter(normalized, p.priority);
    case GL_TEXTURE_RESIDENT: return parameter(boolean, true);
    case GL_GENERATE_MIPMAP: return parameter(boolean, p.generate_mipmap);
    case GL_TEXTURE_MIN_LOD: return parameter(real, p.min_lod);
    case GL_TEXTURE_MAX_LOD: return parameter(real, p.max_lod);
    case GL_TEXTURE_LOD_BIAS: return parameter(real, p.lod_bias);
    case GL_TEXTURE_BASE_LEVEL: return parameter(integer, p.base_level);
    case GL_TEXTURE_MAX_LEVEL: return parameter(integer, p.max_level);
    case GL_TEXTURE_MAX_ANISOTROPY_EXT: return parameter(real, p.max_anisotropy);
    default: return {};
  }
}

template <class T, class Convert>
void get(Context& context, const char* command, GLenum target, GLenum pname, T* params, Convert convert) {
  const auto which = texture_target(target);
  if (!which) return context.record_error(GL_INVALID_ENUM, command, "target is unknown");
  const Parameter found = find_parameter(bound_texture(context, *which).parameters, pname);
  if (found.count == 0) return context.record_error(GL_INVALID_ENUM, command, "pname is unknown");
  for (int i = 0; i < found.count; ++i) {
    params[i] = convert(found.value.components[static_cast<std::size_t>(i)], found.kind);
  }
}

}  // namespace

void TexParameterfv(Context& context, GLenum target, GLenum pname, const GLfloat* params) {
  constexpr auto command = "glTexParameter";
  const auto which = texture_target(target);
  if (!which) return context.record_error(GL_INVALID_ENUM, command, "target is unknown");
  const GLenum error = set_parameter(bound_texture(context, *which).parameters, *which, pname, params);
  if (error != GL_NO_ERROR) return context.record_error(error, command, "pname or its value is not allowed");
  context.change(dirty_textures);
}

void GetTexParameterfv(Context& context, GLenum target, GLenum pname, GLfloat* params) {
  get(context, "glGetTexParameterfv", target, pname, params,
      [](double value, ValueKind) { return static_cast<GLfloat>(value); });
}

void GetTexParameteriv(Context& context, GLenum target, GLenum pname, GLint* params) {
  get(context, "glGetTexParameteriv", target, pname, params, to_integer);
}

}  // namespace gouraud::api
