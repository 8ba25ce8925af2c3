// Texture images: what formats, types, pixel store and pixel transfer make of client memory, one texel a pixel
// [GL1.5 §3.8.1, §3.8.2, §3.8.3].
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

constexpr int cell = 30, step = 32, columns = 8;
using Bytes = std::vector<GLubyte>;

Bytes random_bytes(Random& random, int count) {
  Bytes bytes(static_cast<std::size_t>(count));
  for (GLubyte& byte : bytes) byte = static_cast<GLubyte>(random.below(256));
  return bytes;
}

void tight(const GlTable& gl) {
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

void start(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  tight(gl);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
}

void nearest(const GlTable& gl, GLenum target = GL_TEXTURE_2D) {
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

/// A square of texture coordinates 0 to `most`, its texels pixels if the texture has as many.
void square(const GlTable& gl, float x, float y, float size, float most = 1.0f) {
  gl.Begin(GL_QUADS);
  gl.TexCoord2f(0, 0);
  gl.Vertex2f(x, y);
  gl.TexCoord2f(most, 0);
  gl.Vertex2f(x + size, y);
  gl.TexCoord2f(most, most);
  gl.Vertex2f(x + size, y + size);
  gl.TexCoord2f(0, most);
  gl.Vertex2f(x, y + size);
  gl.End();
}

void place(const GlTable& gl, int index, float most = 1.0f) {
  square(gl, static_cast<float>(1 + step * (index % columns)), static_cast<float>(1 + step * (index / columns)), cell, most);
}

/// An image of cell x cell texels in the next place.
void show(const GlTable& gl, int index, GLint internal_format, GLenum format, GLenum type, const void* pixels) {
  nearest(gl);
  gl.TexImage2D(GL_TEXTURE_2D, 0, internal_format, cell, cell, 0, format, type, pixels);
  place(gl, index);
}

struct Format {
  GLenum name;
  int elements;
};
constexpr Format formats[] = {{GL_RGBA, 4},      {GL_BGRA, 4},  {GL_RGB, 3},   {GL_BGR, 3},
                              {GL_LUMINANCE, 1}, {GL_LUMINANCE_ALPHA, 2}, {GL_ALPHA, 1}, {GL_RED, 1},
                              {GL_GREEN, 1},     {GL_BLUE, 1}};

// Each format of bytes, into RGBA and into RGB.
void byte_formats(const GlTable& gl) {
  start(gl);
  Random random(5);
  int index = 0;
  for (const GLint internal_format : {GL_RGBA8, GL_RGB8}) {
    for (const Format& format : formats) {
      const Bytes bytes = random_bytes(random, cell * cell * format.elements);
      show(gl, index++, internal_format, format.name, GL_UNSIGNED_BYTE, bytes.data());
    }
  }
}

// A ramp in each type, twice: as RGBA and as luminance.
template <class T>
std::vector<T> ramp(int count, double least, double most) {
  std::vector<T> values(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    values[static_cast<std::size_t>(i)] = static_cast<T>(least + (most - least) * ((i * 7) % count) / (count - 1));
  }
  return values;
}

void types(const GlTable& gl) {
  start(gl);
  constexpr int count = cell * cell * 4;
  int index = 0;
  const auto both = [&](GLenum type, const auto& values) {
    show(gl, index++, GL_RGBA8, GL_RGBA, type, values.data());
    show(gl, index++, GL_LUMINANCE16, GL_LUMINANCE, type, values.data());
  };
  both(GL_UNSIGNED_BYTE, ramp<GLubyte>(count, 0, 255));
  both(GL_BYTE, ramp<GLbyte>(count, -128, 127));
  both(GL_UNSIGNED_SHORT, ramp<GLushort>(count, 0, 65535));
  both(GL_SHORT, ramp<GLshort>(count, -32768, 32767));
  both(GL_UNSIGNED_INT, ramp<GLuint>(count, 0, 4294967295.0));
  both(GL_INT, ramp<GLint>(count, -2147483648.0, 2147483647.0));
  both(GL_FLOAT, ramp<GLfloat>(count, -0.5, 1.5));
}

void packed_types(const GlTable& gl) {
  start(gl);
  Random random(9);
  const Bytes bytes = random_bytes(random, cell * cell * 4);
  int index = 0;
  for (const GLenum type : {GL_UNSIGNED_BYTE_3_3_2, GL_UNSIGNED_BYTE_2_3_3_REV, GL_UNSIGNED_SHORT_5_6_5, GL_UNSIGNED_SHORT_5_6_5_REV}) {
    show(gl, index++, GL_RGB8, GL_RGB, type, bytes.data());
  }
  for (const GLenum format : {GL_RGBA, GL_BGRA}) {
    for (const GLenum type : {GL_UNSIGNED_SHORT_4_4_4_4, GL_UNSIGNED_SHORT_4_4_4_4_REV, GL_UNSIGNED_SHORT_5_5_5_1,
                              GL_UNSIGNED_SHORT_1_5_5_5_REV, GL_UNSIGNED_INT_8_8_8_8, GL_UNSIGNED_INT_8_8_8_8_REV,
                              GL_UNSIGNED_INT_10_10_10_2, GL_UNSIGNED_INT_2_10_10_10_REV}) {
      show(gl, index++, GL_RGBA8, format, type, bytes.data());
    }
  }
}

// Colours that each format holds exactly, so that drivers may store more bits than were asked for.
void narrow_formats(const GlTable& gl) {
  start(gl);
  Random random(13);
  int index = 0;
  const auto with_levels = [&](int bits) {
    Bytes bytes(cell * cell * 4);
    const int most = (1 << bits) - 1;
    for (GLubyte& byte : bytes) byte = static_cast<GLubyte>((random.below(most + 1) * 255 + most / 2) / most);
    return bytes;
  };
  for (const GLint format : {GL_RGB4, GL_RGBA4, GL_LUMINANCE4, GL_LUMINANCE4_ALPHA4, GL_ALPHA4, GL_INTENSITY4}) {
    show(gl, index++, format, GL_RGBA, GL_UNSIGNED_BYTE, with_levels(4).data());
  }
  for (const GLint format : {GL_R3_G3_B2, GL_RGBA2, GL_RGB5_A1, GL_RGB5, GL_LUMINANCE6_ALPHA2}) {
    show(gl, index++, format, GL_RGBA, GL_UNSIGNED_BYTE, with_levels(1).data());
  }
}

void wide_formats(const GlTable& gl) {
  start(gl);
  Random random(15);
  int index = 0;
  for (const GLint format : {GL_RGB8, GL_RGB10, GL_RGB12, GL_RGB16, GL_RGBA8, GL_RGB10_A2, GL_RGBA12, GL_RGBA16,
                             GL_LUMINANCE8, GL_LUMINANCE12, GL_LUMINANCE16, GL_LUMINANCE8_ALPHA8, GL_LUMINANCE12_ALPHA4,
                             GL_LUMINANCE12_ALPHA12, GL_LUMINANCE16_ALPHA16, GL_ALPHA8, GL_ALPHA12, GL_ALPHA16,
                             GL_INTENSITY8, GL_INTENSITY12, GL_INTENSITY16}) {
    Bytes bytes = random_bytes(random, cell * cell * 4);
    if (format == GL_RGB10_A2 || format == GL_LUMINANCE12_ALPHA4) {
      for (std::size_t i = 3; i < bytes.size(); i += 4) bytes[i] = 255;
    }
    show(gl, index++, format, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  }
}

// What each base format takes from R, G, B, A, seen by REPLACE, MODULATE and ADD over a coloured square.
void base_formats(const GlTable& gl) {
  start(gl);
  gl.Color4f(0.25f, 0.5f, 0.75f, 0.5f);
  Random random(17);
  const Bytes bytes = random_bytes(random, cell * cell * 4);
  int index = 0;
  for (const GLint mode : {GL_REPLACE, GL_MODULATE, GL_ADD}) {
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode);
    for (const GLint format : {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RGB, GL_RGBA, 1, 2}) {
      show(gl, index++, format, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    }
  }
}

// One and two colours [ARB_texture_rg], of pixels of four and of two components, by all environments and with a border.
void few_colors(const GlTable& gl) {
  start(gl);
  gl.Color4f(0.25f, 0.5f, 0.75f, 0.5f);
  Random random(18);
  const Bytes bytes = random_bytes(random, cell * cell * 4);
  const float border[] = {0.9f, 0.6f, 0.3f, 0.2f}, constant[] = {0.1f, 0.7f, 0.4f, 0.8f};
  gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
  int index = 0;
  for (const GLint mode : {GL_REPLACE, GL_MODULATE, GL_ADD, GL_DECAL, GL_BLEND}) {
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode);
    for (const GLint format : {GL_RED, GL_RG, GL_R16, GL_RG16}) {
      nearest(gl);
      const GLenum pixels = format == GL_R16 || format == GL_RG ? GL_RG : GL_RGBA;
      gl.TexImage2D(GL_TEXTURE_2D, 0, format, cell, cell, 0, pixels, GL_UNSIGNED_BYTE, bytes.data());
      place(gl, index++, 1.21f);
    }
  }
}

// Parts of one image through every parameter of the pixel store.
void pixel_store(const GlTable& gl) {
  start(gl);
  Random random(19);
  const Bytes bytes = random_bytes(random, 80 * 80 * 8);
  int index = 0;
  const auto part = [&](std::initializer_list<std::pair<GLenum, GLint>> parameters, GLenum format, GLenum type) {
    for (const auto& [name, value] : parameters) gl.PixelStorei(name, value);
    show(gl, index++, GL_RGBA8, format, type, bytes.data());
    for (const auto& [name, value] : parameters) gl.PixelStorei(name, name == GL_UNPACK_ALIGNMENT ? 1 : 0);
  };
  part({{GL_UNPACK_ROW_LENGTH, 77}}, GL_RGB, GL_UNSIGNED_BYTE);
  part({{GL_UNPACK_ROW_LENGTH, 77}, {GL_UNPACK_ALIGNMENT, 8}}, GL_RGB, GL_UNSIGNED_BYTE);
  part({{GL_UNPACK_SKIP_PIXELS, 5}, {GL_UNPACK_ROW_LENGTH, 41}}, GL_LUMINANCE, GL_UNSIGNED_BYTE);
  part({{GL_UNPACK_SKIP_ROWS, 3}, {GL_UNPACK_SKIP_PIXELS, 2}}, GL_RGBA, GL_UNSIGNED_BYTE);
  part({{GL_UNPACK_ALIGNMENT, 4}}, GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE);
  part({{GL_UNPACK_SWAP_BYTES, 1}}, GL_RGB, GL_UNSIGNED_SHORT);
  part({{GL_UNPACK_SWAP_BYTES, 1}}, GL_RGBA, GL_UNSIGNED_INT_8_8_8_8);
  part({{GL_UNPACK_SWAP_BYTES, 1}}, GL_RGB, GL_UNSIGNED_SHORT_5_6_5);
  part({{GL_UNPACK_SKIP_IMAGES, 1}, {GL_UNPACK_IMAGE_HEIGHT, 35}}, GL_RGBA, GL_UNSIGNED_BYTE);
}

// Scale, bias and maps between client memory and texels.
void pixel_transfer(const GlTable& gl) {
  start(gl);
  Random random(21);
  const Bytes bytes = random_bytes(random, cell * cell * 4);
  gl.PixelTransferf(GL_RED_SCALE, 0.5f);
  gl.PixelTransferf(GL_RED_BIAS, 0.25f);
  gl.PixelTransferf(GL_GREEN_SCALE, -1.0f);
  gl.PixelTransferf(GL_GREEN_BIAS, 1.0f);
  gl.PixelTransferf(GL_ALPHA_BIAS, 0.4f);
  show(gl, 0, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  show(gl, 1, GL_LUMINANCE8, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
  gl.PixelTransferf(GL_RED_SCALE, 1.0f);
  gl.PixelTransferf(GL_RED_BIAS, 0.0f);
  gl.PixelTransferf(GL_GREEN_SCALE, 1.0f);
  gl.PixelTransferf(GL_GREEN_BIAS, 0.0f);
  gl.PixelTransferf(GL_ALPHA_BIAS, 0.0f);
  const std::array<GLfloat, 4> map{0.0f, 0.2f, 0.8f, 1.0f};
  gl.PixelMapfv(GL_PIXEL_MAP_R_TO_R, 4, map.data());
  gl.PixelMapfv(GL_PIXEL_MAP_B_TO_B, 4, map.data());
  gl.PixelTransferi(GL_MAP_COLOR, GL_TRUE);
  show(gl, 2, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  gl.PixelTransferi(GL_MAP_COLOR, GL_FALSE);
  for (const GLenum index_map : {GL_PIXEL_MAP_I_TO_R, GL_PIXEL_MAP_I_TO_G, GL_PIXEL_MAP_I_TO_B, GL_PIXEL_MAP_I_TO_A}) {
    std::array<GLfloat, 16> colors;
    for (GLfloat& color : colors) color = random.range(0, 1);
    gl.PixelMapfv(index_map, 16, colors.data());
  }
  show(gl, 3, GL_RGBA8, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes.data());
}

// Patches of one texture are replaced, between draws that use it.
void sub_images(const GlTable& gl) {
  start(gl);
  nearest(gl);
  Random random(23);
  const Bytes bytes = random_bytes(random, cell * cell * 4);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, cell, cell, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  for (int i = 0; i < 40; ++i) {
    const int width = random.below(12), height = random.below(12);
    const int x = random.below(cell - width), y = random.below(cell - height);
    const Format& format = formats[random.below(10)];
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, x, y, width, height, format.name, GL_UNSIGNED_BYTE, bytes.data());
    place(gl, i);
  }
}

// Slices of a volume, one replaced; a row as a texture.
void volumes(const GlTable& gl) {
  start(gl);
  gl.Disable(GL_TEXTURE_2D);
  gl.Enable(GL_TEXTURE_3D);
  nearest(gl, GL_TEXTURE_3D);
  Random random(25);
  const Bytes bytes = random_bytes(random, cell * cell * 8 * 3);
  gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGB8, cell, cell, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
  gl.TexSubImage3D(GL_TEXTURE_3D, 0, 3, 5, 2, 20, 10, 3, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
  for (int slice = 0; slice < 8; ++slice) {
    const float r = (static_cast<float>(slice) + 0.5f) / 8, x = static_cast<float>(1 + step * slice);
    gl.Begin(GL_QUADS);
    for (const auto& corner : {std::array{0.0f, 0.0f}, std::array{1.0f, 0.0f}, std::array{1.0f, 1.0f}, std::array{0.0f, 1.0f}}) {
      gl.TexCoord3f(corner[0], corner[1], r);
      gl.Vertex2f(x + corner[0] * cell, 1 + corner[1] * cell);
    }
    gl.End();
  }
  gl.Disable(GL_TEXTURE_3D);
  gl.Enable(GL_TEXTURE_1D);
  nearest(gl, GL_TEXTURE_1D);
  gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA8, cell, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  gl.TexSubImage1D(GL_TEXTURE_1D, 0, 10, 5, GL_LUMINANCE, GL_UNSIGNED_BYTE, bytes.data());
  place(gl, 8);
}

/// Something to copy, none of it background: triangles of smooth colours.
void backdrop(const GlTable& gl) {
  gl.Disable(GL_TEXTURE_2D);
  Random random(27);
  gl.Color4f(0.3f, 0.4f, 0.2f, 1.0f);
  draw_rectangle(gl, 0, 0, 256, 256, 0);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 30; ++i) {
    const float red = random.range(0, 1), green = random.range(0, 1), blue = random.range(0, 1);
    gl.Color4f(red, green, blue, random.range(0, 1));
    const float x = random.range(0, 256);
    gl.Vertex2f(x, random.range(0, 256));
  }
  gl.End();
  gl.Enable(GL_TEXTURE_2D);
}

void copies(const GlTable& gl) {
  start(gl);
  backdrop(gl);
  nearest(gl);
  int index = 0;
  for (const GLenum format : {GL_RGBA, GL_RGB, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_ALPHA, GL_INTENSITY, GL_RGBA16, GL_RGB8}) {
    gl.CopyTexImage2D(GL_TEXTURE_2D, 0, format, 100 + 9 * index, 120, cell, cell, 0);
    place(gl, index++);
  }
  const Bytes grey(cell * cell * 3, 90);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, cell, cell, 0, GL_RGB, GL_UNSIGNED_BYTE, grey.data());
  for (int i = 0; i < 8; ++i) {
    gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 2 * i, 3 * i, 40 + 20 * i, 160, 12, 7);
    place(gl, index++);
  }
}

// Depth as a luminance texture: copied, and given as floats.
void depth_images(const GlTable& gl) {
  start(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.Disable(GL_TEXTURE_2D);
  gl.Begin(GL_TRIANGLES);
  gl.Vertex3f(100, 100, -1);
  gl.Vertex3f(250, 120, 1);
  gl.Vertex3f(130, 250, 0);
  gl.End();
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_TEXTURE_2D);
  nearest(gl);
  int index = 0;
  for (const GLenum format : {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT}) {
    gl.CopyTexImage2D(GL_TEXTURE_2D, 0, format, 130, 130, cell, cell, 0);
    place(gl, index++);
  }
  const auto floats = ramp<GLfloat>(cell * cell, 0, 1);
  for (const GLint format : {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32}) {
    show(gl, index++, format, GL_DEPTH_COMPONENT, GL_FLOAT, floats.data());
  }
  for (const GLint mode : {GL_INTENSITY, GL_ALPHA}) {
    gl.TexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, mode);
    show(gl, index++, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_FLOAT, floats.data());
  }
}

// Depths as red [ARB_texture_rg], by each environment: texels and border, compared and not, nearest and linear.
void red_depths(const GlTable& gl) {
  start(gl);
  gl.Color4f(0.25f, 0.5f, 0.75f, 0.5f);
  const float border[] = {0.7f, 0.6f, 0.3f, 0.2f};
  gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  gl.TexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_RED);
  const auto floats = ramp<GLfloat>(cell * cell, 0, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, cell, cell, 0, GL_DEPTH_COMPONENT, GL_FLOAT, floats.data());
  int index = 0;
  for (const GLint mode : {GL_REPLACE, GL_MODULATE, GL_DECAL, GL_ADD, GL_BLEND}) {
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode);
    for (const GLint compare : {GL_NONE, GL_COMPARE_R_TO_TEXTURE}) {
      gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, compare);
      for (const GLint filter : {GL_NEAREST, GL_LINEAR}) {
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
        gl.MatrixMode(GL_TEXTURE);
        gl.LoadIdentity();
        gl.Translatef(0, 0, 0.5f);
        gl.MatrixMode(GL_MODELVIEW);
        place(gl, index++, 1.21f);
      }
    }
  }
}

// Blocks as they come: every bit of them random.
void compressed(const GlTable& gl) {
  start(gl);
  nearest(gl);
  Random random(29);
  int index = 0;
  for (const GLenum format : {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_COMPRESSED_RGBA_S3TC_DXT1_EXT,
                              GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT}) {
    const bool small = format == GL_COMPRESSED_RGB_S3TC_DXT1_EXT || format == GL_COMPRESSED_RGBA_S3TC_DXT1_EXT;
    const GLsizei size = 8 * 8 * (small ? 8 : 16);
    const Bytes blocks = random_bytes(random, size);
    gl.CompressedTexImage2D(GL_TEXTURE_2D, 0, format, cell, cell, 0, size, blocks.data());
    place(gl, index++);
    gl.CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 8, 12, 8, 4, format, 2 * (small ? 8 : 16), blocks.data());
    place(gl, index++);
  }
}

// Borders of their own colour, seen by CLAMP with linear filtering. Mesa drops them.
void borders(const GlTable& gl) {
  start(gl);
  Bytes image(10 * 10 * 3, 60);
  for (std::size_t y = 0; y < 10; ++y) {
    for (std::size_t x = 0; x < 10; ++x) {
      if (x > 0 && x < 9 && y > 0 && y < 9) continue;
      image[(y * 10 + x) * 3] = 255;
      image[(y * 10 + x) * 3 + 1] = static_cast<GLubyte>(x * 25);
    }
  }
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 10, 10, 1, GL_RGB, GL_UNSIGNED_BYTE, image.data());
  for (const GLint mode : {GL_CLAMP, GL_CLAMP_TO_BORDER, GL_CLAMP_TO_EDGE, GL_REPEAT}) {
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, mode);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, mode);
    const int index = mode == GL_CLAMP ? 0 : mode == GL_CLAMP_TO_BORDER ? 1 : mode == GL_CLAMP_TO_EDGE ? 2 : 3;
    square(gl, static_cast<float>(4 + 126 * (index % 2)), static_cast<float>(4 + 126 * (index / 2)), 120, 1.5f);
  }
}

// Sizes that are no powers of two, and rectangles, whose coordinates are texels.
void odd_sizes(const GlTable& gl) {
  start(gl);
  Random random(31);
  const Bytes bytes = random_bytes(random, 40 * 40 * 3);
  nearest(gl);
  int index = 0;
  for (const int width : {1, 3, 7, 15, 29}) {
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, width, 31 - width, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
    place(gl, index++, 2.03f);  // no pixel's centre between two texels
  }
  gl.Disable(GL_TEXTURE_2D);
  gl.Enable(GL_TEXTURE_RECTANGLE_ARB);
  nearest(gl, GL_TEXTURE_RECTANGLE_ARB);
  gl.TexImage2D(GL_TEXTURE_RECTANGLE_ARB, 0, GL_RGB8, cell, cell, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
  place(gl, index++, cell);
}

// Each level of a mipmap has its own colour; BASE_LEVEL chooses. The last row is made by GENERATE_MIPMAP.
void levels(const GlTable& gl) {
  start(gl);
  nearest(gl);
  Random random(33);
  for (int level = 0; level < 6; ++level) {
    const int side = 32 >> level;
    const Bytes bytes = random_bytes(random, side * side * 3);
    gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGB8, side, side, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
  }
  const auto row = [&](int first) {
    for (int level = 0; level < 6; ++level) {
      gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, level);
      place(gl, first + level);
    }
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 0);
  };
  row(0);
  gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  const Bytes even(32 * 32 * 3, 90);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 32, 32, 0, GL_RGB, GL_UNSIGNED_BYTE, even.data());
  row(8);
  const Bytes white(16 * 32 * 3, 255);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 16, 0, 16, 32, GL_RGB, GL_UNSIGNED_BYTE, white.data());
  row(16);
}

// Bound, drawn with, changed, deleted, and bound again while draws still wait.
void objects(const GlTable& gl) {
  start(gl);
  Random random(35);
  std::array<GLuint, 4> names{};
  gl.GenTextures(4, names.data());
  for (const GLuint name : names) {
    gl.BindTexture(GL_TEXTURE_2D, name);
    nearest(gl);
    const Bytes bytes = random_bytes(random, cell * cell * 3);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, cell, cell, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
  }
  int index = 0;
  for (int round = 0; round < 3; ++round) {
    for (const GLuint name : names) {
      gl.BindTexture(GL_TEXTURE_2D, name);
      place(gl, index++);
    }
    const Bytes bytes = random_bytes(random, cell * cell * 3);
    if (round == 0) gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, cell, cell, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
    if (round == 1) gl.DeleteTextures(2, names.data());
  }
}

}  // namespace

SceneList texture_image_scenes() {
  constexpr std::string_view section = "§3.8.1";
  return {
      {.name = "tex_image_byte_formats", .section = section,
       .shows = "Noise in every format of bytes, stored with alpha and without.", .draw = byte_formats},
      {.name = "tex_image_types", .section = section,
       .shows = "One ramp in seven types, as colours and as greys.", .draw = types},
      {.name = "tex_image_packed_types", .section = section,
       .shows = "Noise in every packed type.", .draw = packed_types},
      {.name = "tex_image_narrow_formats", .section = section,
       .shows = "Noise of few levels in the formats of few bits.", .draw = narrow_formats},
      {.name = "tex_image_wide_formats", .section = section,
       .shows = "Noise in the formats of 8 bits and more.", .draw = wide_formats},
      {.name = "tex_image_few_colors", .section = section,
       .shows = "Noise in red alone and in red and green, by five environments.", .judge = Judge::textures, .draw = few_colors},
      {.name = "tex_image_red_depths", .section = section,
       .shows = "A ramp of depths in red, by five environments.", .judge = Judge::textures, .draw = red_depths},
      {.name = "tex_image_base_formats", .section = section,
       .shows = "What eight base formats take from colours, by three environments.", .draw = base_formats},
      {.name = "tex_image_pixel_store", .section = section,
       .shows = "Parts of one block of noise by way of the pixel store.", .draw = pixel_store},
      {.name = "tex_image_pixel_transfer", .section = section,
       .shows = "Noise scaled, inverted, mapped; and palette colours.", .draw = pixel_transfer},
      {.name = "tex_sub_image", .section = "§3.8.2",
       .shows = "Forty states of one texture that is patched between draws.", .draw = sub_images},
      {.name = "tex_image_volumes", .section = section,
       .shows = "Eight slices of a volume, three of them patched; a texture of one row.", .draw = volumes},
      {.name = "tex_image_copies", .section = "§3.8.2",
       .shows = "Pieces of a picture of triangles as textures, whole and patched.", .draw = copies},
      {.name = "tex_image_depth", .section = section,
       .shows = "Depth as grey: copied, given, and as intensity and alpha.", .draw = depth_images},
      {.name = "tex_image_s3tc", .section = "§3.8.3",
       .shows = "Random DXT1, DXT3 and DXT5 blocks, each also with two blocks replaced.", .draw = compressed},
      {.name = "tex_image_borders", .section = section,
       .shows = "A red rim of border texels by four wrap modes: at the edge, outside, never, never.",
       .judge = Judge::oracle_only,  // Mesa drops borders (MESA-RULES 7.7)
       .draw = borders},
      {.name = "tex_image_odd_sizes", .section = section,
       .shows = "Repeated noise of odd sizes, and a rectangle.", .draw = odd_sizes},
      {.name = "tex_image_levels", .section = section,
       .shows = "Six levels of noise, of grey, and of grey and white, ever coarser.", .draw = levels},
      {.name = "texture_objects", .section = "§3.8.12",
       .shows = "Four textures thrice; one has changed, then two are gone.", .draw = objects},
  };
}

}  // namespace gouraud::conformance
