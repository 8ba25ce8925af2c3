#include "api/snapshot/rasterization_snapshot.h"

#include <algorithm>
#include <cmath>

namespace gouraud::api {
namespace {

static_assert(max_point_size == pipeline::most_wide_px && max_line_width == pipeline::most_wide_px);

/// What is no number becomes 0, so that states compare.
float number_or_zero(float value) { return std::isnan(value) ? 0.0f : value; }

bool draws_faces(const pipeline::AssemblyState& assembly, pipeline::PolygonMode mode) {
  const bool front = assembly.cull == pipeline::CullMode::none || assembly.cull == pipeline::CullMode::back;
  const bool back = assembly.cull == pipeline::CullMode::none || assembly.cull == pipeline::CullMode::front;
  return (front && assembly.polygon_mode_front == mode) || (back && assembly.polygon_mode_back == mode);
}

}  // namespace

// [GL1.5 §3.3]: the size is first kept in [POINT_SIZE_MIN, POINT_SIZE_MAX], then in what is supported.
// choice: a smallest size above the largest wins.
pipeline::PointState point_state(const PointGroup& point, bool multisampled) {
  pipeline::PointState result;
  result.sprite = point.sprite_enabled;
  result.smooth = (point.smooth_enabled || multisampled) && !point.sprite_enabled;
  const auto supported = [](float size) { return std::clamp(size, min_point_size, max_point_size); };
  const float smallest = supported(point.smallest_px), largest = std::max(supported(point.largest_px), smallest);
  const float threshold = std::min(point.fade_threshold_px, max_point_size);
  result.attenuated = point.distance_attenuation != glm::vec3(1.0f, 0.0f, 0.0f);
  if (result.attenuated) {
    result.size_px = point.size_px;
    for (int i = 0; i < 3; ++i) result.attenuation[i] = number_or_zero(point.distance_attenuation[i]);
    result.smallest_px = smallest;
    result.largest_px = largest;
    if (multisampled && smallest < threshold) result.fade_threshold_px = threshold;
    return result;
  }
  result.size_px = std::clamp(point.size_px, smallest, largest);
  if (multisampled && result.size_px < threshold) result.fade_threshold_px = threshold;
  // Halves down, as Mesa does (MESA-RULES 5.4).
  if (!result.smooth && !result.sprite) result.size_px = std::max(std::ceil(result.size_px - 0.5f), 1.0f);
  return result;
}

// [GL1.5 §3.4.2]: the width of an aliased line is rounded to the nearest integer, halves up.
pipeline::LineState line_state(const LineGroup& line, bool multisampled) {
  pipeline::LineState result;
  result.smooth = line.smooth_enabled || multisampled;
  const float width = std::clamp(line.width_px, min_line_width, max_line_width);
  result.width_px = result.smooth ? width : std::floor(width + 0.5f);
  if (line.stipple_enabled && line.stipple_pattern != 0xFFFF) {
    result.stipple_pattern = line.stipple_pattern;
    // A pattern of all zeros has no phase.
    result.stipple_factor = line.stipple_pattern != 0 ? line.stipple_factor : 1;
  }
  return result;
}

pipeline::PolygonState polygon_state(const PolygonGroup& polygon, const pipeline::AssemblyState& assembly,
                                     bool depth_matters) {
  using pipeline::PolygonMode;
  pipeline::PolygonState result;
  result.smooth = polygon.smooth_enabled && draws_faces(assembly, PolygonMode::fill);
  const float factor = number_or_zero(polygon.offset_factor), units = number_or_zero(polygon.offset_units);
  const float bias = number_or_zero(polygon.offset_bias);
  if (!depth_matters || (factor == 0.0f && units == 0.0f && bias == 0.0f)) return result;
  result.offset_fill = polygon.offset_fill_enabled && draws_faces(assembly, PolygonMode::fill);
  result.offset_line = polygon.offset_line_enabled && draws_faces(assembly, PolygonMode::line);
  result.offset_point = polygon.offset_point_enabled && draws_faces(assembly, PolygonMode::point);
  if (result.offset_fill || result.offset_line || result.offset_point) {
    result.offset_factor = factor;
    result.offset_units = units;
    result.offset_bias = bias;
  }
  return result;
}

pipeline::PolygonStippleState polygon_stipple_state(const PolygonGroup& polygon, const PolygonStippleGroup& pattern) {
  if (!polygon.stipple_enabled || pattern == PolygonStippleGroup{}) return {};
  return {true, pattern.rows};
}

}  // namespace gouraud::api
