#include "api/commands/lighting.h"

#include "api/snapshot/enums.h"
#include "api/state/matrix.h"

namespace gouraud::api {
namespace {

glm::vec4 vector_from(const GLfloat* v) {
  return glm::vec4(v[0], v[1], v[2], v[3]);
}

bool in_range(GLfloat value, GLfloat low, GLfloat high) {
  return value >= low && value <= high;
}

// The MaterialBits that follow the current colour on a face now.
unsigned followed_bits(const LightingGroup& lighting, GLenum face) {
  const bool applies = lighting.color_material_enabled &&
                       (lighting.color_material_face == face || lighting.color_material_face == GL_FRONT_AND_BACK);
  return applies ? material_bits(lighting.color_material_parameter) : 0u;
}

void set_colors(MaterialFace& face, unsigned bits, const glm::vec4& color) {
  if (bits & pipeline::material_ambient) face.ambient = color;
  if (bits & pipeline::material_diffuse) face.diffuse = color;
  if (bits & pipeline::material_specular) face.specular = color;
  if (bits & pipeline::material_emission) face.emission = color;
}

bool is_material_color(GLenum pname) {
  return pname == GL_AMBIENT || pname == GL_DIFFUSE || pname == GL_SPECULAR || pname == GL_EMISSION ||
         pname == GL_AMBIENT_AND_DIFFUSE;
}

bool is_material_face(GLenum face) {
  return face == GL_FRONT || face == GL_BACK || face == GL_FRONT_AND_BACK;
}

// False, and nothing set, if the value is out of range.
bool set_spot_or_attenuation(Light& light, GLenum pname, GLfloat value) {
  switch (pname) {
    case GL_SPOT_EXPONENT:
      if (!in_range(value, 0.0f, 128.0f)) return false;
      light.spot_exponent = value;
      return true;
    case GL_SPOT_CUTOFF:
      if (!in_range(value, 0.0f, 90.0f) && value != 180.0f) return false;
      light.spot_cutoff_deg = value;
      return true;
    default:
      if (!(value >= 0.0f)) return false;
      (pname == GL_CONSTANT_ATTENUATION ? light.constant_attenuation
       : pname == GL_LINEAR_ATTENUATION ? light.linear_attenuation
                                        : light.quadratic_attenuation) = value;
      return true;
  }
}

}  // namespace

void Lightfv(Context& context, GLenum light_name, GLenum pname, const GLfloat* params) {
  if (light_name - GL_LIGHT0 >= static_cast<GLenum>(max_lights)) {
    return context.record_error(GL_INVALID_ENUM, "glLight", "no such light");
  }
  Light& light = context.state.lighting.lights[light_name - GL_LIGHT0];
  switch (pname) {
    case GL_AMBIENT:
      light.ambient = vector_from(params);
      break;
    case GL_DIFFUSE:
      light.diffuse = vector_from(params);
      break;
    case GL_SPECULAR:
      light.specular = vector_from(params);
      break;
    case GL_POSITION:
      light.position_eye = product(context.state.matrices.modelview.top(), vector_from(params));
      break;
    case GL_SPOT_DIRECTION: {
      const glm::vec4 direction(params[0], params[1], params[2], 0.0f);
      const glm::mat4& m = context.state.matrices.modelview.top();
      light.spot_direction_eye = glm::vec3((m[0] * direction.x + m[1] * direction.y) + m[2] * direction.z);
      break;
    }
    case GL_SPOT_EXPONENT:
    case GL_SPOT_CUTOFF:
    case GL_CONSTANT_ATTENUATION:
    case GL_LINEAR_ATTENUATION:
    case GL_QUADRATIC_ATTENUATION:
      if (!set_spot_or_attenuation(light, pname, params[0])) {
        return context.record_error(GL_INVALID_VALUE, "glLight", "value out of range");
      }
      break;
    default:
      return context.record_error(GL_INVALID_ENUM, "glLight", "pname is unknown");
  }
  context.change(dirty_lighting);
}

void LightModelfv(Context& context, GLenum pname, const GLfloat* params) {
  LightingGroup& lighting = context.state.lighting;
  switch (pname) {
    case GL_LIGHT_MODEL_AMBIENT:
      lighting.model_ambient = vector_from(params);
      break;
    case GL_LIGHT_MODEL_LOCAL_VIEWER:
      lighting.model_local_viewer = params[0] != 0.0f;
      break;
    case GL_LIGHT_MODEL_TWO_SIDE:
      lighting.model_two_side = params[0] != 0.0f;
      break;
    case GL_LIGHT_MODEL_COLOR_CONTROL:
      if (params[0] == static_cast<GLfloat>(GL_SINGLE_COLOR)) {
        lighting.model_color_control = GL_SINGLE_COLOR;
      } else if (params[0] == static_cast<GLfloat>(GL_SEPARATE_SPECULAR_COLOR)) {
        lighting.model_color_control = GL_SEPARATE_SPECULAR_COLOR;
      } else {
        return context.record_error(GL_INVALID_ENUM, "glLightModel", "no such colour control");
      }
      break;
    default:
      return context.record_error(GL_INVALID_ENUM, "glLightModel", "pname is unknown");
  }
  context.change(dirty_lighting);
}

void Materialfv(Context& context, GLenum face, GLenum pname, const GLfloat* params) {
  if (!is_material_face(face)) return context.record_error(GL_INVALID_ENUM, "glMaterial", "face is unknown");
  const bool is_color = is_material_color(pname);
  if (!is_color && pname != GL_SHININESS && pname != GL_COLOR_INDEXES) {
    return context.record_error(GL_INVALID_ENUM, "glMaterial", "pname is unknown");
  }
  if (pname == GL_SHININESS && !in_range(params[0], 0.0f, 128.0f)) {
    return context.record_error(GL_INVALID_VALUE, "glMaterial", "shininess is not in [0, 128]");
  }

  LightingGroup& lighting = context.state.lighting;
  for (const GLenum one_face : {GLenum{GL_FRONT}, GLenum{GL_BACK}}) {
    if (face != one_face && face != GL_FRONT_AND_BACK) continue;
    MaterialFace& material = lighting.material[one_face - GL_FRONT];
    if (is_color) {
      set_colors(material, material_bits(pname) & ~followed_bits(lighting, one_face), vector_from(params));
    } else if (pname == GL_SHININESS) {
      material.shininess = params[0];
    } else {
      material.color_indexes = glm::vec3(params[0], params[1], params[2]);
    }
  }
  if (context.inside_begin_end()) {
    context.apply_material();
  } else {
    context.change(dirty_material);
  }
}

void ColorMaterial(Context& context, GLenum face, GLenum mode) {
  if (!is_material_face(face)) return context.record_error(GL_INVALID_ENUM, "glColorMaterial", "face is unknown");
  if (!is_material_color(mode)) return context.record_error(GL_INVALID_ENUM, "glColorMaterial", "mode is unknown");
  sync_color_material(context.state);
  context.state.lighting.color_material_face = face;
  context.state.lighting.color_material_parameter = mode;
  context.change(dirty_lighting);
}

void ShadeModel(Context& context, GLenum mode) {
  if (mode != GL_FLAT && mode != GL_SMOOTH) {
    return context.record_error(GL_INVALID_ENUM, "glShadeModel", "mode is unknown");
  }
  context.state.lighting.shade_model = mode;
  context.change(dirty_assembly);
}

void sync_color_material(State& state) {
  LightingGroup& lighting = state.lighting;
  set_colors(lighting.material[0], followed_bits(lighting, GL_FRONT), state.current.color);
  set_colors(lighting.material[1], followed_bits(lighting, GL_BACK), state.current.color);
}

}  // namespace gouraud::api
