// Images in client memory: where their pixels lie under the pixel store parameters, or in a pixel buffer object
// [GL1.5 §3.6.1, §3.6.4, §4.3.2] [ARB_pixel_buffer_object]. One road for DrawPixels, TexImage, GetTexImage, ReadPixels,
// Bitmap, PolygonStipple and the pixel maps:
//
//   ClientImage image;
//   if (!check_unpack(context, "glDrawPixels", {width, height}, format, type, pixels, image)) return;  // error recorded
//   if (image.null()) return;                                                                           // no pixels
//   for (GLsizei y = 0; y < height; ++y) unpack_color_row(image, y, 0, ...);                           // unpack_rows.h
//
// check_pack and pack_rows.h are the way back.
#pragma once

#include <cstddef>
#include <cstdint>

#include <GL/gl.h>

#include "api/commands/pixel_layout.h"
#include "api/context/context.h"

namespace gouraud::api {

/// Pixels a side, none negative. Only a volume (TexImage3D) knows IMAGE_HEIGHT and SKIP_IMAGES.
struct ImageSize {
  GLsizei width = 0, height = 1, depth = 1;
  bool volume = false;
};

struct ClientImage {
  PixelLayout layout;
  ImageSize size;
  /// Of the first pixel (its byte, if pixels are bits). Absurd parameters give an absurd address, without undefined
  /// arithmetic: addresses wrap around.
  std::uintptr_t address = 0;
  std::uintptr_t row_stride = 0, image_stride = 0;
  std::uint8_t first_bit = 0;  ///< of the byte, in the order of LSB_FIRST; if pixels are bits
  bool swap_bytes = false, lsb_first = false;
  bool in_buffer = false;

  /// No memory: a null pointer, without a buffer.
  bool null() const { return address == 0 && !in_buffer; }
  std::byte* row(GLsizei y, GLsizei z = 0) const {
    return reinterpret_cast<std::byte*>(address + static_cast<std::uintptr_t>(y) * row_stride +
                                        static_cast<std::uintptr_t>(z) * image_stride);
  }
  /// Bytes of a row that hold its pixels.
  std::size_t row_bytes() const;
};

/// The image that a command reads through UNPACK_*, or from PIXEL_UNPACK_BUFFER, where `pointer` is an offset. False,
/// and an error is recorded: those of find_pixel_layout; GL_INVALID_VALUE for a negative size; GL_INVALID_OPERATION if
/// the buffer is mapped, if the image is not within its store, or if the offset is no multiple of an element.
bool check_unpack(Context& context, const char* command, const ImageSize& size, GLenum format, GLenum type,
                  const void* pointer, ClientImage& image);
/// The same for what a command writes through PACK_*, or to PIXEL_PACK_BUFFER.
bool check_pack(Context& context, const char* command, const ImageSize& size, GLenum format, GLenum type, void* pointer,
                ClientImage& image);

/// The two steps, for commands that must check something between: the layout is found, sizes are not negative.
bool locate_unpack(Context& context, const char* command, const ImageSize& size, const PixelLayout& layout,
                   const void* pointer, ClientImage& image);
bool locate_pack(Context& context, const char* command, const ImageSize& size, const PixelLayout& layout, void* pointer,
                 ClientImage& image);

/// `count` elements of so many bytes side by side, in client memory or in the buffer, without pixel store parameters
/// (PixelMap, GetPixelMap, compressed images). False, and an error is recorded, as above; `address` may be null.
bool check_unpack_array(Context& context, const char* command, std::size_t count, std::size_t element_bytes,
                        const void* pointer, const std::byte*& address);
bool check_pack_array(Context& context, const char* command, std::size_t count, std::size_t element_bytes, void* pointer,
                      std::byte*& address);

}  // namespace gouraud::api
