// Takes a format and a size, gives a picture that can be attached to framebuffers [ARB_framebuffer_object].
//
// choice: a renderbuffer whose name is deleted keeps its picture as long as a framebuffer that is not bound has it
// attached, as the extension says; names that were never given are ignored.
#include "api/commands/renderbuffers.h"

#include "api/commands/framebuffer_objects.h"
#include "api/snapshot/surface_formats.h"

namespace gouraud::api {
namespace {

void bind(Context& context, GLenum target, GLuint name, bool any_name, const char* command) {
  if (target != GL_RENDERBUFFER) return context.record_error(GL_INVALID_ENUM, command, "target is unknown");
  if (name != 0 && !any_name && !context.renderbuffer_names().used(name)) {
    return context.record_error(GL_INVALID_OPERATION, command, "the name was not given by glGenRenderbuffers");
  }
  context.framebuffers.renderbuffer = name != 0 ? context.renderbuffer_names().find_or_create(name) : nullptr;
}

void set_storage(Context& context, GLenum target, GLsizei samples, GLenum format, GLsizei width, GLsizei height,
                 const char* command) {
  if (target != GL_RENDERBUFFER) return context.record_error(GL_INVALID_ENUM, command, "target is unknown");
  auto surface = surface_of_format(format);
  if (!surface) return context.record_error(GL_INVALID_ENUM, command, "nothing can be drawn into internalformat");
  if (width < 0 || width > max_renderbuffer_size || height < 0 || height > max_renderbuffer_size) {
    return context.record_error(GL_INVALID_VALUE, command, "width or height is out of range");
  }
  if (samples < 0 || samples > max_samples) {
    return context.record_error(GL_INVALID_VALUE, command, "samples is out of range");
  }
  Renderbuffer* const renderbuffer = context.framebuffers.renderbuffer.get();
  if (renderbuffer == nullptr) {
    return context.record_error(GL_INVALID_OPERATION, command, "no renderbuffer is bound");
  }
  surface->allocate(width, height, samples > 0 ? max_samples : 1);
  renderbuffer->surface = *surface;
  renderbuffer->internal_format = format;
  renderbuffer->samples = samples > 0 ? max_samples : 0;
  context.update_targets();
}

}  // namespace

void GenRenderbuffers(Context& context, GLsizei n, GLuint* renderbuffers) {
  if (n < 0) return context.record_error(GL_INVALID_VALUE, "glGenRenderbuffers", "n is negative");
  context.renderbuffer_names().generate(n, renderbuffers);
}

void DeleteRenderbuffers(Context& context, GLsizei n, const GLuint* renderbuffers) {
  if (n < 0) return context.record_error(GL_INVALID_VALUE, "glDeleteRenderbuffers", "n is negative");
  for (GLsizei i = 0; i < n; ++i) {
    if (const auto renderbuffer = context.renderbuffer_names().find(renderbuffers[i])) {
      if (context.framebuffers.renderbuffer == renderbuffer) context.framebuffers.renderbuffer = nullptr;
      const Attachment attachment{renderbuffer, nullptr};
      detach(*context.framebuffers.draw, attachment);
      detach(*context.framebuffers.read, attachment);
    }
    context.renderbuffer_names().remove(renderbuffers[i]);
  }
  context.update_targets();
}

GLboolean IsRenderbuffer(Context& context, GLuint renderbuffer) {
  return context.renderbuffer_names().find(renderbuffer) != nullptr ? GL_TRUE : GL_FALSE;
}

void BindRenderbuffer(Context& context, GLenum target, GLuint renderbuffer) {
  bind(context, target, renderbuffer, false, "glBindRenderbuffer");
}

void BindRenderbufferEXT(Context& context, GLenum target, GLuint renderbuffer) {
  bind(context, target, renderbuffer, true, "glBindRenderbufferEXT");
}

void RenderbufferStorage(Context& context, GLenum target, GLenum internalformat, GLsizei width, GLsizei height) {
  set_storage(context, target, 0, internalformat, width, height, "glRenderbufferStorage");
}

void RenderbufferStorageMultisample(Context& context, GLenum target, GLsizei samples, GLenum internalformat, GLsizei width,
                                    GLsizei height) {
  set_storage(context, target, samples, internalformat, width, height, "glRenderbufferStorageMultisample");
}

void GetRenderbufferParameteriv(Context& context, GLenum target, GLenum pname, GLint* params) {
  constexpr auto command = "glGetRenderbufferParameteriv";
  if (target != GL_RENDERBUFFER) return context.record_error(GL_INVALID_ENUM, command, "target is unknown");
  const Renderbuffer* const renderbuffer = context.framebuffers.renderbuffer.get();
  if (renderbuffer == nullptr) {
    return context.record_error(GL_INVALID_OPERATION, command, "no renderbuffer is bound");
  }
  const ComponentBits bits = component_bits(renderbuffer->surface);
  switch (pname) {
    case GL_RENDERBUFFER_WIDTH:
      *params = renderbuffer->surface.width_px;
      break;
    case GL_RENDERBUFFER_HEIGHT:
      *params = renderbuffer->surface.height_px;
      break;
    case GL_RENDERBUFFER_INTERNAL_FORMAT:
      *params = static_cast<GLint>(renderbuffer->internal_format);
      break;
    case GL_RENDERBUFFER_SAMPLES:
      *params = renderbuffer->samples;
      break;
    case GL_RENDERBUFFER_RED_SIZE:
      *params = bits.red;
      break;
    case GL_RENDERBUFFER_GREEN_SIZE:
      *params = bits.green;
      break;
    case GL_RENDERBUFFER_BLUE_SIZE:
      *params = bits.blue;
      break;
    case GL_RENDERBUFFER_ALPHA_SIZE:
      *params = bits.alpha;
      break;
    case GL_RENDERBUFFER_DEPTH_SIZE:
      *params = bits.depth;
      break;
    case GL_RENDERBUFFER_STENCIL_SIZE:
      *params = bits.stencil;
      break;
    default:
      context.record_error(GL_INVALID_ENUM, command, "pname is unknown");
      break;
  }
}

}  // namespace gouraud::api
