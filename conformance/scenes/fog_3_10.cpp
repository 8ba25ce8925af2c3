// Fog: modes, sources of the coordinate, and what comes before and behind it. [GL1.5 §3.10]
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

void fog(const GlTable& gl, GLenum mode, float density, float start, float end) {
  const GLfloat color[4] = {0.61f, 0.67f, 0.73f, 0.2f};
  gl.Enable(GL_FOG);
  gl.Fogi(GL_FOG_MODE, static_cast<GLint>(mode));
  gl.Fogf(GL_FOG_DENSITY, density);
  gl.Fogf(GL_FOG_START, start);
  gl.Fogf(GL_FOG_END, end);
  gl.Fogfv(GL_FOG_COLOR, color);
}

// Checks of a floor from before the eye to the horizon, and boxes on it.
void landscape(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  const Matrix view = look(gl, {.distance = 0, .pitch_deg = 12, .yaw_deg = 21, .fov_y_deg = 60, .near = 0.5f, .far = 60});
  load_model_view(gl, multiply(view, translation(0, -1.1f, 0)));
  const Surface ground = floor_grid(60, 20);
  Random random(310);
  draw_checks(gl, ground, random);
  for (int i = 0; i < 12; ++i) {
    color_of(gl, random);
    const float x = random.range(-8, 8);
    load_model_view(gl, multiply(view, translation(x, -0.6f, -2.5f - 2 * static_cast<float>(i))));
    draw_box(gl, 0.8f, 1, 0.9f);
  }
}

void linear(const GlTable& gl) {
  fog(gl, GL_LINEAR, 1, 2.3f, 19.7f);
  landscape(gl);
}
void exponential(const GlTable& gl) {
  fog(gl, GL_EXP, 0.087f, 0, 1);
  landscape(gl);
}
void squared(const GlTable& gl) {
  fog(gl, GL_EXP2, 0.077f, 0, 1);
  landscape(gl);
}
// Start behind end: what is near disappears.
void inverted(const GlTable& gl) {
  fog(gl, GL_LINEAR, 1, 14.3f, 3.1f);
  landscape(gl);
}

void rows_of_coordinates(const GlTable& gl, float lowest) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  Random random(311);
  constexpr GLenum modes[3] = {GL_LINEAR, GL_EXP, GL_EXP2};
  for (int row = 0; row < 3; ++row) {
    fog(gl, modes[row], 1.3f, 0.2f, 1.7f);
    for (int column = 0; column < 6; ++column) {
      const float x = 4.5f + 42 * static_cast<float>(column), y = 6.5f + 82 * static_cast<float>(row);
      const float corners[6][2] = {{0, 0}, {37, 0}, {37, 76}, {0, 0}, {37, 76}, {0, 76}};
      gl.Begin(GL_TRIANGLES);
      for (const auto& corner : corners) {
        color_of(gl, random);
        gl.FogCoordf(random.range(lowest, 2.4f));
        gl.Vertex2f(x + corner[0], y + corner[1]);
      }
      gl.End();
    }
  }
}

void coordinates(const GlTable& gl) {
  rows_of_coordinates(gl, 0);
}
void negative_coordinates(const GlTable& gl) {
  rows_of_coordinates(gl, -2.4f);
}

// Fog coordinates in perspective, from an array.
void coordinate_array(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  fog(gl, GL_LINEAR, 1, 0, 1);
  gl.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  look(gl, {.distance = 3.1f, .pitch_deg = 34});
  const Surface ground = floor_grid(2.6f, 6);
  std::vector<GLfloat> coordinates;
  for (const Surface::Point& point : ground.points) coordinates.push_back(point.u * point.v + 0.1f);
  std::vector<GLushort> indices;
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) {
      const int first = 7 * row + column;
      for (const int offset : {0, 1, 8, 0, 8, 7}) indices.push_back(static_cast<GLushort>(first + offset));
    }
  }
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_FOG_COORD_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, sizeof(Surface::Point), ground.points[0].position.data());
  gl.FogCoordPointer(GL_FLOAT, 0, coordinates.data());
  gl.Color3f(0.7f, 0.2f, 0.1f);
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_SHORT, indices.data());
}

void lit(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  fog(gl, GL_EXP2, 0.29f, 0, 1);
  black_lighting(gl, 1);
  light(gl, GL_LIGHT0, GL_POSITION, {0.43f, 0.67f, 0.59f, 0});
  light(gl, GL_LIGHT0, GL_DIFFUSE, {0.9f, 0.9f, 0.9f, 1});
  light(gl, GL_LIGHT0, GL_SPECULAR, {0.3f, 0.3f, 0.3f, 1});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.6f, 0.25f, 0.3f, 1});
  material(gl, GL_FRONT, GL_SPECULAR, {0.5f, 0.5f, 0.5f, 1});
  gl.Materialf(GL_FRONT, GL_SHININESS, 9);
  look(gl, {.distance = 3.4f, .pitch_deg = 33});
  draw_surface(gl, torus(0.95f, 0.38f, 48, 24));
}

void blended(const GlTable& gl) {
  clear_background(gl);
  fog(gl, GL_LINEAR, 1, 2.1f, 5.9f);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_GREATER, 0.3f);
  look(gl, {.distance = 4});
  Random random(312);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 3 * 20; ++i) {
    const float r = random.range(0, 1), g = random.range(0, 1), b = random.range(0, 1);
    gl.Color4f(r, g, b, 0.25f + 0.17f * static_cast<float>(i / 3 % 4));
    const float x = random.range(-1.2f, 1.2f), y = random.range(-1.2f, 1.2f);
    gl.Vertex3f(x, y, random.range(-1.2f, 1.2f));
  }
  gl.End();
}

void on_lines_and_points(const GlTable& gl) {
  clear_background(gl);
  fog(gl, GL_EXP, 0.21f, 0, 1);
  look(gl, {.distance = 4.2f});
  Random random(313);
  gl.Begin(GL_LINES);
  for (int i = 0; i < 160; ++i) {
    color_of(gl, random);
    const float x = random.range(-1.4f, 1.4f), y = random.range(-1.4f, 1.4f);
    gl.Vertex3f(x, y, random.range(-1.4f, 1.4f));
  }
  gl.End();
  gl.Begin(GL_POINTS);
  for (int i = 0; i < 2000; ++i) {
    color_of(gl, random);
    const float x = random.range(-1.4f, 1.4f), y = random.range(-1.4f, 1.4f);
    gl.Vertex3f(x, y, random.range(-1.4f, 1.4f));
  }
  gl.End();
}

}  // namespace

SceneList fog_scenes() {
  constexpr auto section = "§3.10";
  return {
      {.name = "fog_linear", .section = section, .shows = "A landscape that fades into a grey fog.", .draw = linear},
      {.name = "fog_exp", .section = section, .shows = "The same, exponential: fog from the first step.", .draw = exponential},
      {.name = "fog_exp2", .section = section, .shows = "The same, squared: clear before, thick behind.", .draw = squared},
      {.name = "fog_inverted", .section = section, .shows = "What is near is hidden, what is far is clear.", .draw = inverted},
      {.name = "fog_coordinates",
       .section = section,
       .shows = "Three rows of six rectangles, a mode each, with coordinates of their own at the corners.",
       .draw = coordinates},
      // Mesa takes a given coordinate's absolute value; the specification takes the coordinate.
      {.name = "fog_coordinates_negative",
       .section = section,
       .shows = "The same with coordinates from -2.4 on: no fog where they are negative, but in the squared mode.",
       .judge = Judge::oracle_only,
       .draw = negative_coordinates},
      {.name = "fog_coordinate_array",
       .section = section,
       .shows = "A red floor that a fog covers from its right far corner.",
       .draw = coordinate_array},
      {.name = "fog_lit", .section = section, .shows = "A lit ring, its far side in fog.", .draw = lit},
      {.name = "fog_blended",
       .section = section,
       .shows = "Translucent triangles in fog: alpha is not fogged.",
       .draw = blended},
      {.name = "fog_lines_points",
       .section = section,
       .shows = "Lines and points that fade with distance.",
       .judge = Judge::lines_and_points,
       .draw = on_lines_and_points},
  };
}

}  // namespace gouraud::conformance
