// Takes eye-space vertices, gives outcode bits of the user's clip planes [GL1.5 §2.12]. In double: what remains of the sum
// near a plane is what the cut is made of.
#include "pipeline/geometry/clip_planes.h"

#include <cstddef>

#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/geometry/clip_planes.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void test_plane(const glm::vec4& plane, std::uint16_t bit, ProcessedVertices& vertices) {
  const hn::CappedTag<double, 8> d;
  const hn::Rebind<float, decltype(d)> f;
  const auto& eye = vertices.position_eye;
  const auto a = hn::Set(d, static_cast<double>(plane.x)), b = hn::Set(d, static_cast<double>(plane.y));
  const auto c = hn::Set(d, static_cast<double>(plane.z)), e = hn::Set(d, static_cast<double>(plane.w));
  const auto coordinate = [&](std::size_t k, std::size_t i) HWY_ATTR { return hn::PromoteTo(d, hn::Load(f, &eye[k][i])); };
  const auto count = static_cast<std::size_t>(vertices.count);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto xy = hn::Add(hn::Mul(coordinate(0, i), a), hn::Mul(coordinate(1, i), b));
    const auto distance = hn::Add(hn::Add(xy, hn::Mul(coordinate(2, i), c)), hn::Mul(coordinate(3, i), e));
    std::uint64_t inside = 0;
    hn::StoreMaskBits(d, hn::Ge(distance, hn::Zero(d)), reinterpret_cast<std::uint8_t*>(&inside));
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
      const auto outside = static_cast<std::uint16_t>((inside >> lane & 1) != 0 ? 0 : bit);
      vertices.outcode[i + lane] = static_cast<std::uint16_t>(vertices.outcode[i + lane] | outside);
    }
  }
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {

void test_clip_planes(const ClipPlaneState& state, ProcessedVertices& vertices) {
  for (std::size_t i = 0; i < state.count; ++i) {
    GOURAUD_SIMD_PICK(test_plane)(state.plane_eye[i], static_cast<std::uint16_t>(outside_clip_plane_0 << i), vertices);
  }
}

double distance_from(const glm::vec4& plane, const ProcessedVertices& vertices, std::uint16_t index) {
  const auto& eye = vertices.position_eye;
  const double xy = static_cast<double>(eye[0][index]) * plane.x + static_cast<double>(eye[1][index]) * plane.y;
  return (xy + static_cast<double>(eye[2][index]) * plane.z) + static_cast<double>(eye[3][index]) * plane.w;
}

}  // namespace gouraud::pipeline
#endif
