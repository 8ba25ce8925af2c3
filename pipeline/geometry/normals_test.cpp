#include "pipeline/geometry/normals.h"

#include <cmath>

#include "pipeline/geometry/test_support.h"

namespace gouraud::pipeline {
namespace {

glm::vec3 transformed(TransformState state, const glm::vec3& normal) {
  const auto out = blank_vertices();
  const auto batch = random_batch(1, 1);
  for (int k = 0; k < 3; ++k) batch->normal_object[static_cast<std::size_t>(k)][0] = normal[k];
  transform_normals(state, *batch, *out);
  return {out->normal_eye[0][0], out->normal_eye[1][0], out->normal_eye[2][0]};
}

TransformState scaling(NormalScaling how, float factor = 1) {
  TransformState state;
  state.normal_scaling = how;
  state.rescale_factor = factor;
  return state;
}

TEST(Normals, AreMultipliedByTheNormalMatrix) {
  TransformState state = scaling(NormalScaling::none);
  state.normal_matrix = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  EXPECT_EQ(transformed(state, {1, 0, 0}), glm::vec3(1, 2, 3));
  EXPECT_EQ(transformed(state, {0, 1, 0}), glm::vec3(4, 5, 6));
  EXPECT_EQ(transformed(state, {1, 1, 1}), glm::vec3(12, 15, 18));
}

TEST(Normals, AreMultipliedByTheRescaleFactorOnlyIfRescaled) {
  EXPECT_EQ(transformed(scaling(NormalScaling::rescale, 0.25f), {0, 8, 4}), glm::vec3(0, 2, 1));
  EXPECT_EQ(transformed(scaling(NormalScaling::none), {0, 8, 4}), glm::vec3(0, 8, 4));
}

TEST(Normals, GetUnitLengthIfNormalized) {
  EXPECT_EQ(transformed(scaling(NormalScaling::normalize), {3, 0, 4}), glm::vec3(0.6f, 0, 0.8f));
  EXPECT_EQ(transformed(scaling(NormalScaling::normalize), {0, -1e-40f, 0}), glm::vec3(0, -1, 0));
  EXPECT_EQ(transformed(scaling(NormalScaling::normalize), {3e38f, 0, 0}), glm::vec3(1, 0, 0));
}

TEST(Normals, WithoutADirectionNormalizeToZero) {
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  for (const glm::vec3& normal :
       {glm::vec3(0, 0, 0), glm::vec3(nan, 1, 0), glm::vec3(1, inf, 0), glm::vec3(0, 0, -inf)}) {
    EXPECT_EQ(transformed(scaling(NormalScaling::normalize), normal), glm::vec3(0, 0, 0));
  }
}

TEST(Normals, LoseComponentsThatAreNotFinite) {
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(transformed(scaling(NormalScaling::rescale, 10), {nan, 1, inf}), glm::vec3(0, 0, 0));  // each row has a NaN
  EXPECT_EQ(transformed(scaling(NormalScaling::rescale, 10), {3e38f, 1, 0}), glm::vec3(0, 10, 0));
}

TEST(Normals, AreRoundedOnce) {
  const auto batch = random_batch(2, batch_capacity);
  const auto out = blank_vertices();
  TransformState state = scaling(NormalScaling::normalize);
  state.normal_matrix = {{1.1f, 0.2f, -0.3f}, {0.4f, 1.5f, 0.6f}, {-0.7f, 0.8f, 0.9f}};
  transform_normals(state, *batch, *out);
  for (std::size_t i = 0; i < batch_capacity; ++i) {
    double n[3] = {0, 0, 0}, squared = 0;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        n[row] += static_cast<double>(state.normal_matrix[column][row]) *
                  static_cast<double>(batch->normal_object[static_cast<std::size_t>(column)][i]);
      }
      squared += n[row] * n[row];
    }
    for (std::size_t k = 0; k < 3; ++k) ASSERT_EQ(out->normal_eye[k][i], static_cast<float>(n[k] / std::sqrt(squared)));
  }
}

TEST(Normals, HaveTheSameBitsOnEveryTargetForAnyInput) {
  const auto first = blank_vertices(), out = blank_vertices();
  const auto batch = random_batch(3, 1003, true);
  for (const NormalScaling how : {NormalScaling::none, NormalScaling::rescale, NormalScaling::normalize}) {
    transform_normals(scaling(how, 1.7f), *batch, *first);
    for_each_target([&] {
      transform_normals(scaling(how, 1.7f), *batch, *out);
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_TRUE(same_numbers(out->normal_eye[k], first->normal_eye[k], batch->count));
    });
  }
}

}  // namespace
}  // namespace gouraud::pipeline
