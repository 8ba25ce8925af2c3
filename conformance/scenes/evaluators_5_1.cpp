// Evaluators: curves, surfaces, their normals and colours, and the three kinds of mesh. [GL1.5 §5.1]
//
// Where a scene is judged by Mesa its control points are small whole numbers and its grid is of quarters: all vertices
// are then exact floats, whichever way they are summed. Mesa sums others in float, we in double: those scenes are the
// oracle's, which gets our vertices. So are filled meshes: the specification has them drawn as quad strips, Mesa draws
// triangle strips, whose diagonals run the other way.
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

void stage(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
}

// Bicubic hills over a square of pixels, 16 control points a side apart.
void hills(const GlTable& gl) {
  constexpr float heights[16] = {0, 64, -64, 0, 32, 96, 0, -64, 0, -96, 64, 32, 64, 0, 32, -32};
  GLfloat points[4][4][3];
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const float height = heights[4 * i + j];
      points[i][j][0] = 32.0f + 64.0f * static_cast<float>(i) + (j == 1 ? 16.0f : 0.0f);
      points[i][j][1] = 32.0f + 64.0f * static_cast<float>(j) - (i == 2 ? 16.0f : 0.0f);
      points[i][j][2] = height / 128;
    }
  }
  gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 12, 4, 0, 1, 3, 4, points[0][0]);
  gl.Enable(GL_MAP2_VERTEX_3);
}

void corner_colors(const GlTable& gl) {
  const GLfloat colors[2][2][4] = {{{1, 0, 0, 1}, {0, 1, 0, 0.5f}}, {{0, 0, 1, 1}, {1, 1, 0, 0}}};
  gl.Map2f(GL_MAP2_COLOR_4, 0, 1, 8, 2, 0, 1, 4, 2, colors[0][0]);
  gl.Enable(GL_MAP2_COLOR_4);
}

void colored_mesh(const GlTable& gl) {
  stage(gl);
  gl.Enable(GL_DEPTH_TEST);
  hills(gl);
  corner_colors(gl);
  gl.MapGrid2f(4, 0, 1, 4, 0, 1);
  gl.EvalMesh2(GL_FILL, 0, 4, 0, 4);
}

void part_of_a_grid(const GlTable& gl) {
  stage(gl);
  hills(gl);
  corner_colors(gl);
  gl.MapGrid2d(4, 0, 1, 4, 1, 0);  // v runs backwards
  gl.EvalMesh2(GL_FILL, 1, 3, 0, 2);
  gl.EvalMesh2(GL_FILL, 3, 4, 2, 4);
  gl.EvalMesh2(GL_FILL, 3, 1, 2, 4);  // nothing
}

void wire_mesh(const GlTable& gl) {
  stage(gl);
  hills(gl);
  corner_colors(gl);
  gl.MapGrid2f(4, 0, 1, 4, 0, 1);
  gl.EvalMesh2(GL_LINE, 0, 4, 0, 4);
}

void point_mesh(const GlTable& gl) {
  stage(gl);
  hills(gl);
  corner_colors(gl);
  gl.MapGrid2f(64, 0, 1, 64, 0, 1);
  gl.EvalMesh2(GL_POINT, 0, 64, 0, 64);
}

void lit_camera(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  const GLfloat shine[4] = {0.5f, 0.5f, 0.5f, 1};
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 24);
  look(gl, {});
}

// A bump of order 4 x 4 over [-1, 1]^2.
void bump(const GlTable& gl) {
  GLfloat points[4][4][3];
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const bool inner = i % 3 != 0 && j % 3 != 0;
      points[i][j][0] = static_cast<float>(2 * i - 3) / 3;
      points[i][j][1] = inner ? 1.75f : 0.0f;
      points[i][j][2] = static_cast<float>(3 - 2 * j) / 3;
    }
  }
  gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 12, 4, 0, 1, 3, 4, points[0][0]);
  gl.Enable(GL_MAP2_VERTEX_3);
}

void automatic_normals(const GlTable& gl) {
  lit_camera(gl);
  bump(gl);
  gl.Enable(GL_AUTO_NORMAL);
  gl.MapGrid2f(20, 0, 1, 20, 0, 1);
  gl.EvalMesh2(GL_FILL, 0, 20, 0, 20);
}

void mapped_normals(const GlTable& gl) {
  lit_camera(gl);
  bump(gl);
  gl.Enable(GL_NORMALIZE);
  gl.Enable(GL_COLOR_MATERIAL);
  corner_colors(gl);
  const GLfloat normals[2][2][3] = {{{-1, 1, 1}, {-1, 1, -1}}, {{1, 1, 1}, {1, 1, -1}}};
  gl.Map2f(GL_MAP2_NORMAL, 0, 1, 6, 2, 0, 1, 3, 2, normals[0][0]);
  gl.Enable(GL_MAP2_NORMAL);
  gl.MapGrid2f(16, 0, 1, 16, 0, 1);
  gl.EvalMesh2(GL_FILL, 0, 16, 0, 16);
}

// Three quarters of a torus's tube, as rational biquadratic patches.
void rational_surface(const GlTable& gl) {
  lit_camera(gl);
  gl.Enable(GL_AUTO_NORMAL);
  gl.Enable(GL_MAP2_VERTEX_4);
  gl.MapGrid2f(8, 0, 1, 8, 0, 1);
  constexpr float half = 0.70710678f;
  constexpr float arc[3][3] = {{1, 0, 1}, {half, half, half}, {0, 1, 1}};  // x, y, w
  constexpr float turns[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};       // cosine, sine
  for (int ring = 0; ring < 3; ++ring) {
    for (int tube = 0; tube < 4; ++tube) {
      GLfloat points[3][3][4];
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          const float rc = turns[ring][0] * arc[i][0] - turns[ring][1] * arc[i][1];
          const float rs = turns[ring][1] * arc[i][0] + turns[ring][0] * arc[i][1];
          const float tc = turns[tube][0] * arc[j][0] - turns[tube][1] * arc[j][1];
          const float ts = turns[tube][1] * arc[j][0] + turns[tube][0] * arc[j][1];
          const float radius = 0.9f * arc[j][2] + 0.4f * tc;
          points[i][j][0] = rc * radius;
          points[i][j][1] = 0.4f * ts * arc[i][2];
          points[i][j][2] = rs * radius;
          points[i][j][3] = arc[i][2] * arc[j][2];
        }
      }
      gl.Map2f(GL_MAP2_VERTEX_4, 0, 1, 12, 3, 0, 1, 4, 3, points[0][0]);
      gl.EvalMesh2(GL_FILL, 0, 8, 0, 8);
    }
  }
}

void curves(const GlTable& gl) {
  stage(gl);
  const GLfloat colors[3][4] = {{1, 0, 0, 1}, {1, 1, 1, 1}, {0, 0, 1, 0}};
  gl.Map1f(GL_MAP1_COLOR_4, 0, 1, 4, 3, colors[0]);
  gl.Enable(GL_MAP1_COLOR_4);
  gl.Enable(GL_MAP1_VERTEX_3);
  Random random(5);
  for (int order = 2; order <= 8; ++order) {
    GLfloat points[8][3] = {};
    for (int i = 0; i < order; ++i) {
      points[i][0] = random.range(8, 248);
      points[i][1] = random.range(8, 248);
    }
    gl.Map1f(GL_MAP1_VERTEX_3, -2, 3, 3, order, points[0]);
    gl.MapGrid1f(24, -2, 3);
    gl.EvalMesh1(order % 2 == 0 ? GL_LINE : GL_POINT, 0, 24);
  }
}

// Order 30 in both directions: heights from a wave, drawn by EvalCoord among given vertices.
void highest_order(const GlTable& gl) {
  stage(gl);
  static GLdouble points[30][30][3];
  Random random(8);
  for (int i = 0; i < 30; ++i) {
    for (int j = 0; j < 30; ++j) {
      points[i][j][0] = 20 + 216.0 * i / 29 + random.range(-60, 60);
      points[i][j][1] = 20 + 216.0 * j / 29 + random.range(-60, 60);
      points[i][j][2] = random.range(-1, 1);
    }
  }
  gl.Map2d(GL_MAP2_VERTEX_3, 0, 1, 90, 30, 0, 1, 3, 30, points[0][0]);
  gl.Enable(GL_MAP2_VERTEX_3);
  corner_colors(gl);
  gl.Enable(GL_DEPTH_TEST);
  for (int j = 0; j < 16; ++j) {
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int i = 0; i <= 16; ++i) {
      gl.EvalCoord2d(i / 16.0, j / 16.0);
      gl.EvalCoord2d(i / 16.0, (j + 1) / 16.0);
    }
    gl.Color3f(1, 1, 1);  // for the vertex that is given, and no other
    gl.Vertex3f(250, 8.0f + 15.0f * static_cast<float>(j), 0);
    gl.End();
  }
}

void in_a_display_list(const GlTable& gl) {
  stage(gl);
  gl.NewList(1, GL_COMPILE);
  hills(gl);
  corner_colors(gl);
  gl.MapGrid2f(4, 0, 1, 4, 0, 1);
  gl.Begin(GL_TRIANGLE_FAN);
  gl.EvalPoint2(2, 2);
  for (int i = 0; i <= 4; ++i) gl.EvalPoint2(i, 4);
  gl.EvalCoord2f(1, 0.25f);
  gl.End();
  for (int j = 0; j < 2; ++j) {
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int i = 0; i <= 4; ++i) {
      gl.EvalPoint2(i, j);
      gl.EvalPoint2(i, j + 1);
    }
    gl.End();
  }
  gl.EndList();
  gl.CallList(1);
}

}  // namespace

SceneList evaluator_scenes() {
  return {
      {"eval_mesh_fill", "§5.1", "A bicubic patch in four colours, 4 x 4 quads.", Judge::oracle_only, 256, 256,
       colored_mesh},
      {"eval_mesh_parts", "§5.1", "Parts of the same patch upside down.", Judge::oracle_only, 256, 256,
       part_of_a_grid},
      {"eval_mesh_line", "§5.1", "The patch as a net of lines.", Judge::lines_and_points, 256, 256, wire_mesh},
      {"eval_mesh_point", "§5.1", "The patch as 65 x 65 points.", Judge::oracle_only, 256, 256, point_mesh},
      {"eval_auto_normal", "§5.1", "A lit hill with automatic normals.", Judge::oracle_only, 256, 256,
       automatic_normals},
      {"eval_map_normal", "§5.1", "The hill with mapped normals and colours.", Judge::oracle_only, 256, 256,
       mapped_normals},
      {"eval_rational", "§5.1", "Three quarters of a lit torus of rational patches.", Judge::oracle_only, 256, 256,
       rational_surface},
      {"eval_curves", "§5.1", "Curves of orders 2 to 8 as lines and points, red over white to blue.",
       Judge::oracle_only, 256, 256, curves},
      {"eval_order_30", "§5.1", "A crumpled patch of order 30 with a fringe of white vertices.", Judge::oracle_only, 256,
       256, highest_order},
      {"eval_display_list", "§5.1", "The first patch from a display list: a fan above, strips below.", Judge::polygons,
       256, 256, in_a_display_list},
  };
}

}  // namespace gouraud::conformance
