// gouraudMethods: chosen by a program, seen in the picture.
#include <GL/gl.h>
#include <GL/gouraud.h>
#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace gouraud::api {
namespace {

constexpr int size = 64;

class MethodsTest : public ::testing::Test {
 protected:
  MethodsTest() {
    OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, size, size);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, size, 0, size, -1, 1);
    glMatrixMode(GL_MODELVIEW);
  }
  ~MethodsTest() override { OSMesaDestroyContext(context); }
  MethodsTest(const MethodsTest&) = delete;
  MethodsTest& operator=(const MethodsTest&) = delete;

  static void choose(const std::string& methods) { ASSERT_EQ(gouraudMethods(methods.c_str()), GL_TRUE) << methods; }
  std::uint32_t at(int x, int y) {
    glFinish();
    return pixels[static_cast<std::size_t>(y * size + x)];
  }
  int red(int x, int y) { return static_cast<int>(at(x, y) & 0xFF); }

  /// How often each pixel of the window is drawn by a mesh of n x n squares of two triangles, whose inner corners are
  /// moved about by multiples of `unit`: with 0.5, edges that pass through samples are many.
  std::vector<int> hits_of_mesh(const std::string& methods, float unit) {
    choose(methods);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glColor3ub(1, 0, 0);
    constexpr int n = 8;
    std::mt19937 random(5);
    std::uniform_int_distribution<int> step(-3, 3);
    float corner[n + 1][n + 1][2];
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        const bool inner_x = j > 0 && j < n, inner_y = i > 0 && i < n;
        corner[i][j][0] = static_cast<float>(j * size / n) + (inner_x ? unit * static_cast<float>(step(random)) : 0.0f);
        corner[i][j][1] = static_cast<float>(i * size / n) + (inner_y ? unit * static_cast<float>(step(random)) : 0.0f);
      }
    }
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        for (const float* v : {corner[i][j], corner[i][j + 1], corner[i + 1][j + 1], corner[i][j], corner[i + 1][j + 1], corner[i + 1][j]}) {
          glVertex2fv(v);
        }
      }
    }
    glEnd();
    glFinish();
    glDisable(GL_BLEND);
    std::vector<int> hits;
    for (const std::uint32_t pixel : pixels) hits.push_back(static_cast<int>(pixel & 0xFF));
    return hits;
  }
  struct Errors {
    int holes = 0, doubles = 0;
  };
  Errors errors_of_mesh(const std::string& methods, float unit = 0.5f) {
    Errors errors;
    for (const int hits : hits_of_mesh(methods, unit)) {
      errors.holes += hits == 0 ? 1 : 0;
      errors.doubles += hits > 1 ? 1 : 0;
    }
    return errors;
  }

  OSMesaContext context = OSMesaCreateContext(OSMESA_RGBA, nullptr);
  std::vector<std::uint32_t> pixels = std::vector<std::uint32_t>(size * size);
};

TEST_F(MethodsTest, AreWhatWasAskedFor) {
  EXPECT_STREQ(gouraudMethodsInUse(), "");
  choose("colors=affine,coverage=incremental");
  EXPECT_STREQ(gouraudMethodsInUse(), "coverage=incremental,colors=affine");
  choose("colors=perspective");
  EXPECT_STREQ(gouraudMethodsInUse(), "");
  choose("colors=affine");
  EXPECT_EQ(gouraudMethods(nullptr), GL_TRUE);
  EXPECT_STREQ(gouraudMethodsInUse(), "");
}

TEST_F(MethodsTest, ThatAreUnknownAreErrorsAndChangeNothing) {
  choose("colors=affine");
  for (const char* wrong : {"colors=purple", "smell=strong", "colors", "=", "colors=", "colors=affine,,x"}) {
    EXPECT_EQ(gouraudMethods(wrong), GL_FALSE) << wrong;
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_VALUE)) << wrong;
  }
  glBegin(GL_POINTS);
  EXPECT_EQ(gouraudMethods(""), GL_FALSE);
  glEnd();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  EXPECT_STREQ(gouraudMethodsInUse(), "colors=affine");
}

TEST_F(MethodsTest, AreFoundByName) {
  EXPECT_EQ(OSMesaGetProcAddress("gouraudMethods"), reinterpret_cast<OSMESAproc>(&gouraudMethods));
  EXPECT_EQ(OSMesaGetProcAddress("gouraudMethodsInUse"), reinterpret_cast<OSMESAproc>(&gouraudMethodsInUse));
  EXPECT_EQ(OSMesaGetProcAddress("gouraudMethodTable"), reinterpret_cast<OSMESAproc>(&gouraudMethodTable));
}

/// Every row of the table, as gouraudMethods takes it.
std::vector<std::string> all_rows() {
  std::istringstream table(gouraudMethodTable());
  std::vector<std::string> rows;
  std::string line;
  while (std::getline(table, line)) {
    const std::size_t tab = line.find('\t');
    rows.push_back(line.substr(0, tab) + "=" + line.substr(tab + 1, line.find('\t', tab + 1) - tab - 1));
  }
  return rows;
}

TEST_F(MethodsTest, OfTheTableCanAllBeChosenAndSurviveAnything) {
  std::mt19937 random(1);
  const float values[] = {0, 1, -1, 40, 63.5f, 1e4f, -1e6f, 3e38f, -3e38f, 1e-40f, INFINITY, NAN};
  const auto value = [&] { return values[random() % std::size(values)]; };
  std::set<std::string> seen;
  for (const std::string& row : all_rows()) {
    EXPECT_TRUE(seen.insert(row).second) << row;
    choose(row);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    for (const GLenum mode : {GL_TRIANGLES, GL_QUAD_STRIP, GL_LINES, GL_LINE_LOOP, GL_POINTS}) {
      glBegin(mode);
      for (int i = 0; i < 240; ++i) {
        glColor3f(value(), value(), value());
        i % 3 == 0 ? glVertex4f(value(), value(), value(), value()) : glVertex2f(value(), value());
      }
      glEnd();
    }
    glFinish();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << row;
  }
}

TEST_F(MethodsTest, FinishWhatIsPendingWithTheOldOnes) {
  const auto triangle = [](float x) {
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0);
    glVertex2f(x, 0);
    glColor3f(0, 0, 0);
    glVertex2f(x + 30, 0);
    glVertex2f(x, 30);
    glEnd();
  };
  triangle(0);
  choose("shading=flat");
  triangle(32);
  EXPECT_GT(red(1, 1), 200);
  EXPECT_EQ(red(33, 1), 0);  // the last vertex's colour
}

TEST_F(MethodsTest, ThatComputeAnEdgeTheSameTwiceDrawEachPixelOfAMeshOnce) {
  for (const char* method : {"", "coverage=bounding_box", "coverage=incremental", "coverage=blocks4", "coverage=blocks16",
                             "coverage=blocks64", "coverage=homogeneous", "coverage=scanline", "coverage=float_edges"}) {
    const Errors errors = errors_of_mesh(method);
    EXPECT_EQ(errors.holes, 0) << method;
    EXPECT_EQ(errors.doubles, 0) << method;
  }
}

TEST_F(MethodsTest, WithoutAnOwnerOfEdgesDrawTwiceOrNotAtAll) {
  for (const std::string coverage : {"", ",coverage=bounding_box", ",coverage=incremental"}) {
    const Errors all = errors_of_mesh("ownership=all" + coverage), none = errors_of_mesh("ownership=none" + coverage);
    EXPECT_EQ(all.holes, 0) << coverage;
    EXPECT_GT(all.doubles, 50) << coverage;
    EXPECT_GT(none.holes, 50) << coverage;
    EXPECT_EQ(none.doubles, 0) << coverage;
  }
}

TEST_F(MethodsTest, OfIntegerEdgesDrawTheDefaultsPixels) {
  const auto picture = [&](const char* method) {
    choose(method);
    glClear(GL_COLOR_BUFFER_BIT);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-20, size + 20);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 300; ++i) {
      glColor3ub(static_cast<GLubyte>(i), static_cast<GLubyte>(random()), 7);
      glVertex2f(place(random), place(random));
    }
    glEnd();
    glFinish();
    return pixels;
  };
  const std::vector<std::uint32_t> expected = picture("");
  for (const char* method : {"coverage=bounding_box", "coverage=incremental", "coverage=blocks4", "coverage=blocks16",
                             "coverage=blocks64"}) {
    EXPECT_EQ(picture(method), expected) << method;
  }
}

TEST_F(MethodsTest, ByAreasNoEpsilonIsRight) {
  EXPECT_GT(errors_of_mesh("coverage=barycentric,epsilon=0", 0.31f).holes, 10);
  const Errors wide = errors_of_mesh("coverage=barycentric,epsilon=0.01", 0.31f);
  EXPECT_EQ(wide.holes, 0);
  EXPECT_GT(wide.doubles, 100);
}

/// Fans around points inside a larger window, each of which draws every pixel once: how many were not.
int errors_of_fans(const char* method) {
  constexpr int side = 512, fans = 20;
  std::vector<std::uint32_t> window(std::size_t{side} * side);
  const OSMesaContext context = OSMesaCreateContext(OSMESA_RGBA, nullptr);
  OSMesaMakeCurrent(context, window.data(), GL_UNSIGNED_BYTE, side, side);
  EXPECT_EQ(gouraudMethods(method), GL_TRUE);
  glOrtho(0, side, 0, side, -1, 1);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glColor3ub(1, 0, 0);
  std::mt19937 random(9);
  std::uniform_real_distribution<float> place(1, side - 1);
  for (int k = 0; k < fans; ++k) {
    const float x = place(random), y = place(random);
    glBegin(GL_TRIANGLE_FAN);
    glVertex2f(x, y);
    for (const auto& [cx, cy] : {std::pair{0, 0}, {side, 0}, {side, side}, {0, side}, {0, 0}}) glVertex2i(cx, cy);
    glEnd();
  }
  glFinish();
  OSMesaDestroyContext(context);
  int wrong = 0;
  for (const std::uint32_t pixel : window) wrong += std::abs(static_cast<int>(pixel & 0xFF) - fans);
  return wrong;
}

TEST(FloatEdges, LeakWhereTheyAreSteppedAndNotWhereTheyAreEvaluated) {
  EXPECT_EQ(errors_of_fans("coverage=float_edges"), 0);
  EXPECT_EQ(errors_of_fans("coverage=incremental"), 0);
  EXPECT_EQ(errors_of_fans("coverage=scanline"), 0);
  EXPECT_EQ(errors_of_fans(""), 0);
  EXPECT_GT(errors_of_fans("coverage=float_steps"), 0);
}

class ClippingTest : public MethodsTest {
 protected:
  /// Of a floor that reaches from behind the eye to the horizon: how many pixels are drawn, and how many differ from the default's.
  struct Floor {
    int drawn = 0, different = 0;
  };
  std::vector<std::uint32_t> draw(const char* method) {
    choose(method);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-1, 1, -1, 1, 1, 50);
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0);
    glVertex3f(-90, -2, 30);
    glColor3f(1, 1, 0);
    glVertex3f(90, -2, 30);
    glColor3f(1, 0, 1);
    glVertex3f(0, -2, -300);
    glEnd();
    glFinish();
    return pixels;
  }
  Floor floor(const char* method) {
    const std::vector<std::uint32_t> expected = draw(""), found = draw(method);
    Floor result;
    for (std::size_t i = 0; i < found.size(); ++i) {
      result.drawn += (found[i] & 0xFF) != 0 ? 1 : 0;
      for (int shift : {0, 8, 16}) {
        const int a = static_cast<int>(found[i] >> shift & 0xFF), b = static_cast<int>(expected[i] >> shift & 0xFF);
        if (std::abs(a - b) > 2) {
          ++result.different;
          break;
        }
      }
    }
    return result;
  }
};

TEST_F(ClippingTest, IsNotNeededWithHomogeneousEdges) {
  for (const char* method : {"clipping=homogeneous", "coverage=homogeneous"}) {
    const Floor result = floor(method);
    EXPECT_GT(result.drawn, size * size / 4) << method;
    EXPECT_LE(result.different, 4) << method;
  }
}

TEST_F(ClippingTest, IsMissedBehindTheEye) { EXPECT_GT(floor("clipping=none").different, size * size / 8); }

TEST_F(ClippingTest, HasAGuardBandAroundTheWindow) {
  EXPECT_EQ(floor("clipping=guard_band").different, 0);  // near and far are clipped
  const auto large_triangle = [&](const char* method) {
    choose(method);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glClear(GL_COLOR_BUFFER_BIT);
    glViewport(8, 8, 40, 40);
    glRectf(-100, -0.3f, 100, 0.4f);
    glViewport(0, 0, size, size);
    glFinish();
    return pixels;
  };
  EXPECT_EQ(large_triangle("clipping=guard_band"), large_triangle(""));
}

class AffineTest : public MethodsTest {
 protected:
  /// The red of the middle of a line across the window whose left end is at w = 1, red, and whose right end at w = 3.
  int middle() {
    glClear(GL_COLOR_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glBegin(GL_QUADS);
    glColor3f(1, 0, 0);
    glVertex4f(-1, -1, 0, 1);
    glColor3f(0, 0, 0);
    glVertex4f(3, -3, 0, 3);
    glVertex4f(3, 3, 0, 3);
    glColor3f(1, 0, 0);
    glVertex4f(-1, 1, 0, 1);
    glEnd();
    return red(size / 2, size / 2);
  }
};

TEST_F(AffineTest, ColoursAreOffInTheMiddleByTheDifferenceOfTheDistances) {
  choose("");
  EXPECT_NEAR(middle(), 255 * 0.75, 4);  // 1/w is 2/3 there, red/w 1/2
  choose("colors=affine");
  EXPECT_NEAR(middle(), 255 * 0.5, 4);
}

TEST_F(AffineTest, ColoursAreRightWhereTheyAreDividedOftenEnough) {
  for (const char* method : {"colors=affine8", "colors=affine16", "colors=barycentric"}) {
    choose(method);
    EXPECT_NEAR(middle(), 255 * 0.75, 4) << method;
  }
}

TEST_F(AffineTest, ColoursBetweenTheDivisionsAreOffByLittle) {
  const auto picture = [&](const char* method) {
    choose(method);
    middle();
    return pixels;
  };
  const std::vector<std::uint32_t> expected = picture("");
  const auto worst = [&](const char* method) {
    int most = 0;
    const std::vector<std::uint32_t> found = picture(method);
    for (std::size_t i = 0; i < found.size(); ++i) {
      most = std::max(most, std::abs(static_cast<int>(found[i] & 0xFF) - static_cast<int>(expected[i] & 0xFF)));
    }
    return most;
  };
  const int affine = worst("colors=affine"), by_16 = worst("colors=affine16"), by_8 = worst("colors=affine8");
  EXPECT_GT(affine, 60);
  EXPECT_LT(by_16, affine / 4);
  EXPECT_LT(by_8, by_16);
  EXPECT_LE(worst("colors=barycentric"), 1);
}

TEST_F(AffineTest, ColoursFollowAHintOnlyIfToldTo) {
  glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_FASTEST);
  choose("");
  EXPECT_NEAR(middle(), 255 * 0.75, 4);
  choose("colors=hint");
  EXPECT_NEAR(middle(), 255 * 0.5, 4);
  glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_NICEST);
  EXPECT_NEAR(middle(), 255 * 0.75, 4);
}

class LineTest : public MethodsTest {
 protected:
  /// The pixels that a line from (x0, y0) to (x1, y1) has.
  int pixels_of_line(const char* method, float x0, float y0, float x1, float y1) {
    choose(method);
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(GL_LINES);
    glVertex2f(x0, y0);
    glVertex2f(x1, y1);
    glEnd();
    glFinish();
    return static_cast<int>(std::count_if(pixels.begin(), pixels.end(), [](std::uint32_t p) { return (p & 0xFF) != 0; }));
  }
};

TEST_F(LineTest, NaivelyDrawnFallsToPiecesWhereItIsSteep) {
  EXPECT_EQ(pixels_of_line("lines=naive", 2.5f, 2.5f, 42.5f, 12.5f), 41);
  EXPECT_EQ(pixels_of_line("lines=naive", 2.5f, 2.5f, 12.5f, 42.5f), 11);
  EXPECT_EQ(pixels_of_line("lines=naive", 2.5f, 2.5f, 2.5f, 42.5f), 1);
}

TEST_F(LineTest, OfStepsHasItsEndPointAsWell) {
  for (const auto& [x, y] : {std::pair{42.5f, 12.5f}, {12.5f, 42.5f}}) {
    EXPECT_EQ(pixels_of_line("", 2.5f, 2.5f, x, y), 40);
    EXPECT_EQ(pixels_of_line("lines=dda", 2.5f, 2.5f, x, y), 41);
    EXPECT_EQ(pixels_of_line("lines=bresenham", 2.5f, 2.5f, x, y), 41);
  }
}

TEST_F(LineTest, OfBresenhamDoesNotSeePartsOfPixels) {
  const auto picture = [&](float x) {
    pixels_of_line("lines=bresenham", x, 2.1f, x + 40, 20.9f);
    return pixels;
  };
  EXPECT_EQ(picture(3.01f), picture(3.98f));
}

TEST_F(MethodsTest, OfLinesByCoverageSpreadALineOverItsNeighbours) {
  choose("lines=coverage");
  glBegin(GL_LINES);
  glVertex2f(4, 8);
  glVertex2f(40, 8);
  glEnd();
  EXPECT_NEAR(red(20, 7), 128, 1);
  EXPECT_NEAR(red(20, 8), 128, 1);
}

}  // namespace
}  // namespace gouraud::api
