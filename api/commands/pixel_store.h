// PixelStore, and where the pixels of a rectangle lie in client memory [GL1.5 §3.6.1, §3.6.4].
#pragma once

#include <cstddef>
#include <cstdint>

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

void PixelStorei(Context& context, GLenum pname, GLint param);

/// Offsets in bytes from the pointer that the program gave. They wrap around like addresses: absurd parameters give an
/// absurd address, as the specification asks, but no undefined arithmetic.
struct ClientRows {
  std::uintptr_t first_pixel = 0;
  std::uintptr_t row_stride = 0;
};

/// For rows of width_px pixels of so many elements, each of element_size bytes (1, 2 or 4)
/// [GL1.5 §3.6.4 eqs 3.10, 3.11].
ClientRows client_rows(const PixelStore& store, GLsizei width_px, std::size_t elements_per_pixel,
                       std::size_t element_size);

}  // namespace gouraud::api
