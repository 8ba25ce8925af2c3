#include "conformance/oracle/positions.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace gouraud::oracle {

template <typename T>
std::array<std::array<T, 4>, 4> combined_matrix(const pipeline::TransformState& transform) {
  std::array<std::array<T, 4>, 4> out{};
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      T& element = out[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)];
      if constexpr (std::is_same_v<T, float>) {
        element = transform.modelview_projection[column][row];
      } else {
        for (int k = 0; k < 4; ++k) {
          element += static_cast<T>(transform.projection[k][row]) * static_cast<T>(transform.modelview[column][k]);
        }
      }
    }
  }
  return out;
}

template <typename T>
std::array<std::array<T, 4>, 4> modelview_matrix(const pipeline::TransformState& transform) {
  std::array<std::array<T, 4>, 4> out{};
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      out[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)] = static_cast<T>(transform.modelview[column][row]);
    }
  }
  return out;
}

template <typename T>
std::array<T, 4> to_clip_space(const std::array<std::array<T, 4>, 4>& matrix,
                               const std::array<float, 4>& position_object) {
  std::array<T, 4> clip{};
  for (std::size_t row = 0; row < 4; ++row) {
    const T x = position_object[0] * matrix[0][row];
    const T y = position_object[1] * matrix[1][row];
    const T z = position_object[2] * matrix[2][row];
    const T w = position_object[3] * matrix[3][row];
    clip[row] = ((x + y) + z) + w;
  }
  return clip;
}

template <typename T>
std::optional<WindowVertex> to_window_space(const ClipVertex<T>& vertex, const pipeline::ViewportState& viewport) {
  const T half = static_cast<T>(0.5);
  const T half_width = static_cast<T>(viewport.width_px) * half,
          half_height = static_cast<T>(viewport.height_px) * half;
  // [ARB_clip_control]: z may run from 0, and y downwards.
  const double depth_range = viewport.depth_far - viewport.depth_near;
  const T scale_z = static_cast<T>(viewport.zero_to_one ? depth_range : depth_range * 0.5);
  const T center_z = static_cast<T>(viewport.zero_to_one ? viewport.depth_near : (viewport.depth_far + viewport.depth_near) * 0.5);
  const T scale_y_from_top = viewport.upper_left ? half_height : -half_height;
  const T center_x = half_width + static_cast<T>(viewport.x);
  const T center_y_from_top = static_cast<T>(viewport.target_height_px) - (half_height + static_cast<T>(viewport.y));

  const T w_inverse = static_cast<T>(1) / vertex.position[3];
  const T x = (vertex.position[0] * w_inverse) * half_width + center_x;
  const T y_from_top = (vertex.position[1] * w_inverse) * scale_y_from_top + center_y_from_top;
  const T z = (vertex.position[2] * w_inverse) * scale_z + center_z;
  if (!std::isfinite(x) || !std::isfinite(y_from_top) || !std::isfinite(z) || !std::isfinite(w_inverse)) return {};

  // Snap: nearest, ties to even, seen from the top (MESA-RULES 3).
  const T subpixels = static_cast<T>(std::int64_t{1} << subpixel_bits<T>);
  const auto snapped = [&](T coordinate) -> std::int64_t {
    constexpr std::int64_t far_away = std::int64_t{1} << 60;  // of bad input; what is no number as well
    const T value = (coordinate - half) * subpixels;
    return std::abs(value) < static_cast<T>(far_away) ? std::llrint(value) : value > 0 ? far_away : -far_away;
  };
  const std::int64_t snapped_x = snapped(x), snapped_y_from_top = snapped(y_from_top);
  const std::int64_t top_row_center = (static_cast<std::int64_t>(viewport.target_height_px) - 1) << subpixel_bits<T>;

  WindowVertex out;
  out.x = x;
  out.y = static_cast<double>(viewport.target_height_px) - static_cast<double>(y_from_top);
  out.z = std::clamp<double>(z, 0.0, 1.0);  // a vertex on the near or far plane may be rounded beyond it
  out.w_inverse = w_inverse;
  out.snapped = {snapped_x, top_row_center - snapped_y_from_top};
  out.colors = vertex.colors;
  return out;
}

template std::array<std::array<float, 4>, 4> combined_matrix(const pipeline::TransformState&);
template std::array<std::array<double, 4>, 4> combined_matrix(const pipeline::TransformState&);
template std::array<std::array<float, 4>, 4> modelview_matrix(const pipeline::TransformState&);
template std::array<std::array<double, 4>, 4> modelview_matrix(const pipeline::TransformState&);
template std::array<float, 4> to_clip_space(const std::array<std::array<float, 4>, 4>&, const std::array<float, 4>&);
template std::array<double, 4> to_clip_space(const std::array<std::array<double, 4>, 4>&, const std::array<float, 4>&);
template std::optional<WindowVertex> to_window_space(const ClipVertex<float>&, const pipeline::ViewportState&);
template std::optional<WindowVertex> to_window_space(const ClipVertex<double>&, const pipeline::ViewportState&);

}  // namespace gouraud::oracle
