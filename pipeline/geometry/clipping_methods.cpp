#include "pipeline/geometry/clipping_methods.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "pipeline/geometry/viewport.h"

namespace gouraud::pipeline {

bool fits_guard_band(const ViewportState& viewport, const ProcessedVertices& vertices, const AssembledTriangle& triangle) {
  constexpr unsigned sides = outside_right | outside_left | outside_top | outside_bottom;
  const ViewportTransform transform = make_viewport_transform(viewport);
  return std::all_of(triangle.vertex.begin(), triangle.vertex.end(), [&](std::uint16_t index) {
    if ((vertices.outcode[index] & ~sides) != 0) return false;
    const WindowVertex& window = vertices.window[index];
    const bool in_front = vertices.position_clip[3][index] > 0 && std::isfinite(window.w_inverse);
    return in_front && std::abs(window.x - transform.translation[0]) < guard_band_px &&
           std::abs(window.y_raster - transform.translation[1]) < guard_band_px;
  });
}

bool force_into_window(const ViewportState& viewport, const AssembledTriangle& triangle, ProcessedVertices& vertices) {
  const ViewportTransform transform = make_viewport_transform(viewport);
  for (const std::uint16_t index : triangle.vertex) {
    if ((vertices.outcode[index] & outside_invalid) != 0) return false;
    WindowVertex& window = vertices.window[index];
    if (std::isnan(window.x) || std::isnan(window.y_raster) || std::isnan(window.z)) return false;
    const auto within = [&](float position, std::size_t k) {
      return std::clamp(position, transform.translation[k] - guard_band_px, transform.translation[k] + guard_band_px);
    };
    window.x = within(window.x, 0);
    window.y_raster = within(window.y_raster, 1);
    window.z = std::clamp(window.z, 0.0f, 1.0f);
    constexpr float least = 1e-6f, most = 1e6f;  // of 1/w, so that planes are finite
    window.w_inverse = std::clamp(std::abs(window.w_inverse), least, most);
  }
  return true;
}

}  // namespace gouraud::pipeline
