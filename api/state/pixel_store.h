// How pixels lie in client memory [GL1.5 §3.6.1, Tables 3.1 and 6.21].
#pragma once

#include <GL/gl.h>

namespace gouraud::api {

/// Part of client attribute group CLIENT_PIXEL_STORE_BIT: one for packing, one for unpacking.
struct PixelStore {
  bool swap_bytes = false;
  bool lsb_first = false;
  GLint row_length_px = 0;
  GLint skip_rows = 0;
  GLint skip_pixels = 0;
  GLint alignment = 4;  ///< 1, 2, 4 or 8 bytes
  GLint image_height_px = 0;
  GLint skip_images = 0;
  bool operator==(const PixelStore&) const = default;
};

}  // namespace gouraud::api
