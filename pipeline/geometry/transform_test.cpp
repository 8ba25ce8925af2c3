#include "pipeline/geometry/transform.h"

#include "pipeline/geometry/test_support.h"

namespace gouraud::pipeline {
namespace {

TransformState random_transform(unsigned seed, bool wild = false) {
  TransformState state;
  Numbers number(seed, wild);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      state.modelview[column][row] = number();
      state.modelview_projection[column][row] = number();
    }
  }
  return state;
}

/// One product and one sum after the other, each rounded to float.
float plain(const glm::mat4& m, const VertexBatch& batch, std::size_t i, int row) {
  const auto& in = batch.position_object;
  const volatile float x = in[0][i] * m[0][row], y = in[1][i] * m[1][row], z = in[2][i] * m[2][row],
                       w = in[3][i] * m[3][row];
  volatile float sum = x + y;
  sum = sum + z;
  sum = sum + w;
  return sum;
}

TEST(Transform, MovesAPointByTheTranslation) {
  const auto out = blank_vertices();
  const auto batch = random_batch(1, 1);
  for (std::size_t k = 0; k < 4; ++k) batch->position_object[k][0] = 1;
  TransformState state;
  state.modelview[3] = {10, 20, 30, 1};
  transform_to_eye(state, *batch, *out);
  EXPECT_EQ(out->position_eye[0][0], 11);
  EXPECT_EQ(out->position_eye[1][0], 21);
  EXPECT_EQ(out->position_eye[2][0], 31);
  EXPECT_EQ(out->position_eye[3][0], 1);
}

TEST(Transform, SumsFromLeftToRightWithEveryStepRounded) {
  const auto out = blank_vertices();
  const auto batch = random_batch(2, batch_capacity);
  const TransformState state = random_transform(3);
  for_each_target([&] {
    transform_to_clip(state, *batch, *out);
    transform_to_eye(state, *batch, *out);
    EXPECT_EQ(out->count, batch_capacity);
    for (std::size_t i = 0; i < batch_capacity; ++i) {
      for (int row = 0; row < 4; ++row) {
        const auto k = static_cast<std::size_t>(row);
        ASSERT_EQ(out->position_clip[k][i], plain(state.modelview_projection, *batch, i, row));
        ASSERT_EQ(out->position_eye[k][i], plain(state.modelview, *batch, i, row));
      }
    }
  });
}

TEST(Transform, GivesTheSameBitsOnEveryTargetForAnyInput) {
  const auto first = blank_vertices(), out = blank_vertices();
  const auto batch = random_batch(4, 1001, true);
  const TransformState state = random_transform(5, true);
  transform_to_clip(state, *batch, *first);
  for_each_target([&] {
    transform_to_clip(state, *batch, *out);
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_TRUE(same_numbers(out->position_clip[k], first->position_clip[k], batch->count));
  });
}

TEST(Transform, OfNoVerticesGivesNone) {
  const auto out = blank_vertices();
  out->count = 5;
  transform_to_clip({}, *random_batch(6, 0), *out);
  EXPECT_EQ(out->count, 0);
}

}  // namespace
}  // namespace gouraud::pipeline
