// Takes a block with its varyings, gives the filtered texels of one unit in its covered lanes.
// choice: coordinates that do not vary (points) have rho = 0.
#include "pipeline/texture/sampling.h"

#include <algorithm>

#include "pipeline/simd/dispatch.h"
#include "pipeline/texture/seams.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/texture/sampling.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/texture/anisotropy-inl.h"
#include "pipeline/texture/levels-inl.h"
#include "pipeline/texture/tiles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// One face's coordinates of a block's lanes.
struct LaneCoordinates {
  std::array<const float*, 3> coordinate{};
  const float* compared = nullptr;
  std::int32_t face = 0;
};

/// All texels that a filter of these axes reads.
void make_tiles_readable(const PreparedLevel& level, const std::array<AxisTexels, 3>& axis, int dimensions, bool linear, std::uint64_t lanes) {
  const IntTag d;
  std::int32_t last = -1;
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    const std::uint64_t wanted = lane_bits(lanes, lane);
    if (wanted == 0) continue;
    for (int corner = 0; corner < (linear ? 1 << dimensions : 1); ++corner) {
      IntVector offset = hn::Zero(d);
      for (std::size_t k = 0; k < static_cast<std::size_t>(dimensions); ++k) {
        offset = hn::Add(offset, hn::Load(d, ((corner >> k & 1) != 0 ? axis[k].second : axis[k].first).data() + lane));
      }
      make_tiles_readable(*level.image->tiles, offset, wanted, last);
    }
  }
}

/// The absolute values of one coordinate.
HWY_INLINE const float* mirrored(const float* s, std::array<float, 64>& out) {
  const FloatTag d;
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) hn::Store(hn::Abs(hn::Load(d, s + lane)), d, out.data() + lane);
  return out.data();
}

/// Those lanes whose linear filter reaches over an edge of a cube's face of this size (seams.h).
HWY_INLINE std::uint64_t lanes_across_seams(const float* s, const float* t, float size, std::uint64_t lanes) {
  const FloatTag d;
  std::uint64_t across = 0;
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    const std::uint64_t wanted = lane_bits(lanes, lane);
    if (wanted == 0) continue;
    const auto inside = [&](const float* c) HWY_ATTR {
      const FloatVector kept = hn::Min(at_least(d, hn::Load(d, c + lane), hn::Zero(d)), hn::Set(d, 1.0f));
      const FloatVector u = hn::Sub(hn::Mul(kept, hn::Set(d, size)), hn::Set(d, 0.5f));
      return hn::And(hn::Ge(u, hn::Zero(d)), hn::Lt(u, hn::Set(d, size - 1.0f)));
    };
    across |= (wanted & ~bits_of(d, hn::And(inside(s), inside(t)))) << lane;
  }
  return across;
}

/// Reads one level with one filter.
HWY_INLINE void read_level(const PreparedUnit& unit, const LaneCoordinates& at, std::int32_t index, TexelFilter filter,
                           std::uint64_t lanes, bool keeps_others, TexelBlock& out) {
  const PreparedLevel& level = unit.level(at.face, index);
  const bool linear = filter == TexelFilter::linear;
  std::array<AxisTexels, 3> axis;
  LevelRead read{&unit, level.texels, &axis, at.compared, lanes, keeps_others, false};
  for (std::size_t k = 0; k < static_cast<std::size_t>(unit.dimensions); ++k) {
    const WrapMode wrap = unit.state.sampler.wrap[k];
    const AxisAddress address = address_of(level, k, can_leave(wrap, linear));
    const float scale = unit.state.target == TextureTarget::rectangle ? 1.0f : static_cast<float>(level.size[k]);
    read.reaches_border |= address.marks;
    alignas(64) std::array<float, 64> distances;
    const float* const s = unit.state.sampler.mirrored_once[k] ? mirrored(at.coordinate[k], distances) : at.coordinate[k];
    if (linear) axis_texels<true>(wrap, s, scale, address, lanes, axis[k]);
    else axis_texels<false>(wrap, s, scale, address, lanes, axis[k]);
  }
  if (level.tiled) make_tiles_readable(level, axis, unit.dimensions, linear, lanes);
  unit.kernel[linear ? 1 : 0](read, out);
  if (linear && unit.state.sampler.seamless && unit.state.target == TextureTarget::cube_map) {
    const float *const s = at.coordinate[0], *const t = at.coordinate[1];
    const std::uint64_t across = lanes_across_seams(s, t, static_cast<float>(level.size[0]), lanes);
    if (across != 0) filter_across_seams(unit, at.face, index, s, t, across, out);
  }
}

/// out = out + (other - out) * weight in the chosen lanes.
HWY_INLINE void mix_levels(const TexelBlock& other, const float* weight, std::uint64_t lanes, TexelBlock& out) {
  const FloatTag d;
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    const std::uint64_t wanted = lane_bits(lanes, lane);
    if (wanted == 0) continue;
    const FloatVector w = hn::Load(d, weight + lane);
    for (std::size_t k = 0; k < 4; ++k) {
      const FloatVector a = hn::Load(d, out.channel[k].data() + lane), b = hn::Load(d, other.channel[k].data() + lane);
      const FloatVector mixed = hn::Add(a, hn::Mul(hn::Sub(b, a), w));
      hn::Store(hn::IfThenElse(mask_of(d, wanted), mixed, a), d, out.channel[k].data() + lane);
    }
  }
}

/// out += other in the chosen lanes.
HWY_INLINE void add_texels(const TexelBlock& other, std::uint64_t lanes, TexelBlock& out) {
  const FloatTag d;
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    const std::uint64_t wanted = lane_bits(lanes, lane);
    if (wanted == 0) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      const FloatVector a = hn::Load(d, out.channel[k].data() + lane), b = hn::Load(d, other.channel[k].data() + lane);
      hn::Store(hn::IfThenElse(mask_of(d, wanted), hn::Add(a, b), a), d, out.channel[k].data() + lane);
    }
  }
}

/// out /= divisor.
HWY_INLINE void divide_texels(const float* divisor, std::uint64_t lanes, TexelBlock& out) {
  const FloatTag d;
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    if (lane_bits(lanes, lane) == 0) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      float* const texels = out.channel[k].data() + lane;
      hn::Store(hn::Div(hn::Load(d, texels), hn::Load(d, divisor + lane)), d, texels);
    }
  }
}

/// Levels of one face into a block of texels (levels-inl.h).
struct FaceReader {
  const PreparedUnit& unit;
  const LaneCoordinates& at;
  TexelBlock& out;

  HWY_INLINE void read(std::int32_t index, TexelFilter filter, std::uint64_t lanes, bool keeps_others) {
    read_level(unit, at, index, filter, lanes, keeps_others, out);
  }
  HWY_INLINE void read_two(std::int32_t index, const float* share, std::uint64_t lanes, bool keeps_others) {
    const TexelFilter filter = unit.state.sampler.minify;
    TexelBlock next;
    read_level(unit, at, index, filter, lanes, keeps_others, out);
    read_level(unit, at, index + 1, filter, lanes, false, next);
    mix_levels(next, share, lanes, out);
  }
};

/// r clamped to [0, 1], if the unit compares [GL1.5 §3.8.14]. Depth textures have at most two dimensions: r is the third.
HWY_INLINE const float* compared_lanes(const PreparedUnit& unit, const DividedCoordinates& coordinates, float* storage) {
  const FloatTag d;
  if (!unit.state.sampler.compares) return nullptr;
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    hn::Store(clamp_to_unit(d, hn::Load(d, coordinates.coordinate[2] + lane)), d, storage + lane);
  }
  return storage;
}

void sample_base_level(const FragmentBlock& block, const PreparedUnit& unit, TexelBlock& out) {
  const DividedCoordinates coordinates(block, layout_of(block, unit));
  alignas(64) float r[64];
  const LaneCoordinates at{coordinates.coordinate, compared_lanes(unit, coordinates, r), 0};
  read_level(unit, at, 0, unit.state.sampler.minify, block.coverage, false, out);
}

void sample_levels(const FragmentBlock& block, const PreparedUnit& unit, TexelBlock& out) {
  const TextureCoordinateLayout& layout = layout_of(block, unit);
  const DividedCoordinates coordinates(block, layout);
  alignas(64) float r[64];
  const LaneCoordinates at{coordinates.coordinate, compared_lanes(unit, coordinates, r), 0};
  FaceReader reader{unit, at, out};
  read_levels(unit, reader, coordinate_planes(block, layout), block.coverage, false);
}

/// Magnified and minified lanes, whose level of detail is `lambda`: it is used up.
HWY_INLINE void read_at(const PreparedUnit& unit, FaceReader& reader, float* lambda, std::uint64_t lanes) {
  const SamplerState& sampler = unit.state.sampler;
  if (needs_no_lod(sampler)) return reader.read(0, sampler.minify, lanes, false);
  const std::uint64_t minified = lanes & lanes_above_zero(lambda), magnified = lanes & ~minified;
  if (magnified != 0) reader.read(0, sampler.magnify, magnified, false);
  if (minified == 0) return;
  if (sampler.mip == MipFilter::none) return reader.read(0, sampler.minify, minified, magnified != 0);
  read_minified(unit, reader, sampler.min_lod, sampler.max_lod, lambda, minified, magnified != 0);
}

/// The means of several samples along the longer side of each lane's footprint (anisotropy-inl.h).
void sample_anisotropic(const FragmentBlock& block, const PreparedUnit& unit, TexelBlock& out) {
  const FloatTag d;
  const SamplerState& sampler = unit.state.sampler;
  const TextureCoordinateLayout& layout = layout_of(block, unit);
  const DividedCoordinates coordinates(block, layout);
  const PairRange pairs = covered_pairs(block.coverage);
  const std::size_t begin = pairs.first * pair_lanes, end = pairs.end * pair_lanes;
  BlockFootprints footprints(coordinate_planes(block, layout), base_size(unit), sampler.max_anisotropy, pairs);
  alignas(64) float r[64], moved[3][64], lambda[64];
  const LaneCoordinates at{{moved[0], moved[1], moved[2]}, compared_lanes(unit, coordinates, r), 0};
  for (std::size_t lane = begin; lane < end; lane += hn::Lanes(d)) {
    const FloatVector biased = hn::Add(hn::Load(d, footprints.lambda + lane), hn::Set(d, sampler.lod_bias));
    hn::Store(kept_between(biased, sampler.min_lod, sampler.max_lod), d, footprints.lambda + lane);
  }
  TexelBlock probe;
  std::uint64_t lanes = block.coverage;
  for (int i = 1; lanes != 0; ++i) {
    const auto number = static_cast<float>(i);
    for (std::size_t lane = begin; lane < end; lane += hn::Lanes(d)) {
      const FloatVector count = hn::Load(d, footprints.probes + lane);
      const FloatVector place = hn::Sub(hn::Div(hn::Set(d, number), hn::Add(count, hn::Set(d, 1.0f))), hn::Set(d, 0.5f));
      for (std::size_t k = 0; k < static_cast<std::size_t>(unit.dimensions); ++k) {
        const FloatVector center = hn::Load(d, coordinates.coordinate[k] + lane);
        hn::Store(hn::Add(center, hn::Mul(place, hn::Load(d, footprints.along[k] + lane))), d, moved[k] + lane);
      }
      hn::Store(hn::Load(d, footprints.lambda + lane), d, lambda + lane);
    }
    FaceReader reader{unit, at, i == 1 ? out : probe};
    read_at(unit, reader, lambda, lanes);
    if (i > 1) add_texels(probe, lanes, out);
    lanes &= lanes_above(footprints.probes, number);
  }
  divide_texels(footprints.probes, block.coverage, out);
}

/// Signs and axes of [GL1.5 Table 3.20]: s_c, t_c and |m_a| of a face, by axis of (r_x, r_y, r_z).
struct FaceAxes {
  std::int8_t s_axis, s_sign, t_axis, t_sign, m_axis, m_sign;
};
inline constexpr std::array<FaceAxes, 6> face_axes{{{2, -1, 1, -1, 0, 1},
                                                    {2, 1, 1, -1, 0, -1},
                                                    {0, 1, 2, 1, 1, 1},
                                                    {0, 1, 2, -1, 1, -1},
                                                    {0, 1, 1, -1, 2, 1},
                                                    {0, -1, 1, -1, 2, -1}}};

/// Which face each of the lanes' directions hits. choice: where two are equally long, x before y before z, as Mesa.
HWY_INLINE void select_faces(const std::array<const float*, 3>& direction, std::uint64_t lanes, std::array<std::uint64_t, 6>& lanes_of) {
  const FloatTag d;
  lanes_of = {};
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    if (lane_bits(lanes, lane) == 0) continue;
    const FloatVector x = hn::Load(d, direction[0] + lane), y = hn::Load(d, direction[1] + lane), z = hn::Load(d, direction[2] + lane);
    const std::uint64_t all = (std::uint64_t{1} << hn::Lanes(d)) - 1;
    const std::uint64_t along_x = bits_of(d, hn::And(hn::Ge(hn::Abs(x), hn::Abs(y)), hn::Ge(hn::Abs(x), hn::Abs(z))));
    const std::uint64_t along_y = bits_of(d, hn::Ge(hn::Abs(y), hn::Abs(z))) & ~along_x;
    const std::uint64_t along_z = all & ~(along_x | along_y);
    const auto negative = [&](FloatVector v) HWY_ATTR { return bits_of(d, hn::Lt(v, hn::Zero(d))); };
    const std::array<std::uint64_t, 3> along{along_x, along_y, along_z}, below{negative(x), negative(y), negative(z)};
    for (std::size_t k = 0; k < 3; ++k) {
      lanes_of[2 * k] |= (along[k] & ~below[k]) << lane;
      lanes_of[2 * k + 1] |= (along[k] & below[k]) << lane;
    }
  }
}

HWY_INLINE LocalPlane times(const LocalPlane& plane, double factor) { return {plane.value * factor, plane.dx * factor, plane.dy * factor}; }

void sample_cube_map(const FragmentBlock& block, const PreparedUnit& unit, TexelBlock& out) {
  const FloatTag d;
  const TextureCoordinateLayout& layout = layout_of(block, unit);
  std::array<const float*, 3> direction;
  for (std::size_t k = 0; k < 3; ++k) direction[k] = block.varying[static_cast<std::size_t>(layout.first) + k].data();
  std::array<std::uint64_t, 6> lanes_of;
  select_faces(direction, block.coverage, lanes_of);
  TextureCoordinateLayout undivided = layout;
  undivided.has_q = false;
  const CoordinatePlanes planes = coordinate_planes(block, undivided);
  bool keeps_others = false;
  for (std::size_t face = 0; face < 6; ++face) {
    const std::uint64_t lanes = lanes_of[face] & block.coverage;
    if (lanes == 0) continue;
    const FaceAxes& axes = face_axes[face];
    const auto of = [](std::int8_t axis) { return static_cast<std::size_t>(axis); };
    alignas(64) float s[64], t[64];
    for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
      if (lane_bits(lanes, lane) == 0) continue;
      const FloatVector reach = hn::Abs(hn::Load(d, direction[of(axes.m_axis)] + lane));
      const auto coordinate = [&](std::int8_t axis, std::int8_t sign) HWY_ATTR {
        const FloatVector c = hn::Mul(hn::Load(d, direction[of(axis)] + lane), hn::Set(d, 0.5f * sign));
        return hn::Add(hn::Div(c, reach), hn::Set(d, 0.5f));
      };
      hn::Store(coordinate(axes.s_axis, axes.s_sign), d, s + lane);
      hn::Store(coordinate(axes.t_axis, axes.t_sign), d, t + lane);
    }
    CoordinatePlanes on_face;
    on_face.numerator[0] = times(planes.numerator[of(axes.s_axis)], 0.5 * axes.s_sign);
    on_face.numerator[1] = times(planes.numerator[of(axes.t_axis)], 0.5 * axes.t_sign);
    on_face.denominator = times(planes.numerator[of(axes.m_axis)], axes.m_sign);
    const LaneCoordinates at{{s, t, nullptr}, nullptr, static_cast<std::int32_t>(face)};
    const bool part = keeps_others || lanes != block.coverage;
    FaceReader reader{unit, at, out};
    if (needs_no_lod(unit.state.sampler)) reader.read(0, unit.state.sampler.minify, lanes, part);
    else read_levels(unit, reader, on_face, lanes, part);
    keeps_others = true;
  }
}

SampleFunction select(const PreparedUnit& unit) {
  if (unit.state.target == TextureTarget::cube_map) return sample_cube_map;
  if (unit.state.sampler.max_anisotropy > 1) return sample_anisotropic;
  return needs_no_lod(unit.state.sampler) ? sample_base_level : sample_levels;
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
SampleFunction sample_function(const PreparedUnit& unit) { return GOURAUD_SIMD_PICK(select)(unit); }
}  // namespace gouraud::pipeline
#endif
