// The plan of a draw: which vertex stages and which fragment passes its picture needs, and no others. Computed
// backwards from what can reach the framebuffer (ARCHITECTURE §3).
#pragma once

#include <cstdint>
#include <string>

#include "pipeline/draw/draw_state.h"
#include "pipeline/draw/methods.h"
#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/geometry/vertex_batch.h"
#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// What a plan depends on besides the DrawState.
struct TargetFormat {
  ColorFormat color = ColorFormat::none;
  DepthFormat depth = DepthFormat::none;
  Methods methods{};  ///< apply_methods has told the DrawState of them
  bool operator==(const TargetFormat&) const = default;
};

/// Where the secondary colour is added [GL1.5 §3.9]: at the vertices, unless a texture stands between.
enum class SecondaryColor : std::uint8_t { none, summed_at_vertices, interpolated };

struct Plan {
  /// False if no fragment of this draw can change the target (all writes masked, everything culled, empty scissor):
  /// vertices need not even be kept.
  bool draws = false;
  /// Primitives are reported instead of rasterized: no fragment passes.
  bool reports = false;
  /// Vertices under other matrices may come in the same batch, as transform runs.
  bool follows_matrices = false;
  /// VertexAttribute bits that the batch must hold besides positions.
  std::uint32_t vertex_demand = 0;

  // Vertex stages, in order.
  bool eye_positions = false;
  bool normals = false;
  bool lighting = false;
  bool vertex_colors = false;  ///< without lighting: clamp the current colours
  bool phong = false;          ///< in place of lighting and interpolated colours: fragments are lit
  bool secondary_vertex_colors = false;  ///< without lighting: and the secondary ones

  // What becomes of fragments besides.
  bool stencil = false;
  bool writes_stencil = false;
  bool counts_samples = false;

  // What is interpolated.
  bool colors = false;
  bool depth = false;
  bool gathers = false;   ///< triangles that a method without a depth buffer sorts
  bool textured = false;  ///< the coordinates of the textured units; colours are then interpolated without scale
  bool fog = false;       ///< the fog coordinate
  SecondaryColor secondary_color = SecondaryColor::none;

  // What becomes of fragments and their colours.
  bool polygon_stipple = false;
  bool coverage = false;  ///< of smooth points, lines or polygons
  bool sample_alpha = false;  ///< alpha chooses samples, or becomes 1
  bool alpha_test = false;
  bool blends = false;  ///< blending or a logical operation
  bool writes_color = false;

  FragmentPasses fragment{};
  /// Of filled polygons: without the coverage, if it is that of points and lines alone.
  FragmentPasses filled{};
  Methods methods{};
  bool operator==(const Plan&) const = default;

};

/// Pure and cheap (no allocation): called whenever the state changed.
Plan make_plan(const DrawState& state, TargetFormat target);

/// What a draw is rasterized as.
struct DrawnKinds {
  bool points = true, lines = true, filled = true;
};
DrawnKinds kinds_of(const DrawState& state, const VertexBatch& batch);

/// One line a stage, in order, each with its spec section: what GOURAUD_TRACE=plan prints.
std::string describe(const Plan& plan, const DrawState& state, TargetFormat target, DrawnKinds kinds = {});

}  // namespace gouraud::pipeline
