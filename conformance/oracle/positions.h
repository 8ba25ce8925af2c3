// Takes object positions, gives clip and window positions [GL1.5 §2.11, §2.11.1].
// In float each product and sum is rounded by itself, in the order that MESA-RULES 2.2-2.3 prescribes; in double the
// same formulas give the true positions. Window y is computed from the top of the target, as the pipeline and Mesa do,
// so that snapping rounds the same way.
#pragma once

#include <array>
#include <optional>

#include "conformance/oracle/vertex.h"
#include "pipeline/draw/draw_state.h"

namespace gouraud::oracle {

/// Bits of the sub-pixel grid that positions of this type are snapped to.
template <typename T>
inline constexpr int subpixel_bits = 0;
template <>
inline constexpr int subpixel_bits<float> = 8;
template <>
inline constexpr int subpixel_bits<double> = 30;

/// projection * modelview, entry [column][row]; in float the state's own product.
template <typename T>
std::array<std::array<T, 4>, 4> combined_matrix(const pipeline::TransformState& transform);

template <typename T>
std::array<std::array<T, 4>, 4> modelview_matrix(const pipeline::TransformState& transform);

/// With the modelview matrix: to eye space.
template <typename T>
std::array<T, 4> to_clip_space(const std::array<std::array<T, 4>, 4>& matrix,
                               const std::array<float, 4>& position_object);

/// Empty if a coordinate is not finite (w = 0).
template <typename T>
std::optional<WindowVertex> to_window_space(const ClipVertex<T>& vertex, const pipeline::ViewportState& viewport);

}  // namespace gouraud::oracle
