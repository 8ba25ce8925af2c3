// What the commands that specify texture images or parts of them have in common: which image, and whether it may be so
// [GL1.5 §3.8.1, §3.8.2, §3.8.11].
#pragma once

#include <GL/gl.h>

#include "api/commands/texel_formats.h"
#include "api/commands/texture_targets.h"
#include "api/context/context.h"

namespace gouraud::api {

/// Levels are below this.
GLint level_count(TextureTarget target);

/// As a command gives it; `dimensions` is the command's.
struct ImageRequest {
  const char* command = nullptr;
  int dimensions = 2;
  GLenum target = 0;
  GLint level = 0;
  GLsizei width = 0, height = 1, depth = 1;
  GLint border = 0;
};

/// The target, if level, border and size are none that is never allowed. Else nothing, and an error is recorded.
std::optional<ImageTarget> check_request(Context& context, const ImageRequest& request);

/// Why images of this format have no place on this target; null if they have [ARB_depth_texture,
/// EXT_texture_compression_s3tc].
const char* misplaced(const ImageRequest& request, const ImageTarget& target, const StoredFormat& format);

/// True if an image of this size and format can be stored.
enum class Fit { fits, too_large, no_memory };
Fit fit(const ImageRequest& request, TextureTarget target, const StoredFormat& format);

/// The image without texels: shape and format.
pipeline::Image make_image(const ImageRequest& request, const StoredFormat& format);

/// Sets the proxy to the image, or, if it does not fit, to nothing.
void set_proxy(Context& context, const ImageRequest& request, const ImageTarget& target, GLint internal_format,
               const StoredFormat& format);

/// A region of an image that exists, in texels of its array: offsets count from the border's edge.
struct Region {
  const char* command = nullptr;
  int dimensions = 2;
  GLenum target = 0;
  GLint level = 0;
  GLint x = 0, y = 0, z = 0;
  GLsizei width = 0, height = 1, depth = 1;
};

/// The image that the region is of; the region's offsets then count from the border's edge. Else nothing, and an error is
/// recorded: GL_INVALID_ENUM for a target, GL_INVALID_VALUE for a level or for texels that are not there,
/// GL_INVALID_OPERATION if there is no image.
std::optional<ImageTarget> check_region(Context& context, Region& region);

}  // namespace gouraud::api
