// Colours: what affine interpolation makes of perspective, what Gouraud loses of highlights, moire, and how much a format
// forgets over a thousand blends.
#include <array>
#include <cmath>

#include <GL/osmesa.h>

#include "conformance/stability/sweeps.h"

namespace gouraud::stability {
namespace {

using conformance::clear_background;

constexpr int width = 160, height = 120;

/// A rectangle on the screen whose right side is `knob` times as far away as its left.
Drawing perspective_slope(const GlTable& gl, double knob) {
  probes::project_pixels(gl, width, height);
  return {[w = static_cast<float>(knob)](const GlTable& table) {
    clear_background(table);
    table.Begin(GL_TRIANGLE_STRIP);
    for (const float side : {0.0f, 1.0f}) {
      const float depth = side > 0 ? w : 1;
      table.Color3f(side, 1 - side, 0.5f);
      for (const float y : {10.0f, 110.0f}) table.Vertex4f((10 + 140 * side) * depth, y * depth, 0, depth);
    }
    table.End();
  }};
}

Drawing lit_ball(const GlTable& gl, int stacks, float shininess, int cuts) {
  conformance::black_lighting(gl, 1);
  gl.Enable(GL_NORMALIZE);
  gl.Enable(GL_DEPTH_TEST);
  probes::project(gl, conformance::perspective(40, static_cast<float>(width) / height, 1, 20), width, height);
  conformance::load_model_view(gl, conformance::multiply(conformance::translation(0, 0, -4), conformance::rotation(33, 1)));
  conformance::light(gl, GL_LIGHT0, GL_POSITION, {3, 4, 6, 1});
  for (const GLenum term : {GL_DIFFUSE, GL_SPECULAR}) conformance::light(gl, GL_LIGHT0, term, {0.9f, 0.9f, 0.9f, 1});
  conformance::material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, {0.1f, 0.2f, 0.4f, 1});
  conformance::material(gl, GL_FRONT_AND_BACK, GL_SPECULAR, {0.8f, 0.8f, 0.8f, 1});
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, shininess);
  return {[ball = conformance::sphere(1.2f, stacks, 3 * stacks / 2), cuts](const GlTable& table) {
    clear_background(table);
    conformance::draw_cut_surface(table, ball, cuts);
  }};
}

Drawing tessellation(const GlTable& gl, double knob) {
  const int stacks = static_cast<int>(std::abs(knob));
  return lit_ball(gl, stacks, 64, knob > 0 ? 1 : std::max(1, 96 / stacks));
}
constexpr double another_mesh = 1000;
Drawing shininess(const GlTable& gl, double knob) {
  return knob >= another_mesh ? lit_ball(gl, 8, static_cast<float>(knob - another_mesh), 14) : lit_ball(gl, 8, static_cast<float>(knob), 1);
}

/// Brightest luma of the reference less the picture's.
double lost_peak(const Observed& observed) {
  const auto brightest = [](const auto& rgba, double scale) {
    double peak = 0;
    for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
      peak = std::max(peak, scale * (0.2126 * rgba[i] + 0.7152 * rgba[i + 1] + 0.0722 * rgba[i + 2]));
    }
    return peak;
  };
  return std::max(0.0, brightest(observed.reference->color, 255) - brightest(observed.answer.picture->rgba, 1));
}

constexpr int moire_width = 128, moire_height = 96;

/// A checker to the horizon; knob n: the mean of n x n pictures moved over the pixel, by the accumulation buffer.
Drawing moire(const GlTable&, double knob) {
  const int grid = static_cast<int>(knob);
  return {[grid](const GlTable& table) {
    conformance::Matrix camera = conformance::perspective(45, static_cast<float>(moire_width) / moire_height, 0.5f, 200);
    table.Clear(GL_ACCUM_BUFFER_BIT);
    for (int i = 0; i < grid * grid; ++i) {
      const double dx = (i % grid + 0.5) / grid - 0.5, dy = (static_cast<double>(i / grid) + 0.5) / grid - 0.5;
      conformance::Matrix moved = camera;
      moved[8] = static_cast<float>(camera[8] - 2 * dx / moire_width);
      moved[9] = static_cast<float>(camera[9] - 2 * dy / moire_height);
      probes::project(table, moved, moire_width, moire_height);
      conformance::load_model_view(table, conformance::multiply(conformance::rotation(9, 0), conformance::translation(0, -1.5f, 0)));
      clear_background(table);
      table.Begin(GL_QUADS);
      for (int z = 0; z < 60; ++z) {
        for (int x = -14; x < 14; ++x) {
          const float shade = (x + z) % 2 == 0 ? 0.9f : 0.15f;
          table.Color3f(shade, shade, shade);
          for (const auto& [cx, cz] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) table.Vertex3f(static_cast<float>(x + cx), 0, -1 - static_cast<float>(z + cz));
        }
      }
      table.End();
      if (grid > 1) table.Accum(GL_ACCUM, 1.0f / static_cast<float>(grid * grid));
    }
    if (grid > 1) table.Accum(GL_RETURN, 1);
  }};
}

constexpr float layer_alpha = 0.02f, layer_color = 0.7f;

/// `knob` layers of 2 % over black.
Drawing layers(const GlTable& gl, double knob) {
  gl.Enable(GL_BLEND);
  gl.Disable(GL_DITHER);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  return {[count = static_cast<int>(knob)](const GlTable& table) {
            table.ClearColor(0, 0, 0, 1);
            table.Clear(GL_COLOR_BUFFER_BIT);
            table.Color4f(layer_color, layer_color, layer_color, layer_alpha);
            for (int i = 0; i < count; ++i) table.Rectf(-1, -1, 1, 1);
          },
          [](const GlTable& table) {
            std::array<float, 4> pixel{};
            table.ReadPixels(1, 1, 1, 1, GL_RGBA, GL_FLOAT, pixel.data());
            return std::vector<double>(pixel.begin(), pixel.end());
          }};
}

double forgotten(const Observed& observed) {
  const double exact = layer_color * (1 - std::pow(1 - static_cast<double>(layer_alpha), observed.knob));
  return 255 * std::abs(observed.answer.numbers.at(1) - exact);  // green: the widest of 565
}

Sweep layer_sweep(std::string_view name, std::string_view shows, GLenum format, GLenum type, Expectation expectation) {
  return {{name, shows, 4, 4, layers, 0, format, type},
          "layers",
          {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000},
          {{"color", "colour error, 1/255", forgotten}},
          {expectation},
          SweepReference::none,
          {"blending"},
          [](double knob) { return knob; },
          true};
}

}  // namespace

std::vector<Sweep> color_sweeps() {
  const std::string_view stalls = "a layer that changes less than half a step changes nothing";
  return {
      {{"perspective_slope", "a colour ramp whose right side is further away than its left", width, height, perspective_slope},
       "ratio of the distances",
       powers(2, 0, 12),
       {{"color", "largest colour error, 1/255", color_max}},
       {{"default", "color", 1, 4096, 0.55},
        {"colors=affine", "color", 8, 4096, {}, 64, "half way over the screen is at 1 / (1 + ratio) of the colours"},
        {"colors=affine8", "color", 1, 2, 2.0},
        {"colors=affine16", "color", 32, 4096, {}, 64, "over 16 pixels the distance changes many times over"}},
       SweepReference::house,
       {"colors"},
       [](double knob) { return knob; },
       true},
      {{"highlight_tessellation", "a ball with a highlight of shininess 64, of more and more faces", width, height, tessellation},
       "stacks",
       {3, 4, 6, 8, 12, 16, 24, 32, 48, 64},
       {{"peak", "brightness that the highlight loses, 1/255", lost_peak}, {"color", "mean colour error, 1/255", color_beyond_rounding}},
       {{"default", "peak", 48, 64, 8.0},
        {"default", "peak", 3, 8, {}, 20, "a highlight between the corners is not seen by them"},
        {"shading=phong", "peak", 3, 64, 2.0}},
       SweepReference::house,
       {"shading"},
       [](double knob) { return -knob; },
       true},
      {{"highlight_shininess", "a ball of 192 faces, of more and more shininess", width, height, shininess},
       "shininess",
       {0, 1, 2, 4, 8, 16, 32, 64, 96, 128},
       {{"peak", "brightness that the highlight loses, 1/255", lost_peak}, {"color", "mean colour error, 1/255", color_beyond_rounding}},
       {{"default", "peak", 0, 8, 8.0}, {"default", "peak", 64, 128, {}, 20, "the highlight is smaller than a face"}},
       SweepReference::house,
       {"shading"},
       [](double knob) { return knob + another_mesh; }},
      {{"moire", "a checker to the horizon, more and more samples a pixel", moire_width, moire_height, moire},
       "samples a side",
       {1, 2, 3, 4, 6, 8, 12},
       {{"color", "mean colour error against area coverage, 1/255", color_beyond_rounding}},
       {{"default", "color", 8, 12, 2.5}, {"default", "color", 1, 1, {}, 5, "fields smaller than pixels are hit or missed"}},
       SweepReference::area,
       {},  // a method that takes n x n samples itself would take them n x n times
       [](double) { return 1.0; },
       true},
      layer_sweep("layers_565", "layers of 2 % in 16 bits, 5-6-5", OSMESA_RGB_565, GL_UNSIGNED_SHORT_5_6_5,
                  {"default", "color", 100, 1000, {}, 20, stalls}),
      layer_sweep("layers_rgb8", "layers of 2 % in 24 bits, 8-8-8", OSMESA_RGB, GL_UNSIGNED_BYTE,
                  {"default", "color", 100, 1000, {}, 10, stalls}),
      layer_sweep("layers_bgra8", "layers of 2 % in 32 bits, 8-8-8-8", OSMESA_BGRA, GL_UNSIGNED_BYTE,
                  {"default", "color", 100, 1000, {}, 10, stalls}),
      layer_sweep("layers_rgba16", "layers of 2 % in 16 bits a channel", OSMESA_RGBA, GL_UNSIGNED_SHORT,
                  {"default", "color", 1, 1000, 0.15}),
      layer_sweep("layers_float", "layers of 2 % in 32-bit floats", OSMESA_RGBA, GL_FLOAT, {"default", "color", 1, 1000, 0.001}),
  };
}

}  // namespace gouraud::stability
