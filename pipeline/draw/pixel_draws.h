// The steps of bitmaps and pixel rectangles that stand between the renderer's door and its bins [GL1.5 §3.6.4, §3.7].
#pragma once

#include <cstdint>
#include <memory>

#include "pipeline/draw/draw_state.h"
#include "pipeline/draw/plan.h"
#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/geometry/vertex_batch.h"
#include "pipeline/raster/pixel_image.h"
#include "pipeline/raster/pixel_rectangle.h"

namespace gouraud::pipeline {

/// What bitmaps and pixel rectangles are drawn with.
struct PixelDraw {
  DrawState state{};           ///< a pixel_draw_state
  Plan plan{};                 ///< make_plan of it
  std::uint64_t version = 0;   ///< another one for other contents
};

/// The state under which bitmaps and pixel rectangles are drawn while `state` holds: fragments as always, but a single
/// vertex, whose colour, texture coordinates and fog coordinate are those of a FragmentSource as they are.
DrawState pixel_draw_state(const DrawState& state);

/// The only vertex of such a draw.
void fill_batch(const FragmentSource& source, VertexBatch& batch);

void write_rectangle(const Framebuffer& target, const DirectRectangle& rectangle);

/// A rectangle's pixels in the window, cut to `clip`.
struct PlacedRectangle {
  AxisMap columns, rows;
  bool empty() const { return columns.empty() || rows.empty(); }
};
PlacedRectangle place(const PixelRectangle& rectangle, std::int32_t width_px, std::int32_t height_px, const PixelRect& clip);

/// Whether the image's bytes are the target's, and so many that it pays to write them past the tiles: behind all that waits
/// there.
bool is_plain(const Plan& plan, const Framebuffer& target, const PixelImage& image, const PlacedRectangle& placed);
void write_colors(const Framebuffer& target, const PixelImage& image, const PlacedRectangle& placed);

/// An image of depths in the units of the target's depth buffer.
std::shared_ptr<const float[]> depths_in_units(const PixelImage& image, DepthFormat format);

}  // namespace gouraud::pipeline
