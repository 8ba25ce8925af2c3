// The one page: the way of a batch from object space to the tile bins. One call a stage; data passed explicitly.
#include "pipeline/draw/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>
#include <optional>
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
#include "pipeline/draw/varying_layout.h"
#include "pipeline/draw/visibility_methods.h"
#include "pipeline/fragment/color_write.h"
#include "pipeline/fragment/depth_methods.h"
#include "pipeline/geometry/assembly.h"
#include "pipeline/geometry/clip_planes.h"
#include "pipeline/geometry/clipping.h"
#include "pipeline/geometry/clipping_methods.h"
#include "pipeline/geometry/affine.h"
#include "pipeline/geometry/colors.h"
#include "pipeline/geometry/lighting.h"
#include "pipeline/geometry/lighting_methods.h"
#include "pipeline/geometry/normals.h"
#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/geometry/texture_coordinates.h"
#include "pipeline/geometry/transform.h"
#include "pipeline/geometry/viewport.h"
#include "pipeline/raster/homogeneous.h"
#include "pipeline/raster/line_methods.h"
#include "pipeline/raster/method_triangle.h"
#include "pipeline/raster/setup.h"
#include "pipeline/raster/triangles.h"
#include "pipeline/simd/float_mode.h"

namespace gouraud::pipeline {
namespace {

/// So much memory of images may wait for the tiles. No more than stays in a cache and in the allocator's hands: ten images
/// of a whole screen, 8 MiB each, take 66 ms if all of them wait, in pages that the system makes and takes back.
constexpr std::size_t image_bytes_limit = std::size_t{1} << 20;

/// What multiplies a depth in [0, 1] to give buffer units.
double depth_scale(DepthFormat format) {
  switch (format) {
    case DepthFormat::z16: return 0xFFFF;
    case DepthFormat::z24s8: return 0xFFFFFF;
    case DepthFormat::none:
    case DepthFormat::z32f: break;
  }
  return 1.0;
}

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

/// Where a line that will be clipped would have begun and ended, for the phase of its stipple.
/// choice: the specification leaves the phase of a clipped line open [GL1.5 §3.4.2]; ours is that of the whole line, as
/// long as both ends lie in front of the eye. (Mesa starts at the border.)
struct LineSpan {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool steep() const { return std::abs(y1 - y0) > std::abs(x1 - x0); }
  static StippleCount rounded(double length) { return static_cast<StippleCount>(std::min(length + 0.5, 1e15)); }
  StippleCount fragments() const { return rounded(steep() ? std::abs(y1 - y0) : std::abs(x1 - x0)); }
  StippleCount fragments_to(const WindowVertex& v) const {
    return std::min(rounded(steep() ? std::abs(v.y_raster - y0) : std::abs(v.x - x0)), fragments());
  }
};

LineSpan unclipped_span(const ViewportState& viewport, const ProcessedVertices& vertices, const AssembledLine& line) {
  std::array<double, 2> x, y;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto clip = [&](std::size_t k) { return static_cast<double>(vertices.position_clip[k][line.vertex[i]]); };
    x[i] = clip(0) / clip(3) * 0.5 * viewport.width_px;
    y[i] = (viewport.upper_left ? clip(1) : -clip(1)) / clip(3) * 0.5 * viewport.height_px;
    if (!(clip(3) > 0) || !std::isfinite(x[i]) || !std::isfinite(y[i])) return {};
    x[i] += viewport.x + 0.5 * viewport.width_px + viewport.sample_shift_x;
    y[i] += viewport.target_height_px - (viewport.y + 0.5 * viewport.height_px) - viewport.sample_shift_y;
  }
  return {x[0], y[0], x[1], y[1]};
}

}  // namespace

struct Renderer::Implementation {
  explicit Implementation(int thread_count) : bins(thread_count) {}

  void prepare(const DrawState& state, const Plan& plan, const VaryingLayout& varyings, const PlacedImage* image = nullptr);
  void project(const DrawState& state);
  void run_vertex_stages(const DrawState& state, const Plan& plan, const VaryingLayout& varyings, const VertexBatch& batch);
  void draw_primitives(const DrawState& state, const VertexBatch& batch);
  void select_material(const VertexBatch& batch, const PrimitiveRange& range);
  void draw_samples(const DrawState& state, const VertexBatch& batch);
  void draw_range_of_triangles(const PrimitiveRange& range);
  SharedVertices share_vertices(const PrimitiveRange& range);
  void draw_triangle(const AssembledTriangle& triangle);
  void flush_triangles();
  void select_and_add(std::span<const AssembledTriangle> triangles, SharedVertices of_range);
  void set_up_smooth_part(const WaitingTriangle& triangle);
  void finish_polygons();
  void flush_shapes();
  void add_homogeneous_triangle(const AssembledTriangle& triangle);
  bool draw_unclipped(const AssembledTriangle& triangle);
  void add_method_triangle(const WaitingTriangle& triangle, const AssembledTriangle& assembled_triangle);
  void add_shape(const PrimitiveRecord& record);
  void give_gathered();
  void draw_unfilled(const AssembledTriangle& triangle, bool front);
  void draw_line(AssembledLine line);
  void draw_clipped_line(const AssembledLine& line);
  void walk_line_by_method(const AssembledLine& line, void* memory);
  void draw_smooth_line(const AssembledLine& line);
  void draw_point(const AssembledPoint& point);
  bool stippled() const { return setup->lines.stipple_pattern != 0xFFFF; }
  void clip_and_draw(const AssembledTriangle& triangle);
  void prepare_fragments(const PixelDraw& draw, const FragmentSource& source, const PlacedImage* image);
  template <class Add>
  void add_to_samples(const DrawState& state, Add add);
  PlacedImage* keep_image(const PixelRectangle& rectangle, const PlacedRectangle& placed);
  PrimitiveRecord& bitmap_record(const PixelDraw& draw, const FragmentSource& source);
  void use_samples();
  void accumulate_resolved(const AccumState& state);
  void finish();
  /// Rasterizes what is pending.
  void run_bins() {
    give_gathered();
    drawn_since_resolve |= bins.pending();
    const IeeeFloats floats;
    bins.run();
    kept.clear();
    kept_image_bytes = 0;
  }
  void emit(const AssembledTriangle& triangle) {
    unfilled ? draw_unfilled(triangle, faces_front(*setup, vertices, triangle)) : draw_triangle(triangle);
  }

  TileBins bins;
  Framebuffer* target = nullptr;      ///< the program's
  std::optional<Framebuffer> hidden;  ///< drawn into in its place, with the samples of the antialiasing method
  AntialiasingMethod antialiasing = AntialiasingMethod::none;
  bool drawn_since_resolve = false;
  std::vector<std::shared_ptr<const void>> kept;  ///< until the bins have run
  std::shared_ptr<SampleCounter> samples;
  std::size_t kept_image_bytes = 0;
  DrawObserver* observer = nullptr;
  PrimitiveReceiver* receiver = nullptr;
  bool dirty = false;

  // Of the batch being drawn.
  const SetupState* setup = nullptr;
  ViewportState viewport;
  PolygonMode mode_front = PolygonMode::fill, mode_back = PolygonMode::fill;
  bool unfilled = false;
  bool plain_points = false, plain_lines = false;
  Methods methods;
  bool smooth_polygons = false, homogeneous = false, phong = false, gathers = false;
  GatheredTriangles gathered;
  DepthMethod gathered_for = DepthMethod::z;
  ClipAttributes clip_attributes;
  AssembledPrimitives assembled;
  std::vector<AssembledTriangle> clipped;
  std::vector<AssembledTriangle> ready;  ///< wait for setup, which takes several at a time
  alignas(64) std::array<std::byte, selection_batch * largest_waiting> selected;  ///< of those, the ones to draw
  std::vector<const PrimitiveRecord*> smooth_parts;  ///< of the smooth polygon that is being drawn
  std::int32_t batch_count = 0;          ///< vertices beyond are the clipper's
  SharedVertices shared;                 ///< of the batch, for its indexed ranges; none until one has asked
  std::vector<PixelPosition> pixels;
  StippleCount stipple_count = 0;  ///< goes on where a batch was cut
  bool clipped_quads = false;      ///< as well
  ProcessedVertices vertices;

  // Of bitmaps and pixel rectangles. Glyphs of one text share a record.
  std::unique_ptr<VertexBatch> source_vertex;
  struct {
    PrimitiveRecord* record = nullptr;
    FragmentSource source{};
    std::uint64_t version = 0, generation = 0;
  } last_bitmap;
};

/// What a draw needs of the stages after the vertices.
void Renderer::Implementation::prepare(const DrawState& state, const Plan& plan, const VaryingLayout& varyings,
                                       const PlacedImage* image) {
  RasterBinding binding{state.raster, plan.fragment, varyings, plan.colors};
  binding.image = image;
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
  setup = bins.intern(make_setup_state(state, plan, *bins.target()), binding);
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

/// Clip space to window space, and what is outside.
void Renderer::Implementation::project(const DrawState& state) {
  project_to_window(viewport, vertices);
  if (state.clip_planes.count > 0) test_clip_planes(state.clip_planes, vertices);
  if (methods.colors == InterpolationMethod::affine) forget_distances(0, vertices);
}

void Renderer::Implementation::draw_triangle(const AssembledTriangle& triangle) {
  if (smooth_polygons && !triangle.continues) finish_polygons();
  ready.push_back(triangle);
  if (ready.size() == selection_batch) flush_triangles();
}

void Renderer::Implementation::flush_triangles() {
  if (ready.empty()) return;
  if (setup->polygons.smooth) return flush_shapes();
  select_and_add(ready, {});
  ready.clear();
}

void Renderer::Implementation::select_and_add(std::span<const AssembledTriangle> triangles, SharedVertices of_range) {
  while (!triangles.empty()) {
    const auto some = triangles.first(std::min(triangles.size(), selection_batch));
    triangles = triangles.subspan(some.size());
    const std::size_t count = select_triangles(*setup, vertices, some, of_range, selected.data());
    bins.add_triangles(*setup, selected.data(), count, of_range.kept != nullptr);
  }
}

/// Vertices that the triangles of a range share, if it pays: two of three corners must be another triangle's too.
SharedVertices Renderer::Implementation::share_vertices(const PrimitiveRange& range) {
  const std::int32_t used = range.indexed ? batch_count : range.count;
  if (!may_share_vertices(*setup) || 2 * assembled.triangles.size() <= static_cast<std::size_t>(used)) return {};
  if (range.indexed && shared.kept != nullptr) return shared;
  const std::int32_t first = range.indexed ? 0 : range.first;
  const auto count = static_cast<std::size_t>(used);
  auto* const memory = static_cast<std::byte*>(bins.allocate(count * kept_vertex_size(*setup)));
  const SharedVertices result{keep_vertices(*setup, vertices, static_cast<std::size_t>(first), count, memory),
                              static_cast<std::uint16_t>(first)};
  if (range.indexed) shared = result;
  return result;
}

/// Those that the clip volume holds wholly go on in stretches. Others have vertices of the clipper's, which are soon
/// overwritten: their parts keep their own.
void Renderer::Implementation::draw_range_of_triangles(const PrimitiveRange& range) {
  const std::span<const AssembledTriangle> triangles = assembled.triangles;
  if (triangles.empty()) return;
  const bool plain = !unfilled && !setup->polygons.smooth;
  const SharedVertices of_range = plain ? share_vertices(range) : SharedVertices{};
  const auto is_inside = [this](const AssembledTriangle& triangle) {
    const auto& outcode = vertices.outcode;
    return (outcode[triangle.vertex[0]] | outcode[triangle.vertex[1]] | outcode[triangle.vertex[2]]) == 0;
  };
  for (std::size_t i = 0; i < triangles.size();) {
    if (!is_inside(triangles[i])) {
      clip_and_draw(triangles[i++]);
      continue;
    }
    const std::size_t first = i++;
    if (!plain) {
      emit(triangles[first]);
      continue;
    }
    while (i < triangles.size() && is_inside(triangles[i])) ++i;
    flush_triangles();
    select_and_add(triangles.subspan(first, i - first), of_range);
  }
  finish_polygons();
}

/// Triangles whose pixels their edges alone do not give: smooth ones, and those of other methods.
void Renderer::Implementation::flush_shapes() {
  for (const AssembledTriangle& triangle : ready) {
    if (homogeneous) {
      add_homogeneous_triangle(triangle);
    } else if (select_triangles(*setup, vertices, {&triangle, 1}, {}, selected.data()) > 0) {
      const auto& waiting = *reinterpret_cast<const WaitingTriangle*>(selected.data());
      smooth_polygons ? set_up_smooth_part(waiting) : add_method_triangle(waiting, triangle);
    }
  }
  ready.clear();
}

void Renderer::Implementation::add_homogeneous_triangle(const AssembledTriangle& triangle) {
  const std::size_t bytes = record_size(*setup);
  auto* shape = new (bins.allocate(sizeof(MethodTriangle))) MethodTriangle;
  void* memory = bins.allocate(bytes);
  if (!setup_homogeneous(*setup, viewport, vertices, triangle, memory, *shape)) return bins.take_back(bytes);
  if (gathers) set_ray_corners(viewport, vertices, triangle, *shape);
  add_shape(*static_cast<PrimitiveRecord*>(memory));
}

/// A triangle that lies partly outside, as the method has it. False: clip it.
bool Renderer::Implementation::draw_unclipped(const AssembledTriangle& triangle) {
  unsigned outcodes = 0;
  for (const std::uint16_t vertex : triangle.vertex) outcodes |= vertices.outcode[vertex];
  if (unfilled || smooth_polygons || outcodes >= outside_clip_plane_0) return false;
  if ((outcodes & outside_invalid) != 0) return true;
  if (homogeneous || methods.clipping == ClippingMethod::homogeneous) {
    flush_triangles();
    add_homogeneous_triangle(triangle);
    return true;
  }
  const bool fits = methods.clipping == ClippingMethod::none ? force_into_window(viewport, triangle, vertices)
                                                             : fits_guard_band(viewport, vertices, triangle);
  if (fits) emit(triangle);
  return fits || methods.clipping == ClippingMethod::none;
}

/// A smooth polygon has one fragment in each pixel, whatever triangles it was split into [GL1.5 §3.5.3].
void Renderer::Implementation::set_up_smooth_part(const WaitingTriangle& triangle) {
  auto* memory = static_cast<std::byte*>(bins.allocate(record_size(*setup)));
  set_up_triangle(*setup, triangle, memory);
  auto& record = *reinterpret_cast<PrimitiveRecord*>(memory);
  record.shape = new (bins.allocate(sizeof(SmoothShape))) SmoothShape(smooth_triangle(*setup, triangle));
  record.scissored = true;
  smooth_parts.push_back(&record);
}

/// What comes next belongs to no polygon before it. choice: one that was cut, because it is longer than a batch, shows the
/// seam where it was cut.
void Renderer::Implementation::finish_polygons() {
  flush_triangles();
  if (smooth_parts.empty()) return;
  const auto count = static_cast<std::int32_t>(smooth_parts.size());
  if (count == 1) {
    bins.add_smooth(*smooth_parts[0]);
  } else {
    auto* const parts = static_cast<const PrimitiveRecord**>(bins.allocate(smooth_parts.size() * sizeof(PrimitiveRecord*)));
    std::ranges::copy(smooth_parts, parts);
    const PrimitiveRecord& first = *parts[0];
    auto& polygon = *new (bins.allocate(sizeof(SmoothPolygon))) SmoothPolygon{parts, count, first.x0, first.y0, first.x1, first.y1};
    for (const PrimitiveRecord* part : smooth_parts) {
      polygon.x0 = std::min(polygon.x0, part->x0);
      polygon.y0 = std::min(polygon.y0, part->y0);
      polygon.x1 = std::max(polygon.x1, part->x1);
      polygon.y1 = std::max(polygon.y1, part->y1);
    }
    bins.add_smooth(polygon);
  }
  smooth_parts.clear();
}

/// A triangle whose pixels another method than the default finds, or whose vertices a pass wants to see.
void Renderer::Implementation::add_method_triangle(const WaitingTriangle& triangle, const AssembledTriangle& assembled_triangle) {
  const std::size_t bytes = waiting_size(*setup, false);
  auto* const copy = static_cast<std::byte*>(bins.allocate(bytes));
  std::memcpy(copy, &triangle, bytes);
  const auto& kept_triangle = *reinterpret_cast<const WaitingTriangle*>(copy);
  auto* memory = static_cast<std::byte*>(bins.allocate(record_size(*setup)));
  set_up_triangle(*setup, kept_triangle, memory);
  auto& record = *reinterpret_cast<PrimitiveRecord*>(memory);
  record.scissored = true;
  auto* const shape =
      new (bins.allocate(sizeof(MethodTriangle))) MethodTriangle(method_triangle(*setup, kept_triangle, methods, record));
  if (gathers) set_ray_corners(viewport, vertices, assembled_triangle, *shape);
  record.shape = shape;
  add_shape(record);
}

void Renderer::Implementation::add_shape(const PrimitiveRecord& record) {
  if (!gathers) return bins.add_smooth(record);
  const CompareFunc func = record.binding->state.depth.func;
  gathered.add(record, bins.selected_sample(), func == CompareFunc::less || func == CompareFunc::lequal);
}

/// What was gathered goes to the bins, before anything else does.
void Renderer::Implementation::give_gathered() {
  if (gathered.empty()) return;
  const std::int32_t sample = bins.selected_sample();
  gathered.give_to(bins, gathered_for);
  bins.select_sample(sample);
}

/// Polygon modes [GL1.5 §3.5.4]: the face decides between filling, the boundary edges and their vertices.
/// choice: edges 2-0, 0-1, 1-2, as Mesa (MESA-RULES 5.5): a polygon's fan then gives the polygon's edges in order.
void Renderer::Implementation::draw_unfilled(const AssembledTriangle& triangle, bool front) {
  if (is_culled(setup->cull, front)) return;
  const PolygonMode mode = front ? mode_front : mode_back;
  if (mode == PolygonMode::fill) return draw_triangle(triangle);
  finish_polygons();
  const bool back = !front;
  const bool offset = mode == PolygonMode::line ? setup->polygons.offset_line : setup->polygons.offset_point;
  const double depth_offset = offset ? pipeline::depth_offset(*setup, vertices, triangle) : 0.0;
  if (!triangle.continues) stipple_count = 0;
  const std::size_t first = mode == PolygonMode::line ? 2 : 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (first + i) % 3;
    if ((triangle.edges >> k & 1) == 0) continue;
    const std::uint16_t from = triangle.vertex[k], to = triangle.vertex[(k + 1) % 3];
    if (mode == PolygonMode::line) {
      draw_clipped_line({{from, to}, triangle.provoking, back, depth_offset});
    } else {
      draw_point({from, triangle.provoking, back, depth_offset});
    }
  }
}

void Renderer::Implementation::clip_and_draw(const AssembledTriangle& triangle) {
  const auto outcode = [&](std::size_t i) { return vertices.outcode[triangle.vertex[i]]; };
  if ((outcode(0) & outcode(1) & outcode(2)) != 0) return;
  if (methods.leaves_viewport() && draw_unclipped(triangle)) return;
  if (vertices.count + max_clip_vertices > processed_stride) {
    flush_triangles();
    vertices.count = batch_count;
  }
  clipped.clear();
  const std::int32_t first_new = vertices.count;
  clip_triangle(triangle, viewport, clip_attributes, vertices, clipped);
  if (methods.colors == InterpolationMethod::affine) forget_distances(first_new, vertices);
  double area = 0.0;
  for (std::size_t i = 0; unfilled && i < clipped.size(); ++i) area += front_area(*setup, vertices, clipped[i]);
  for (const AssembledTriangle& part : clipped) unfilled ? draw_unfilled(part, area > 0.0) : draw_triangle(part);
}

void Renderer::Implementation::draw_line(AssembledLine line) {
  const std::int32_t count = vertices.count;
  const unsigned outcodes = vertices.outcode[line.vertex[0]] | vertices.outcode[line.vertex[1]];
  if (outcodes == 0) {
    draw_clipped_line(line);
  } else {
    const AssembledLine whole = line;
    const StippleCount before = stipple_count;
    const LineSpan span = stippled() ? unclipped_span(viewport, vertices, whole) : LineSpan{};
    if (clip_line(line, viewport, clip_attributes, vertices)) {
      if (methods.colors == InterpolationMethod::affine) forget_distances(count, vertices);
      stipple_count += span.fragments_to(vertices.window[line.vertex[0]]);
      draw_clipped_line(line);
    }
    stipple_count = before + span.fragments();
  }
  vertices.count = count;
}

/// A line inside the clip volume.
void Renderer::Implementation::draw_clipped_line(const AssembledLine& line) {
  if (setup->lines.smooth) return draw_smooth_line(line);
  if (plain_lines && line.depth_offset == 0) {
    WaitingLine waiting;
    const LinePixels found = select_line(*setup, vertices, line, waiting);
    if (found == LinePixels::edges) return bins.add_line(waiting);
    if (found == LinePixels::none) return;
  }
  const std::size_t bytes = record_size(*setup);
  void* memory = bins.allocate(bytes);
  const auto& record = *static_cast<PrimitiveRecord*>(memory);
  pixels.clear();
  if (methods.walks_lines() && setup->lines.width_px == 1.0f && !stippled()) return walk_line_by_method(line, memory);
  switch (setup_line(*setup, vertices, line, stipple_count, memory, pixels)) {
    case LinePixels::none: bins.take_back(bytes); break;
    case LinePixels::edges: bins.add_polygon(record); break;
    case LinePixels::list: bins.add_pixels(record, pixels, setup->scissor); break;
  }
}

/// The record is the default's, the pixels are the method's.
void Renderer::Implementation::walk_line_by_method(const AssembledLine& line, void* memory) {
  if (setup_line(*setup, vertices, line, stipple_count, memory, pixels) == LinePixels::none) return bins.take_back(record_size(*setup));
  const auto position = [&](std::size_t i) {
    const WindowVertex& vertex = vertices.window[line.vertex[i]];
    return Point2{vertex.x, static_cast<double>(setup->target_height_px) - vertex.y_raster};
  };
  pixels.clear();
  walk_line(methods.lines, position(0), position(1), pixels);
  bins.add_pixels(*static_cast<const PrimitiveRecord*>(memory), pixels, setup->scissor);
}

/// Whole, or the stretches of unit rectangles that the stipple keeps [GL1.5 §3.4.2].
/// choice: neighbours make one rectangle, as they do without a stipple.
void Renderer::Implementation::draw_smooth_line(const AssembledLine& line) {
  const auto draw_stretch = [&](double begin, double end) {
    auto* shape = new (bins.allocate(sizeof(SmoothShape))) SmoothShape;
    void* memory = bins.allocate(record_size(*setup));
    if (setup_smooth_line(*setup, vertices, line, begin, end, memory, *shape)) {
      bins.add_smooth(*static_cast<PrimitiveRecord*>(memory));
    }
  };
  const double length = length_of(vertices, line);
  if (!stippled()) return draw_stretch(0.0, length);
  const auto rectangles = static_cast<StippleCount>(std::ceil(length));
  for (StippleCount i = 0; i < rectangles;) {
    StippleCount end = i;
    while (end < rectangles && stipple_keeps(setup->lines, stipple_count + end)) ++end;
    if (end > i) draw_stretch(static_cast<double>(i), std::min(static_cast<double>(end), length));
    i = end + 1;
  }
  stipple_count += rectangles;
}

void Renderer::Implementation::draw_point(const AssembledPoint& point) {
  if (vertices.outcode[point.vertex] != 0) return;
  if (plain_points && point.depth_offset == 0) {
    WaitingPoint waiting;
    if (select_point(*setup, vertices, point, waiting)) bins.add_point(*setup, waiting);
    return;
  }
  const auto& eye = vertices.position_eye;
  const float size_px = derived_point_size(setup->points, eye[0][point.vertex], eye[1][point.vertex], eye[2][point.vertex]);
  auto* shape = has_shape(*setup) ? new (bins.allocate(sizeof(SmoothShape))) SmoothShape : nullptr;
  const std::size_t bytes = record_size(*setup);
  void* memory = bins.allocate(bytes);
  if (!setup_point(*setup, vertices, point, size_px, memory, shape)) return bins.take_back(bytes);
  const auto& record = *static_cast<PrimitiveRecord*>(memory);
  shape != nullptr ? bins.add_smooth(record) : bins.add_polygon(record);
}

/// Of the primitives that begin with this vertex, where fragments are lit.
void Renderer::Implementation::select_material(const VertexBatch& batch, const PrimitiveRange& range) {
  const std::int32_t first = range.indexed ? batch.elements[static_cast<std::size_t>(range.first)] : range.first;
  const MaterialRun* run = nullptr;
  for (const MaterialRun& next : batch.material_runs) {
    if (next.first <= first) run = &next;
  }
  if (run == nullptr || setup->binding->method->lighting.material == run->material) return;
  RasterBinding binding = *setup->binding;
  auto* const method = new (bins.allocate(sizeof(MethodState))) MethodState(*binding.method);
  method->lighting.material = run->material;
  binding.method = method;
  setup = bins.intern(*setup, binding);
}

/// In order, to the sample that is selected.
void Renderer::Implementation::draw_primitives(const DrawState& state, const VertexBatch& batch) {
  smooth_parts.clear();
  shared = {};
  const bool lasting_diagonal = unfilled || state.assembly.shade_model == ShadeModel::flat || state.raster.polygon_stipple.enabled;
  for (std::size_t i = 0; i < batch.primitives.size(); ++i) {
    const PrimitiveRange& range = batch.primitives[i];
    if (phong && !batch.material_runs.empty()) select_material(batch, range);
    if (range.mode == PrimitiveMode::quads && (i == 0 || batch.primitives[i - 1].mode != PrimitiveMode::quads)) {
      clipped_quads = (clipped_quads && !range.begins) || are_quads_clipped(batch, vertices, i);
    }
    const bool other_diagonal = lasting_diagonal || clipped_quads || range.indexed || range.from_list;
    assembled.triangles.clear();
    assembled.lines.clear();
    assembled.points.clear();
    assemble(range, other_diagonal ? QuadDiagonal::from_1_to_3 : QuadDiagonal::from_0_to_2, assembled);
    if (range.indexed) resolve_elements(batch.elements.data() + range.first, assembled);
    if (unfilled) apply_edge_flags(range, batch.edge_flag.data(), assembled.triangles);
    draw_range_of_triangles(range);
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

/// Where the samples of a pixel lie, in pixels from its lower left corner: each in a row and a column of its own,
/// where Mesa has them in framebuffer objects.
constexpr std::array<std::array<float, 2>, max_samples> sample_positions{
    {{0.375f, 0.125f}, {0.875f, 0.375f}, {0.125f, 0.625f}, {0.625f, 0.875f}}};

/// Every sample is a picture of its own [GL1.5 §3.2.1]: what is drawn is moved so that the sample stands where a pixel
/// has its centre, and drawn as ever. So coverage, depth and colours are those of the sample's own place, and no stage
/// after this one knows of samples.
void Renderer::Implementation::draw_samples(const DrawState& state, const VertexBatch& batch) {
  const StippleCount stipple_before = stipple_count;
  for (std::size_t sample = 0; sample < static_cast<std::size_t>(bins.target()->samples); ++sample) {
    if (!hidden && (state.multisample.sample_mask >> sample & 1) == 0) continue;
    bins.select_sample(static_cast<std::int32_t>(sample));
    if (hidden) {
      const auto [x, y] = sample_position(antialiasing, sample);
      viewport.sample_shift_x = 0.5f - x;
      viewport.sample_shift_y = 0.5f - y;
    }
    if (state.multisample.enabled) {
      viewport.sample_shift_x = 0.5f - sample_positions[sample][0];
      viewport.sample_shift_y = 0.5f - sample_positions[sample][1];
    }
    vertices.count = batch_count;
    project(state);
    stipple_count = stipple_before;
    draw_primitives(state, batch);
  }
  bins.select_sample(0);
}

/// Draws into a hidden target from now on, if the method has samples. Without memory for it there is one sample.
/// choice: targets that have several samples by themselves are drawn into as they are.
void Renderer::Implementation::use_samples() {
  hidden.reset();
  bins.set_target(target);
  const int count = samples_of(antialiasing);
  if (target == nullptr || count == 1 || target->samples > 1) return;
  try {
    hidden = make_sampled(*target, count);
    bins.set_target(&*hidden);
    load_samples(*target, *hidden);
  } catch (const std::bad_alloc&) {
    hidden.reset();
    bins.set_target(target);
  }
}

/// The accumulation buffer is the program's target's [GL1.5 §4.2.4]: it adds up what has been resolved.
void Renderer::Implementation::accumulate_resolved(const AccumState& state) {
  finish();
  bins.set_target(target);
  bins.add_accum(state);
  bins.run();
  bins.set_target(&*hidden);
  load_samples(*target, *hidden);
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
  if (const Framebuffer* target = this->target(); observer != nullptr && target != nullptr) {
    observer->target_changed(target->width_px, target->height_px, depth_bits(target->depth_format), target->stencil_bits);
  }
}

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
  if (self.observer != nullptr) self.observer->draw(state, batch);
  if (!plan.draws) return;

  const VaryingLayout varyings = make_varying_layout(state, plan, batch);
  self.prepare(state, plan, varyings);
  self.dirty = true;

  // Vertices, then primitives in order.
  self.run_vertex_stages(state, plan, varyings, batch);
  self.batch_count = batch.count;
  self.bins.target()->samples > 1 ? self.draw_samples(state, batch) : self.draw_primitives(state, batch);
  if (self.bins.full()) self.run_bins();
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

/// What the fragments of a bitmap or pixel rectangle need of the stages after the vertices: a vertex of their own.
void Renderer::Implementation::prepare_fragments(const PixelDraw& draw, const FragmentSource& source, const PlacedImage* image) {
  if (source_vertex == nullptr) source_vertex = std::make_unique<VertexBatch>();
  fill_batch(source, *source_vertex);
  const VaryingLayout varyings = make_varying_layout(draw.state, draw.plan, *source_vertex);
  prepare(draw.state, draw.plan, varyings, image);
  run_vertex_stages(draw.state, draw.plan, varyings, *source_vertex);
  vertices.window[0] = {0.0f, 0.0f, source.depth, 1.0f};
}

PrimitiveRecord& Renderer::Implementation::bitmap_record(const PixelDraw& draw, const FragmentSource& source) {
  const bool same = last_bitmap.record != nullptr && draw.version == last_bitmap.version &&
                    bins.generation() == last_bitmap.generation && source == last_bitmap.source;
  if (!same) {
    prepare_fragments(draw, source, nullptr);
    void* const memory = bins.allocate(record_size(*setup));
    last_bitmap = {&setup_fragments(*setup, vertices, draw.state.raster.scissor, memory), source, draw.version, bins.generation()};
  }
  return *last_bitmap.record;
}

/// Calls add() for every sample that is drawn: all get the pixel's fragment.
template <class Add>
void Renderer::Implementation::add_to_samples(const DrawState& state, Add add) {
  for (std::int32_t sample = 0; sample < bins.target()->samples; ++sample) {
    if (!hidden && bins.target()->samples > 1 && (state.multisample.sample_mask >> sample & 1) == 0) continue;
    bins.select_sample(sample);
    add();
  }
  bins.select_sample(0);
}

/// The image and its tables, in memory that lasts until the bins have run.
PlacedImage* Renderer::Implementation::keep_image(const PixelRectangle& rectangle, const PlacedRectangle& placed) {
  const PixelImage& image = *rectangle.image;
  auto* const result = new (bins.allocate(sizeof(PlacedImage))) PlacedImage;
  const auto width = static_cast<std::size_t>(image.width_px);
  result->format = image.format;
  kept_image_bytes += width * static_cast<std::size_t>(image.height_px) * bytes_per_pixel(image.format);
  if (image.format == PixelImageFormat::depth) {
    const std::shared_ptr<const float[]> units = depths_in_units(image, bins.target()->depth_format);
    result->pixels = reinterpret_cast<const std::byte*>(units.get());
    result->row_bytes = static_cast<std::ptrdiff_t>(width * sizeof(float));
    kept.push_back(units);
  } else {
    result->pixels = image.first_row;
    result->row_bytes = image.row_bytes;
    kept.push_back(rectangle.image);
  }
  const auto table = [&](const AxisMap& axis, std::int32_t& begin) -> const std::int32_t* {
    begin = axis.begin - (axis.source.empty() ? axis.first_source : 0);
    if (axis.source.empty()) return nullptr;
    auto* const copy = static_cast<std::int32_t*>(bins.allocate(axis.source.size() * sizeof(std::int32_t)));
    std::copy(axis.source.begin(), axis.source.end(), copy);
    return copy;
  };
  result->column = table(placed.columns, result->x0);
  result->row = table(placed.rows, result->y0);
  return result;
}

void Renderer::draw_rectangle(const PixelDraw& draw, const FragmentSource& source, const PixelRectangle& rectangle) {
  Implementation& self = *implementation_;
  if (target() == nullptr) return;
  const IeeeFloats floats;
  if (self.observer != nullptr) self.observer->rectangle(draw.state, source, rectangle);
  const PixelImage& image = *rectangle.image;
  const PlacedRectangle placed = place(rectangle, image.width_px, image.height_px, draw.state.raster.scissor);
  if (!draw.plan.draws || placed.empty()) return;

  self.dirty = true;
  if (is_plain(draw.plan, *target(), image, placed)) {
    self.run_bins();
    return write_colors(*target(), image, placed);
  }
  self.prepare_fragments(draw, source, self.keep_image(rectangle, placed));
  const PixelRect box{placed.columns.begin, placed.rows.begin, placed.columns.end, placed.rows.end};
  PrimitiveRecord& record = setup_fragments(*self.setup, self.vertices, box, self.bins.allocate(record_size(*self.setup)));
  if (image.format == PixelImageFormat::depth) {
    record.depth.steep = true;
  } else if (draw.plan.colors) {
    ColorRecord& color = reinterpret_cast<ColoredPrimitive&>(record).color;
    color.variation = ColorVariation::image;
    color.base[0] = self.setup->targets.color_scale;
  }
  try {
    self.add_to_samples(draw.state, [&] { self.bins.add_polygon(record); });
  } catch (...) {  // no memory; what refers to the image must not outlive this call
    if (image.borrowed()) self.run_bins();
    throw;
  }
  if (self.bins.full() || self.kept_image_bytes > image_bytes_limit || image.borrowed()) self.run_bins();
}

void Renderer::draw_bitmap(const PixelDraw& draw, const FragmentSource& source, const Bitmap& bitmap) {
  Implementation& self = *implementation_;
  if (target() == nullptr) return;
  const IeeeFloats floats;
  if (self.observer != nullptr) self.observer->bitmap(draw.state, source, bitmap);
  if (!draw.plan.draws) return;
  const PrimitiveRecord& record = self.bitmap_record(draw, source);
  self.dirty = true;
  self.add_to_samples(draw.state, [&] { self.bins.add_bitmap(record, bitmap); });
  if (self.bins.full()) self.run_bins();
}

void Renderer::write_rectangle(const DirectRectangle& rectangle) {
  if (target() == nullptr) return;
  const IeeeFloats floats;
  finish();
  implementation_->dirty = true;
  for (int sample = 0; sample < target()->samples; ++sample) {
    pipeline::write_rectangle(target()->samples > 1 ? target()->sample(sample) : *target(), rectangle);
  }
  target_changed();
}

void Renderer::clear(const ClearState& state) {
  if (target() == nullptr) return;
  if (implementation_->observer != nullptr) implementation_->observer->clear(state);
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
