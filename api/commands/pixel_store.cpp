// Takes PixelStore's parameters, gives the pixel store state [GL1.5 §3.6.1, Table 3.1; §4.3.2, Table 4.4].
#include "api/commands/pixel_store.h"

namespace gouraud::api {
namespace {

enum class Parameter {
  unknown,
  swap_bytes,
  lsb_first,
  row_length,
  skip_rows,
  skip_pixels,
  alignment,
  image_height,
  skip_images
};

Parameter parameter_of(GLenum pname) {
  switch (pname) {
    case GL_PACK_SWAP_BYTES:
    case GL_UNPACK_SWAP_BYTES:
      return Parameter::swap_bytes;
    case GL_PACK_LSB_FIRST:
    case GL_UNPACK_LSB_FIRST:
      return Parameter::lsb_first;
    case GL_PACK_ROW_LENGTH:
    case GL_UNPACK_ROW_LENGTH:
      return Parameter::row_length;
    case GL_PACK_SKIP_ROWS:
    case GL_UNPACK_SKIP_ROWS:
      return Parameter::skip_rows;
    case GL_PACK_SKIP_PIXELS:
    case GL_UNPACK_SKIP_PIXELS:
      return Parameter::skip_pixels;
    case GL_PACK_ALIGNMENT:
    case GL_UNPACK_ALIGNMENT:
      return Parameter::alignment;
    case GL_PACK_IMAGE_HEIGHT:
    case GL_UNPACK_IMAGE_HEIGHT:
      return Parameter::image_height;
    case GL_PACK_SKIP_IMAGES:
    case GL_UNPACK_SKIP_IMAGES:
      return Parameter::skip_images;
    default:
      return Parameter::unknown;
  }
}

bool is_pack(GLenum pname) {
  switch (pname) {
    case GL_PACK_SWAP_BYTES:
    case GL_PACK_LSB_FIRST:
    case GL_PACK_ROW_LENGTH:
    case GL_PACK_SKIP_ROWS:
    case GL_PACK_SKIP_PIXELS:
    case GL_PACK_ALIGNMENT:
    case GL_PACK_IMAGE_HEIGHT:
    case GL_PACK_SKIP_IMAGES:
      return true;
    default:
      return false;
  }
}

bool valid(Parameter parameter, GLint value) {
  switch (parameter) {
    case Parameter::swap_bytes:
    case Parameter::lsb_first:
      return true;
    case Parameter::alignment:
      return value == 1 || value == 2 || value == 4 || value == 8;
    default:
      return value >= 0;
  }
}

void set(PixelStore& store, Parameter parameter, GLint value) {
  switch (parameter) {
    case Parameter::unknown:
      break;
    case Parameter::swap_bytes:
      store.swap_bytes = value != 0;
      break;
    case Parameter::lsb_first:
      store.lsb_first = value != 0;
      break;
    case Parameter::row_length:
      store.row_length_px = value;
      break;
    case Parameter::skip_rows:
      store.skip_rows = value;
      break;
    case Parameter::skip_pixels:
      store.skip_pixels = value;
      break;
    case Parameter::alignment:
      store.alignment = value;
      break;
    case Parameter::image_height:
      store.image_height_px = value;
      break;
    case Parameter::skip_images:
      store.skip_images = value;
      break;
  }
}

}  // namespace

void PixelStorei(Context& context, GLenum pname, GLint param) {
  const Parameter parameter = parameter_of(pname);
  if (parameter == Parameter::unknown) {
    return context.record_error(GL_INVALID_ENUM, "glPixelStore", "pname is not a pixel store parameter");
  }
  if (!valid(parameter, param)) {
    return context.record_error(GL_INVALID_VALUE, "glPixelStore", "param is outside the parameter's range");
  }
  set(is_pack(pname) ? context.state.pack : context.state.unpack, parameter, param);
}

}  // namespace gouraud::api
