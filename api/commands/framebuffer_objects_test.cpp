// Renderbuffers and framebuffer objects: names, attachments, completeness, errors, and pictures drawn into them
// [ARB_framebuffer_object].
#include <cstdint>
#include <vector>

#include <GL/gl.h>
#include <gtest/gtest.h>

#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

GLint integer(GLenum pname) {
  GLint value = -1;
  glGetIntegerv(pname, &value);
  return value;
}
GLenum status() { return glCheckFramebufferStatus(GL_FRAMEBUFFER); }

GLuint renderbuffer(GLenum format, GLsizei width, GLsizei height, GLsizei samples = 0) {
  GLuint name = 0;
  glGenRenderbuffers(1, &name);
  glBindRenderbuffer(GL_RENDERBUFFER, name);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  return name;
}
void attach(GLenum point, GLuint name) { glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name); }

GLuint framebuffer() {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  return name;
}

GLint attachment(GLenum point, GLenum pname) {
  GLint value = -1;
  glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, point, pname, &value);
  return value;
}

std::uint32_t pixel(int x, int y) {
  std::uint32_t rgba = 0;
  glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &rgba);
  return rgba;
}

void clear_to(float r, float g, float b, float a) {
  glClearColor(r, g, b, a);
  glClear(GL_COLOR_BUFFER_BIT);
}

void rectangle(float x0, float y0, float x1, float y1, float z = 0) {
  glBegin(GL_QUADS);
  glVertex3f(x0, y0, z);
  glVertex3f(x1, y0, z);
  glVertex3f(x1, y1, z);
  glVertex3f(x0, y1, z);
  glEnd();
}

constexpr std::uint32_t red = 0xFF0000FF, green = 0xFF00FF00, white = 0xFFFFFFFF;

TEST(FramebufferObjects, NamesBecomeObjectsWhenTheyAreBound) {
  const Screen screen;
  GLuint name = 0, other = 0;
  glGenFramebuffers(1, &name);
  glGenRenderbuffers(1, &other);
  EXPECT_FALSE(glIsFramebuffer(name));
  EXPECT_FALSE(glIsRenderbuffer(other));
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  glBindRenderbuffer(GL_RENDERBUFFER, other);
  EXPECT_TRUE(glIsFramebuffer(name));
  EXPECT_TRUE(glIsRenderbuffer(other));
  EXPECT_EQ(integer(GL_FRAMEBUFFER_BINDING), static_cast<GLint>(name));
  EXPECT_EQ(integer(GL_READ_FRAMEBUFFER_BINDING), static_cast<GLint>(name));
  EXPECT_EQ(integer(GL_RENDERBUFFER_BINDING), static_cast<GLint>(other));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  EXPECT_EQ(integer(GL_DRAW_FRAMEBUFFER_BINDING), static_cast<GLint>(name));
  EXPECT_EQ(integer(GL_READ_FRAMEBUFFER_BINDING), 0);
  glDeleteFramebuffers(1, &name);
  glDeleteRenderbuffers(1, &other);
  EXPECT_EQ(integer(GL_FRAMEBUFFER_BINDING), 0);
  EXPECT_EQ(integer(GL_RENDERBUFFER_BINDING), 0);
  EXPECT_FALSE(glIsFramebuffer(name));
  EXPECT_FALSE(glIsRenderbuffer(other));
  EXPECT_EQ(glGetError(), GL_NO_ERROR);
}

TEST(FramebufferObjects, TheExtFormsTakeAnyName) {
  const Screen screen;
  glBindFramebuffer(GL_FRAMEBUFFER, 77);
  EXPECT_EQ(glGetError(), GL_INVALID_OPERATION);
  glBindRenderbuffer(GL_RENDERBUFFER, 77);
  EXPECT_EQ(glGetError(), GL_INVALID_OPERATION);
  glBindFramebufferEXT(GL_FRAMEBUFFER_EXT, 77);
  glBindRenderbufferEXT(GL_RENDERBUFFER_EXT, 78);
  EXPECT_EQ(glGetError(), GL_NO_ERROR);
  EXPECT_EQ(integer(GL_FRAMEBUFFER_BINDING), 77);
  EXPECT_EQ(integer(GL_RENDERBUFFER_BINDING), 78);
}

struct BadCall {
  const char* what;
  GLenum error;
  void (*call)();
};

const BadCall bad_calls[] = {
    {"bind target", GL_INVALID_ENUM, [] { glBindFramebuffer(GL_RENDERBUFFER, 0); }},
    {"status target", GL_INVALID_ENUM, [] { EXPECT_EQ(glCheckFramebufferStatus(GL_RENDERBUFFER), 0u); }},
    {"renderbuffer target", GL_INVALID_ENUM, [] { glBindRenderbuffer(GL_FRAMEBUFFER, 0); }},
    {"gen", GL_INVALID_VALUE, [] { glGenFramebuffers(-1, nullptr); }},
    {"delete", GL_INVALID_VALUE, [] { glDeleteFramebuffers(-1, nullptr); }},
    {"gen renderbuffers", GL_INVALID_VALUE, [] { glGenRenderbuffers(-1, nullptr); }},
    {"delete renderbuffers", GL_INVALID_VALUE, [] { glDeleteRenderbuffers(-1, nullptr); }},
    {"storage target", GL_INVALID_ENUM, [] { glRenderbufferStorage(GL_FRAMEBUFFER, GL_RGBA8, 1, 1); }},
    {"storage format", GL_INVALID_ENUM, [] { glRenderbufferStorage(GL_RENDERBUFFER, GL_COMPRESSED_RGB, 1, 1); }},
    {"storage width", GL_INVALID_VALUE, [] { glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, -1, 1); }},
    {"storage height", GL_INVALID_VALUE, [] { glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 1, 16385); }},
    {"samples", GL_INVALID_VALUE, [] { glRenderbufferStorageMultisample(GL_RENDERBUFFER, -1, GL_RGBA8, 1, 1); }},
    {"many samples", GL_INVALID_VALUE, [] { glRenderbufferStorageMultisample(GL_RENDERBUFFER, 5, GL_RGBA8, 1, 1); }},
    {"attach target", GL_INVALID_ENUM,
     [] { glFramebufferRenderbuffer(GL_RENDERBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 0); }},
    {"attachment", GL_INVALID_ENUM, [] { attach(GL_FRONT, 0); }},
    {"ninth attachment", GL_INVALID_OPERATION, [] { attach(GL_COLOR_ATTACHMENT0 + 8, 0); }},
    {"renderbuffertarget", GL_INVALID_ENUM,
     [] { glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0); }},
    {"no such renderbuffer", GL_INVALID_OPERATION, [] { attach(GL_COLOR_ATTACHMENT0, 99); }},
    {"query attachment", GL_INVALID_ENUM, [] { attachment(GL_FRONT_LEFT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE); }},
    {"query pname", GL_INVALID_ENUM, [] { attachment(GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER_WIDTH); }},
    {"query of nothing", GL_INVALID_OPERATION,
     [] { attachment(GL_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE); }},
    {"query level", GL_INVALID_ENUM, [] { attachment(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL); }},
    {"query different", GL_INVALID_OPERATION,
     [] { attachment(GL_DEPTH_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE); }},
    {"renderbuffer query", GL_INVALID_ENUM,
     [] {
       GLint value;
       glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RGBA, &value);
     }},
    {"draw window buffer", GL_INVALID_OPERATION, [] { glDrawBuffer(GL_FRONT); }},
    {"draw ninth", GL_INVALID_OPERATION, [] { glDrawBuffer(GL_COLOR_ATTACHMENT8); }},
    {"read both", GL_INVALID_ENUM, [] { glReadBuffer(GL_FRONT_AND_BACK); }},
    {"draw unknown", GL_INVALID_ENUM, [] { glDrawBuffer(GL_RGBA); }},
};

TEST(FramebufferObjects, ErrorsChangeNothing) {
  const Screen screen;
  const GLuint bound = framebuffer();
  const GLuint color = renderbuffer(GL_RGBA8, 8, 8);
  attach(GL_COLOR_ATTACHMENT0, color);
  attach(GL_DEPTH_ATTACHMENT, renderbuffer(GL_DEPTH_COMPONENT16, 8, 8));
  for (const BadCall& bad : bad_calls) {
    bad.call();
    EXPECT_EQ(glGetError(), bad.error) << bad.what;
    EXPECT_EQ(status(), GL_FRAMEBUFFER_COMPLETE) << bad.what;
    EXPECT_EQ(attachment(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME), static_cast<GLint>(color));
    EXPECT_EQ(integer(GL_FRAMEBUFFER_BINDING), static_cast<GLint>(bound));
  }
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 1, 1);
  EXPECT_EQ(glGetError(), GL_INVALID_OPERATION);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  attach(GL_COLOR_ATTACHMENT0, color);
  EXPECT_EQ(glGetError(), GL_INVALID_OPERATION);
}

TEST(FramebufferObjects, CompletenessFollowsTheRules) {
  const Screen screen;
  EXPECT_EQ(status(), GL_FRAMEBUFFER_COMPLETE);
  framebuffer();
  EXPECT_EQ(status(), GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT);
  GLuint empty = 0;
  glGenRenderbuffers(1, &empty);
  glBindRenderbuffer(GL_RENDERBUFFER, empty);
  attach(GL_COLOR_ATTACHMENT0, empty);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, 8, 8);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 8, 8);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_COMPLETE);
  glDrawBuffer(GL_COLOR_ATTACHMENT1);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_COMPLETE) << "as in Mesa";
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_EQ(glGetError(), GL_NO_ERROR);
  glDrawBuffer(GL_COLOR_ATTACHMENT0);
  glReadBuffer(GL_COLOR_ATTACHMENT1);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_COMPLETE);
  GLuint pixel = 0;
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
  EXPECT_EQ(glGetError(), GL_INVALID_OPERATION);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  attach(GL_COLOR_ATTACHMENT1, renderbuffer(GL_RGBA8, 8, 8, 4));
  EXPECT_EQ(status(), GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE);
  attach(GL_COLOR_ATTACHMENT1, 0);
  const GLuint packed = renderbuffer(GL_DEPTH24_STENCIL8, 4, 16);
  attach(GL_DEPTH_STENCIL_ATTACHMENT, packed);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_COMPLETE);
  attach(GL_STENCIL_ATTACHMENT, renderbuffer(GL_STENCIL_INDEX8, 4, 16));
  EXPECT_EQ(status(), GL_FRAMEBUFFER_UNSUPPORTED);
  attach(GL_DEPTH_ATTACHMENT, 0);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_COMPLETE);
  attach(GL_STENCIL_ATTACHMENT, renderbuffer(GL_DEPTH_COMPONENT16, 4, 16));
  EXPECT_EQ(status(), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
  EXPECT_EQ(glGetError(), GL_NO_ERROR);
}

TEST(FramebufferObjects, AnIncompleteFramebufferIsNeitherDrawnNorRead) {
  Screen screen;
  clear_to(0, 1, 0, 1);
  framebuffer();
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_EQ(glGetError(), GL_INVALID_FRAMEBUFFER_OPERATION);
  glBegin(GL_TRIANGLES);
  EXPECT_EQ(glGetError(), GL_INVALID_FRAMEBUFFER_OPERATION);
  EXPECT_FALSE(screen.context.inside_begin_end());
  const float position[2] = {};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, position);
  glDrawArrays(GL_POINTS, 0, 1);
  EXPECT_EQ(glGetError(), GL_INVALID_FRAMEBUFFER_OPERATION);
  EXPECT_EQ(pixel(0, 0), 0u);
  EXPECT_EQ(glGetError(), GL_INVALID_FRAMEBUFFER_OPERATION);
  const float points[6] = {-1, 0, 0, 1, 0, 0};
  glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, points);
  glEnable(GL_MAP1_VERTEX_3);
  struct {
    const char* command;
    void (*call)();
  } const commands[] = {
      {"Rect", [] { glRectf(-1, -1, 1, 1); }},
      {"Bitmap", [] { glBitmap(8, 1, 0, 0, 0, 0, reinterpret_cast<const GLubyte*>("x")); }},
      {"DrawPixels", [] { glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, "1234"); }},
      {"CopyPixels", [] { glCopyPixels(0, 0, 1, 1, GL_COLOR); }},
      {"Accum", [] { glAccum(GL_LOAD, 1); }},
      {"EvalMesh1", [] { glEvalMesh1(GL_LINE, 0, 1); }},
      {"CopyTexImage2D", [] { glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 0); }},
      {"BlitFramebuffer", [] { glBlitFramebuffer(0, 0, 1, 1, 0, 0, 1, 1, GL_COLOR_BUFFER_BIT, GL_NEAREST); }},
  };
  for (const auto& command : commands) {
    command.call();
    EXPECT_EQ(glGetError(), GL_INVALID_FRAMEBUFFER_OPERATION) << command.command;
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  EXPECT_EQ(pixel(0, 0), green);
}

TEST(FramebufferObjects, PopAttribSelectsTheBuffersThatWereSaved) {
  const Screen screen;
  const auto selected = [](GLenum pname) {
    GLint value = -1;
    glGetIntegerv(pname, &value);
    return value;
  };
  for (const GLbitfield mask : {GL_COLOR_BUFFER_BIT, GL_PIXEL_MODE_BIT}) {
    glDrawBuffer(GL_FRONT);
    glReadBuffer(GL_FRONT);
    glPushAttrib(mask);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    glPopAttrib();
    EXPECT_EQ(selected(GL_DRAW_BUFFER), mask == GL_COLOR_BUFFER_BIT ? GL_FRONT : GL_NONE);
    EXPECT_EQ(selected(GL_READ_BUFFER), mask == GL_PIXEL_MODE_BIT ? GL_FRONT : GL_NONE);
  }
  EXPECT_EQ(glGetError(), GL_NO_ERROR);
}

TEST(FramebufferObjects, PicturesAreTheirOwn) {
  const Screen screen;
  clear_to(0, 1, 0, 1);
  framebuffer();
  attach(GL_COLOR_ATTACHMENT0, renderbuffer(GL_RGBA8, 200, 100));
  glViewport(0, 0, 200, 100);
  glColor3f(1, 0, 0);
  rectangle(0, 0, 1, 1);
  EXPECT_EQ(pixel(99, 50), 0u);
  EXPECT_EQ(pixel(100, 49), 0u);
  EXPECT_EQ(pixel(100, 50), red);
  EXPECT_EQ(pixel(199, 99), red);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  EXPECT_EQ(pixel(31, 31), green);
  EXPECT_EQ(glGetError(), GL_NO_ERROR);
}

TEST(FramebufferObjects, TheSizeIsWhatAllAttachmentsHave) {
  const Screen screen;
  framebuffer();
  attach(GL_COLOR_ATTACHMENT0, renderbuffer(GL_RGBA8, 150, 20));
  attach(GL_DEPTH_ATTACHMENT, renderbuffer(GL_DEPTH_COMPONENT24, 70, 90));
  EXPECT_EQ(status(), GL_FRAMEBUFFER_COMPLETE);
  clear_to(1, 1, 1, 1);
  attach(GL_DEPTH_ATTACHMENT, 0);
  EXPECT_EQ(pixel(69, 19), white);
  EXPECT_EQ(pixel(70, 19), 0u);
}

TEST(FramebufferObjects, OneRenderbufferServesSeveralFramebuffersAndContexts) {
  Screen first;
  const GLuint shared = renderbuffer(GL_RGBA8, 8, 8);
  framebuffer();
  attach(GL_COLOR_ATTACHMENT0, shared);
  clear_to(1, 0, 0, 1);
  framebuffer();
  attach(GL_COLOR_ATTACHMENT0, shared);
  EXPECT_EQ(pixel(3, 3), red);
  {
    const Screen second(&first.context);
    EXPECT_TRUE(glIsRenderbuffer(shared));
    EXPECT_FALSE(glIsFramebuffer(1));
    framebuffer();
    attach(GL_COLOR_ATTACHMENT0, shared);
    EXPECT_EQ(pixel(3, 3), red);
    clear_to(0, 1, 0, 1);
    glFinish();
  }
  make_current(&first.context);
  EXPECT_EQ(pixel(3, 3), green);
}

TEST(FramebufferObjects, DepthAloneIsComplete) {
  const Screen screen;
  framebuffer();
  attach(GL_DEPTH_ATTACHMENT, renderbuffer(GL_DEPTH_COMPONENT32F, 8, 8));
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_COMPLETE);
  EXPECT_EQ(integer(GL_DEPTH_BITS), 32);
  EXPECT_EQ(integer(GL_RED_BITS), 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glViewport(0, 0, 8, 8);
  rectangle(-1, -1, 0, 1, 0.5f);
  float depth[2] = {};
  glReadPixels(3, 4, 2, 1, GL_DEPTH_COMPONENT, GL_FLOAT, depth);
  EXPECT_EQ(depth[0], 0.75f);
  EXPECT_EQ(depth[1], 1.0f);
  EXPECT_EQ(glGetError(), GL_NO_ERROR);
  pixel(0, 0);
  EXPECT_EQ(glGetError(), GL_INVALID_OPERATION);
}

TEST(FramebufferObjects, DrawAndReadBuffersAreTheFramebuffers) {
  const Screen screen;
  EXPECT_EQ(integer(GL_DRAW_BUFFER), GL_FRONT);
  glDrawBuffer(GL_NONE);
  clear_to(1, 1, 1, 1);
  EXPECT_EQ(pixel(0, 0), 0u);
  framebuffer();
  EXPECT_EQ(integer(GL_DRAW_BUFFER), GL_COLOR_ATTACHMENT0);
  attach(GL_COLOR_ATTACHMENT0, renderbuffer(GL_RGBA8, 8, 8));
  attach(GL_COLOR_ATTACHMENT3, renderbuffer(GL_RGBA8, 8, 8));
  glDrawBuffer(GL_COLOR_ATTACHMENT3);
  clear_to(0, 1, 0, 1);
  EXPECT_EQ(pixel(0, 0), 0u);
  glReadBuffer(GL_COLOR_ATTACHMENT3);
  EXPECT_EQ(pixel(0, 0), green);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  EXPECT_EQ(integer(GL_DRAW_BUFFER), GL_NONE);
  EXPECT_EQ(integer(GL_READ_BUFFER), GL_FRONT);
  EXPECT_EQ(glGetError(), GL_NO_ERROR);
}

TEST(FramebufferObjects, PopAttribRestoresTheDrawBufferOfTheFramebufferThatIsBound) {
  const Screen screen;
  framebuffer();
  attach(GL_COLOR_ATTACHMENT0, renderbuffer(GL_RGBA8, 8, 8));
  glPushAttrib(GL_COLOR_BUFFER_BIT);
  glDrawBuffer(GL_NONE);
  glPopAttrib();
  EXPECT_EQ(integer(GL_DRAW_BUFFER), GL_COLOR_ATTACHMENT0);
  glPushAttrib(GL_COLOR_BUFFER_BIT);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  EXPECT_EQ(glGetError(), GL_NO_ERROR);
  glPopAttrib();
  EXPECT_EQ(glGetError(), GL_INVALID_OPERATION);
  EXPECT_EQ(integer(GL_DRAW_BUFFER), GL_FRONT);
}

TEST(FramebufferObjects, DeletedRenderbuffersLeaveTheBoundFramebufferAlone) {
  const Screen screen;
  const GLuint color = renderbuffer(GL_RGBA8, 8, 8);
  const GLuint other = framebuffer();
  attach(GL_COLOR_ATTACHMENT0, color);
  clear_to(1, 0, 0, 1);
  framebuffer();
  attach(GL_COLOR_ATTACHMENT0, color);
  glDeleteRenderbuffers(1, &color);
  EXPECT_EQ(attachment(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE), GL_NONE);
  glBindFramebuffer(GL_FRAMEBUFFER, other);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_COMPLETE);
  EXPECT_EQ(pixel(1, 1), red);
}

TEST(FramebufferObjects, NewStorageIsSeenByTheBoundFramebuffer) {
  const Screen screen;
  framebuffer();
  const GLuint color = renderbuffer(GL_RGBA8, 8, 8);
  attach(GL_COLOR_ATTACHMENT0, color);
  clear_to(1, 0, 0, 1);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 100, 100);
  EXPECT_EQ(pixel(99, 99), 0u);
  clear_to(1, 0, 0, 1);
  EXPECT_EQ(pixel(99, 99), red);
}

TEST(FramebufferObjects, ChannelsThatAFormatLacksAreNotWritten) {
  const Screen screen;
  struct {
    GLenum format;
    std::uint32_t expected;
  } const cases[] = {{GL_RGB8, 0xFFBF8040}, {GL_RGBA8, 0x20BF8040}, {GL_ALPHA8, 0x20000000}, {GL_LUMINANCE8, 0xFF000040}};
  framebuffer();
  for (const auto& test : cases) {
    attach(GL_COLOR_ATTACHMENT0, renderbuffer(test.format, 8, 8));
    clear_to(0.25f, 0.5f, 0.75f, 0.125f);
    EXPECT_EQ(pixel(7, 7), test.expected) << test.format;
  }
}

TEST(FramebufferObjects, QueriesTellWhatIsStored) {
  const Screen screen;
  framebuffer();
  const GLuint color = renderbuffer(GL_RGBA16, 30, 40);
  attach(GL_COLOR_ATTACHMENT2, color);
  EXPECT_EQ(attachment(GL_COLOR_ATTACHMENT2, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE), GL_RENDERBUFFER);
  EXPECT_EQ(attachment(GL_COLOR_ATTACHMENT2, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE), 16);
  EXPECT_EQ(attachment(GL_COLOR_ATTACHMENT2, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE), GL_UNSIGNED_NORMALIZED);
  EXPECT_EQ(attachment(GL_COLOR_ATTACHMENT1, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME), 0);
  const GLuint packed = renderbuffer(GL_DEPTH32F_STENCIL8, 30, 40);
  attach(GL_DEPTH_STENCIL_ATTACHMENT, packed);
  EXPECT_EQ(attachment(GL_DEPTH_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME), static_cast<GLint>(packed));
  EXPECT_EQ(attachment(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE), 32);
  EXPECT_EQ(attachment(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE), GL_FLOAT);
  EXPECT_EQ(attachment(GL_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE), 8);
  GLint value = 0;
  glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_INTERNAL_FORMAT, &value);
  EXPECT_EQ(value, GL_DEPTH32F_STENCIL8);
  glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &value);
  EXPECT_EQ(value, 40);
  renderbuffer(GL_RGBA8, 1, 1, 1);
  glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &value);
  EXPECT_EQ(value, 4);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  EXPECT_EQ(attachment(GL_FRONT_LEFT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE), GL_FRAMEBUFFER_DEFAULT);
  EXPECT_EQ(attachment(GL_DEPTH, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE), 24);
  EXPECT_EQ(attachment(GL_STENCIL, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE), 8);
  EXPECT_EQ(glGetError(), GL_NO_ERROR);
}

TEST(FramebufferObjects, OfAnotherFormatAreDrawnIntoByPassesOfThatFormat) {
  Screen screen;
  const GLuint wide = framebuffer();
  attach(GL_COLOR_ATTACHMENT0, renderbuffer(GL_RGBA16, side_px, side_px));
  ASSERT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
  glColor4f(1, 0, 0, 1);
  for (int i = 0; i < 3; ++i) {
    for (const GLuint name : {GLuint{0}, wide}) {  // equal states, targets of equal size
      glBindFramebuffer(GL_FRAMEBUFFER, name);
      clear_to(0, 0, 0, 0);
      glRectf(-1, -1, 1, 1);
      for (const int at : {0, side_px / 2, side_px - 1}) EXPECT_EQ(pixel(at, at), 0xFF0000FFu);
    }
  }
}

}  // namespace
}  // namespace gouraud::api
