#include "pipeline/draw/transform_runs.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace gouraud::pipeline {
namespace {

TransformState scaled(float factor) {
  TransformState result;
  result.modelview[0][0] = factor;
  return result;
}
MaterialPair shining(float shininess) {
  MaterialPair result;
  result.front.shininess = shininess;
  return result;
}

/// Three vertices under the state's matrices, then three named by elements under others, then one again under others.
std::unique_ptr<VertexBatch> batch_of_three_runs() {
  auto batch = std::make_unique<VertexBatch>();
  batch->count = 7;
  for (std::size_t i = 0; i < 7; ++i) batch->position_object[0][i] = static_cast<float>(i);
  batch->elements = {5, 3, 4};
  batch->primitives = {{.mode = PrimitiveMode::triangles, .first = 0, .count = 3},
                       {.mode = PrimitiveMode::triangles, .first = 0, .count = 3, .indexed = true, .moved = true},
                       {.mode = PrimitiveMode::points, .first = 6, .count = 1, .moved = true}};
  batch->transform_runs = {{0, scaled(1)}, {3, scaled(2)}, {6, scaled(3)}};
  batch->material_runs = {{2, shining(2)}, {4, shining(4)}};
  return batch;
}

TEST(SplitTransformRuns, GivesEachRunItsVerticesPrimitivesAndMaterials) {
  DrawState state;
  state.lighting.material = shining(1);
  struct Part {
    float scale, shininess, first_x;
    std::int32_t count, first;
    std::vector<std::uint16_t> elements;
    std::vector<std::int32_t> material_changes;
  };
  std::vector<Part> parts;
  split_transform_runs(state, *batch_of_three_runs(), [&](const DrawState& s, const VertexBatch& b) {
    ASSERT_EQ(b.primitives.size(), 1u);
    EXPECT_TRUE(b.transform_runs.empty());
    EXPECT_FALSE(b.primitives[0].moved);
    Part part{s.transform.modelview[0][0], s.lighting.material.front.shininess, b.position_object[0][0], b.count,
              b.primitives[0].first, b.elements, {}};
    for (const MaterialRun& run : b.material_runs) part.material_changes.push_back(run.first);
    parts.push_back(part);
  });
  ASSERT_EQ(parts.size(), 3u);
  const auto expect = [&](std::size_t i, float scale, float shininess, float first_x, std::int32_t count) {
    EXPECT_EQ(parts[i].scale, scale);
    EXPECT_EQ(parts[i].shininess, shininess);
    EXPECT_EQ(parts[i].first_x, first_x);
    EXPECT_EQ(parts[i].count, count);
    EXPECT_EQ(parts[i].first, 0);
  };
  expect(0, 1, 1, 0, 3);
  expect(1, 2, 2, 3, 3);
  expect(2, 3, 4, 6, 1);
  EXPECT_EQ(parts[0].material_changes, (std::vector<std::int32_t>{2}));
  EXPECT_EQ(parts[1].material_changes, (std::vector<std::int32_t>{1}));
  EXPECT_EQ(parts[1].elements, (std::vector<std::uint16_t>{2, 0, 1}));
  EXPECT_TRUE(parts[2].material_changes.empty());
}

TEST(SplitTransformRuns, GivesABatchWithoutRunsAsItIs) {
  VertexBatch const* seen = nullptr;
  const auto batch = std::make_unique<VertexBatch>();
  split_transform_runs({}, *batch, [&](const DrawState&, const VertexBatch& b) { seen = &b; });
  EXPECT_EQ(seen, batch.get());
}

}  // namespace
}  // namespace gouraud::pipeline
