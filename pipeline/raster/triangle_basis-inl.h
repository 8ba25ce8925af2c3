// Takes triangles of a group, one a lane; gives the basis of all their planes, from the unsnapped window positions; for
// kernels: included inside a kernel file, once per instruction set.
#include <hwy/highway.h>

#include "pipeline/raster/plane_lanes-inl.h"

#if defined(GOURAUD_PIPELINE_RASTER_TRIANGLE_BASIS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_RASTER_TRIANGLE_BASIS_INL_H_
#undef GOURAUD_PIPELINE_RASTER_TRIANGLE_BASIS_INL_H_
#else
#define GOURAUD_PIPELINE_RASTER_TRIANGLE_BASIS_INL_H_
#endif

#include <cstddef>

#include "pipeline/raster/triangles.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// Window positions of the corners, y up, depth and 1/w; and the positions as the vertices have them.
struct Corners {
  hn::Vec<F> window_x[3], window_y[3];
  V x[3], y[3], z[3], inverse_w[3];
};
HWY_INLINE Corners load_corners(const TriangleGroup& group, std::size_t first) {
  const D d;
  Corners c;
  const V height = set(group.state->target_height_px);
  for (std::size_t i = 0; i < 3; ++i) {
    const FloatQuad window = load_vertices(group, first, i, &KeptVertex::window);
    c.window_x[i] = window.x;
    c.window_y[i] = window.y;
    c.x[i] = hn::PromoteTo(d, window.x);
    c.y[i] = hn::Sub(height, hn::PromoteTo(d, window.y));
    c.z[i] = hn::PromoteTo(d, window.z);
    c.inverse_w[i] = hn::PromoteTo(d, window.w);
  }
  return c;
}

/// The corners in 1/256 pixel: integers.
struct SnappedPlaces {
  V x[3], y[3];
};
HWY_INLINE SnappedPlaces snap_places(const Corners& corners, std::int32_t target_height_px) {
  SnappedPlaces places;
  for (std::size_t i = 0; i < 3; ++i) {
    const SnappedCorner<IV> corner = snap_corner(corners.window_x[i], corners.window_y[i], target_height_px);
    places.x[i] = hn::PromoteTo(D(), corner.x);
    places.y[i] = hn::PromoteTo(D(), corner.y);
  }
  return places;
}

HWY_INLINE V area_of(const V (&x)[3], const V (&y)[3]) {
  return hn::Sub(hn::Mul(hn::Sub(x[1], x[0]), hn::Sub(y[2], y[0])), hn::Mul(hn::Sub(x[2], x[0]), hn::Sub(y[1], y[0])));
}

/// Where the unsnapped triangle has no area its plane is not defined: the snapped one's stands in.
HWY_INLINE void replace_places(Mask no_area, std::int32_t target_height_px, Corners& corners) {
  const SnappedPlaces snapped = snap_places(corners, target_height_px);
  const auto pixels = [](V place) HWY_ATTR { return hn::Add(hn::Mul(place, set(1.0 / subpixels)), set(0.5)); };
  for (std::size_t i = 0; i < 3; ++i) {
    corners.x[i] = hn::IfThenElse(no_area, pixels(snapped.x[i]), corners.x[i]);
    corners.y[i] = hn::IfThenElse(no_area, pixels(snapped.y[i]), corners.y[i]);
  }
}

HWY_INLINE Basis basis_of(Corners corners, std::int32_t target_height_px) {
  const V (&x)[3] = corners.x, (&y)[3] = corners.y;
  V area = area_of(x, y);
  const Mask no_area = hn::Eq(area, hn::Zero(D()));
  if (!hn::AllFalse(D(), no_area)) {
    replace_places(no_area, target_height_px, corners);
    area = area_of(x, y);
  }
  const V scale = hn::Div(set(1), area);
  return {x[0], y[0], hn::Mul(hn::Sub(y[2], y[0]), scale), hn::Mul(hn::Sub(x[0], x[2]), scale),
          hn::Mul(hn::Sub(y[0], y[1]), scale), hn::Mul(hn::Sub(x[1], x[0]), scale)};
}

/// For the second step of the group's setup.
HWY_INLINE void keep_basis(const Basis& basis, const Corners& corners, TriangleGroup& group, std::size_t first) {
  const D d;
  const V parts[6] = {basis.x0, basis.y0, basis.first_x, basis.first_y, basis.second_x, basis.second_y};
  for (std::size_t k = 0; k < 6; ++k) hn::Store(parts[k], d, group.basis[k] + first);
  for (std::size_t i = 0; i < 3; ++i) hn::Store(corners.inverse_w[i], d, group.inverse_w[i] + first);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
