// The level of detail of a block's fragments [GL1.5 §3.8.8 eq 3.16, 3.17], exact at each pixel's centre; for kernels:
// included inside a kernel file, once per instruction set.
//
// A texture coordinate is a quotient P / Q of two planes over the window (of s / w and 1 / w, say), so that
//   d(P/Q)/dx = (P_x Q - P Q_x) / Q^2,
// and the numerator does not change along x: it depends on the row alone, and that of d/dy on the column. So
//   lambda = max(rho_x(row), rho_y(column)) - 2 log2 Q
// with logarithms of 8 + 8 numbers a block and of one a lane; none where the whole block is magnified. Where Q changes by at
// most 1/16 from the block's centre, log2 Q of a lane is that of the centre and a short series.
// choice: for lines the same formula, which stays within the bounds that the specification sets for approximations.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_TEXTURE_LOD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_TEXTURE_LOD_INL_H_
#undef GOURAUD_PIPELINE_TEXTURE_LOD_INL_H_
#else
#define GOURAUD_PIPELINE_TEXTURE_LOD_INL_H_
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "pipeline/raster/interpolation-inl.h"
#include "pipeline/raster/primitive.h"
#include "pipeline/simd/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// A plane relative to the block's first pixel.
struct LocalPlane {
  double value = 0, dx = 0, dy = 0;
};

/// Coordinates of a texture as quotients of planes at a block.
struct CoordinatePlanes {
  std::array<LocalPlane, 3> numerator{};
  LocalPlane denominator{1, 0, 0};
};

/// The planes of the varyings [first, first + count) times Q, and Q itself: 1/w, or q/w if `has_q`.
HWY_INLINE CoordinatePlanes coordinate_planes(const FragmentBlock& block, const TextureCoordinateLayout& layout) {
  const VaryingRecord& record = varyings_of(*block.primitive);
  const VaryingPlane* planes = planes_of(record);
  const double x = block.x, y = block.y;
  LocalPlane w;
  if (record.perspective) {
    w = {(record.inverse_w_origin + record.inverse_w_dx * x) + record.inverse_w_dy * y, record.inverse_w_dx, record.inverse_w_dy};
  } else {
    w = {1, 0, 0};
  }
  const auto plane_of = [&](int index) {
    const VaryingPlane& p = planes[index];
    const double base = static_cast<double>(p.base);
    if ((record.constant >> index & 1) != 0) return LocalPlane{base * w.value, base * w.dx, base * w.dy};
    const LocalPlane own{(p.origin + p.dx * x) + p.dy * y, p.dx, p.dy};
    if (!record.perspective) return own;
    return LocalPlane{own.value + base * w.value, own.dx + base * w.dx, own.dy + base * w.dy};
  };
  CoordinatePlanes out;
  for (int k = 0; k < layout.dimensions; ++k) out.numerator[static_cast<std::size_t>(k)] = plane_of(layout.first + k);
  out.denominator = layout.has_q ? plane_of(layout.first + layout.dimensions) : w;
  return out;
}

/// log2 of rho in the lanes of a block, before bias.
class BlockLod {
  using EightTag = hn::CappedTag<float, 8>;

 public:
  /// `size[k]`: texels of the base level that coordinate k = 1 stands for; 0 for those that do not count.
  HWY_INLINE BlockLod(const CoordinatePlanes& planes, const std::array<float, 3>& size) {
    const LocalPlane& q = planes.denominator;
    // Logarithms of the numerators: of d/dx in rows 0 to 7, then of d/dy in columns 0 to 7.
    const EightTag d8;
    for (std::size_t i = 0; i < 8; i += hn::Lanes(d8)) {
      const auto step = hn::Load(d8, pair_column + i);
      auto along_x = hn::Zero(d8), along_y = hn::Zero(d8);
      for (std::size_t k = 0; k < 3; ++k) {
        if (size[k] == 0) continue;
        const LocalPlane& p = planes.numerator[k];
        const double texels = static_cast<double>(size[k]);
        const auto x0 = static_cast<float>((p.dx * q.value - p.value * q.dx) * texels);
        const auto y0 = static_cast<float>((p.dy * q.value - p.value * q.dy) * texels);
        const auto change = static_cast<float>((p.dx * q.dy - p.dy * q.dx) * texels);
        const auto x = hn::Add(hn::Set(d8, x0), hn::Mul(hn::Set(d8, change), step));
        const auto y = hn::Sub(hn::Set(d8, y0), hn::Mul(hn::Set(d8, change), step));
        along_x = hn::Add(along_x, hn::Mul(x, x));
        along_y = hn::Add(along_y, hn::Mul(y, y));
      }
      hn::Store(hn::Mul(log2(d8, along_x), hn::Set(d8, 0.5f)), d8, logs_ + i);
      hn::Store(hn::Mul(log2(d8, along_y), hn::Set(d8, 0.5f)), d8, logs_ + 8 + i);
    }
    const double rise_x = q.dx * 7, rise_y = q.dy * 7;
    const double lowest = q.value + std::min(rise_x, 0.0) + std::min(rise_y, 0.0);
    const double highest = q.value + std::max(rise_x, 0.0) + std::max(rise_y, 0.0);
    const double center = 0.5 * (lowest + highest);
    q_ = {static_cast<float>(q.value), static_cast<float>(q.dx), static_cast<float>(q.dy)};
    varies_little_ = center > 0 && highest - lowest <= 0.125 * center;
    if (varies_little_) {
      const double scale = 1.0 / center;
      change_ = {static_cast<float>((q.value - center) * scale), static_cast<float>(q.dx * scale), static_cast<float>(q.dy * scale)};
    }
    store_logs(static_cast<float>(lowest), static_cast<float>(highest), static_cast<float>(center), logs_ + 16);

    // Bounds of all lanes.
    const auto [least_x, most_x] = bounds(logs_);
    const auto [least_y, most_y] = bounds(logs_ + 8);
    lowest_ = std::max(least_x, least_y) - 2.0f * logs_[17];
    highest_ = std::max(most_x, most_y) - 2.0f * logs_[16];
  }

  HWY_INLINE float lowest() const { return lowest_; }
  HWY_INLINE float highest() const { return highest_; }

  /// adjusted(value) of the lanes of these row pairs.
  template <class Adjust>
  HWY_INLINE void lanes(const PairRange& pairs, float* out, const Adjust& adjusted) const {
    const FloatTag d;
    if (varies_little_) {
      return store_lanes(pairs, out, change_, adjusted, [&](FloatVector e) HWY_ATTR {
        // log2(1 + e) for |e| <= 1/16: the first five terms of the series, at most 1.5e-8 off.
        constexpr float terms[] = {1.44269504f, -0.72134752f, 0.48089835f, -0.36067376f, 0.28853901f};
        return hn::Add(hn::Set(d, logs_[18]), hn::Mul(e, polynomial(d, terms, e)));
      });
    }
    store_lanes(pairs, out, q_, adjusted, [&](FloatVector q) HWY_ATTR { return log2(d, q); });
  }

 private:
  /// (By way of memory a vector would wait for its lanes to be stored one by one.)
  static HWY_INLINE void store_logs(float a, float b, float c, float* out) {
    const EightTag d8;
#if HWY_TARGET == HWY_SCALAR
    for (const float v : {a, b, c}) hn::Store(log2(d8, hn::Set(d8, v)), d8, out++);
#else
    const auto ab = hn::IfThenElse(hn::FirstN(d8, 1), hn::Set(d8, a), hn::Set(d8, b));
    hn::Store(log2(d8, hn::IfThenElse(hn::FirstN(d8, 2), ab, hn::Set(d8, c))), d8, out);
#endif
  }

  /// log_of(value of the plane in a lane) is log2 Q.
  template <class Adjust, class LogOf>
  HWY_INLINE void store_lanes(const PairRange& pairs, float* out, const BlockPlane& plane, const Adjust& adjusted, const LogOf& log_of) const {
    const FloatTag d;
    for (std::size_t pair = pairs.first; pair < pairs.end; ++pair) {
      for (std::size_t offset = 0; offset < pair_lanes; offset += hn::Lanes(d)) {
        const FloatVector numerator = hn::Max(row_logs(pair, offset), column_logs(offset));
        const FloatVector value = hn::Add(first_pair(plane, offset), hn::Mul(hn::Set(d, static_cast<float>(pair)), pair_step(plane)));
        hn::Store(adjusted(hn::Sub(numerator, hn::Mul(hn::Set(d, 2.0f), log_of(value)))), d, out + pair * pair_lanes + offset);
      }
    }
  }

  HWY_INLINE FloatVector row_logs(std::size_t pair, std::size_t offset) const {
    const FloatTag d;
#if HWY_TARGET == HWY_AVX3  // 16 lanes: two rows
    return hn::IfThenElse(hn::FirstN(d, 8), hn::Set(d, logs_[2 * pair]), hn::Set(d, logs_[2 * pair + offset / 8 + 1]));
#else
    return hn::Set(d, logs_[2 * pair + offset / 8]);
#endif
  }
  HWY_INLINE FloatVector column_logs(std::size_t offset) const {
    const FloatTag d;
#if HWY_TARGET == HWY_AVX3
    const auto columns = hn::Load(EightTag(), logs_ + 8 + offset);
    return hn::Combine(d, columns, columns);
#else
    return hn::Load(d, logs_ + 8 + offset % 8);
#endif
  }

  struct Bounds {
    float least, most;
  };
  static HWY_INLINE Bounds bounds(const float* eight) {
    const EightTag d8;
    auto least = hn::Load(d8, eight), most = least;
    for (std::size_t i = hn::Lanes(d8); i < 8; i += hn::Lanes(d8)) {
      least = hn::Min(least, hn::Load(d8, eight + i));
      most = hn::Max(most, hn::Load(d8, eight + i));
    }
    return {hn::GetLane(hn::MinOfLanes(d8, least)), hn::GetLane(hn::MaxOfLanes(d8, most))};
  }

  /// Of the numerators in rows and columns; of Q: the lowest, the highest, the centre's.
  alignas(64) float logs_[24];
  BlockPlane q_, change_;  ///< Q, and Q / Q_center - 1
  bool varies_little_;
  float lowest_, highest_;
};

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
