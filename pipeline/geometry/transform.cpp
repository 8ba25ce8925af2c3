// Takes object-space positions, gives clip-space or eye-space ones [GL1.5 §2.11].
//
// Positions are transformed by the combined matrix at once, not by two matrices in turn: Mesa's bits (MESA-RULES 2.1).
#include "pipeline/geometry/transform.h"

#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/geometry/transform.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void transform(const glm::mat4& matrix, const VertexBatch& batch, std::size_t first, std::size_t end, ProcessedArray<4>& out) {
  const hn::CappedTag<float, 16> d;
  const auto& in = batch.position_object;
  for (std::size_t row = 0; row < 4; ++row) {
    const int k = static_cast<int>(row);
    const auto m0 = hn::Set(d, matrix[0][k]), m1 = hn::Set(d, matrix[1][k]);
    const auto m2 = hn::Set(d, matrix[2][k]), m3 = hn::Set(d, matrix[3][k]);
    for (std::size_t i = first; i < end; i += hn::Lanes(d)) {
      const auto x = hn::LoadU(d, &in[0][i]), y = hn::LoadU(d, &in[1][i]), z = hn::LoadU(d, &in[2][i]),
                 w = hn::LoadU(d, &in[3][i]);
      const auto xy = hn::Add(hn::Mul(x, m0), hn::Mul(y, m1));
      hn::StoreU(hn::Add(hn::Add(xy, hn::Mul(z, m2)), hn::Mul(w, m3)), d, &out[row][i]);
    }
  }
}

void transform_all(glm::mat4 TransformState::*matrix, const TransformState& state, const VertexBatch& batch, ProcessedArray<4>& out) {
  for_each_transform(state, batch, [&](const TransformState& run, std::size_t first, std::size_t end) HWY_ATTR {
    transform(run.*matrix, batch, first, end, out);
  });
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {

void transform_to_clip(const TransformState& state, const VertexBatch& batch, ProcessedVertices& out) {
  out.count = batch.count;
  GOURAUD_SIMD_PICK(transform_all)(&TransformState::modelview_projection, state, batch, out.position_clip);
}

void transform_to_eye(const TransformState& state, const VertexBatch& batch, ProcessedVertices& out) {
  GOURAUD_SIMD_PICK(transform_all)(&TransformState::modelview, state, batch, out.position_eye);
}

}  // namespace gouraud::pipeline
#endif
