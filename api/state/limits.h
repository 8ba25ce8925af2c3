// Implementation limits: what the specification lets us choose [GL1.5 Tables 6.28 to 6.31]. Values as Mesa's, so that
// programs meet what they are used to (MESA-RULES 10).
#pragma once

#include "pipeline/draw/draw_state.h"

namespace gouraud::api {

inline constexpr int max_lights = pipeline::max_lights;
inline constexpr int max_clip_planes = pipeline::max_clip_planes;
inline constexpr int max_texture_units = pipeline::max_texture_units;
inline constexpr int max_modelview_stack_depth = 32;
inline constexpr int max_projection_stack_depth = 32;
inline constexpr int max_texture_stack_depth = 10;
inline constexpr int max_attrib_stack_depth = 16, max_client_attrib_stack_depth = 16;
/// Recommendations for DrawRangeElements; larger draws are as fast.
inline constexpr int max_elements_vertices = 3000, max_elements_indices = 3000;
inline constexpr int max_eval_order = 30;
inline constexpr int max_name_stack_depth = 64;
inline constexpr int max_list_nesting = 64;
inline constexpr int max_pixel_map_table = 256;
inline constexpr int max_texture_size = pipeline::max_texture_size;
inline constexpr int max_texture_3d_size = pipeline::max_texture_3d_size, max_texture_3d_levels = 12;
static_assert(1 << (max_texture_3d_levels - 1) == max_texture_3d_size);
inline constexpr float max_texture_lod_bias = 15.0f, max_texture_anisotropy = 16.0f;
/// The largest target and the largest viewport, in pixels a side.
inline constexpr int max_target_size_px = 16384;
/// choice: glViewport clamps x and y to these bounds, as Mesa does; the specification clamps only width and height.
inline constexpr int min_viewport_origin = -32768, max_viewport_origin = 32767;
inline constexpr int max_renderbuffer_size = max_target_size_px;
inline constexpr int max_color_attachments = 8;
inline constexpr int max_samples = pipeline::max_samples;
inline constexpr float min_point_size = 1.0f, max_point_size = 255.0f;
inline constexpr float min_line_width = 1.0f, max_line_width = 255.0f;
inline constexpr float point_size_granularity = 0.1f, line_width_granularity = 0.1f;
inline constexpr int subpixel_bits = 8;

}  // namespace gouraud::api
