// For the oracle's tests: states in which window positions are what the test says, and batches made of them.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "conformance/oracle/oracle.h"

namespace gouraud::oracle {

/// A power of two, so that window positions on a fine grid pass through clip space exactly.
inline constexpr int test_size = 64;

/// Positions given are window positions: x, y in [0, 64], z in [0, 1]; everything is visible, nothing is lit or tested.
inline pipeline::DrawState window_state() {
  pipeline::DrawState state;
  state.viewport = {0, 0, test_size, test_size, 0.0, 1.0, test_size};
  glm::mat4 projection(1.0f);
  projection[0][0] = projection[1][1] = 2.0f / test_size;
  projection[3][0] = projection[3][1] = projection[3][2] = -1.0f;
  projection[2][2] = 2.0f;
  state.transform.projection = state.transform.modelview_projection = projection;
  state.raster.scissor = {0, 0, test_size, test_size};
  return state;
}

struct TestVertex {
  std::array<float, 4> position{0, 0, 0, 1};
  std::array<float, 4> color{1, 1, 1, 1};
  std::array<float, 3> normal{0, 0, 1};
};

inline TestVertex at(float x, float y, float z = 0.0f, std::array<float, 4> color = {1, 1, 1, 1}) {
  return {{x, y, z, 1}, color, {0, 0, 1}};
}

inline void append(pipeline::VertexBatch& batch, const TestVertex& vertex) {
  const auto i = static_cast<std::size_t>(batch.count++);
  for (std::size_t k = 0; k < 4; ++k) {
    batch.position_object[k][i] = vertex.position[k];
    batch.color[k][i] = vertex.color[k];
  }
  batch.edge_flag[i] = 1;
  for (std::size_t k = 0; k < 3; ++k) batch.normal_object[k][i] = vertex.normal[k];
}

inline std::unique_ptr<pipeline::VertexBatch> make_batch(pipeline::PrimitiveMode mode,
                                                         const std::vector<TestVertex>& vertices) {
  auto batch = std::make_unique<pipeline::VertexBatch>();
  batch->clear();
  for (const TestVertex& vertex : vertices) append(*batch, vertex);
  batch->primitives.push_back({mode, true, true, 0, batch->count});
  return batch;
}

/// A framebuffer without planes: the oracle has its own pictures.
inline pipeline::Framebuffer test_target(int width_px, int height_px, int depth_bits, int samples = 1) {
  pipeline::Framebuffer target;
  target.width_px = width_px;
  target.height_px = height_px;
  target.depth_format = depth_bits == 16 ? pipeline::DepthFormat::z16 : depth_bits == 24 ? pipeline::DepthFormat::z24s8 : pipeline::DepthFormat::none;
  target.samples = samples;
  return target;
}

/// An oracle with a 64x64 target of 24-bit depth, cleared to black and the farthest depth.
struct TestOracle : Oracle {
  explicit TestOracle(const OracleOptions& options = {}, int depth_bits = 24) : Oracle(options) {
    target_changed(test_target(test_size, test_size, depth_bits));
    pipeline::ClearState all;
    all.color = all.depth = true;
    all.scissor = {0, 0, test_size, test_size};
    clear(all);
  }
  using Oracle::draw;
  void draw(const pipeline::DrawState& state, pipeline::PrimitiveMode mode, const std::vector<TestVertex>& vertices) {
    draw(state, *make_batch(mode, vertices));
  }
  const OraclePixel& pixel(int x, int y) const { return picture().pixels[picture().index(x, y)]; }
  int fragments(int x, int y) const { return picture().fragments_written[picture().index(x, y)]; }
  int all_fragments() const {
    int sum = 0;
    for (const int n : picture().fragments_written) sum += n;
    return sum;
  }
};

}  // namespace gouraud::oracle
