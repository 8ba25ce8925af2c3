// Numbers: denormals under flush-to-zero, NaN and infinity in every float of every command, ten thousand rotations.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "conformance/stability/sweeps.h"
#include "gl_commands.h"

namespace gouraud::stability {
namespace {

using conformance::clear_background;

constexpr int width = 96, height = 72;

/// Sets how the processor computes, as a program may have done, until it is destroyed. Bit 0 of `mode`: denormal results
/// are flushed to zero; bit 1: denormal operands are; bit 2: rounds down.
class FloatMode {
 public:
#if defined(__x86_64__)
  explicit FloatMode(int mode) : before_(_mm_getcsr()) {
    constexpr unsigned flush_results = 0x8000, flush_operands = 0x0040, round_down = 0x2000;
    _mm_setcsr(before_ | ((mode & 1) != 0 ? flush_results : 0) | ((mode & 2) != 0 ? flush_operands : 0) |
                ((mode & 4) != 0 ? round_down : 0));
  }
  ~FloatMode() { _mm_setcsr(before_); }
#else
  explicit FloatMode(int) {}
  ~FloatMode() = default;
#endif
  FloatMode(const FloatMode&) = delete;
  FloatMode& operator=(const FloatMode&) = delete;

 private:
#if defined(__x86_64__)
  unsigned before_;
#endif
};

Drawing flushed_ball(const GlTable& gl, double knob, float scale) {
  conformance::black_lighting(gl, 1);
  gl.Enable(GL_NORMALIZE);
  gl.Enable(GL_DEPTH_TEST);
  probes::project(gl, conformance::perspective(40, static_cast<float>(width) / height, 1, 20), width, height);
  conformance::load_model_view(gl, conformance::translation(0, 0, -4));
  conformance::light(gl, GL_LIGHT0, GL_POSITION, {2, 3, 4, 1});
  conformance::light(gl, GL_LIGHT0, GL_DIFFUSE, {0.9f, 0.8f, 0.7f, 1});
  conformance::light(gl, GL_LIGHT0, GL_SPECULAR, {0.9f, 0.8f, 0.7f, 1});
  conformance::material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, {0.4f, 0.5f, 0.7f, 1});
  conformance::material(gl, GL_FRONT_AND_BACK, GL_SPECULAR, {0.5f, 0.5f, 0.5f, 1});
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 100);
  return {[mode = static_cast<int>(knob), scale, mesh = conformance::sphere(1.2f / scale, 21, 31)](const GlTable& table) {
    const FloatMode floats(mode);
    conformance::load_model_view(table, conformance::multiply(conformance::translation(0, 0, -4), conformance::scaling(scale, scale, scale)));
    clear_background(table);
    draw_surface(table, mesh);
    table.Finish();
  }};
}
Drawing flushed_ordinary(const GlTable& gl, double knob) { return flushed_ball(gl, knob, 1); }
/// Coordinates around 10^-38, about half of which are denormal.
Drawing flushed_denormal(const GlTable& gl, double knob) { return flushed_ball(gl, knob, 1e38f); }

double differing_percent(const Observed& observed) {
  const conformance::Picture &now = *observed.answer.picture, &first = *observed.first.picture;
  int differing = 0;
  for (std::size_t i = 0; i < now.pixel_count(); ++i) {
    const bool same = std::memcmp(&now.rgba[4 * i], &first.rgba[4 * i], 4) == 0 && now.depth[i] == first.depth[i];
    differing += same ? 0 : 1;
  }
  return 100.0 * differing / static_cast<double>(now.pixel_count());
}

constexpr std::array bad_values{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                                -std::numeric_limits<double>::infinity(), 3.4e38, -3.4e38, 1e-45};

// Where a command takes an enum, what it may be; each is tried, and most are refused.
constexpr std::array<GLenum, 40> enums{
    GL_LIGHT0, GL_FRONT, GL_FRONT_AND_BACK, GL_TEXTURE_2D, GL_TEXTURE_ENV, GL_S, GL_Q, GL_FOG_DENSITY, GL_FOG_START, GL_FOG_END,
    GL_FOG_COLOR, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_SPOT_DIRECTION, GL_SPOT_EXPONENT, GL_SPOT_CUTOFF,
    GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION, GL_EMISSION, GL_SHININESS, GL_LIGHT_MODEL_AMBIENT,
    GL_TEXTURE_MIN_LOD, GL_TEXTURE_LOD_BIAS, GL_TEXTURE_PRIORITY, GL_TEXTURE_BORDER_COLOR, GL_TEXTURE_ENV_COLOR, GL_OBJECT_PLANE,
    GL_EYE_PLANE, GL_CLIP_PLANE0, GL_POINT_SIZE_MIN, GL_POINT_DISTANCE_ATTENUATION, GL_GREATER, GL_TEXTURE1, GL_RED_SCALE,
    GL_MAP1_VERTEX_3, GL_MAP2_COLOR_4, GL_ACCUM};

bool takes_floats(const CommandRow& row) {
  const std::string_view name(row.name), parameters(row.parameters);
  if (name.starts_with("Get") || name.starts_with("Prioritize") || name.starts_with("Feedback")) return false;
  if (parameters.find('f') != parameters.npos || parameters.find('d') != parameters.npos) return true;
  const bool has_array = parameters.find('p') != parameters.npos;
  return has_array && (name.ends_with("fv") || name.ends_with("dv") || name.find("Matrix") != name.npos || name == "ClipPlane");
}

/// Every command that takes floats, with the bad value in each of them and in all, for each enum that fits.
class Storm {
 public:
  Storm(const GlTable& gl, double bad) : gl_(gl), bad_(bad), floats_(256, static_cast<float>(bad)), doubles_(256, bad) {}

  void run() {
    for (const CommandRow& row : command_rows()) {
      if (takes_floats(row)) try_enums(row, 0);
    }
  }
  double calls() const { return calls_; }

 private:
  void try_enums(const CommandRow& row, std::size_t parameter) {
    const char kind = row.parameters[parameter];
    if (kind == '\0') {
      try_floats(row);
    } else if (kind == 'e') {
      for (const GLenum value : enums) {
        arguments_[parameter] = CommandArgument(static_cast<double>(value));
        try_enums(row, parameter + 1);
      }
    } else {
      arguments_[parameter] = harmless(row, kind);
      try_enums(row, parameter + 1);
    }
  }

  CommandArgument harmless(const CommandRow& row, char kind) {
    const bool wants_doubles = std::string_view(row.name).find('d') != std::string_view::npos || std::string_view(row.name) == "ClipPlane";
    switch (kind) {
      case 'p': return {wants_doubles ? static_cast<void*>(doubles_.data()) : static_cast<void*>(floats_.data())};
      case 'f':
      case 'd': return {0.5};
      default: return {2.0};
    }
  }

  void try_floats(const CommandRow& row) {
    const std::string_view parameters(row.parameters);
    gl_.PushAttrib(GL_ALL_ATTRIB_BITS);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i] != 'f' && parameters[i] != 'd') continue;
      const CommandArgument before = arguments_[i];
      arguments_[i] = CommandArgument(bad_);
      call(row);
      arguments_[i] = before;
    }
    std::array<CommandArgument, 16> all = arguments_;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i] == 'f' || parameters[i] == 'd') arguments_[i] = CommandArgument(bad_);
    }
    if (call(row)) draw(row);
    arguments_ = all;
    gl_.PopAttrib();
    gl_.LoadIdentity();
  }

  bool call(const CommandRow& row) {
    ++calls_;
    row.call(gl_, arguments_.data());
    return gl_.GetError() == GL_NO_ERROR;
  }

  /// With what the command has left behind, and, where it may be, with the command before each vertex.
  void draw(const CommandRow& row) {
    gl_.Begin(GL_TRIANGLES);
    for (const auto& [x, y] : {std::array{-0.9f, -0.8f}, {0.8f, -0.9f}, {0.1f, 0.9f}}) {
      if (row.legal_inside_begin_end) row.call(gl_, arguments_.data());
      gl_.Normal3f(x, y, 1);
      gl_.TexCoord2f(x, y);
      gl_.Vertex3f(x, y, 0.2f);
    }
    gl_.End();
    gl_.Finish();
    while (gl_.GetError() != GL_NO_ERROR) {
    }
  }

  const GlTable& gl_;
  double bad_, calls_ = 0;
  std::vector<float> floats_;
  std::vector<double> doubles_;
  std::array<CommandArgument, 16> arguments_;
};

Drawing storm(const GlTable& gl, double knob) {
  for (const GLenum capability : {GL_LIGHTING, GL_LIGHT0, GL_FOG, GL_DEPTH_TEST, GL_NORMALIZE, GL_BLEND, GL_ALPHA_TEST, GL_TEXTURE_2D,
                                  GL_POLYGON_OFFSET_FILL, GL_SCISSOR_TEST}) {
    gl.Enable(capability);
  }
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  constexpr std::array<std::uint8_t, 4> texel{200, 100, 50, 255};
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
  auto calls = std::make_shared<double>(0);
  return {[bad = bad_values[static_cast<std::size_t>(knob)], calls](const GlTable& table) {
            Storm all(table, bad);
            all.run();
            *calls = all.calls();
            table.Disable(GL_SCISSOR_TEST);
            table.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
            table.ClearColor(0, 1, 0, 1);
            table.Clear(GL_COLOR_BUFFER_BIT);
          },
          [calls](const GlTable&) { return std::vector<double>{*calls}; }};
}

/// Whether the context still clears as it is told to.
double wrong_clear_percent(const Observed& observed) {
  const conformance::Picture& picture = *observed.answer.picture;
  int wrong = 0;
  for (std::size_t i = 0; i < picture.pixel_count(); ++i) wrong += picture.rgba[4 * i] != 0 || picture.rgba[4 * i + 1] != 255 ? 1 : 0;
  return 100.0 * wrong / static_cast<double>(picture.pixel_count());
}
double calls_made(const Observed& observed) { return observed.answer.numbers.at(0); }

constexpr double step_deg = 7.3;

/// `knob` rotations multiplied onto each other, in a stack of 16 matrices that is pushed and popped meanwhile.
Drawing rotations(const GlTable& gl, double knob) {
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  return {[count = static_cast<int>(knob)](const GlTable& table) {
            for (int i = 0; i < count; ++i) {
              table.Rotatef(static_cast<float>(step_deg), 1, 2, 2);
              if (i % 16 == 15) table.PushMatrix();
              if (i % 256 == 255) {
                for (int k = 0; k < 16; ++k) {
                  std::array<float, 16> matrix;
                  table.GetFloatv(GL_MODELVIEW_MATRIX, matrix.data());
                  table.PopMatrix();
                  table.LoadMatrixf(matrix.data());
                }
              }
            }
            clear_background(table);
          },
          [](const GlTable& table) {
            std::array<double, 16> matrix;
            table.GetDoublev(GL_MODELVIEW_MATRIX, matrix.data());
            return std::vector<double>(matrix.begin(), matrix.end());
          }};
}

/// The largest element of M^T M - 1.
double skew(const Observed& observed) {
  const std::vector<double>& m = observed.answer.numbers;
  double worst = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      double dot = 0;
      for (std::size_t k = 0; k < 3; ++k) dot += m[4 * a + k] * m[4 * b + k];
      worst = std::max(worst, std::abs(dot - (a == b ? 1 : 0)));
    }
  }
  return worst;
}

/// The largest element of M less the rotation by all angles at once: Rodrigues' formula in double.
double drift(const Observed& observed) {
  const double angle = std::fmod(observed.knob * static_cast<double>(static_cast<float>(step_deg)), 360.0) * 3.14159265358979323846 / 180;
  const std::array<double, 3> axis{1.0 / 3, 2.0 / 3, 2.0 / 3};
  const double c = std::cos(angle), s = std::sin(angle);
  double worst = 0;
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      double exact = axis[row] * axis[column] * (1 - c) + (row == column ? c : 0);
      if ((row + 1) % 3 == column) exact -= s * axis[(column + 1) % 3];
      if ((column + 1) % 3 == row) exact += s * axis[(row + 1) % 3];
      worst = std::max(worst, std::abs(observed.answer.numbers[4 * column + row] - exact));
    }
  }
  return worst;
}

}  // namespace

std::vector<Sweep> number_sweeps() {
  const SweepMeasure differs{"differs", "pixels that differ from the picture without flushing, %", differing_percent};
  return {
      {{"float_mode", "a lit ball, drawn while the processor flushes denormals or rounds down", width, height, flushed_ordinary},
       "1 flushes results, 2 operands, 3 both, 4 rounds down",
       {0, 1, 2, 3, 4, 7},
       {differs},
       {{"default", "differs", 0, 7, 0.0}}},
      {{"float_mode_denormal", "the same ball of coordinates around 10^-38", width, height, flushed_denormal},
       "1 flushes results, 2 operands, 3 both, 4 rounds down",
       {0, 1, 2, 3, 4, 7},
       {differs},
       {{"default", "differs", 0, 7, 0.0}}},
      {{"bad_numbers", "NaN, infinity and the extremes in every float of every command", width, height, storm},
       "0 NaN, 1 and 2 infinite, 3 and 4 largest, 5 smallest",
       {0, 1, 2, 3, 4, 5},
       {{"clear", "pixels that do not clear afterwards, %", wrong_clear_percent}, {"calls", "calls survived", calls_made}},
       {{"default", "clear", 0, 5, 0.0}, {"default", "calls", 0, 5, {}, 5000, "every command was tried"}},
       SweepReference::none,
       {},
       [](double knob) { return knob; },
       false},
      {{"rotations", "rotations by 7.3 degrees multiplied onto each other", width, height, rotations},
       "rotations",
       {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000},
       {{"skew", "largest element of M^T M - 1", skew}, {"drift", "largest element of M less the exact rotation", drift}},
       {{"default", "skew", 1, 10000, 1e-3}, {"default", "drift", 1, 10000, 1e-2}},
       SweepReference::none,
       {},
       [](double knob) { return knob; },
       true,
       true,
       1e-9},
  };
}

}  // namespace gouraud::stability
