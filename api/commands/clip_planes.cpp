#include "api/commands/clip_planes.h"

#include "api/state/matrix.h"

namespace gouraud::api {
namespace {

// Null, and an error is recorded, if there is no such plane.
UserClipPlane* find_plane(Context& context, GLenum plane, const char* command) {
  if (plane - GL_CLIP_PLANE0 < static_cast<GLenum>(max_clip_planes)) {
    return &context.state.transform.clip_planes[plane - GL_CLIP_PLANE0];
  }
  context.record_error(GL_INVALID_ENUM, command, "no such clip plane");
  return nullptr;
}

}  // namespace

void ClipPlane(Context& context, GLenum plane, const GLdouble* equation) {
  UserClipPlane* const found = find_plane(context, plane, "glClipPlane");
  if (found == nullptr) return;
  const glm::dvec4 plane_object(equation[0], equation[1], equation[2], equation[3]);
  found->plane_eye = to_eye(plane_object, context.state.matrices.modelview.top());
  context.change(dirty_transform);
}

void GetClipPlane(Context& context, GLenum plane, GLdouble* equation) {
  const UserClipPlane* const found = find_plane(context, plane, "glGetClipPlane");
  if (found == nullptr) return;
  for (int i = 0; i < 4; ++i) equation[i] = found->plane_eye[i];
}

}  // namespace gouraud::api
