#include "api/commands/pixel_store.h"

#include <cstdint>
#include <limits>

#include "api/osmesa/testing/drivers.h"

namespace gouraud::api::testing {
namespace {

class PixelStorage : public BothDrivers {
 protected:
  void SetUp() override { ASSERT_TRUE(driver.MakeCurrent(context.get(), &pixel, GL_UNSIGNED_BYTE, 1, 1)); }
  void TearDown() override {
    context.reset();
    BothDrivers::TearDown();
  }
  GLint get(GLenum pname) const {
    GLint value = -77;
    gl.GetIntegerv(pname, &value);
    return value;
  }
  OwnedContext context = make_context(driver);
  std::uint32_t pixel = 0;
};

constexpr GLenum counts[] = {GL_PACK_ROW_LENGTH,     GL_PACK_SKIP_ROWS,    GL_PACK_SKIP_PIXELS, GL_PACK_IMAGE_HEIGHT,
                             GL_PACK_SKIP_IMAGES,    GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS,
                             GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES};
constexpr GLenum switches[] = {GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST, GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST};
constexpr GLenum alignments[] = {GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT};

TEST_P(PixelStorage, HasItsInitialValues) {
  for (const GLenum pname : counts) EXPECT_EQ(get(pname), 0) << pname;
  for (const GLenum pname : switches) EXPECT_EQ(get(pname), GL_FALSE) << pname;
  for (const GLenum pname : alignments) EXPECT_EQ(get(pname), 4) << pname;
}

TEST_P(PixelStorage, KeepsEachParameterApart) {
  GLint value = 1;
  for (const GLenum pname : counts) gl.PixelStorei(pname, value++);
  value = 1;
  for (const GLenum pname : counts) EXPECT_EQ(get(pname), value++) << pname;
  for (const GLenum pname : switches) {
    gl.PixelStorei(pname, 5);
    for (const GLenum other : switches) EXPECT_EQ(get(other), other == pname) << pname;
    gl.PixelStorei(pname, 0);
  }
  for (const GLint alignment : {1, 2, 4, 8}) {
    gl.PixelStorei(GL_PACK_ALIGNMENT, alignment);
    EXPECT_EQ(get(GL_PACK_ALIGNMENT), alignment);
    EXPECT_EQ(get(GL_UNPACK_ALIGNMENT), 4);
  }
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST_P(PixelStorage, RoundsFloats) {
  gl.PixelStoref(GL_PACK_ROW_LENGTH, 7.4f);
  EXPECT_EQ(get(GL_PACK_ROW_LENGTH), 7);
  gl.PixelStoref(GL_PACK_ALIGNMENT, 8.0f);
  EXPECT_EQ(get(GL_PACK_ALIGNMENT), 8);
  gl.PixelStoref(GL_PACK_SWAP_BYTES, 1.0f);
  EXPECT_EQ(get(GL_PACK_SWAP_BYTES), GL_TRUE);
}

TEST_P(PixelStorage, RefusesWhatIsOutOfRange) {
  for (const GLenum pname : counts) {
    gl.PixelStorei(pname, 3);
    gl.PixelStorei(pname, -1);
    EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_VALUE}) << pname;
    EXPECT_EQ(get(pname), 3) << pname;
  }
  for (const GLenum pname : alignments) {
    for (const GLint alignment : {-1, 0, 3, 5, 16, std::numeric_limits<GLint>::max()}) {
      gl.PixelStorei(pname, alignment);
      EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_VALUE}) << alignment;
      EXPECT_EQ(get(pname), 4);
    }
  }
  gl.PixelStorei(GL_PACK_ALIGNMENT + 1000, 1);
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_ENUM});
  gl.PixelStorei(0, 1);
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_ENUM});
}

GOURAUD_ON_BOTH_DRIVERS(PixelStorage);

}  // namespace
}  // namespace gouraud::api::testing
