// What a Renderer keeps between the stages, and the steps of a draw. renderer.cpp is the page that calls them; triangles,
// lines and points, bitmaps and images, and the methods have a file each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/draw/antialiasing.h"
#include "pipeline/draw/method_state.h"
#include "pipeline/draw/pixel_draws.h"
#include "pipeline/draw/renderer.h"
#include "pipeline/draw/sample_counter.h"
#include "pipeline/draw/tiles.h"
#include "pipeline/draw/varying_layout.h"
#include "pipeline/draw/visibility_methods.h"
#include "pipeline/geometry/assembly.h"
#include "pipeline/geometry/clipping.h"
#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/raster/setup.h"
#include "pipeline/raster/triangles.h"
#include "pipeline/simd/float_mode.h"

namespace gouraud::pipeline {

struct Renderer::Implementation {
  explicit Implementation(int thread_count) : bins(thread_count) {}

  void prepare(const DrawState& state, const Plan& plan, const VaryingLayout& varyings, const PlacedImage* image = nullptr);
  void project(const DrawState& state);
  void tell_of_vertex(const DrawState& state, const Plan& plan, const VertexBatch& batch);
  void set_passes(const DrawState& state, const Plan& plan, const FragmentPasses& passes, RasterBinding& binding);
  void run_vertex_stages(const DrawState& state, const Plan& plan, const VaryingLayout& varyings, const VertexBatch& batch);
  QuadSplit split_of(const DrawState& state, const VertexBatch& batch, std::size_t i);
  PrimitiveRange assemble_ranges(const DrawState& state, const VertexBatch& batch, std::size_t& i);
  void draw_primitives(const DrawState& state, const VertexBatch& batch);
  void select_material(const VertexBatch& batch, const PrimitiveRange& range);
  void draw_samples(const DrawState& state, const VertexBatch& batch);
  void draw_each_sample(const DrawState& state, const VertexBatch& batch);
  void draw_range_of_triangles(const PrimitiveRange& range);
  SharedVertices share_vertices(const PrimitiveRange& range);
  void draw_triangle(const AssembledTriangle& triangle);
  void flush_triangles();
  void select_and_add(std::span<const AssembledTriangle> triangles, SharedVertices of_range);
  void set_up_smooth_part(const WaitingTriangle& triangle);
  void finish_polygons();
  void add_smooth_polygon();
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
  template <class DrawStretch>
  void draw_stretches(const AssembledLine& line, DrawStretch draw_stretch);
  void draw_smooth_line(const AssembledLine& line);
  void draw_sampled_line(const AssembledLine& line);
  void draw_point(const AssembledPoint& point);
  bool stippled() const { return setup->lines.stipple_pattern != 0xFFFF; }
  void clip_and_draw(const AssembledTriangle& triangle);
  void prepare_fragments(const PixelDraw& draw, const FragmentSource& source, const PlacedImage* image);
  template <class Add>
  void add_to_samples(const DrawState& state, const PrimitiveRecord& record, Add add);
  PlacedImage* keep_image(const PixelRectangle& rectangle, const PlacedRectangle& placed);
  PrimitiveRecord& bitmap_record(const PixelDraw& draw, const FragmentSource& source);
  void use_samples();
  void accumulate_resolved(const AccumState& state);
  void finish();
  /// Rasterizes what is pending.
  void run_bins() {
    add_smooth_polygon();
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
  Watch watch;
  std::int64_t watched_vertices = 0, watched_draws = 0;  ///< since colours were cleared
  PrimitiveReceiver* receiver = nullptr;
  bool dirty = false;

  // Of the batch being drawn.
  const SetupState *setup = nullptr, *filled_setup = nullptr, *outlined_setup = nullptr;
  ViewportState viewport;
  PolygonMode mode_front = PolygonMode::fill, mode_back = PolygonMode::fill;
  bool samples_at_once = false;  ///< what is drawn goes into all samples
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
  std::vector<const PrimitiveRecord*> smooth_parts;  ///< of the smooth polygon that is being drawn; in the bins' memory
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

}  // namespace gouraud::pipeline
