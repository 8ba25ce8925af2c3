// Matrices, viewport and normal scaling [GL1.5 §2.11, Table 6.9].
#pragma once

#include <array>

#include <GL/gl.h>
#include <glm/glm.hpp>

#include "api/state/limits.h"

namespace gouraud::api {

/// A stack of `capacity` matrices with one identity on it. `depth` counts the matrices, so it is at least 1.
template <int capacity>
struct MatrixStack {
  std::array<glm::mat4, capacity> matrices{glm::mat4(1.0f)};
  int depth = 1;
  glm::mat4& top() { return matrices[static_cast<std::size_t>(depth - 1)]; }
  const glm::mat4& top() const { return matrices[static_cast<std::size_t>(depth - 1)]; }
  bool operator==(const MatrixStack&) const = default;
};

/// The matrix stacks belong to no attribute group.
struct MatrixStacks {
  MatrixStack<max_modelview_stack_depth> modelview;
  MatrixStack<max_projection_stack_depth> projection;
  std::array<MatrixStack<max_texture_stack_depth>, max_texture_units> texture;
  bool operator==(const MatrixStacks&) const = default;
};

/// [GL1.5 §2.12]: times the inverse of the modelview matrix of its time.
struct UserClipPlane {
  bool enabled = false;
  glm::dvec4 plane_eye{0.0};
  bool operator==(const UserClipPlane&) const = default;
};

/// Attribute group TRANSFORM_BIT.
struct TransformGroup {
  GLenum matrix_mode = GL_MODELVIEW;
  bool normalize_enabled = false;
  bool rescale_normal_enabled = false;
  GLenum clip_origin = GL_LOWER_LEFT, clip_depth_mode = GL_NEGATIVE_ONE_TO_ONE;  ///< ARB_clip_control
  std::array<UserClipPlane, max_clip_planes> clip_planes;
  bool operator==(const TransformGroup&) const = default;
};

/// Attribute group VIEWPORT_BIT. The context sets width and height when it gets its first target.
struct ViewportGroup {
  GLint x = 0, y = 0;
  GLsizei width_px = 0, height_px = 0;
  double depth_near = 0.0, depth_far = 1.0;  ///< in [0, 1]
  bool operator==(const ViewportGroup&) const = default;
};

}  // namespace gouraud::api
