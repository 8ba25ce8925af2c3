// The pipeline's front door: draws and clears go in, pixels of the target come out.
//
// Geometry runs at once, on the calling thread; its triangles, lines and points wait in tile bins. Tiles are rasterized
// at finish(), or earlier when enough work is waiting. A Renderer belongs to one thread at a time.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "pipeline/draw/draw_observer.h"
#include "pipeline/draw/draw_state.h"
#include "pipeline/draw/pixel_draws.h"
#include "pipeline/draw/plan.h"
#include "pipeline/draw/primitive_report.h"
#include "pipeline/draw/watch.h"
#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/geometry/vertex_batch.h"

namespace gouraud::pipeline {

/// A vertex as rasterization would get it.
struct ProcessedVertex {
  bool inside = false;        ///< of the clip volume; nothing below is valid otherwise
  glm::vec3 position_window{0.0f};  ///< y up, z in [0, 1]
  float w_clip = 1.0f;
  float eye_distance = 0.0f;  ///< if the state's report asks for eye positions
  /// Of the units that the report asks for; (0, 0, 0, 1) of others.
  std::array<glm::vec4, max_texture_units> texture_coordinates{};
  glm::vec4 color{0.0f}, specular{0.0f};  ///< of the front face, clamped; specular is black unless it is separate
};

class SampleCounter;  // pipeline/draw/sample_counter.h

class Renderer {
 public:
  /// `thread_count` >= 1 counts the calling thread: with 1 no thread is ever made.
  explicit Renderer(int thread_count);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Draws into `target` from now on (null: nothing is drawn), after finishing what is pending for the old one.
  /// `target` stays the caller's and must outlive its use here.
  void set_target(Framebuffer* target);
  Framebuffer* target() const;

  /// Draws into many samples from now on, after finishing what is pending, and shows their mean.
  void set_antialiasing(AntialiasingMethod method);
  /// Others than the renderer have written to the target.
  void target_changed();

  /// Draws the batch's primitives. `plan` is make_plan(state, target format) and may be shared by draws of equal state.
  void draw(const DrawState& state, const Plan& plan, const VertexBatch& batch);
  void clear(const ClearState& state);
  /// Needs a target with an accumulation buffer [GL1.5 §4.2.4].
  void accumulate(const AccumState& state);
  /// Draws whose state counts samples add to this counter from now on. Null: there are none.
  void count_samples(std::shared_ptr<SampleCounter> counter);

  /// Bitmaps and pixel rectangles [GL1.5 §3.6.4, §3.7]. The bitmap's bits are read at once, the rectangle's image until
  /// it has been rasterized.
  void draw_bitmap(const PixelDraw& draw, const FragmentSource& source, const Bitmap& bitmap);
  void draw_rectangle(const PixelDraw& draw, const FragmentSource& source, const PixelRectangle& rectangle);
  /// Draws what is pending, then writes.
  void write_rectangle(const DirectRectangle& rectangle);
  /// Draws what is pending, then copies from another framebuffer (pipeline/framebuffer/blit.h).
  void blit(const Framebuffer& source, const Blit& blit);

  /// The batch's first vertex through the vertex stages of a reporting plan; draws nothing.
  ProcessedVertex process_vertex(const DrawState& state, const Plan& plan, const VertexBatch& batch);

  /// Keeps what the draws so far refer to (a texture) alive until they have been rasterized.
  void keep(std::shared_ptr<const void> resource);

  /// All that was drawn is in the target when this returns. Returns at once if nothing is pending.
  void finish();
  /// True if something was drawn or cleared since the last call of this function: the OSMesa copy-out asks.
  bool take_dirty();

  /// Who gets the primitives of reporting plans; null: nobody. Not owned.
  void set_receiver(PrimitiveReceiver* receiver);
  /// Null removes it. Not owned.
  void set_observer(DrawObserver* observer);
  /// Who watches a vertex or a pixel from now on.
  void set_watch(const Watch& watch);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// GOURAUD_THREADS if set (1..256), else the number of cores that this process may use.
int default_thread_count();

}  // namespace gouraud::pipeline
