// The level of detail of a block's fragments [GL1.5 §3.8.8 eq 3.16, 3.17], exact at each pixel's centre; for kernels:
// included inside a kernel file, once per instruction set.
//
// A texture coordinate is a quotient P / Q of two planes over the window (of s / w and 1 / w, say), so that
//   d(P/Q)/dx = (P_x Q - P Q_x) / Q^2,
// and the numerator does not change along x: it depends on the row alone, and that of d/dy on the column. So
//   lambda = max(rho_x(row), rho_y(column)) - 2 log2 Q
// with logarithms of 8 + 8 numbers a block and of one a lane; none where the whole block is magnified.
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
 public:
  /// `size[k]`: texels of the base level that coordinate k = 1 stands for; 0 for those that do not count.
  HWY_INLINE BlockLod(const CoordinatePlanes& planes, const std::array<float, 3>& size) {
    const FloatTag d;
    const LocalPlane& q = planes.denominator;
    // Squares of the numerators: of d/dx in rows 0 to 7, then of d/dy in columns 0 to 7.
    alignas(64) float squares[numbers];
    const hn::CappedTag<float, 8> d8;
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
      hn::Store(along_x, d8, squares + i);
      hn::Store(along_y, d8, squares + 8 + i);
    }
    const double rise_x = q.dx * 7, rise_y = q.dy * 7;
    const double lowest = q.value + std::min(rise_x, 0.0) + std::min(rise_y, 0.0);
    const double highest = q.value + std::max(rise_x, 0.0) + std::max(rise_y, 0.0);
    q_ = {static_cast<float>(q.value), static_cast<float>(q.dx), static_cast<float>(q.dy)};
    varies_ = q.dx != 0 || q.dy != 0;
    for (std::size_t i = 16; i < numbers; ++i) squares[i] = 1.0f;
    squares[16] = static_cast<float>(lowest);
    squares[17] = static_cast<float>(highest);
    for (std::size_t i = 0; i < numbers; i += hn::Lanes(d)) hn::Store(log2(d, hn::Load(d, squares + i)), d, logs_ + i);
    for (std::size_t i = 0; i < 16; ++i) logs_[i] *= 0.5f;

    // Bounds of all lanes.
    const auto [least_x, most_x] = std::minmax_element(logs_, logs_ + 8);
    const auto [least_y, most_y] = std::minmax_element(logs_ + 8, logs_ + 16);
    lowest_ = std::max(*least_x, *least_y) - 2.0f * logs_[17];
    highest_ = std::max(*most_x, *most_y) - 2.0f * logs_[16];
  }

  HWY_INLINE float lowest() const { return lowest_; }
  HWY_INLINE float highest() const { return highest_; }

  /// All lanes.
  HWY_INLINE void lanes(float* out) const {
    const FloatTag d;
    alignas(64) float rows[16];
    for (std::size_t pair = 0; pair < row_pairs; ++pair) {
      std::fill(rows, rows + 8, logs_[2 * pair]);
      std::fill(rows + 8, rows + 16, logs_[2 * pair + 1]);
      for (std::size_t offset = 0; offset < pair_lanes; offset += hn::Lanes(d)) {
        const FloatVector numerator = hn::Max(hn::Load(d, rows + offset), column_logs(offset));
        const FloatVector q = hn::Add(first_pair(q_, offset), hn::Mul(hn::Set(d, static_cast<float>(pair)), pair_step(q_)));
        hn::Store(hn::Sub(numerator, hn::Mul(hn::Set(d, 2.0f), varies_ ? log2(d, q) : hn::Set(d, logs_[16]))), d,
                  out + pair * pair_lanes + offset);
      }
    }
  }

 private:
  HWY_INLINE FloatVector column_logs(std::size_t offset) const {
    alignas(64) float columns[16];
    for (std::size_t i = 0; i < 16; ++i) columns[i] = logs_[8 + i % 8];
    return hn::Load(FloatTag(), columns + offset);
  }

  static constexpr std::size_t numbers = 32;
  alignas(64) float logs_[numbers];
  BlockPlane q_;
  bool varies_;
  float lowest_, highest_;
};

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
