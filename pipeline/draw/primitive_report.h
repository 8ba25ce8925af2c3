// Where primitives go that are not rasterized: to somebody who wants to know of them [GL1.5 §5.2, §5.3].
//
// Takes processed vertices; gives the points, lines and polygons that would be rasterized: clipped, culled, of the mode
// that their face has, in window coordinates. Leaves out widths, stipples and depth offset.
#pragma once

#include <cstdint>
#include <span>

#include <glm/glm.hpp>

#include "pipeline/draw/draw_state.h"
#include "pipeline/draw/plan.h"
#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/geometry/vertex_batch.h"
#include "pipeline/raster/varyings.h"

namespace gouraud::pipeline {

struct ReportedVertex {
  glm::vec3 position_window{0.0f};  ///< y up, z in [0, 1]
  float w_clip = 1.0f;
  glm::vec4 color{0.0f};  ///< primary, in [0, 1], if the state's report asks for it
  glm::vec4 texture_coordinates{0.0f, 0.0f, 0.0f, 1.0f};
};

class PrimitiveReceiver {
 public:
  virtual ~PrimitiveReceiver() = default;
  virtual void point(const ReportedVertex& vertex) = 0;
  /// `starts`: the line stipple would be reset before this segment [GL1.5 §3.4.2].
  virtual void line(const ReportedVertex& from, const ReportedVertex& to, bool starts) = 0;
  /// At least three vertices.
  virtual void polygon(std::span<const ReportedVertex> vertices) = 0;
};

/// Reports the batch's primitives in order. `vertices` hold the batch after the vertex stages; the clipper adds to them.
void report_primitives(const DrawState& state, const Plan& plan, const VaryingLayout& varyings, const VertexBatch& batch,
                       ProcessedVertices& vertices, PrimitiveReceiver& receiver);

/// A vertex's four coordinates of a unit whose report is asked for; (0, 0, 0, 1) of others.
glm::vec4 texture_coordinates_of(const VaryingLayout& varyings, int unit, const ProcessedVertices& vertices,
                                 std::uint16_t index);

}  // namespace gouraud::pipeline
