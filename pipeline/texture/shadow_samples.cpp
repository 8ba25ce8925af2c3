// Takes a block with its varyings, gives 1 where its r passes the comparison with a depth texture's nearest texel, else 0, as
// the texture's mode has it [GL1.5 §3.8.14]. Leaves out filters, levels, borders and repeated coordinates (sampling.cpp).
//
// A shadow map is larger than the caches, and each fragment reads a texel of its own: a block waits for memory far longer than
// it computes. So the texels are asked for before the other units are sampled (fetch), and only those of covered lanes. It
// pays: the light with shadows in conformance/speed's mirror takes 19 ms in place of 27.
#include "pipeline/texture/shadow_samples.h"

#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/texture/shadow_samples.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/texture/levels-inl.h"
#include "pipeline/texture/texels-inl.h"
#include "pipeline/texture/tiles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// Where the lanes' texels lie; lanes that are not covered share the first covered one's.
class NearestTexels {
 public:
  HWY_INLINE NearestTexels(const FragmentBlock& block, const PreparedUnit& unit)
      : coordinates_(block, layout_of(block, unit)), level_(unit.level(0, 0)), x_(address_of(level_, 0, false)), y_(address_of(level_, 1, false)) {}

  HWY_INLINE IntVector offset(std::size_t lane, std::uint64_t wanted) const {
    const IntTag d;
    const auto place = [&](std::size_t k, const AxisAddress& axis) HWY_ATTR {
      const auto size = static_cast<float>(axis.size);
      const FloatVector u = hn::Mul(hn::Load(FloatTag(), coordinates_.coordinate[k] + lane), hn::Set(FloatTag(), size));
      return axis(hn::ConvertTo(d, kept_between(u, 0.0f, size - 0.5f)));
    };
    const IntVector offset = hn::Add(place(0, x_), place(1, y_));
    if (all_lanes(wanted)) return offset;
    alignas(64) std::int32_t lanes[pair_lanes];
    hn::Store(offset, d, lanes);
    return hn::IfThenElse(mask_of(d, wanted), offset, hn::Set(d, lanes[hwy::Num0BitsBelowLS1Bit_Nonzero64(wanted)]));
  }
  HWY_INLINE FloatVector r(std::size_t lane) const {
    return clamp_to_unit(FloatTag(), hn::Load(FloatTag(), coordinates_.coordinate[2] + lane));
  }
  const PreparedLevel& level() const { return level_; }

 private:
  DividedCoordinates coordinates_;
  const PreparedLevel& level_;
  AxisAddress x_, y_;
};

void fetch(const FragmentBlock& block, const PreparedUnit& unit) {
  const IntTag d;
  const NearestTexels texels(block, unit);
  const std::int32_t bytes = bytes_per_texel(unit.format);
  alignas(64) std::int32_t offsets[pair_lanes];
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    std::uint64_t wanted = lane_bits(block.coverage, lane);
    if (wanted == 0) continue;
    hn::Store(texels.offset(lane, wanted), d, offsets);
    for (; wanted != 0; wanted &= wanted - 1) {
      __builtin_prefetch(texels.level().texels + std::ptrdiff_t{offsets[hwy::Num0BitsBelowLS1Bit_Nonzero64(wanted)]} * bytes);
    }
  }
}

/// `func` says which outcomes pass: 1 less, 2 equal, 4 greater.
template <class Format>
void sample(const FragmentBlock& block, const PreparedUnit& unit, TexelBlock& out) {
  const FloatTag d;
  static_assert(static_cast<int>(CompareFunc::lequal) == 3 && static_cast<int>(CompareFunc::greater) == 4 &&
                static_cast<int>(CompareFunc::notequal) == 5 && static_cast<int>(CompareFunc::always) == 7);
  const std::uint8_t func = unit.state.sampler.compare_func;
  const auto one_if = [&](int bit) HWY_ATTR { return hn::Set(d, (func & bit) != 0 ? 1.0f : 0.0f); };
  const FloatVector if_less = one_if(1), if_equal = one_if(2), if_greater = one_if(4);
  const NearestTexels texels(block, unit);
  const PreparedLevel& level = texels.level();
  std::int32_t last_tile = -1;
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    const std::uint64_t wanted = lane_bits(block.coverage, lane);
    if (wanted == 0) continue;
    const IntVector offset = texels.offset(lane, wanted);
    if (level.tiled) make_tiles_readable(*level.image->tiles, offset, wanted, last_tile);
    const FloatVector depth = Format::value(level.texels, offset), r = texels.r(lane);
    const FloatVector result = hn::IfThenElse(hn::Lt(r, depth), if_less, hn::IfThenElse(hn::Eq(r, depth), if_equal, if_greater));
    const TexelVector texel = spread(result, unit.base_format);
    for (std::size_t k = 0; k < 4; ++k) hn::Store(texel.channel[k], d, out.channel[k].data() + lane);
  }
}

ShadowFunctions select(TexelFormat format) {
  switch (format) {
    case TexelFormat::z16: return {sample<R16>, fetch};
    case TexelFormat::z24s8: return {sample<Z24S8>, fetch};
    case TexelFormat::z32f: return {sample<Z32F>, fetch};
    default: break;
  }
  return {};
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {

ShadowFunctions shadow_functions(const PreparedUnit& unit) {
  const SamplerState& sampler = unit.state.sampler;
  const PreparedLevel& level = unit.levels[0];
  const bool one_level = sampler.mip == MipFilter::none && sampler.minify == TexelFilter::nearest && sampler.magnify == TexelFilter::nearest;
  if (unit.state.target != TextureTarget::two_d || !sampler.compares || !one_level || sampler.max_anisotropy > 1) return {};
  for (std::size_t k = 0; k < 2; ++k) {
    if (level.border[k] != 0 || sampler.wrap[k] != WrapMode::clamp_to_edge || sampler.mirrored_once[k]) return {};
  }
  return GOURAUD_SIMD_PICK(select)(unit.format);
}

}  // namespace gouraud::pipeline
#endif
