// How the typed variants of a command become its canonical form: integers by [GL1.5 Table 2.9] where they are colours
// or normals, plain conversion elsewhere. Reference for k bits: unsigned c/(2^k - 1), signed (2c + 1)/(2^k - 1).
#pragma once

#include <GL/gl.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace gouraud::api {

/// A coordinate, angle or parameter as the GL keeps it. A double beyond the range of float becomes an infinity.
template <class T>
constexpr GLfloat to_float(T value) {
  return static_cast<GLfloat>(value);
}

/// c/255 for every byte: glColor4ub is hot, and four divisions are slower than four loads.
inline constexpr std::array<GLfloat, 256> ubyte_components = [] {
  std::array<GLfloat, 256> table{};
  for (std::size_t c = 0; c < 256; ++c) table[c] = static_cast<GLfloat>(c) / 255.0f;
  return table;
}();

/// A component of a colour or a normal: [0, 1] for unsigned types, [-1, 1] for signed ones, floats as they are.
/// choice: each is the exact quotient, rounded to float (32-bit integers by way of double).
constexpr GLfloat to_component(GLubyte c) {
  return ubyte_components[c];
}
constexpr GLfloat to_component(GLbyte c) {
  return static_cast<GLfloat>(2 * c + 1) / 255.0f;
}
constexpr GLfloat to_component(GLushort c) {
  return static_cast<GLfloat>(c) / 65535.0f;
}
constexpr GLfloat to_component(GLshort c) {
  return static_cast<GLfloat>(2 * c + 1) / 65535.0f;
}
constexpr GLfloat to_component(GLuint c) {
  return static_cast<GLfloat>(c / 4294967295.0);
}
constexpr GLfloat to_component(GLint c) {
  return static_cast<GLfloat>((2.0 * c + 1.0) / 4294967295.0);
}
constexpr GLfloat to_component(GLfloat c) {
  return c;
}
constexpr GLfloat to_component(GLdouble c) {
  return static_cast<GLfloat>(c);
}

using FloatMatrix = std::array<GLfloat, 16>;

/// Sixteen doubles as floats, in the same order.
inline FloatMatrix to_float_matrix(const GLdouble* m) {
  FloatMatrix result;
  for (std::size_t i = 0; i < 16; ++i) result[i] = to_float(m[i]);
  return result;
}

/// The transpose of a 4x4 matrix [GL1.5 §2.11.2].
template <class T>
FloatMatrix transposed(const T* m) {
  FloatMatrix result;
  for (std::size_t i = 0; i < 16; ++i) result[i] = to_float(m[i % 4 * 4 + i / 4]);
  return result;
}

/// A PixelStore value given as a float [GL1.5 §3.6.1]: booleans are true unless zero, integers round to nearest.
/// What no GLint holds becomes the nearest GLint, and NaN becomes -1, which no parameter accepts.
inline GLint pixel_store_value(GLenum pname, GLfloat param) {
  const bool boolean = pname == GL_UNPACK_SWAP_BYTES || pname == GL_UNPACK_LSB_FIRST || pname == GL_PACK_SWAP_BYTES ||
                       pname == GL_PACK_LSB_FIRST;
  if (boolean) return param != 0.0f;
  if (std::isnan(param)) return -1;
  if (param >= 2147483648.0f) return 2147483647;
  if (param <= -2147483648.0f) return -2147483647 - 1;
  return static_cast<GLint>(std::lround(param));
}

/// What a pname of Light, Material, Fog, TexParameter, ... takes. No values: it is not a parameter of that command.
struct ParameterShape {
  int values = 0;
  bool color = false;    // integers convert by Table 2.9
  bool is_enum = false;  // the value is itself an enum
};

/// The values of a parameter as floats; those beyond shape.values are zero.
template <class T>
std::array<GLfloat, 4> to_parameter(ParameterShape shape, const T* values) {
  std::array<GLfloat, 4> result{};
  for (int i = 0; i < shape.values; ++i) {
    result[static_cast<std::size_t>(i)] = shape.color ? to_component(values[i]) : to_float(values[i]);
  }
  return result;
}

}  // namespace gouraud::api
