// Texture coordinates: given or generated, then transformed [GL1.5 §2.11.4]. Also the fog coordinate [GL1.5 §3.10].
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/geometry/vertex_batch.h"
#include "pipeline/raster/varyings.h"

namespace gouraud::pipeline {

/// What a source takes of a vertex beside its object-space position. A unit whose coordinates are `dimensions` long (and
/// q) needs no others.
struct TextureCoordinateNeeds {
  bool given = false, position_eye = false, normal_eye = false;
};
TextureCoordinateNeeds needs_of(const TextureCoordinateSource& source, int dimensions);

/// True if q is 1 at every vertex of the batch. Cheap, and it may say no where q is generated.
bool q_is_one(const TextureCoordinateSource& source, const VertexBatch& batch, int unit);

/// Fills the unit's arrays of out.varying. What is not finite as a float becomes 0. Eye positions and normals must be
/// there if needed.
void make_texture_coordinates(const TextureCoordinateSource& source, const TextureCoordinateLayout& layout, int unit,
                              const VertexBatch& batch, ProcessedVertices& out);

/// The fog coordinate: the vertex's own, or the distance |z_eye| from the eye plane (MESA-RULES 6) by `transform`,
/// unless the batch has transform runs.
void make_fog_coordinates(const TransformState& transform, const FogState& fog, const VertexBatch& batch,
                          std::array<float, processed_stride>& out);

}  // namespace gouraud::pipeline
