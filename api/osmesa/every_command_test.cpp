// Pours NaN, infinities, the largest numbers and enums of all kinds into every command that the registry knows, in
// random order, inside and outside of Begin/End and display lists, with draws in between: nothing may crash, read or
// write out of range, or compute what C++ does not define (ASan and UBSan watch).
//
// The sequence is the same in every run. What a command may legally read or write of the application's memory stays
// within what it is given: sizes and offsets are small, or so large that the command refuses them.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string_view>
#include <vector>

#include "api/osmesa/testing/drivers.h"
#include "gl_commands.h"

namespace gouraud::api::testing {
namespace {

constexpr std::size_t filled_bytes = 1 << 15;  // more than any call reads
constexpr int width = 70, height = 41;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double awkward[] = {0,     -0.0,  1,          -1,       0.5,       0.3,
                              2,     90,    128,        1e-45,    1e20,      1e38,
                              -1e38, 1e300, 16777216.5, infinite, -infinite, std::numeric_limits<double>::quiet_NaN()};
constexpr double awkward_integers[] = {0, 1, 2, 3, 4, 5, 7, 8, -1, -2, 2147483647, -2147483648.0};

// Commands that would do for long what they are told, or read what a pixel store of millions of rows makes them.
constexpr std::string_view bounded[] = {"EvalMesh1",     "EvalMesh2",    "PixelStorei",     "PixelStoref",
                                        "DrawArrays",    "ArrayElement", "ArrayElementEXT", "DrawArraysEXT",
                                        "LockArraysEXT", "PixelZoom"};

// Indices and counts stay below the size of the arrays; what is in buffers may be indices.
bool takes_counts(std::string_view name) {
  return name.find("Draw") != name.npos || name.find("Buffer") != name.npos || name.find("Delete") != name.npos;
}
bool may_be_null(std::string_view name) {
  if (name.starts_with("Get")) return false;
  return name.find("TexImage") != name.npos || name.find("Pointer") != name.npos ||
         name.find("BufferData") != name.npos || name.starts_with("DrawElements") || name == "InterleavedArrays" ||
         name.starts_with("DrawRangeElements");
}

bool is_one_of(std::string_view name, std::span<const std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

class EveryCommand : public ::testing::Test {
 protected:
  EveryCommand() {
    collect_enums();
    for (const CommandRow& row : command_rows()) {
      // Strings of names grow without bound in lists that call lists; the window of a window system is not tested here.
      if (row.name != std::string_view("CallList") && row.name != std::string_view("CallLists")) rows_.push_back(&row);
      if (row.legal_inside_begin_end) vertex_rows_.push_back(&row);
    }
    std::erase_if(vertex_rows_,
                  [](const CommandRow* row) { return std::string_view(row->name).starts_with("CallList"); });
  }

  std::uint32_t random(std::size_t below) { return static_cast<std::uint32_t>(engine_() % below); }

  // An enum of the GL's own ranges, most of the time one that some command has accepted before.
  GLenum random_enum() {
    switch (random(8)) {
      case 0:
        return static_cast<GLenum>(random(16));
      case 1:
        return 0x0B00 + random(0x400);
      case 2:
        return static_cast<GLenum>(engine_());
      default:
        return enums_[random(enums_.size())];
    }
  }

  CommandArgument argument(const CommandRow& row, char kind, bool reads_memory) {
    const bool is_bounded = reads_memory || is_one_of(row.name, bounded);
    switch (kind) {
      case 'p':
        return {may_be_null(row.name) && random(4) == 0 ? nullptr : static_cast<void*>(memory_.data())};
      case 'e':
        return {static_cast<double>(random_enum())};
      case 'm':
        return {static_cast<double>(random(2) == 0 ? random(0x200000) : engine_())};
      case 'b':
        return {static_cast<double>(random(2))};
      case 'f':
      case 'd':
        if (is_bounded || random(2) == 0) return {static_cast<double>(random(2001)) / 500.0 - 2.0};
        return {awkward[random(std::size(awkward))]};
      case 's':
        return {random(6) == 0 ? awkward_integers[random(std::size(awkward_integers) - 2)] : random(9)};
      case 'n':
        return {random(6) == 0 ? -1.0 : static_cast<double>(random(64))};
      default: {
        // Internal formats are integers.
        if (random(3) == 0 && std::strchr(row.parameters, 'e') != nullptr && !is_one_of(row.name, bounded) &&
            std::string_view(row.name).find("Tex") != std::string_view::npos) {
          return {static_cast<double>(random_enum())};
        }
        const std::size_t choices = std::size(awkward_integers) - (is_bounded ? 2 : 0);
        return {awkward_integers[random(choices)]};
      }
    }
  }

  // Learns the enums of the library by asking what is known: glGet and glIsEnabled accept them.
  void collect_enums() {
    enums_ = {GL_TRIANGLES,
              GL_QUADS,
              GL_POLYGON,
              GL_RGBA,
              GL_RGB,
              GL_LUMINANCE,
              GL_ALPHA,
              GL_DEPTH_COMPONENT,
              GL_COLOR_INDEX,
              GL_STENCIL_INDEX,
              GL_BGRA,
              GL_UNSIGNED_BYTE,
              GL_FLOAT,
              GL_SHORT,
              GL_INT,
              GL_UNSIGNED_INT,
              GL_UNSIGNED_SHORT,
              GL_UNSIGNED_SHORT_5_6_5,
              GL_UNSIGNED_INT_8_8_8_8,
              GL_BITMAP,
              GL_BYTE,
              GL_DOUBLE,
              GL_TEXTURE_1D,
              GL_TEXTURE_2D,
              GL_TEXTURE_3D,
              GL_TEXTURE_CUBE_MAP,
              GL_TEXTURE_CUBE_MAP_POSITIVE_X,
              GL_TEXTURE_CUBE_MAP_NEGATIVE_Z,
              GL_TEXTURE_RECTANGLE_ARB,
              GL_PROXY_TEXTURE_2D,
              GL_TEXTURE_ENV,
              GL_TEXTURE_FILTER_CONTROL,
              GL_POINT_SPRITE_ARB,
              GL_S,
              GL_T,
              GL_R,
              GL_Q,
              GL_COMBINE,
              GL_MODULATE,
              GL_DECAL,
              GL_REPLACE,
              GL_DOT3_RGB,
              GL_PREVIOUS,
              GL_CONSTANT,
              GL_NEAREST,
              GL_LINEAR,
              GL_LINEAR_MIPMAP_LINEAR,
              GL_CLAMP,
              GL_CLAMP_TO_BORDER,
              GL_CLAMP_TO_EDGE,
              GL_REPEAT,
              GL_MIRRORED_REPEAT,
              GL_SPHERE_MAP,
              GL_OBJECT_LINEAR,
              GL_EYE_LINEAR,
              GL_OBJECT_PLANE,
              GL_EYE_PLANE,
              GL_TEXTURE_GEN_MODE,
              GL_TEXTURE_ENV_MODE,
              GL_COLOR,
              GL_DEPTH,
              GL_STENCIL,
              GL_RENDER,
              GL_SELECT,
              GL_FEEDBACK,
              GL_3D_COLOR_TEXTURE,
              GL_COMPILE,
              GL_COMPILE_AND_EXECUTE,
              GL_ACCUM,
              GL_LOAD,
              GL_RETURN,
              GL_MULT,
              GL_ADD,
              GL_POINT,
              GL_LINE,
              GL_FILL,
              GL_ARRAY_BUFFER,
              GL_ELEMENT_ARRAY_BUFFER,
              GL_STATIC_DRAW,
              GL_READ_WRITE,
              GL_SAMPLES_PASSED,
              GL_QUERY_RESULT,
              GL_FRAMEBUFFER,
              GL_RENDERBUFFER,
              GL_COLOR_ATTACHMENT0,
              GL_DEPTH_ATTACHMENT,
              GL_COMPRESSED_RGB_S3TC_DXT1_EXT,
              GL_COMPRESSED_RGBA_S3TC_DXT5_EXT,
              GL_T2F_N3F_V3F,
              GL_LUMINANCE8_ALPHA8,
              GL_DEPTH24_STENCIL8,
              GL_DEPTH_STENCIL,
              GL_RGBA8,
              GL_INTENSITY,
              GL_LINEAR_ATTENUATION,
              GL_EXP2};
    const OwnedContext context = make_context(ours());
    std::vector<std::uint32_t> pixels(width * height);
    ours().MakeCurrent(context.get(), pixels.data(), GL_UNSIGNED_BYTE, width, height);
    for (GLenum name = 0; name < 0x9400; ++name) {
      GLdouble values[16];
      gl.GetDoublev(name, values);
      const bool is_value = gl.GetError() == GL_NO_ERROR;
      gl.IsEnabled(name);
      if (is_value || gl.GetError() == GL_NO_ERROR) enums_.push_back(name);
    }
  }

  // What pointers lead to: small integers, or the worst of floats, or any bytes. Arrays of pointers: nulls.
  void fill_memory(std::string_view name) {
    const std::uint32_t kind = name.starts_with("MultiDrawElements") ? 3 : takes_counts(name) ? 0 : random(3);
    for (std::size_t i = 0; i < filled_bytes; i += 4) {
      std::uint32_t word = kind == 0 ? random(9) : kind == 2 ? static_cast<std::uint32_t>(engine_()) : 0;
      if (kind == 1) {
        const CommandArgument value(awkward[random(std::size(awkward))]);
        const float number = value.as<float>();
        std::memcpy(&word, &number, 4);
      }
      std::memcpy(&memory_[i], &word, 4);
    }
  }

  void call(const CommandRow& row) {
    CommandArgument arguments[16];
    const bool reads_memory = std::strchr(row.parameters, 'p') != nullptr;
    if (reads_memory) fill_memory(row.name);
    for (std::size_t i = 0; row.parameters[i] != '\0'; ++i)
      arguments[i] = argument(row, row.parameters[i], reads_memory);
    row.call(gl, arguments);
  }

  void draw_primitive() {
    gl.End();
    gl.Begin(random(10));
    for (std::uint32_t i = random(12); i > 0; --i) {
      call(*vertex_rows_[random(vertex_rows_.size())]);
      gl.Vertex3f(static_cast<float>(random(200)) / 100 - 1, static_cast<float>(random(200)) / 100 - 1, 0.5f);
    }
    if (random(20) != 0) gl.End();
  }

  // Back to where pictures appear: a command that is obeyed once can hide all that follows.
  void recover() {
    gl.End();
    gl.EndList();
    gl.RenderMode(GL_RENDER);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.Viewport(0, 0, width, height);
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
    gl.Scissor(0, 0, width, height);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    for (GLuint list = 0; list < 4; ++list) gl.CallList(list);
    // Arrays of the application's memory end where it ends.
    gl.PopClientAttrib();
  }

  void run(int rounds) {
    for (int i = 0; i < rounds; ++i) {
      if (i % 100 == 0) recover();
      if (random(10) == 0) {
        draw_primitive();
      } else {
        call(*rows_[random(rows_.size())]);
      }
    }
    gl.End();
    gl.EndList();
    gl.Finish();
  }

  const GlTable& gl = ours().gl;
  std::mt19937 engine_{19920630};

 private:
  std::vector<std::uint8_t> memory_ = std::vector<std::uint8_t>(1 << 20);
  std::vector<GLenum> enums_;
  std::vector<const CommandRow*> rows_, vertex_rows_;
};

TEST_F(EveryCommand, TakesAnythingWithoutHarm) {
  for (const int rounds : {500, 2000, 5000, 11, 20000}) {
    engine_.seed(static_cast<unsigned>(rounds));
    const OwnedContext context = make_context(ours(), OSMESA_RGBA, 24, 8);
    std::vector<std::uint32_t> pixels(width * height);
    ASSERT_TRUE(ours().MakeCurrent(context.get(), pixels.data(), GL_UNSIGNED_BYTE, width, height));
    run(rounds);
  }
}

TEST_F(EveryCommand, WithoutAContextDoesNothing) {
  ours().MakeCurrent(nullptr, nullptr, 0, 0, 0);
  run(5000);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace gouraud::api::testing
