#include "pipeline/draw/pixel_draws.h"

#include <vector>

#include "pipeline/fragment/color_write.h"
#include "pipeline/framebuffer/write.h"

namespace gouraud::pipeline {

DrawState pixel_draw_state(const DrawState& state) {
  DrawState result;
  result.viewport = state.viewport;
  result.viewport.depth_near = 0.0;
  result.viewport.depth_far = 1.0;
  result.color_sum = state.color_sum || (state.lighting.enabled && state.lighting.separate_specular);
  result.multisample = state.multisample;
  result.texture_coordinates.units = state.texture_coordinates.units;
  result.texturing = state.texturing;
  result.raster = state.raster;
  result.raster.polygon_stipple = {};
  if (result.raster.fog.mode != FogMode::none) result.raster.fog.from_coordinate = true;
  return result;
}

void fill_batch(const FragmentSource& source, VertexBatch& batch) {
  batch.clear();
  batch.count = 1;
  for (int c = 0; c < 4; ++c) {
    const auto k = static_cast<std::size_t>(c);
    batch.position_object[k][0] = c == 3 ? 1.0f : 0.0f;
    batch.color[k][0] = source.color[c];
    if (c < 3) batch.secondary_color[k][0] = source.secondary_color[c];
    for (std::size_t unit = 0; unit < source.texture_coordinates.size(); ++unit) {
      batch.texture_coordinates[unit][k][0] = source.texture_coordinates[unit][c];
    }
  }
  batch.fog_coordinate[0][0] = source.fog_coordinate;
  batch.primitives.push_back({PrimitiveMode::points, true, true, 0, 1});
}

PlacedRectangle place(const PixelRectangle& rectangle, std::int32_t width_px, std::int32_t height_px, const PixelRect& clip) {
  return {map_axis(rectangle.x, rectangle.zoom_x, rectangle.first_column, width_px, clip.x0, clip.x1),
          map_axis(rectangle.y, rectangle.zoom_y, rectangle.first_row, height_px, clip.y0, clip.y1)};
}

void write_rectangle(const Framebuffer& target, const DirectRectangle& rectangle) {
  const PlacedRectangle placed = place(rectangle.place, rectangle.width_px, rectangle.height_px, rectangle.clip);
  if (placed.empty()) return;
  const std::int32_t count = placed.columns.end - placed.columns.begin;
  std::vector<std::uint8_t> stencils(static_cast<std::size_t>(count));
  std::vector<double> depths(static_cast<std::size_t>(count));
  for (std::int32_t y = placed.rows.begin; y < placed.rows.end; ++y) {
    const auto row = static_cast<std::size_t>(placed.rows.source_of(y)) * static_cast<std::size_t>(rectangle.width_px);
    for (std::int32_t i = 0; i < count; ++i) {
      const std::size_t from = row + static_cast<std::size_t>(placed.columns.source_of(placed.columns.begin + i));
      stencils[static_cast<std::size_t>(i)] = rectangle.stencils[from];
      if (rectangle.depths != nullptr) depths[static_cast<std::size_t>(i)] = rectangle.depths[from];
    }
    write_stencil_row(target, placed.columns.begin, y, count, stencils.data(), rectangle.stencil_write_mask);
    if (rectangle.depths != nullptr) write_depth_row(target, placed.columns.begin, y, count, depths.data());
  }
}

bool is_plain(const Plan& plan, const Framebuffer& target, const PixelImage& image, const PlacedRectangle& placed) {
  const FragmentPasses& passes = plan.fragment;
  return image.format == PixelImageFormat::rgba8 && target.color_format == ColorFormat::rgba8 && target.samples == 1 &&
         passes.count == 1 && passes.pass[0] == color_write_pass(ColorFormat::rgba8, 0xF) && plan.colors &&
         placed.columns.source.empty() && placed.rows.source.empty() &&
         std::int64_t{image.width_px} * image.height_px >= many_pixels;
}

void write_colors(const Framebuffer& target, const PixelImage& image, const PlacedRectangle& placed) {
  const AxisMap &columns = placed.columns, &rows = placed.rows;
  write_color_rows(target, columns.begin, rows.begin, columns.end - columns.begin, rows.end - rows.begin,
                   image.row(rows.first_source) + std::ptrdiff_t{columns.first_source} * 4, image.row_bytes);
}

std::shared_ptr<const float[]> depths_in_units(const PixelImage& image, DepthFormat format) {
  const auto width = static_cast<std::size_t>(image.width_px);
  std::shared_ptr<float[]> units = std::make_shared_for_overwrite<float[]>(width * static_cast<std::size_t>(image.height_px));
  for (std::int32_t y = 0; y < image.height_px; ++y) {
    const auto* const depths = reinterpret_cast<const double*>(image.row(y));
    float* const out = units.get() + static_cast<std::size_t>(y) * width;
    for (std::size_t i = 0; i < width; ++i) out[i] = depth_in_units(depths[i], format);
  }
  return units;
}

}  // namespace gouraud::pipeline
