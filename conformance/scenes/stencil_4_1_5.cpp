// The stencil test: functions, operations, masks, both faces; what a buffer holds is shown by drawing where it is equal
// to one value after the other. [GL1.5 §4.1.5]
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

constexpr GLenum operations[] = {GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP};

void begin_scene(const GlTable& gl) {
  clear_background(gl);
  gl.Clear(GL_STENCIL_BUFFER_BIT);
  gl.Enable(GL_STENCIL_TEST);
}

void operate(const GlTable& gl, GLenum fail, GLenum depth_fail, GLenum depth_pass) {
  gl.StencilOp(fail, depth_fail, depth_pass);
}

// What is drawn leaves its mark in the stencil buffer alone.
void mark(const GlTable& gl, bool marks) {
  const auto visible = static_cast<GLboolean>(marks ? GL_FALSE : GL_TRUE);
  gl.ColorMask(visible, visible, visible, visible);
}

// 16 columns of a stencil value each, over the height of the picture.
void columns(const GlTable& gl, const int (&values)[16]) {
  mark(gl, true);
  operate(gl, GL_REPLACE, GL_REPLACE, GL_REPLACE);
  for (int i = 0; i < 16; ++i) {
    gl.StencilFunc(GL_ALWAYS, values[i], ~0u);
    const float x = 16 * static_cast<float>(i);
    draw_rectangle(gl, x + 1.5f, 0, x + 15.5f, 256, 0);
  }
  mark(gl, false);
}
constexpr int small_values[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
constexpr int edge_values[16] = {0, 1, 2, 3, 64, 126, 127, 128, 129, 200, 250, 252, 253, 254, 255, 170};

// A colour for each value, where the buffer holds it.
void show(const GlTable& gl) {
  gl.Disable(GL_DEPTH_TEST);
  gl.Disable(GL_CULL_FACE);
  gl.Disable(GL_ALPHA_TEST);
  gl.Disable(GL_LIGHTING);
  gl.Disable(GL_STENCIL_TEST_TWO_SIDE_EXT);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  gl.StencilMask(~0u);
  pixel_space(gl, 256, 256);
  operate(gl, GL_KEEP, GL_KEEP, GL_KEEP);
  for (int value = 1; value < 256; ++value) {
    gl.StencilFunc(GL_EQUAL, value, ~0u);
    gl.Color3ub(static_cast<GLubyte>(53 * value % 256), static_cast<GLubyte>(255 - value),
                static_cast<GLubyte>(101 * value % 256));
    draw_rectangle(gl, 0, 0, 256, 256, 0);
  }
}

// A function a row, over 16 stored values.
void compare(const GlTable& gl, GLint reference, GLuint mask) {
  begin_scene(gl);
  pixel_space(gl, 256, 256);
  columns(gl, small_values);
  operate(gl, GL_KEEP, GL_KEEP, GL_KEEP);
  for (int row = 0; row < 8; ++row) {
    gl.StencilFunc(GL_NEVER + static_cast<GLenum>(row), reference, mask);
    gl.Color3ub(static_cast<GLubyte>(90 + 20 * row), 200, static_cast<GLubyte>(250 - 30 * row));
    const float y = 32 * static_cast<float>(row);
    draw_rectangle(gl, 0, y + 4.5f, 256, y + 28.5f, 0);
  }
}

// An operation a row, over values at the ends of the range and in its middle.
void operate_rows(const GlTable& gl, GLuint write_mask, bool fails) {
  begin_scene(gl);
  pixel_space(gl, 256, 256);
  columns(gl, edge_values);
  mark(gl, true);
  gl.StencilMask(write_mask);
  gl.StencilFunc(fails ? GL_NEVER : GL_ALWAYS, 0x5A, ~0u);
  for (int row = 0; row < 8; ++row) {
    const GLenum op = operations[row];
    operate(gl, fails ? op : GL_ZERO, GL_ZERO, fails ? GL_ZERO : op);
    const float y = 32 * static_cast<float>(row);
    draw_rectangle(gl, 0, y + 4.5f, 256, y + 28.5f, 0);
    draw_rectangle(gl, 0, y + 16.5f, 256, y + 28.5f, 0);
  }
  mark(gl, false);
  show(gl);
}

// Counts what a ball hides, and what it does not, of a ring through it.
void count_depth_outcomes(const GlTable& gl) {
  begin_scene(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 4.2f, .pitch_deg = 41});
  mark(gl, true);
  operate(gl, GL_KEEP, GL_KEEP, GL_KEEP);
  gl.StencilFunc(GL_ALWAYS, 0, ~0u);
  draw_surface(gl, sphere(0.83f, 24, 40));
  operate(gl, GL_ZERO, GL_INCR, GL_REPLACE);
  gl.StencilFunc(GL_ALWAYS, 17, ~0u);
  draw_surface(gl, torus(0.93f, 0.41f, 40, 20));
  mark(gl, false);
  show(gl);
}

// Without a depth test all depths pass; with NEVER all fail, and the colours with them.
void without_and_never(const GlTable& gl) {
  begin_scene(gl);
  pixel_space(gl, 256, 256);
  gl.StencilFunc(GL_ALWAYS, 5, ~0u);
  operate(gl, GL_KEEP, GL_INVERT, GL_REPLACE);
  gl.Color3f(0.9f, 0.1f, 0.1f);
  draw_rectangle(gl, 13.5f, 17.5f, 170.5f, 130.5f, 0.25f);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_NEVER);
  draw_rectangle(gl, 90.5f, 70.5f, 240.5f, 230.5f, 0.5f);
  show(gl);
}

// Every fragment counts, whatever it hides: how often each pixel is covered.
void overdraw(const GlTable& gl) {
  begin_scene(gl);
  look(gl, {.distance = 4, .pitch_deg = 33});
  mark(gl, true);
  gl.StencilFunc(GL_ALWAYS, 0, ~0u);
  operate(gl, GL_KEEP, GL_INCR, GL_INCR);
  draw_surface(gl, torus(0.8f, 0.37f, 36, 18));
  draw_surface(gl, sphere(0.6f, 20, 30));
  mark(gl, false);
  show(gl);
}

// The classic: a floor is marked, then the scene is drawn upside down where it is, then upright.
void mirror(const GlTable& gl) {
  begin_scene(gl);
  const Matrix view = look(gl, {.distance = 5.2f, .pitch_deg = 27});
  gl.Enable(GL_DEPTH_TEST);
  const auto ring = [&](bool mirrored) {
    const Matrix upright = multiply(translation(0.1f, 0.87f, 0), rotation(67, 0));
    load_model_view(gl, multiply(view, mirrored ? multiply(scaling(1, -1, 1), upright) : upright));
    gl.FrontFace(mirrored ? GL_CW : GL_CCW);
    draw_surface(gl, torus(0.57f, 0.23f, 40, 20), [&](const Surface::Point& point) {
      const float shade = mirrored ? 0.57f : 1.0f;
      gl.Color3f(shade * (0.31f + 0.53f * point.u), shade * 0.71f, shade * (0.91f - 0.67f * point.v));
    });
  };
  mark(gl, true);
  gl.DepthMask(GL_FALSE);
  gl.StencilFunc(GL_ALWAYS, 1, ~0u);
  operate(gl, GL_KEEP, GL_KEEP, GL_REPLACE);
  draw_surface(gl, floor_grid(2.1f, 5));
  mark(gl, false);
  gl.DepthMask(GL_TRUE);
  gl.StencilFunc(GL_EQUAL, 1, ~0u);
  operate(gl, GL_KEEP, GL_KEEP, GL_KEEP);
  gl.Enable(GL_CULL_FACE);
  ring(true);
  gl.Disable(GL_STENCIL_TEST);
  ring(false);
}

// A counted volume: +1 where a ray enters it, -1 where it leaves, in front of a slanted floor. One pass for both faces.
void volume(const GlTable& gl) {
  begin_scene(gl);
  gl.Enable(GL_DEPTH_TEST);
  const Matrix view = look(gl, {.distance = 4.3f, .pitch_deg = 36});
  load_model_view(gl, multiply(view, rotation(11, 0)));
  mark(gl, true);
  operate(gl, GL_KEEP, GL_KEEP, GL_KEEP);
  draw_surface(gl, floor_grid(3.1f, 7));
  load_model_view(gl, view);
  gl.DepthMask(GL_FALSE);
}
void draw_volume(const GlTable& gl) {
  draw_surface(gl, sphere(0.71f, 20, 30));
  draw_surface(gl, torus(0.9f, 0.31f, 36, 18));
  gl.DepthMask(GL_TRUE);
  mark(gl, false);
}

void two_sided(const GlTable& gl) {
  volume(gl);
  gl.Enable(GL_STENCIL_TEST_TWO_SIDE_EXT);
  gl.ActiveStencilFaceEXT(GL_BACK);
  operate(gl, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
  gl.StencilMask(0x7F);
  gl.ActiveStencilFaceEXT(GL_FRONT);
  operate(gl, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
  draw_volume(gl);
  show(gl);
}

// The same by the other extension, with depth failures counted instead.
void separate(const GlTable& gl) {
  volume(gl);
  gl.StencilFuncSeparateATI(GL_ALWAYS, GL_NOTEQUAL, 3, 0xF);
  gl.StencilOpSeparateATI(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
  gl.StencilOpSeparateATI(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
  draw_volume(gl);
  show(gl);
}

// With culling only one side counts; clockwise is the front.
void culled(const GlTable& gl) {
  volume(gl);
  gl.FrontFace(GL_CW);
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_FRONT);
  gl.StencilOpSeparateATI(GL_BACK, GL_KEEP, GL_INCR, GL_REPLACE);
  gl.StencilFuncSeparateATI(GL_NEVER, GL_GREATER, 2, ~0u);
  draw_volume(gl);
  show(gl);
}

// A polygon's points keep its side; points of their own are front.
void unfilled_back_faces(const GlTable& gl) {
  begin_scene(gl);
  pixel_space(gl, 256, 256);
  mark(gl, true);
  gl.StencilFunc(GL_ALWAYS, 1, ~0u);
  operate(gl, GL_KEEP, GL_KEEP, GL_REPLACE);
  gl.StencilOpSeparateATI(GL_BACK, GL_KEEP, GL_KEEP, GL_INVERT);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
  for (int i = 0; i < 400; ++i) {
    const float x = 10.5f + 12 * static_cast<float>(i % 20), y = 8.5f + 12 * static_cast<float>(i / 20);
    gl.Begin(i % 3 == 0 ? GL_POINTS : GL_TRIANGLES);
    gl.Vertex2f(x, y);
    gl.Vertex2f(x + 8, y + (i % 2 == 0 ? 1.0f : 5.0f));
    gl.Vertex2f(x + 7, y + (i % 2 == 0 ? 6.0f : 0.0f));
    gl.End();
  }
  mark(gl, false);
  show(gl);
}

// What fails the alpha test does not reach the stencil test.
void behind_alpha(const GlTable& gl) {
  begin_scene(gl);
  pixel_space(gl, 256, 256);
  mark(gl, true);
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_GREATER, 127.5f / 255.0f);
  Random random(31);
  operate(gl, GL_INCR, GL_KEEP, GL_INCR_WRAP);
  for (int i = 0; i < 150; ++i) {
    gl.StencilFunc(i % 2 == 0 ? GL_ALWAYS : GL_GREATER, i % 5, ~0u);
    gl.Color4ub(255, 255, 255, static_cast<GLubyte>(random.below(256)));
    const float x = random.range(-20, 220), y = random.range(-20, 220);
    const float width = random.range(10, 90), height = random.range(10, 90);
    draw_rectangle(gl, x, y, x + width, y + height, 0);
  }
  mark(gl, false);
  show(gl);
}

}  // namespace

SceneList stencil_scenes() {
  constexpr auto section = "§4.1.5";
  return {
      {.name = "stencil_functions",
       .section = section,
       .shows = "Eight rows, a function each, over 16 columns of the values 0 to 15; the reference is 7.",
       .draw = [](const GlTable& gl) { compare(gl, 7, ~0u); }},
      {.name = "stencil_functions_masked",
       .section = section,
       .shows = "The same rows, comparing two bits alone; the reference is beyond the buffer.",
       .draw = [](const GlTable& gl) { compare(gl, 0x1234, 0x106); }},
      {.name = "stencil_operations",
       .section = section,
       .shows = "Eight rows, an operation each, once below and twice above, over 16 columns of values.",
       .draw = [](const GlTable& gl) { operate_rows(gl, ~0u, false); }},
      {.name = "stencil_operations_masked",
       .section = section,
       .shows = "The same rows, writing four bits.",
       .draw = [](const GlTable& gl) { operate_rows(gl, 0xF3C, false); }},
      {.name = "stencil_operations_of_failures",
       .section = section,
       .shows = "The rows of stencil_operations, by a test that never passes.",
       .draw = [](const GlTable& gl) { operate_rows(gl, ~0u, true); }},
      {.name = "stencil_depth_outcomes",
       .section = section,
       .shows = "A ring in one colour where it is seen, in others where a ball that is not seen hides it.",
       .draw = count_depth_outcomes},
      {.name = "stencil_without_depth",
       .section = section,
       .shows = "Two overlapping rectangles: the first by depths that pass, the second by depths that fail.",
       .draw = without_and_never},
      {.name = "stencil_overdraw",
       .section = section,
       .shows = "A ring and a ball, coloured by how many layers cover each pixel.",
       .draw = overdraw},
      {.name = "stencil_mirror",
       .section = section,
       .shows = "A ring above a floor that is seen only by what it mirrors.",
       .draw = mirror},
      {.name = "stencil_two_side",
       .section = section,
       .shows = "The shadow of a ball and a ring on a floor that is not seen, counted in one pass.",
       .draw = two_sided},
      {.name = "stencil_separate",
       .section = section,
       .shows = "Where the floor hides the volume's faces, counted in one pass.",
       .draw = separate},
      {.name = "stencil_culled",
       .section = section,
       .shows = "The volume's near side alone.",
       .draw = culled},
      {.name = "stencil_points_of_back_faces",
       .section = section,
       .shows = "Points of two colours in triples: those of triangles that face away, and all others.",
       // GL 2.0 says that a polygon is one to the stencil test in every mode; to Mesa its points are front.
       .judge = Judge::oracle_only,
       .draw = unfilled_back_faces},
      {.name = "stencil_behind_alpha",
       .section = section,
       .shows = "Overlapping rectangles, about half of them missing, coloured by how many cover a pixel.",
       .draw = behind_alpha},
  };
}

}  // namespace gouraud::conformance
