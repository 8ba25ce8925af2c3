// Display lists: one geometry under several matrices, lists in lists, text by CallLists, lists that change state.
// [GL1.5 §5.4]
#include <array>
#include <string_view>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

void one_list_four_matrices(const GlTable& gl) {
  clear_background(gl);
  const GLuint ball = gl.GenLists(1);
  gl.NewList(ball, GL_COMPILE);
  draw_surface(gl, sphere(0.9f, 24, 40));
  gl.EndList();
  const Matrix camera = look(gl, {.distance = 6});
  light(gl, GL_LIGHT0, GL_POSITION, {0.3f, 0.8f, 0.5f, 0});
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_NORMALIZE);
  gl.Enable(GL_DEPTH_TEST);
  for (int i = 0; i < 4; ++i) {
    const float x = i % 2 == 0 ? -1.02f : 1.04f, z = i < 2 ? -1.03f : 1.01f;
    const float size = 0.35f + 0.21f * static_cast<float>(i);
    load_model_view(gl, multiply(camera, multiply(translation(x, 0, z), scaling(size, size, size))));
    material(gl, GL_FRONT, GL_AMBIENT_AND_DIFFUSE, {0.87f - 0.21f * static_cast<float>(i), 0.43f, 0.77f, 1});
    gl.CallList(ball);
  }
}

// Each level draws the level below three times, at half its size: a triangle of triangles.
void nested_lists(const GlTable& gl) {
  constexpr GLuint levels = 6;
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.NewList(1, GL_COMPILE);
  gl.Begin(GL_TRIANGLES);
  gl.Color3f(0.9f, 0.2f, 0.1f);
  gl.Vertex2f(3.3f, 4.2f);
  gl.Color3f(0.1f, 0.9f, 0.2f);
  gl.Vertex2f(252.7f, 6.1f);
  gl.Color3f(0.2f, 0.1f, 0.9f);
  gl.Vertex2f(127.6f, 251.4f);
  gl.End();
  gl.EndList();
  for (GLuint level = 2; level <= levels; ++level) {
    gl.NewList(level, GL_COMPILE);
    for (const auto& [x, y] : {std::array{0.0f, 0.0f}, {128.0f, 0.0f}, {64.0f, 128.0f}}) {
      gl.PushMatrix();
      gl.Translatef(x, y, 0);
      gl.Scalef(0.5f, 0.5f, 1);
      gl.CallList(level - 1);
      gl.PopMatrix();
    }
    gl.EndList();
  }
  gl.CallList(levels);
}

struct Glyph {
  char letter;
  std::string_view rows;  // five rows of three, from the top
};
constexpr Glyph glyphs[] = {{'G', "####..#.####.##"}, {'L', "#..#..#..#..###"}, {'1', ".#.##..#..#.###"},
                            {'5', "####..##...###."}, {'.', ".............#."}, {'S', ".###...#...###."}};

// A list a letter at its character code; each draws its squares and steps on.
void text(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 128);
  constexpr GLuint base = 1000;
  for (const Glyph& glyph : glyphs) {
    gl.NewList(base + static_cast<GLuint>(glyph.letter), GL_COMPILE);
    gl.Begin(GL_TRIANGLES);
    for (std::size_t i = 0; i < glyph.rows.size(); ++i) {
      if (glyph.rows[i] != '#') continue;
      const float x = static_cast<float>(i % 3), y = static_cast<float>(4 - i / 3);
      gl.Vertex2f(x, y);
      gl.Vertex2f(x + 0.9f, y);
      gl.Vertex2f(x + 0.9f, y + 0.9f);
      gl.Vertex2f(x, y);
      gl.Vertex2f(x + 0.9f, y + 0.9f);
      gl.Vertex2f(x, y + 0.9f);
    }
    gl.End();
    gl.Translatef(4, 0, 0);
    gl.EndList();
  }
  gl.ListBase(base);
  const auto line = [&](float y, float size, std::string_view letters, float red) {
    gl.LoadIdentity();
    gl.Translatef(9.3f, y, 0);
    gl.Scalef(size, size, 1);
    gl.Color3f(red, 0.8f, 0.9f - red);
    gl.CallLists(static_cast<GLsizei>(letters.size()), GL_UNSIGNED_BYTE, letters.data());
  };
  line(60.7f, 9.4f, "GL1.5", 0.2f);
  line(8.2f, 4.6f, "LISTS.S15.GL.GLS", 0.7f);  // I and T have no list: nothing happens for them
}

// A list that leaves another state behind: colours, light, depth function, matrix.
void lists_change_state(const GlTable& gl) {
  clear_background(gl);
  const Matrix camera = look(gl, {.distance = 5});
  light(gl, GL_LIGHT0, GL_POSITION, {0.3f, 0.8f, 0.5f, 0});
  gl.Enable(GL_DEPTH_TEST);
  gl.NewList(1, GL_COMPILE);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.5f, 0.2f, 1});
  gl.ShadeModel(GL_FLAT);
  gl.EndList();
  gl.NewList(2, GL_COMPILE);
  gl.Disable(GL_LIGHTING);
  gl.ShadeModel(GL_SMOOTH);
  gl.Color3f(0.2f, 0.7f, 0.9f);
  gl.DepthFunc(GL_GREATER);
  gl.Translatef(0.31f, 0.12f, 0);
  gl.EndList();
  gl.CallList(1);
  load_model_view(gl, multiply(camera, translation(-0.4f, 0, 0)));
  draw_surface(gl, torus(1.0f, 0.4f, 24, 16));
  gl.CallList(2);  // now only what lies behind the first torus
  draw_surface(gl, torus(1.0f, 0.4f, 24, 16));
}

// Oracle only: both Mesa drivers lose vertices of a strip in a list whose first colour comes in its middle, and give
// those before it that colour. Colours in a list hold for the vertices behind them; before the first it takes the
// caller's, and leaves its last.
void colors_across_lists(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 128);
  gl.NewList(1, GL_COMPILE);
  gl.Begin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 14; ++i) {
    if (i == 5) gl.Color3f(0.9f, 0.8f, 0.1f);
    if (i == 10) gl.Color3f(0.2f, 0.9f, 0.6f);
    gl.Vertex2f(4.3f + 8.2f * static_cast<float>(i), i % 2 == 0 ? 5.4f : 57.6f);
  }
  gl.Color3f(0.8f, 0.1f, 0.3f);
  gl.End();
  gl.EndList();
  gl.NewList(2, GL_COMPILE_AND_EXECUTE);
  gl.Color3f(0.1f, 0.3f, 0.9f);
  gl.CallList(1);
  gl.Translatef(0, 64, 0);
  gl.CallList(1);
  gl.EndList();
  gl.LoadIdentity();
  gl.Translatef(128, 0, 0);
  gl.CallList(2);
}

}  // namespace

SceneList display_list_scenes() {
  constexpr auto section = "§5.4";
  return {
      {.name = "list_under_matrices",
       .section = section,
       .shows = "One list, a sphere, drawn four times: small to large, four materials.",
       .draw = one_list_four_matrices},
      {.name = "nested_lists",
       .section = section,
       .shows = "A triangle of 243 triangles, made by six lists that call one another.",
       .draw = nested_lists},
      {.name = "list_text",
       .section = section,
       .shows = "GL1.5 large, below it small letters and gaps, each letter a list of squares called by its code.",
       .width_px = 256,
       .height_px = 128,
       .draw = text},
      {.name = "list_state",
       .section = section,
       .shows = "A flat-shaded lit torus; a second one, light blue, where it lies behind the first.",
       .draw = lists_change_state},
      {.name = "list_colors",
       .section = section,
       .shows = "Four strips: blue (bottom) or red (top) at the left, then yellow, then green.",
       .judge = Judge::oracle_only,
       .width_px = 256,
       .height_px = 128,
       .draw = colors_across_lists},
  };
}

}  // namespace gouraud::conformance
