#include "api/commands/rasterization.h"

#include "api/commands/clamped.h"

namespace gouraud::api {

void PointSize(Context& context, GLfloat size) {
  if (!(size > 0.0f)) return context.record_error(GL_INVALID_VALUE, "glPointSize", "size is not positive");
  context.state.point.size_px = size;
}

void LineWidth(Context& context, GLfloat width) {
  if (!(width > 0.0f)) return context.record_error(GL_INVALID_VALUE, "glLineWidth", "width is not positive");
  context.state.line.width_px = width;
}

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
}

}  // namespace gouraud::api
