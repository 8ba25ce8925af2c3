// Every bad argument of this folder's commands gives the specification's error and changes nothing [GL1.5 §2.5].
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "api/commands/begin_end.h"
#include "api/commands/blending.h"
#include "api/commands/current_values.h"
#include "api/commands/enables.h"
#include "api/commands/flush_and_hints.h"
#include "api/commands/framebuffer_control.h"
#include "api/commands/lighting.h"
#include "api/commands/matrices.h"
#include "api/commands/queries.h"
#include "api/commands/rasterization.h"
#include "api/commands/viewport.h"

namespace gouraud::api {
namespace {

constexpr GLenum bad_enum = 0xBAD;
const float nan_value = std::numeric_limits<float>::quiet_NaN();

void light(Context& c, GLenum pname, float value) {
  Lightfv(c, GL_LIGHT0, pname, &value);
}
void shininess(Context& c, float value) {
  Materialfv(c, GL_FRONT, GL_SHININESS, &value);
}

struct BadCall {
  const char* what;
  GLenum error;
  void (*call)(Context& c);
};

GLfloat four[4] = {};
GLint four_ints[4] = {};

const BadCall bad_calls[] = {
    {"Begin mode", GL_INVALID_ENUM, [](Context& c) { Begin(c, GL_POLYGON + 1); }},
    {"End without Begin", GL_INVALID_OPERATION, [](Context& c) { End(c); }},
    {"MultiTexCoord unit", GL_INVALID_ENUM, [](Context& c) { MultiTexCoord4f(c, GL_TEXTURE0 + 8, 1, 2, 3, 4); }},
    {"MultiTexCoord below", GL_INVALID_ENUM, [](Context& c) { MultiTexCoord4f(c, GL_TEXTURE0 - 1, 1, 2, 3, 4); }},
    {"ActiveTexture", GL_INVALID_ENUM, [](Context& c) { ActiveTexture(c, GL_TEXTURE0 + 8); }},
    {"MatrixMode", GL_INVALID_ENUM, [](Context& c) { MatrixMode(c, GL_COLOR); }},
    {"PopMatrix", GL_STACK_UNDERFLOW, [](Context& c) { PopMatrix(c); }},
    {"Frustum near", GL_INVALID_VALUE, [](Context& c) { Frustum(c, -1, 1, -1, 1, 0, 1); }},
    {"Frustum far", GL_INVALID_VALUE, [](Context& c) { Frustum(c, -1, 1, -1, 1, 1, -1); }},
    {"Frustum depth", GL_INVALID_VALUE, [](Context& c) { Frustum(c, -1, 1, -1, 1, 2, 2); }},
    {"Frustum width", GL_INVALID_VALUE, [](Context& c) { Frustum(c, 1, 1, -1, 1, 1, 2); }},
    {"Frustum height", GL_INVALID_VALUE, [](Context& c) { Frustum(c, -1, 1, 1, 1, 1, 2); }},
    {"Ortho width", GL_INVALID_VALUE, [](Context& c) { Ortho(c, 1, 1, -1, 1, 1, 2); }},
    {"Ortho height", GL_INVALID_VALUE, [](Context& c) { Ortho(c, -1, 1, 1, 1, 1, 2); }},
    {"Ortho depth", GL_INVALID_VALUE, [](Context& c) { Ortho(c, -1, 1, -1, 1, 1, 1); }},
    {"Viewport width", GL_INVALID_VALUE, [](Context& c) { Viewport(c, 0, 0, -1, 1); }},
    {"Viewport height", GL_INVALID_VALUE, [](Context& c) { Viewport(c, 0, 0, 1, -1); }},
    {"Enable", GL_INVALID_ENUM, [](Context& c) { Enable(c, bad_enum); }},
    {"Enable light 8", GL_INVALID_ENUM, [](Context& c) { Enable(c, GL_LIGHT0 + 8); }},
    {"Disable", GL_INVALID_ENUM, [](Context& c) { Disable(c, bad_enum); }},
    {"IsEnabled", GL_INVALID_ENUM, [](Context& c) { EXPECT_EQ(IsEnabled(c, bad_enum), GL_FALSE); }},
    {"Light light", GL_INVALID_ENUM, [](Context& c) { Lightfv(c, GL_LIGHT0 + 8, GL_AMBIENT, four); }},
    {"Light pname", GL_INVALID_ENUM, [](Context& c) { Lightfv(c, GL_LIGHT0, GL_EMISSION, four); }},
    {"spot exponent", GL_INVALID_VALUE, [](Context& c) { light(c, GL_SPOT_EXPONENT, 128.5f); }},
    {"spot exponent", GL_INVALID_VALUE, [](Context& c) { light(c, GL_SPOT_EXPONENT, -0.5f); }},
    {"spot exponent NaN", GL_INVALID_VALUE, [](Context& c) { light(c, GL_SPOT_EXPONENT, nan_value); }},
    {"spot cutoff", GL_INVALID_VALUE, [](Context& c) { light(c, GL_SPOT_CUTOFF, 90.5f); }},
    {"spot cutoff", GL_INVALID_VALUE, [](Context& c) { light(c, GL_SPOT_CUTOFF, -1.0f); }},
    {"spot cutoff NaN", GL_INVALID_VALUE, [](Context& c) { light(c, GL_SPOT_CUTOFF, nan_value); }},
    {"attenuation", GL_INVALID_VALUE, [](Context& c) { light(c, GL_CONSTANT_ATTENUATION, -1.0f); }},
    {"attenuation", GL_INVALID_VALUE, [](Context& c) { light(c, GL_LINEAR_ATTENUATION, -1.0f); }},
    {"attenuation NaN", GL_INVALID_VALUE, [](Context& c) { light(c, GL_QUADRATIC_ATTENUATION, nan_value); }},
    {"LightModel pname", GL_INVALID_ENUM, [](Context& c) { LightModelfv(c, GL_AMBIENT, four); }},
    {"color control", GL_INVALID_ENUM, [](Context& c) { LightModelfv(c, GL_LIGHT_MODEL_COLOR_CONTROL, four); }},
    {"Material face", GL_INVALID_ENUM, [](Context& c) { Materialfv(c, GL_LEFT, GL_AMBIENT, four); }},
    {"Material pname", GL_INVALID_ENUM, [](Context& c) { Materialfv(c, GL_FRONT, GL_POSITION, four); }},
    {"shininess", GL_INVALID_VALUE, [](Context& c) { shininess(c, 128.5f); }},
    {"shininess", GL_INVALID_VALUE, [](Context& c) { shininess(c, -1.0f); }},
    {"shininess NaN", GL_INVALID_VALUE, [](Context& c) { shininess(c, nan_value); }},
    {"ColorMaterial face", GL_INVALID_ENUM, [](Context& c) { ColorMaterial(c, GL_LEFT, GL_AMBIENT); }},
    {"ColorMaterial mode", GL_INVALID_ENUM, [](Context& c) { ColorMaterial(c, GL_FRONT, GL_SHININESS); }},
    {"ShadeModel", GL_INVALID_ENUM, [](Context& c) { ShadeModel(c, bad_enum); }},
    {"GetLight light", GL_INVALID_ENUM, [](Context& c) { GetLightfv(c, GL_LIGHT0 + 8, GL_AMBIENT, four); }},
    {"GetLight pname", GL_INVALID_ENUM, [](Context& c) { GetLightiv(c, GL_LIGHT0, GL_EMISSION, four_ints); }},
    {"GetMaterial face", GL_INVALID_ENUM, [](Context& c) { GetMaterialfv(c, GL_FRONT_AND_BACK, GL_AMBIENT, four); }},
    {"GetMaterial pname", GL_INVALID_ENUM,
     [](Context& c) { GetMaterialiv(c, GL_FRONT, GL_AMBIENT_AND_DIFFUSE, four_ints); }},
    {"PointSize 0", GL_INVALID_VALUE, [](Context& c) { PointSize(c, 0.0f); }},
    {"PointSize NaN", GL_INVALID_VALUE, [](Context& c) { PointSize(c, nan_value); }},
    {"LineWidth -1", GL_INVALID_VALUE, [](Context& c) { LineWidth(c, -1.0f); }},
    {"LineWidth NaN", GL_INVALID_VALUE, [](Context& c) { LineWidth(c, nan_value); }},
    {"FrontFace", GL_INVALID_ENUM, [](Context& c) { FrontFace(c, GL_FRONT); }},
    {"CullFace", GL_INVALID_ENUM, [](Context& c) { CullFace(c, GL_CW); }},
    {"PolygonMode face", GL_INVALID_ENUM, [](Context& c) { PolygonMode(c, GL_CW, GL_LINE); }},
    {"PolygonMode mode", GL_INVALID_ENUM, [](Context& c) { PolygonMode(c, GL_FRONT, GL_LINES); }},
    {"Scissor width", GL_INVALID_VALUE, [](Context& c) { Scissor(c, 0, 0, -1, 1); }},
    {"Scissor height", GL_INVALID_VALUE, [](Context& c) { Scissor(c, 0, 0, 1, -1); }},
    {"AlphaFunc", GL_INVALID_ENUM, [](Context& c) { AlphaFunc(c, GL_ALWAYS + 1, 0.5f); }},
    {"AlphaFunc", GL_INVALID_ENUM, [](Context& c) { AlphaFunc(c, GL_NEVER - 1, 0.5f); }},
    {"BlendFunc source", GL_INVALID_ENUM, [](Context& c) { BlendFunc(c, bad_enum, GL_ONE); }},
    {"BlendFunc destination", GL_INVALID_ENUM, [](Context& c) { BlendFunc(c, GL_ONE, GL_SRC_ALPHA_SATURATE); }},
    {"BlendFuncSeparate", GL_INVALID_ENUM, [](Context& c) { BlendFuncSeparate(c, GL_ZERO, GL_ONE, bad_enum, GL_ONE); }},
    {"BlendFuncSeparate", GL_INVALID_ENUM, [](Context& c) { BlendFuncSeparate(c, GL_ZERO, GL_ONE, GL_ONE, bad_enum); }},
    {"BlendEquation", GL_INVALID_ENUM, [](Context& c) { BlendEquation(c, bad_enum); }},
    {"BlendEquationSeparateEXT", GL_INVALID_ENUM, [](Context& c) { BlendEquationSeparateEXT(c, GL_LOGIC_OP, GL_MIN); }},
    {"LogicOp", GL_INVALID_ENUM, [](Context& c) { LogicOp(c, GL_SET + 1); }},
    {"LogicOp", GL_INVALID_ENUM, [](Context& c) { LogicOp(c, GL_CLEAR - 1); }},
    {"DepthFunc", GL_INVALID_ENUM, [](Context& c) { DepthFunc(c, GL_ALWAYS + 1); }},
    {"DepthFunc", GL_INVALID_ENUM, [](Context& c) { DepthFunc(c, GL_NEVER - 1); }},
    {"Clear", GL_INVALID_VALUE, [](Context& c) { Clear(c, GL_COLOR_BUFFER_BIT | 1); }},
    {"Hint target", GL_INVALID_ENUM, [](Context& c) { Hint(c, GL_FOG, GL_NICEST); }},
    {"Hint mode", GL_INVALID_ENUM, [](Context& c) { Hint(c, GL_FOG_HINT, GL_TRUE); }},
    {"GetFloatv", GL_INVALID_ENUM, [](Context& c) { GetFloatv(c, bad_enum, four); }},
    {"GetIntegerv", GL_INVALID_ENUM, [](Context& c) { GetIntegerv(c, GL_AMBIENT, four_ints); }},
    {"GetString", GL_INVALID_ENUM, [](Context& c) { EXPECT_EQ(GetString(c, bad_enum), nullptr); }},
};

TEST(BadArguments, GiveTheErrorAndChangeNothing) {
  Context context({}, nullptr);
  ASSERT_TRUE(context.set_window_size(8, 8, pipeline::ColorFormat::rgba8));
  for (const BadCall& bad : bad_calls) {
    const State before = context.state;
    bad.call(context);
    EXPECT_EQ(context.take_error(), bad.error) << bad.what;
    EXPECT_TRUE(context.state == before) << bad.what;
    EXPECT_FALSE(context.inside_begin_end()) << bad.what;
  }
}

TEST(MatrixStacks, OverflowAtTheirDepthsAndKeepTheMatrix) {
  Context context({}, nullptr);
  const struct {
    GLenum mode;
    int depth;
  } stacks[] = {{GL_MODELVIEW, 32}, {GL_PROJECTION, 32}, {GL_TEXTURE, 10}};
  for (const auto& [mode, depth] : stacks) {
    MatrixMode(context, mode);
    for (int i = 1; i < depth; ++i) PushMatrix(context);
    EXPECT_EQ(context.take_error(), static_cast<GLenum>(GL_NO_ERROR));
    const State before = context.state;
    PushMatrix(context);
    EXPECT_EQ(context.take_error(), static_cast<GLenum>(GL_STACK_OVERFLOW));
    EXPECT_TRUE(context.state == before);
  }
}

// Every float of every command, poured full of what is no ordinary number: nothing may crash or be undefined (this
// test is for the sanitizers), and what is asked for afterwards is defined.
TEST(AnyFloat, IsTakenWithoutHarm) {
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<float> values = {nan_value, infinity, -infinity, 1e38f, -1e38f, 1e-45f, 0.0f};
  for (const float v : values) {
    Context c({}, nullptr);
    ASSERT_TRUE(c.set_window_size(32, 32, pipeline::ColorFormat::rgba8));
    Enable(c, GL_LIGHTING);
    Enable(c, GL_LIGHT0);
    Enable(c, GL_RESCALE_NORMAL);
    Enable(c, GL_DEPTH_TEST);
    LightModelfv(c, GL_LIGHT_MODEL_LOCAL_VIEWER, &values[3]);
    const GLfloat vector[16] = {v, v, v, v, v, v, v, v, v, v, v, v, v, v, v, v};
    for (GLenum pname = GL_AMBIENT; pname <= GL_QUADRATIC_ATTENUATION; ++pname) Lightfv(c, GL_LIGHT0, pname, vector);
    for (GLenum pname = GL_LIGHT_MODEL_LOCAL_VIEWER; pname <= GL_LIGHT_MODEL_AMBIENT; ++pname) {
      LightModelfv(c, pname, vector);
    }
    LightModelfv(c, GL_LIGHT_MODEL_COLOR_CONTROL, vector);
    for (GLenum pname = GL_EMISSION; pname <= GL_COLOR_INDEXES; ++pname) {
      Materialfv(c, GL_FRONT_AND_BACK, pname, vector);
    }
    DepthRange(c, v, -v);
    ClearDepth(c, v);
    ClearColor(c, v, v, v, v);
    ClearIndex(c, v);
    PointSize(c, v);
    LineWidth(c, v);
    SampleCoverage(c, v, GL_TRUE);
    FogCoordf(c, v);
    Indexf(c, v);
    SecondaryColor3f(c, v, v, v);
    TexCoord4f(c, v, v, v, v);

    const auto draw = [&] {
      Clear(c, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
        Begin(c, mode);
        for (int i = 0; i < 8; ++i) {
          Normal3f(c, v, i < 4 ? v : 1.0f, v);
          Color4f(c, v, i < 4 ? v : 1.0f, v, v);
          Vertex4f(c, i % 3 == 0 ? v : 0.1f * static_cast<float>(i), i % 2 == 0 ? v : 0.3f, v, i < 5 ? 1.0f : v);
        }
        End(c);
      }
      Finish(c);
    };
    draw();
    LoadMatrixf(c, vector);
    draw();
    for (int command = 0; command < 6; ++command) {
      LoadIdentity(c);
      switch (command) {
        case 0:
          MultMatrixf(c, vector);
          break;
        case 1:
          Rotatef(c, v, 1, 2, 3);
          break;
        case 2:
          Rotatef(c, 30, v, 1, v);
          break;
        case 3:
          Translatef(c, v, 1, v);
          break;
        case 4:
          Scalef(c, v, 1, v);
          break;
        default:
          MatrixMode(c, GL_PROJECTION);
          Frustum(c, v, 1, -1, 1, 1, v);
          Ortho(c, -1, v, -1, 1, -1, 1);
          break;
      }
      Lightfv(c, GL_LIGHT0, GL_POSITION, vector);
      Lightfv(c, GL_LIGHT0, GL_SPOT_DIRECTION, vector);
      draw();
    }
    for (GLenum pname = 0; pname < 0x9000; ++pname) {
      GLint integers[16];
      GLfloat floats[16];
      GLdouble doubles[16];
      GLboolean booleans[16];
      GetIntegerv(c, pname, integers);
      GetFloatv(c, pname, floats);
      GetDoublev(c, pname, doubles);
      GetBooleanv(c, pname, booleans);
    }
  }
}

TEST(Viewport, ClampsToItsLimits) {
  Context c({}, nullptr);
  constexpr GLint most = std::numeric_limits<GLint>::max(), least = std::numeric_limits<GLint>::min();
  Viewport(c, least, most, most, 5);
  EXPECT_EQ(c.state.viewport, (ViewportGroup{-32768, 32767, 16384, 5, 0.0, 1.0}));
}

}  // namespace
}  // namespace gouraud::api
