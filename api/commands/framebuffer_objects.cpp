#include "api/commands/framebuffer_objects.h"

#include "api/snapshot/surface_formats.h"

namespace gouraud::api {
namespace {

using FramebufferBinding = std::shared_ptr<FramebufferObject>;

/// The framebuffer that target names; null, and an error is recorded, if it names none.
FramebufferObject* bound(Context& context, GLenum target, const char* command) {
  switch (target) {
    case GL_FRAMEBUFFER:
    case GL_DRAW_FRAMEBUFFER:
      return context.framebuffers.draw.get();
    case GL_READ_FRAMEBUFFER:
      return context.framebuffers.read.get();
    default:
      context.record_error(GL_INVALID_ENUM, command, "target is unknown");
      return nullptr;
  }
}

}  // namespace

FramebufferObject* bound_object(Context& context, GLenum target, const char* command) {
  FramebufferObject* const framebuffer = bound(context, target, command);
  if (framebuffer == nullptr || !framebuffer->is_window()) return framebuffer;
  context.record_error(GL_INVALID_OPERATION, command, "no framebuffer object is bound");
  return nullptr;
}

namespace {

bool is_color_attachment(GLenum attachment) {
  return attachment - GL_COLOR_ATTACHMENT0 <= GL_COLOR_ATTACHMENT15 - GL_COLOR_ATTACHMENT0;
}

/// The attachment point; of GL_DEPTH_STENCIL_ATTACHMENT that of depth. Null, and an error is recorded, if there is none.
Attachment* attachment_point(Context& context, FramebufferObject& framebuffer, GLenum attachment, const char* command) {
  switch (attachment) {
    case GL_DEPTH_ATTACHMENT:
    case GL_DEPTH_STENCIL_ATTACHMENT:
      return &framebuffer.depth;
    case GL_STENCIL_ATTACHMENT:
      return &framebuffer.stencil;
    default:
      break;
  }
  if (attachment - GL_COLOR_ATTACHMENT0 < static_cast<GLenum>(max_color_attachments)) {
    return &framebuffer.color[attachment - GL_COLOR_ATTACHMENT0];
  }
  if (is_color_attachment(attachment)) {
    context.record_error(GL_INVALID_OPERATION, command, "there are fewer colour attachments");
  } else {
    context.record_error(GL_INVALID_ENUM, command, "attachment is unknown");
  }
  return nullptr;
}

void bind(Context& context, GLenum target, GLuint name, bool any_name, const char* command) {
  if (target != GL_FRAMEBUFFER && target != GL_DRAW_FRAMEBUFFER && target != GL_READ_FRAMEBUFFER) {
    return context.record_error(GL_INVALID_ENUM, command, "target is unknown");
  }
  if (name != 0 && !any_name && !context.framebuffer_names.used(name)) {
    return context.record_error(GL_INVALID_OPERATION, command, "the name was not given by glGenFramebuffers");
  }
  const FramebufferBinding framebuffer =
      name != 0 ? context.framebuffer_names.find_or_create(name) : context.framebuffers.window;
  if (target != GL_READ_FRAMEBUFFER) context.framebuffers.draw = framebuffer;
  if (target != GL_DRAW_FRAMEBUFFER) context.framebuffers.read = framebuffer;
  context.update_targets();
}

}  // namespace

void attach(Context& context, FramebufferObject& framebuffer, GLenum point, const Attachment& attachment,
            const char* command) {
  Attachment* const place = attachment_point(context, framebuffer, point, command);
  if (place == nullptr) return;
  *place = attachment;
  if (point == GL_DEPTH_STENCIL_ATTACHMENT) framebuffer.stencil = attachment;
  context.update_targets();
}

void detach(FramebufferObject& framebuffer, const Attachment& attachment) {
  const auto clear = [&](Attachment& place) {
    if (place == attachment) place = {};
  };
  for (Attachment& place : framebuffer.color) clear(place);
  clear(framebuffer.depth);
  clear(framebuffer.stencil);
}

void GenFramebuffers(Context& context, GLsizei n, GLuint* framebuffers) {
  if (n < 0) return context.record_error(GL_INVALID_VALUE, "glGenFramebuffers", "n is negative");
  context.framebuffer_names.generate(n, framebuffers);
}

void DeleteFramebuffers(Context& context, GLsizei n, const GLuint* framebuffers) {
  if (n < 0) return context.record_error(GL_INVALID_VALUE, "glDeleteFramebuffers", "n is negative");
  FramebufferBindings& bindings = context.framebuffers;
  for (GLsizei i = 0; i < n; ++i) {
    if (framebuffers[i] == 0) continue;
    if (bindings.draw->name == framebuffers[i]) bindings.draw = bindings.window;
    if (bindings.read->name == framebuffers[i]) bindings.read = bindings.window;
    context.framebuffer_names.remove(framebuffers[i]);
  }
  context.update_targets();
}

GLboolean IsFramebuffer(Context& context, GLuint framebuffer) {
  return context.framebuffer_names.find(framebuffer) != nullptr ? GL_TRUE : GL_FALSE;
}

void BindFramebuffer(Context& context, GLenum target, GLuint framebuffer) {
  bind(context, target, framebuffer, false, "glBindFramebuffer");
}

void BindFramebufferEXT(Context& context, GLenum target, GLuint framebuffer) {
  bind(context, target, framebuffer, true, "glBindFramebufferEXT");
}

GLenum CheckFramebufferStatus(Context& context, GLenum target) {
  const FramebufferObject* const framebuffer = bound(context, target, "glCheckFramebufferStatus");
  return framebuffer != nullptr ? context.framebuffer_status(*framebuffer) : 0;
}

void FramebufferRenderbuffer(Context& context, GLenum target, GLenum attachment, GLenum renderbuffertarget,
                             GLuint renderbuffer) {
  constexpr auto command = "glFramebufferRenderbuffer";
  if (renderbuffertarget != GL_RENDERBUFFER) {
    return context.record_error(GL_INVALID_ENUM, command, "renderbuffertarget is unknown");
  }
  FramebufferObject* const framebuffer = bound_object(context, target, command);
  if (framebuffer == nullptr) return;
  const auto object = renderbuffer != 0 ? context.renderbuffer_names().find(renderbuffer) : nullptr;
  if (renderbuffer != 0 && object == nullptr) {
    return context.record_error(GL_INVALID_OPERATION, command, "there is no such renderbuffer");
  }
  attach(context, *framebuffer, attachment, {object, nullptr}, command);
}

namespace {

struct Query {
  Context& context;
  GLenum point, pname;
  void refuse(GLenum error, const char* message) const {
    context.record_error(error, "glGetFramebufferAttachmentParameteriv", message);
  }
};

bool is_depth(GLenum point) {
  return point == GL_DEPTH_ATTACHMENT || point == GL_DEPTH || point == GL_DEPTH_STENCIL_ATTACHMENT;
}
bool is_stencil(GLenum point) {
  return point == GL_STENCIL_ATTACHMENT || point == GL_STENCIL;
}

/// The names of the window's one colour buffer.
bool is_window_color(GLenum point) {
  return point == GL_FRONT_LEFT || point == GL_FRONT || point == GL_BACK_LEFT || point == GL_BACK;
}

/// What is asked of a picture's format; false if pname is none of these.
bool query_format(const Query& query, const pipeline::Surface& surface, GLint* params) {
  const ComponentBits bits = component_bits(surface);
  switch (query.pname) {
    case GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE:
      *params = bits.red;
      return true;
    case GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE:
      *params = bits.green;
      return true;
    case GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE:
      *params = bits.blue;
      return true;
    case GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE:
      *params = bits.alpha;
      return true;
    case GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE:
      *params = bits.depth;
      return true;
    case GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE:
      *params = bits.stencil;
      return true;
    case GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING:
      *params = GL_LINEAR;  // nothing is encoded when it is written
      return true;
    case GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE: {
      const bool is_float = surface.color_format == pipeline::ColorFormat::rgba32f ||
                            (is_depth(query.point) && surface.depth_format == pipeline::DepthFormat::z32f);
      *params = is_stencil(query.point) ? GL_INDEX : is_float ? GL_FLOAT : GL_UNSIGNED_NORMALIZED;
      return true;
    }
    default:
      return false;
  }
}

/// What is asked of the place in a texture; false if pname is none of these.
bool query_texture(const Query& query, const Attachment& attachment, GLint* params) {
  const bool cube = attachment.texture->target == TextureTarget::cube_map;
  switch (query.pname) {
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL:
      *params = static_cast<GLint>(attachment.level);
      return true;
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE:
      *params = cube ? static_cast<GLint>(GL_TEXTURE_CUBE_MAP_POSITIVE_X + attachment.face) : 0;
      return true;
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER:
      *params = attachment.layer;
      return true;
    default:
      return false;
  }
}

/// Of the window's framebuffer: its planes as surfaces.
void query_window(const Query& query, GLint* params) {
  const bool right = query.point == GL_FRONT_RIGHT || query.point == GL_BACK_RIGHT;
  if (!is_window_color(query.point) && query.point != GL_DEPTH && query.point != GL_STENCIL && !right) {
    return query.refuse(GL_INVALID_ENUM, "attachment is no buffer of the window");
  }
  const pipeline::Framebuffer* const window = query.context.window();
  pipeline::Surface surface;
  if (window != nullptr && is_window_color(query.point)) {
    surface.color_format = window->color_format;
  } else if (window != nullptr && !right) {
    surface.depth_format = window->depth_format;
    surface.has_depth = window->has_depth;
    surface.has_stencil = window->stencil_bits > 0;
  }
  const bool exists = surface.color_format != pipeline::ColorFormat::none ||
                      (query.point == GL_DEPTH && surface.has_depth) ||
                      (query.point == GL_STENCIL && surface.has_stencil);
  if (query.pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) {
    *params = exists ? GL_FRAMEBUFFER_DEFAULT : GL_NONE;
  } else if (query.pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME) {
    *params = 0;
  } else if (!exists) {
    query.refuse(GL_INVALID_OPERATION, "there is no such buffer");
  } else if (!query_format(query, surface, params)) {
    query.refuse(GL_INVALID_ENUM, "pname is unknown");
  }
}

void query_attachment(const Query& query, const Attachment& attachment, GLint* params) {
  if (query.pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) {
    *params = static_cast<GLint>(attachment.object_type());
  } else if (query.pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME) {
    *params = static_cast<GLint>(attachment.object_name());
  } else if (attachment.object_type() == GL_NONE) {
    query.refuse(GL_INVALID_OPERATION, "nothing is attached");
  } else if (query.pname == GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE && query.point == GL_DEPTH_STENCIL_ATTACHMENT) {
    query.refuse(GL_INVALID_OPERATION, "depth and stencil have two types");
  } else if (attachment.texture != nullptr && query_texture(query, attachment, params)) {
    return;
  } else if (!query_format(query, attachment.surface(), params)) {
    query.refuse(GL_INVALID_ENUM, "pname is unknown or asks for a texture");
  }
}

}  // namespace

void GetFramebufferAttachmentParameteriv(Context& context, GLenum target, GLenum attachment, GLenum pname,
                                         GLint* params) {
  constexpr auto command = "glGetFramebufferAttachmentParameteriv";
  FramebufferObject* const framebuffer = bound(context, target, command);
  if (framebuffer == nullptr) return;
  const Query query{context, attachment, pname};
  if (framebuffer->is_window()) return query_window(query, params);
  const Attachment* const place = attachment_point(context, *framebuffer, attachment, command);
  if (place == nullptr) return;
  if (attachment == GL_DEPTH_STENCIL_ATTACHMENT && framebuffer->depth != framebuffer->stencil) {
    return query.refuse(GL_INVALID_OPERATION, "depth and stencil are different pictures");
  }
  query_attachment(query, *place, params);
}

}  // namespace gouraud::api
