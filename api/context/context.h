// A GL context: its state, its error, its pending vertices, and the pipeline that draws into its target. One thread at
// a time uses a context; each thread has at most one current context.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <GL/gl.h>

#include "api/context/display_list.h"
#include "api/context/framebuffer_objects.h"
#include "api/context/immediate.h"
#include "api/context/object_names.h"
#include "api/context/texture_proxies.h"
#include "api/context/trace_topics.h"
#include "api/context/query_names.h"
#include "api/snapshot/snapshot.h"
#include "api/state/attribute_stacks.h"
#include "api/state/buffer_object.h"
#include "api/state/state.h"
#include "pipeline/draw/draw_state.h"
#include "pipeline/draw/methods.h"
#include "pipeline/draw/plan.h"
#include "pipeline/draw/renderer.h"
#include "pipeline/framebuffer/framebuffer.h"

namespace gouraud::api {

class Context;

using TextureNames = ObjectNames<TextureObject>;
using BufferNames = ObjectNames<BufferObject>;
using RenderbufferNames = ObjectNames<Renderbuffer>;

/// What is drawn into and read from [ARB_framebuffer_object]; the first three are never null.
struct FramebufferBindings {
  std::shared_ptr<FramebufferObject> window, draw, read;
  std::shared_ptr<Renderbuffer> renderbuffer;
};

/// This thread's current context or null. Read it with current_context(), change it with make_current().
extern constinit thread_local Context* current_context_pointer __attribute__((tls_model("initial-exec")));

inline Context* current_context() {
  return current_context_pointer;
}

/// Makes `context` (or none, if null) current in this thread. A context that ceases to be current is released: what it
/// drew is finished and copied out.
void make_current(Context* context);

struct ContextConfig {
  int depth_bits = 24, stencil_bits = 8, accum_bits = 0;
  /// Bits of R, G, B, A that the window's colours have, where they are fewer than they are stored with; alpha: 0 or not.
  std::array<std::uint8_t, 4> most_color_bits = {32, 32, 32, 32};
};

/// The depth buffer that a request for so many bits gets; as Mesa, 16 bits with stencil become 24, but 32 bits are
/// 32-bit floats (Mesa: 24).
pipeline::DepthFormat depth_format(const ContextConfig& config);

class Context {
 public:
  /// `share_with` is the context whose objects (display lists, buffer objects) this one shares, or null.
  Context(const ContextConfig& config, Context* share_with);
  /// Unbinds the context if it is current in this thread. Nothing is copied out.
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  bool inside_begin_end() const { return immediate.inside_begin_end; }

  /// True while calls must be recorded or printed before (or instead of) being executed.
  bool intercepting() const { return intercepting_; }
  bool tracing_calls() const { return traces_.calls; }
  /// True while a display list is open: recordable commands go to the entry points' append_record.
  bool compiling() const { return list_compiler.open(); }
  /// NewList and EndList have opened or closed list_compiler.
  void compiling_changed() { intercepting_ = traces_.calls || tells_errors() || compiling(); }

  /// The command that the program has called, while it is carried out; known if calls are looked at first, else null.
  const char* programs_command() const { return programs_command_; }
  void set_programs_command(const char* command) { programs_command_ = command; }

  /// Keeps `error` unless an earlier one waits for glGetError [GL1.5 §2.5]. `command` is the full name of the command
  /// that fails, or of its family. GOURAUD_TRACE=errors prints the texts on stderr, and before them the command that the
  /// program called, if that is another (a list, of which this one is part); GOURAUD_ABORT_ON_ERROR=1 prints and aborts.
  void record_error(GLenum error, const char* command, const char* message);
  /// The error kept, GL_NO_ERROR if none; none is kept afterwards.
  GLenum take_error();

  /// The window system's framebuffer has this size and colour format from now on, with depth and stencil as configured:
  /// a new one, all zero, unless size and format are those of the old. The first one also sets viewport and scissor box.
  /// False, and nothing is changed, if a side is outside 1..max_target_size_px or memory is short.
  bool set_window_size(int width_px, int height_px, pipeline::ColorFormat color_format);
  /// The window system's framebuffer or null. Pixels of this and of the next two are complete only after
  /// finish_rendering().
  pipeline::Framebuffer* window() { return window_.get(); }
  const pipeline::Framebuffer* window() const { return window_.get(); }
  /// What is drawn into, and what is read from: null if it does not exist.
  pipeline::Framebuffer* target() { return renderer_.target(); }
  const pipeline::Framebuffer* target() const { return renderer_.target(); }
  pipeline::Framebuffer* read_target() { return read_target_; }
  /// True if something was drawn into the window system's framebuffer since the last call.
  bool take_window_dirty();

  /// What GL_DRAW_FRAMEBUFFER and its like are bound to. Whoever changes a binding, an attachment, an attached picture, a
  /// draw or a read buffer calls update_targets() then.
  FramebufferBindings framebuffers;
  ObjectNames<FramebufferObject> framebuffer_names;
  void update_targets();
  /// GL_FRAMEBUFFER_COMPLETE or what is wrong.
  GLenum framebuffer_status(const FramebufferObject& framebuffer) const;
  /// False, and GL_INVALID_FRAMEBUFFER_OPERATION is recorded, if the framebuffer that is drawn into (read from) is not
  /// complete; nothing but a blit reads a multisampled one: GL_INVALID_OPERATION. True without a window: then there is no
  /// target().
  bool can_draw(const char* command);
  bool can_read(const char* command);
  bool can_blit_from(const char* command);
  const ContextConfig& config() const { return config_; }

  /// The parts in `bits` (DirtyBits) of the state have changed. Pending vertices are not touched: they are drawn with
  /// the DrawState that they were given under, when that next differs.
  void change(std::uint32_t bits) { dirty_ |= bits; }

  /// Gives pending vertices to the renderer. Everything that reads or writes the target calls it first.
  /// choice: only the window system can ask for it between Begin and End, where the specification leaves the outcome
  /// open; the primitive ends there.
  void flush_vertices();
  /// Draws all that is pending; the target is complete when this returns.
  void finish_rendering();

  /// Brings draw_state() and plan() up to date with the state, flushing pending vertices first if they differ.
  void refresh();
  /// Begin and End [GL1.5 §2.6.1]; begin_primitive refreshes first.
  void begin_primitive(pipeline::PrimitiveMode mode, pipeline::PrimitiveOrigin origin = pipeline::PrimitiveOrigin::begin_end);
  void end_primitive();
  /// As begin_primitive, for a primitive whose vertices are named by batch.elements; end_primitive ends it as well.
  void begin_indexed_primitive(pipeline::PrimitiveMode mode);
  /// Gives the batch to the renderer and goes on with the primitive in an empty one. The caller appends again, as the first
  /// elements, those that the primitive still needs (see PrimitiveRange).
  void continue_indexed_primitive();
  /// For a vertex that the batch has no room for: gives the full batch to the renderer and carries over what the
  /// primitive still needs (see PrimitiveRange). False if the vertex is not to be kept.
  bool make_room_for_vertex();
  /// The material has changed between Begin and End: takes effect from the next vertex on.
  void apply_material();

  const pipeline::DrawState& draw_state() const { return draw_state_; }
  const pipeline::Plan& plan() const { return plan_; }
  /// What bitmaps and pixel rectangles are drawn with now. Refreshes, and flushes pending vertices.
  const pipeline::PixelDraw& pixel_draw();
  TargetInfo target_info() const;  ///< of the framebuffer that is drawn into
  /// True if a method has near at 1 and far at 0 in what is drawn into.
  bool draws_reversed_depth() const { return methods_.reverses_depth() && target() == window_.get(); }

  /// How the next draws are done: what is pending is finished with the old methods first. GOURAUD_METHODS at first. Where
  /// the window's depths are stored another way from now on, they are as far away as can be, and stencil is 0. Throws
  /// std::bad_alloc, and nothing is changed.
  void set_methods(const pipeline::Methods& methods);
  const pipeline::Methods& methods() const { return methods_; }

  pipeline::Renderer& renderer() { return renderer_; }

  /// Writes the target to where the window system shows it. Called, after finish_rendering(), by glFlush, by glFinish
  /// and when the context is released; may be empty.
  std::function<void()> copy_out;

  BufferNames& buffer_names() { return *buffer_names_; }
  TextureNames& texture_names() { return *texture_names_; }
  /// The texture of name 0 [GL1.5 §3.8.12]: contexts do not share it.
  const TextureBinding& default_texture(TextureTarget target) const { return default_textures_[index_of(target)]; }
  /// Binds the default texture wherever this one is bound, and detaches it from the framebuffers that are bound.
  void unbind_texture(const TextureBinding& texture);
  /// How often the draw state, which keeps its textures alive, refers to this one.
  long texture_uses(const pipeline::Texture& texture) const;
  TextureProxies texture_proxies{};
  RenderbufferNames& renderbuffer_names() { return *renderbuffer_names_; }

  /// Of selection and feedback; null while the mode is GL_RENDER. The renderer's receiver.
  std::unique_ptr<pipeline::PrimitiveReceiver> primitive_receiver;

  State state;
  AttributeStacks attribute_stacks;
  Immediate immediate;
  ListCompiler list_compiler;
  QueryNames query_names;
  /// The lists of this context and of those it shares with; never null.
  const std::shared_ptr<DisplayLists> display_lists;
  /// How many lists are being executed, one called by the other.
  int list_nesting = 0;

 private:
  pipeline::DepthFormat window_depth_format() const;
  void store_window_depth(bool reversed);
  void install_window(std::unique_ptr<pipeline::Framebuffer> fresh);
  void tile_attachments(const FramebufferObject& framebuffer);
  void draw_pending();
  void hold_textures();
  void refresh_matrices();
  bool go_on_under_next_matrices();
  void take_draw_state(std::uint32_t changed, const pipeline::TargetFormat& format, bool other_format);
  void trace_plan();

  bool tells_errors() const { return traces_.errors || aborting_on_error_; }

  bool intercepting_ = false;
  TraceTopics traces_;
  std::string traced_plan_;  ///< the last that was printed
  bool aborting_on_error_ = false;
  bool had_window_ = false;
  std::uint32_t dirty_ = dirty_all;
  GLenum error_ = GL_NO_ERROR;
  const char* programs_command_ = nullptr;
  pipeline::Methods methods_;
  ContextConfig config_;
  std::shared_ptr<BufferNames> buffer_names_;
  std::shared_ptr<TextureNames> texture_names_;
  std::array<TextureBinding, texture_target_count> default_textures_;
  std::array<std::shared_ptr<const pipeline::Texture>, max_texture_units> held_textures_;  // of draw_state_.texturing
  std::shared_ptr<RenderbufferNames> renderbuffer_names_;
  pipeline::DrawState draw_state_{};
  pipeline::DrawState next_draw_state_{};  ///< refresh() works here; the same between its calls, material apart
  pipeline::Plan plan_{};
  pipeline::TargetFormat plan_format_{};  ///< the plan's
  pipeline::PixelDraw pixel_draw_{};
  pipeline::TargetFormat pixel_draw_format_{};
  bool pixel_draw_valid_ = false;
  std::unique_ptr<pipeline::Framebuffer> window_;
  bool window_dirty_ = false;  // besides what the renderer knows, if it draws into the window
  bool draw_complete_ = true, read_complete_ = true;
  pipeline::Framebuffer draw_view_, read_view_;  // of framebuffer objects
  pipeline::Framebuffer* read_target_ = nullptr;
  pipeline::Renderer renderer_;
};

}  // namespace gouraud::api
