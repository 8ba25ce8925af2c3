// Takes a block and its primitive, gives the block with colours and varyings.
//
// Subdivided affine (affine8, affine16): along each row the true value, with its division, at every 8th or 16th column, and straight
// lines between. Two divisions in place of eight or sixteen; the error falls with the square of the interval, so that it is hardly
// seen but where a row runs far into the distance. The places between which it interpolates may lie outside the
// primitive, where the plane is extrapolated, at most to the nearest vertex's distance.
// Source: M. Abrash, "Graphics programming black book", 1997, on the spans of Quake (id Software, 1996): every 16 pixels.
//
// Barycentric: the weights of the three vertices at every pixel, as areas, times each vertex's 1/w; a value is the weighted mean
// of the vertices'. The definition, without planes: three products a value and pixel in place of one addition. In float,
// from window coordinates, so that it loses bits on small triangles far from the origin. Lines, points and homogeneous
// triangles, which have no three vertices to weigh, are interpolated by planes.
// Source: A. F. Moebius, "Der barycentrische Calcul", 1827; perspective: J. Blinn, "Hyperbolic interpolation", 1992.
#include "pipeline/fragment/interpolation_methods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "pipeline/fragment/color_write.h"
#include "pipeline/fragment/varyings.h"
#include "pipeline/raster/method_shape.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/interpolation_methods.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using RowTag = hn::CappedTag<float, 8>;  ///< (part of) a row of a block

/// A value over the window: (base + plane / q), between limits.
struct Hyperbola {
  double origin, dx, dy;
  float base, minimum, maximum;
};
struct InverseW {
  double origin, dx, dy;
  float minimum;
};

template <std::int32_t interval>
HWY_INLINE void subdivide(const FragmentBlock& block, const InverseW& q, const Hyperbola& value, float* lanes) {
  const RowTag d;
  const std::int32_t first = block.x / interval * interval;
  const auto low = hn::Set(d, value.minimum), high = hn::Set(d, value.maximum);
  for (std::int32_t row = 0; row < 8; ++row) {
    const double y = block.y + row;
    const auto at = [&](double x) HWY_ATTR {
      const double inverse_w = HWY_MAX((q.origin + q.dx * x) + q.dy * y, static_cast<double>(q.minimum));
      return static_cast<float>(value.base + ((value.origin + value.dx * x) + value.dy * y) / inverse_w);
    };
    const float start = at(first), step = (at(first + interval) - start) / static_cast<float>(interval);
    for (std::size_t column = 0; column < 8; column += hn::Lanes(d)) {
      const auto steps = hn::Iota(d, static_cast<float>(block.x - first) + static_cast<float>(column));
      const auto v = hn::Add(hn::Set(d, start), hn::Mul(hn::Set(d, step), steps));
      hn::Store(hn::Min(hn::Max(v, low), high), d, lanes + 8 * row + static_cast<std::int32_t>(column));
    }
  }
}

template <std::int32_t interval>
void subdivide_colors(FragmentBlock& block, const TileTarget& target) {
  const ColorRecord& color = color_of(*block.primitive);
  if (color.variation != ColorVariation::perspective) return pipeline::color_interpolation_pass()(block, target);
  const InverseW q{color.inverse_w_origin, color.inverse_w_dx, color.inverse_w_dy, color.inverse_w_minimum};
  for (std::size_t k = 0; k < 4; ++k) {
    subdivide<interval>(block, q, {color.origin[k], color.dx[k], color.dy[k], color.base[k], color.minimum[k], color.maximum[k]},
                        block.color[k].data());
  }
}

template <std::int32_t interval>
void subdivide_varyings(FragmentBlock& block, const TileTarget& target) {
  const VaryingRecord& record = varyings_of(*block.primitive);
  if (!record.perspective) return pipeline::varying_interpolation_pass()(block, target);
  const InverseW q{record.inverse_w_origin, record.inverse_w_dx, record.inverse_w_dy, record.inverse_w_minimum};
  const auto count = static_cast<std::size_t>(block.primitive->binding->varyings.count);
  for (std::size_t k = 0; k < count; ++k) {
    const VaryingPlane& p = planes_of(record)[k];
    if ((record.constant >> k & 1) != 0) {
      block.varying[k].fill(p.base);
    } else {
      subdivide<interval>(block, q, {p.origin, p.dx, p.dy, p.base, p.minimum, p.maximum}, block.varying[k].data());
    }
  }
}

/// The vertices' shares of each lane: they add up to 1.
using Weights = std::array<std::array<float, 64>, 3>;
HWY_INLINE void weigh(const FragmentBlock& block, const MethodTriangle& triangle, Weights& weights) {
  const RowTag d;
  float x[3], y[3], q[3];
  const float largest = HWY_MAX(HWY_MAX(triangle.window[0]->w_inverse, triangle.window[1]->w_inverse), triangle.window[2]->w_inverse);
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = static_cast<float>(triangle.corner[i].x);
    y[i] = static_cast<float>(triangle.corner[i].y);
    q[i] = triangle.window[i]->w_inverse / largest;
  }
  for (std::size_t row = 0; row < 8; ++row) {
    const float py = static_cast<float>(block.y) + static_cast<float>(row) + 0.5f;
    for (std::size_t column = 0; column < 8; column += hn::Lanes(d)) {
      const auto px = hn::Iota(d, static_cast<float>(block.x) + static_cast<float>(column) + 0.5f);
      const auto opposite = [&](std::size_t a, std::size_t b) HWY_ATTR {  // the area of the pixel and the edge from a to b
        const auto left = hn::Mul(hn::Set(d, x[b] - x[a]), hn::Set(d, py - y[a]));
        return hn::Sub(left, hn::Mul(hn::Set(d, y[b] - y[a]), hn::Sub(px, hn::Set(d, x[a]))));
      };
      const auto w0 = hn::Mul(opposite(1, 2), hn::Set(d, q[0])), w1 = hn::Mul(opposite(2, 0), hn::Set(d, q[1]));
      const auto w2 = hn::Mul(opposite(0, 1), hn::Set(d, q[2])), sum = hn::Add(hn::Add(w0, w1), w2);
      const std::size_t lane = 8 * row + column;
      hn::Store(hn::Div(w0, sum), d, weights[0].data() + lane);
      hn::Store(hn::Div(w1, sum), d, weights[1].data() + lane);
      hn::Store(hn::Div(w2, sum), d, weights[2].data() + lane);
    }
  }
}

/// The weighted mean of three values, in every lane. Lanes far outside the triangle, where the sum may be 0, hold the minimum.
HWY_INLINE void mix(const Weights& weights, const std::array<float, 3>& value, float* lanes) {
  const RowTag d;
  const auto low = hn::Set(d, HWY_MIN(HWY_MIN(value[0], value[1]), value[2]));
  const auto high = hn::Set(d, HWY_MAX(HWY_MAX(value[0], value[1]), value[2]));
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    const auto part = [&](std::size_t i) HWY_ATTR { return hn::Mul(hn::Load(d, weights[i].data() + lane), hn::Set(d, value[i])); };
    const auto v = hn::Add(hn::Add(part(0), part(1)), part(2));
    const auto clamped = hn::Min(hn::Max(v, low), high);
    hn::Store(hn::IfThenElse(hn::Eq(v, v), clamped, low), d, lanes + lane);
  }
}

void mix_colors(FragmentBlock& block, const TileTarget& target) {
  const MethodTriangle* const triangle = vertices_of(*block.primitive);
  const ColorVariation variation = color_of(*block.primitive).variation;
  const bool varies = variation == ColorVariation::affine || variation == ColorVariation::perspective;
  if (triangle == nullptr || !varies) return pipeline::color_interpolation_pass()(block, target);
  alignas(64) Weights weights;
  weigh(block, *triangle, weights);
  const auto& c = triangle->color;
  const float scale = triangle->color_scale;
  const auto channel = [&](std::size_t k, float Rgba::*member) HWY_ATTR {
    mix(weights, {HWY_MIN(c[0]->*member, 1.0f) * scale, HWY_MIN(c[1]->*member, 1.0f) * scale, HWY_MIN(c[2]->*member, 1.0f) * scale},
        block.color[k].data());
  };
  channel(0, &Rgba::r);
  channel(1, &Rgba::g);
  channel(2, &Rgba::b);
  channel(3, &Rgba::a);
}

void mix_varyings(FragmentBlock& block, const TileTarget& target) {
  const MethodTriangle* const triangle = vertices_of(*block.primitive);
  if (triangle == nullptr) return pipeline::varying_interpolation_pass()(block, target);
  const VaryingRecord& record = varyings_of(*block.primitive);
  alignas(64) Weights weights;
  weigh(block, *triangle, weights);
  const auto count = static_cast<std::size_t>(block.primitive->binding->varyings.count);
  for (std::size_t k = 0; k < count; ++k) {
    if ((record.constant >> k & 1) != 0) {
      block.varying[k].fill(planes_of(record)[k].base);
    } else {
      mix(weights, {triangle->varyings[0][k], triangle->varyings[1][k], triangle->varyings[2][k]}, block.varying[k].data());
    }
  }
}

FragmentPass select_colors(InterpolationMethod method) {
  switch (method) {
    case InterpolationMethod::affine8: return subdivide_colors<8>;
    case InterpolationMethod::affine16: return subdivide_colors<16>;
    case InterpolationMethod::barycentric: return mix_colors;
    default: break;
  }
  return pipeline::color_interpolation_pass();
}

FragmentPass select_varyings_method(InterpolationMethod method, LanesWanted wanted) {
  switch (method) {
    case InterpolationMethod::affine8: return subdivide_varyings<8>;
    case InterpolationMethod::affine16: return subdivide_varyings<16>;
    case InterpolationMethod::barycentric: return mix_varyings;
    default: break;
  }
  return pipeline::varying_interpolation_pass(wanted);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
FragmentPass color_interpolation_pass(InterpolationMethod method) { return GOURAUD_SIMD_PICK(select_colors)(method); }
FragmentPass varying_interpolation_pass(InterpolationMethod method, LanesWanted wanted) {
  return GOURAUD_SIMD_PICK(select_varyings_method)(method, wanted);
}
}  // namespace gouraud::pipeline
#endif
