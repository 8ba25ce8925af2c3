// Every typed form of Vertex, Normal and Color, with the conversions of Table 2.9. [GL1.5 §2.7]
#include <array>
#include <functional>
#include <vector>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

struct Corner {
  int x, y, z;
};
constexpr std::array<Corner, 3> corners = {{{3, 4, -20}, {36, 9, 10}, {17, 37, 30}}};

/// Calls `vertex(corner, form)` for the three corners of a triangle in each of `count` cells of a 6-column grid.
void draw_cells(const GlTable& gl, int count, const std::function<void(const Corner&, int form)>& vertex) {
  Random random(51);
  for (int form = 0; form < count; ++form) {
    const float x = static_cast<float>(42 * (form % 6)), y = static_cast<float>(42 * (form / 6));
    load_model_view(gl, translation(x + 2.3f, y + 2.7f, 0));
    gl.Begin(GL_TRIANGLES);
    for (const Corner& corner : corners) {
      color_of(gl, random);
      vertex(corner, form);
    }
    gl.End();
  }
}

template <class T>
T to(int value) {
  return static_cast<T>(value);
}

// Forms 0-3: 2s 2i 2f 2d, 4-7: their vectors.
void vertex_2(const GlTable& gl, const Corner& c, int form) {
  const std::array s = {to<GLshort>(c.x), to<GLshort>(c.y)};
  const std::array i = {c.x, c.y};
  const std::array f = {to<GLfloat>(c.x), to<GLfloat>(c.y)};
  const std::array d = {to<GLdouble>(c.x), to<GLdouble>(c.y)};
  switch (form) {
    case 0:
      return gl.Vertex2s(s[0], s[1]);
    case 1:
      return gl.Vertex2i(i[0], i[1]);
    case 2:
      return gl.Vertex2f(f[0], f[1]);
    case 3:
      return gl.Vertex2d(d[0], d[1]);
    case 4:
      return gl.Vertex2sv(s.data());
    case 5:
      return gl.Vertex2iv(i.data());
    case 6:
      return gl.Vertex2fv(f.data());
    default:
      return gl.Vertex2dv(d.data());
  }
}

void vertex_3(const GlTable& gl, const Corner& c, int form) {
  const std::array s = {to<GLshort>(c.x), to<GLshort>(c.y), to<GLshort>(c.z)};
  const std::array i = {c.x, c.y, c.z};
  const std::array f = {to<GLfloat>(c.x), to<GLfloat>(c.y), to<GLfloat>(c.z)};
  const std::array d = {to<GLdouble>(c.x), to<GLdouble>(c.y), to<GLdouble>(c.z)};
  switch (form) {
    case 0:
      return gl.Vertex3s(s[0], s[1], s[2]);
    case 1:
      return gl.Vertex3i(i[0], i[1], i[2]);
    case 2:
      return gl.Vertex3f(f[0], f[1], f[2]);
    case 3:
      return gl.Vertex3d(d[0], d[1], d[2]);
    case 4:
      return gl.Vertex3sv(s.data());
    case 5:
      return gl.Vertex3iv(i.data());
    case 6:
      return gl.Vertex3fv(f.data());
    default:
      return gl.Vertex3dv(d.data());
  }
}

// With w = 2: twice the coordinates for the same place.
void vertex_4(const GlTable& gl, const Corner& c, int form) {
  const std::array i = {2 * c.x, 2 * c.y, 2 * c.z, 2};
  const std::array s = {to<GLshort>(i[0]), to<GLshort>(i[1]), to<GLshort>(i[2]), to<GLshort>(i[3])};
  const std::array f = {to<GLfloat>(i[0]), to<GLfloat>(i[1]), to<GLfloat>(i[2]), to<GLfloat>(i[3])};
  const std::array d = {to<GLdouble>(i[0]), to<GLdouble>(i[1]), to<GLdouble>(i[2]), to<GLdouble>(i[3])};
  switch (form) {
    case 0:
      return gl.Vertex4s(s[0], s[1], s[2], s[3]);
    case 1:
      return gl.Vertex4i(i[0], i[1], i[2], i[3]);
    case 2:
      return gl.Vertex4f(f[0], f[1], f[2], f[3]);
    case 3:
      return gl.Vertex4d(d[0], d[1], d[2], d[3]);
    case 4:
      return gl.Vertex4sv(s.data());
    case 5:
      return gl.Vertex4iv(i.data());
    case 6:
      return gl.Vertex4fv(f.data());
    default:
      return gl.Vertex4dv(d.data());
  }
}

void vertex_forms(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 176);
  // The corners' z, up to 30, is brought into [-1, 1] by the projection.
  gl.MatrixMode(GL_PROJECTION);
  gl.Scalef(1, 1, 0.03125f);
  gl.MatrixMode(GL_MODELVIEW);
  gl.Enable(GL_DEPTH_TEST);
  draw_cells(gl, 24, [&](const Corner& corner, int form) {
    if (form < 8)
      vertex_2(gl, corner, form);
    else if (form < 16)
      vertex_3(gl, corner, form - 8);
    else
      vertex_4(gl, corner, form - 16);
  });
}

struct Rgba {
  double red, green, blue, alpha;  ///< 0 .. 1
};
constexpr std::array<Rgba, 3> corner_colors = {
    {{0.91, 0.17, 0.23, 0.83}, {0.12, 0.77, 0.36, 0.59}, {0.27, 0.33, 0.94, 1}}};

/// `highest` is what stands for 1; integers are truncated.
template <class T>
std::array<T, 4> scaled(const Rgba& color, double highest) {
  const auto part = [&](double value) { return static_cast<T>(value * highest); };
  return {part(color.red), part(color.green), part(color.blue), part(color.alpha)};
}

// Forms 0-7: b s i f d ub us ui; 8-15: their vectors.
void color_3(const GlTable& gl, const Rgba& color, int form) {
  const auto b = scaled<GLbyte>(color, 127);
  const auto s = scaled<GLshort>(color, 32767);
  const auto i = scaled<GLint>(color, 2147483647);
  const auto f = scaled<GLfloat>(color, 1);
  const auto d = scaled<GLdouble>(color, 1);
  const auto ub = scaled<GLubyte>(color, 255);
  const auto us = scaled<GLushort>(color, 65535);
  const auto ui = scaled<GLuint>(color, 4294967295.0);
  switch (form) {
    case 0:
      return gl.Color3b(b[0], b[1], b[2]);
    case 1:
      return gl.Color3s(s[0], s[1], s[2]);
    case 2:
      return gl.Color3i(i[0], i[1], i[2]);
    case 3:
      return gl.Color3f(f[0], f[1], f[2]);
    case 4:
      return gl.Color3d(d[0], d[1], d[2]);
    case 5:
      return gl.Color3ub(ub[0], ub[1], ub[2]);
    case 6:
      return gl.Color3us(us[0], us[1], us[2]);
    case 7:
      return gl.Color3ui(ui[0], ui[1], ui[2]);
    case 8:
      return gl.Color3bv(b.data());
    case 9:
      return gl.Color3sv(s.data());
    case 10:
      return gl.Color3iv(i.data());
    case 11:
      return gl.Color3fv(f.data());
    case 12:
      return gl.Color3dv(d.data());
    case 13:
      return gl.Color3ubv(ub.data());
    case 14:
      return gl.Color3usv(us.data());
    default:
      return gl.Color3uiv(ui.data());
  }
}

void color_4(const GlTable& gl, const Rgba& color, int form) {
  const auto b = scaled<GLbyte>(color, 127);
  const auto s = scaled<GLshort>(color, 32767);
  const auto i = scaled<GLint>(color, 2147483647);
  const auto f = scaled<GLfloat>(color, 1);
  const auto d = scaled<GLdouble>(color, 1);
  const auto ub = scaled<GLubyte>(color, 255);
  const auto us = scaled<GLushort>(color, 65535);
  const auto ui = scaled<GLuint>(color, 4294967295.0);
  switch (form) {
    case 0:
      return gl.Color4b(b[0], b[1], b[2], b[3]);
    case 1:
      return gl.Color4s(s[0], s[1], s[2], s[3]);
    case 2:
      return gl.Color4i(i[0], i[1], i[2], i[3]);
    case 3:
      return gl.Color4f(f[0], f[1], f[2], f[3]);
    case 4:
      return gl.Color4d(d[0], d[1], d[2], d[3]);
    case 5:
      return gl.Color4ub(ub[0], ub[1], ub[2], ub[3]);
    case 6:
      return gl.Color4us(us[0], us[1], us[2], us[3]);
    case 7:
      return gl.Color4ui(ui[0], ui[1], ui[2], ui[3]);
    case 8:
      return gl.Color4bv(b.data());
    case 9:
      return gl.Color4sv(s.data());
    case 10:
      return gl.Color4iv(i.data());
    case 11:
      return gl.Color4fv(f.data());
    case 12:
      return gl.Color4dv(d.data());
    case 13:
      return gl.Color4ubv(ub.data());
    case 14:
      return gl.Color4usv(us.data());
    default:
      return gl.Color4uiv(ui.data());
  }
}

void color_forms(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  draw_cells(gl, 32, [&](const Corner& corner, int form) {
    const Rgba& color = corner_colors[static_cast<std::size_t>(&corner - corners.data())];
    if (form < 16)
      color_3(gl, color, form);
    else
      color_4(gl, color, form - 16);
    gl.Vertex2i(corner.x, corner.y);
  });
}

// Signed bytes and shorts from their lowest to their highest: (2c + 1) / (2^b - 1), negative ones clamped to black.
void signed_color_range(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 128);
  gl.ShadeModel(GL_FLAT);
  for (int value = -128; value < 128; ++value) {
    const float x = static_cast<float>(value + 128);
    gl.Color3b(static_cast<GLbyte>(value), static_cast<GLbyte>(-1 - value), 60);
    draw_rectangle(gl, x, 67, x + 1, 120, 0);
    gl.Color3s(static_cast<GLshort>(value * 256 + 85), static_cast<GLshort>(-1 - value * 256), 20000);
    draw_rectangle(gl, x, 8, x + 1, 61, 0);
  }
}

void normal_forms(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 88);
  black_lighting(gl, 1);
  light(gl, GL_LIGHT0, GL_DIFFUSE, {1, 1, 1, 1});
  light(gl, GL_LIGHT0, GL_POSITION, {0.3f, 0.5f, 0.8f, 0});
  constexpr std::array<Rgba, 3> normals = {{{-0.61, -0.52, 0.59, 0}, {0.72, -0.21, 0.66, 0}, {-0.11, 0.83, 0.54, 0}}};
  draw_cells(gl, 10, [&](const Corner& corner, int form) {
    const Rgba& normal = normals[static_cast<std::size_t>(&corner - corners.data())];
    const auto b = scaled<GLbyte>(normal, 127);
    const auto s = scaled<GLshort>(normal, 32767);
    const auto i = scaled<GLint>(normal, 2147483647);
    const auto f = scaled<GLfloat>(normal, 1);
    const auto d = scaled<GLdouble>(normal, 1);
    material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.09f * static_cast<float>(form), 0.35f, 1});
    switch (form) {
      case 0:
        gl.Normal3b(b[0], b[1], b[2]);
        break;
      case 1:
        gl.Normal3s(s[0], s[1], s[2]);
        break;
      case 2:
        gl.Normal3i(i[0], i[1], i[2]);
        break;
      case 3:
        gl.Normal3f(f[0], f[1], f[2]);
        break;
      case 4:
        gl.Normal3d(d[0], d[1], d[2]);
        break;
      case 5:
        gl.Normal3bv(b.data());
        break;
      case 6:
        gl.Normal3sv(s.data());
        break;
      case 7:
        gl.Normal3iv(i.data());
        break;
      case 8:
        gl.Normal3fv(f.data());
        break;
      default:
        gl.Normal3dv(d.data());
        break;
    }
    gl.Vertex2i(corner.x, corner.y);
  });
}

}  // namespace

SceneList vertex_scenes() {
  constexpr auto section = "§2.7";
  return {
      {.name = "vertex_forms",
       .section = section,
       .shows = "24 triangles of equal shape, each from another form of glVertex.",
       .width_px = 256,
       .height_px = 176,
       .draw = vertex_forms},
      {.name = "color_forms",
       .section = section,
       .shows = "32 triangles with the same red, green and blue corners, each from another form of glColor.",
       .draw = color_forms},
      {.name = "signed_color_range",
       .section = section,
       .shows = "A ramp of all signed bytes (top) and of 256 shorts (bottom): red dark in the left half, green in the "
                "right.",
       .width_px = 256,
       .height_px = 128,
       .draw = signed_color_range},
      {.name = "normal_forms",
       .section = section,
       .shows = "Ten triangles lit alike by normals from the ten forms of glNormal, from red to yellow.",
       .width_px = 256,
       .height_px = 88,
       .draw = normal_forms},
  };
}

}  // namespace gouraud::conformance
