// Takes a block with its varyings, gives the filtered texels of one unit in its covered lanes. Levels are read one at a
// time, for all lanes that need them: a block in which every lane has the same level reads it without asking lane by lane.
// choice: magnification begins at lambda = 0 whatever the filters are, as Mesa has it, and not at 1/2 for NEAREST_MIPMAP
// minification with LINEAR magnification [GL1.5 §3.8.9].
// choice: coordinates that do not vary (points) have rho = 0.
#include "pipeline/texture/sampling.h"

#include <algorithm>

#include "pipeline/simd/dispatch.h"
#include "pipeline/texture/seams.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/texture/sampling.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/texture/lod-inl.h"
#include "pipeline/texture/wrap-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// One face's coordinates of a block's lanes.
struct LaneCoordinates {
  std::array<const float*, 3> coordinate{};
  const float* compared = nullptr;
  std::int32_t face = 0;
};

/// Tiles that a cleared framebuffer owes its pixels (TiledBuffer) get them before they are read.
void make_tiles_readable(const PreparedLevel& level, const std::array<AxisTexels, 3>& axis, bool linear, std::uint64_t lanes) {
  std::int32_t last = -1;
  for (std::size_t lane = 0; lane < 64; ++lane) {
    if ((lanes >> lane & 1) == 0) continue;
    for (int corner = 0; corner < (linear ? 4 : 1); ++corner) {
      const std::int32_t offset = ((corner & 1) != 0 ? axis[0].second : axis[0].first)[lane] +
                                  ((corner & 2) != 0 ? axis[1].second : axis[1].first)[lane];
      const std::int32_t tile = offset / pixels_per_tile;
      if (offset < 0 || tile == last) continue;
      last = tile;
      level.image->tiles->make_readable(tile);
    }
  }
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
    if (linear) axis_texels<true>(wrap, at.coordinate[k], scale, address, lanes, axis[k]);
    else axis_texels<false>(wrap, at.coordinate[k], scale, address, lanes, axis[k]);
  }
  if (level.tiled) make_tiles_readable(level, axis, linear, lanes);
  unit.kernel[linear ? 1 : 0](read, out);
  if (linear && unit.state.sampler.seamless && unit.state.target == TextureTarget::cube_map) {
    filter_across_seams(unit, at.face, index, at.coordinate[0], at.coordinate[1], lanes, out);
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

/// The level that a LOD selects (below it, for a linear filter between levels), relative to the base level.
HWY_INLINE float selected_level(MipFilter filter, float lod, float last) {
  // [GL1.5 §3.8.8 eq 3.23]: lambda + 1/2 rounded up, minus 1. [eq 3.24]: rounded down.
  const FloatTag d;
  const FloatVector v = hn::Set(d, lod);
  const FloatVector level = filter == MipFilter::nearest ? hn::Sub(hn::Ceil(hn::Add(v, hn::Set(d, 0.5f))), hn::Set(d, 1.0f)) : hn::Floor(v);
  return hn::GetLane(kept_between(level, 0.0f, last));
}

/// Lanes whose value equals.
HWY_INLINE std::uint64_t lanes_equal(const float* values, float value) {
  const FloatTag d;
  std::uint64_t lanes = 0;
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    lanes |= bits_of(d, hn::Eq(hn::Load(d, values + lane), hn::Set(d, value))) << lane;
  }
  return lanes;
}
HWY_INLINE std::uint64_t lanes_above_zero(const float* values) {
  const FloatTag d;
  std::uint64_t lanes = 0;
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    lanes |= bits_of(d, hn::Gt(hn::Load(d, values + lane), hn::Zero(d))) << lane;
  }
  return lanes;
}

/// Reads minified lanes: the levels that their LODs select, mixed if the filter is linear between levels.
HWY_INLINE void read_minified(const PreparedUnit& unit, const LaneCoordinates& at, float lowest, float highest, float* lod,
                              std::uint64_t lanes, bool keeps_others, TexelBlock& out) {
  const FloatTag d;
  const SamplerState& sampler = unit.state.sampler;
  const auto last = static_cast<float>(unit.level_count - 1);
  alignas(64) float levels[64];
  TexelBlock next;
  const float first_level = selected_level(sampler.mip, lowest, last), last_level = selected_level(sampler.mip, highest, last);
  const bool one_level = first_level == last_level;
  const bool mixes = sampler.mip == MipFilter::linear;

  // The level of each lane; its LOD becomes the share of the next level.
  for (std::size_t lane = 0; lane < 64 && (mixes || !one_level); lane += hn::Lanes(d)) {
    const FloatVector v = hn::Load(d, lod + lane);
    const FloatVector level = mixes ? hn::Floor(v) : hn::Sub(hn::Ceil(hn::Add(v, hn::Set(d, 0.5f))), hn::Set(d, 1.0f));
    const FloatVector kept = kept_between(level, first_level, last_level);
    hn::Store(kept, d, levels + lane);
    if (mixes) hn::Store(clamp_lanes(hn::Sub(v, kept), hn::Zero(d), hn::Set(d, 1.0f)), d, lod + lane);
  }
  for (std::uint64_t left = lanes; left != 0;) {
    const float level = one_level ? first_level : levels[hwy::Num0BitsBelowLS1Bit_Nonzero64(left)];
    const std::uint64_t group = one_level ? left : left & lanes_equal(levels, level);
    const bool part = keeps_others || group != lanes;
    const auto index = static_cast<std::int32_t>(level);
    read_level(unit, at, index, sampler.minify, group, part, out);
    if (mixes && index + 1 < unit.level_count) {
      read_level(unit, at, index + 1, sampler.minify, group, false, next);
      mix_levels(next, lod, group, out);
    }
    left &= ~group;
  }
}

/// Whether the level of detail makes no difference.
HWY_INLINE bool needs_no_lod(const SamplerState& sampler) {
  return sampler.mip == MipFilter::none && sampler.minify == sampler.magnify;
}

HWY_INLINE std::array<float, 3> base_size(const PreparedUnit& unit) {
  std::array<float, 3> size{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(unit.dimensions); ++k) {
    size[k] = unit.state.target == TextureTarget::rectangle ? 1.0f : static_cast<float>(unit.level(0, 0).size[k]);
  }
  return size;
}

/// One face: magnified and minified lanes.
HWY_INLINE void sample_face(const PreparedUnit& unit, const LaneCoordinates& at, const CoordinatePlanes& planes, std::uint64_t lanes,
                            bool keeps_others, TexelBlock& out) {
  const FloatTag d;
  const SamplerState& sampler = unit.state.sampler;
  const BlockLod lod(planes, base_size(unit));
  const auto adjusted = [&](FloatVector v) HWY_ATTR {
    return kept_between(hn::Add(v, hn::Set(d, sampler.lod_bias)), sampler.min_lod, sampler.max_lod);
  };
  const float lowest = hn::GetLane(adjusted(hn::Set(d, lod.lowest()))), highest = hn::GetLane(adjusted(hn::Set(d, lod.highest())));
  if (highest <= 0.0f) return read_level(unit, at, 0, sampler.magnify, lanes, keeps_others, out);
  if (sampler.mip == MipFilter::none && lowest > 0.0f) return read_level(unit, at, 0, sampler.minify, lanes, keeps_others, out);

  alignas(64) float lambda[64];
  lod.lanes(lambda);
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) hn::Store(adjusted(hn::Load(d, lambda + lane)), d, lambda + lane);
  const std::uint64_t minified = sampler.minify == sampler.magnify ? lanes : lanes & lanes_above_zero(lambda);
  if (minified != lanes) {
    read_level(unit, at, 0, sampler.magnify, lanes & ~minified, keeps_others, out);
    keeps_others = true;
  }
  if (minified == 0) return;
  if (sampler.mip == MipFilter::none) return read_level(unit, at, 0, sampler.minify, minified, keeps_others, out);
  read_minified(unit, at, lowest, highest, lambda, minified, keeps_others, out);
}

/// The coordinates of a unit, divided by q if it has one.
struct DividedCoordinates {
  alignas(64) float lanes[3][64];
  std::array<const float*, 3> coordinate{};

  HWY_INLINE DividedCoordinates(const FragmentBlock& block, const TextureCoordinateLayout& layout) {
    const FloatTag d;
    const auto first = static_cast<std::size_t>(layout.first), count = static_cast<std::size_t>(layout.dimensions);
    for (std::size_t k = 0; k < count; ++k) coordinate[k] = block.varying[first + k].data();
    if (!layout.has_q) return;
    for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
      const FloatVector q = hn::Load(d, block.varying[first + count].data() + lane);
      for (std::size_t k = 0; k < count; ++k) hn::Store(hn::Div(hn::Load(d, coordinate[k] + lane), q), d, lanes[k] + lane);
    }
    for (std::size_t k = 0; k < count; ++k) coordinate[k] = lanes[k];
  }
};

HWY_INLINE const TextureCoordinateLayout& layout_of(const FragmentBlock& block, const PreparedUnit& unit) {
  return block.primitive->binding->varyings.texture_coordinates[unit.state.unit];
}

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
  sample_face(unit, at, coordinate_planes(block, layout), block.coverage, false, out);
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

/// Which face each lane's direction hits. choice: where two are equally long, x before y before z, as Mesa.
HWY_INLINE void select_faces(const std::array<const float*, 3>& direction, std::array<std::uint64_t, 6>& lanes_of) {
  const FloatTag d;
  lanes_of = {};
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
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
  select_faces(direction, lanes_of);
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
    if (needs_no_lod(unit.state.sampler)) read_level(unit, at, 0, unit.state.sampler.minify, lanes, part, out);
    else sample_face(unit, at, on_face, lanes, part, out);
    keeps_others = true;
  }
}

SampleFunction select(const PreparedUnit& unit) {
  if (unit.state.target == TextureTarget::cube_map) return sample_cube_map;
  return needs_no_lod(unit.state.sampler) ? sample_base_level : sample_levels;
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
SampleFunction sample_function(const PreparedUnit& unit) { return GOURAUD_SIMD_PICK(select)(unit); }
}  // namespace gouraud::pipeline
#endif
