// Light: normals scaled until they vanish, spots, attenuation where the lamp is, all exponents.
#include <array>
#include <cmath>

#include "conformance/stability/sweeps.h"

namespace gouraud::stability {
namespace {

using conformance::Matrix;

constexpr int width = 160, height = 120;

struct Lamp {
  conformance::Four position{2, 3, 4, 1};
  float exponent = 0, cutoff_deg = 180, shininess = 20;
  std::array<float, 3> attenuation{1, 0, 0};
  float scale = 1;  ///< of the model-view matrix; the mesh is as much smaller
};

Drawing ball(const GlTable& gl, const Lamp& lamp) {
  conformance::black_lighting(gl, 1);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_NORMALIZE);
  probes::project(gl, conformance::perspective(40, static_cast<float>(width) / height, 1, 20), width, height);
  conformance::load_model_view(gl, conformance::translation(0, 0, -4));
  conformance::light(gl, GL_LIGHT0, GL_POSITION, lamp.position);
  const std::array<float, 3> down{-2, -3, -4};
  gl.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, down.data());
  gl.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, lamp.exponent);
  gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, lamp.cutoff_deg);
  gl.Lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, lamp.attenuation[0]);
  gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, lamp.attenuation[1]);
  gl.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, lamp.attenuation[2]);
  for (const GLenum term : {GL_DIFFUSE, GL_SPECULAR}) conformance::light(gl, GL_LIGHT0, term, {0.9f, 0.8f, 0.7f, 1});
  conformance::material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, {0.4f, 0.5f, 0.7f, 1});
  conformance::material(gl, GL_FRONT_AND_BACK, GL_SPECULAR, {0.5f, 0.5f, 0.5f, 1});
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, lamp.shininess);
  const Matrix model = conformance::scaling(lamp.scale, lamp.scale, lamp.scale);
  conformance::load_model_view(gl, conformance::multiply(conformance::translation(0, 0, -4), model));
  return {[mesh = conformance::sphere(1.2f / lamp.scale, 31, 47)](const GlTable& table) {
    conformance::clear_background(table);
    draw_surface(table, mesh);
  }};
}

Drawing normal_scale(const GlTable& gl, double knob) { return ball(gl, {.scale = static_cast<float>(std::pow(10.0, knob))}); }
Drawing spot_exponent(const GlTable& gl, double knob) { return ball(gl, {.exponent = static_cast<float>(knob), .cutoff_deg = 60}); }
Drawing spot_cutoff(const GlTable& gl, double knob) { return ball(gl, {.cutoff_deg = static_cast<float>(knob)}); }
Drawing shininess(const GlTable& gl, double knob) { return ball(gl, {.shininess = static_cast<float>(knob)}); }

/// The lamp comes down on the ball's front corner; only distance attenuates, so that the light there grows to infinity.
Drawing attenuation(const GlTable& gl, double knob) {
  return ball(gl, {.position = {0, 0, static_cast<float>(1.2 + knob), 1}, .attenuation = {0, 0, 4}});
}

Sweep light_sweep(std::string_view name, std::string_view shows, Drawing (*setup)(const GlTable&, double), std::string_view label,
                  std::vector<double> knobs, Expectation expectation, bool log_x = false) {
  return {{name, shows, width, height, setup},
          label,
          std::move(knobs),
          {{"color", "largest colour error, 1/255", color_max}, {"mean", "mean colour error beyond rounding, 1/255", color_beyond_rounding}},
          {expectation},
          SweepReference::house,
          {"highlight", "power"},
          [](double knob) { return knob; },
          log_x};
}

}  // namespace

std::vector<Sweep> light_sweeps() {
  const std::vector<double> exponents{0, 0.1, 0.5, 1, 2, 5, 10, 20, 50, 80, 100, 127, 128};
  return {
      light_sweep("normal_scale", "a lit ball whose matrix scales by 10^k, GL_NORMALIZE", normal_scale, "scale 10^k: k",
                  {-37, -30, -24, -20, -18, -16, -12, -8, -4, 0, 4, 8, 12, 16, 18, 20, 24, 30, 37}, {"default", "mean", -37, 37, 0.01}),
      light_sweep("spot_exponent", "a spot light's exponent", spot_exponent, "exponent", exponents, {"default", "mean", 0, 128, 0.01}),
      light_sweep("spot_cutoff", "a spot light's cone", spot_cutoff, "cutoff, degrees", {0, 0.01, 0.5, 1, 2, 5, 10, 20, 30, 60, 89.9, 90, 180},
                  {"default", "mean", 0, 180, 0.01}),
      light_sweep("shininess", "a highlight's exponent", shininess, "shininess", exponents, {"default", "mean", 0, 128, 0.01}),
      light_sweep("attenuation", "a lamp comes down on the ball, to distance 0", attenuation, "distance",
                  {0, 1e-30, 1e-20, 1e-10, 1e-5, 1e-3, 0.01, 0.1, 0.5, 1, 4}, {"default", "mean", 0, 4, 0.01}),
  };
}

}  // namespace gouraud::stability
