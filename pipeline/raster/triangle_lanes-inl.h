// Triangles one a lane, for kernels: included inside a kernel file, once per instruction set.
//
// Everything is computed in double, so an instruction set works on as many triangles at once as it has lanes of double,
// and floats and integers come in vectors of as many lanes.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_RASTER_TRIANGLE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_RASTER_TRIANGLE_LANES_INL_H_
#undef GOURAUD_PIPELINE_RASTER_TRIANGLE_LANES_INL_H_
#else
#define GOURAUD_PIPELINE_RASTER_TRIANGLE_LANES_INL_H_
#endif

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "pipeline/raster/primitive.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
using F = hn::Rebind<float, D>;
using I = hn::Rebind<std::int32_t, D>;
using V = hn::Vec<D>;
using IV = hn::Vec<I>;
using Mask = hn::Mask<D>;
inline constexpr std::size_t max_lanes = 8;

HWY_INLINE V set(double value) { return hn::Set(D(), value); }
HWY_INLINE IV set_int(std::int32_t value) { return hn::Set(I(), value); }
template <class Vector>
HWY_INLINE Vector least(Vector a, Vector b, Vector c) { return hn::Min(hn::Min(a, b), c); }
template <class Vector>
HWY_INLINE Vector most(Vector a, Vector b, Vector c) { return hn::Max(hn::Max(a, b), c); }

HWY_INLINE std::uint64_t bits_of(Mask mask) {
  std::uint64_t bits = 0;
  hn::StoreMaskBits(D(), mask, reinterpret_cast<std::uint8_t*>(&bits));
  return bits;
}

/// The four floats of one struct a lane.
template <class Tag>
struct Quads {
  hn::Vec<Tag> x, y, z, w;
};
using FloatQuad = Quads<F>;
#if HWY_TARGET != HWY_SCALAR
/// The structs of lanes first, first + 4, ... in a vector.
template <class Tag, class At>
HWY_INLINE hn::Vec<Tag> load_every_fourth(Tag f, std::size_t first, At at) {
  if constexpr (hn::MaxLanes(Tag()) == 4) {
    return hn::LoadU(f, at(first));
  } else {
    const hn::Half<Tag> half;
    return hn::Combine(f, load_every_fourth(half, first + hn::Lanes(half), at), load_every_fourth(half, first, at));
  }
}
#endif

/// `at(lane)` is where the struct of that lane lies. Transposed in registers where they are wide enough: what is stored in
/// pieces and loaded as a whole makes a processor wait.
template <class Tag, class At>
HWY_INLINE Quads<Tag> load_quads(Tag f, At at) {
  Quads<Tag> q;
  constexpr std::size_t lanes = hn::MaxLanes(Tag());
#if HWY_TARGET != HWY_SCALAR
  if constexpr (lanes >= 4) {
    hn::Vec<Tag> v[4];
    for (std::size_t i = 0; i < 4; ++i) v[i] = load_every_fourth(f, i, at);
    const auto xy_even = hn::InterleaveLower(f, v[0], v[2]), xy_odd = hn::InterleaveLower(f, v[1], v[3]);
    const auto zw_even = hn::InterleaveUpper(f, v[0], v[2]), zw_odd = hn::InterleaveUpper(f, v[1], v[3]);
    q.x = hn::InterleaveLower(f, xy_even, xy_odd);
    q.y = hn::InterleaveUpper(f, xy_even, xy_odd);
    q.z = hn::InterleaveLower(f, zw_even, zw_odd);
    q.w = hn::InterleaveUpper(f, zw_even, zw_odd);
    return q;
  }
#endif
  alignas(64) float floats[4 * lanes];
  for (std::size_t lane = 0; lane < lanes; ++lane) std::memcpy(floats + 4 * lane, at(lane), 4 * sizeof(float));
  hn::LoadInterleaved4(f, floats, q.x, q.y, q.z, q.w);
  return q;
}

/// Window x and y from the top to 1/256 pixel, y up: nearest, ties to even, rounded in float as MESA-RULES 3 says.
template <class Ints>
struct SnappedCorner {
  Ints x, y;
};
template <class Floats>
HWY_INLINE auto snap(Floats coordinate) {
  const hn::DFromV<Floats> f;
  return hn::NearestInt(hn::Mul(hn::Sub(coordinate, hn::Set(f, 0.5f)), hn::Set(f, static_cast<float>(subpixels))));
}
template <class Floats>
HWY_INLINE auto snap_corner(Floats x, Floats y_raster, std::int32_t target_height_px) {
  const hn::RebindToSigned<hn::DFromV<Floats>> i;
  return SnappedCorner<hn::Vec<hn::RebindToSigned<hn::DFromV<Floats>>>>{
      snap(x), hn::Sub(hn::Set(i, (target_height_px - 1) * subpixels), snap(y_raster))};
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
