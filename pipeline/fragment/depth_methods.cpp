// Takes a block and its primitive's depth plane, gives the block without the fragments that fail.
//
// w, w16: the distance from the eye, in equal steps from the near plane to the far one, of 24 or 16 bits. As fine far away as near by,
// where z has most of its steps; but it is not linear in the window, so that each pixel takes a division, and what two edges share
// they share only to within rounding. Very near surfaces, and large far / near with few bits, are where it is the worse one. An
// orthographic projection has z for distance.
// Stored depths are those of the method: ReadPixels gives them as they are. All in double, one lane after the other: to be seen, not
// to be fast.
// Source: J. Blinn, "W pleasure, W fun", 1998; K. Akeley, J. Su, "Minimum triangle separation for correct z-buffer occlusion", 2006.
#include "pipeline/fragment/depth_methods.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {
namespace {

/// A depth in [0, 1], in as many steps as the method has.
double method_depth(const MethodState& state, double z) {
  const auto in_steps = [](double value, double steps) { return std::nearbyint(std::clamp(value, 0.0, 1.0) * steps) / steps; };
  constexpr double steps16 = 0xFFFF, steps24 = 0xFFFFFF;
  const MethodState::Distance& d = state.distance;
  const double steps = state.methods.depth == DepthMethod::w16 ? steps16 : steps24;
  if (d.numerator == 0) return in_steps(z, steps);
  return in_steps((d.numerator / (z * d.scale + d.offset) - d.w_near) / (d.w_far - d.w_near), steps);
}

bool passes(CompareFunc func, double z, double stored) {
  switch (func) {
    case CompareFunc::never: return false;
    case CompareFunc::less: return z < stored;
    case CompareFunc::equal: return z == stored;
    case CompareFunc::lequal: return z <= stored;
    case CompareFunc::greater: return z > stored;
    case CompareFunc::notequal: return z != stored;
    case CompareFunc::gequal: return z >= stored;
    case CompareFunc::always: break;
  }
  return true;
}

/// Depths as the formats store them: as numbers that can be compared.
struct StoredZ16 {
  static constexpr double scale = 0xFFFF;
  using Word = std::uint16_t;
  static double depth(Word word) { return word; }
  static Word merge(Word, double z) { return static_cast<Word>(z); }
};
struct StoredZ24 {
  static constexpr double scale = 0xFFFFFF;
  using Word = std::uint32_t;
  static double depth(Word word) { return word & 0xFFFFFFu; }
  static Word merge(Word word, double z) { return (word & 0xFF000000u) | static_cast<Word>(z); }
};
struct StoredFloat {
  static constexpr double scale = 0;  ///< not rounded to integers
  using Word = float;
  static double depth(Word word) { return static_cast<double>(word); }
  static Word merge(Word, double z) { return static_cast<Word>(z); }
};

template <class Stored>
void test_depth(FragmentBlock& block, const TileTarget& target) {
  const RasterBinding& binding = *block.primitive->binding;
  const DepthPlane& plane = block.primitive->depth;
  const double units = Stored::scale != 0 ? Stored::scale : 1.0;
  auto* words = reinterpret_cast<typename Stored::Word*>(target.depth) + block.first_pixel;
  for (std::uint64_t left = block.coverage; left != 0; left &= left - 1) {
    const int lane = __builtin_ctzll(left);
    const double at_lane = (plane.origin + plane.dx * (block.x + lane % 8)) + plane.dy * (block.y + lane / 8);
    const double z = std::clamp<double>(at_lane, plane.minimum, plane.maximum) / units;
    const double value = method_depth(*binding.method, z);
    const double stored = Stored::scale != 0 ? std::nearbyint(value * units) : static_cast<double>(static_cast<float>(value));
    if (!passes(binding.state.depth.func, stored, Stored::depth(words[lane]))) {
      block.coverage &= ~(std::uint64_t{1} << lane);
    } else if (binding.state.depth.write_enabled) {
      words[lane] = Stored::merge(words[lane], stored);
    }
  }
}

}  // namespace

FragmentPass depth_method_pass(CompareFunc, DepthFormat format) {
  switch (format) {
    case DepthFormat::z16: return test_depth<StoredZ16>;
    case DepthFormat::z32f: return test_depth<StoredFloat>;
    case DepthFormat::z24s8:
    case DepthFormat::z32:  // another method's
    case DepthFormat::none: break;
  }
  return test_depth<StoredZ24>;
}

// A projection's third row is (0, 0, A, B) and its fourth (0, 0, -1, 0): z_ndc = -A + B / w.
MethodState::Distance distance_of_depth(const TransformState& transform, const ViewportState& viewport) {
  MethodState::Distance result;
  const double a = transform.projection[2][2], b = transform.projection[3][2];
  const double range = viewport.depth_far - viewport.depth_near;
  const bool projects = transform.projection[2][3] == -1.0f && transform.projection[3][3] == 0.0f;
  const double low = viewport.zero_to_one ? 0.0 : -1.0;
  const double near = b / (low + a), far = b / (1.0 + a);
  if (!projects || range == 0 || !(near > 0 && far > near) || !std::isfinite(far)) return result;
  result.numerator = b;
  result.scale = (1.0 - low) / range;
  result.offset = low - viewport.depth_near * result.scale + a;
  result.w_near = near;
  result.w_far = far;
  return result;
}

}  // namespace gouraud::pipeline
