// GetLight and GetMaterial [GL1.5 §6.1.3].
#include "api/commands/lighting.h"
#include "api/commands/state_rows.h"

namespace gouraud::api {
namespace {

// A parameter's components and how they convert; count 0 for what is no parameter.
struct Parameter {
  int count = 0;
  ValueKind kind = ValueKind::real;
  StateValue value;
};

template <class Value>
Parameter parameter(int count, ValueKind kind, const Value& value) {
  Parameter result{count, kind, {}};
  set(result.value, value);
  return result;
}

Parameter light_parameter(const Light& light, GLenum pname) {
  switch (pname) {
    case GL_AMBIENT:
      return parameter(4, ValueKind::normalized, light.ambient);
    case GL_DIFFUSE:
      return parameter(4, ValueKind::normalized, light.diffuse);
    case GL_SPECULAR:
      return parameter(4, ValueKind::normalized, light.specular);
    case GL_POSITION:
      return parameter(4, ValueKind::real, light.position_eye);
    case GL_SPOT_DIRECTION:
      return parameter(3, ValueKind::real, light.spot_direction_eye);
    case GL_SPOT_EXPONENT:
      return parameter(1, ValueKind::real, light.spot_exponent);
    case GL_SPOT_CUTOFF:
      return parameter(1, ValueKind::real, light.spot_cutoff_deg);
    case GL_CONSTANT_ATTENUATION:
      return parameter(1, ValueKind::real, light.constant_attenuation);
    case GL_LINEAR_ATTENUATION:
      return parameter(1, ValueKind::real, light.linear_attenuation);
    case GL_QUADRATIC_ATTENUATION:
      return parameter(1, ValueKind::real, light.quadratic_attenuation);
    default:
      return {};
  }
}

Parameter material_parameter(const MaterialFace& material, GLenum pname) {
  switch (pname) {
    case GL_AMBIENT:
      return parameter(4, ValueKind::normalized, material.ambient);
    case GL_DIFFUSE:
      return parameter(4, ValueKind::normalized, material.diffuse);
    case GL_SPECULAR:
      return parameter(4, ValueKind::normalized, material.specular);
    case GL_EMISSION:
      return parameter(4, ValueKind::normalized, material.emission);
    case GL_SHININESS:
      return parameter(1, ValueKind::real, material.shininess);
    case GL_COLOR_INDEXES:
      return parameter(3, ValueKind::real, material.color_indexes);
    default:
      return {};
  }
}

template <class T>
void store(const Parameter& parameter, T* params) {
  for (int i = 0; i < parameter.count; ++i) {
    const double value = parameter.value.components[static_cast<std::size_t>(i)];
    if constexpr (std::is_same_v<T, GLint>) {
      params[i] = to_integer(value, parameter.kind);
    } else {
      params[i] = static_cast<T>(value);
    }
  }
}

template <class T>
void get_light(Context& context, GLenum light, GLenum pname, T* params) {
  if (light - GL_LIGHT0 >= static_cast<GLenum>(max_lights)) {
    return context.record_error(GL_INVALID_ENUM, "glGetLight", "no such light");
  }
  const Parameter found = light_parameter(context.state.lighting.lights[light - GL_LIGHT0], pname);
  if (found.count == 0) return context.record_error(GL_INVALID_ENUM, "glGetLight", "pname is unknown");
  store(found, params);
}

template <class T>
void get_material(Context& context, GLenum face, GLenum pname, T* params) {
  if (face != GL_FRONT && face != GL_BACK) {
    return context.record_error(GL_INVALID_ENUM, "glGetMaterial", "face is neither FRONT nor BACK");
  }
  sync_color_material(context.state);
  const Parameter found = material_parameter(context.state.lighting.material[face - GL_FRONT], pname);
  if (found.count == 0) return context.record_error(GL_INVALID_ENUM, "glGetMaterial", "pname is unknown");
  store(found, params);
}

}  // namespace

void GetLightfv(Context& context, GLenum light, GLenum pname, GLfloat* params) {
  get_light(context, light, pname, params);
}

void GetLightiv(Context& context, GLenum light, GLenum pname, GLint* params) {
  get_light(context, light, pname, params);
}

void GetMaterialfv(Context& context, GLenum face, GLenum pname, GLfloat* params) {
  get_material(context, face, pname, params);
}

void GetMaterialiv(Context& context, GLenum face, GLenum pname, GLint* params) {
  get_material(context, face, pname, params);
}

}  // namespace gouraud::api
