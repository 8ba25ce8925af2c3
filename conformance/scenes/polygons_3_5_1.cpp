// Polygon rasterization: coverage, shared edges, culling, perspective-correct colours. [GL1.5 §3.5.1]
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

// 15 x 15 jittered cells, each cut in two, each triangle flat in its own colour, no depth test: a gap shows the
// background, a pixel hit twice the wrong colour.
void shared_edges(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  Random random(181);
  constexpr int cells = 15;
  std::array<std::array<float, 2>, (cells + 1) * (cells + 1)> points{};
  for (int i = 0; i < (cells + 1) * (cells + 1); ++i) {
    const float x = 17 * static_cast<float>(i % (cells + 1)), y = 17 * static_cast<float>(i / (cells + 1));
    points[static_cast<std::size_t>(i)] = {x + random.range(-5, 5), y + random.range(-5, 5)};
  }
  gl.Begin(GL_TRIANGLES);
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const int corner = row * (cells + 1) + column, above = corner + cells + 1;
      const std::array<int, 6> order = {corner, corner + 1, above, above, corner + 1, above + 1};
      for (std::size_t i = 0; i < 6; ++i) {
        if (i % 3 == 0) color_of(gl, random);
        gl.Vertex2fv(points[static_cast<std::size_t>(order[i])].data());
      }
    }
  }
  gl.End();
}

// The hub at a pixel's centre, spokes through centres of pixels: each of these samples belongs to one triangle.
void fans_through_centers(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  Random random(182);
  const int rim[16][2] = {{28, 0},  {28, 14},   {28, 28},   {14, 28},   {0, 28},  {-14, 28}, {-28, 28}, {-28, 14},
                          {-28, 0}, {-28, -14}, {-28, -28}, {-14, -28}, {0, -28}, {14, -28}, {28, -28}, {28, -14}};
  gl.ShadeModel(GL_FLAT);
  for (int fan = 0; fan < 16; ++fan) {
    const float x = 32.5f + 63 * static_cast<float>(fan % 4), y = 32.5f + 63 * static_cast<float>(fan / 4);
    const int step = fan % 2 == 0 ? 1 : -1, stride = 1 + fan / 8;
    gl.Begin(GL_TRIANGLE_FAN);
    gl.Vertex2f(x, y);
    for (int i = 0; i <= 16; i += stride) {
      const auto& spoke = rim[(step * i + fan + 16) % 16];
      color_of(gl, random);
      gl.Vertex2f(x + static_cast<float>(spoke[0]), y + static_cast<float>(spoke[1]));
    }
    gl.End();
  }
}

// Rectangles whose edges run through pixel centres: left and bottom edges own them.
void edges_on_centers(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 128, 128);
  Random random(183);
  for (int row = 0; row < 14; ++row) {
    for (int column = 0; column < 14; ++column) {
      const float x = 1.5f + 9 * static_cast<float>(column), y = 1.5f + 9 * static_cast<float>(row);
      color_of(gl, random);
      draw_rectangle(gl, x, y, x + static_cast<float>(column % 10), y + static_cast<float>(row % 10), 0);
    }
  }
}

// Triangles with corners on centres and on edges of pixels, in both orders of vertices.
void corners_on_half_pixels(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  Random random(184);
  gl.Begin(GL_TRIANGLES);
  for (int row = 0; row < 16; ++row) {
    for (int column = 0; column < 16; ++column) {
      color_of(gl, random);
      for (int corner = 0; corner < 3; ++corner) {
        const float x = 16 * static_cast<float>(column) + 0.5f * static_cast<float>(random.below(31));
        gl.Vertex2f(x, 16 * static_cast<float>(row) + 0.5f * static_cast<float>(random.below(31)));
      }
    }
  }
  gl.End();
}

// Long triangles a fraction of a pixel wide, in all directions.
void slivers(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  Random random(185);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 150; ++i) {
    const float x0 = random.range(5, 251), y0 = random.range(5, 251), x1 = random.range(5, 251),
                y1 = random.range(5, 251);
    color_of(gl, random);
    gl.Vertex2f(x0, y0);
    gl.Vertex2f(x1, y1);
    const float dx = random.range(-1, 1), dy = random.range(-1, 1);
    gl.Vertex2f(x1 + dx, y1 + dy);
  }
  gl.End();
}

// The colour runs along each sliver; across it, it does not change.
void slivers_smooth(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  Random random(186);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 70; ++i) {
    const float angle = 0.0897f * static_cast<float>(i), c = static_cast<float>(std::cos(angle)),
                s = static_cast<float>(std::sin(angle));
    color_of(gl, random);
    gl.Vertex2f(128.3f + 12.6f * c, 128.4f + 12.6f * s);
    color_of(gl, random);
    gl.Vertex2f(128.3f + 123.7f * c - 1.3f * s, 128.4f + 123.7f * s + 1.3f * c);
    gl.Vertex2f(128.3f + 123.7f * c + 1.3f * s, 128.4f + 123.7f * s - 1.3f * c);
  }
  gl.End();
}

// Far smaller than a pixel: only those that hold a centre are seen.
void tiny_triangles(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  Random random(187);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 60'000; ++i) {
    const float x = random.range(2, 254), y = random.range(2, 254);
    color_of(gl, random);
    for (int corner = 0; corner < 3; ++corner) {
      const float vx = x + random.range(-0.7f, 0.7f);
      gl.Vertex2f(vx, y + random.range(-0.7f, 0.7f));
    }
  }
  gl.End();
}

void random_triangles(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  pixel_space(gl, 500, 333);
  Random random(188);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 300; ++i) {
    const float x = random.range(20, 480), y = random.range(20, 313), size = random.range(5, 60);
    for (int corner = 0; corner < 3; ++corner) {
      color_of(gl, random);
      const float vx = x + random.range(-size, size), vy = y + random.range(-size, size);
      gl.Vertex3f(vx, vy, random.range(-0.95f, 0.95f));
    }
  }
  gl.End();
}

// Triangles without area draw nothing: two equal corners, three on a line; whole ones stand beside them.
void no_area(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 128);
  Random random(189);
  for (int i = 0; i < 32; ++i) {
    const float x = 32 * static_cast<float>(i % 8), y = 32 * static_cast<float>(i / 8);
    const float bends[4] = {0, 0, 13.3f, -11.6f};
    color_of(gl, random);
    gl.Begin(GL_TRIANGLES);
    gl.Vertex2f(x + 3.5f, y + 4.5f);
    if (i % 4 == 0)
      gl.Vertex2f(x + 3.5f, y + 4.5f);
    else
      gl.Vertex2f(x + 15.5f + bends[i % 4], y + 16.5f - bends[i % 4]);
    gl.Vertex2f(x + 27.5f, y + 28.5f);
    gl.End();
  }
}

// A sphere of 1,200 flat triangles, back faces culled, no depth test: each pixel is hit once.
void closed_mesh_once(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_CULL_FACE);
  look(gl, {.distance = 3.6f});
  const Surface ball = sphere(1, 20, 30);
  Random random(190);
  gl.Begin(GL_TRIANGLES);
  for (int row = 0; row + 1 < ball.rows; ++row) {
    for (int column = 0; column + 1 < ball.columns; ++column) {
      color_of(gl, random);
      for (const auto& [r, c] : {std::array{row, column}, {row, column + 1}, {row + 1, column + 1}}) {
        gl.Vertex3fv(ball.at(r, c).position.data());
      }
      color_of(gl, random);
      for (const auto& [r, c] : {std::array{row, column}, {row + 1, column + 1}, {row + 1, column}}) {
        gl.Vertex3fv(ball.at(r, c).position.data());
      }
    }
  }
  gl.End();
}

// Columns: no culling, back, front, both; rows: counterclockwise and clockwise fronts.
void cull_and_front_face(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 128);
  for (int i = 0; i < 8; ++i) {
    const GLenum culled[4] = {GL_BACK, GL_BACK, GL_FRONT, GL_FRONT_AND_BACK};
    (i % 4 == 0 ? gl.Disable : gl.Enable)(GL_CULL_FACE);
    gl.CullFace(culled[i % 4]);
    gl.FrontFace(i < 4 ? GL_CCW : GL_CW);
    const float x = 64 * static_cast<float>(i % 4), y = i < 4 ? 64.0f : 0.0f;
    gl.Begin(GL_TRIANGLES);
    gl.Color3f(0.8f, 0.6f, 0.2f);
    gl.Vertex2f(x + 4.3f, y + 5.6f);
    gl.Vertex2f(x + 57.1f, y + 12.3f);
    gl.Vertex2f(x + 31.2f, y + 32.7f);
    gl.Color3f(0.2f, 0.6f, 0.8f);
    gl.Vertex2f(x + 6.4f, y + 58.7f);
    gl.Vertex2f(x + 59.3f, y + 54.2f);
    gl.Vertex2f(x + 33.6f, y + 35.3f);
    gl.End();
  }
}

// Strips, fans, quads and polygons keep one facing: none of their triangles is culled while the others stay.
void cull_by_mode(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 320, 128);
  gl.Enable(GL_CULL_FACE);
  Random random(191);
  using Points = std::vector<std::array<float, 2>>;
  const Points ladder = {{5.3f, 57.2f},  {8.1f, 6.4f},  {22.6f, 58.3f}, {24.4f, 5.2f},
                         {41.3f, 55.8f}, {39.2f, 8.3f}, {58.7f, 58.1f}, {56.3f, 6.1f}};
  const Points hexagon = {{58.2f, 31.3f}, {44.6f, 56.1f}, {18.4f, 55.3f}, {5.2f, 30.8f}, {17.6f, 7.4f}, {45.1f, 8.7f}};
  const Points quad = {{6.1f, 7.3f}, {57.2f, 7.3f}, {57.2f, 56.4f}, {6.1f, 56.4f}};
  const GLenum modes[5] = {GL_TRIANGLE_STRIP, GL_QUAD_STRIP, GL_TRIANGLE_FAN, GL_POLYGON, GL_QUADS};
  for (int i = 0; i < 10; ++i) {
    gl.CullFace(i < 5 ? GL_BACK : GL_FRONT);
    gl.FrontFace(i < 5 ? GL_CCW : GL_CW);
    const GLenum mode = modes[i % 5];
    const float x = 64 * static_cast<float>(i % 5), y = i < 5 ? 64.0f : 0.0f;
    color_of(gl, random);
    gl.Begin(mode);
    for (const auto& [px, py] : i % 5 < 2 ? ladder : mode == GL_QUADS ? quad : hexagon) gl.Vertex2f(x + px, y + py);
    gl.End();
  }
}

void rings_culled(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_CULL_FACE);
  gl.Enable(GL_DEPTH_TEST);
  const Surface ring = torus(0.85f, 0.36f, 36, 18);
  const Matrix view = look(gl, {.distance = 5.6f, .pitch_deg = 0, .yaw_deg = 0, .aspect = 2});
  for (int i = 0; i < 2; ++i) {
    gl.CullFace(i == 0 ? GL_BACK : GL_FRONT);
    load_model_view(gl, multiply(view, multiply(translation(i == 0 ? -1.5f : 1.5f, 0, 0), rotation(47, 0))));
    draw_surface(gl, ring,
                 [&](const Surface::Point& point) { gl.Color3f(0.3f + 0.5f * point.u, 0.8f * point.v, 0.45f); });
  }
}

// A floor of two triangles whose near colours are red and green, whose far ones blue and white: affine interpolation
// would put the middle colours in the middle of the picture.
void perspective_floor(const GlTable& gl) {
  clear_background(gl);
  load_projection(gl, perspective(55, 1, 0.5f, 200));
  gl.Begin(GL_TRIANGLE_STRIP);
  gl.Color3f(0.8f, 0, 0.2f);
  gl.Vertex3f(-1.6f, -1, -2.1f);
  gl.Color3f(0, 0.8f, 0.2f);
  gl.Vertex3f(1.7f, -1, -2.1f);
  gl.Color3f(0, 0.2f, 0.8f);
  gl.Vertex3f(-19.3f, -1, -47.6f);
  gl.Color3f(0.8f, 0.8f, 0.75f);
  gl.Vertex3f(18.7f, -1, -47.6f);
  gl.End();
}

// Walls, floor and ceiling of a corridor, in bands: each band is one pair of triangles of great w range.
void perspective_corridor(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 0, .pitch_deg = 3, .yaw_deg = 8, .aspect = 1.5f, .fov_y_deg = 58, .near = 0.4f, .far = 90});
  const float corners[5][2] = {{-1.3f, -0.9f}, {1.3f, -0.9f}, {1.3f, 1.1f}, {-1.3f, 1.1f}, {-1.3f, -0.9f}};
  for (int side = 0; side < 4; ++side) {
    for (int band = 0; band < 6; ++band) {
      const float near = static_cast<float>(band) / 6, far = static_cast<float>(band + 1) / 6;
      const auto vertex = [&](float t, float z, float shade) {
        const float red = band % 2 == 0 ? shade : 0.8f, green = 0.2f * static_cast<float>(side);
        gl.Color3f(red, green, 0.8f - 0.75f * shade);
        gl.Vertex3f(corners[side][0] + t * (corners[side + 1][0] - corners[side][0]),
                    corners[side][1] + t * (corners[side + 1][1] - corners[side][1]), z);
      };
      gl.Begin(GL_TRIANGLE_STRIP);
      vertex(near, -0.53f, 0.1f);
      vertex(far, -0.53f, 0.1f);
      vertex(near, -63.7f, 0.9f);
      vertex(far, -63.7f, 0.9f);
      gl.End();
    }
  }
}

// One triangle whose w runs from 1 to 60.
void w_from_1_to_60(const GlTable& gl) {
  clear_background(gl);
  gl.Begin(GL_TRIANGLES);
  gl.Color3f(0.8f, 0.2f, 0.2f);
  gl.Vertex4f(-0.93f, -0.87f, 0.3f, 1);
  gl.Color3f(0.2f, 0.8f, 0.2f);
  gl.Vertex4f(0.91f * 7, -0.71f * 7, 0.4f * 7, 7);
  gl.Color3f(0.2f, 0.2f, 0.8f);
  gl.Vertex4f(0.13f * 60, 0.92f * 60, 0.2f * 60, 60);
  gl.End();
}

}  // namespace

SceneList polygon_scenes() {
  constexpr auto section = "§3.5.1";
  return {
      {.name = "shared_edges",
       .section = section,
       .shows = "A crumpled sheet of 450 flat triangles without gaps or overlaps.",
       .draw = shared_edges},
      {.name = "fans_through_centers",
       .section = section,
       .shows = "16 square fans whose hubs and spokes run through pixel centres, each whole.",
       .draw = fans_through_centers},
      {.name = "edges_on_centers",
       .section = section,
       .shows = "Rectangles of 0 to 9 pixels in both directions, all edges on pixel centres.",
       .width_px = 128,
       .height_px = 128,
       .draw = edges_on_centers},
      {.name = "corners_on_half_pixels",
       .section = section,
       .shows = "256 random triangles with corners at multiples of half a pixel.",
       .draw = corners_on_half_pixels},
      {.name = "slivers",
       .section = section,
       .shows = "150 needles less than a pixel wide, dashed where no centre lies within.",
       .draw = slivers},
      {.name = "slivers_smooth",
       .section = section,
       .shows = "A sun of 70 thin rays, each from one colour to another.",
       .draw = slivers_smooth},
      {.name = "tiny_triangles",
       .section = section,
       .shows = "Coloured noise: 60,000 triangles smaller than a pixel.",
       .draw = tiny_triangles},
      {.name = "random_triangles",
       .section = section,
       .shows = "300 random smooth triangles that run through each other.",
       .width_px = 500,
       .height_px = 333,
       .draw = random_triangles},
      {.name = "no_area",
       .section = section,
       .shows = "Of 32 triangles the half has no area and is missing; the others are whole.",
       .width_px = 256,
       .height_px = 128,
       .draw = no_area},
      {.name = "closed_mesh_once",
       .section = section,
       .shows = "A ball of 1,200 flat triangles without depth test; no back face, gap or double hit.",
       .draw = closed_mesh_once},
      {.name = "cull_and_front_face",
       .section = section,
       .shows = "A yellow counterclockwise and a blue clockwise triangle in each cell: both, one, the other, none; "
                "below, fronts exchanged.",
       .width_px = 256,
       .height_px = 128,
       .draw = cull_and_front_face},
      {.name = "cull_by_mode",
       .section = section,
       .shows =
           "Strip, quad strip, fan, polygon and quad, whole under culling of back faces; below, of clockwise fronts.",
       .width_px = 320,
       .height_px = 128,
       .draw = cull_by_mode},
      {.name = "rings_culled",
       .section = section,
       .shows = "Left a ring without its back faces, right one of back faces alone.",
       .width_px = 400,
       .height_px = 200,
       .draw = rings_culled},
      {.name = "perspective_floor",
       .section = section,
       .shows = "A floor, red and green before, blue and white only near the horizon.",
       .draw = perspective_floor},
      {.name = "perspective_corridor",
       .section = section,
       .shows = "A striped corridor; every stripe keeps its near colour until deep into the picture.",
       .width_px = 384,
       .height_px = 256,
       .draw = perspective_corridor},
      {.name = "w_from_1_to_60",
       .section = section,
       .shows = "A triangle that is almost wholly the red of its nearest corner.",
       .draw = w_from_1_to_60},
  };
}

}  // namespace gouraud::conformance
