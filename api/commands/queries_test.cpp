#include "api/commands/queries.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <set>
#include <string>

#include "api/commands/current_values.h"
#include "api/commands/enables.h"
#include "api/commands/framebuffer_control.h"
#include "api/commands/matrices.h"
#include "api/commands/rasterization.h"
#include "api/commands/state_table.h"
#include "api/commands/viewport.h"

namespace gouraud::api {
namespace {

GLint integer(Context& c, GLenum pname) {
  GLint v[16] = {};
  GetIntegerv(c, pname, v);
  return v[0];
}

TEST(Conversions, RoundRealsAndStretchNormalizedValues) {
  EXPECT_EQ(to_integer(2.4, ValueKind::real), 2);
  EXPECT_EQ(to_integer(-2.6, ValueKind::real), -3);
  EXPECT_EQ(to_integer(1.0, ValueKind::normalized), 2147483647);
  EXPECT_EQ(to_integer(0.0, ValueKind::normalized), 0);
  EXPECT_EQ(to_integer(-1.0, ValueKind::normalized), std::numeric_limits<GLint>::min());
}

TEST(Conversions, GiveTheNearestIntegerOfWhatIsOutOfRange) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const ValueKind kind : {ValueKind::real, ValueKind::normalized}) {
    EXPECT_EQ(to_integer(1e38, kind), 2147483647);
    EXPECT_EQ(to_integer(-infinity, kind), std::numeric_limits<GLint>::min());
    EXPECT_EQ(to_integer(std::numeric_limits<double>::quiet_NaN(), kind), 0);
  }
}

TEST(Queries, ConvertToEveryType) {
  Context c({}, nullptr);
  Color4f(c, 0.5f, 0, 1, -1);
  GLint i[4];
  GetIntegerv(c, GL_CURRENT_COLOR, i);
  EXPECT_EQ(i[0], 1073741823);
  EXPECT_EQ(i[2], 2147483647);
  GLboolean b[4];
  GetBooleanv(c, GL_CURRENT_COLOR, b);
  EXPECT_EQ(b[0], GL_TRUE);
  EXPECT_EQ(b[1], GL_FALSE);
  DepthRange(c, 0.25, 0.75);
  GLdouble d[2];
  GetDoublev(c, GL_DEPTH_RANGE, d);
  EXPECT_EQ(d[0], 0.25);
  GLfloat f[16];
  GetFloatv(c, GL_CULL_FACE_MODE, f);
  EXPECT_EQ(f[0], static_cast<GLfloat>(GL_BACK));
  PointSize(c, 2.5f);
  EXPECT_EQ(integer(c, GL_POINT_SIZE), 3);
}

TEST(Queries, GiveMatricesInBothOrders) {
  Context c({}, nullptr);
  Translatef(c, 7, 8, 9);
  GLfloat m[16];
  GetFloatv(c, GL_MODELVIEW_MATRIX, m);
  EXPECT_EQ(m[12], 7.0f);
  GetFloatv(c, GL_TRANSPOSE_MODELVIEW_MATRIX, m);
  EXPECT_EQ(m[3], 7.0f);
  EXPECT_EQ(m[11], 9.0f);
}

TEST(Queries, AnswerCapabilitiesToo) {
  Context c({}, nullptr);
  for (const GLenum cap : {GL_LIGHTING, GL_LIGHT7, GL_SCISSOR_TEST, GL_NORMALIZE}) {
    EXPECT_EQ(integer(c, cap), 0);
    Enable(c, cap);
    EXPECT_EQ(integer(c, cap), 1);
    EXPECT_EQ(IsEnabled(c, cap), GL_TRUE);
    Disable(c, cap);
    EXPECT_EQ(IsEnabled(c, cap), GL_FALSE);
  }
  EXPECT_EQ(IsEnabled(c, GL_DITHER), GL_TRUE);
  EXPECT_EQ(IsEnabled(c, GL_MULTISAMPLE), GL_TRUE);
}

TEST(Queries, DescribeTheTarget) {
  Context c({16, 0, 0}, nullptr);
  EXPECT_EQ(integer(c, GL_RED_BITS), 0);
  ASSERT_TRUE(c.set_window_size(8, 8, pipeline::ColorFormat::rgba16));
  EXPECT_EQ(integer(c, GL_ALPHA_BITS), 16);
  EXPECT_EQ(integer(c, GL_DEPTH_BITS), 16);
  EXPECT_EQ(integer(c, GL_STENCIL_BITS), 0);
  EXPECT_EQ(integer(c, GL_DOUBLEBUFFER), 0);
  EXPECT_EQ(integer(c, GL_RGBA_MODE), 1);
}

TEST(Queries, InSixtyFourBits) {
  Context c({}, nullptr);
  std::array<GLint64, 4> box{-7, -7, -7, -7};
  GetInteger64v(c, GL_MAX_TEXTURE_SIZE, box.data());
  EXPECT_EQ(box, (std::array<GLint64, 4>{16384, -7, -7, -7}));
  GetInteger64v(c, GL_MAX_SHININESS_NV, box.data());
  EXPECT_EQ(box[0], 128);
  GetInteger64v(c, GL_TEXTURE_2D + 1, box.data());
  EXPECT_EQ(c.take_error(), static_cast<GLenum>(GL_INVALID_ENUM));
}

TEST(StateTable, HasNoNameTwice) {
  std::set<GLenum> names;
  for (const auto rows : {vertex_state_rows(), fragment_state_rows(), implementation_rows()}) {
    for (const StateRow& row : rows) {
      EXPECT_TRUE(names.insert(row.pname).second) << row.pname;
      EXPECT_LE(row.count, max_components);
      EXPECT_EQ(find_state_row(row.pname)->read, row.read);
      State state;
      EXPECT_EQ(find_capability(state, row.pname).flag, nullptr) << row.pname;
    }
  }
  EXPECT_EQ(find_state_row(0), nullptr);
}

TEST(GetString, NamesTheImplementation) {
  Context c({}, nullptr);
  const auto text = [&](GLenum name) { return std::string(reinterpret_cast<const char*>(GetString(c, name))); };
  EXPECT_EQ(text(GL_VENDOR), "Gouraud");
  EXPECT_EQ(text(GL_VERSION).substr(0, 4), "1.5 ");
  EXPECT_EQ(text(GL_RENDERER).substr(0, 18), "Gouraud software (");
  const std::string extensions = " " + text(GL_EXTENSIONS) + " ";
  EXPECT_NE(extensions.find(" GL_ARB_vertex_buffer_object "), std::string::npos);
  EXPECT_EQ(extensions.find(" GL_EXT_texture_snorm "), std::string::npos);

  GLint count = 0;
  GetIntegerv(c, GL_NUM_EXTENSIONS, &count);
  std::string joined = " ";
  for (GLint i = 0; i < count; ++i) {
    joined += std::string(reinterpret_cast<const char*>(GetStringi(c, GL_EXTENSIONS, static_cast<GLuint>(i)))) + " ";
  }
  EXPECT_EQ(joined, extensions);
  EXPECT_EQ(GetStringi(c, GL_EXTENSIONS, static_cast<GLuint>(count)), nullptr);
  EXPECT_EQ(c.take_error(), static_cast<GLenum>(GL_INVALID_VALUE));
  EXPECT_EQ(GetStringi(c, GL_VERSION, 0), nullptr);
  EXPECT_EQ(c.take_error(), static_cast<GLenum>(GL_INVALID_ENUM));
}

}  // namespace
}  // namespace gouraud::api
