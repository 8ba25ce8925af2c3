// Takes a block and its primitive's planes of colour and fog coordinate, gives pixels: interpolation [GL1.5 §3.5.1 eq 3.6], fog
// [GL1.5 §3.10] and write in one pass, for 8-bit targets all of whose channels are written.
//
// A lit body in fog is seen in perspective, its alpha varies seldom, and where no light falls all of its colour is the same: then all
// happens in registers, and colours and fog coordinate share a division. The others have their fog coordinate in the block
// first, as the passes apart would.
#include <cstddef>
#include <cstdint>

#include "pipeline/fragment/color_write.h"
#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/fogged_color_write.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/fragment/fog-inl.h"
#include "pipeline/fragment/pixel_words-inl.h"
#include "pipeline/fragment/shading-inl.h"
#include "pipeline/fragment/varyings-inl.h"
#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

inline constexpr float byte_scale = 255.0f;

/// Takes shaded lanes through fog to their pixels. The block has its fog coordinate.
template <class Mode>
struct FoggedSink {
  Unorm8Writer<true> writer;
  FogBlend<Mode> fog;
  const float* coordinate;
  HWY_INLINE FoggedSink(FragmentBlock& block, const TileTarget& target)
      : writer(target, block.first_pixel, 0xF), fog(block.primitive->binding->state.fog, byte_scale),
        coordinate(block.varying[fog_coordinate(block)].data()) {}
  HWY_INLINE void write(FloatVector r, FloatVector g, FloatVector b, FloatVector a, std::uint64_t covered,
                        std::size_t lane) const {
    fog.blend(hn::Load(FloatTag(), coordinate + lane), r, g, b);
    writer.put_some(pack_unorm8(r, g, b, a), covered, lane);
  }
};

/// A plane, and its value in a vector of lanes as it goes from row pair to row pair.
struct PlaneWalk {
  FloatVector value, step;
  HWY_INLINE void advance() { value = hn::Add(value, step); }
};

/// R, G and B of a primitive whose alpha is the same all over, in a vector of lanes; in perspective.
template <bool clamp>
class VaryingBody {
 public:
  HWY_INLINE VaryingBody(const FragmentBlock& block, const ColorRecord& color, std::size_t offset) : color_(color) {
    const BlockColor planes(color, block.x, block.y);
    const auto walk = [&](std::size_t k) HWY_ATTR { return PlaneWalk{first_pair(planes.plane(k), offset), pair_step(planes.plane(k))}; };
    red_ = walk(0);
    green_ = walk(1);
    blue_ = walk(2);
  }
  HWY_INLINE FloatVector r(FloatVector w) const { return channel(red_, w, 0); }
  HWY_INLINE FloatVector g(FloatVector w) const { return channel(green_, w, 1); }
  HWY_INLINE FloatVector b(FloatVector w) const { return channel(blue_, w, 2); }
  HWY_INLINE void advance() {
    red_.advance();
    green_.advance();
    blue_.advance();
  }

 private:
  HWY_INLINE FloatVector channel(const PlaneWalk& plane, FloatVector w, std::size_t k) const {
    const FloatTag d;
    const FloatVector value = hn::Add(hn::Mul(plane.value, w), hn::Set(d, color_.base[k]));
    return clamp ? clamp_lanes(value, hn::Set(d, color_.minimum[k]), hn::Set(d, color_.maximum[k])) : value;
  }
  const ColorRecord& color_;
  PlaneWalk red_, green_, blue_;
};

/// The same of one whose colour is the same all over.
class ConstantBody {
 public:
  HWY_INLINE ConstantBody(const FragmentBlock&, const ColorRecord& color, std::size_t) : color_(color) {}
  HWY_INLINE FloatVector r(FloatVector) const { return hn::Set(FloatTag(), color_.base[0]); }
  HWY_INLINE FloatVector g(FloatVector) const { return hn::Set(FloatTag(), color_.base[1]); }
  HWY_INLINE FloatVector b(FloatVector) const { return hn::Set(FloatTag(), color_.base[2]); }
  HWY_INLINE void advance() {}

 private:
  const ColorRecord& color_;
};

/// `clamp_w`: 1/w may leave the range of the vertices by more than rounding forgives.
template <class Mode, class Body, bool clamp_w>
HWY_INLINE void write_body(const FragmentBlock& block, const VaryingRecord& varyings, const VaryingPlane& coordinate, const TileTarget& target) {
  const FloatTag d;
  const ColorRecord& color = color_of(*block.primitive);
  const Unorm8Writer<true> writer(target, block.first_pixel, 0xF);
  const FogBlend<Mode> fog(block.primitive->binding->state.fog, byte_scale);
  const NearCorner corner(varyings, block);
  const BlockPlane fog_plane = corner.plane(coordinate);
  const IntVector alpha = pack_alpha8(hn::Set(d, color.base[3]));
  const PairRange pairs = covered_pairs(block.coverage);
  for (std::size_t offset = 0; offset < pair_lanes; offset += hn::Lanes(d)) {
    Body body(block, color, offset);
    PlaneWalk inverse_w{corner.first(corner.inverse_w, offset), pair_step(corner.inverse_w)};
    PlaneWalk distance{corner.first(fog_plane, offset), pair_step(fog_plane)};
    const auto advance = [&]() HWY_ATTR {
      body.advance();
      inverse_w.advance();
      distance.advance();
    };
    for (std::size_t pair = 0; pair < pairs.first; ++pair) advance();
    for (std::size_t pair = pairs.first; pair < pairs.end; ++pair, advance()) {
      const std::size_t lane = pair * pair_lanes + offset;
      const FloatVector w = corner.w_at<clamp_w>(inverse_w.value);
      FloatVector c = hn::Add(hn::Set(d, fog_plane.base), hn::Mul(distance.value, w));
      c = clamp_lanes(c, hn::Set(d, coordinate.minimum), hn::Set(d, coordinate.maximum));
      FloatVector r = body.r(w), g = body.g(w), b = body.b(w);
      fog.blend(c, r, g, b);
      writer.put_some(hn::Or(pack_rgb8(r, g, b), alpha), lane_bits(block.coverage, lane), lane);
    }
  }
}

template <class Mode>
void write_in_fog(FragmentBlock& block, const TileTarget& target) {
  const ColorRecord& color = color_of(*block.primitive);
  const VaryingRecord& varyings = varyings_of(*block.primitive);
  const std::size_t k = fog_coordinate(block);
  const VaryingPlane& coordinate = planes_of(varyings)[k];
  const bool distance_varies = varyings.perspective && (varyings.constant >> k & 1) == 0;
  if (distance_varies && color.variation == ColorVariation::constant) {
    return write_body<Mode, ConstantBody, true>(block, varyings, coordinate, target);
  }
  const bool same_alpha = color.origin[3] == 0 && color.dx[3] == 0 && color.dy[3] == 0;
  if (distance_varies && color.variation == ColorVariation::perspective && same_alpha) {
    return color.clamp ? write_body<Mode, VaryingBody<true>, true>(block, varyings, coordinate, target)
                       : write_body<Mode, VaryingBody<false>, false>(block, varyings, coordinate, target);
  }
  interpolate(block, covered_pairs(block.coverage));
  shade<FoggedSink<Mode>>(block, target);
}

FragmentPass select_fogged(FogMode mode) {
  switch (mode) {
    case FogMode::linear: return write_in_fog<LinearFog>;
    case FogMode::exp2: return write_in_fog<Exp2Fog>;
    case FogMode::exp:
    case FogMode::none: break;
  }
  return write_in_fog<ExpFog>;
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
FragmentPass fogged_color_write_pass(FogMode mode) { return GOURAUD_SIMD_PICK(select_fogged)(mode); }
}  // namespace gouraud::pipeline
#endif
