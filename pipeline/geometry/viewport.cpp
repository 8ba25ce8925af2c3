// Takes clip-space positions, gives outcodes [GL1.5 §2.12] and window positions [GL1.5 §2.11, §2.11.1].
//
// Window y is counted from the top, as Mesa does it, so that its float rounding is Mesa's (MESA-RULES 2.3).
#include "pipeline/geometry/viewport.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/geometry/viewport.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void project(const ViewportTransform& viewport, ProcessedVertices& vertices) {
  const hn::CappedTag<float, 16> d;
  const hn::RebindToSigned<decltype(d)> di;
  const hn::Rebind<std::uint16_t, decltype(d)> d16;
  const auto count = static_cast<std::size_t>(vertices.count);
  const auto& clip = vertices.position_clip;
  const auto near_plane_w = hn::Set(d, vertices.near_plane_w);
  const auto flag = [&](auto mask, Outcode bit) HWY_ATTR {
    return hn::BitCast(di, hn::IfThenElseZero(mask, hn::BitCast(d, hn::Set(di, bit))));
  };
  const auto is_finite = [&](auto v)
                             HWY_ATTR { return hn::Le(hn::Abs(v), hn::Set(d, std::numeric_limits<float>::max())); };
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto x = hn::Load(d, &clip[0][i]), y = hn::Load(d, &clip[1][i]), z = hn::Load(d, &clip[2][i]),
               w = hn::Load(d, &clip[3][i]);
    const auto minus_w = hn::Neg(w);
    const auto across = hn::Or(flag(hn::Gt(x, w), outside_right), flag(hn::Lt(x, minus_w), outside_left));
    const auto upright = hn::Or(flag(hn::Gt(y, w), outside_top), flag(hn::Lt(y, minus_w), outside_bottom));
    const auto deep = hn::Or(flag(hn::Lt(z, hn::Mul(minus_w, near_plane_w)), outside_near), flag(hn::Gt(z, w), outside_far));
    const auto planes = hn::Or(hn::Or(across, upright), deep);

    // Inside all planes a coordinate is no larger than w: where 1 / w is finite, so is the window position.
    const auto w_inverse = hn::Div(hn::Set(d, 1.0f), w);
    const auto finite = hn::And(hn::And(is_finite(x), is_finite(y)), hn::And(is_finite(z), is_finite(w)));
    const auto inside = hn::RebindMask(d, hn::Eq(planes, hn::Zero(di)));
    const auto invalid = hn::Or(hn::Not(finite), hn::And(inside, hn::Not(is_finite(w_inverse))));
    hn::Store(hn::DemoteTo(d16, hn::Or(planes, flag(invalid, outside_invalid))), d16, &vertices.outcode[i]);

    const auto to_window = [&](auto coordinate, std::size_t k) HWY_ATTR {
      return hn::Add(hn::Mul(hn::Mul(coordinate, w_inverse), hn::Set(d, viewport.scale[k])),
                     hn::Set(d, viewport.translation[k]));
    };
    hn::StoreInterleaved4(to_window(x, 0), to_window(y, 1), to_window(z, 2), w_inverse, d, &vertices.window[i].x);
  }
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {

ViewportTransform make_viewport_transform(const ViewportState& state) {
  const float half_width = static_cast<float>(state.width_px) * 0.5f,
              half_height = static_cast<float>(state.height_px) * 0.5f;
  const double near = state.depth_near, far = state.depth_far;
  const float center_x = half_width + static_cast<float>(state.x);
  const float center_y = static_cast<float>(state.target_height_px) - (half_height + static_cast<float>(state.y));
  return {{half_width, state.upper_left ? half_height : -half_height,
           static_cast<float>(state.zero_to_one ? far - near : (far - near) * 0.5)},
          {center_x + state.sample_shift_x, center_y - state.sample_shift_y,
           static_cast<float>(state.zero_to_one ? near : (far + near) * 0.5)}};
}

void project_to_window(const ViewportState& state, ProcessedVertices& vertices) {
  vertices.near_plane_w = state.zero_to_one ? 0.0f : 1.0f;
  GOURAUD_SIMD_PICK(project)(make_viewport_transform(state), vertices);
}

bool project_vertex(const ViewportState& state, ProcessedVertices& vertices, std::int32_t index) {
  const ViewportTransform viewport = make_viewport_transform(state);
  const auto i = static_cast<std::size_t>(index);
  const auto& clip = vertices.position_clip;
  const float w_inverse = 1.0f / clip[3][i];
  const auto to_window = [&](std::size_t k) {
    return (clip[k][i] * w_inverse) * viewport.scale[k] + viewport.translation[k];
  };
  // A vertex on the clip volume's surface lies in the viewport; where coordinates were too large for the clipper's
  // floats, rounding may have thrown it anywhere. One pixel beyond is rounding that Mesa has too.
  const auto near_viewport = [&](float position, std::size_t k) {
    const float reach = std::abs(viewport.scale[k]) + 1.0f;
    return std::clamp(position, viewport.translation[k] - reach, viewport.translation[k] + reach);
  };
  WindowVertex window{to_window(0), to_window(1), to_window(2), w_inverse};
  const bool finite =
      std::isfinite(window.x) && std::isfinite(window.y_raster) && std::isfinite(window.z) && std::isfinite(w_inverse);
  if (finite)
    window = {near_viewport(window.x, 0), near_viewport(window.y_raster, 1), near_viewport(window.z, 2), w_inverse};
  vertices.window[i] = window;
  vertices.outcode[i] = finite ? 0 : outside_invalid;
  return finite;
}

glm::vec3 window_position(const ViewportState& state, const ProcessedVertices& vertices, std::int32_t index) {
  const auto i = static_cast<std::size_t>(index);
  const double w = vertices.position_clip[3][i];
  const auto ndc = [&](std::size_t k) { return static_cast<double>(vertices.position_clip[k][i]) / w; };
  const double x = state.x + (ndc(0) + 1.0) * 0.5 * state.width_px;
  const double y = state.y + ((state.upper_left ? -ndc(1) : ndc(1)) + 1.0) * 0.5 * state.height_px;
  const double near = state.depth_near, far = state.depth_far;
  const double z = std::clamp(near + (state.zero_to_one ? ndc(2) : (ndc(2) + 1.0) * 0.5) * (far - near), std::min(near, far), std::max(near, far));
  return glm::vec3(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
}

}  // namespace gouraud::pipeline
#endif
