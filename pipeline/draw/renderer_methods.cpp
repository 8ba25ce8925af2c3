// What triangles and samples need whose steps are done by another method (methods.h).
#include "pipeline/draw/renderer_implementation.h"

#include <algorithm>
#include <cstring>
#include <new>

#include "pipeline/geometry/clipping_methods.h"
#include "pipeline/raster/homogeneous.h"
#include "pipeline/raster/method_triangle.h"

namespace gouraud::pipeline {

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

/// Of the primitives that begin with this vertex, where fragments are lit.
void Renderer::Implementation::select_material(const VertexBatch& batch, const PrimitiveRange& range) {
  const std::int32_t first = range.indexed ? batch.elements[static_cast<std::size_t>(range.first)] : range.first;
  const MaterialRun* run = nullptr;
  for (const MaterialRun& next : batch.material_runs) {
    if (next.first <= first) run = &next;
  }
  if (run == nullptr || setup->binding->method->lighting.material == run->material) return;
  auto* const method = new (bins.allocate(sizeof(MethodState))) MethodState(*setup->binding->method);
  method->lighting.material = run->material;
  const auto with_material = [&](const SetupState* before) {
    RasterBinding binding = *before->binding;
    binding.method = method;
    return bins.intern(*before, binding);
  };
  const bool alike = filled_setup == outlined_setup;
  filled_setup = with_material(filled_setup);
  setup = outlined_setup = alike ? filled_setup : with_material(outlined_setup);
}

/// What was gathered goes to the bins, before anything else does.
void Renderer::Implementation::give_gathered() {
  if (gathered.empty()) return;
  const std::int32_t sample = bins.selected_sample();
  gathered.give_to(bins, gathered_for);
  bins.select_sample(sample);
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

}  // namespace gouraud::pipeline
