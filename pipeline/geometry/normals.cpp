// Takes object-space normals, gives eye-space ones of the wanted length [GL1.5 §2.11.3].
//
// In double up to the one rounding to float: the specular exponent multiplies a normal's error by up to 128.
// choice: normals go through the upper 3x3 of the inverse modelview alone, as the section allows.
#include "pipeline/geometry/normals.h"

#include <limits>

#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/geometry/normals.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <bool normalize>
HWY_INLINE void transform_with(const glm::mat3& matrix, double factor, const VertexBatch& batch, std::size_t first,
                               std::size_t end, ProcessedArray<3>& out) {
  const hn::CappedTag<double, 8> d;
  const hn::Rebind<float, decltype(d)> f;
  const auto& in = batch.normal_object;
  [[maybe_unused]] const auto largest_double = hn::Set(d, std::numeric_limits<double>::max());
  [[maybe_unused]] const auto largest_float = hn::Set(d, std::numeric_limits<float>::max());
  hn::Vec<decltype(d)> m[3][3];
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) m[column][row] = hn::Set(d, static_cast<double>(matrix[column][row]) * factor);
  }
  for (std::size_t i = first; i < end; i += hn::Lanes(d)) {
    const auto x = hn::PromoteTo(d, hn::LoadU(f, &in[0][i])), y = hn::PromoteTo(d, hn::LoadU(f, &in[1][i]));
    const auto z = hn::PromoteTo(d, hn::LoadU(f, &in[2][i]));
    hn::Vec<decltype(d)> n[3];
    for (int k = 0; k < 3; ++k) {
      n[k] = hn::Add(hn::Add(hn::Mul(x, m[0][k]), hn::Mul(y, m[1][k])), hn::Mul(z, m[2][k]));
    }
    if constexpr (normalize) {
      const auto squared = hn::Add(hn::Add(hn::Mul(n[0], n[0]), hn::Mul(n[1], n[1])), hn::Mul(n[2], n[2]));
      const auto has_direction = hn::And(hn::Gt(squared, hn::Zero(d)), hn::Le(squared, largest_double));
      const auto scale = hn::Div(hn::Set(d, 1), hn::Sqrt(squared));
      for (auto& component : n) component = hn::IfThenElseZero(has_direction, hn::Mul(component, scale));
    } else {
      // Targets disagree about what infinity becomes as a float.
      for (auto& component : n) component = hn::IfThenElseZero(hn::Le(hn::Abs(component), largest_float), component);
    }
    for (std::size_t k = 0; k < 3; ++k) hn::StoreU(hn::DemoteTo(f, n[k]), f, &out[k][i]);
  }
}

void transform(const TransformState& of_all, const VertexBatch& batch, ProcessedArray<3>& out) {
  for_each_transform(of_all, batch, [&](const TransformState& state, std::size_t first, std::size_t end) HWY_ATTR {
    if (state.normal_scaling == NormalScaling::normalize) {
      transform_with<true>(state.normal_matrix, 1.0, batch, first, end, out);
    } else {
      const bool rescale = state.normal_scaling == NormalScaling::rescale;
      transform_with<false>(state.normal_matrix, rescale ? state.rescale_factor : 1.0, batch, first, end, out);
    }
  });
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
void transform_normals(const TransformState& state, const VertexBatch& batch, ProcessedVertices& out) {
  GOURAUD_SIMD_PICK(transform)(state, batch, out.normal_eye);
}
}  // namespace gouraud::pipeline
#endif
