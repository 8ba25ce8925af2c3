// A look between the steps: one vertex through its spaces, and one pixel's fragments through their passes. Who watches gets
// the plan's own steps with a look before and after each; who does not has none of it in his passes, and no kernel knows.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "pipeline/draw/plan.h"
#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

struct Watch {
  std::int64_t vertex = -1;     ///< this vertex of those since colours were last cleared, from 0; -1: none
  std::int32_t x = -1, y = -1;  ///< this pixel, y from the bottom; -1: none
  void (*tell)(const std::string& text) = nullptr;  ///< from any thread

  bool watches_pixel() const { return x >= 0 && y >= 0; }
};

/// What the steps of a watched draw need, interned with its binding.
struct PixelWatch {
  Watch watch{};
  std::int64_t draw = 0;  ///< since colours were last cleared, from 0
  FragmentPasses passes{};
  std::array<std::string_view, FragmentPasses::max_passes> names{};
  TargetFormat target{};
  float color_scale = 1;  ///< of interpolated colours; behind textures, that of the target
};

PixelWatch make_pixel_watch(const Watch& watch, std::int64_t draw, const FragmentPasses& passes, const DrawState& state,
                            const Plan& plan, TargetFormat target);

/// As many passes as it is of, each of which runs one of the plan's and tells what it did to the pixel.
FragmentPasses watched(const FragmentPasses& passes);

/// Vertex i behind the vertex stages: what the plan has computed of it.
std::string describe_vertex(const DrawState& state, const Plan& plan, const VertexBatch& batch, const ProcessedVertices& vertices,
                            std::int32_t i);

}  // namespace gouraud::pipeline
