// Features of random pictures: pixel rectangles, bitmaps, copies, accumulation, and framebuffer objects drawn to and copied.
#include <array>

#include "conformance/fuzz/pictures.h"

namespace gouraud::conformance {
namespace {

std::array<GLubyte, 2048> noise(Brush& b) {
  std::array<GLubyte, 2048> bytes{};
  for (GLubyte& byte : bytes) byte = static_cast<GLubyte>(17 * b.below(16));
  return bytes;
}

/// Unlit: depths that Mesa draws have the current colour.
void position(Brush& b) {
  const bool lit = b.gl.IsEnabled(GL_LIGHTING) == GL_TRUE;
  b.gl.Disable(GL_LIGHTING);
  b.gl.Color4fv(b.color().v);
  if (b.chance(2)) {
    in_order(b.gl.WindowPos2i, std::tuple{b.below(40), b.below(40)});
  } else {
    in_order(b.gl.RasterPos3f, std::tuple{b.range(-0.9f, 0.7f), b.range(-0.9f, 0.7f), b.range(-0.9f, 0.9f)});
  }
  if (lit) b.gl.Enable(GL_LIGHTING);
}

void draw_pixels(Brush& b) {
  const std::array<GLubyte, 2048> bytes = noise(b);
  position(b);
  const GLenum format = b.one_of({GL_RGBA, GL_BGRA, GL_RGB, GL_BGR, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA});
  const GLenum type = b.one_of({GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_BYTE});
  b.gl.DrawPixels(12, 9, format, type, bytes.data());
}

void draw_stencil_or_depth(Brush& b) {
  const std::array<GLubyte, 2048> bytes = noise(b);
  position(b);
  b.gl.Enable(GL_DEPTH_TEST);
  b.gl.DepthFunc(GL_ALWAYS);
  in_order(b.gl.DrawPixels, std::tuple{14, 11, b.one_of({GL_STENCIL_INDEX, GL_DEPTH_COMPONENT}), b.one_of({GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT}), bytes.data()});
  b.gl.DepthFunc(GL_LESS);
}

void packed_pixels(Brush& b) {
  const std::array<GLubyte, 2048> bytes = noise(b);
  position(b);
  const bool three = b.chance(2);
  const GLenum type = three ? b.one_of({GL_UNSIGNED_SHORT_5_6_5, GL_UNSIGNED_SHORT_5_6_5_REV})
                            : b.one_of({GL_UNSIGNED_SHORT_4_4_4_4, GL_UNSIGNED_SHORT_4_4_4_4_REV, GL_UNSIGNED_INT_8_8_8_8, GL_UNSIGNED_INT_8_8_8_8_REV});
  b.gl.DrawPixels(10, 10, three ? GL_RGB : b.one_of({GL_RGBA, GL_BGRA}), type, bytes.data());
}

void bitmap(Brush& b) {
  const std::array<GLubyte, 2048> bytes = noise(b);
  position(b);
  // Side by side: Mesa draws several at once, and a pixel of them once.
  for (int i = 0; i < 3; ++i) {
    const float x = b.range(0.0f, 5.0f), y = b.range(0.0f, 5.0f), move = b.range(-3.0f, 9.0f);
    b.gl.Bitmap(13, 11, x, y, 18.0f, move, bytes.data());
  }
}

void copy_pixels(Brush& b) {
  b.gl.Rectf(-0.9f, -0.9f, -0.2f, -0.3f);
  position(b);
  in_order(b.gl.CopyPixels, std::tuple{b.below(20), b.below(20), 16, 13, b.one_of({GL_COLOR, GL_COLOR, GL_DEPTH, GL_STENCIL})});
}

/// By whole numbers: for others it matters that Mesa rounds the raster position.
void zoom(Brush& b) {
  const int x = b.below(7) - 3, y = b.below(7) - 3;
  b.gl.PixelZoom(static_cast<float>(x), static_cast<float>(y));
}

void transfer(Brush& b) {
  for (GLenum component = 0; component < 4; ++component) {
    b.gl.PixelTransferf(GL_RED_SCALE + 2 * component + (component > 0 ? 2u : 0u), b.level() + 0.5f);
    b.gl.PixelTransferf(GL_RED_BIAS + 2 * component + (component > 0 ? 2u : 0u), b.range(-0.5f, 0.5f));
  }
  if (b.chance(2)) return;
  std::array<float, 16> map{};
  for (float& value : map) value = b.level();
  for (GLenum i = 0; i < 4; ++i) b.gl.PixelMapfv(GL_PIXEL_MAP_R_TO_R + i, 16, map.data());
  b.gl.PixelTransferi(GL_MAP_COLOR, GL_TRUE);
}

void storage(Brush& b) {
  float red_scale = 1.0f;
  b.gl.GetFloatv(GL_RED_SCALE, &red_scale);
  const bool skips = red_scale == 1.0f;  // Mesa skips nothing of texture images that it transfers
  b.gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 16 + b.below(4));
  b.gl.PixelStorei(GL_UNPACK_SKIP_ROWS, skips ? b.below(3) : 0);
  b.gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, skips ? b.below(3) : 0);
  b.gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1 << b.below(4));
  b.gl.PixelStorei(GL_UNPACK_LSB_FIRST, b.below(2));
  b.gl.PixelStorei(GL_UNPACK_SWAP_BYTES, b.below(2));
}

void copied_texture(Brush& b) {
  b.gl.Rectf(-0.8f, -0.6f, 0.3f, 0.5f);
  b.gl.BindTexture(GL_TEXTURE_2D, 10);
  b.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  b.gl.PushAttrib(GL_PIXEL_MODE_BIT);
  initial_pixel_transfer(b.gl);  // Mesa transfers the first row alone
  in_order(b.gl.CopyTexImage2D, std::tuple{GL_TEXTURE_2D, 0, b.one_of({GL_RGBA, GL_RGB, GL_LUMINANCE, GL_ALPHA, GL_INTENSITY}), b.below(30), b.below(30), 16, 16, 0});
  if (b.chance(2)) in_order(b.gl.CopyTexSubImage2D, std::tuple{GL_TEXTURE_2D, 0, 3, 4, b.below(30), b.below(30), 9, 8});
  b.gl.PopAttrib();
  b.gl.Enable(GL_TEXTURE_2D);
}

void accumulation(Brush& b) {
  // Sums are at most 1: Mesa's wrap around beyond.
  in_order(b.gl.ClearAccum, std::tuple{0.25f * b.level(), 0.25f * b.level(), 0.25f * b.level(), 0.25f * b.level()});
  b.gl.Clear(GL_ACCUM_BUFFER_BIT);
  b.gl.Rectf(-0.6f, -0.8f, 0.5f, 0.9f);
  b.gl.Accum(b.one_of({GL_LOAD, GL_ACCUM}), 0.5f);
  in_order(b.gl.Accum, std::tuple{b.one_of({GL_ADD, GL_MULT}), 0.25f * b.level()});
  b.gl.Accum(GL_RETURN, b.level());
}

void rendered_texture(Brush& b) {
  const GlTable& gl = b.gl;
  gl.BindTexture(GL_TEXTURE_2D, 11);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 11, 0);
  gl.Disable(GL_POLYGON_STIPPLE);  // Mesa's lies elsewhere in framebuffer objects
  gl.Disable(GL_TEXTURE_2D);       // what is drawn into is not to be read
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Color4fv(b.color().v);
  in_order(gl.Rectf, std::tuple{b.range(-0.9f, 0.0f), -0.7f, 0.8f, b.range(0.0f, 0.9f)});
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  if (b.chance(2)) in_order(gl.BlitFramebuffer, std::tuple{0, 0, 32, 32, b.below(20), b.below(20), 30 + b.below(30), 30 + b.below(30), GL_COLOR_BUFFER_BIT, GL_NEAREST});
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.Enable(GL_TEXTURE_2D);
}

constexpr Feature features[] = {
    {"accumulation", accumulation},
    {"pixel_zoom", zoom},
    {"pixel_transfer", transfer},
    {"pixel_storage", storage},
    {"draw_pixels", draw_pixels},
    {"packed_pixels", packed_pixels},
    {"draw_stencil_or_depth", draw_stencil_or_depth},
    {"bitmap", bitmap},
    {"copy_pixels", copy_pixels},
    {"copied_texture", copied_texture},
    {"rendered_texture", rendered_texture},
};

}  // namespace

std::span<const Feature> pixel_features() { return features; }

}  // namespace gouraud::conformance
