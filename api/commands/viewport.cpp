#include "api/commands/viewport.h"

#include <algorithm>

#include "api/commands/clamped.h"

namespace gouraud::api {

void Viewport(Context& context, GLint x, GLint y, GLsizei width, GLsizei height) {
  if (width < 0 || height < 0) {
    return context.record_error(GL_INVALID_VALUE, "glViewport", "width or height is negative");
  }
  ViewportGroup& viewport = context.state.viewport;
  viewport.x = std::clamp(x, min_viewport_origin, max_viewport_origin);
  viewport.y = std::clamp(y, min_viewport_origin, max_viewport_origin);
  viewport.width_px = std::min(width, max_target_size_px);
  viewport.height_px = std::min(height, max_target_size_px);
  context.change(dirty_viewport);
}

void DepthRange(Context& context, GLdouble n, GLdouble f) {
  context.state.viewport.depth_near = clamped(n);
  context.state.viewport.depth_far = clamped(f);
  context.change(dirty_viewport);
}

void ClipControl(Context& context, GLenum origin, GLenum depth) {
  if (origin != GL_LOWER_LEFT && origin != GL_UPPER_LEFT) {
    return context.record_error(GL_INVALID_ENUM, "glClipControl", "origin is unknown");
  }
  if (depth != GL_NEGATIVE_ONE_TO_ONE && depth != GL_ZERO_TO_ONE) {
    return context.record_error(GL_INVALID_ENUM, "glClipControl", "depth is unknown");
  }
  context.state.transform.clip_origin = origin;
  context.state.transform.clip_depth_mode = depth;
  context.change(dirty_viewport | dirty_assembly);
}

}  // namespace gouraud::api
