#include "api/commands/flush_and_hints.h"

namespace gouraud::api {
namespace {

GLenum* find_hint(HintGroup& hint, GLenum target) {
  switch (target) {
    case GL_PERSPECTIVE_CORRECTION_HINT:
      return &hint.perspective_correction;
    case GL_POINT_SMOOTH_HINT:
      return &hint.point_smooth;
    case GL_LINE_SMOOTH_HINT:
      return &hint.line_smooth;
    case GL_POLYGON_SMOOTH_HINT:
      return &hint.polygon_smooth;
    case GL_FOG_HINT:
      return &hint.fog;
    case GL_GENERATE_MIPMAP_HINT:
      return &hint.generate_mipmap;
    case GL_TEXTURE_COMPRESSION_HINT:
      return &hint.texture_compression;
    default:
      return nullptr;
  }
}

}  // namespace

void Flush(Context& context) {
  context.finish_rendering();
  if (context.copy_out) context.copy_out();
}

void Finish(Context& context) {
  Flush(context);
}

void Hint(Context& context, GLenum target, GLenum mode) {
  GLenum* const hint = find_hint(context.state.hint, target);
  if (hint == nullptr) return context.record_error(GL_INVALID_ENUM, "glHint", "target is unknown");
  if (mode != GL_FASTEST && mode != GL_NICEST && mode != GL_DONT_CARE) {
    return context.record_error(GL_INVALID_ENUM, "glHint", "mode is unknown");
  }
  *hint = mode;
  if (context.methods().colors == pipeline::InterpolationMethod::hint) context.change(dirty_raster);
}

}  // namespace gouraud::api
