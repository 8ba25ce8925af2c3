#include "api/context/context.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "api/gouraud.h"
#include "pipeline/framebuffer/clear.h"

namespace gouraud {
namespace api {

constinit thread_local Context* current_context_pointer = nullptr;

namespace {

TraceTopics traced_topics() {
  const char* const list = std::getenv("GOURAUD_TRACE");
  std::string problem;
  const TraceTopics topics = parse_trace_topics(list != nullptr ? list : "", problem);
  if (!problem.empty()) std::fprintf(stderr, "gouraud: GOURAUD_TRACE: %s\n", problem.c_str());
  return topics;
}

void tell(const std::string& text) { std::fprintf(stderr, "%s%s", text.starts_with(' ') ? "" : "gouraud: ", text.c_str()); }

bool is_set(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && std::string_view(value) == "1";
}

const char* error_name(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_STACK_OVERFLOW:
      return "GL_STACK_OVERFLOW";
    case GL_STACK_UNDERFLOW:
      return "GL_STACK_UNDERFLOW";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    default:
      return "error";
  }
}

// The methods that GOURAUD_METHODS asks for; the default ones, and a line on stderr, if it cannot be understood.
pipeline::Methods default_methods() {
  const char* const text = std::getenv("GOURAUD_METHODS");
  if (text == nullptr) return {};
  std::string error;
  const std::optional<pipeline::Methods> methods = pipeline::parse_methods(text, error);
  if (!methods) std::fprintf(stderr, "gouraud: GOURAUD_METHODS: %s\n", error.c_str());
  return methods.value_or(pipeline::Methods{});
}

// choice: a hint has an effect only for programs that have asked for it by name (colors=hint): too many ask for GL_FASTEST
// out of habit [GL1.5 §5.6].
pipeline::Methods resolved(pipeline::Methods methods, const HintGroup& hint) {
  using Method = pipeline::InterpolationMethod;
  if (methods.colors == Method::hint) {
    methods.colors = hint.perspective_correction == GL_FASTEST ? Method::affine : Method::perspective;
  }
  return methods;
}

void release(Context& context) {
  context.finish_rendering();
  if (context.copy_out) context.copy_out();
}

}  // namespace

void make_current(Context* context) {
  Context* const old = current_context();
  if (old == context) return;
  if (old != nullptr) release(*old);
  current_context_pointer = context;
}

pipeline::DepthFormat depth_format(const ContextConfig& config) {
  if (config.depth_bits <= 0) return pipeline::DepthFormat::none;
  if (config.depth_bits > 24) return pipeline::DepthFormat::z32f;
  return config.depth_bits > 16 || config.stencil_bits > 0 ? pipeline::DepthFormat::z24s8 : pipeline::DepthFormat::z16;
}

Context::Context(const ContextConfig& config, Context* share_with)
    : display_lists(share_with != nullptr ? share_with->display_lists : std::make_shared<DisplayLists>()),
      traces_(traced_topics()),
      aborting_on_error_(is_set("GOURAUD_ABORT_ON_ERROR")),
      methods_(default_methods()),
      config_(config),
      buffer_names_(share_with != nullptr ? share_with->buffer_names_ : std::make_shared<BufferNames>()),
      texture_names_(share_with != nullptr ? share_with->texture_names_ : std::make_shared<TextureNames>()),
      renderbuffer_names_(share_with != nullptr ? share_with->renderbuffer_names_
                                                : std::make_shared<RenderbufferNames>()),
      renderer_(pipeline::default_thread_count()) {
  compiling_changed();
  renderer_.set_antialiasing(methods_.antialiasing);
  if (traces_.vertex >= 0 || traces_.pixel_x >= 0) {
    renderer_.set_watch({traces_.vertex, traces_.pixel_x, traces_.pixel_y, tell});
  }
  for (std::size_t i = 0; i < texture_target_count; ++i) {
    default_textures_[i] = std::make_shared<TextureObject>(static_cast<TextureTarget>(i));
  }
  for (TextureUnit& unit : state.texture.units) unit.binding = default_textures_;
  framebuffers.window = std::make_shared<FramebufferObject>();
  framebuffers.window->draw_buffer = framebuffers.window->read_buffer = GL_FRONT;
  framebuffers.draw = framebuffers.read = framebuffers.window;
}

Context::~Context() {
  if (current_context() == this) current_context_pointer = nullptr;
}

void Context::record_error(GLenum error, const char* command, const char* message) {
  if (error_ == GL_NO_ERROR) error_ = error;
  if (!tells_errors()) return;
  const std::string_view failing = command, programs = programs_command_ != nullptr ? programs_command_ : command;
  const bool inside = !programs.starts_with(failing);
  std::fprintf(stderr, "gouraud: %s: %s: %s%s%s\n", programs.data(), error_name(error), inside ? command : "",
               inside ? ": " : "", message);
  if (aborting_on_error_) std::abort();
}

GLenum Context::take_error() {
  return std::exchange(error_, static_cast<GLenum>(GL_NO_ERROR));
}

bool Context::set_window_size(int width_px, int height_px, pipeline::ColorFormat color_format) {
  if (width_px < 1 || width_px > max_target_size_px || height_px < 1 || height_px > max_target_size_px) return false;
  if (window_ != nullptr && window_->width_px == width_px && window_->height_px == height_px &&
      window_->color_format == color_format) {
    return true;
  }
  flush_vertices();
  try {
    install_window(std::make_unique<pipeline::Framebuffer>(width_px, height_px, color_format, window_depth_format(),
                                                           config_.stencil_bits > 0 ? 8 : 0, config_.accum_bits > 0,
                                                           config_.most_color_bits[3] > 0));
  } catch (const std::bad_alloc&) {
    return false;
  }
  if (!had_window_) {
    state.viewport.width_px = state.scissor.width_px = width_px;
    state.viewport.height_px = state.scissor.height_px = height_px;
    had_window_ = true;
  }
  change(dirty_all);
  return true;
}

void Context::install_window(std::unique_ptr<pipeline::Framebuffer> fresh) {
  if (target() == window_.get()) renderer_.set_target(nullptr);
  window_ = std::move(fresh);
  update_targets();
}

pipeline::DepthFormat Context::window_depth_format() const {
  using Method = pipeline::DepthMethod;
  const pipeline::DepthFormat visual = depth_format(config_);
  if (visual == pipeline::DepthFormat::none) return visual;
  switch (methods_.depth) {
    case Method::z16:
      return pipeline::DepthFormat::z16;
    case Method::z24:
      return pipeline::DepthFormat::z24s8;
    case Method::z32:
      return pipeline::DepthFormat::z32;
    case Method::z_float:
    case Method::z_reversed:
      return pipeline::DepthFormat::z32f;
    default:
      return visual;
  }
}

// As methods_ say, the colours kept.
void Context::store_window_depth(bool reversed) {
  auto fresh = std::make_unique<pipeline::Framebuffer>(*window_);
  const pipeline::Framebuffer depth(fresh->width_px, fresh->height_px, pipeline::ColorFormat::none, window_depth_format(),
                                    fresh->stencil_bits, false);
  fresh->depth_format = depth.depth_format;
  fresh->depth = depth.depth;
  fresh->stencil = depth.stencil;
  pipeline::ClearState clear;
  clear.depth = true;
  clear.scissor = {0, 0, fresh->width_px, fresh->height_px};
  clear.clear_depth = reversed ? 0.0 : 1.0;
  for (int tile = 0; tile < fresh->tile_count(); ++tile) pipeline::clear_tile(*fresh, tile, clear);
  install_window(std::move(fresh));
}

TargetInfo Context::target_info() const {
  const pipeline::Framebuffer* const target = renderer_.target();
  if (target == nullptr) return {};
  const std::uint32_t stencil_mask = target->stencil_bits > 0 ? (1u << target->stencil_bits) - 1u : 0u;
  const bool writes_color = framebuffers.draw->draw_buffer != GL_NONE;
  pipeline::Methods methods = resolved(methods_, state.hint);
  if (methods.formats_depth() && target != window_.get()) methods.depth = pipeline::DepthMethod::z;
  return {target->width_px,
          target->height_px,
          {target->color_format, target->depth_format, methods},
          stencil_mask,
          writes_color ? target->color_channels : std::uint8_t{0},
          target->samples > 1 ? target->samples : 0,
          target->has_depth,
          !target->accum.empty()};
}

void Context::set_methods(const pipeline::Methods& methods) {
  finish_rendering();
  const pipeline::Methods before = std::exchange(methods_, methods);
  const bool turned = methods.reverses_depth() != before.reverses_depth();
  if (window_ != nullptr && (turned || window_->depth_format != window_depth_format())) {
    try {
      store_window_depth(methods.reverses_depth());
    } catch (...) {
      methods_ = before;
      throw;
    }
  }
  renderer_.set_antialiasing(methods.antialiasing);
  change(dirty_all);
}

void Context::finish_rendering() {
  flush_vertices();
  renderer_.finish();
}

void Context::refresh() {
  const std::uint32_t dirty = dirty_;
  if (dirty == 0) return;
  const std::uint32_t besides_material = dirty & ~dirty_material;
  if (besides_material == dirty_transform && plan_format_.methods == pipeline::Methods{}) {
    refresh_matrices();
  } else if (besides_material != 0) {
    const TargetInfo target = target_info();
    next_draw_state_.lighting.material = draw_state_.lighting.material;
    const bool applies_methods = target.format.methods != pipeline::Methods{};
    std::uint32_t parts = update_draw_state(state, target, applies_methods ? dirty_all : dirty, next_draw_state_);
    if (applies_methods) {
      pipeline::apply_methods(target.format.methods, next_draw_state_);
      parts = dirty_all;
    }
    // Passes are of a format: another target may need others for an equal state.
    const bool other_format = target.format != plan_format_;
    const std::uint32_t changed = differing_parts(draw_state_, next_draw_state_, parts);
    pixel_draw_valid_ = pixel_draw_valid_ && changed == 0 && target.format == pixel_draw_format_;
    if (changed != 0 || other_format) take_draw_state(changed, target.format, other_format);
  }
  if ((dirty & ~(dirty_transform | dirty_viewport)) != 0) apply_material();
  dirty_ = 0;
}

// refresh() where nothing but matrices has changed: most draws of most programs.
void Context::refresh_matrices() {
  update_matrices(state, next_draw_state_);
  const std::uint32_t changed = differing_parts(draw_state_, next_draw_state_, dirty_transform);
  if (changed == 0) return;
  pixel_draw_valid_ = false;
  if (!go_on_under_next_matrices()) take_draw_state(changed, plan_format_, false);
}

// Where the next draw state has other matrices and nothing else is new: takes them for the vertices to come. False if
// pending vertices have to be drawn first.
bool Context::go_on_under_next_matrices() {
  if (!plan_.follows_matrices || draw_state_.clip_planes != next_draw_state_.clip_planes) return false;
  if (immediate.batch.count > 0) append_transform(immediate.batch, draw_state_.transform, next_draw_state_.transform);
  draw_state_.transform = next_draw_state_.transform;
  return true;
}

// The changed parts of next_draw_state_, and what follows from them.
void Context::take_draw_state(std::uint32_t changed, const pipeline::TargetFormat& format, bool other_format) {
  if (changed == dirty_transform && !other_format && go_on_under_next_matrices()) return;
  if (other_format || differ_for(immediate.batch_modes, changed, draw_state_, next_draw_state_)) {
    try {
      flush_vertices();
    } catch (...) {  // no memory: the parts are dirty still, and taken again next time
      next_draw_state_ = draw_state_;
      throw;
    }
  }
  next_draw_state_.lighting.material = draw_state_.lighting.material;
  const bool moved_only = (changed & ~(dirty_transform | dirty_viewport)) == 0 &&
                          draw_state_.clip_planes.count == next_draw_state_.clip_planes.count;
  copy_parts(next_draw_state_, changed, draw_state_);
  if ((changed & dirty_textures) != 0) hold_textures();
  if (moved_only && !other_format) return;  // no stage more or less
  plan_ = pipeline::make_plan(draw_state_, format);
  plan_format_ = format;
}

void Context::unbind_texture(const TextureBinding& texture) {
  const std::size_t target = index_of(texture->target);
  for (TextureUnit& unit : state.texture.units) {
    if (unit.binding[target] == texture) unit.binding[target] = default_textures_[target];
  }
  change(dirty_textures);
  const auto detach_from = [&](FramebufferObject& framebuffer) {
    const auto detach = [&](Attachment& place) {
      if (place.texture == texture) place = {};
    };
    for (Attachment& place : framebuffer.color) detach(place);
    detach(framebuffer.depth);
    detach(framebuffer.stencil);
  };
  detach_from(*framebuffers.draw);
  detach_from(*framebuffers.read);
  update_targets();
}

long Context::texture_uses(const pipeline::Texture& texture) const {
  return std::count_if(held_textures_.begin(), held_textures_.end(),
                       [&](const auto& held) { return held.get() == &texture; });
}

// What the draw state no longer refers to may still wait in the bins.
void Context::hold_textures() {
  const pipeline::TexturingState& texturing = draw_state_.texturing;
  for (std::size_t i = 0; i < held_textures_.size(); ++i) {
    const pipeline::TextureUnitState& unit = texturing.unit[i];
    const pipeline::Texture* const wanted = i < texturing.count ? unit.texture : nullptr;
    if (held_textures_[i].get() == wanted) continue;
    if (held_textures_[i] != nullptr) renderer_.keep(std::move(held_textures_[i]));
    held_textures_[i] = wanted != nullptr ? state.texture.units[unit.unit].binding[index_of(unit.target)]->texture : nullptr;
  }
}

const pipeline::PixelDraw& Context::pixel_draw() {
  refresh();
  flush_vertices();
  if (!pixel_draw_valid_) {
    pixel_draw_.state = pipeline::pixel_draw_state(draw_state_);
    pixel_draw_format_ = target_info().format;
    pixel_draw_.plan = pipeline::make_plan(pixel_draw_.state, pixel_draw_format_);
    ++pixel_draw_.version;
    pixel_draw_valid_ = true;
  }
  return pixel_draw_;
}

void Context::trace_plan() {
  const pipeline::VertexBatch& batch = immediate.batch;
  const std::string text = pipeline::describe(plan_, draw_state_, target_info().format, kinds_of(draw_state_, batch));
  const bool is_new = std::exchange(traced_plan_, text) != text;
  std::fprintf(stderr, "gouraud: draw of %d vertices in %zu primitives%s\n%s", batch.count, batch.primitives.size(),
               is_new ? "" : ", by the same plan", is_new ? text.c_str() : "");
}

}  // namespace api

bool set_draw_observer(pipeline::DrawObserver* observer) {
  api::Context* const context = api::current_context();
  if (context == nullptr) return false;
  context->flush_vertices();
  context->renderer().set_observer(observer);
  return true;
}

}  // namespace gouraud
