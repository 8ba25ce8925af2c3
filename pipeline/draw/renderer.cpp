// The one page: the way of a batch from object space to the tile bins. One call a stage; data passed explicitly.
#include "pipeline/draw/renderer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <thread>
#include <utility>
#include <vector>

#if defined(__linux__)
#include <sched.h>
#endif

#include "pipeline/draw/tiles.h"
#include "pipeline/fragment/color_write.h"
#include "pipeline/geometry/assembly.h"
#include "pipeline/geometry/clipping.h"
#include "pipeline/geometry/colors.h"
#include "pipeline/geometry/lighting.h"
#include "pipeline/geometry/normals.h"
#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/geometry/transform.h"
#include "pipeline/geometry/viewport.h"
#include "pipeline/raster/setup.h"

namespace gouraud::pipeline {
namespace {

int depth_bits(DepthFormat format) {
  switch (format) {
    case DepthFormat::none: return 0;
    case DepthFormat::z16: return 16;
    case DepthFormat::z24s8: return 24;
    case DepthFormat::z32f: return 32;
  }
  return 0;
}

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

SetupState make_setup_state(const DrawState& state, const Plan& plan, const Framebuffer& target) {
  SetupState setup;
  setup.scissor = state.raster.scissor;
  setup.target_height_px = state.viewport.target_height_px;
  setup.front_face = state.assembly.front_face;
  setup.cull = state.assembly.cull;
  setup.flat = state.assembly.shade_model == ShadeModel::flat;
  setup.colors = plan.colors;
  setup.two_sided = plan.lighting && state.lighting.two_sided;
  setup.separate_specular = plan.lighting && state.lighting.separate_specular;
  setup.targets = {depth_scale(target.depth_format), target.depth_format == DepthFormat::z32f, color_scale(target.color_format)};
  return setup;
}

}  // namespace

struct Renderer::Implementation {
  explicit Implementation(int thread_count) : bins(thread_count) {}

  void run_vertex_stages(const DrawState& state, const Plan& plan, const VertexBatch& batch);
  void draw_triangle(const AssembledTriangle& triangle);
  void flush_triangles();
  void draw_unfilled(const AssembledTriangle& triangle);
  void draw_line(AssembledLine line);
  void draw_point(const AssembledPoint& point);
  void clip_and_draw(const AssembledTriangle& triangle);
  /// Rasterizes what is pending.
  void run_bins() {
    bins.run();
    kept.clear();
  }
  void emit(const AssembledTriangle& triangle) { unfilled ? draw_unfilled(triangle) : draw_triangle(triangle); }

  TileBins bins;
  std::vector<std::shared_ptr<const void>> kept;  ///< until the bins have run
  DrawObserver* observer = nullptr;
  bool dirty = false;

  // Of the batch being drawn.
  const SetupState* setup = nullptr;
  ViewportState viewport;
  PolygonMode mode_front = PolygonMode::fill, mode_back = PolygonMode::fill;
  bool unfilled = false;
  ClipAttributes clip_attributes;
  AssembledPrimitives assembled;
  std::vector<AssembledTriangle> clipped;
  std::vector<AssembledTriangle> ready;  ///< wait for setup, which takes several at a time
  std::int32_t batch_count = 0;          ///< vertices beyond are the clipper's
  std::vector<PixelPosition> pixels;
  ProcessedVertices vertices;
};

void Renderer::Implementation::run_vertex_stages(const DrawState& state, const Plan& plan, const VertexBatch& batch) {
  transform_to_clip(state.transform, batch, vertices);
  if (plan.eye_positions) transform_to_eye(state.transform, batch, vertices);
  if (plan.normals) transform_normals(state.transform, batch, vertices);
  if (plan.lighting) light_vertices(state.lighting, batch, vertices);
  if (plan.vertex_colors) clamp_vertex_colors(batch, vertices);
  project_to_window(state.viewport, vertices);
}

void Renderer::Implementation::draw_triangle(const AssembledTriangle& triangle) {
  ready.push_back(triangle);
  if (ready.size() == setup_batch) flush_triangles();
}

void Renderer::Implementation::flush_triangles() {
  if (ready.empty()) return;
  auto* waiting = static_cast<WaitingTriangle*>(bins.allocate(ready.size() * sizeof(WaitingTriangle)));
  const std::size_t selected = select_triangles(*setup, vertices, ready, waiting);
  bins.take_back((ready.size() - selected) * sizeof(WaitingTriangle));
  for (std::size_t i = 0; i < selected; ++i) bins.add_triangle(waiting[i]);
  ready.clear();
}

/// Polygon modes [GL1.5 §3.5.4]: the face decides between filling, the boundary edges and their vertices.
/// choice: edges 2-0, 0-1, 1-2, as Mesa (MESA-RULES 5.5): a polygon's fan then gives the polygon's edges in order.
void Renderer::Implementation::draw_unfilled(const AssembledTriangle& triangle) {
  const bool front = faces_front(*setup, vertices, triangle);
  if (is_culled(setup->cull, front)) return;
  const PolygonMode mode = front ? mode_front : mode_back;
  if (mode == PolygonMode::fill) return draw_triangle(triangle);
  flush_triangles();
  const bool back = setup->two_sided && !front;
  const std::size_t first = mode == PolygonMode::line ? 2 : 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (first + i) % 3;
    if ((triangle.edges >> k & 1) == 0) continue;
    const std::uint16_t from = triangle.vertex[k], to = triangle.vertex[(k + 1) % 3];
    if (mode == PolygonMode::line) {
      draw_line({{from, to}, triangle.provoking, back});
    } else {
      draw_point({from, triangle.provoking, back});
    }
  }
}

void Renderer::Implementation::clip_and_draw(const AssembledTriangle& triangle) {
  const auto outcode = [&](std::size_t i) { return vertices.outcode[triangle.vertex[i]]; };
  if ((outcode(0) & outcode(1) & outcode(2)) != 0) return;
  if (vertices.count + max_clip_vertices > processed_stride) {
    flush_triangles();
    vertices.count = batch_count;
  }
  clipped.clear();
  clip_triangle(triangle, viewport, clip_attributes, vertices, clipped);
  for (const AssembledTriangle& part : clipped) emit(part);
}

void Renderer::Implementation::draw_line(AssembledLine line) {
  const std::int32_t count = vertices.count;
  const unsigned outcodes = vertices.outcode[line.vertex[0]] | vertices.outcode[line.vertex[1]];
  if (outcodes == 0 || clip_line(line, viewport, clip_attributes, vertices)) {
    const std::size_t bytes = record_size(*setup);
    void* record = bins.allocate(bytes);
    pixels.clear();
    if (setup_line(*setup, vertices, line, record, pixels)) {
      bins.add_pixels(*static_cast<PrimitiveRecord*>(record), pixels, setup->scissor);
    } else {
      bins.take_back(bytes);
    }
  }
  vertices.count = count;
}

void Renderer::Implementation::draw_point(const AssembledPoint& point) {
  if (vertices.outcode[point.vertex] != 0) return;
  PixelPosition pixel;
  void* record = bins.allocate(record_size(*setup));
  if (setup_point(*setup, vertices, point, record, pixel)) {
    bins.add_pixels(*static_cast<PrimitiveRecord*>(record), {&pixel, 1}, setup->scissor);
  }
}

Renderer::Renderer(int thread_count) : implementation_(std::make_unique<Implementation>(thread_count)) {}
Renderer::~Renderer() = default;

Framebuffer* Renderer::target() const { return implementation_->bins.target(); }

void Renderer::set_target(Framebuffer* target) {
  finish();
  implementation_->bins.set_target(target);
  set_observer(implementation_->observer);
}

void Renderer::set_observer(DrawObserver* observer) {
  implementation_->observer = observer;
  if (const Framebuffer* target = this->target(); observer != nullptr && target != nullptr) {
    observer->target_changed(target->width_px, target->height_px, depth_bits(target->depth_format), target->stencil_bits);
  }
}

void Renderer::draw(const DrawState& state, const Plan& plan, const VertexBatch& batch) {
  Implementation& self = *implementation_;
  if (target() == nullptr) return;
  if (self.observer != nullptr) self.observer->draw(state, batch);
  if (!plan.draws) return;

  // What this draw needs of the stages after the vertices.
  self.setup = self.bins.intern(make_setup_state(state, plan, *target()), {state.raster, plan.fragment});
  self.viewport = state.viewport;
  self.mode_front = state.assembly.polygon_mode_front;
  self.mode_back = state.assembly.polygon_mode_back;
  self.unfilled = self.mode_front != PolygonMode::fill || self.mode_back != PolygonMode::fill;
  self.clip_attributes = {plan.eye_positions, plan.colors, self.setup->two_sided, self.setup->separate_specular};
  self.dirty = true;

  // Vertices, then primitives in order.
  self.run_vertex_stages(state, plan, batch);
  self.batch_count = batch.count;
  for (const PrimitiveRange& range : batch.primitives) {
    self.assembled.triangles.clear();
    self.assembled.lines.clear();
    self.assembled.points.clear();
    // choice: quads that are not filled are split like flat ones, as Mesa does: their edges then come in order.
    assemble(range, self.unfilled ? ShadeModel::flat : state.assembly.shade_model, self.assembled);
    for (const AssembledTriangle& triangle : self.assembled.triangles) {
      const auto& outcode = self.vertices.outcode;
      const unsigned outside = outcode[triangle.vertex[0]] | outcode[triangle.vertex[1]] | outcode[triangle.vertex[2]];
      if (outside == 0) {
        self.emit(triangle);
      } else {
        self.clip_and_draw(triangle);
      }
    }
    self.flush_triangles();
    for (const AssembledLine& line : self.assembled.lines) self.draw_line(line);
    for (const AssembledPoint& point : self.assembled.points) self.draw_point(point);
  }
  if (self.bins.full()) self.run_bins();
}

ProcessedVertex Renderer::process_vertex(const DrawState& state, const Plan& plan, const VertexBatch& batch) {
  Implementation& self = *implementation_;
  self.run_vertex_stages(state, plan, batch);
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
  return result;
}

void Renderer::clear(const ClearState& state) {
  if (target() == nullptr) return;
  if (implementation_->observer != nullptr) implementation_->observer->clear(state);
  implementation_->dirty = true;
  const bool stencil_in_depth = target()->stencil_bits > 0 && target()->depth_format == DepthFormat::z24s8;
  if (state.stencil && stencil_in_depth && (state.clear_stencil & state.stencil_write_mask) != 0) {
    target()->depth.use_stencil();
  }
  implementation_->bins.add_clear(state);
  if (implementation_->bins.full()) implementation_->run_bins();
}

void Renderer::keep(std::shared_ptr<const void> resource) {
  auto& kept = implementation_->kept;
  if (kept.empty() || kept.back() != resource) kept.push_back(std::move(resource));
}

void Renderer::finish() { implementation_->run_bins(); }

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
