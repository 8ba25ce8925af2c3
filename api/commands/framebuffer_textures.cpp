#include "api/commands/framebuffer_textures.h"

#include <optional>

#include "api/commands/framebuffer_objects.h"
#include "api/commands/texture_storage.h"
#include "api/commands/texture_targets.h"

namespace gouraud::api {
namespace {

/// What is asked for, beside the attachment point.
struct Request {
  const char* command;
  GLenum target, point;
  GLuint texture;
  GLint level, layer;
};

void attach_texture(Context& context, const Request& request, std::optional<ImageTarget> image) {
  FramebufferObject* const framebuffer = bound_object(context, request.target, request.command);
  if (framebuffer == nullptr) return;
  if (request.texture == 0) return attach(context, *framebuffer, request.point, {}, request.command);
  const TextureBinding texture = context.texture_names().find(request.texture);
  const auto refuse = [&](GLenum error, const char* message) {
    context.record_error(error, request.command, message);
  };
  if (texture == nullptr) return refuse(GL_INVALID_OPERATION, "there is no such texture");
  if (!image || image->proxy || image->target != texture->target) {
    return refuse(GL_INVALID_OPERATION, "the texture has another target");
  }
  const GLint levels = texture->target == TextureTarget::rectangle ? 1 : pipeline::max_texture_levels;
  if (request.level < 0 || request.level >= levels) return refuse(GL_INVALID_VALUE, "level is out of range");
  if (request.layer < 0 || request.layer >= pipeline::max_texture_3d_size) {
    return refuse(GL_INVALID_VALUE, "the slice is out of range");
  }
  Attachment attachment;
  attachment.texture = texture;
  attachment.face = image->face;
  attachment.level = static_cast<std::size_t>(request.level);
  attachment.layer = request.layer;
  attach(context, *framebuffer, request.point, attachment, request.command);
}

/// GL_INVALID_ENUM, as Mesa: a textarget that no texture of these dimensions has.
bool is_target_of(Context& context, const Request& request, GLenum textarget, std::initializer_list<TextureTarget> targets) {
  const auto image = image_target(textarget);
  if (request.texture == 0) return true;
  for (const TextureTarget target : targets) {
    if (image && !image->proxy && image->target == target) return true;
  }
  context.record_error(GL_INVALID_ENUM, request.command, "textarget is no target of these dimensions");
  return false;
}

}  // namespace

void FramebufferTexture1D(Context& context, GLenum target, GLenum attachment, GLenum textarget, GLuint texture, GLint level) {
  const Request request{"glFramebufferTexture1D", target, attachment, texture, level, 0};
  if (!is_target_of(context, request, textarget, {TextureTarget::one_d})) return;
  attach_texture(context, request, image_target(textarget));
}

void FramebufferTexture2D(Context& context, GLenum target, GLenum attachment, GLenum textarget, GLuint texture, GLint level) {
  const Request request{"glFramebufferTexture2D", target, attachment, texture, level, 0};
  using enum TextureTarget;
  if (!is_target_of(context, request, textarget, {two_d, rectangle, cube_map})) return;
  attach_texture(context, request, image_target(textarget));
}

void FramebufferTexture3D(Context& context, GLenum target, GLenum attachment, GLenum textarget, GLuint texture, GLint level,
                          GLint zoffset) {
  const Request request{"glFramebufferTexture3D", target, attachment, texture, level, zoffset};
  if (!is_target_of(context, request, textarget, {TextureTarget::three_d})) return;
  attach_texture(context, request, image_target(textarget));
}

void FramebufferTextureLayer(Context& context, GLenum target, GLenum attachment, GLuint texture, GLint level, GLint layer) {
  attach_texture(context, {"glFramebufferTextureLayer", target, attachment, texture, level, layer},
                 image_target(GL_TEXTURE_3D));
}

void GenerateMipmap(Context& context, GLenum target) {
  constexpr auto command = "glGenerateMipmap";
  const auto kind = texture_target(target);
  if (!kind || *kind == TextureTarget::rectangle) {
    return context.record_error(GL_INVALID_ENUM, command, "target has no mipmaps");
  }
  TextureObject& object = bound_texture(context, *kind);
  const auto base = static_cast<std::size_t>(object.parameters.base_level);
  if (base >= static_cast<std::size_t>(pipeline::max_texture_levels)) return;
  const auto& faces = object.texture->faces;
  for (const auto& face : faces) {
    const pipeline::Image &image = face[base], &first = faces[0][base];
    if (image.width != first.width || image.height != first.height || image.format != first.format) {
      return context.record_error(GL_INVALID_OPERATION, command, "the cube map is not complete");
    }
  }
  if (faces[0][base].empty()) return;
  context.finish_rendering();
  generate_mipmaps(context, object, 0, faces.size());
}

}  // namespace gouraud::api
