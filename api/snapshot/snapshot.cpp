#include "api/snapshot/snapshot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "api/snapshot/blend_snapshot.h"
#include "api/snapshot/enums.h"
#include "api/snapshot/lighting_snapshot.h"
#include "api/snapshot/varying_snapshot.h"
#include "api/snapshot/rasterization_snapshot.h"
#include "api/snapshot/texture_snapshot.h"
#include "api/snapshot/stencil_snapshot.h"
#include "api/state/matrix.h"

namespace gouraud::api {
namespace {

// x + width may exceed 32 bits; the target's sides do not.
std::int32_t clamp_edge(std::int64_t edge, std::int32_t side) {
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(edge, 0, side));
}

// The pixels that may be written: scissor box, if enabled, and target, intersected [GL1.5 §4.1.2].
pipeline::PixelRect writable_rect(const ScissorGroup& scissor, const TargetInfo& target) {
  const pipeline::PixelRect all{0, 0, target.width_px, target.height_px};
  if (!scissor.enabled) return all;
  const std::int64_t x = scissor.x, y = scissor.y;
  const pipeline::PixelRect box{clamp_edge(x, all.x1), clamp_edge(y, all.y1), clamp_edge(x + scissor.width_px, all.x1),
                                clamp_edge(y + scissor.height_px, all.y1)};
  return box.empty() ? pipeline::PixelRect{} : box;
}

std::uint8_t color_write_mask(const ColorBufferGroup& group, const TargetInfo& target) {
  if (target.format.color == pipeline::ColorFormat::none) return 0;
  const auto& enabled = group.write_enabled;
  const auto mask = static_cast<std::uint8_t>(enabled[0] | enabled[1] << 1 | enabled[2] << 2 | enabled[3] << 3);
  return mask & target.color_channels;
}

pipeline::DepthState depth_state(const DepthGroup& group, const TargetInfo& target) {
  const pipeline::CompareFunc func = compare_func(group.func);
  const bool exists = group.test_enabled && target.has_depth && target.format.depth != pipeline::DepthFormat::none;
  if (!exists || (func == pipeline::CompareFunc::always && !group.write_enabled)) return {};
  // What never passes never writes.
  return {true, group.write_enabled && func != pipeline::CompareFunc::never, func};
}

// What selection and feedback want of vertices [GL1.5 §5.2, §5.3].
pipeline::ReportState report_state(const RenderModeState& render_mode) {
  const bool feedback = render_mode.mode == GL_FEEDBACK;
  const GLenum type = render_mode.feedback.type;
  const bool textures = feedback && (type == GL_3D_COLOR_TEXTURE || type == GL_4D_COLOR_TEXTURE);
  return {.enabled = render_mode.mode != GL_RENDER,
          .colors = feedback && type != GL_2D && type != GL_3D,
          .texture_units = static_cast<std::uint8_t>(textures ? 1 : 0)};
}

bool back_faces_drawn(const PolygonGroup& polygon) {
  return !polygon.cull_enabled || polygon.cull_face == GL_FRONT;
}

bool is_multisampled(const MultisampleGroup& group, const TargetInfo& target) { return target.samples > 0 && group.enabled; }

pipeline::RasterState raster_state(const State& state, const TargetInfo& target) {
  if (const auto report = report_state(state.render_mode); report.enabled) {
    pipeline::RasterState nothing;
    nothing.color_write_mask = report.colors ? 0xF : 0;
    return nothing;
  }
  pipeline::RasterState result;
  result.scissor = writable_rect(state.scissor, target);
  result.depth = depth_state(state.depth, target);
  result.color_write_mask = color_write_mask(state.color_buffer, target);
  result.alpha_test = alpha_test_state(state.color_buffer);
  result.blend = blend_state(state.color_buffer, result.color_write_mask);
  result.logic_op = logic_op_state(state.color_buffer, result.color_write_mask, target.format.color);
  result.fog = fog_state(state.fog, result.color_write_mask);
  result.polygon_stipple = polygon_stipple_state(state.polygon, state.polygon_stipple);
  result.stencil = stencil_state(state.stencil, target.stencil_mask, result.depth, back_faces_drawn(state.polygon));
  result.counts_samples = state.current_query != 0;
  if (is_multisampled(state.multisample, target)) {
    if (state.multisample.alpha_to_coverage_enabled) result.alpha_to_coverage = static_cast<std::uint8_t>(target.samples);
    result.alpha_to_one = state.multisample.alpha_to_one_enabled && result.needs_colors();
  }
  return result;
}

/// Which samples SAMPLE_COVERAGE leaves [GL1.5 §4.1.3]: as many as its value says, the first ones.
std::uint8_t coverage_mask(const MultisampleGroup& group, int samples) {
  const auto all = static_cast<unsigned>((1 << samples) - 1);
  if (!group.coverage_enabled) return static_cast<std::uint8_t>(all);
  const int covered = static_cast<int>(group.coverage_value * static_cast<float>(samples) + 0.5f);
  const auto mask = static_cast<unsigned>((1 << covered) - 1);
  return static_cast<std::uint8_t>((group.coverage_inverted ? ~mask : mask) & all);
}

pipeline::MultisampleState multisample_state(const MultisampleGroup& group, const TargetInfo& target) {
  if (!is_multisampled(group, target)) return {};
  return {true, coverage_mask(group, target.samples)};
}

pipeline::AssemblyState assembly_state(const State& state, bool colors_matter, const pipeline::StencilState& stencil) {
  const PolygonGroup& polygon = state.polygon;
  pipeline::AssemblyState result;
  if (colors_matter && state.lighting.shade_model == GL_FLAT) result.shade_model = pipeline::ShadeModel::flat;
  if (polygon.cull_enabled) result.cull = cull_mode(polygon.cull_face);

  // A culled face has no mode, selection knows none, and one that nothing tells from the other has no direction.
  const bool front_drawn = result.cull == pipeline::CullMode::none || result.cull == pipeline::CullMode::back;
  const bool back_drawn = result.cull == pipeline::CullMode::none || result.cull == pipeline::CullMode::front;
  const bool modes = state.render_mode.mode != GL_SELECT;
  if (front_drawn && modes) result.polygon_mode_front = polygon_mode(polygon.front_mode);
  if (back_drawn && modes) result.polygon_mode_back = polygon_mode(polygon.back_mode);
  const bool two_sided = colors_matter && state.lighting.enabled && state.lighting.model_two_side;
  const bool faces_differ =
      front_drawn != back_drawn || (front_drawn && (result.polygon_mode_front != result.polygon_mode_back || two_sided ||
                                                    stencil.front != stencil.back));
  // With the origin at the upper left a polygon shows the same face, though its window coordinates turn the other way.
  const bool clockwise_is_front = (polygon.front_face == GL_CW) != (state.transform.clip_origin == GL_UPPER_LEFT);
  if (faces_differ && clockwise_is_front) result.front_face = pipeline::FrontFace::cw;
  return result;
}

pipeline::ViewportState viewport_state(const State& state, const TargetInfo& target, bool depth_matters) {
  const ViewportGroup& viewport = state.viewport;
  pipeline::ViewportState result{viewport.x, viewport.y, viewport.width_px, viewport.height_px};
  result.target_height_px = target.height_px;
  result.upper_left = state.transform.clip_origin == GL_UPPER_LEFT;
  result.zero_to_one = state.transform.clip_depth_mode == GL_ZERO_TO_ONE;
  if (depth_matters) {
    result.depth_near = viewport.depth_near;
    result.depth_far = viewport.depth_far;
  }
  return result;
}

pipeline::TransformState transform_state(const State& state, bool normals_matter) {
  pipeline::TransformState result;
  result.modelview = state.matrices.modelview.top();
  result.projection = state.matrices.projection.top();
  result.modelview_projection = product(result.projection, result.modelview);
  if (!normals_matter) return result;

  result.normal_matrix = normal_matrix(result.modelview);
  if (state.transform.normalize_enabled) {
    result.normal_scaling = pipeline::NormalScaling::normalize;
  } else if (state.transform.rescale_normal_enabled) {
    result.normal_scaling = pipeline::NormalScaling::rescale;
    result.rescale_factor = rescale_factor(result.modelview);
  }
  return result;
}

bool normals_matter(const pipeline::DrawState& draw_state) {
  const pipeline::LightingState& lighting = draw_state.lighting;
  return (lighting.enabled && lighting.light_count > 0) || generates_from_normals(draw_state.texture_coordinates);
}

}  // namespace

pipeline::PixelRect writable_rect(const State& state, const TargetInfo& target) {
  return writable_rect(state.scissor, target);
}

void update_matrices(const State& state, pipeline::DrawState& draw_state) {
  draw_state.transform = transform_state(state, normals_matter(draw_state));
  draw_state.clip_planes = clip_plane_state(state.transform);
}

// Parts are computed in an order in which each depends only on those before; a part that depends on a fact of an
// earlier one is computed again when that fact changes.
std::uint32_t update_draw_state(const State& state, const TargetInfo& target, std::uint32_t dirty,
                                pipeline::DrawState& draw_state) {
  // The stencil test is one part with the faces that are drawn.
  if ((dirty & (dirty_raster | dirty_assembly)) != 0 && state.stencil.test_enabled) dirty |= dirty_raster | dirty_assembly;
  const pipeline::RasterState old_raster = draw_state.raster;
  const pipeline::ReportState old_report = draw_state.report;
  draw_state.report = report_state(state.render_mode);
  if (draw_state.report != old_report) dirty = dirty_all;
  if (dirty & dirty_raster) {
    draw_state.raster = raster_state(state, target);
    const bool was_multisampled = draw_state.multisample.enabled;
    draw_state.multisample = multisample_state(state.multisample, target);
    if (draw_state.multisample.enabled != was_multisampled) dirty |= dirty_assembly;
  }
  const bool colors_matter = draw_state.raster.needs_colors();
  if (colors_matter != old_raster.needs_colors()) dirty |= dirty_assembly | dirty_lighting | dirty_textures;
  const bool reported = draw_state.report.enabled;
  const bool depth_matters = draw_state.raster.depth.test_enabled || reported;
  if (depth_matters != old_raster.depth.test_enabled) dirty |= dirty_viewport | dirty_assembly;
  if (draw_state.raster.stencil != old_raster.stencil) dirty |= dirty_assembly;

  if (dirty & dirty_textures) {
    draw_state.texturing = colors_matter && !reported ? texturing_state(state) : pipeline::TexturingState();
  }
  const std::uint8_t mask = draw_state.raster.color_write_mask;
  if (mask != old_raster.color_write_mask) dirty |= dirty_lighting;
  if (dirty & dirty_lighting) draw_state.color_sum = color_sum_state(state, mask);

  const pipeline::CullMode old_cull = draw_state.assembly.cull;
  if (dirty & (dirty_assembly | dirty_lighting)) {
    draw_state.assembly = assembly_state(state, colors_matter, draw_state.raster.stencil);
  }
  if (dirty & dirty_assembly) {
    const bool multisampled = draw_state.multisample.enabled;
    draw_state.points = reported ? pipeline::PointState{} : point_state(state.point, multisampled);
    draw_state.lines = reported ? pipeline::LineState{} : line_state(state.line, multisampled);
    draw_state.polygons =
        reported ? pipeline::PolygonState{} : polygon_state(state.polygon, draw_state.assembly, depth_matters);
    if (multisampled) draw_state.polygons.smooth = false;
  }
  if (dirty & dirty_lighting) dirty |= dirty_assembly;  // has been computed, as far as it depends
  if (draw_state.assembly.cull != old_cull) dirty |= dirty_lighting;

  const bool old_normals_matter = normals_matter(draw_state);
  const std::uint8_t units = reported ? draw_state.report.texture_units : units_of(draw_state.texturing);
  if ((dirty & dirty_texture_coordinates) != 0 || draw_state.texture_coordinates.units != units) {
    draw_state.texture_coordinates = texture_coordinates_state(state, units);
    dirty |= dirty_texture_coordinates;
  }
  if (dirty & dirty_lighting) {
    update_lighting(state.lighting, colors_matter, draw_state.assembly.cull, draw_state.lighting);
  }
  const bool new_normals_matter = normals_matter(draw_state);
  if (new_normals_matter != old_normals_matter) dirty |= dirty_transform;

  if (dirty & dirty_transform) update_matrices(state, draw_state);
  if (dirty & dirty_viewport) {
    draw_state.viewport = viewport_state(state, target, depth_matters);
  }
  return dirty;
}

namespace {

/// Calls visit(bit, member) for the members of a DrawState that the parts are.
template <class Visit>
void for_each_member(std::uint32_t parts, const Visit& visit) {
  using Draw = pipeline::DrawState;
  const auto part = [&](std::uint32_t bit, auto... members) {
    if ((parts & bit) != 0) (visit(bit, members), ...);
  };
  part(dirty_transform, &Draw::transform, &Draw::clip_planes);
  part(dirty_viewport, &Draw::viewport);
  part(dirty_lighting, &Draw::lighting, &Draw::color_sum);
  part(dirty_assembly, &Draw::assembly, &Draw::points, &Draw::lines, &Draw::polygons);
  part(dirty_raster, &Draw::raster, &Draw::multisample, &Draw::report);
  part(dirty_textures, &Draw::texturing);
  part(dirty_texture_coordinates, &Draw::texture_coordinates);
}

}  // namespace

std::uint32_t differing_parts(const pipeline::DrawState& a, const pipeline::DrawState& b, std::uint32_t parts) {
  std::uint32_t differing = 0;
  for_each_member(parts, [&](std::uint32_t bit, auto member) {
    if (!(a.*member == b.*member)) differing |= bit;
  });
  return differing;
}

void copy_parts(const pipeline::DrawState& from, std::uint32_t parts, pipeline::DrawState& to) {
  for_each_member(parts, [&](std::uint32_t, auto member) { to.*member = from.*member; });
}

pipeline::DrawState raster_position_state(const State& state, const TargetInfo& target) {
  pipeline::DrawState result;
  result.report = {.enabled = true, .colors = true, .eye_positions = true, .texture_units = 0xFF};
  result.texture_coordinates = texture_coordinates_state(state, result.report.texture_units);
  update_lighting(state.lighting, true, pipeline::CullMode::back, result.lighting);  // front colours are enough
  result.lighting.material = canonical_material(state.lighting, result.lighting);
  result.transform = transform_state(state, normals_matter(result));
  result.clip_planes = clip_plane_state(state.transform);
  result.viewport = viewport_state(state, target, true);
  return result;
}

pipeline::ClearState clear_state(const State& state, const TargetInfo& target, GLbitfield mask) {
  pipeline::ClearState result;
  result.scissor = writable_rect(state.scissor, target);
  if ((mask & GL_COLOR_BUFFER_BIT) != 0 && color_write_mask(state.color_buffer, target) != 0) {
    result.color = true;
    result.color_write_mask = color_write_mask(state.color_buffer, target);
    result.clear_color = state.color_buffer.clear_color;
    if (result.color_write_mask == 0b0111 && target.color_channels == 0b0111) {
      // The alpha that is not there is 1 as before, and nothing is masked.
      result.color_write_mask = 0b1111;
      result.clear_color.w = 1.0f;
    }
  }
  if ((mask & GL_DEPTH_BUFFER_BIT) != 0 && state.depth.write_enabled && target.has_depth &&
      target.format.depth != pipeline::DepthFormat::none) {
    result.depth = true;
    result.clear_depth = state.depth.clear_value;
  }
  const std::uint32_t stencil_mask = state.stencil.front.write_mask & target.stencil_mask;
  if ((mask & GL_STENCIL_BUFFER_BIT) != 0 && stencil_mask != 0) {
    result.stencil = true;
    result.clear_stencil = static_cast<std::uint32_t>(state.stencil.clear_value) & target.stencil_mask;
    result.stencil_write_mask = stencil_mask;
  }
  if ((mask & GL_ACCUM_BUFFER_BIT) != 0 && target.accumulates) {
    result.accum = true;
    result.clear_accum = state.accum.clear_value;
  }
  return result;
}

pipeline::AccumState accum_state(const State& state, const TargetInfo& target, GLenum op, GLfloat value) {
  constexpr float most = std::numeric_limits<float>::max();
  pipeline::AccumState result;
  result.op = accum_op(op);
  const bool of_sums = op == GL_ADD || op == GL_MULT;
  const float largest = of_sums ? 1.0f : most;
  result.value = std::isnan(value) ? 0.0f : std::clamp(value, -largest, largest);
  result.scissor = writable_rect(state.scissor, target);
  if (op == GL_RETURN) result.color_write_mask = color_write_mask(state.color_buffer, target);
  return result;
}

}  // namespace gouraud::api
