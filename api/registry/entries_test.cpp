// The generated entry points over handlers that only note what they get (testing/).
#include <GL/gl.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "api/context/context.h"
#include "api/registry/enum_names.h"
#include "api/registry/proc_address.h"
#include "gl_table.h"
#include "records.h"

namespace gouraud::api {

constinit thread_local Context* test_context = nullptr;

std::vector<unsigned char> appended_record;
records::Opcode appended_opcode;
bool execute_too = false;

bool append_record(Context&, records::Opcode opcode, const void* record, std::size_t bytes) noexcept {
  const auto* const first = static_cast<const unsigned char*>(record);
  appended_record.assign(first, first + bytes);
  appended_opcode = opcode;
  return execute_too;
}

namespace {

using Values = std::vector<double>;

class Entries : public testing::Test {
 protected:
  Entries() { test_context = &context; }
  ~Entries() override { test_context = nullptr; }
  void expect_call(const char* handler, const Values& arguments) {
    EXPECT_EQ(context.called, handler);
    EXPECT_EQ(context.arguments, arguments);
    context.called.clear();
  }
  Context context;
};

// [GL1.5 Table 2.9] in long double, rounded once.
template <class T>
double component(T c) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<float>(c);
  } else {
    const long double range = std::pow(2.0L, 8 * sizeof(T)) - 1;
    return static_cast<float>((std::is_signed_v<T> ? 2.0L * c + 1 : static_cast<long double>(c)) / range);
  }
}

template <class T>
std::vector<T> boundaries() {
  using Limits = std::numeric_limits<T>;
  if constexpr (std::is_floating_point_v<T>) {
    return {T(0), T(1), T(-1), T(0.1), T(1e38), Limits::infinity()};
  } else {
    return {Limits::min(), T(Limits::min() + 1), T(-1), T(0), T(1), T(Limits::max() - 1), Limits::max()};
  }
}

template <class T>
void check_components(Context& context, void (*three)(T, T, T), void (*three_v)(const T*), void (*four)(T, T, T, T),
                      void (*four_v)(const T*), const char* handler) {
  for (const T c : boundaries<T>()) {
    const T v[] = {c, T(1), T(0), c};
    Values expected = {component(v[0]), component(v[1]), component(v[2])};
    const bool has_alpha = std::strcmp(handler, "Color4f") == 0;
    if (has_alpha) expected.push_back(1.0);
    three(v[0], v[1], v[2]);
    EXPECT_EQ(context.arguments, expected);
    context.arguments.clear();
    three_v(v);
    EXPECT_EQ(context.arguments, expected);
    EXPECT_EQ(context.called, handler);
    if (four == nullptr) continue;
    expected[3] = component(v[3]);
    four(v[0], v[1], v[2], v[3]);
    EXPECT_EQ(context.arguments, expected);
    context.arguments.clear();
    four_v(v);
    EXPECT_EQ(context.arguments, expected);
  }
}

TEST_F(Entries, ColorConvertsEachTypeByTable29) {
  check_components<GLbyte>(context, glColor3b, glColor3bv, glColor4b, glColor4bv, "Color4f");
  check_components<GLshort>(context, glColor3s, glColor3sv, glColor4s, glColor4sv, "Color4f");
  check_components<GLint>(context, glColor3i, glColor3iv, glColor4i, glColor4iv, "Color4f");
  check_components<GLubyte>(context, glColor3ub, glColor3ubv, glColor4ub, glColor4ubv, "Color4f");
  check_components<GLushort>(context, glColor3us, glColor3usv, glColor4us, glColor4usv, "Color4f");
  check_components<GLuint>(context, glColor3ui, glColor3uiv, glColor4ui, glColor4uiv, "Color4f");
  check_components<GLfloat>(context, glColor3f, glColor3fv, glColor4f, glColor4fv, "Color4f");
  check_components<GLdouble>(context, glColor3d, glColor3dv, glColor4d, glColor4dv, "Color4f");
}

TEST_F(Entries, NormalAndSecondaryColorConvertByTable29) {
  check_components<GLbyte>(context, glNormal3b, glNormal3bv, nullptr, nullptr, "Normal3f");
  check_components<GLshort>(context, glNormal3s, glNormal3sv, nullptr, nullptr, "Normal3f");
  check_components<GLint>(context, glNormal3i, glNormal3iv, nullptr, nullptr, "Normal3f");
  check_components<GLdouble>(context, glNormal3d, glNormal3dv, nullptr, nullptr, "Normal3f");
  check_components<GLubyte>(context, glSecondaryColor3ub, glSecondaryColor3ubv, nullptr, nullptr, "SecondaryColor3f");
  check_components<GLushort>(context, glSecondaryColor3us, glSecondaryColor3usv, nullptr, nullptr, "SecondaryColor3f");
  check_components<GLuint>(context, glSecondaryColor3ui, glSecondaryColor3uiv, nullptr, nullptr, "SecondaryColor3f");
}

TEST_F(Entries, EveryByteHitsTheEndsOfTheRange) {
  glColor3ub(255, 0, 128);
  expect_call("Color4f", {1.0, 0.0, static_cast<float>(128.0 / 255.0), 1.0});
  glNormal3b(127, -128, 0);
  expect_call("Normal3f", {1.0, -1.0, static_cast<float>(1.0 / 255.0)});
  glColor3i(2147483647, -2147483647 - 1, 0);
  expect_call("Color4f", {1.0, -1.0, static_cast<float>(1.0 / 4294967295.0), 1.0});
}

TEST_F(Entries, CoordinatesKeepTheirValueAndFillTheRest) {
  glVertex2s(-32768, 7);
  expect_call("Vertex4f", {-32768, 7, 0, 1});
  const GLint xyz[] = {1, -2, 16777217};
  glVertex3iv(xyz);
  expect_call("Vertex4f", {1, -2, 16777216, 1});
  glVertex4d(1, 2, 3, 1e300);
  expect_call("Vertex4f", {1, 2, 3, std::numeric_limits<double>::infinity()});
  glTexCoord1f(0.5f);
  expect_call("TexCoord4f", {0.5, 0, 0, 1});
  const GLshort strq[] = {1, 2, 3, 4};
  glMultiTexCoord4sv(GL_TEXTURE3, strq);
  expect_call("MultiTexCoord4f", {GL_TEXTURE3, 1, 2, 3, 4});
  glMultiTexCoord2dARB(GL_TEXTURE1, 0.25, 2);
  expect_call("MultiTexCoord4f", {GL_TEXTURE1, 0.25, 2, 0, 1});
  const GLint from[] = {1, 2}, to[] = {3, 4};
  glRectiv(from, to);
  expect_call("Rectf", {1, 2, 3, 4});
  glRasterPos2i(3, 4);
  expect_call("RasterPos4f", {3, 4, 0, 1});
  glWindowPos2s(5, 6);
  expect_call("WindowPos3f", {5, 6, 0});
  glIndexub(255);
  expect_call("Indexf", {255});
  const GLdouble uv[] = {0.5, 0.75};
  glEvalCoord2dv(uv);
  expect_call("EvalCoord2f", {0.5, 0.75});
  const GLboolean flag = GL_FALSE;
  glEdgeFlagv(&flag);
  expect_call("EdgeFlag", {0});
  glFogCoordd(2.5);
  expect_call("FogCoordf", {2.5});
}

TEST_F(Entries, IntegerColourParametersMapLinearlyAndOthersDirectly) {
  const GLint ends[] = {2147483647, -2147483647 - 1, 0, 2147483647};
  const float zero = static_cast<float>(1.0 / 4294967295.0);
  glLightiv(GL_LIGHT0, GL_DIFFUSE, ends);
  expect_call("Lightfv", {GL_DIFFUSE, 1, -1, zero, 1});
  glMaterialiv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, ends);
  expect_call("Materialfv", {GL_AMBIENT_AND_DIFFUSE, 1, -1, zero, 1});
  glFogiv(GL_FOG_COLOR, ends);
  expect_call("Fogfv", {GL_FOG_COLOR, 1, -1, zero, 1});
  glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, ends);
  expect_call("TexParameterfv", {GL_TEXTURE_BORDER_COLOR, 1, -1, zero, 1});
  const GLint position[] = {1, 2, 3, 0};
  glLightiv(GL_LIGHT0, GL_POSITION, position);
  expect_call("Lightfv", {GL_POSITION, 1, 2, 3, 0});
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
  expect_call("TexEnvfv", {GL_TEXTURE_ENV_MODE, GL_DECAL, 0, 0, 0});
  const GLdouble plane[] = {0.5, 1, 2, 3};
  glTexGendv(GL_S, GL_EYE_PLANE, plane);
  expect_call("TexGenfv", {GL_EYE_PLANE, 0.5, 1, 2, 3});
}

TEST_F(Entries, VectorFormReadsNoMoreThanTheParameterHas) {
  const std::vector<GLint> one = {90};
  glLightiv(GL_LIGHT0, GL_SPOT_CUTOFF, one.data());
  expect_call("Lightfv", {GL_SPOT_CUTOFF, 90, 0, 0, 0});
  glLightiv(GL_LIGHT0, GL_TEXTURE_2D, nullptr);
  expect_call("", context.arguments);
  EXPECT_EQ(context.error, static_cast<GLenum>(GL_INVALID_ENUM));
}

TEST_F(Entries, ScalarFormRefusesVectorParameters) {
  glLightf(GL_LIGHT1, GL_SPOT_EXPONENT, 8.0f);
  expect_call("Lightfv", {GL_SPOT_EXPONENT, 8, 0, 0, 0});
  EXPECT_EQ(context.error, static_cast<GLenum>(GL_NO_ERROR));
  void (*const refused[])() = {[] { glLightf(GL_LIGHT0, GL_POSITION, 1.0f); },
                               [] { glMateriali(GL_FRONT, GL_DIFFUSE, 1); },
                               [] { glLightModeli(GL_LIGHT_MODEL_AMBIENT, 1); },
                               [] { glFogf(GL_FOG_COLOR, 1.0f); },
                               [] { glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 1.0f); },
                               [] { glTexGend(GL_S, GL_OBJECT_PLANE, 1.0); },
                               [] { glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 1); },
                               [] { glPointParameterf(GL_POINT_DISTANCE_ATTENUATION, 1.0f); }};
  for (const auto call : refused) {
    context.error = GL_NO_ERROR;
    call();
    EXPECT_EQ(context.called, "");
    EXPECT_EQ(context.error, static_cast<GLenum>(GL_INVALID_ENUM));
  }
}

TEST_F(Entries, MatricesConvertAndTranspose) {
  GLdouble m[16];
  Values expected = {0}, transposed = {0};
  for (int i = 0; i < 16; ++i) m[i] = i;
  for (int i = 0; i < 16; ++i) expected.push_back(i), transposed.push_back(i % 4 * 4 + i / 4);
  glLoadMatrixd(m);
  expect_call("LoadMatrixf", expected);
  glMultTransposeMatrixd(m);
  expect_call("MultMatrixf", transposed);
  glRotated(90, 0, 0, 1);
  expect_call("Rotatef", {90, 0, 0, 1});
}

TEST_F(Entries, PixelStoreRoundsFloats) {
  glPixelStoref(GL_UNPACK_ROW_LENGTH, 6.6f);
  expect_call("PixelStorei", {GL_UNPACK_ROW_LENGTH, 7});
  glPixelStoref(GL_PACK_SWAP_BYTES, 0.25f);
  expect_call("PixelStorei", {GL_PACK_SWAP_BYTES, 1});
  glPixelStoref(GL_PACK_ROW_LENGTH, 1e38f);
  expect_call("PixelStorei", {GL_PACK_ROW_LENGTH, 2147483647});
  glPixelStoref(GL_PACK_ROW_LENGTH, std::nanf(""));
  expect_call("PixelStorei", {GL_PACK_ROW_LENGTH, -1});
}

TEST_F(Entries, CommandIsRefusedBetweenBeginAndEnd) {
  context.inside = true;
  glDepthFunc(GL_LESS);
  EXPECT_EQ(context.called, "");
  EXPECT_EQ(context.error, static_cast<GLenum>(GL_INVALID_OPERATION));
  EXPECT_EQ(context.error_text, "glDepthFunc: not allowed between glBegin and glEnd");
  EXPECT_EQ(glGetError(), 0u);
  context.error = GL_NO_ERROR;
  glVertex2f(1, 2);
  glMaterialf(GL_FRONT, GL_SHININESS, 10);
  expect_call("Materialfv", {GL_SHININESS, 10, 0, 0, 0});
  glEnd();
  expect_call("End", {});
  EXPECT_EQ(context.error, static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Entries, UnwrittenCommandSaysSoOnce) {
  testing::internal::CaptureStderr();
  glAccum(GL_LOAD, 1.0f);
  glAccum(GL_LOAD, 1.0f);
  EXPECT_EQ(glIsTexture(1), GL_FALSE);
  EXPECT_EQ(glMapBufferARB(GL_ARRAY_BUFFER, GL_READ_ONLY), nullptr);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "gouraud: glAccum is not implemented\ngouraud: glIsTexture is not implemented\n"
            "gouraud: glMapBuffer is not implemented\n");
  EXPECT_EQ(context.error, static_cast<GLenum>(GL_INVALID_OPERATION));
}

TEST_F(Entries, WithoutAContextNothingHappens) {
  test_context = nullptr;
  glVertex3f(1, 2, 3);
  glAccum(GL_LOAD, 1.0f);
  EXPECT_EQ(glGetError(), 0u);
  EXPECT_EQ(glGetString(GL_VERSION), nullptr);
  EXPECT_EQ(context.called, "");
}

TEST_F(Entries, NoExceptionLeavesTheLibrary) {
  glLineWidth(2.0f);
  EXPECT_EQ(context.error, static_cast<GLenum>(GL_OUT_OF_MEMORY));
}

TEST_F(Entries, TraceNamesEnumsByTheirParameter) {
  context.tracing = true;
  testing::internal::CaptureStderr();
  glBegin(GL_POINTS);
  glVertex3f(1, 2.5f, -0.1f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const GLfloat position[] = {1, 1, 1, 0};
  glLightfv(GL_LIGHT0, GL_POSITION, position);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glBlendFunc(GL_ONE, GL_ZERO);
  glBitmap(8, 8, 0, 0, 0, 0, nullptr);
  glTexImage1D(GL_TEXTURE_1D, 0, 3, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
  glGetError();
  const std::string text = testing::internal::GetCapturedStderr();
  for (const char* line :
       {"glBegin(GL_POINTS)\n", "glVertex3f(1, 2.5, -0.1)\n", "glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT)\n",
        "glLightfv(GL_LIGHT0, GL_POSITION, {1, 1, 1, 0})\n",
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR)\n", "glBlendFunc(GL_ONE, GL_ZERO)\n",
        "glBitmap(8, 8, 0, 0, 0, 0, NULL)\n",
        "glTexImage1D(GL_TEXTURE_1D, 0, 3, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, NULL)\n", "glGetError()\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << "is not in\n" << text;
  }
  EXPECT_EQ(context.called, "TexParameterfv");
}

TEST_F(Entries, OpenListTakesRecordableCommandsAndExecutesTheRestAtOnce) {
  context.open_list = true;
  execute_too = false;
  context.inside = true;  // errors belong to the list's execution
  const GLfloat specular[] = {0.25f, 0.5f, 0.75f, 1.0f};
  glMaterialfv(GL_BACK, GL_SPECULAR, specular);
  EXPECT_EQ(context.called, "");
  ASSERT_EQ(appended_opcode, records::Opcode::Materialfv);
  ASSERT_EQ(appended_record.size(), sizeof(records::Materialfv));
  const auto opcode = appended_opcode;
  const auto record = appended_record;
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  EXPECT_EQ(context.error, static_cast<GLenum>(GL_INVALID_OPERATION));
  context.inside = false;
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  expect_call("PixelStorei", {GL_PACK_ALIGNMENT, 1});

  context.open_list = false;
  records::execute(context, opcode, record.data());
  expect_call("Materialfv", {GL_SPECULAR, 0.25, 0.5, 0.75, 1});
}

TEST_F(Entries, CompileAndExecuteDoesBoth) {
  context.open_list = true;
  execute_too = true;
  const GLubyte color[] = {255, 0, 255, 255};
  glColor4ubv(color);
  EXPECT_EQ(appended_opcode, records::Opcode::Color4ubv);
  EXPECT_EQ(std::memcmp(appended_record.data(), color, 4), 0);
  expect_call("Color4f", {1, 0, 1, 1});
}

TEST(Records, VertexValueConvertsLikeTheCommand) {
  using Kind = records::VertexValue::Kind;
  const auto check = [](records::Opcode opcode, const void* record, Kind kind, const std::vector<GLfloat>& expected) {
    const records::VertexValue value = records::vertex_value(opcode, record);
    EXPECT_EQ(value.kind, kind);
    EXPECT_EQ(std::vector<GLfloat>(std::begin(value.components), std::end(value.components)), expected);
  };
  const records::Vertex2s vertex{3, -4};
  check(records::Opcode::Vertex2s, &vertex, Kind::position, {3, -4, 0, 1});
  const records::Color4ubv color{{255, 0, 51, 255}};
  check(records::Opcode::Color4ubv, &color, Kind::color, {1, 0, 0.2f, 1});
  const records::Normal3b normal{127, -128, 127};
  check(records::Opcode::Normal3b, &normal, Kind::normal, {1, -1, 1, 0});
  const records::TexCoord1dv coordinates{{0.5}};
  check(records::Opcode::TexCoord1dv, &coordinates, Kind::texture_coordinates, {0.5f, 0, 0, 1});
  const records::SecondaryColor3ub secondary{255, 0, 51};
  check(records::Opcode::SecondaryColor3ub, &secondary, Kind::secondary_color, {1, 0, 0.2f, 0});
  const records::FogCoordd fog{2.5};
  check(records::Opcode::FogCoordd, &fog, Kind::fog_coordinate, {2.5f, 0, 0, 0});
  const records::MultiTexCoord2s multi{GL_TEXTURE3, 7, -8};
  check(records::Opcode::MultiTexCoord2s, &multi, Kind::texture_coordinates, {7, -8, 0, 1});
  EXPECT_EQ(records::vertex_value(records::Opcode::MultiTexCoord2s, &multi).texture, static_cast<GLenum>(GL_TEXTURE3));
  const records::Begin begin{GL_POINTS};
  check(records::Opcode::Begin, &begin, Kind::none, {0, 0, 0, 0});
}

TEST(Records, TableOfClientMemoryIsSortedAndInRange) {
  // GL 1.5's, BlitFramebuffer, ClipControl, BlendEquationSeparateEXT, PolygonOffsetEXT, and three of stencil tests of both
  // faces.
  EXPECT_EQ(records::opcode_count, 373u + 7);
  for (std::size_t i = 0; i < records::client_memory_count; ++i) {
    const records::ClientMemory& row = records::client_memory[i];
    const std::size_t bytes = records::record_infos[static_cast<std::size_t>(row.opcode)].bytes;
    EXPECT_LE(row.pointer_offset + sizeof(void*), bytes);
    EXPECT_LE(row.count_offset + sizeof(GLsizei), bytes);
    if (i > 0) {
      EXPECT_LE(records::client_memory[i - 1].opcode, row.opcode);
    }
  }
}

TEST(ProcAddress, FindsEveryNameAndNothingElse) {
  EXPECT_EQ(proc_address("glBegin"), reinterpret_cast<Proc>(&glBegin));
  EXPECT_EQ(proc_address("glActiveTextureARB"), reinterpret_cast<Proc>(&glActiveTexture));
  EXPECT_EQ(proc_address("glBeginn"), nullptr);
  EXPECT_EQ(proc_address("glBegi"), nullptr);
  EXPECT_EQ(proc_address(""), nullptr);
  EXPECT_EQ(proc_address(nullptr), nullptr);
  for (std::size_t i = 0; i < named_proc_count; ++i) {
    EXPECT_EQ(proc_address(named_procs[i].name), named_procs[i].proc) << named_procs[i].name;
  }
}

void* find_proc(const char* name) {
  return reinterpret_cast<void*>(proc_address(name));
}

TEST(GlTable, HoldsEveryCommand) {
  GlTable table;
  EXPECT_TRUE(load(table, find_proc));
  EXPECT_EQ(table.Vertex3f, &glVertex3f);
  EXPECT_EQ(table.WindowPos3svARB, &glWindowPos3sv);
}

TEST(GlTable, IsIncompleteWithoutACoreCommand) {
  GlTable table;
  EXPECT_FALSE(load(table, [](const char* name) { return std::strcmp(name, "glAccum") ? find_proc(name) : nullptr; }));
  EXPECT_EQ(table.Accum, nullptr);
  EXPECT_EQ(table.Begin, &glBegin);
  EXPECT_TRUE(load(table, [](const char* name) { return std::strstr(name, "ARB") ? nullptr : find_proc(name); }));
  EXPECT_EQ(table.ActiveTextureARB, nullptr);
}

TEST(EnumNames, GroupDecidesAmongNamesOfOneValue) {
  EXPECT_STREQ(enum_name(0, EnumGroup::PrimitiveType), "GL_POINTS");
  EXPECT_STREQ(enum_name(0, EnumGroup::BlendingFactor), "GL_ZERO");
  EXPECT_STREQ(enum_name(0, EnumGroup::DrawBufferMode), "GL_NONE");
  EXPECT_STREQ(enum_name(0, EnumGroup::ErrorCode), "GL_NO_ERROR");
  EXPECT_STREQ(enum_name(1, EnumGroup::PrimitiveType), "GL_LINES");
  EXPECT_STREQ(enum_name(GL_CURRENT_BIT, EnumGroup::AttribMask), "GL_CURRENT_BIT");
}

TEST(EnumNames, NewestCoreNameWins) {
  EXPECT_STREQ(enum_name(GL_FOG_COORDINATE_SOURCE), "GL_FOG_COORD_SRC");
  EXPECT_STREQ(enum_name(GL_SOURCE0_RGB_ARB), "GL_SRC0_RGB");
  EXPECT_STREQ(enum_name(GL_BGRA_EXT), "GL_BGRA");
  EXPECT_STREQ(enum_name(GL_LIGHT0), "GL_LIGHT0");
  EXPECT_STREQ(enum_name(0xDEAD), "0xDEAD");
}

}  // namespace
}  // namespace gouraud::api
