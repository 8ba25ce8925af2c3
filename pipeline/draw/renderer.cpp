// The one page: the way of a batch from object space to the tile bins. One call a stage; data passed explicitly.
#include "pipeline/draw/renderer_implementation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <new>
#include <optional>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#if defined(__linux__)
#include <sched.h>
#endif

#include "pipeline/draw/antialiasing.h"
#include "pipeline/draw/method_state.h"
#include "pipeline/draw/phong_shading.h"
#include "pipeline/draw/pixel_draws.h"
#include "pipeline/draw/sample_counter.h"
#include "pipeline/draw/tiles.h"
#include "pipeline/draw/transform_runs.h"
#include "pipeline/draw/varying_layout.h"
#include "pipeline/draw/visibility_methods.h"
#include "pipeline/fragment/color_write.h"
#include "pipeline/fragment/depth_methods.h"
#include "pipeline/geometry/assembly.h"
#include "pipeline/geometry/clip_planes.h"
#include "pipeline/geometry/affine.h"
#include "pipeline/geometry/colors.h"
#include "pipeline/geometry/lighting.h"
#include "pipeline/geometry/lighting_methods.h"
#include "pipeline/geometry/normals.h"
#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/geometry/texture_coordinates.h"
#include "pipeline/geometry/transform.h"
#include "pipeline/geometry/viewport.h"
#include "pipeline/raster/sample_positions.h"
#include "pipeline/raster/setup.h"
#include "pipeline/simd/float_mode.h"

namespace gouraud::pipeline {
namespace {

/// Stencil values other than zero are about to be stored.
void note_stencil(const Framebuffer& target) {
  if (target.stencil_bits > 0 && target.depth_format == DepthFormat::z24s8) target.depth.use_stencil();
}

/// What of the rectangle lies in the viewport.
PixelRect cut_to(const ViewportState& viewport, const PixelRect& rectangle) {
  const auto sum = [](std::int32_t a, std::int32_t b) { return static_cast<std::int32_t>(std::min<std::int64_t>(std::int64_t{a} + b, INT32_MAX)); };
  return {std::max(rectangle.x0, viewport.x), std::max(rectangle.y0, viewport.y),
          std::min(rectangle.x1, sum(viewport.x, viewport.width_px)), std::min(rectangle.y1, sum(viewport.y, viewport.height_px))};
}

SetupState make_setup_state(const DrawState& state, const Plan& plan, const Framebuffer& target) {
  SetupState setup;
  setup.scissor = state.raster.scissor;
  setup.target_height_px = state.viewport.target_height_px;
  setup.front_face = state.assembly.front_face;
  setup.cull = state.assembly.cull;
  setup.flat = state.assembly.shade_model == ShadeModel::flat;
  setup.colors = plan.colors;
  setup.two_sided = plan.lighting && state.lighting.two_sided;
  setup.sampled = state.multisample.enabled;
  setup.color_sum = plan.secondary_color == SecondaryColor::summed_at_vertices;
  setup.points = state.points;
  setup.lines = state.lines;
  setup.polygons = state.polygons;
  setup.polygons.smooth |= plan.methods.shapes_triangles();
  if (plan.methods.leaves_viewport()) setup.scissor = cut_to(state.viewport, setup.scissor);
  setup.targets = {depth_scale(target.depth_format), target.depth_format == DepthFormat::z32f, plan.textured ? 1.0f : color_scale(target.color_format)};
  return setup;
}

}  // namespace

/// The plan's, or those of somebody who looks on.
void Renderer::Implementation::set_passes(const DrawState& state, const Plan& plan, const FragmentPasses& passes, RasterBinding& binding) {
  binding.passes = passes;
  if (!watch.watches_pixel()) return;
  const TargetFormat format{bins.target()->color_format, bins.target()->depth_format, plan.methods};
  binding.watch = new (bins.allocate(sizeof(PixelWatch))) PixelWatch(make_pixel_watch(watch, watched_draws, passes, state, plan, format));
  binding.passes = watched(passes);
}

/// What a draw needs of the stages after the vertices.
void Renderer::Implementation::prepare(const DrawState& state, const Plan& plan, const VaryingLayout& varyings,
                                       const PlacedImage* image) {
  RasterBinding binding{state.raster, {}, varyings, plan.colors};
  set_passes(state, plan, plan.fragment, binding);
  binding.image = image;
  samples_at_once = bins.target()->samples > 1 && !hidden && state.multisample.sample_mask != 0 && plan.methods == Methods{};
  if (samples_at_once) {
    binding.sample_mask = state.multisample.sample_mask;
    binding.samples_apart = state.multisample.enabled;
  }
  if (plan.textured) {
    const TileBins::InternedTextures& textures = bins.intern(state.texturing, color_scale(bins.target()->color_format));
    binding.texturing = &textures.state;
    binding.texture_units = &textures.units;
  }
  if (plan.counts_samples) {
    binding.samples = samples.get();
    if (kept.empty() || kept.back() != samples) kept.push_back(samples);
  }
  if (plan.phong || plan.methods.warps_depth()) {
    auto* const method = new (bins.allocate(sizeof(MethodState))) MethodState{plan.methods, {}, state.lighting, 1.0f};
    method->distance = distance_of_depth(state.transform, state.viewport);
    method->color_scale = plan.textured ? 1.0f : color_scale(bins.target()->color_format);
    binding.method = method;
  }
  if (plan.writes_stencil) note_stencil(*bins.target());
  const SetupState state_of_setup = make_setup_state(state, plan, *bins.target());
  setup = outlined_setup = filled_setup = bins.intern(state_of_setup, binding);
  smooth_polygons = state.polygons.smooth;
  homogeneous = plan.methods.coverage == CoverageMethod::homogeneous && !smooth_polygons;
  phong = plan.phong;
  gathers = plan.gathers && !smooth_polygons;
  if (!gathers) give_gathered();
  if (gathers) gathered_for = plan.methods.depth;
  mode_front = state.assembly.polygon_mode_front;
  mode_back = state.assembly.polygon_mode_back;
  plain_points = are_plain_points(*setup);
  plain_lines = are_plain_lines(*setup) && !plan.methods.walks_lines();
  unfilled = mode_front != PolygonMode::fill || mode_back != PolygonMode::fill;
  const bool plain_polygons = !unfilled && !state.polygons.smooth && image == nullptr;
  if (plain_polygons && plan.coverage) {
    set_passes(state, plan, plan.filled, binding);
    filled_setup = bins.intern(state_of_setup, binding);
  }
  clip_attributes = {plan.eye_positions, plan.colors, setup->two_sided, plan.secondary_color != SecondaryColor::none,
                     varyings.of_vertices(), &state.clip_planes};
}

void Renderer::Implementation::run_vertex_stages(const DrawState& state, const Plan& plan, const VaryingLayout& varyings,
                                                 const VertexBatch& batch) {
  transform_to_clip(state.transform, batch, vertices);
  if (plan.eye_positions) transform_to_eye(state.transform, batch, vertices);
  if (plan.normals) transform_normals(state.transform, batch, vertices);
  if (plan.lighting) {
    plan.methods.lights_plainly() ? light_vertices(state.lighting, plan.methods.highlight, batch, vertices)
                                  : light_vertices(state.lighting, batch, vertices);
  }
  if (plan.phong) make_lighting_varyings(state.lighting, varyings, batch, vertices);
  if (plan.vertex_colors) clamp_vertex_colors(batch, vertices);
  if (plan.secondary_vertex_colors) clamp_secondary_colors(batch, vertices);
  for (int unit = 0; plan.textured && unit < max_texture_units; ++unit) {
    const auto k = static_cast<std::size_t>(unit);
    const TextureCoordinateLayout& layout = varyings.texture_coordinates[k];
    if (layout.first >= 0) make_texture_coordinates(state.texture_coordinates.unit[k], layout, unit, batch, vertices);
  }
  if (plan.fog) {
    make_fog_coordinates(state.transform, state.raster.fog, batch, vertices.varying[static_cast<std::size_t>(varyings.fog_coordinate)]);
  }
  viewport = state.viewport;
  methods = plan.reports ? Methods{} : plan.methods;
  project(state);
}

void Renderer::Implementation::tell_of_vertex(const DrawState& state, const Plan& plan, const VertexBatch& batch) {
  const std::int64_t index = watch.vertex - watched_vertices;
  if (watch.vertex >= 0 && index >= 0 && index < batch.count) {
    watch.tell("vertex " + std::to_string(watch.vertex) + ": draw " + std::to_string(watched_draws) + "\n" +
               describe_vertex(state, plan, batch, vertices, static_cast<std::int32_t>(index)));
  }
  watched_vertices += batch.count;
  ++watched_draws;
}

/// Clip space to window space, and what is outside.
void Renderer::Implementation::project(const DrawState& state) {
  project_to_window(viewport, vertices);
  if (state.clip_planes.count > 0) test_clip_planes(state.clip_planes, vertices);
  if (methods.colors == InterpolationMethod::affine) forget_distances(0, vertices);
}

/// How the quads of range `i` are split: asked of every range in order.
QuadSplit Renderer::Implementation::split_of(const DrawState& state, const VertexBatch& batch, std::size_t i) {
  const PrimitiveRange& range = batch.primitives[i];
  const bool in_pieces = unfilled || state.raster.polygon_stipple.enabled;
  const bool lasting_diagonal = in_pieces || state.assembly.shade_model == ShadeModel::flat;
  if (!lasting_diagonal && begins_quads(batch, i)) {
    clipped_quads = (clipped_quads && !range.begins) || are_quads_clipped(batch, vertices, i);
  }
  const bool other_diagonal = lasting_diagonal || clipped_quads || range.indexed || range.origin == PrimitiveOrigin::display_list;
  const bool far_half_first = range.mode == PrimitiveMode::quad_strip && (in_pieces || is_clipped(range, batch, vertices));
  return {other_diagonal ? QuadDiagonal::from_1_to_3 : QuadDiagonal::from_0_to_2, far_half_first};
}

/// Assembles range `i`, and those after it that are to be drawn together with it: filled polygons whose vertices follow
/// each other. `i` is then the next range. Returns all of them as one.
PrimitiveRange Renderer::Implementation::assemble_ranges(const DrawState& state, const VertexBatch& batch, std::size_t& i) {
  assembled.triangles.clear();
  assembled.lines.clear();
  assembled.points.clear();
  PrimitiveRange all = batch.primitives[i];
  assemble(all, split_of(state, batch, i++), assembled);
  if (all.indexed) resolve_elements(batch.elements.data() + all.first, assembled);
  if (unfilled) apply_edge_flags(all, batch.edge_flag.data(), assembled.triangles);
  if (unfilled || smooth_polygons || phong || all.indexed || !is_polygonal(all.mode)) return all;
  for (; i < batch.primitives.size(); ++i) {
    const PrimitiveRange& next = batch.primitives[i];
    if (next.indexed || !is_polygonal(next.mode) || next.first != all.first + all.count) break;
    assemble(next, split_of(state, batch, i), assembled);
    all.count += next.count;
    all.begins |= next.begins;
  }
  return all;
}

/// In order, to the sample that is selected, or to all.
void Renderer::Implementation::draw_primitives(const DrawState& state, const VertexBatch& batch) {
  shared = {};
  for (std::size_t i = 0; i < batch.primitives.size();) {
    if (phong && !batch.material_runs.empty()) select_material(batch, batch.primitives[i]);
    const PrimitiveRange range = assemble_ranges(state, batch, i);
    setup = filled_setup;
    draw_range_of_triangles(range);
    setup = outlined_setup;
    if (gathers && !(assembled.lines.empty() && assembled.points.empty())) give_gathered();
    // The stipple counter starts anew with a primitive and with each independent line [GL1.5 §3.4.2].
    const bool independent = range.mode == PrimitiveMode::lines;
    if (range.begins) stipple_count = 0;
    for (const AssembledLine& line : assembled.lines) {
      if (independent) stipple_count = 0;
      draw_line(line);
    }
    for (const AssembledPoint& point : assembled.points) draw_point(point);
  }
}

/// All samples of a pixel at once, shaded once (sample_blocks.h), where no method has it otherwise.
void Renderer::Implementation::draw_samples(const DrawState& state, const VertexBatch& batch) {
  if (samples_at_once) {
    bins.select_sample(TileBins::all_samples);
    draw_primitives(state, batch);
  } else {
    draw_each_sample(state, batch);
  }
  bins.select_sample(0);
}

/// Every sample is a picture of its own [GL1.5 §3.2.1]: what is drawn is moved so that the sample stands where a pixel
/// has its centre, projected once more, and drawn as ever. So coverage, depth and colours are those of the sample's own
/// place, and no stage after this one knows of samples.
void Renderer::Implementation::draw_each_sample(const DrawState& state, const VertexBatch& batch) {
  const StippleCount stipple_before = stipple_count;
  for (std::size_t sample = 0; sample < static_cast<std::size_t>(bins.target()->samples); ++sample) {
    if (!hidden && (state.multisample.sample_mask >> sample & 1) == 0) continue;
    bins.select_sample(static_cast<std::int32_t>(sample));
    std::array<float, 2> position{0.5f, 0.5f};
    if (hidden) position = sample_position(antialiasing, sample);
    if (!hidden && state.multisample.enabled) position = sample_positions[sample];
    viewport.sample_shift_x = 0.5f - position[0];
    viewport.sample_shift_y = 0.5f - position[1];
    vertices.count = batch_count;
    project(state);
    stipple_count = stipple_before;
    draw_primitives(state, batch);
  }
}

void Renderer::Implementation::finish() {
  run_bins();
  if (hidden && std::exchange(drawn_since_resolve, false)) resolve_samples(*hidden, *target);
}

Renderer::Renderer(int thread_count) : implementation_(std::make_unique<Implementation>(thread_count)) {}
Renderer::~Renderer() = default;

Framebuffer* Renderer::target() const { return implementation_->target; }

void Renderer::set_target(Framebuffer* target) {
  finish();
  implementation_->target = target;
  implementation_->use_samples();
  set_observer(implementation_->observer);
}

void Renderer::set_antialiasing(AntialiasingMethod method) {
  if (method == implementation_->antialiasing) return;
  finish();
  implementation_->antialiasing = method;
  implementation_->use_samples();
}

void Renderer::target_changed() {
  if (implementation_->hidden) load_samples(*implementation_->target, *implementation_->hidden);
}

void Renderer::set_receiver(PrimitiveReceiver* receiver) { implementation_->receiver = receiver; }

void Renderer::set_observer(DrawObserver* observer) {
  implementation_->observer = observer;
  if (observer == nullptr || target() == nullptr) return;
  finish();
  observer->target_changed(*target());
}

void Renderer::set_watch(const Watch& watch) { implementation_->watch = watch; }

void Renderer::draw(const DrawState& state, const Plan& plan, const VertexBatch& batch) {
  Implementation& self = *implementation_;
  if (target() == nullptr) return;
  const IeeeFloats floats;
  if (plan.reports) {
    if (self.receiver == nullptr) return;
    const VaryingLayout varyings = make_varying_layout(state, plan, batch);
    self.run_vertex_stages(state, plan, varyings, batch);
    return report_primitives(state, plan, varyings, batch, self.vertices, *self.receiver);
  }
  if (self.observer != nullptr) {
    split_transform_runs(state, batch, [&](const DrawState& s, const VertexBatch& part) { self.observer->draw(s, part); });
  }
  if (!plan.draws) return;

  const VaryingLayout varyings = make_varying_layout(state, plan, batch);
  self.prepare(state, plan, varyings);
  self.dirty = true;

  // Vertices, then primitives in order.
  self.run_vertex_stages(state, plan, varyings, batch);
  if (self.watch.tell != nullptr) self.tell_of_vertex(state, plan, batch);
  self.batch_count = batch.count;
  self.bins.target()->samples > 1 ? self.draw_samples(state, batch) : self.draw_primitives(state, batch);
  if (self.bins.full() && self.smooth_parts.empty()) self.run_bins();
}

ProcessedVertex Renderer::process_vertex(const DrawState& state, const Plan& plan, const VertexBatch& batch) {
  Implementation& self = *implementation_;
  const IeeeFloats floats;
  const VaryingLayout varyings = make_varying_layout(state, plan, batch);
  self.run_vertex_stages(state, plan, varyings, batch);
  ProcessedVertex result;
  result.inside = self.vertices.outcode[0] == 0;
  if (!result.inside) return result;
  const auto vector = [](const Rgba& color) { return glm::vec4(color.r, color.g, color.b, color.a); };
  const auto& eye = self.vertices.position_eye;
  result.position_window = window_position(state.viewport, self.vertices, 0);
  result.w_clip = self.vertices.position_clip[3][0];
  if (plan.eye_positions) {
    const double x = eye[0][0], y = eye[1][0], z = eye[2][0];
    result.eye_distance = static_cast<float>(std::sqrt((x * x + y * y) + z * z));
  }
  if (plan.colors) result.color = vector(self.vertices.color_front[0]);
  if (plan.lighting && state.lighting.separate_specular) result.specular = vector(self.vertices.specular_front[0]);
  for (std::size_t unit = 0; unit < max_texture_units; ++unit) {
    result.texture_coordinates[unit] = texture_coordinates_of(varyings, static_cast<int>(unit), self.vertices, 0);
  }
  return result;
}

void Renderer::clear(const ClearState& state) {
  if (target() == nullptr) return;
  if (implementation_->observer != nullptr) implementation_->observer->clear(state);
  if (state.color) implementation_->watched_vertices = implementation_->watched_draws = 0;
  implementation_->dirty = true;
  if (state.stencil && (state.clear_stencil & state.stencil_write_mask) != 0) note_stencil(*implementation_->bins.target());
  implementation_->give_gathered();
  implementation_->bins.add_clear(state);
  if (implementation_->bins.full()) implementation_->run_bins();
}

void Renderer::keep(std::shared_ptr<const void> resource) {
  auto& kept = implementation_->kept;
  if (kept.empty() || kept.back() != resource) kept.push_back(std::move(resource));
}

void Renderer::accumulate(const AccumState& state) {
  if (target() == nullptr) return;
  if (implementation_->observer != nullptr) implementation_->observer->accumulate(state);
  implementation_->dirty = true;
  implementation_->give_gathered();
  if (implementation_->hidden) return implementation_->accumulate_resolved(state);
  implementation_->bins.add_accum(state);
  if (implementation_->bins.full()) implementation_->run_bins();
}

void Renderer::count_samples(std::shared_ptr<SampleCounter> counter) {
  implementation_->samples = std::move(counter);
  implementation_->last_bitmap.record = nullptr;
}

void Renderer::finish() { implementation_->finish(); }

bool Renderer::take_dirty() { return std::exchange(implementation_->dirty, false); }

int default_thread_count() {
  constexpr int most = 256;
  if (const char* wanted = std::getenv("GOURAUD_THREADS")) {
    const long count = std::strtol(wanted, nullptr, 10);
    if (count >= 1) return static_cast<int>(std::min<long>(count, most));
  }
#if defined(__linux__)
  cpu_set_t cpus;
  if (sched_getaffinity(0, sizeof cpus, &cpus) == 0) return std::clamp(CPU_COUNT(&cpus), 1, most);
#endif
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, most);
}

}  // namespace gouraud::pipeline
