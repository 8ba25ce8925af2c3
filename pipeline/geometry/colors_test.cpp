#include "pipeline/geometry/colors.h"

#include "pipeline/geometry/test_support.h"

namespace gouraud::pipeline {
namespace {

TEST(VertexColors, AreClampedAndNaNBecomesZero) {
  const auto batch = random_batch(1, 2);
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  const float given[2][4] = {{0.25f, -1, 2, nan}, {-inf, inf, 1, 0}};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 4; ++k) batch->color[k][i] = given[i][k];
  }
  const auto out = blank_vertices();
  for_each_target([&] {
    clamp_vertex_colors(*batch, *out);
    EXPECT_EQ(out->color_front[0].r, 0.25f);
    EXPECT_EQ(out->color_front[0].g, 0.0f);
    EXPECT_EQ(out->color_front[0].b, 1.0f);
    EXPECT_EQ(out->color_front[0].a, 0.0f);
    EXPECT_EQ(out->color_front[1].r, 0.0f);
    EXPECT_EQ(out->color_front[1].g, 1.0f);
    EXPECT_EQ(out->color_front[1].b, 1.0f);
    EXPECT_EQ(out->color_front[1].a, 0.0f);
  });
}

TEST(VertexColors, HaveTheSameBitsOnEveryTargetForAnyInput) {
  const auto first = blank_vertices(), out = blank_vertices();
  const auto batch = random_batch(2, 1001, true);
  clamp_vertex_colors(*batch, *first);
  for_each_target([&] {
    clamp_vertex_colors(*batch, *out);
    EXPECT_TRUE(same_bits(out->color_front, first->color_front, batch->count));
  });
}

}  // namespace
}  // namespace gouraud::pipeline
