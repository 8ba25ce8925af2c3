// A pixel in client memory: what a command's format and type say [GL1.5 §3.6.4, Tables 3.5, 3.6, 3.8 to 3.12], with
// EXT_abgr, EXT_packed_depth_stencil and ARB_depth_buffer_float.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

enum class PixelKind : std::uint8_t { color, color_index, stencil_index, depth, depth_stencil };

/// The elements of a pixel, or the word that all of them are packed in. `bits`: one bit a pixel, GL_BITMAP.
enum class ElementType : std::uint8_t {
  bits, unsigned_byte, signed_byte, unsigned_short, signed_short, unsigned_int, signed_int, floating,
  packed_byte, packed_short, packed_int,
  depth24_stencil8,   ///< a 32-bit word, stencil in its low 8 bits
  depth32f_stencil8,  ///< a float, then a 32-bit word, stencil in its low 8 bits
};

/// What an element means: R, G, B and A are 0 to 3.
inline constexpr std::uint8_t channel_luminance = 4;

/// A field of a packed word.
struct PackedField {
  std::uint8_t shift = 0, bits = 0;
};

struct PixelLayout {
  PixelKind kind = PixelKind::color;
  ElementType element = ElementType::unsigned_byte;
  std::uint8_t element_count = 1;           ///< elements in a group; fields of a packed word
  std::uint8_t element_bytes = 1;           ///< what SWAP_BYTES turns round, and what alignment is measured against
  std::uint8_t pixel_bytes = 1;             ///< of a whole group; 0 for `bits`
  std::array<std::uint8_t, 4> channel{};    ///< of each element, if `kind` is color
  std::array<PackedField, 4> field{};       ///< of each element, if packed
  bool packed() const { return element >= ElementType::packed_byte && element <= ElementType::packed_int; }
};

/// Finds the layout. False, and an error is recorded: GL_INVALID_ENUM for an unknown format or type, for GL_BITMAP with
/// what is no index, and for GL_DEPTH_STENCIL with a type that does not hold both; GL_INVALID_OPERATION for a packed
/// type that does not match the format.
bool find_pixel_layout(Context& context, const char* command, GLenum format, GLenum type, PixelLayout& layout);

/// The same without a word: whether the layout exists.
bool has_pixel_layout(GLenum format, GLenum type, PixelLayout& layout);

}  // namespace gouraud::api
