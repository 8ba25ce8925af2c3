// Pours NaN, infinities, 1e38 and random enums into every command of the road from Begin to the pixel, in random order:
// nothing may crash, read or write out of range, or compute what C++ does not define (ASan and UBSan watch).
//
// The sequence is the same in every run. Arrays given are larger than any command reads or writes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <tuple>
#include <type_traits>
#include <vector>

#include "api/osmesa/testing/drivers.h"

namespace gouraud::api::testing {
namespace {

constexpr int width = 70, height = 41;

constexpr double awkward[] = {0.0,
                              -0.0,
                              1.0,
                              -1.0,
                              0.5,
                              0.3,
                              -0.7,
                              2.0,
                              90.0,
                              128.0,
                              1e-38,
                              1e-45,
                              -1e-300,
                              1e20,
                              -1e20,
                              1e38,
                              -1e38,
                              1e300,
                              16777216.5,
                              2147483648.0,
                              -2147483904.0,
                              std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()};

constexpr GLint awkward_integers[] = {0,  1,   -1,    2,     3,     7,          8,           40,
                                      64, 255, 16384, 16385, 65536, 2147483647, -2147483647, -2147483647 - 1};

// What an enum may well be where the caller of pour() does not say.
constexpr GLenum enums[] = {0,
                            1,
                            GL_TRIANGLES,
                            GL_QUADS,
                            GL_POLYGON + 1,
                            GL_FRONT,
                            GL_BACK,
                            GL_FRONT_AND_BACK,
                            GL_LIGHT0,
                            GL_LIGHT0 + 8,
                            GL_AMBIENT,
                            GL_POSITION,
                            GL_DEPTH_TEST,
                            GL_RGBA,
                            GL_FLOAT,
                            GL_PROJECTION,
                            0x7FFFFFFF,
                            0xFFFFFFFF};

using Enums = std::vector<GLenum>;
const Enums lights = {GL_LIGHT0, GL_LIGHT1, GL_LIGHT2, GL_LIGHT7};
const Enums light_parameters = {GL_AMBIENT,
                                GL_DIFFUSE,
                                GL_SPECULAR,
                                GL_POSITION,
                                GL_SPOT_DIRECTION,
                                GL_SPOT_EXPONENT,
                                GL_SPOT_CUTOFF,
                                GL_CONSTANT_ATTENUATION,
                                GL_LINEAR_ATTENUATION,
                                GL_QUADRATIC_ATTENUATION};
const Enums model_parameters = {GL_LIGHT_MODEL_AMBIENT, GL_LIGHT_MODEL_LOCAL_VIEWER, GL_LIGHT_MODEL_TWO_SIDE,
                                GL_LIGHT_MODEL_COLOR_CONTROL};
const Enums faces = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK};
const Enums material_parameters = {GL_AMBIENT,  GL_DIFFUSE,   GL_SPECULAR,
                                   GL_EMISSION, GL_SHININESS, GL_AMBIENT_AND_DIFFUSE};
const Enums modes = {GL_POINTS,         GL_LINES,        GL_LINE_LOOP, GL_LINE_STRIP, GL_TRIANGLES,
                     GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,     GL_QUAD_STRIP, GL_POLYGON};
const Enums capabilities = {GL_LIGHTING,   GL_LIGHT0,         GL_LIGHT1,    GL_LIGHT2,
                            GL_LIGHT7,     GL_COLOR_MATERIAL, GL_NORMALIZE, GL_RESCALE_NORMAL,
                            GL_DEPTH_TEST, GL_SCISSOR_TEST,   GL_CULL_FACE, GL_DITHER};
const Enums comparisons = {GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
const Enums matrix_modes = {GL_MODELVIEW, GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE};
const Enums queries = {GL_MODELVIEW_MATRIX,
                       GL_PROJECTION_MATRIX,
                       GL_CURRENT_COLOR,
                       GL_CURRENT_NORMAL,
                       GL_VIEWPORT,
                       GL_DEPTH_RANGE,
                       GL_SCISSOR_BOX,
                       GL_COLOR_CLEAR_VALUE,
                       GL_DEPTH_CLEAR_VALUE,
                       GL_LIGHT_MODEL_AMBIENT,
                       GL_TRANSPOSE_MODELVIEW_MATRIX,
                       GL_POINT_SIZE,
                       GL_MAX_VIEWPORT_DIMS};

class BadInput : public ::testing::Test {
 protected:
  BadInput() { list_commands(); }

  std::uint32_t random(std::size_t below) { return static_cast<std::uint32_t>(engine_() % below); }
  template <class Values>
  auto any_of(const Values& values) {
    return values[random(std::size(values))];
  }

  // Half of all numbers are harmless, so that pictures appear; the others are the worst there are.
  template <class T>
  T number() {
    if constexpr (std::is_same_v<T, GLfloat>) {
      return static_cast<GLfloat>(random(2) == 0 ? awkward_float() : static_cast<double>(random(2001)) / 500.0 - 2.0);
    } else if constexpr (std::is_same_v<T, GLdouble>) {
      return random(2) == 0 ? any_of(awkward) : static_cast<double>(random(2001)) / 500.0 - 2.0;
    } else {
      return static_cast<T>(random(2) == 0 ? any_of(awkward_integers) : static_cast<GLint>(random(60)));
    }
  }
  // The nearest float; beyond the range of float the conversion is not C++'s to define.
  double awkward_float() {
    const double value = any_of(awkward);
    return std::abs(value) > 3.4e38 && std::isfinite(value) ? std::copysign(1e38, value) : value;
  }

  template <class T>
  T* array() {
    static std::array<T, 64> values;
    for (T& value : values) value = number<T>();
    return values.data();
  }

  template <class T>
  T argument(const std::vector<Enums>& choices, std::size_t& next_enum) {
    if constexpr (std::is_pointer_v<T>) {
      return array<std::remove_const_t<std::remove_pointer_t<T>>>();
    } else if constexpr (std::is_same_v<T, GLenum>) {
      const std::size_t which = next_enum++;
      if (which < choices.size() && random(10) != 0) return any_of(choices[which]);
      return any_of(enums);
    } else {
      return number<T>();
    }
  }

  // Adds a command: called with random arguments, its enums mostly from `choices`, in their order.
  template <class Result, class... Arguments>
  void pour(Result (*command)(Arguments...), std::vector<Enums> choices = {}) {
    if constexpr (sizeof...(Arguments) == 0) {
      commands_.push_back([command] { command(); });
    } else {
      commands_.push_back([this, command, choices] {
        std::size_t next_enum = 0;
        const std::tuple<Arguments...> arguments{argument<Arguments>(choices, next_enum)...};
        std::apply(command, arguments);
      });
    }
  }
  template <class... Commands>
  void pour_all(Commands... commands) {
    (pour(commands), ...);
  }

  void list_commands();
  void list_vertex_commands();
  void draw_primitive();
  void run(int rounds);

  const GlTable& gl = ours().gl;

 private:
  std::mt19937 engine_{20031030};
  std::vector<std::function<void()>> commands_;
  std::vector<std::function<void()>> vertex_commands_;
};

void BadInput::list_vertex_commands() {
  pour_all(gl.Vertex2d, gl.Vertex2dv, gl.Vertex2f, gl.Vertex2fv, gl.Vertex2i, gl.Vertex2iv, gl.Vertex2s, gl.Vertex2sv,
           gl.Vertex3d, gl.Vertex3dv, gl.Vertex3f, gl.Vertex3fv, gl.Vertex3i, gl.Vertex3iv, gl.Vertex3s, gl.Vertex3sv,
           gl.Vertex4d, gl.Vertex4dv, gl.Vertex4f, gl.Vertex4fv, gl.Vertex4i, gl.Vertex4iv, gl.Vertex4s, gl.Vertex4sv);
  pour_all(gl.Normal3b, gl.Normal3bv, gl.Normal3d, gl.Normal3dv, gl.Normal3f, gl.Normal3fv, gl.Normal3i, gl.Normal3iv,
           gl.Normal3s, gl.Normal3sv);
  pour_all(gl.Color3b, gl.Color3bv, gl.Color3d, gl.Color3dv, gl.Color3f, gl.Color3fv, gl.Color3i, gl.Color3iv,
           gl.Color3s, gl.Color3sv, gl.Color3ub, gl.Color3ubv, gl.Color3ui, gl.Color3uiv, gl.Color3us, gl.Color3usv);
  pour_all(gl.Color4b, gl.Color4bv, gl.Color4d, gl.Color4dv, gl.Color4f, gl.Color4fv, gl.Color4i, gl.Color4iv,
           gl.Color4s, gl.Color4sv, gl.Color4ub, gl.Color4ubv, gl.Color4ui, gl.Color4uiv, gl.Color4us, gl.Color4usv);
  pour_all(gl.SecondaryColor3f, gl.SecondaryColor3d, gl.SecondaryColor3b, gl.TexCoord1f, gl.TexCoord2d, gl.TexCoord3i,
           gl.TexCoord4f, gl.FogCoordf, gl.FogCoordd, gl.EdgeFlag, gl.Indexf, gl.Indexd, gl.Indexi);
  pour(gl.MultiTexCoord4f, {{GL_TEXTURE0, GL_TEXTURE1, GL_TEXTURE7, GL_TEXTURE0 + 8}});
  pour(gl.Materialf, {faces, {GL_SHININESS}});
  pour(gl.Materiali, {faces, {GL_SHININESS}});
  pour(gl.Materialfv, {faces, material_parameters});
  pour(gl.Materialiv, {faces, material_parameters});
}

void BadInput::list_commands() {
  list_vertex_commands();
  vertex_commands_ = commands_;

  for (int i = 0; i < 20; ++i) commands_.push_back([this] { draw_primitive(); });
  pour(gl.Begin, {modes});
  pour(gl.Enable, {capabilities});
  pour(gl.Enable, {capabilities});
  pour(gl.Disable, {capabilities});
  pour(gl.IsEnabled, {capabilities});
  pour_all(gl.End, gl.Flush, gl.Finish, gl.LoadIdentity, gl.PushMatrix, gl.PopMatrix, gl.GetError);
  pour_all(gl.LoadMatrixf, gl.LoadMatrixd, gl.MultMatrixf, gl.MultMatrixd, gl.LoadTransposeMatrixf,
           gl.LoadTransposeMatrixd, gl.MultTransposeMatrixf, gl.MultTransposeMatrixd, gl.Rotatef, gl.Rotated,
           gl.Translatef, gl.Translated, gl.Scalef, gl.Scaled, gl.Frustum, gl.Ortho);
  for (int i = 0; i < 10; ++i) commands_.push_back([this] { gl.LoadIdentity(); });
  pour(gl.MatrixMode, {matrix_modes});
  pour(gl.ActiveTexture, {{GL_TEXTURE0, GL_TEXTURE1}});
  pour(gl.Lightf, {lights, light_parameters});
  pour(gl.Lighti, {lights, light_parameters});
  pour(gl.Lightfv, {lights, light_parameters});
  pour(gl.Lightiv, {lights, light_parameters});
  pour(gl.GetLightfv, {lights, light_parameters});
  pour(gl.GetLightiv, {lights, light_parameters});
  pour(gl.LightModelf, {model_parameters});
  pour(gl.LightModeli, {model_parameters});
  pour(gl.LightModelfv, {model_parameters});
  pour(gl.LightModeliv, {model_parameters});
  pour(gl.GetMaterialfv, {{GL_FRONT, GL_BACK}, material_parameters});
  pour(gl.GetMaterialiv, {{GL_FRONT, GL_BACK}, material_parameters});
  pour(gl.ColorMaterial, {faces, material_parameters});
  pour(gl.ShadeModel, {{GL_FLAT, GL_SMOOTH}});
  pour(gl.FrontFace, {{GL_CW, GL_CCW}});
  pour(gl.CullFace, {faces});
  pour(gl.PolygonMode, {faces, {GL_POINT, GL_LINE, GL_FILL}});
  pour(gl.DepthFunc, {comparisons});
  pour_all(gl.PointSize, gl.LineWidth, gl.Viewport, gl.DepthRange, gl.Scissor, gl.DepthMask, gl.ColorMask,
           gl.StencilMask, gl.IndexMask, gl.ClearColor, gl.ClearDepth, gl.ClearStencil, gl.ClearIndex);
  commands_.push_back([this] { gl.Viewport(0, 0, width, height); });
  pour(gl.Clear, {{GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT, GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT}});
  pour(gl.Hint, {{GL_PERSPECTIVE_CORRECTION_HINT, GL_FOG_HINT}, {GL_NICEST, GL_FASTEST}});
  pour(gl.PixelStoref, {{GL_PACK_SKIP_ROWS, GL_UNPACK_ALIGNMENT, GL_PACK_SWAP_BYTES, GL_PACK_ROW_LENGTH}});
  pour(gl.PixelStorei, {{GL_PACK_SKIP_ROWS, GL_UNPACK_ALIGNMENT, GL_PACK_SWAP_BYTES, GL_PACK_ROW_LENGTH}});
  pour(gl.GetFloatv, {queries});
  pour(gl.GetIntegerv, {queries});
  pour(gl.GetDoublev, {queries});
  pour(gl.GetBooleanv, {queries});
  pour(gl.GetString, {{GL_VENDOR, GL_RENDERER, GL_VERSION, GL_EXTENSIONS}});
  // ReadPixels writes as many bytes as its arguments say: within the rectangle of the target, but anywhere.
  commands_.push_back([this] {
    for (const GLenum pname : {GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_ROW_LENGTH}) gl.PixelStorei(pname, 0);
    std::vector<float> pixels(4 * 40 * 40);
    const GLsizei w = static_cast<GLsizei>(random(41)), h = static_cast<GLsizei>(random(41));
    gl.ReadPixels(number<GLint>(), number<GLint>(), w, h,
                  any_of(Enums{GL_RGBA, GL_RGB, GL_DEPTH_COMPONENT, GL_LUMINANCE}),
                  any_of(Enums{GL_UNSIGNED_BYTE, GL_FLOAT, GL_UNSIGNED_INT}), pixels.data());
  });
}

// A whole primitive of ten modes, its attributes changed between vertices.
void BadInput::draw_primitive() {
  gl.End();
  gl.Begin(any_of(modes));
  for (int i = static_cast<int>(random(12)); i > 0; --i) {
    any_of(vertex_commands_)();
    gl.Vertex4f(number<GLfloat>(), number<GLfloat>(), number<GLfloat>(), random(3) == 0 ? number<GLfloat>() : 1.0f);
  }
  if (random(20) != 0) gl.End();
}

void BadInput::run(int rounds) {
  for (int i = 0; i < rounds; ++i) any_of(commands_)();
  gl.End();
  gl.Finish();
}

TEST_F(BadInput, HarmsNoTargetOfAnyFormat) {
  struct Target {
    GLenum type;
    int depth_bits, stencil_bits;
  };
  for (const Target target : {Target{GL_UNSIGNED_BYTE, 24, 8}, Target{GL_UNSIGNED_BYTE, 0, 0},
                              Target{GL_UNSIGNED_SHORT, 16, 0}, Target{GL_FLOAT, 24, 0}, Target{GL_FLOAT, 32, 8}}) {
    const OwnedContext context = make_context(ours(), OSMESA_RGBA, target.depth_bits, target.stencil_bits);
    std::vector<float> pixels(width * height * 4);
    ASSERT_TRUE(ours().MakeCurrent(context.get(), pixels.data(), target.type, width, height));
    run(60000);
    if (target.type == GL_FLOAT) {
      for (const float value : pixels) ASSERT_TRUE(value >= 0.0f && value <= 1.0f) << value;
    }
  }
}

TEST_F(BadInput, WithoutAContextDoesNothing) {
  run(20000);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

// What a program can do to its context is undone by another context: nothing leaks from one to the next.
TEST_F(BadInput, LeavesTheNextContextWhole) {
  const auto picture_of = [&](bool after_pouring) {
    std::vector<std::uint32_t> pixels(width * height), others(width * height);
    const OwnedContext spoilt = make_context(ours()), context = make_context(ours());
    if (after_pouring) {
      ours().MakeCurrent(spoilt.get(), others.data(), GL_UNSIGNED_BYTE, width, height);
      run(5000);
    }
    ours().MakeCurrent(context.get(), pixels.data(), GL_UNSIGNED_BYTE, width, height);
    gl.Enable(GL_DEPTH_TEST);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Begin(GL_TRIANGLES);
    for (const auto& [x, y] : {std::pair{-0.9f, -0.8f}, std::pair{0.8f, -0.7f}, std::pair{0.1f, 0.9f}}) {
      gl.Color3f(x, y, 1.0f);
      gl.Vertex3f(x, y, x);
    }
    gl.End();
    gl.Finish();
    return pixels;
  };
  EXPECT_EQ(picture_of(true), picture_of(false));
}

}  // namespace
}  // namespace gouraud::api::testing
