// The feedback array, value by value [GL1.5 §5.3].
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "api/commands/render_mode.h"
#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

constexpr GLenum no_error = GL_NO_ERROR, invalid_value = GL_INVALID_VALUE, invalid_enum = GL_INVALID_ENUM,
                 invalid_operation = GL_INVALID_OPERATION;
using Values = std::vector<GLfloat>;
constexpr GLfloat point_token = GL_POINT_TOKEN, line_token = GL_LINE_TOKEN, reset_token = GL_LINE_RESET_TOKEN,
                  polygon_token = GL_POLYGON_TOKEN, pass_token = GL_PASS_THROUGH_TOKEN, bitmap_token = GL_BITMAP_TOKEN;

Values feed_back(GLenum type, const std::function<void()>& commands) {
  std::array<GLfloat, 4096> buffer{};
  glFeedbackBuffer(4096, type, buffer.data());
  EXPECT_EQ(glRenderMode(GL_FEEDBACK), 0);
  commands();
  const GLint count = glRenderMode(GL_RENDER);
  EXPECT_GE(count, 0);
  return Values(buffer.begin(), buffer.begin() + std::max(count, 0));
}

struct Feedback : testing::Test {
  Feedback() {
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, side_px, 0, side_px, 1, -1);
    glMatrixMode(GL_MODELVIEW);
  }
  Screen screen;
};

void draw(GLenum mode, std::initializer_list<std::array<GLfloat, 2>> vertices) {
  glBegin(mode);
  for (const auto& vertex : vertices) glVertex2fv(vertex.data());
  glEnd();
}

TEST_F(Feedback, EveryTypeHasItsValues) {
  glColor4f(0.25f, 0.5f, 2, 1);
  glTexCoord4f(1, 2, 3, 4);
  const auto point = [] {
    glBegin(GL_POINTS);
    glVertex4f(6, 10, 0.5f, 2);
    glEnd();
  };
  EXPECT_EQ(feed_back(GL_2D, point), (Values{point_token, 3, 5}));
  EXPECT_EQ(feed_back(GL_3D, point), (Values{point_token, 3, 5, 0.625f}));
  EXPECT_EQ(feed_back(GL_3D_COLOR, point), (Values{point_token, 3, 5, 0.625f, 0.25f, 0.5f, 1, 1}));
  EXPECT_EQ(feed_back(GL_3D_COLOR_TEXTURE, point),
            (Values{point_token, 3, 5, 0.625f, 0.25f, 0.5f, 1, 1, 1, 2, 3, 4}));
  EXPECT_EQ(feed_back(GL_4D_COLOR_TEXTURE, point),
            (Values{point_token, 3, 5, 0.625f, 2, 0.25f, 0.5f, 1, 1, 1, 2, 3, 4}));
  EXPECT_EQ(glGetError(), no_error);
}

TEST_F(Feedback, LinesStartWithAReset) {
  EXPECT_EQ(feed_back(GL_2D, [] { draw(GL_LINES, {{1, 1}, {2, 2}, {3, 3}, {4, 4}}); }),
            (Values{reset_token, 1, 1, 2, 2, reset_token, 3, 3, 4, 4}));
  EXPECT_EQ(feed_back(GL_2D, [] { draw(GL_LINE_STRIP, {{1, 1}, {2, 2}, {3, 3}}); }),
            (Values{reset_token, 1, 1, 2, 2, line_token, 2, 2, 3, 3}));
  EXPECT_EQ(feed_back(GL_2D, [] { draw(GL_LINE_LOOP, {{1, 1}, {2, 2}, {3, 1}}); }),
            (Values{reset_token, 1, 1, 2, 2, line_token, 2, 2, 3, 1, line_token, 3, 1, 1, 1}));
}

TEST_F(Feedback, LinesAreClipped) {
  EXPECT_EQ(feed_back(GL_2D, [] { draw(GL_LINES, {{-16, 8}, {48, 24}, {-9, -9}, {-1, 5}}); }),
            (Values{reset_token, 0, 12, 32, 20}));
}

TEST_F(Feedback, PolygonsStayWhole) {
  EXPECT_EQ(feed_back(GL_2D, [] { draw(GL_QUADS, {{1, 1}, {5, 1}, {5, 5}, {1, 5}}); }),
            (Values{polygon_token, 4, 1, 1, 5, 1, 5, 5, 1, 5}));
  EXPECT_EQ(feed_back(GL_2D, [] { draw(GL_QUAD_STRIP, {{1, 1}, {1, 5}, {5, 1}, {5, 5}, {9, 1}, {9, 5}}); }),
            (Values{polygon_token, 4, 1, 1, 1, 5, 5, 5, 5, 1, polygon_token, 4, 5, 1, 5, 5, 9, 5, 9, 1}));
  EXPECT_EQ(feed_back(GL_2D, [] { draw(GL_POLYGON, {{1, 1}, {5, 1}, {7, 3}, {5, 5}, {1, 5}}); }),
            (Values{polygon_token, 5, 1, 1, 5, 1, 7, 3, 5, 5, 1, 5}));
  EXPECT_EQ(feed_back(GL_2D, [] { draw(GL_TRIANGLE_STRIP, {{1, 1}, {5, 1}, {1, 5}, {5, 5}}); }),
            (Values{polygon_token, 3, 1, 1, 5, 1, 1, 5, polygon_token, 3, 1, 5, 5, 1, 5, 5}));
  EXPECT_EQ(feed_back(GL_2D, [] { draw(GL_TRIANGLE_FAN, {{1, 1}, {5, 1}, {5, 5}, {1, 5}}); }),
            (Values{polygon_token, 3, 1, 1, 5, 1, 5, 5, polygon_token, 3, 1, 1, 5, 5, 1, 5}));
}

TEST_F(Feedback, PolygonsAreClippedToPolygons) {
  const Values values = feed_back(GL_2D, [] { draw(GL_QUADS, {{16, -16}, {48, 16}, {16, 48}, {-16, 16}}); });
  // A square on its tip whose corners are cut off: its sides pass through the corners of the window.
  ASSERT_GE(values.size(), 2u);
  const auto count = static_cast<std::size_t>(values[1]);
  ASSERT_EQ(values.size(), 2 + 2 * count);
  double area = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const GLfloat *a = &values[2 + 2 * i], *b = &values[2 + 2 * ((i + 1) % count)];
    area += 0.5 * (static_cast<double>(a[0]) * b[1] - static_cast<double>(b[0]) * a[1]);
  }
  EXPECT_EQ(area, 32.0 * 32.0);
}

TEST_F(Feedback, PolygonsOfAThousandVerticesStayWhole) {
  int inside = 0;
  const Values values = feed_back(GL_2D, [&inside] {
    glBegin(GL_POLYGON);
    for (int i = 0; i < 1000; ++i) {
      const double x = 18 * std::cos(i * 0.0062831853), y = 18 * std::sin(i * 0.0062831853);
      glVertex2d(16 + x, 16 + y);
      inside += std::abs(x) < 16 && std::abs(y) < 16 ? 1 : 0;
    }
    glEnd();
  });
  ASSERT_GE(values.size(), 2u);
  EXPECT_EQ(values[1], static_cast<GLfloat>(inside + 8));  // the circle crosses each side of the window twice
  EXPECT_EQ(values.size(), 2 + 2 * static_cast<std::size_t>(values[1]));
}

TEST_F(Feedback, ModesCullingAndFlatColors) {
  glEnable(GL_CULL_FACE);
  glPolygonMode(GL_FRONT, GL_LINE);
  EXPECT_EQ(feed_back(GL_2D, [] { draw(GL_QUADS, {{1, 1}, {5, 1}, {5, 5}, {1, 5}, {1, 1}, {1, 5}, {5, 5}, {5, 1}}); }),
            (Values{reset_token, 1, 1, 5, 1, line_token, 5, 1, 5, 5, line_token, 5, 5, 1, 5, line_token, 1, 5, 1, 1}));
  glPolygonMode(GL_FRONT, GL_POINT);
  EXPECT_EQ(feed_back(GL_2D, [] { draw(GL_TRIANGLES, {{1, 1}, {5, 1}, {5, 5}}); }),
            (Values{point_token, 1, 1, point_token, 5, 1, point_token, 5, 5}));
  glDisable(GL_CULL_FACE);
  glShadeModel(GL_FLAT);
  const Values values = feed_back(GL_3D_COLOR, [] {
    glBegin(GL_LINES);
    glColor3f(1, 0, 0), glVertex2f(1, 1);
    glColor3f(0, 0, 1), glVertex2f(2, 2);
    glEnd();
  });
  EXPECT_EQ(values, (Values{reset_token, 1, 1, 0.5f, 0, 0, 1, 1, 2, 2, 0.5f, 0, 0, 1, 1}));
}

TEST_F(Feedback, ColorsAreThoseOfTheClippedVertices) {
  const Values values = feed_back(GL_3D_COLOR, [] {
    glBegin(GL_LINES);
    glColor4f(1, 0, 0, 1), glVertex2f(-16, 4);
    glColor4f(0, 0, 1, 0), glVertex2f(16, 4);
    glEnd();
  });
  EXPECT_EQ(values, (Values{reset_token, 0, 4, 0.5f, 0.5f, 0, 0.5f, 0.5f, 16, 4, 0.5f, 0, 0, 1, 0}));
}

TEST_F(Feedback, EdgeFlagsDecideWhichEdgesAreLines) {
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  const auto quad = [](GLenum mode) {
    glBegin(mode);
    glEdgeFlag(GL_FALSE), glVertex2f(1, 1);
    glEdgeFlag(GL_TRUE), glVertex2f(5, 1);
    glEdgeFlag(GL_FALSE), glVertex2f(5, 5);
    glEdgeFlag(GL_TRUE), glVertex2f(1, 5);
    glEnd();
  };
  for (const GLenum mode : {GL_QUADS, GL_POLYGON}) {
    EXPECT_EQ(feed_back(GL_2D, [=] { quad(mode); }), (Values{reset_token, 5, 1, 5, 5, line_token, 1, 5, 1, 1})) << mode;
  }
  EXPECT_EQ(feed_back(GL_2D, [=] { quad(GL_QUAD_STRIP); }).size(), 20u);  // strips have no flags
}

TEST_F(Feedback, RectanglesAreQuads) {
  EXPECT_EQ(feed_back(GL_2D, [] { glRectf(1, 2, 3, 4); }), (Values{polygon_token, 4, 1, 2, 3, 2, 3, 4, 1, 4}));
}

TEST_F(Feedback, TextureCoordinatesAreTransformedAndClipped) {
  glMatrixMode(GL_TEXTURE);
  glScalef(2, 3, 1);
  const Values values = feed_back(GL_3D_COLOR_TEXTURE, [] {
    glBegin(GL_LINES);
    glTexCoord2f(0, 1), glVertex2f(-16, 4);
    glTexCoord2f(4, 1), glVertex2f(16, 4);
    glEnd();
  });
  EXPECT_EQ(values, (Values{reset_token, 0, 4, 0.5f, 1, 1, 1, 1, 4, 3, 0, 1, 16, 4, 0.5f, 1, 1, 1, 1, 8, 3, 0, 1}));
  glLoadIdentity();
  EXPECT_EQ(feed_back(GL_3D_COLOR_TEXTURE, [] { draw(GL_POINTS, {{1, 2}}); }),
            (Values{point_token, 1, 2, 0.5f, 1, 1, 1, 1, 4, 1, 0, 1}));
}

TEST_F(Feedback, BackFacesHaveTheirOwnLight) {
  glEnable(GL_LIGHTING);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  const GLfloat black[4] = {0, 0, 0, 1}, red[4] = {1, 0, 0, 1}, green[4] = {0, 1, 0, 1};
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
  glMaterialfv(GL_FRONT, GL_EMISSION, red);
  glMaterialfv(GL_BACK, GL_EMISSION, green);
  const auto color = [](std::initializer_list<std::array<GLfloat, 2>> vertices) {
    const Values values = feed_back(GL_3D_COLOR, [&] { draw(GL_TRIANGLES, vertices); });
    return values.size() == 23 ? Values(values.begin() + 5, values.begin() + 9) : Values();
  };
  EXPECT_EQ(color({{1, 1}, {5, 1}, {5, 5}}), (Values{1, 0, 0, 1}));
  EXPECT_EQ(color({{1, 1}, {5, 5}, {5, 1}}), (Values{0, 1, 0, 1}));
}

TEST_F(Feedback, TokensPassThroughInOrder) {
  glPassThrough(1);  // not in this mode
  EXPECT_EQ(feed_back(GL_2D,
                      [] {
                        glPassThrough(-1);
                        draw(GL_POINTS, {{1, 2}});
                        glPassThrough(2.5f);
                        draw(GL_POINTS, {{3, 4}});
                      }),
            (Values{pass_token, -1, point_token, 1, 2, pass_token, 2.5f, point_token, 3, 4}));
}

TEST_F(Feedback, RasterPositionsOfPixelCommands) {
  glColor3f(0, 1, 0);
  EXPECT_EQ(feed_back(GL_3D_COLOR,
                      [this] {
                        glRasterPos2i(4, 5);
                        draw(GL_POINTS, {{1, 2}});
                        report_raster_position(screen.context, GL_BITMAP_TOKEN);
                      }),
            (Values{point_token, 1, 2, 0.5f, 0, 1, 0, 1, bitmap_token, 4, 5, 0.5f, 0, 1, 0, 1}));
}

TEST_F(Feedback, OverflowFillsTheArray) {
  std::array<GLfloat, 8> buffer{};
  glFeedbackBuffer(4, GL_2D, buffer.data());
  glRenderMode(GL_FEEDBACK);
  draw(GL_POINTS, {{1, 2}, {3, 4}});
  EXPECT_EQ(glRenderMode(GL_FEEDBACK), -1);
  EXPECT_EQ(buffer, (std::array<GLfloat, 8>{point_token, 1, 2, point_token}));
  draw(GL_POINTS, {{5, 6}});
  EXPECT_EQ(glRenderMode(GL_RENDER), 3);
  EXPECT_EQ(buffer[1], 5);
}

TEST_F(Feedback, MasksAndTestsDoNotMatter) {
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 0, 0);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_NEVER);
  glColor3f(1, 0, 1);
  EXPECT_EQ(feed_back(GL_3D_COLOR, [] { draw(GL_POINTS, {{1, 2}}); }), (Values{point_token, 1, 2, 0.5f, 1, 0, 1, 1}));
}

TEST_F(Feedback, ErrorsAndQueries) {
  EXPECT_EQ(glRenderMode(GL_FEEDBACK), 0);
  EXPECT_EQ(glGetError(), invalid_operation);
  std::array<GLfloat, 8> buffer{};
  glFeedbackBuffer(-1, GL_2D, buffer.data());
  EXPECT_EQ(glGetError(), invalid_value);
  glFeedbackBuffer(8, GL_2D - 1, buffer.data());
  EXPECT_EQ(glGetError(), invalid_enum);
  GLint value = 0;
  glGetIntegerv(GL_FEEDBACK_BUFFER_TYPE, &value);
  EXPECT_EQ(value, GL_2D);
  glFeedbackBuffer(8, GL_3D, buffer.data());
  glGetIntegerv(GL_FEEDBACK_BUFFER_TYPE, &value);
  EXPECT_EQ(value, GL_3D);
  glGetIntegerv(GL_FEEDBACK_BUFFER_SIZE, &value);
  EXPECT_EQ(value, 8);
  void* pointer = nullptr;
  glGetPointerv(GL_FEEDBACK_BUFFER_POINTER, &pointer);
  EXPECT_EQ(pointer, buffer.data());
  glRenderMode(GL_FEEDBACK);
  glFeedbackBuffer(8, GL_2D, buffer.data());
  EXPECT_EQ(glGetError(), invalid_operation);
  glBegin(GL_POINTS);
  glPassThrough(1);
  EXPECT_EQ(glRenderMode(GL_RENDER), 0);
  glEnd();
  EXPECT_EQ(glGetError(), invalid_operation);
  EXPECT_EQ(glRenderMode(GL_RENDER), 0);
}

TEST_F(Feedback, SurvivesBadNumbers) {
  const Values values = feed_back(GL_4D_COLOR_TEXTURE, [] {
    for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
      glBegin(mode);
      for (const GLfloat x : {NAN, INFINITY, -INFINITY, 1e38f, -1e38f, 0.0f, 5.0f}) {
        glVertex4f(x, 3, 0, 1);
        glVertex4f(3, x, 0, 0);
        glVertex4f(3, 7, x, x);
      }
      glEnd();
    }
  });
  for (const GLfloat value : values) EXPECT_TRUE(std::isfinite(value));
}

/// The same elements one by one, by indices, and from a list, which keeps equal vertices once.
void expect_the_same_by_indices(GLenum mode, const std::vector<std::array<GLfloat, 3>>& vertices, const std::vector<GLuint>& indices) {
  const auto one_by_one = [&] {
    glBegin(mode);
    for (const GLuint index : indices) glEdgeFlag(index % 3 != 0), glVertex3fv(vertices[index].data());
    glEnd();
  };
  const std::vector<GLboolean> flags = [&] {
    std::vector<GLboolean> result;
    for (std::size_t i = 0; i < vertices.size(); ++i) result.push_back(i % 3 != 0);
    return result;
  }();
  const auto by_indices = [&] {
    glVertexPointer(3, GL_FLOAT, 0, vertices.data());
    glEdgeFlagPointer(0, flags.data());
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_EDGE_FLAG_ARRAY);
    glDrawElements(mode, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, indices.data());
  };
  glNewList(1, GL_COMPILE);
  one_by_one();
  glEndList();
  const Values expected = feed_back(GL_3D, one_by_one);
  EXPECT_EQ(feed_back(GL_3D, by_indices), expected) << mode;
  EXPECT_EQ(feed_back(GL_3D, [] { glCallList(1); }), expected) << mode;
}

TEST_F(Feedback, VerticesThatSeveralIndicesNameAreReportedInTheirOrder) {
  std::vector<std::array<GLfloat, 3>> vertices;
  for (int i = 0; i < 9; ++i) {  // one of them outside
    const double angle = 0.7 * i;
    vertices.push_back({static_cast<GLfloat>(4 + 2 * std::cos(angle)), static_cast<GLfloat>(4 + 2 * std::sin(angle)), i == 4 ? 2.0f : 0.1f * static_cast<GLfloat>(i)});
  }
  const std::vector<GLuint> indices{7, 2, 5, 2, 0, 7, 8, 4, 2, 5, 6, 1};
  for (const GLenum mode : {GL_FILL, GL_LINE, GL_POINT}) {
    glPolygonMode(GL_FRONT_AND_BACK, mode);
    for (GLenum primitive = GL_POINTS; primitive <= GL_POLYGON; ++primitive) expect_the_same_by_indices(primitive, vertices, indices);
  }
}

TEST_F(Feedback, ALongPolygonOfFewVerticesIsClippedInItsRoom) {
  std::vector<std::array<GLfloat, 3>> vertices{{1, 1, 0}, {20, 2, 0}, {3, -9, 0.5f}, {-20, 4, -3}, {5, 20, 3}};
  std::vector<GLuint> indices;
  for (GLuint i = 0; i < 7000; ++i) indices.push_back(i * i % 5);
  glVertexPointer(3, GL_FLOAT, 0, vertices.data());
  glEnableClientState(GL_VERTEX_ARRAY);
  std::vector<GLfloat> buffer(100'000);
  glFeedbackBuffer(static_cast<GLsizei>(buffer.size()), GL_2D, buffer.data());
  glRenderMode(GL_FEEDBACK);
  glDrawElements(GL_POLYGON, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, indices.data());
  EXPECT_GE(glRenderMode(GL_RENDER), 0);
  EXPECT_EQ(glGetError(), no_error);
}

}  // namespace
}  // namespace gouraud::api
