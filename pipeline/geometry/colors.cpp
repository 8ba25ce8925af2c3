// Takes the current colours of unlit vertices, gives them clamped, secondary ones as well [GL1.5 §2.14.6].
#include "pipeline/geometry/colors.h"

#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/geometry/colors.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/simd/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

void clamp_colors(const VertexBatch& batch, ProcessedVertices& out) {
  const hn::CappedTag<float, 16> d;
  const auto count = static_cast<std::size_t>(batch.count);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto channel = [&](std::size_t k) HWY_ATTR { return clamp_to_unit(d, hn::Load(d, &batch.color[k][i])); };
    hn::StoreInterleaved4(channel(0), channel(1), channel(2), channel(3), d, &out.color_front[i].r);
  }
}

void clamp_secondary(const VertexBatch& batch, ProcessedVertices& out) {
  const hn::CappedTag<float, 16> d;
  const auto count = static_cast<std::size_t>(batch.count);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto channel =
        [&](std::size_t k) HWY_ATTR { return clamp_to_unit(d, hn::Load(d, &batch.secondary_color[k][i])); };
    hn::StoreInterleaved4(channel(0), channel(1), channel(2), hn::Zero(d), d, &out.specular_front[i].r);
  }
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
void clamp_vertex_colors(const VertexBatch& batch, ProcessedVertices& out) {
  GOURAUD_SIMD_PICK(clamp_colors)(batch, out);
}
void clamp_secondary_colors(const VertexBatch& batch, ProcessedVertices& out) {
  GOURAUD_SIMD_PICK(clamp_secondary)(batch, out);
}
}  // namespace gouraud::pipeline
#endif
