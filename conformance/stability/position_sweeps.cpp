// Positions: the near plane, w = 0, coordinates beyond all reason, and steps across 16,384 pixels.
#include <algorithm>
#include <array>
#include <cmath>

#include "conformance/stability/sweeps.h"

namespace gouraud::stability {
namespace {

using conformance::clear_background;

constexpr int width = 200, height = 150;

void triangle(const GlTable& gl, const std::array<std::array<float, 4>, 3>& corners) {
  constexpr std::array<std::array<float, 3>, 3> colors{{{0.9f, 0.2f, 0.1f}, {0.1f, 0.8f, 0.3f}, {0.2f, 0.3f, 0.9f}}};
  gl.Begin(GL_TRIANGLES);
  for (std::size_t i = 0; i < 3; ++i) {
    gl.Color3fv(colors[i].data());
    gl.Vertex4fv(corners[i].data());
  }
  gl.End();
}

/// A floor through the eye's plane, cut by a near plane at 10^-knob.
Drawing near_plane(const GlTable& gl, double knob) {
  const auto near = static_cast<float>(std::pow(10.0, -knob));
  probes::project(gl, conformance::perspective(60, static_cast<float>(width) / height, near, 100), width, height);
  return {[](const GlTable& table) {
    clear_background(table);
    triangle(table, {{{-4, -1, 3, 1}, {5, -1.2f, 2, 1}, {0.5f, -1, -60, 1}}});
  }};
}

/// A corner whose w goes through 0 to behind the eye; coordinates are clip coordinates.
Drawing w_through_zero(const GlTable&, double knob) {
  return {[w = static_cast<float>(knob)](const GlTable& table) {
    clear_background(table);
    triangle(table, {{{-0.83f, -0.71f, 0, 1}, {0.77f, -0.63f, 0, 1}, {0.13f, 0.69f, 0, w}}});
  }};
}

/// Half of the window: below the line y = x / 2 in normalized device coordinates, of a triangle that goes 2^knob beyond.
Drawing huge_coordinates(const GlTable&, double knob) {
  return {[l = static_cast<float>(std::exp2(knob))](const GlTable& table) {
    clear_background(table);
    table.Begin(GL_TRIANGLES);
    table.Color3f(0.9f, 0.8f, 0.2f);
    table.Vertex2f(-l, -l / 2);
    table.Vertex2f(l, -l);
    table.Vertex2f(l, l / 2);
    table.End();
  }};
}

/// % of the pixels on the wrong side of that line; those within 1/256 pixel of it are free.
double wrong_half_percent(const Observed& observed) {
  const conformance::Picture& picture = *observed.answer.picture;
  int wrong = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double ndc_x = (2 * x + 1.0) / width - 1, ndc_y = (2 * y + 1.0) / height - 1;
      const double distance_px = (ndc_x / 2 - ndc_y) * height / 2;
      if (std::abs(distance_px) < 1.0 / 256) continue;
      const auto i = static_cast<std::size_t>(y * width + x);
      const bool drawn = picture.rgba[4 * i] > 150;  // the background's red is 64
      wrong += drawn != (distance_px > 0) ? 1 : 0;
    }
  }
  return 100.0 * wrong / (width * height);
}

constexpr int most_steps = 16384, step_rows = 8;

/// A ramp of colour and depth over `knob` pixels, as one rectangle of two triangles.
Drawing stepping(const GlTable& gl, double knob) {
  probes::project_pixels(gl, most_steps, step_rows);
  gl.Enable(GL_DEPTH_TEST);
  return {[end = static_cast<float>(knob)](const GlTable& table) {
    clear_background(table);
    table.Begin(GL_TRIANGLE_STRIP);
    for (const float x : {0.0f, end}) {
      const float shade = x > 0 ? 1.0f : 0.0f;
      table.Color3f(shade, 1 - shade, 0.5f);
      table.Vertex3f(x, 0, 2 * shade - 1);
      table.Vertex3f(x, step_rows, 2 * shade - 1);
    }
    table.End();
  }};
}

/// A wedge of `knob` pixels whose long edge rises by less than one row in a thousand pixels, if it is that long.
Drawing long_edge(const GlTable& gl, double knob) {
  probes::project_pixels(gl, most_steps, step_rows);
  return {[end = static_cast<float>(knob - 179 / 256.0)](const GlTable& table) {
    clear_background(table);
    table.Begin(GL_TRIANGLES);
    table.Color3f(0.9f, 0.8f, 0.2f);
    // On the grid of 1/256 pixel, so that snapping moves nothing and steps alone can err.
    table.Vertex2f(77 / 256.0f, 54 / 256.0f);
    table.Vertex2f(end, 2004 / 256.0f);
    table.Vertex2f(77 / 256.0f, 2004 / 256.0f);
    table.End();
  }};
}

}  // namespace

std::vector<Sweep> position_sweeps() {
  return {
      {{"near_plane", "a floor through the eye's plane, cut by the near plane", width, height, near_plane},
       "near plane at 10^-k: k",
       {0, 1, 2, 4, 6, 8, 12, 16, 20, 24, 28, 32, 36, 37, 38, 40, 42, 44},
       {{"coverage", "wrong coverage, % of the pixels drawn", coverage_percent},
        {"color", "mean colour error beyond rounding, 1/255", color_beyond_rounding}},
       {{"default", "coverage", 0, 44, 0.01},
        {"default", "color", 0, 44, 0.01},
        {"clipping=homogeneous", "coverage", 0, 44, 0.01},
        {"coverage=homogeneous", "color", 0, 44, 0.01},
        {"clipping=none", "coverage", 0, 44, {}, 50, "what lies behind the eye comes out before it, turned over"}},
       SweepReference::exact,
       {"clipping", "coverage"}},
      {{"w_through_zero", "a corner that goes through w = 0 to behind the eye", width, height, w_through_zero},
       "w of one corner",
       {-1, -0.5, -0.1, -1e-3, -1e-6, -1e-20, -1e-38, 0, 1e-38, 1e-20, 1e-6, 1e-3, 0.01, 0.1, 0.5, 1},
       {{"coverage", "wrong coverage, % of the pixels drawn", coverage_percent},
        {"color", "mean colour error beyond rounding, 1/255", color_beyond_rounding}},
       {{"default", "coverage", -1, 1, 0.01},
        {"default", "color", -1, 1, 0.01},
        {"clipping=none", "coverage", -1, 1e-20, {}, 10, "behind the eye the division turns the triangle over"}},
       SweepReference::exact,
       {"clipping", "coverage"}},
      {{"huge_coordinates", "half of the window, by a triangle 2^k times as large", width, height, huge_coordinates},
       "size 2^k windows: k",
       {2, 4, 8, 12, 16, 18, 20, 21, 22, 23, 24, 25, 26, 28, 32, 40, 64, 96, 125, 126},
       {{"wrong", "pixels on the wrong side of the edge, %", wrong_half_percent}},
       {{"default", "wrong", 2, 24, 0.01},
        {"clipping=homogeneous", "wrong", 2, 40, 0.01},
        {"clipping=none", "wrong", 8, 126, {}, 10, "window coordinates leave the range of integers"},
        {"default", "wrong", 25, 126, {}, 10, "a float has 24 bits: the clipper's point on an edge is off by 2^-25 of its length"}},
       SweepReference::none,
       {"clipping", "coverage"}},
      {{"stepping", "a ramp of colour and depth over many pixels", most_steps, step_rows, stepping},
       "pixels",
       powers(2, 0, 14),
       {{"color", "largest colour error, 1/255", color_max}, {"depth", "largest depth error, units of 24 bits", depth_max}},
       {{"default", "color", 1, most_steps, 0.55}, {"default", "depth", 1, most_steps, 0.75}},
       SweepReference::house,
       {"coverage", "colors", "depth"},
       [](double knob) { return knob; },
       true},
      {{"long_edge", "a wedge of many pixels whose edge hardly rises", most_steps, step_rows, long_edge},
       "pixels",
       powers(2, 2, 14),
       {{"coverage", "wrong coverage, % of the pixels drawn", coverage_percent}},
       {{"default", "coverage", 4, most_steps, 0.0},
        {"coverage=incremental", "coverage", 4, most_steps, 0.0},  // integers add up exactly
        {"coverage=barycentric,epsilon=0.01", "coverage", 32, most_steps, {}, 0.5, "a hundredth of the area is a strip of pixels"}},
       SweepReference::house,
       {"coverage"},
       [](double knob) { return knob; },
       true},
  };
}

}  // namespace gouraud::stability
