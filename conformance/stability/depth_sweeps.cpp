// Depth: how far apart near and far may be for a format, what no order of drawing can show, and decals.
#include <array>
#include <cmath>

#include "conformance/stability/sweeps.h"

namespace gouraud::stability {
namespace {

using conformance::clear_background;

constexpr int width = 160, height = 120;

struct Range {
  float near, far, distance;
};

/// Two walls, the first a thousandth of its distance before the second, at an eighth of the far plane's.
Range range_of(double knob) {
  const double far = std::pow(10.0, knob);
  return {1, static_cast<float>(far), static_cast<float>(far / 8)};
}

/// The wall behind comes first, so that the one before it must win.
void draw_walls(const GlTable& gl, float distance) {
  for (const float behind : {1.001f, 1.0f}) {
    if (behind > 1) {
      gl.Color3f(0.9f, 0.2f, 0.1f);
    } else {
      gl.Color3f(0.1f, 0.3f, 0.9f);
    }
    gl.Begin(GL_TRIANGLE_STRIP);
    const float half = 1.3f * distance * behind;  // over all of the window
    // Slanted, so that their depths take many values.
    for (const auto& [x, y] : {std::array{-1.0f, -1.0f}, {1.0f, -1.0f}, {-1.0f, 1.0f}, {1.0f, 1.0f}}) {
      const float slant = 1 + 0.1f * x + 0.05f * y;
      gl.Vertex3f(x * half * slant, y * half * slant, -distance * behind * slant);
    }
    gl.End();
  }
}

Drawing walls(const GlTable& gl, double knob) {
  const Range range = range_of(knob);
  gl.Enable(GL_DEPTH_TEST);
  probes::project(gl, conformance::perspective(60, static_cast<float>(width) / height, range.near, range.far), width, height);
  return {[range](const GlTable& table) {
    clear_background(table);
    draw_walls(table, range.distance);
  }};
}

/// The walls in a framebuffer object with 32-bit float depth [ARB_depth_buffer_float]; the picture is copied over.
Drawing float_walls(const GlTable& gl, double knob, bool reversed) {
  const Range range = range_of(knob);
  gl.Enable(GL_DEPTH_TEST);
  conformance::Matrix matrix = conformance::perspective(60, static_cast<float>(width) / height, range.near, range.far);
  if (reversed) {
    // Far goes to 0, near to 1, and clip space keeps it so [ARB_clip_control].
    gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    const double near = range.near, far = range.far;
    matrix[10] = static_cast<float>(near / (far - near));
    matrix[14] = static_cast<float>(far * near / (far - near));
    gl.DepthFunc(GL_GREATER);
    gl.ClearDepth(0);
  }
  probes::project(gl, matrix, width, height);
  GLuint framebuffer = 0;
  std::array<GLuint, 2> buffers{};
  gl.GenFramebuffers(1, &framebuffer);
  gl.GenRenderbuffers(2, buffers.data());
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.BindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
  gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
  gl.BindRenderbuffer(GL_RENDERBUFFER, buffers[1]);
  gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffers[1]);
  return {[range, framebuffer](const GlTable& table) {
    table.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    clear_background(table);
    draw_walls(table, range.distance);
    table.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    table.BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    table.BindFramebuffer(GL_FRAMEBUFFER, 0);
  }};
}
Drawing float_walls(const GlTable& gl, double knob) { return float_walls(gl, knob, false); }
Drawing reversed_walls(const GlTable& gl, double knob) { return float_walls(gl, knob, true); }

/// % of the picture that does not show the wall in front.
double lost_wall_percent(const Observed& observed) {
  const conformance::Picture& picture = *observed.answer.picture;
  int lost = 0;
  for (std::size_t i = 0; i < picture.pixel_count(); ++i) lost += picture.rgba[4 * i + 2] < 200 ? 1 : 0;
  return 100.0 * lost / static_cast<double>(picture.pixel_count());
}

/// Three bars about a centre; tilted, each passes over the next and under the one before.
Drawing cycle(const GlTable& gl, double knob) {
  gl.Enable(GL_DEPTH_TEST);
  return {[tilt = static_cast<float>(knob)](const GlTable& table) {
    clear_background(table);
    constexpr std::array<std::array<float, 3>, 3> colors{{{0.9f, 0.2f, 0.2f}, {0.2f, 0.9f, 0.2f}, {0.3f, 0.3f, 0.9f}}};
    for (std::size_t bar = 0; bar < 3; ++bar) {
      const double angle = 2.0943951 * static_cast<double>(bar);
      // Without tilt the bars lie in three planes of their own.
      const float depth = 0.2f * (static_cast<float>(bar) - 1) * (1 - tilt);
      table.Color3fv(colors[bar].data());
      table.Begin(GL_TRIANGLE_STRIP);
      for (const auto& [x, y] : {std::array{-0.8f, -0.45f}, {-0.8f, -0.2f}, {0.8f, -0.45f}, {0.8f, -0.2f}}) {
        table.Vertex3f(static_cast<float>(x * std::cos(angle) - y * std::sin(angle)),
                       static_cast<float>(x * std::sin(angle) + y * std::cos(angle)), depth + 0.5f * tilt * x);
      }
      table.End();
    }
  }};
}

/// Cards in the plane of a board that leans by `knob` degrees, with polygon offset or without it.
Drawing decals(const GlTable& gl, double knob, float factor, float units) {
  gl.Enable(GL_DEPTH_TEST);
  probes::project(gl, conformance::perspective(40, static_cast<float>(width) / height, 1, 30), width, height);
  conformance::load_model_view(gl, conformance::multiply(conformance::translation(0, 0, -5), conformance::rotation(static_cast<float>(-knob), 0)));
  return {[factor, units](const GlTable& table) {
    clear_background(table);
    const auto card = [&](float x, float y, float half_x, float half_y) {
      table.Begin(GL_TRIANGLE_FAN);
      table.Vertex2f(x - half_x, y - half_y);
      table.Vertex2f(x + half_x, y - 0.9f * half_y);
      table.Vertex2f(x + 0.9f * half_x, y + half_y);
      table.Vertex2f(x - 0.8f * half_x, y + half_y);
      table.End();
    };
    table.PolygonOffset(factor, units);
    table.Color3f(0.9f, 0.2f, 0.1f);
    table.Disable(GL_POLYGON_OFFSET_FILL);
    card(0, 0, 2.2f, 1.7f);
    table.Color3f(0.1f, 0.3f, 0.9f);
    table.Enable(GL_POLYGON_OFFSET_FILL);
    for (int i = 0; i < 15; ++i) card(static_cast<float>(i % 5) * 0.7f - 1.4f, static_cast<float>(i / 5) * 0.8f - 0.8f, 0.3f, 0.35f);
    table.Disable(GL_POLYGON_OFFSET_FILL);
  }};
}
Drawing offset_decals(const GlTable& gl, double knob) { return decals(gl, knob, -1, -1); }
Drawing bare_decals(const GlTable& gl, double knob) { return decals(gl, knob, 0, 0); }
/// The reference: with an offset that is beyond doubt.
Drawing lifted_decals(const GlTable& gl, double knob) {
  return knob >= 1000 ? decals(gl, knob - 1000, -4, -400) : offset_decals(gl, knob);
}
Drawing lifted_bare_decals(const GlTable& gl, double knob) {
  return knob >= 1000 ? decals(gl, knob - 1000, -4, -400) : bare_decals(gl, knob);
}

constexpr std::string_view ratio_label = "log10 of far / near";
const std::vector<double> ratios{1.5, 2, 2.5, 3, 3.5, 4, 4.5, 5, 5.5, 6, 6.5, 7, 8, 9, 10, 12, 14};
const std::vector<double> slopes{0, 10, 20, 30, 40, 50, 60, 70, 75, 80, 83, 85, 86, 87, 88};

Sweep wall_sweep(std::string_view name, std::string_view shows, Drawing (*setup)(const GlTable&, double), int depth_bits,
                 double holds_to, double fails_from, const std::vector<Expectation>& of_methods = {}) {
  Sweep sweep{{name, shows, width, height, setup, depth_bits},
          ratio_label,
          ratios,
          {{"lost", "pixels where the wall in front loses, %", lost_wall_percent}},
          {{"default", "lost", 1.5, holds_to, 0.0},
           {"default", "lost", fails_from, 14, {}, 1.0, "a step of the depth buffer is there more than the walls' distance"}},
          SweepReference::none,
          {"depth"}};
  sweep.expectations.insert(sweep.expectations.end(), of_methods.begin(), of_methods.end());
  return sweep;
}

Sweep decal_sweep(std::string_view name, std::string_view shows, Drawing (*setup)(const GlTable&, double), Expectation expectation) {
  return {{name, shows, width, height, setup},
          "lean of the board, degrees",
          slopes,
          {{"wrong", "pixels that show the wrong surface, %", wrong_surface_percent}},
          {expectation},
          SweepReference::house,
          {"depth", "coverage"},
          [](double knob) { return knob + 1000; }};
}

}  // namespace

std::vector<Sweep> depth_sweeps() {
  return {
      // A step of n bits at distance z is about z^2 / (near 2^n): more than z / 1000 from z = near 2^n / 1000 on.
      wall_sweep("depth_16_bits", "two walls a thousandth apart, 16 bits of depth", walls, 16, 2, 3.5),
      wall_sweep("depth_24_bits", "two walls a thousandth apart, 24 bits of depth", walls, 24, 4.5, 6,
                 {{"depth=z16", "lost", 3, 14, {}, 10.0, "a step of 16 bits"},
                  {"depth=z24", "lost", 1.5, 4.5, 0.0},
                  {"depth=z32", "lost", 1.5, 5, 0.0},  // finer than a float vertex, whose depths near 1 have 24 bits
                  {"depth=z32", "lost", 6, 6.5, {}, 1.0, "vertices bring floats"},
                  {"depth=float", "lost", 1.5, 4.5, 0.0},
                  {"depth=float", "lost", 6, 6.5, {}, 10.0, "a float near 1 has steps of 2^-24"},
                  {"depth=reversed", "lost", 1.5, 14, 0.0}}),
      wall_sweep("depth_float", "two walls a thousandth apart, 32-bit float depth", float_walls, 24, 4, 6.5),
      {{"depth_float_reversed", "two walls a thousandth apart, float depth, near at 1 and far at 0", width, height, reversed_walls},
       ratio_label,
       ratios,
       {{"lost", "pixels where the wall in front loses, %", lost_wall_percent}},
       {{"default", "lost", 1.5, 14, 0.0}},
       SweepReference::none,
       {"depth"}},
      {{"cycles", "three bars, from planes of their own to each over the next", width, height, cycle},
       "tilt",
       {0, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 1},
       {{"wrong", "pixels that show the wrong surface, %", wrong_surface_percent}},
       {{"default", "wrong", 0, 1, 0.0},
        {"depth=painter", "wrong", 0.8, 1, {}, 1.0, "no order of three triangles shows a cycle"}},
       SweepReference::house,
       {"depth"}},
      decal_sweep("decals_with_offset", "cards in the plane of a leaning board, glPolygonOffset(-1, -1)", lifted_decals,
                  {"default", "wrong", 0, 86, 0.1}),
      decal_sweep("decals_without_offset", "cards in the plane of a leaning board, no offset", lifted_bare_decals,
                  {"default", "wrong", 0, 88, {}, 5.0, "two triangulations of one plane round their depths differently"}),
  };
}

}  // namespace gouraud::stability
