// Pixel rectangles, pixel transfer, bitmaps and copies. [GL1.5 §3.6.4, §3.6.5, §3.7, §4.3.3]
//
// Raster positions lie away from where Mesa rounds otherwise than the specification (MESA-RULES 9).
#include <array>
#include <vector>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

std::vector<GLubyte> noise(Random& random, int count) {
  std::vector<GLubyte> bytes;
  for (int i = 0; i < count; ++i) bytes.push_back(static_cast<GLubyte>(random.below(256)));
  return bytes;
}

void ground(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

// The harness reads the picture with glReadPixels, which would transfer as well.
void end_transfer(const GlTable& gl) {
  for (const GLenum scale : {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE}) gl.PixelTransferf(scale, 1);
  for (const GLenum bias : {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_DEPTH_BIAS}) gl.PixelTransferf(bias, 0);
  gl.PixelTransferi(GL_MAP_COLOR, GL_FALSE);
  gl.PixelTransferi(GL_INDEX_SHIFT, 0);
  gl.PixelTransferi(GL_INDEX_OFFSET, 0);
}

// Every format as bytes, in a grid.
void formats(const GlTable& gl) {
  constexpr std::array<GLenum, 11> names{GL_RED,  GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_BGR,
                                         GL_RGBA, GL_BGRA,  GL_ABGR_EXT, GL_LUMINANCE, GL_LUMINANCE_ALPHA};
  ground(gl);
  Random random(41);
  const auto bytes = noise(random, 50 * 50 * 4);
  for (std::size_t i = 0; i < names.size(); ++i) {
    gl.RasterPos2i(5 + 62 * static_cast<int>(i % 4), 7 + 62 * static_cast<int>(i / 4));
    gl.DrawPixels(50, 50, names[i], GL_UNSIGNED_BYTE, bytes.data());
  }
}

void packed_types(const GlTable& gl) {
  struct Type {
    GLenum format, type;
  };
  constexpr std::array<Type, 12> types{
      Type{GL_RGB, GL_UNSIGNED_BYTE_3_3_2}, {GL_RGB, GL_UNSIGNED_BYTE_2_3_3_REV}, {GL_RGB, GL_UNSIGNED_SHORT_5_6_5},
      {GL_RGB, GL_UNSIGNED_SHORT_5_6_5_REV}, {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4}, {GL_BGRA, GL_UNSIGNED_SHORT_4_4_4_4_REV},
      {GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1}, {GL_BGRA, GL_UNSIGNED_SHORT_1_5_5_5_REV}, {GL_RGBA, GL_UNSIGNED_INT_8_8_8_8},
      {GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV}, {GL_RGBA, GL_UNSIGNED_INT_10_10_10_2}, {GL_BGRA, GL_UNSIGNED_INT_2_10_10_10_REV}};
  ground(gl);
  Random random(43);
  const auto bytes = noise(random, 50 * 50 * 4);
  for (std::size_t i = 0; i < types.size(); ++i) {
    gl.RasterPos2i(5 + 62 * static_cast<int>(i % 4), 7 + 62 * static_cast<int>(i / 4));
    gl.PixelStorei(GL_UNPACK_SWAP_BYTES, i % 2 != 0);
    gl.DrawPixels(50, 50, types[i].format, types[i].type, bytes.data());
  }
}

using Zooms = std::array<std::array<float, 2>, 9>;
constexpr Zooms whole_zooms{{{2, 2}, {-2, 3}, {3, -2}, {-4, -4}, {1, 2}, {8, 1}, {1, -5}, {-1, 6}, {7, 7}}};
constexpr Zooms broken_zooms{{{1.5f, 1.5f}, {-2.25f, 3}, {0.5f, -2}, {-4.5f, -0.75f}, {1, 0.3f}, {8, 0.25f}, {3.1f, -5}, {-0.5f, 6}, {7, 7.7f}}};

// One small image under many zooms, cut by the window's borders.
void zooms(const GlTable& gl, const Zooms& factors) {
  ground(gl);
  Random random(47);
  const auto bytes = noise(random, 12 * 10 * 4);
  for (std::size_t i = 0; i < factors.size(); ++i) {
    gl.PixelZoom(factors[i][0], factors[i][1]);
    gl.RasterPos2i(50 + 80 * static_cast<int>(i % 3), 40 + 80 * static_cast<int>(i / 3));
    gl.DrawPixels(12, 10, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  }
}

// A part of a larger image: row length and skips.
void sub_images(const GlTable& gl) {
  ground(gl);
  Random random(53);
  const auto bytes = noise(random, 101 * 90 * 3);
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 101);
  for (int i = 0; i < 9; ++i) {
    gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 11 * (i % 3));
    gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 7 * (i / 3));
    gl.RasterPos2i(3 + 84 * (i % 3), 5 + 84 * (i / 3));
    gl.DrawPixels(70, 72, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
  }
}

// Images blended over each other, tested for alpha, under scissor and colour mask.
void fragment_operations(const GlTable& gl) {
  ground(gl);
  Random random(59);
  const auto bytes = noise(random, 120 * 120 * 4);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  gl.RasterPos2i(10, 12);
  gl.DrawPixels(120, 120, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  gl.RasterPos2i(70, 62);
  gl.DrawPixels(120, 120, GL_BGRA, GL_UNSIGNED_BYTE, bytes.data());
  gl.Disable(GL_BLEND);
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_GREATER, 0.4f);
  gl.RasterPos2i(130, 125);
  gl.DrawPixels(120, 120, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  gl.Disable(GL_ALPHA_TEST);
  gl.ColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(33, 141, 77, 81);
  gl.RasterPos2i(10, 130);
  gl.DrawPixels(120, 120, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
}

// The raster position's depth decides between an image and triangles.
void depth_of_position(const GlTable& gl) {
  ground(gl);
  Random random(61);
  const auto bytes = noise(random, 100 * 100 * 4);
  gl.Enable(GL_DEPTH_TEST);
  gl.Begin(GL_QUADS);
  gl.Color3f(0.2f, 0.5f, 0.9f);
  gl.Vertex3f(20.5f, 20.5f, 0.1f);
  gl.Vertex3f(230.5f, 30.5f, 0.1f);
  gl.Vertex3f(220.5f, 230.5f, 0.1f);
  gl.Vertex3f(30.5f, 215.5f, 0.1f);
  gl.End();
  for (int i = 0; i < 4; ++i) {
    gl.RasterPos3f(15 + 120 * static_cast<float>(i % 2), 17 + 120 * static_cast<float>(i / 2), 0.4f - 0.27f * static_cast<float>(i));
    gl.DrawPixels(100, 100, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  }
}

// A depth image is drawn in the raster colour; triangles are hidden by it.
void depth_images(const GlTable& gl) {
  ground(gl);
  gl.Enable(GL_DEPTH_TEST);
  std::vector<GLuint> hill;
  for (int j = 0; j < 100; ++j) {
    for (int i = 0; i < 100; ++i) hill.push_back(static_cast<GLuint>((i - 50) * (i - 50) + (j - 50) * (j - 50)) * 850000u);
  }
  gl.Color3f(0.8f, 0.6f, 0.1f);
  gl.RasterPos2i(60, 55);
  gl.DrawPixels(100, 100, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, hill.data());
  gl.PixelTransferf(GL_DEPTH_SCALE, 0.5f);
  gl.PixelTransferf(GL_DEPTH_BIAS, 0.25f);
  gl.RasterPos2i(140, 130);
  gl.DrawPixels(100, 100, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, hill.data());
  gl.Color3f(0.1f, 0.7f, 0.6f);
  draw_rectangle(gl, 40.5f, 90.5f, 240.5f, 180.5f, 0.0f);
  end_transfer(gl);
}

void transfer(const GlTable& gl) {
  ground(gl);
  Random random(67);
  const auto bytes = noise(random, 100 * 100 * 4);
  gl.PixelTransferf(GL_RED_SCALE, 1.7f);
  gl.PixelTransferf(GL_GREEN_SCALE, -1.0f);
  gl.PixelTransferf(GL_GREEN_BIAS, 1.0f);
  gl.PixelTransferf(GL_BLUE_BIAS, -0.3f);
  gl.RasterPos2i(11, 13);
  gl.DrawPixels(100, 100, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  gl.RasterPos2i(131, 15);
  gl.DrawPixels(100, 100, GL_LUMINANCE_ALPHA, GL_UNSIGNED_SHORT, bytes.data());
  gl.PixelTransferf(GL_RED_SCALE, 0.5f);
  gl.RasterPos2i(13, 135);
  gl.CopyPixels(11, 13, 100, 100, GL_COLOR);
  end_transfer(gl);
}

// Mesa confuses entries of the maps.
void maps(const GlTable& gl) {
  ground(gl);
  Random random(71);
  const auto bytes = noise(random, 100 * 100 * 4);
  for (GLenum map = GL_PIXEL_MAP_I_TO_R; map <= GL_PIXEL_MAP_A_TO_A; ++map) {
    std::vector<GLfloat> entries;
    for (int i = 0; i < 16; ++i) entries.push_back(random.range(0, 1));
    gl.PixelMapfv(map, 16, entries.data());
  }
  gl.RasterPos2i(11, 13);
  gl.DrawPixels(100, 100, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes.data());
  gl.PixelTransferi(GL_INDEX_SHIFT, -3);
  gl.PixelTransferi(GL_INDEX_OFFSET, 5);
  gl.RasterPos2i(131, 13);
  gl.DrawPixels(100, 100, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes.data());
  gl.PixelTransferi(GL_MAP_COLOR, GL_TRUE);
  gl.RasterPos2i(11, 133);
  gl.DrawPixels(100, 100, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  end_transfer(gl);
}

constexpr std::array<GLubyte, 13> letter_g{0x00, 0x3E, 0x41, 0x41, 0x47, 0x40, 0x40, 0x40, 0x41, 0x3E, 0, 0, 0};
constexpr std::array<GLubyte, 13> letter_l{0x00, 0x7F, 0x40, 0x40, 0x40, 0x40, 0x40, 0x40, 0x40, 0x40, 0, 0, 0};

// Text runs on from glyph to glyph, at positions between pixels too.
void text(const GlTable& gl) {
  ground(gl);
  Random random(73);
  for (int line = 0; line < 18; ++line) {
    color_of(gl, random);
    gl.RasterPos2f(4.25f + 0.1f * static_cast<float>(line), 6.25f + 13.7f * static_cast<float>(line));
    for (int i = 0; i < 24; ++i) gl.Bitmap(8, 13, 0, 2, 8.7f + 0.2f * static_cast<float>(line % 5), 0, (i % 3 ? letter_g : letter_l).data());
  }
}

void bitmaps(const GlTable& gl) {
  ground(gl);
  Random random(79);
  const auto bytes = noise(random, 40 * 170);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  for (int i = 0; i < 7; ++i) {
    gl.PixelStorei(GL_UNPACK_LSB_FIRST, i % 2);
    gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 3 * i);
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 300);
    gl.Color4f(0.15f * static_cast<float>(i), 0.9f - 0.1f * static_cast<float>(i), 0.5f, 0.4f + 0.08f * static_cast<float>(i));
    gl.RasterPos2f(5.25f + 17 * static_cast<float>(i), 3.25f + 11 * static_cast<float>(i));
    gl.Bitmap(150 + i, 170, 2.5f * static_cast<float>(i), 1, 0, 0, bytes.data());
  }
}

void copies(const GlTable& gl) {
  ground(gl);
  Random random(83);
  const auto bytes = noise(random, 60 * 60 * 4);
  gl.RasterPos2i(10, 10);
  gl.DrawPixels(60, 60, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  gl.RasterPos2i(21, 17);
  gl.CopyPixels(10, 10, 60, 60, GL_COLOR);
  gl.PixelZoom(2, -1.0f);
  gl.RasterPos2i(100, 90);
  gl.CopyPixels(10, 10, 60, 60, GL_COLOR);
  gl.PixelZoom(-3, 3);
  gl.RasterPos2i(230, 110);
  gl.CopyPixels(20, 20, 50, 40, GL_COLOR);
}

}  // namespace

SceneList pixel_scenes() {
  return {
      {.name = "pixels_formats", .section = "§3.6.4", .shows = "Eleven squares of noise, one a format.", .draw = formats},
      {.name = "pixels_packed_types", .section = "§3.6.4", .shows = "Twelve squares of noise, one a packed type.", .draw = packed_types},
      {.name = "pixels_zooms", .section = "§3.6.4", .shows = "A small image enlarged, shrunk and mirrored nine ways.",
       .draw = [](const GlTable& gl) { zooms(gl, whole_zooms); }},
      {.name = "pixels_fractional_zooms",  // where a border meets a centre Mesa takes the neighbouring pixel
       .section = "§3.6.4",
       .shows = "The same image by factors that are no whole numbers.",
       .judge = Judge::oracle_only,
       .draw = [](const GlTable& gl) { zooms(gl, broken_zooms); }},
      {.name = "pixels_sub_images", .section = "§3.6.4", .shows = "Nine parts of one image, side by side.", .draw = sub_images},
      {.name = "pixels_fragment_operations",
       .section = "§3.6.4",
       .shows = "Squares of noise: two added, one with holes by the alpha test, one red and cut by the scissor.",
       .draw = fragment_operations},
      {.name = "pixels_depth_of_position",
       .section = "§3.6.4",
       .shows = "Four squares of noise, two of them behind a quadrilateral.",
       .draw = depth_of_position},
      {.name = "pixels_depth_images",
       .section = "§3.6.4",
       .shows = "Two yellow squares, whose depths form hills that stick out of a green rectangle.",
       .draw = depth_images},
      {.name = "pixels_transfer",  // Mesa errs by up to 1.5/255 of the oracle: it rounds to bytes on the way
       .section = "§3.6.5",
       .shows = "Noise with more red, inverted green and less blue; a copy of it.",
       .judge = Judge::oracle_only,
       .draw = transfer},
      {.name = "pixels_maps",
       .section = "§3.6.5",
       .shows = "Two squares in 16 colours from the maps of indices, one through the maps of components.",
       .judge = Judge::oracle_only,
       .draw = maps},
      {.name = "bitmap_text", .section = "§3.7", .shows = "Eighteen lines of the letters L and G.", .draw = text},
      {.name = "bitmap_noise", .section = "§3.7", .shows = "Seven overlapping transparent squares of random dots.", .draw = bitmaps},
      {.name = "pixels_copies", .section = "§4.3.3", .shows = "A square of noise, copied over itself, stretched and mirrored.", .draw = copies},
  };
}

}  // namespace gouraud::conformance
