// Bitmaps and pixel rectangles to the tile bins, or straight to the target [GL1.5 §3.6.4, §3.7].
#include "pipeline/draw/renderer_implementation.h"

#include <algorithm>
#include <new>
#include <utility>

#include "pipeline/framebuffer/blit.h"

namespace gouraud::pipeline {
namespace {

/// So much memory of images may wait for the tiles. No more than stays in a cache and in the allocator's hands: ten images
/// of a whole screen, 8 MiB each, take 66 ms if all of them wait, in pages that the system makes and takes back.
constexpr std::size_t image_bytes_limit = std::size_t{1} << 20;

}  // namespace

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

/// Calls add() for all samples that are drawn, or for each: all get the pixel's fragment.
template <class Add>
void Renderer::Implementation::add_to_samples(const DrawState& state, const PrimitiveRecord& record, Add add) {
  const bool at_once = record.binding->sample_mask != 0;
  if (at_once) {
    bins.select_sample(TileBins::all_samples);
    add();
  }
  for (std::int32_t sample = 0; !at_once && sample < bins.target()->samples; ++sample) {
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
    self.add_to_samples(draw.state, record, [&] { self.bins.add_polygon(record); });
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
  self.add_to_samples(draw.state, record, [&] { self.bins.add_bitmap(record, bitmap); });
  if (self.bins.full()) self.run_bins();
}

void Renderer::write_rectangle(const DirectRectangle& rectangle) {
  if (target() == nullptr) return;
  const IeeeFloats floats;
  finish();
  if (implementation_->observer != nullptr) implementation_->observer->write(rectangle);
  implementation_->dirty = true;
  for (int sample = 0; sample < target()->samples; ++sample) {
    pipeline::write_rectangle(target()->samples > 1 ? target()->sample(sample) : *target(), rectangle);
  }
  target_changed();
}

void Renderer::blit(const Framebuffer& source, const Blit& blit) {
  if (target() == nullptr) return;
  finish();
  if (implementation_->observer != nullptr) implementation_->observer->blit(source, blit);
  implementation_->dirty = true;
  pipeline::blit(source, *target(), blit);
  target_changed();
}

}  // namespace gouraud::pipeline
