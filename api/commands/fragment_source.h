// From the current raster position to the pipeline: what DrawPixels, CopyPixels and Bitmap share [GL1.5 §2.13].
#pragma once

#include "api/context/context.h"
#include "pipeline/draw/pixel_draws.h"

namespace gouraud::api {

inline pipeline::FragmentSource fragment_source(const Context& context) {
  const RasterPosition& raster = context.state.current.raster;
  const float depth = raster.position_window.z;
  return {context.draws_reversed_depth() ? 1.0f - depth : depth, raster.distance, raster.color, raster.secondary_color, raster.texture_coordinates};
}

inline void draw_bitmap(Context& context, const pipeline::Bitmap& bitmap) {
  context.renderer().draw_bitmap(context.pixel_draw(), fragment_source(context), bitmap);
}

inline void draw_rectangle(Context& context, const pipeline::PixelRectangle& rectangle) {
  context.renderer().draw_rectangle(context.pixel_draw(), fragment_source(context), rectangle);
}

}  // namespace gouraud::api
