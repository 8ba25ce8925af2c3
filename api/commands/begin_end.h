// Begin, End and Vertex [GL1.5 §2.6.1, §2.7].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// GL_INVALID_ENUM for an unknown mode, GL_INVALID_FRAMEBUFFER_OPERATION for an incomplete framebuffer.
void Begin(Context& context, GLenum mode);

/// GL_INVALID_OPERATION without a Begin.
void End(Context& context);

/// Appends the vertex with the attributes that its draw demands. Outside Begin/End: undefined by the specification,
/// ignored here.
[[gnu::always_inline]] inline void Vertex4f(Context& context, GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
  Immediate& immediate = context.immediate;
  if (immediate.batch.count >= immediate.limit) [[unlikely]] {
    if (!context.make_room_for_vertex()) return;
  }
  pipeline::VertexBatch& batch = immediate.batch;
  const auto i = static_cast<std::size_t>(batch.count);
  batch.position_object[0][i] = x;
  batch.position_object[1][i] = y;
  batch.position_object[2][i] = z;
  batch.position_object[3][i] = w;
  const CurrentGroup& current = context.state.current;
  if (immediate.demand & pipeline::attribute_normal) {
    batch.normal_object[0][i] = current.normal_object.x;
    batch.normal_object[1][i] = current.normal_object.y;
    batch.normal_object[2][i] = current.normal_object.z;
  }
  if (immediate.demand & pipeline::attribute_color) {
    batch.color[0][i] = current.color.x;
    batch.color[1][i] = current.color.y;
    batch.color[2][i] = current.color.z;
    batch.color[3][i] = current.color.w;
  }
  if (immediate.demand >= pipeline::attribute_secondary_color) keep_more_attributes(batch, immediate.demand, current);
  batch.count = static_cast<std::int32_t>(i) + 1;
}

}  // namespace gouraud::api
