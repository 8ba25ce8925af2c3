#include "api/commands/rasterization.h"

#include <algorithm>

#include "api/commands/clamped.h"

namespace gouraud::api {
namespace {

void set_offset(Context& context, float factor, float units, float bias) {
  PolygonGroup& polygon = context.state.polygon;
  polygon.offset_factor = factor;
  polygon.offset_units = units;
  polygon.offset_bias = bias;
  context.change(dirty_assembly);
}

}  // namespace

void PointSize(Context& context, GLfloat size) {
  if (!(size > 0.0f)) return context.record_error(GL_INVALID_VALUE, "glPointSize", "size is not positive");
  context.state.point.size_px = size;
  context.change(dirty_assembly);
}

void PointParameterfv(Context& context, GLenum pname, const GLfloat* params) {
  PointGroup& point = context.state.point;
  const auto set_size = [&](float& size) {
    if (!(params[0] >= 0.0f)) return context.record_error(GL_INVALID_VALUE, "glPointParameter", "a size is negative");
    size = params[0];
  };
  switch (pname) {
    case GL_POINT_SIZE_MIN:
      set_size(point.smallest_px);
      break;
    case GL_POINT_SIZE_MAX:
      set_size(point.largest_px);
      break;
    case GL_POINT_FADE_THRESHOLD_SIZE:
      set_size(point.fade_threshold_px);
      break;
    case GL_POINT_DISTANCE_ATTENUATION:
      point.distance_attenuation = glm::vec3(params[0], params[1], params[2]);
      break;
    default:
      return context.record_error(GL_INVALID_ENUM, "glPointParameter", "pname is unknown");
  }
  context.change(dirty_assembly);
}

void LineWidth(Context& context, GLfloat width) {
  if (!(width > 0.0f)) return context.record_error(GL_INVALID_VALUE, "glLineWidth", "width is not positive");
  context.state.line.width_px = width;
  context.change(dirty_assembly);
}

void LineStipple(Context& context, GLint factor, GLushort pattern) {
  context.state.line.stipple_factor = std::clamp(factor, 1, 256);
  context.state.line.stipple_pattern = pattern;
  context.change(dirty_assembly);
}

void PolygonOffset(Context& context, GLfloat factor, GLfloat units) { set_offset(context, factor, units, 0.0f); }
void PolygonOffsetEXT(Context& context, GLfloat factor, GLfloat bias) { set_offset(context, factor, 0.0f, bias); }

void FrontFace(Context& context, GLenum mode) {
  if (mode != GL_CW && mode != GL_CCW) {
    return context.record_error(GL_INVALID_ENUM, "glFrontFace", "mode is unknown");
  }
  context.state.polygon.front_face = mode;
  context.change(dirty_assembly);
}

void CullFace(Context& context, GLenum mode) {
  if (mode != GL_FRONT && mode != GL_BACK && mode != GL_FRONT_AND_BACK) {
    return context.record_error(GL_INVALID_ENUM, "glCullFace", "mode is unknown");
  }
  context.state.polygon.cull_face = mode;
  context.change(dirty_assembly);
}

void PolygonMode(Context& context, GLenum face, GLenum mode) {
  if (face != GL_FRONT && face != GL_BACK && face != GL_FRONT_AND_BACK) {
    return context.record_error(GL_INVALID_ENUM, "glPolygonMode", "face is unknown");
  }
  if (mode != GL_POINT && mode != GL_LINE && mode != GL_FILL) {
    return context.record_error(GL_INVALID_ENUM, "glPolygonMode", "mode is unknown");
  }
  if (face != GL_BACK) context.state.polygon.front_mode = mode;
  if (face != GL_FRONT) context.state.polygon.back_mode = mode;
  context.change(dirty_assembly);
}

void SampleCoverage(Context& context, GLfloat value, GLboolean invert) {
  context.state.multisample.coverage_value = clamped(value);
  context.state.multisample.coverage_inverted = invert != GL_FALSE;
  context.change(dirty_raster);
}

}  // namespace gouraud::api
