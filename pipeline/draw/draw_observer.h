// A look at what enters the pipeline: every draw and clear, in order, as the pipeline gets it. The oracle is such an
// observer. Without one installed the pipeline tests a null pointer once a batch, and no kernel knows of it.
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/vertex_batch.h"
#include "pipeline/raster/pixel_image.h"

namespace gouraud::pipeline {

class DrawObserver {
 public:
  virtual ~DrawObserver() = default;
  /// A new target of this size begins, all zero (colour, depth and stencil), with this many depth bits (0, 16, 24).
  virtual void target_changed(int width_px, int height_px, int depth_bits, int stencil_bits) = 0;
  virtual void draw(const DrawState& state, const VertexBatch& batch) = 0;
  virtual void clear(const ClearState& state) = 0;
  virtual void accumulate(const AccumState&) {}
  /// [GL1.5 §3.6.4, §3.7]; `state` is a pixel_draw_state.
  virtual void rectangle(const DrawState&, const FragmentSource&, const PixelRectangle&) {}
  virtual void bitmap(const DrawState&, const FragmentSource&, const Bitmap&) {}
};

}  // namespace gouraud::pipeline
