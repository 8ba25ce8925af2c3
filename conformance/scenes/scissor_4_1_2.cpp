// The scissor box, for drawing and for clearing. [GL1.5 §4.1.2]
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

void draw_ring(const GlTable& gl) {
  draw_surface(gl, torus(0.95f, 0.38f, 40, 20), [&](const Surface::Point& point) {
    gl.Color3f(0.8f - 0.6f * point.u, 0.3f + 0.5f * point.v, 0.7f * point.u);
  });
}

// One ring a box: 16 boxes of unequal sizes, some beyond the target, some empty.
void scissor_boxes(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_SCISSOR_TEST);
  look(gl, {.distance = 3.9f, .pitch_deg = 52});
  const int boxes[12][4] = {{20, 30, 61, 47},  {90, 11, 33, 80},    {140, 25, 91, 9},   {140, 44, 1, 60},
                            {152, 44, 90, 60}, {-40, 110, 70, 33},  {40, 120, 90, 0},   {60, 118, 0, 40},
                            {70, 110, 50, 50}, {200, 115, 300, 90}, {30, 170, 150, 21}, {11, 200, 170, 400}};
  for (const auto& box : boxes) {
    gl.Scissor(box[0], box[1], box[2], box[3]);
    draw_ring(gl);
  }
}

// A chessboard made of clears alone.
void scissored_clears(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_SCISSOR_TEST);
  for (int row = 0; row < 10; ++row) {
    for (int column = row % 2; column < 10; column += 2) {
      const int x = 7 + 25 * column, y = 3 + 25 * row;
      gl.Scissor(x, y, 10 + 2 * column, 10 + 2 * row);
      gl.ClearColor(0.08f * static_cast<float>(column), 0.6f, 0.09f * static_cast<float>(row), 1);
      gl.ClearDepth(0.1 * row);
      gl.Clear((row + column) % 4 == 0 ? GL_COLOR_BUFFER_BIT : GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }
  }
}

// Depth is cleared to the front in a band: there the ring is hidden.
void scissored_depth_clear(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(0, 100, 256, 31);
  gl.ClearDepth(0);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.Scissor(77, 0, 23, 256);
  gl.ClearDepth(0.84);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.Disable(GL_SCISSOR_TEST);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 3.9f, .pitch_deg = 52});
  draw_ring(gl);
}

// A box that is set but not enabled does nothing; enabled, it holds until it is disabled; viewports are independent of
// it.
void scissor_and_viewport(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 3.9f, .pitch_deg = 52});
  gl.Scissor(30, 140, 60, 100);
  gl.Viewport(0, 128, 128, 128);
  draw_ring(gl);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(150, 150, 200, 71);
  gl.Viewport(128, 128, 128, 128);
  draw_ring(gl);
  gl.Viewport(0, 0, 256, 256);
  gl.Scissor(10, 10, 100, 110);
  draw_ring(gl);
  gl.Disable(GL_SCISSOR_TEST);
  gl.Viewport(128, 0, 128, 128);
  draw_ring(gl);
}

void scissored_lines_and_points(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(41, 37, 173, 181);
  Random random(211);
  gl.Begin(GL_LINES);
  for (int i = 0; i < 300; ++i) {
    color_of(gl, random);
    const float x = random.range(5, 250);
    gl.Vertex2f(x, random.range(5, 250));
  }
  gl.End();
  gl.Begin(GL_POINTS);
  for (int i = 0; i < 4000; ++i) {
    color_of(gl, random);
    const int x = random.below(256);
    gl.Vertex2f(static_cast<float>(x) + 0.375f, static_cast<float>(random.below(256)) + 0.625f);
  }
  gl.End();
}

}  // namespace

SceneList scissor_scenes() {
  constexpr auto section = "§4.1.2";
  return {
      {.name = "scissor_boxes",
       .section = section,
       .shows = "A ring seen through ten windows; two empty boxes show nothing.",
       .draw = scissor_boxes},
      {.name = "scissor_clears",
       .section = section,
       .shows = "A chessboard of growing rectangles made by glClear alone.",
       .draw = scissored_clears},
      {.name = "scissor_depth_clear",
       .section = section,
       .shows = "A ring with a missing horizontal band, and a vertical band in which its far half is missing.",
       .draw = scissored_depth_clear},
      {.name = "scissor_and_viewport",
       .section = section,
       .shows =
           "Above, a whole ring and the upper slice of one; below, the corner of a large one and a whole small one.",
       .draw = scissor_and_viewport},
      {.name = "scissor_lines_and_points",
       .section = section,
       .shows = "Random lines and points cut to a rectangle.",
       .judge = Judge::lines_and_points,
       .draw = scissored_lines_and_points},
  };
}

}  // namespace gouraud::conformance
