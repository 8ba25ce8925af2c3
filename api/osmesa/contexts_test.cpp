// Contexts: what can be created and made current, and what is current where (OSMESA-ABI.md).
#include <array>
#include <cstdint>
#include <thread>
#include <vector>

#include "api/osmesa/testing/drivers.h"

namespace gouraud::api::testing {
namespace {

class Creation : public BothDrivers {
 protected:
  GLint integer(GLenum pname) const {
    GLint value = -1;
    gl.GetIntegerv(pname, &value);
    return value;
  }
  bool make_current(const OwnedContext& context) {
    return driver.MakeCurrent(context.get(), pixels.data(), GL_UNSIGNED_BYTE, 4, 4) == GL_TRUE;
  }
  OwnedContext from_attributes(std::vector<int> list) const {
    list.push_back(0);
    return {driver.CreateContextAttribs(list.data(), nullptr), {&driver}};
  }
  std::vector<std::uint32_t> pixels = std::vector<std::uint32_t>(16);
};

TEST_P(Creation, ByDefaultGives24DepthAnd8StencilBitsAndNoAccumulation) {
  const OwnedContext context(driver.CreateContext(OSMESA_RGBA, nullptr), {&driver});
  ASSERT_TRUE(make_current(context));
  EXPECT_EQ(integer(GL_DEPTH_BITS), 24);
  EXPECT_EQ(integer(GL_STENCIL_BITS), 8);
  EXPECT_EQ(integer(GL_ACCUM_RED_BITS), 0);
}

TEST_P(Creation, GivesTheDepthAndStencilAskedFor) {
  struct Row {
    int depth_asked, stencil_asked, depth, stencil;
  };
  for (const Row& row : {Row{0, 0, 0, 0}, Row{16, 0, 16, 0}, Row{24, 0, 24, 0}, Row{16, 8, 24, 8}, Row{24, 8, 24, 8},
                         Row{24, 1, 24, 8}, Row{0, 8, 0, 8}}) {
    const OwnedContext context = make_context(driver, OSMESA_RGBA, row.depth_asked, row.stencil_asked);
    ASSERT_TRUE(make_current(context));
    EXPECT_EQ(integer(GL_DEPTH_BITS), row.depth) << row.depth_asked << ' ' << row.stencil_asked;
    EXPECT_EQ(integer(GL_STENCIL_BITS), row.stencil) << row.depth_asked << ' ' << row.stencil_asked;
  }
}

TEST_P(Creation, OfMoreThan24DepthBitsGivesAtLeast24) {
  const OwnedContext context = make_context(driver, OSMESA_RGBA, 32, 0);
  ASSERT_TRUE(make_current(context));
  EXPECT_GE(integer(GL_DEPTH_BITS), 24);
}

TEST_P(Creation, FailsForNegativeBitsAndUnknownFormats) {
  for (const std::array<int, 3> bits : {std::array{-1, 0, 0}, std::array{0, -1, 0}, std::array{0, 0, -1}}) {
    EXPECT_EQ(driver.CreateContextExt(OSMESA_RGBA, bits[0], bits[1], bits[2], nullptr), nullptr);
  }
  for (const GLenum format : {GLenum{0}, GLenum{3}, GLenum{6}, GLenum{GL_LUMINANCE}, GLenum{GL_BGRA}}) {
    EXPECT_EQ(driver.CreateContext(format, nullptr), nullptr) << format;
  }
}

TEST_P(Creation, FromAnEmptyListGivesRgbaWithoutDepthAndStencil) {
  const OwnedContext context = from_attributes({});
  ASSERT_TRUE(make_current(context));
  GLint format = 0;
  driver.GetIntegerv(OSMESA_FORMAT, &format);
  EXPECT_EQ(format, OSMESA_RGBA);
  EXPECT_EQ(integer(GL_DEPTH_BITS), 0);
  EXPECT_EQ(integer(GL_STENCIL_BITS), 0);
}

TEST_P(Creation, FromAListGivesWhatItSays) {
  const OwnedContext context =
      from_attributes({OSMESA_FORMAT, OSMESA_BGRA, OSMESA_DEPTH_BITS, 16, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE});
  ASSERT_TRUE(make_current(context));
  GLint format = 0;
  driver.GetIntegerv(OSMESA_FORMAT, &format);
  EXPECT_EQ(format, OSMESA_BGRA);
  EXPECT_EQ(integer(GL_DEPTH_BITS), 16);
}

TEST_P(Creation, FromAListFailsForWhatItDoesNotKnow) {
  EXPECT_EQ(from_attributes({0x99, 1}), nullptr);
  EXPECT_EQ(from_attributes({OSMESA_DEPTH_BITS, -1}), nullptr);
  EXPECT_EQ(from_attributes({OSMESA_FORMAT, GL_LUMINANCE}), nullptr);
  EXPECT_EQ(from_attributes({OSMESA_PROFILE, 0x99}), nullptr);
}

TEST_P(Creation, AcceptsEveryVersionUpTo15InTheCompatibilityProfile) {
  for (int minor = 0; minor <= 5; ++minor) {
    EXPECT_NE(from_attributes({OSMESA_CONTEXT_MAJOR_VERSION, 1, OSMESA_CONTEXT_MINOR_VERSION, minor}), nullptr)
        << minor;
  }
  EXPECT_EQ(from_attributes({OSMESA_CONTEXT_MAJOR_VERSION, 0, OSMESA_CONTEXT_MINOR_VERSION, 5}), nullptr);
  EXPECT_EQ(from_attributes({OSMESA_CONTEXT_MAJOR_VERSION, -1}), nullptr);
  EXPECT_EQ(from_attributes({OSMESA_CONTEXT_MAJOR_VERSION, 9, OSMESA_CONTEXT_MINOR_VERSION, 9}), nullptr);
}

TEST_P(Creation, GivesOneBufferThatIsTheFront) {
  const OwnedContext context = make_context(driver);
  ASSERT_TRUE(make_current(context));
  EXPECT_EQ(integer(GL_DRAW_BUFFER), GL_FRONT);
  EXPECT_EQ(integer(GL_READ_BUFFER), GL_FRONT);
  EXPECT_EQ(integer(GL_DOUBLEBUFFER), GL_FALSE);
}

TEST_P(Creation, GivesAtLeastTheLimitsThatProgramsAreUsedTo) {
  const OwnedContext context = make_context(driver);
  ASSERT_TRUE(make_current(context));
  EXPECT_GE(integer(GL_MAX_LIGHTS), 8);
  EXPECT_GE(integer(GL_MAX_CLIP_PLANES), 8);
  EXPECT_GE(integer(GL_MAX_MODELVIEW_STACK_DEPTH), 32);
  EXPECT_GE(integer(GL_MAX_PROJECTION_STACK_DEPTH), 32);
  EXPECT_GE(integer(GL_MAX_TEXTURE_STACK_DEPTH), 10);
  EXPECT_GE(integer(GL_MAX_ATTRIB_STACK_DEPTH), 16);
  EXPECT_GE(integer(GL_MAX_NAME_STACK_DEPTH), 64);
  EXPECT_GE(integer(GL_MAX_LIST_NESTING), 64);
  EXPECT_GE(integer(GL_MAX_TEXTURE_SIZE), 16384);
  std::array<GLint, 2> sizes{};
  gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, sizes.data());
  EXPECT_GE(sizes[0], 16384);
  EXPECT_GE(sizes[1], 16384);
  for (const GLenum range : {GL_POINT_SIZE_RANGE, GL_LINE_WIDTH_RANGE}) {
    gl.GetIntegerv(range, sizes.data());
    EXPECT_EQ(sizes[0], 1);
    EXPECT_GE(sizes[1], 255);
  }
}

TEST_P(Creation, OfAContextThatSharesWithAnotherWorks) {
  const OwnedContext first = make_context(driver);
  const OwnedContext second(driver.CreateContextExt(OSMESA_RGBA, 24, 8, 0, first.get()), {&driver});
  EXPECT_TRUE(make_current(second));
}

GOURAUD_ON_BOTH_DRIVERS(Creation);

class MakeCurrent : public Creation {};

TEST_P(MakeCurrent, AcceptsTheTypesOfEachFormat) {
  for (const GLenum format : {GLenum{OSMESA_RGBA}, GLenum{OSMESA_BGRA}, GLenum{OSMESA_ARGB}, GLenum{OSMESA_RGB},
                              GLenum{OSMESA_RGB_565}, GLenum{OSMESA_COLOR_INDEX}}) {
    const OwnedContext context = make_context(driver, format);
    ASSERT_NE(context, nullptr);
    for (const GLenum type : {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT, GL_UNSIGNED_SHORT_5_6_5, GL_BYTE, GL_INT,
                              GL_UNSIGNED_INT, GL_UNSIGNED_INT_8_8_8_8_REV, 0}) {
      const bool is_plain = type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_FLOAT;
      const bool expected =
          format == OSMESA_RGB_565 ? type == GL_UNSIGNED_SHORT_5_6_5 : is_plain && format != OSMESA_COLOR_INDEX;
      std::vector<std::uint32_t> buffer(64);
      EXPECT_EQ(driver.MakeCurrent(context.get(), buffer.data(), type, 4, 4), expected) << format << ' ' << type;
    }
    driver.MakeCurrent(nullptr, nullptr, 0, 0, 0);
  }
}

TEST_P(MakeCurrent, FailsAndChangesNothingWithoutBufferOrSize) {
  const OwnedContext context = make_context(driver), other = make_context(driver);
  ASSERT_TRUE(make_current(context));
  EXPECT_FALSE(driver.MakeCurrent(other.get(), nullptr, GL_UNSIGNED_BYTE, 4, 4));
  EXPECT_FALSE(driver.MakeCurrent(nullptr, pixels.data(), GL_UNSIGNED_BYTE, 4, 4));
  EXPECT_FALSE(driver.MakeCurrent(other.get(), pixels.data(), GL_UNSIGNED_BYTE, 0, 4));
  EXPECT_FALSE(driver.MakeCurrent(other.get(), pixels.data(), GL_UNSIGNED_BYTE, 4, -1));
  EXPECT_FALSE(driver.MakeCurrent(other.get(), pixels.data(), GL_INT, 4, 4));
  EXPECT_EQ(driver.GetCurrentContext(), context.get());
  GLint width = 0;
  driver.GetIntegerv(OSMESA_WIDTH, &width);
  EXPECT_EQ(width, 4);
}

TEST_P(MakeCurrent, WithoutContextAndBufferUnbinds) {
  const OwnedContext context = make_context(driver);
  ASSERT_TRUE(make_current(context));
  EXPECT_TRUE(driver.MakeCurrent(nullptr, nullptr, 0, 0, 0));
  EXPECT_EQ(driver.GetCurrentContext(), nullptr);
  ASSERT_TRUE(make_current(context));
  EXPECT_TRUE(driver.MakeCurrent(nullptr, nullptr, GL_FLOAT, 0, 0));
  EXPECT_EQ(driver.GetCurrentContext(), nullptr);
}

TEST_P(MakeCurrent, SetsTheViewportTheFirstTimeOnly) {
  const OwnedContext context = make_context(driver);
  std::vector<std::uint32_t> buffer(64);
  ASSERT_TRUE(driver.MakeCurrent(context.get(), buffer.data(), GL_UNSIGNED_BYTE, 8, 4));
  std::array<GLint, 4> box{};
  gl.GetIntegerv(GL_VIEWPORT, box.data());
  EXPECT_EQ(box, (std::array{0, 0, 8, 4}));
  ASSERT_TRUE(driver.MakeCurrent(context.get(), buffer.data(), GL_UNSIGNED_BYTE, 4, 2));
  gl.GetIntegerv(GL_VIEWPORT, box.data());
  EXPECT_EQ(box, (std::array{0, 0, 8, 4}));
  gl.GetIntegerv(GL_SCISSOR_BOX, box.data());
  EXPECT_EQ(box, (std::array{0, 0, 8, 4}));
}

TEST_P(MakeCurrent, IsUndoneByDestroyingTheContext) {
  OwnedContext context = make_context(driver);
  ASSERT_TRUE(make_current(context));
  context.reset();
  EXPECT_EQ(driver.GetCurrentContext(), nullptr);
  driver.DestroyContext(nullptr);
}

TEST_P(MakeCurrent, HoldsForItsThreadAlone) {
  const OwnedContext context = make_context(driver);
  ASSERT_TRUE(make_current(context));
  OSMesaContext elsewhere = context.get();
  std::thread([&] { elsewhere = driver.GetCurrentContext(); }).join();
  EXPECT_EQ(elsewhere, nullptr);
  EXPECT_EQ(driver.GetCurrentContext(), context.get());
}

TEST_P(MakeCurrent, OfTwoContextsInTwoThreadsKeepsTheirPicturesApart) {
  constexpr int side = 70, rounds = 50;
  std::vector<std::uint32_t> pictures[2];
  const auto paint = [&](int which) {
    std::vector<std::uint32_t>& picture = pictures[which];
    picture.resize(side * side);
    const OwnedContext context = make_context(driver);
    driver.MakeCurrent(context.get(), picture.data(), GL_UNSIGNED_BYTE, side, side);
    gl.Enable(GL_SCISSOR_TEST);
    for (int i = 0; i < rounds; ++i) {
      gl.Scissor(i, 0, side, side);
      gl.ClearColor(which == 0 ? 1.0f : 0.0f, static_cast<float>(i) / 255.0f, 0.0f, 1.0f);
      gl.Clear(GL_COLOR_BUFFER_BIT);
      gl.Finish();
    }
    driver.MakeCurrent(nullptr, nullptr, 0, 0, 0);
  };
  std::thread first(paint, 0), second(paint, 1);
  first.join();
  second.join();
  for (int x = 0; x < side; ++x) {
    const auto green = static_cast<std::uint32_t>(std::min(x, rounds - 1)) << 8;
    ASSERT_EQ(pictures[0][static_cast<std::size_t>(x)], 0xFF0000FFu | green);
    ASSERT_EQ(pictures[1][static_cast<std::size_t>(x)], 0xFF000000u | green);
  }
}

TEST_P(MakeCurrent, TellsTheBufferByQuery) {
  const OwnedContext context = make_context(driver, OSMESA_BGRA);
  std::vector<float> buffer(64);
  ASSERT_TRUE(driver.MakeCurrent(context.get(), buffer.data(), GL_FLOAT, 4, 2));
  const auto get = [&](GLint pname) {
    GLint value = -77;
    driver.GetIntegerv(pname, &value);
    return value;
  };
  EXPECT_EQ(get(OSMESA_WIDTH), 4);
  EXPECT_EQ(get(OSMESA_HEIGHT), 2);
  EXPECT_EQ(get(OSMESA_FORMAT), OSMESA_BGRA);
  EXPECT_EQ(get(OSMESA_TYPE), GL_FLOAT);
  EXPECT_EQ(get(OSMESA_MAX_WIDTH), 16384);
  EXPECT_EQ(get(OSMESA_MAX_HEIGHT), 16384);
  EXPECT_EQ(get(OSMESA_ROW_LENGTH), 0);
  EXPECT_EQ(get(OSMESA_Y_UP), 1);
  EXPECT_EQ(get(0x99), -77);
  driver.PixelStore(OSMESA_ROW_LENGTH, 7);
  driver.PixelStore(OSMESA_Y_UP, 0);
  driver.PixelStore(0x99, 0);
  EXPECT_EQ(get(OSMESA_ROW_LENGTH), 7);
  EXPECT_EQ(get(OSMESA_Y_UP), 0);
  GLint width = 0, height = 0, format = 0;
  void* pointer = nullptr;
  EXPECT_TRUE(driver.GetColorBuffer(context.get(), &width, &height, &format, &pointer));
  EXPECT_EQ(width, 4);
  EXPECT_EQ(height, 2);
  EXPECT_EQ(format, OSMESA_BGRA);
  EXPECT_EQ(pointer, buffer.data());
}

TEST_P(MakeCurrent, IsFoundByItsName) {
  EXPECT_EQ(driver.GetProcAddress("OSMesaMakeCurrent"), reinterpret_cast<OSMESAproc>(driver.MakeCurrent));
  EXPECT_NE(driver.GetProcAddress("glBegin"), nullptr);
  EXPECT_EQ(driver.GetProcAddress("OSMesaNoSuchFunction"), nullptr);
  EXPECT_EQ(driver.GetProcAddress("begin"), nullptr);
}

GOURAUD_ON_BOTH_DRIVERS(MakeCurrent);

// Where we differ from Mesa on purpose.

TEST(Ours, TheCoreProfileAndLaterVersionsDoNotExist) {
  const auto creates = [](std::vector<int> list) {
    list.push_back(0);
    return OwnedContext(ours().CreateContextAttribs(list.data(), nullptr), {&ours()}) != nullptr;
  };
  EXPECT_FALSE(creates({OSMESA_PROFILE, OSMESA_CORE_PROFILE}));
  EXPECT_FALSE(
      creates({OSMESA_PROFILE, OSMESA_CORE_PROFILE, OSMESA_CONTEXT_MAJOR_VERSION, 3, OSMESA_CONTEXT_MINOR_VERSION, 2}));
  EXPECT_FALSE(creates({OSMESA_CONTEXT_MAJOR_VERSION, 1, OSMESA_CONTEXT_MINOR_VERSION, 6}));
  EXPECT_FALSE(creates({OSMESA_CONTEXT_MAJOR_VERSION, 2, OSMESA_CONTEXT_MINOR_VERSION, 0}));
  EXPECT_TRUE(OwnedContext(ours().CreateContextAttribs(nullptr, nullptr), {&ours()}) != nullptr);
}

TEST(Ours, BgrContextsCanBeMadeCurrent) {
  const OwnedContext context = make_context(ours(), OSMESA_BGR);
  std::vector<float> buffer(64);
  for (const GLenum type : {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT}) {
    EXPECT_TRUE(ours().MakeCurrent(context.get(), buffer.data(), type, 4, 4)) << type;
  }
  EXPECT_FALSE(ours().MakeCurrent(context.get(), buffer.data(), GL_UNSIGNED_SHORT_5_6_5, 4, 4));
}

TEST(Ours, BuffersBeyondTheMaximumAreRefused) {
  const OwnedContext context = make_context(ours());
  std::uint32_t pixel = 0;
  EXPECT_FALSE(ours().MakeCurrent(context.get(), &pixel, GL_UNSIGNED_BYTE, 16385, 1));
  EXPECT_FALSE(ours().MakeCurrent(context.get(), &pixel, GL_UNSIGNED_BYTE, 1, 2147483647));
  EXPECT_EQ(ours().GetCurrentContext(), nullptr);
}

TEST(Ours, UnknownFunctionsAreNull) {
  EXPECT_EQ(ours().GetProcAddress("glNoSuchFunction"), nullptr);
  EXPECT_EQ(ours().GetProcAddress("glBegi"), nullptr);
  EXPECT_EQ(ours().GetProcAddress(""), nullptr);
  EXPECT_EQ(ours().GetProcAddress(nullptr), nullptr);
}

TEST(Ours, QueriesWithoutAContextAreHarmless) {
  GLint value = -77;
  ours().GetIntegerv(OSMESA_WIDTH, &value);
  EXPECT_EQ(value, 0);
  ours().GetIntegerv(OSMESA_MAX_WIDTH, &value);
  EXPECT_EQ(value, 16384);
  ours().GetIntegerv(OSMESA_WIDTH, nullptr);
  ours().PixelStore(OSMESA_Y_UP, 0);
  ours().ColorClamp(GL_TRUE);
  ours().Postprocess(nullptr, "pp_jimenezmlaa", 8);
  GLint width = -1, height = -1, third = -1;
  void* buffer = &width;
  const OwnedContext never_bound = make_context(ours());
  for (const OSMesaContext context : {OSMesaContext{nullptr}, never_bound.get()}) {
    EXPECT_FALSE(ours().GetDepthBuffer(context, &width, &height, &third, &buffer));
    EXPECT_FALSE(ours().GetColorBuffer(context, &width, &height, &third, &buffer));
    EXPECT_EQ(buffer, nullptr);
    EXPECT_EQ(width, 0);
    EXPECT_FALSE(ours().GetDepthBuffer(context, nullptr, nullptr, nullptr, nullptr));
  }
}

TEST(Ours, CommandsWithoutAContextDoNothing) {
  ours().gl.Clear(GL_COLOR_BUFFER_BIT);
  ours().gl.Begin(GL_TRIANGLES);
  ours().gl.Vertex3f(0.0f, 0.0f, 0.0f);
  ours().gl.End();
  std::uint32_t pixel = 0xEEEEEEEE;
  ours().gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
  EXPECT_EQ(pixel, 0xEEEEEEEE);
  EXPECT_EQ(ours().gl.GetError(), GLenum{GL_NO_ERROR});
  EXPECT_EQ(ours().gl.GetString(GL_VERSION), nullptr);
}

}  // namespace
}  // namespace gouraud::api::testing
