// Evaluators: what the vertices are that they send, and that a mesh is what the specification takes it apart into
// [GL1.5 §5.1].
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "api/commands/map_evaluation.h"
#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

constexpr GLenum no_error = GL_NO_ERROR, invalid_value = GL_INVALID_VALUE, invalid_enum = GL_INVALID_ENUM;

/// A vertex as the batch has it.
struct Vertex {
  std::array<float, 4> position;
  std::array<float, 3> normal;
  std::array<float, 4> color;
  bool operator==(const Vertex&) const = default;
};

Vertex vertex(const Context& context, int index) {
  const pipeline::VertexBatch& batch = context.immediate.batch;
  const auto i = static_cast<std::size_t>(index);
  Vertex result{};
  for (std::size_t c = 0; c < 4; ++c) result.position[c] = batch.position_object[c][i];
  if (context.immediate.demand & pipeline::attribute_normal) {
    for (std::size_t c = 0; c < 3; ++c) result.normal[c] = batch.normal_object[c][i];
  }
  if (context.immediate.demand & pipeline::attribute_color) {
    for (std::size_t c = 0; c < 4; ++c) result.color[c] = batch.color[c][i];
  }
  return result;
}

// The pending vertices that the commands leave behind, which are few.
std::vector<Vertex> vertices_of(Screen& screen, const std::function<void()>& commands) {
  screen.context.flush_vertices();
  commands();
  std::vector<Vertex> result;
  for (int i = 0; i < screen.context.immediate.batch.count; ++i) result.push_back(vertex(screen.context, i));
  screen.context.flush_vertices();
  return result;
}

std::array<float, 4> eval1(Screen& screen, float u) {
  const auto vertices = vertices_of(screen, [u] {
    glBegin(GL_POINTS);
    glEvalCoord1f(u);
    glEnd();
  });
  return vertices.size() == 1 ? vertices[0].position : std::array<float, 4>{NAN, NAN, NAN, NAN};
}

Vertex eval2(Screen& screen, float u, float v) {
  const auto vertices = vertices_of(screen, [=] {
    glBegin(GL_POINTS);
    glEvalCoord2f(u, v);
    glEnd();
  });
  return vertices.size() == 1 ? vertices[0] : Vertex{{NAN, NAN, NAN, NAN}, {}, {}};
}

void light() {
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
}

TEST(Curve, IsTheBernsteinSum) {
  Screen screen;
  const GLfloat points[4][3] = {{0, 0, 0}, {1, 2, 0}, {3, -1, 0.5f}, {4, 0, 1}};
  glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 4, points[0]);
  glEnable(GL_MAP1_VERTEX_3);
  EXPECT_EQ(eval1(screen, 0), (std::array<float, 4>{0, 0, 0, 1}));
  EXPECT_EQ(eval1(screen, 1), (std::array<float, 4>{4, 0, 1, 1}));
  EXPECT_EQ(eval1(screen, 0.5f), (std::array<float, 4>{2, 0.375f, 0.3125f, 1}));
  EXPECT_EQ(glGetError(), no_error);
}

TEST(Curve, DomainAndStride) {
  Screen screen;
  GLdouble points[3][7] = {{1}, {5}, {2}};
  glMap1d(GL_MAP1_VERTEX_4, 2, 4, 7, 3, points[0]);
  points[0][0] = 99;  // the map has a copy
  glEnable(GL_MAP1_VERTEX_4);
  EXPECT_EQ(eval1(screen, 2), (std::array<float, 4>{1, 0, 0, 0}));
  EXPECT_EQ(eval1(screen, 3), (std::array<float, 4>{3.25f, 0, 0, 0}));
  EXPECT_EQ(eval1(screen, 4), (std::array<float, 4>{2, 0, 0, 0}));
  const GLfloat backwards[2][3] = {{0, 0, 0}, {1, 0, 0}};
  glDisable(GL_MAP1_VERTEX_4);
  glEnable(GL_MAP1_VERTEX_3);
  glMap1f(GL_MAP1_VERTEX_3, 1, -1, 3, 2, backwards[0]);
  EXPECT_EQ(eval1(screen, 0.5f)[0], 0.25f);
  EXPECT_EQ(eval1(screen, -2)[0], 1.5f);  // beyond the domain the polynomial goes on
}

TEST(Curve, HasOrdersUpToThirty) {
  Screen screen;
  GLfloat points[30][3] = {};
  for (int i = 0; i < 30; ++i) points[i][0] = static_cast<float>(i);
  glEnable(GL_MAP1_VERTEX_3);
  for (int order = 2; order <= 30; ++order) {
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, order, points[0]);
    // Points in line at equal distances: the curve is the line.
    EXPECT_EQ(eval1(screen, 0.375f)[0], 0.375f * static_cast<float>(order - 1)) << order;
  }
  GLint most = 0;
  glGetIntegerv(GL_MAX_EVAL_ORDER, &most);
  EXPECT_EQ(most, 30);
}

TEST(Map, WithoutVertexMapNothingHappens) {
  Screen screen;
  const GLfloat color[4] = {1, 0, 0, 1};
  glMap1f(GL_MAP1_COLOR_4, 0, 1, 4, 1, color);
  glEnable(GL_MAP1_COLOR_4);
  glEnable(GL_MAP2_VERTEX_3);  // the other dimension
  EXPECT_TRUE(std::isnan(eval1(screen, 0)[0]));
  EXPECT_EQ(vertices_of(screen, [] { glEvalMesh1(GL_LINE, 0, 5); }).size(), 0u);
  EXPECT_EQ(eval2(screen, 0.5f, 0.5f).position, (std::array<float, 4>{0, 0, 0, 1}));  // its initial point
  EXPECT_EQ(glGetError(), no_error);
}

TEST(Map, MostComponentsWin) {
  Screen screen;
  const GLfloat three[3] = {3, 3, 3}, four[4] = {4, 4, 4, 4};
  glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 1, three);
  glMap1f(GL_MAP1_VERTEX_4, 0, 1, 4, 1, four);
  glEnable(GL_MAP1_VERTEX_3);
  EXPECT_EQ(eval1(screen, 0), (std::array<float, 4>{3, 3, 3, 1}));
  glEnable(GL_MAP1_VERTEX_4);
  EXPECT_EQ(eval1(screen, 0), (std::array<float, 4>{4, 4, 4, 4}));
}

TEST(Map, LeavesCurrentValuesAlone) {
  Screen screen;
  light();
  glEnable(GL_COLOR_MATERIAL);
  const GLfloat color[2][4] = {{0, 0, 0, 1}, {1, 0.5f, 0, 0}}, normal[3] = {0, 2, 0};
  glMap1f(GL_MAP1_COLOR_4, 0, 1, 4, 2, color[0]);
  glMap1f(GL_MAP1_NORMAL, 0, 1, 3, 1, normal);
  for (const GLenum cap : {GL_MAP1_VERTEX_3, GL_MAP1_COLOR_4, GL_MAP1_NORMAL, GL_MAP1_TEXTURE_COORD_2}) glEnable(cap);
  glColor3f(0.25f, 0.5f, 0.75f);
  glNormal3f(1, 0, 0);
  glTexCoord2f(5, 6);
  const auto vertices = vertices_of(screen, [] {
    glBegin(GL_POINTS);
    glEvalCoord1f(0.5f);
    glVertex2f(0, 0);
    glEnd();
  });
  ASSERT_EQ(vertices.size(), 2u);
  EXPECT_EQ(vertices[0].color, (std::array<float, 4>{0.5f, 0.25f, 0, 0.5f}));
  EXPECT_EQ(vertices[0].normal, (std::array<float, 3>{0, 2, 0}));
  EXPECT_EQ(vertices[1].color, (std::array<float, 4>{0.25f, 0.5f, 0.75f, 1}));
  EXPECT_EQ(vertices[1].normal, (std::array<float, 3>{1, 0, 0}));
  GLfloat values[4];
  glGetFloatv(GL_CURRENT_TEXTURE_COORDS, values);
  EXPECT_EQ(values[0], 5);
  glGetFloatv(GL_CURRENT_COLOR, values);
  EXPECT_EQ(values[0], 0.25f);
}

// z = u^2 - v^2 over [-1, 1]^2, as a biquadratic map with u running up the rows of the array.
void saddle() {
  const GLfloat s[3] = {1, -1, 1};
  GLfloat points[3][3][3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      points[i][j][0] = static_cast<float>(i - 1);
      points[i][j][1] = static_cast<float>(j - 1);
      points[i][j][2] = s[i] - s[j];
    }
  }
  glMap2f(GL_MAP2_VERTEX_3, 0, 1, 9, 3, 0, 1, 3, 3, points[0][0]);
  glEnable(GL_MAP2_VERTEX_3);
}

TEST(Surface, IsTheTensorProduct) {
  Screen screen;
  saddle();
  for (const float u : {0.0f, 0.25f, 0.5f, 1.0f}) {
    for (const float v : {0.0f, 0.75f, 1.0f}) {
      const float x = 2 * u - 1, y = 2 * v - 1;
      EXPECT_EQ(eval2(screen, u, v).position, (std::array<float, 4>{x, y, x * x - y * y, 1}));
    }
  }
}

TEST(Surface, AutomaticNormalsAreThoseOfTheSurface) {
  Screen screen;
  light();
  saddle();
  glEnable(GL_AUTO_NORMAL);
  for (const float u : {0.0f, 0.3f, 1.0f}) {
    for (const float v : {0.1f, 0.5f}) {
      const double x = 2.0 * u - 1, y = 2.0 * v - 1, length = std::sqrt(4 * x * x + 4 * y * y + 1);
      const auto normal = eval2(screen, u, v).normal;
      EXPECT_NEAR(normal[0], -2 * x / length, 1e-7);
      EXPECT_NEAR(normal[1], 2 * y / length, 1e-7);
      EXPECT_NEAR(normal[2], 1 / length, 1e-7);
    }
  }
}

TEST(Surface, AutomaticNormalsOfRationalSurfaces) {
  Screen screen;
  light();
  // A quarter of a cylinder about the y axis: (cos, v, sin) as a rational quadratic.
  const float r = std::sqrt(0.5f);
  const GLfloat points[3][2][4] = {{{1, 0, 0, 1}, {1, 1, 0, 1}}, {{r, 0, r, r}, {r, r, r, r}}, {{0, 0, 1, 1}, {0, 1, 1, 1}}};
  glMap2f(GL_MAP2_VERTEX_4, 0, 1, 8, 3, 0, 1, 4, 2, points[0][0]);
  glEnable(GL_MAP2_VERTEX_4);
  glEnable(GL_AUTO_NORMAL);
  glEnable(GL_MAP2_NORMAL);  // gives way
  for (const float u : {0.0f, 0.2f, 0.5f, 0.9f, 1.0f}) {
    const Vertex vertex = eval2(screen, u, 0.3f);
    const double x = vertex.position[0] / vertex.position[3], z = vertex.position[2] / vertex.position[3];
    EXPECT_NEAR(x * x + z * z, 1.0, 1e-6);
    EXPECT_NEAR(vertex.normal[0], -x, 1e-6);
    EXPECT_NEAR(vertex.normal[1], 0, 1e-6);
    EXPECT_NEAR(vertex.normal[2], -z, 1e-6);
  }
}

TEST(Surface, NormalIsZeroWhereItHasNone) {
  Screen screen;
  light();
  const GLfloat points[2][2][3] = {{{0, 0, 0}, {0, 0, 0}}, {{1, 0, 0}, {0, 1, 0}}};  // a triangle: u = 0 is its tip
  glMap2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, 0, 1, 3, 2, points[0][0]);
  glEnable(GL_MAP2_VERTEX_3);
  glEnable(GL_AUTO_NORMAL);
  EXPECT_EQ(eval2(screen, 0, 0.5f).normal, (std::array<float, 3>{0, 0, 0}));
  EXPECT_EQ(eval2(screen, 0.5f, 0.5f).normal, (std::array<float, 3>{0, 0, 1}));
}

// The grid's parameters, as the specification writes them.
float across(int i) {
  return i == 7 ? 0.9f : static_cast<float>(i * ((static_cast<double>(0.9f) - 0.2f) / 7) + 0.2f);
}
float upwards(int j) {
  return j == 3 ? -0.5f : static_cast<float>(j * (-1.5 / 3) + 1);
}

void mesh_maps() {
  light();
  glEnable(GL_COLOR_MATERIAL);
  saddle();
  glEnable(GL_AUTO_NORMAL);
  const GLfloat colors[2][2][4] = {{{0, 0, 0, 1}, {1, 0, 0, 1}}, {{0, 1, 0, 0}, {0, 0, 1, 1}}};
  glMap2f(GL_MAP2_COLOR_4, 0, 1, 8, 2, 0, 1, 4, 2, colors[0][0]);
  glEnable(GL_MAP2_COLOR_4);
  glMapGrid2f(7, 0.2f, 0.9f, 3, 1, -0.5f);
}

TEST(Mesh, FillIsQuadStripsOfRows) {
  Screen screen;
  mesh_maps();
  const auto mesh = vertices_of(screen, [] { glEvalMesh2(GL_FILL, 1, 7, 0, 3); });
  const auto strips = vertices_of(screen, [] {
    for (int j = 0; j < 3; ++j) {
      glBegin(GL_QUAD_STRIP);
      for (int i = 1; i <= 7; ++i) {
        glEvalPoint2(i, j);
        glEvalPoint2(i, j + 1);
      }
      glEnd();
    }
  });
  ASSERT_EQ(mesh.size(), 42u);
  EXPECT_EQ(mesh, strips);
}

TEST(Mesh, LineIsStripsBothWays) {
  Screen screen;
  mesh_maps();
  const auto mesh = vertices_of(screen, [] { glEvalMesh2(GL_LINE, 0, 4, 1, 3); });
  const auto strips = vertices_of(screen, [] {
    for (int j = 1; j <= 3; ++j) {
      glBegin(GL_LINE_STRIP);
      for (int i = 0; i <= 4; ++i) glEvalPoint2(i, j);
      glEnd();
    }
    for (int i = 0; i <= 4; ++i) {
      glBegin(GL_LINE_STRIP);
      for (int j = 1; j <= 3; ++j) glEvalPoint2(i, j);
      glEnd();
    }
  });
  ASSERT_EQ(mesh.size(), 30u);
  EXPECT_EQ(mesh, strips);
}

TEST(Mesh, PointIsPointsRowByRow) {
  Screen screen;
  mesh_maps();
  const auto mesh = vertices_of(screen, [] { glEvalMesh2(GL_POINT, -1, 2, 2, 4); });
  const auto points = vertices_of(screen, [] {
    glBegin(GL_POINTS);
    for (int j = 2; j <= 4; ++j) {
      for (int i = -1; i <= 2; ++i) glEvalPoint2(i, j);
    }
    glEnd();
  });
  ASSERT_EQ(mesh.size(), 12u);
  EXPECT_EQ(mesh, points);
}

TEST(Mesh, GridPointsAreCoordinatesWithExactEnds) {
  Screen screen;
  mesh_maps();
  const auto points = vertices_of(screen, [] {
    glBegin(GL_POINTS);
    glEvalPoint2(0, 0), glEvalPoint2(7, 3), glEvalPoint2(3, 2);
    glEnd();
  });
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[0], eval2(screen, 0.2f, 1));
  EXPECT_EQ(points[1], eval2(screen, 0.9f, -0.5f));
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(points[2].position[c], eval2(screen, across(3), upwards(2)).position[c], 1e-6f);
  }
}

TEST(Mesh, OfACurve) {
  Screen screen;
  const GLfloat points[2][3] = {{0, 0, 0}, {8, 0, 0}};
  glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, points[0]);
  glEnable(GL_MAP1_VERTEX_3);
  glMapGrid1f(8, 0, 1);
  for (const GLenum mode : {GL_LINE, GL_POINT}) {
    const auto mesh = vertices_of(screen, [mode] { glEvalMesh1(mode, 2, 5); });
    ASSERT_EQ(mesh.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(mesh[i].position[0], static_cast<float>(i + 2));
  }
  EXPECT_EQ(vertices_of(screen, [] { glEvalMesh1(GL_LINE, 5, 2); }).size(), 0u);
}

TEST(Evaluators, GoIntoDisplayLists) {
  Screen screen;
  glNewList(1, GL_COMPILE);
  {
    GLfloat points[2][5] = {{1, 2, 3}, {3, 2, 1}};
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 5, 2, points[0]);
    points[0][0] = 77;
  }
  glEnable(GL_MAP1_VERTEX_3);
  glBegin(GL_POINTS);
  glEvalCoord1f(0.5f);
  glEvalPoint1(1);
  glEnd();
  glEndList();
  EXPECT_FALSE(glIsEnabled(GL_MAP1_VERTEX_3));
  const auto vertices = vertices_of(screen, [] { glCallList(1); });
  ASSERT_EQ(vertices.size(), 2u);
  EXPECT_EQ(vertices[0].position, (std::array<float, 4>{2, 2, 2, 1}));
  EXPECT_EQ(vertices[1].position, (std::array<float, 4>{3, 2, 1, 1}));
}

TEST(Evaluators, Queries) {
  Screen screen;
  GLfloat f[64] = {};
  GLint i[64] = {};
  GLdouble d[64] = {};
  glGetMapfv(GL_MAP2_COLOR_4, GL_COEFF, f);
  EXPECT_EQ((std::array{f[0], f[1], f[2], f[3]}), (std::array{1.f, 1.f, 1.f, 1.f}));
  glGetMapiv(GL_MAP1_NORMAL, GL_COEFF, i);
  EXPECT_EQ((std::array{i[0], i[1], i[2]}), (std::array{0, 0, 1}));
  glGetMapdv(GL_MAP1_VERTEX_4, GL_DOMAIN, d);
  EXPECT_EQ((std::array{d[0], d[1]}), (std::array{0.0, 1.0}));

  GLdouble points[12];
  for (int k = 0; k < 12; ++k) points[k] = k + 0.25;
  glMap2d(GL_MAP2_TEXTURE_COORD_2, -1, 2.5, 2, 3, 4, 5, 6, 2, points);
  glGetMapiv(GL_MAP2_TEXTURE_COORD_2, GL_ORDER, i);
  EXPECT_EQ((std::array{i[0], i[1]}), (std::array{3, 2}));
  glGetMapfv(GL_MAP2_TEXTURE_COORD_2, GL_DOMAIN, f);
  EXPECT_EQ((std::array{f[0], f[1], f[2], f[3]}), (std::array{-1.f, 2.5f, 4.f, 5.f}));
  glGetMapdv(GL_MAP2_TEXTURE_COORD_2, GL_COEFF, d);
  const double want[] = {0.25, 1.25, 6.25, 7.25, 2.25, 3.25, 8.25, 9.25, 4.25, 5.25, 10.25, 11.25};
  for (int k = 0; k < 12; ++k) EXPECT_EQ(d[k], want[k]);
  glGetMapiv(GL_MAP2_TEXTURE_COORD_2, GL_COEFF, i);
  EXPECT_EQ(i[1], 1);
  EXPECT_EQ(glGetError(), no_error);
  i[0] = 42;
  glGetMapiv(GL_MAP2_TEXTURE_COORD_2, GL_VERTEX_ARRAY, i);
  EXPECT_EQ(glGetError(), invalid_enum);
  glGetMapiv(GL_TEXTURE_2D, GL_ORDER, i);
  EXPECT_EQ(glGetError(), invalid_enum);
  EXPECT_EQ(i[0], 42);

  glGetFloatv(GL_MAP2_GRID_DOMAIN, f);
  EXPECT_EQ((std::array{f[0], f[1], f[2], f[3]}), (std::array{0.f, 1.f, 0.f, 1.f}));
  glMapGrid2d(3, 1, 2, 4, 5, 6);
  glMapGrid1d(9, -1, -2);
  glGetIntegerv(GL_MAP2_GRID_SEGMENTS, i);
  EXPECT_EQ((std::array{i[0], i[1]}), (std::array{3, 4}));
  glGetFloatv(GL_MAP2_GRID_DOMAIN, f);
  EXPECT_EQ((std::array{f[0], f[1], f[2], f[3]}), (std::array{1.f, 2.f, 5.f, 6.f}));
  glGetIntegerv(GL_MAP1_GRID_SEGMENTS, i);
  EXPECT_EQ(i[0], 9);
  glGetFloatv(GL_MAP1_GRID_DOMAIN, f);
  EXPECT_EQ((std::array{f[0], f[1]}), (std::array{-1.f, -2.f}));
}

TEST(Evaluators, EnablesAndGridsAreOfTheEvalGroup) {
  Screen screen;
  for (GLenum cap = GL_MAP1_COLOR_4; cap <= GL_MAP1_VERTEX_4; ++cap) {
    for (const GLenum one : {cap, cap + GL_MAP2_COLOR_4 - GL_MAP1_COLOR_4, static_cast<GLenum>(GL_AUTO_NORMAL)}) {
      for (const GLbitfield bit : {GL_EVAL_BIT, GL_ENABLE_BIT}) {
        glPushAttrib(bit);
        glEnable(one);
        EXPECT_TRUE(glIsEnabled(one));
        glMapGrid1f(5, 3, 4);
        glPopAttrib();
        EXPECT_FALSE(glIsEnabled(one));
      }
    }
  }
  glMapGrid1f(1, 0, 1);
  glPushAttrib(GL_EVAL_BIT);
  glMapGrid1f(5, 3, 4);
  glPopAttrib();
  GLint segments = 0;
  glGetIntegerv(GL_MAP1_GRID_SEGMENTS, &segments);
  EXPECT_EQ(segments, 1);
  EXPECT_EQ(glGetError(), no_error);
}

TEST(Evaluators, RefuseBadMaps) {
  Screen screen;
  const GLfloat points[64] = {};
  const GLdouble doubles[64] = {};
  const State before = screen.context.state;
  const auto refused = [&](GLenum error, const std::function<void()>& command) {
    command();
    EXPECT_EQ(glGetError(), error);
    EXPECT_TRUE(screen.context.state == before);
  };
  refused(invalid_enum, [&] { glMap1f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, points); });
  refused(invalid_enum, [&] { glMap2f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 2, points); });
  refused(invalid_enum, [&] { glMap1f(GL_MAP1_COLOR_4 - 1, 0, 1, 4, 2, points); });
  refused(invalid_value, [&] { glMap1f(GL_MAP1_VERTEX_3, 1, 1, 3, 2, points); });
  refused(invalid_value, [&] { glMap1f(GL_MAP1_VERTEX_3, 0, 1, 2, 2, points); });
  refused(invalid_value, [&] { glMap1f(GL_MAP1_VERTEX_3, 0, 1, -3, 2, points); });
  refused(invalid_value, [&] { glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 0, points); });
  refused(invalid_value, [&] { glMap1d(GL_MAP1_VERTEX_3, 0, 1, 3, 31, doubles); });
  refused(invalid_value, [&] { glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, nullptr); });
  refused(invalid_value, [&] { glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 7, 7, 6, 2, points); });
  refused(invalid_value, [&] { glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 2, 2, points); });
  refused(invalid_value, [&] { glMap2d(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 31, doubles); });
  refused(invalid_value, [&] { glMap2d(GL_MAP2_VERTEX_3, 0, 1, 3, 0, 0, 1, 6, 2, doubles); });
  refused(invalid_value, [] { glMapGrid1f(0, 0, 1); });
  refused(invalid_value, [] { glMapGrid2f(1, 0, 1, -1, 0, 1); });
  refused(invalid_enum, [] { glEvalMesh1(GL_FILL, 0, 1); });
  refused(invalid_enum, [] { glEvalMesh2(GL_POINTS, 0, 1, 0, 1); });
  glActiveTexture(GL_TEXTURE1);
  glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, points);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
}

TEST(Evaluators, SurviveBadNumbers) {
  Screen screen;
  light();
  const GLfloat inf = std::numeric_limits<GLfloat>::infinity();
  const GLfloat points[8][3] = {{NAN, inf, 0}, {1e38f, -1e38f, 1e38f}, {0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {}, {}, {}};
  glMap2f(GL_MAP2_VERTEX_3, NAN, inf, 6, 4, -1e38f, 1e38f, 3, 2, points[0]);
  EXPECT_EQ(glGetError(), no_error);
  glEnable(GL_MAP2_VERTEX_3);
  glEnable(GL_AUTO_NORMAL);
  glMapGrid2f(2147483647, NAN, 1, 3, inf, -inf);
  glEvalMesh2(GL_FILL, 0, 5, 0, 5);
  glEvalMesh2(GL_LINE, 2147483640, 2147483647, -2147483647, -2147483640);
  glBegin(GL_TRIANGLES);
  for (const GLfloat u : {NAN, inf, -inf, 0.0f, 1e38f}) glEvalCoord2f(u, u);
  glEnd();
  glEvalCoord2f(0, 0);  // outside Begin and End: no vertex
  glEvalMesh2(GL_FILL, -2147483647, 2147483647, 0, 1);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_OUT_OF_MEMORY));
  EXPECT_FALSE(screen.context.inside_begin_end());
  glFinish();
}

TEST(Evaluators, MeshesAreRefusedBetweenBeginAndEnd) {
  Screen screen;
  glBegin(GL_POINTS);
  glEvalMesh1(GL_LINE, 0, 1);
  glEnd();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
}

TEST(MapSelection, HasNoMapWhereNoneIsEnabled) {
  EvalGroup group;
  const MapSelection nothing = select_maps(group, 2, ~0u);
  for (const std::size_t kind : {nothing.position, nothing.normal, nothing.color, nothing.texture_coordinates}) {
    EXPECT_EQ(kind, MapSelection::none);
  }
  group.map2_enabled.fill(true);
  const MapSelection all = select_maps(group, 2, ~0u);
  EXPECT_EQ(all.position, GL_MAP2_VERTEX_4 - GL_MAP2_COLOR_4);
  EXPECT_EQ(all.color, std::size_t{0});
  EXPECT_EQ(all.texture_coordinates, GL_MAP2_TEXTURE_COORD_4 - GL_MAP2_COLOR_4);
}

}  // namespace
}  // namespace gouraud::api
