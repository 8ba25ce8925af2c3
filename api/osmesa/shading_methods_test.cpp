// Methods of depth, shading and antialiasing: what each gets right, and where the weak ones fail.
#include <GL/gl.h>
#include <GL/gouraud.h>
#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace gouraud::api {
namespace {

constexpr int size = 64;

class PictureTest : public ::testing::Test {
 protected:
  PictureTest() {
    OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, size, size);
    glEnable(GL_DEPTH_TEST);
  }
  ~PictureTest() override { OSMesaDestroyContext(context); }
  PictureTest(const PictureTest&) = delete;
  PictureTest& operator=(const PictureTest&) = delete;

  template <class Draw>
  std::vector<std::uint32_t> picture(const std::string& methods, const Draw& draw) {
    EXPECT_EQ(gouraudMethods(methods.c_str()), GL_TRUE) << methods;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw();
    glFinish();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << methods;
    return pixels;
  }
  static int channel(std::uint32_t pixel, int k) { return static_cast<int>(pixel >> (8 * k) & 0xFF); }
  static int largest_difference(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    int most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (int k = 0; k < 4; ++k) most = std::max(most, std::abs(channel(a[i], k) - channel(b[i], k)));
    }
    return most;
  }
  static int differing(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
    return count;
  }

  OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 16, nullptr);
  std::vector<std::uint32_t> pixels = std::vector<std::uint32_t>(size * size);
};

void triangle(std::array<float, 3> color, const std::array<std::array<float, 3>, 3>& corners) {
  glColor3fv(color.data());
  glBegin(GL_TRIANGLES);
  for (const auto& corner : corners) glVertex3fv(corner.data());
  glEnd();
}

/// Two triangles one behind the other, the nearer one first; then one behind both.
void layers() {
  triangle({1, 0, 0}, {{{-0.9f, -0.9f, -0.5f}, {0.8f, -0.8f, -0.4f}, {0, 0.9f, -0.6f}}});
  triangle({0, 1, 0}, {{{-0.8f, 0.7f, 0.1f}, {0.1f, -0.9f, 0.2f}, {0.9f, 0.8f, 0.1f}}});
  triangle({0, 0, 1}, {{{-1, -1, 0.8f}, {1, -1, 0.9f}, {1, 1, 0.8f}}});
}

/// Three bars, each over the next and under the one before.
void cycle() {
  for (int k = 0; k < 3; ++k) {
    glPushMatrix();
    glRotatef(120.0f * static_cast<float>(k), 0, 0, 1);
    triangle({k == 0 ? 1.0f : 0.0f, k == 1 ? 1.0f : 0.0f, k == 2 ? 1.0f : 0.0f},
             {{{-0.9f, -0.55f, -0.5f}, {0.9f, -0.4f, 0.5f}, {-0.9f, -0.25f, -0.5f}}});
    glPopMatrix();
  }
}

TEST_F(PictureTest, OfLayersIsTheSameWithAndWithoutADepthBuffer) {
  const auto expected = picture("", layers);
  EXPECT_EQ(differing(picture("depth=painter", layers), expected), 0);
  EXPECT_LE(differing(picture("depth=ray", layers), expected), 8);  // corners that are not snapped
  EXPECT_EQ(differing(picture("depth=w", layers), expected), 0);
}

TEST_F(PictureTest, OfACycleIsNotAPaintersBusiness) {
  const auto expected = picture("", cycle);
  EXPECT_GT(differing(picture("depth=painter", cycle), expected), 10);
  EXPECT_LE(differing(picture("depth=ray", cycle), expected), 16);
}

TEST_F(PictureTest, OfThePainterIsInTheOrderOfTheCallsWithoutADepthTest) {
  glDisable(GL_DEPTH_TEST);
  EXPECT_EQ(picture("depth=painter", layers), picture("", layers));
}

/// Two floors a distance apart, far away; the upper one, green, is drawn first. How many pixels of it are seen.
int seen_far_away(const std::vector<std::uint32_t>& pixels) {
  return static_cast<int>(std::count_if(pixels.begin(), pixels.end(), [](std::uint32_t p) { return (p >> 8 & 0xFF) != 0; }));
}
void far_walls() {
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-0.1, 0.1, -0.1, 0.1, 0.1, 1000);
  glMatrixMode(GL_MODELVIEW);
  for (const float z : {-900.0f, -901.0f}) {
    glColor3f(0, z == -900.0f ? 1.0f : 0.0f, 1);
    glBegin(GL_QUADS);
    for (const auto& [x, y] : {std::pair{-800.0f, -800.0f}, {800.0f, -800.0f}, {800.0f, 800.0f}, {-800.0f, 800.0f}}) {
      glVertex3f(x, y, z + 0.3f * x / 800.0f);
    }
    glEnd();
  }
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
}

TEST_F(PictureTest, OfFarWallsNeedsDistancesWhereSixteenBitsOfDepthDoNotDo) {
  const int whole = seen_far_away(picture("", far_walls));
  EXPECT_GT(whole, 3000);
  EXPECT_EQ(seen_far_away(picture("depth=w", far_walls)), whole);
  EXPECT_EQ(seen_far_away(picture("depth=w16", far_walls)), whole);
  glDepthFunc(GL_LEQUAL);
  EXPECT_LT(seen_far_away(picture("depth=z16", far_walls)), whole / 2);
}

constexpr const char* depth_formats[] = {"depth=z16", "depth=z24", "depth=z32", "depth=float", "depth=reversed"};

/// Two floors that cross, a decal on one by polygon offset, a rectangle of pixels, a bitmap and stencil.
void depth_uses(GLenum func, double clear) {
  glClearDepth(clear);
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glDepthFunc(func);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, 1, 0xFF);
  glStencilOp(GL_KEEP, GL_INVERT, GL_INCR);
  triangle({1, 0, 0}, {{{-1, -1, -0.75f}, {1, -1, -0.75f}, {0, 1, 0.75f}}});
  triangle({0, 1, 0}, {{{-1, 1, -0.5f}, {-1, -1, 0.25f}, {1, 0, 0.5f}}});
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(func == GL_LESS || func == GL_LEQUAL ? -1.0f : 1.0f, func == GL_LESS || func == GL_LEQUAL ? -4.0f : 4.0f);
  triangle({0, 0, 1}, {{{-0.5f, -0.5f, -0.375f}, {0.5f, -0.5f, -0.375f}, {0, 0.5f, 0.375f}}});
  glDisable(GL_POLYGON_OFFSET_FILL);
  const std::vector<std::uint32_t> gray(16 * 16, 0xFF808080);
  glWindowPos3f(24, 24, 0.5f);
  glDrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, gray.data());
  glDepthRange(0.25, 0.75);
  triangle({1, 1, 0}, {{{-1, -1, 0}, {0, -1, 0.125f}, {-1, 0, 0}}});
  glDepthRange(0, 1);
  glStencilFunc(GL_EQUAL, 2, 0xFF);
  glDisable(GL_DEPTH_TEST);
  triangle({1, 1, 1}, {{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}});
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_STENCIL_TEST);
  glClearDepth(1);
}

TEST_F(PictureTest, IsTheSameInEveryFormatOfDepthIfNothingIsFinerThanItsSteps) {
  for (const auto& [func, clear] : {std::pair{GL_LESS, 1.0}, {GL_LEQUAL, 0.75}, {GL_GREATER, 0.0}, {GL_GEQUAL, 0.25}, {GL_NOTEQUAL, 1.0}}) {
    const auto draw = [f = static_cast<GLenum>(func), c = clear] { depth_uses(f, c); };
    const std::vector<std::uint32_t> expected = picture("", draw);
    for (const char* format : depth_formats) EXPECT_EQ(differing(picture(format, draw), expected), 0) << format << ' ' << func;
  }
}

TEST_F(PictureTest, HasTheBitsOfDepthThatTheMethodSays) {
  const struct {
    const char* methods;
    GLint bits;
    double step;
  } formats[] = {{"", 24, 0x1p-24}, {"depth=z16", 16, 0x1p-16}, {"depth=z24", 24, 0x1p-24}, {"depth=z32", 32, 0x1p-24}, {"depth=float", 32, 0x1p-24}};
  for (const auto& [methods, bits, step] : formats) {
    picture(methods, [] { triangle({1, 1, 1}, {{{-3, -1, 0.3f}, {1, -1, 0.3f}, {1, 3, 0.3f}}}); });
    GLint found = 0;
    glGetIntegerv(GL_DEPTH_BITS, &found);
    EXPECT_EQ(found, bits) << methods;
    float depth = 0;
    GLuint fixed = 0;
    glReadPixels(40, 10, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    glReadPixels(40, 10, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &fixed);
    EXPECT_NEAR(static_cast<double>(depth), 0.65, step) << methods;
    EXPECT_NEAR(fixed / 4294967295.0, 0.65, step) << methods;
  }
  picture("depth=reversed", [] { triangle({1, 1, 1}, {{{-3, -1, 0.3f}, {1, -1, 0.3f}, {1, 3, 0.3f}}}); });
  float depth = 0;
  glReadPixels(40, 10, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
  EXPECT_NEAR(depth, 0.35f, 1e-7f);
}

/// As far_walls, with far a hundred million times near.
void very_far_walls() {
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-1e-5, 1e-5, -1e-5, 1e-5, 1e-5, 1000);
  glMatrixMode(GL_MODELVIEW);
  for (const float z : {-100.0f, -101.0f}) {
    glColor3f(0, z == -100.0f ? 1.0f : 0.0f, 1);
    glBegin(GL_QUADS);
    for (const auto& [x, y] : {std::pair{-80.0f, -80.0f}, {80.0f, -80.0f}, {80.0f, 80.0f}, {-80.0f, 80.0f}}) glVertex3f(x, y, z + 0.3f * x / 80.0f);
    glEnd();
  }
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
}

TEST_F(PictureTest, OfVeryFarWallsNeedsReversedDepth) {
  glDepthFunc(GL_LEQUAL);
  const int whole = seen_far_away(picture("depth=reversed", very_far_walls));
  EXPECT_GT(whole, 2000);
  for (const char* format : {"", "depth=z16", "depth=z24", "depth=z32", "depth=float"}) {
    EXPECT_LT(seen_far_away(picture(format, very_far_walls)), whole) << format;
  }
}

TEST_F(PictureTest, OfAFramebufferObjectHasItsOwnFormatOfDepth) {
  GLuint texture = 0, framebuffer = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size, size, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  glGenFramebuffers(1, &framebuffer);
  for (const char* format : {"", "depth=z16", "depth=reversed"}) {
    picture(format, [&] {
      glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
      glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
      glDrawBuffer(GL_NONE);
      glReadBuffer(GL_NONE);
      glClear(GL_DEPTH_BUFFER_BIT);
      triangle({1, 1, 1}, {{{-3, -1, 0.3f}, {1, -1, 0.3f}, {1, 3, 0.3f}}});
      float depth = 0;
      glReadPixels(40, 10, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
      EXPECT_NEAR(depth, 0.65f, 1e-7f) << format;
      glBindFramebuffer(GL_FRAMEBUFFER, 0);
    });
  }
}

/// A lit square of two triangles, whose highlight is in its middle.
void lit_square() {
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  const float position[] = {0, 0, 0.6f, 1}, white[] = {1, 1, 1, 1}, gray[] = {0.3f, 0.3f, 0.3f, 1};
  glLightfv(GL_LIGHT0, GL_POSITION, position);
  glMaterialfv(GL_FRONT, GL_SPECULAR, white);
  glMaterialfv(GL_FRONT, GL_DIFFUSE, gray);
  glMaterialf(GL_FRONT, GL_SHININESS, 30.5f);
  glNormal3f(0, 0, 1);
  glRectf(-1, -1, 1, 1);
  glDisable(GL_LIGHTING);
}

TEST_F(PictureTest, OfAHighlightInsideATriangleNeedsNormalsPerPixel) {
  const auto brightest = [&](const char* method) {
    int most = 0;
    for (const std::uint32_t pixel : picture(method, lit_square)) most = std::max(most, channel(pixel, 0));
    return most;
  };
  EXPECT_LT(brightest(""), 90);
  EXPECT_GT(brightest("shading=phong"), 240);
  EXPECT_GT(brightest("shading=phong,power=libm"), 240);
}

TEST_F(PictureTest, OfOneNormalAndADistantLightIsTheSameWithPhongsShading) {
  const auto draw = [] {
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    const float position[] = {0.3f, 0.2f, 1, 0};
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    const float red[] = {0.9f, 0.1f, 0.1f, 1}, green[] = {0.1f, 0.9f, 0.1f, 1};
    for (const float* color : {red, green}) {  // a material for each, in one batch
      glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, color);
      glNormal3f(0, 0.6f, 0.8f);
      glRectf(color == red ? -0.9f : 0.1f, -0.9f, color == red ? -0.1f : 0.9f, 0.9f);
    }
    glDisable(GL_LIGHTING);
  };
  const auto expected = picture("", draw);
  EXPECT_LE(largest_difference(picture("shading=phong", draw), expected), 1);
  EXPECT_LE(largest_difference(picture("power=libm", draw), expected), 1);
}

TEST_F(PictureTest, OfAMirroredLightHasASmallerHighlight) {
  const auto bright = [&](const char* method) {
    const auto found = picture(method, lit_square);
    return std::count_if(found.begin(), found.end(), [](std::uint32_t p) { return (p & 0xFF) > 150; });
  };
  const auto half_vector = bright("shading=phong"), reflection = bright("shading=phong,highlight=reflection");
  EXPECT_GT(reflection, 0);
  EXPECT_LT(2 * reflection, half_vector);
}

TEST_F(PictureTest, OfTexturedLitTrianglesIsNearWithPhongsShading) {
  const auto draw = [] {
    const std::uint32_t texels[4] = {0xFFFFFFFFu, 0xFF8080FFu, 0xFFFF8080u, 0xFF80FF80u};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glColor3f(1, 0.5f, 0.25f);
    glNormal3f(0, 0, 1);
    glBegin(GL_QUADS);
    for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
      glTexCoord2f(x, y);
      glVertex2f(0.8f * x, 0.8f * y);
    }
    glEnd();
    for (const GLenum feature : {GL_TEXTURE_2D, GL_LIGHTING, GL_COLOR_MATERIAL}) glDisable(feature);
  };
  EXPECT_LE(largest_difference(picture("shading=phong", draw), picture("", draw)), 1);
}

/// A white triangle with steep edges, by itself.
void steep_triangle() {
  glDisable(GL_DEPTH_TEST);
  triangle({1, 1, 1}, {{{-0.8f, -0.9f, 0}, {0.63f, -0.87f, 0}, {0.21f, 0.93f, 0}}});
  glEnable(GL_DEPTH_TEST);
}

TEST_F(PictureTest, OfAnEdgeHasAsManyShadesAsSamples) {
  const auto exact = picture("antialiasing=area", steep_triangle);
  const auto error = [&](const char* method) {
    const auto found = picture(method, steep_triangle);
    double sum = 0;
    for (std::size_t i = 0; i < found.size(); ++i) sum += std::abs(channel(found[i], 0) - channel(exact[i], 0));
    return sum;
  };
  const double one = error(""), two = error("antialiasing=supersample2"), four = error("antialiasing=supersample4");
  const double eight = error("antialiasing=supersample8"), rotated = error("antialiasing=multisample4");
  EXPECT_LT(two, 0.8 * one);
  EXPECT_LT(rotated, 0.8 * one);
  EXPECT_LT(four, 0.7 * two);
  EXPECT_LT(eight, 0.7 * four);
}

TEST_F(PictureTest, OfManySamplesKeepsWhatWasThereAndDepths) {
  const auto base = picture("", layers);
  EXPECT_EQ(gouraudMethods("antialiasing=supersample2"), GL_TRUE);
  glFinish();
  EXPECT_EQ(pixels, base);
  triangle({1, 1, 1}, {{{-1, -1, 0.95f}, {1, -1, 0.95f}, {-1, 1, 0.95f}}});  // behind all, where there is something
  glFinish();
  EXPECT_EQ(channel(pixels[size / 2 * size + size / 2], 0), channel(base[size / 2 * size + size / 2], 0));
  float depth = 0;
  glReadPixels(size / 2, size / 2, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
  EXPECT_LT(depth, 0.5f);
  glRasterPos2f(-1, -1);
  const std::uint32_t blue = 0xFFFF0000u;
  glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &blue);
  glAccum(GL_LOAD, 0.5f);
  glAccum(GL_RETURN, 2.0f);
  glFinish();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace gouraud::api
