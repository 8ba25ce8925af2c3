// A look at what enters the pipeline: every draw, clear and blit, in order, as the pipeline gets it. The oracle is such an
// observer. Without one installed the pipeline tests a null pointer once a batch, and no kernel knows of it.
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/geometry/vertex_batch.h"
#include "pipeline/raster/pixel_image.h"

namespace gouraud::pipeline {

class DrawObserver {
 public:
  virtual ~DrawObserver() = default;
  /// What follows is drawn into this target; copies of it keep its planes alive. Nothing is pending for it.
  virtual void target_changed(const Framebuffer& target) = 0;
  virtual void draw(const DrawState& state, const VertexBatch& batch) = 0;
  virtual void clear(const ClearState& state) = 0;
  virtual void accumulate(const AccumState&) {}
  /// From a framebuffer to the target [ARB_framebuffer_object].
  virtual void blit(const Framebuffer& /*source*/, const Blit&) {}
  /// [GL1.5 §3.6.4, §3.7]; `state` is a pixel_draw_state.
  virtual void rectangle(const DrawState&, const FragmentSource&, const PixelRectangle&) {}
  virtual void bitmap(const DrawState&, const FragmentSource&, const Bitmap&) {}
  virtual void write(const DirectRectangle&) {}
};

}  // namespace gouraud::pipeline
