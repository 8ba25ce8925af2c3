// A probe: a scene with a knob, drawn by every contestant of the chart and of the stability sweeps, and by the oracle.
// Setting up (textures, meshes, state) is not timed; a frame is.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "conformance/scenes/shapes.h"
#include "gl_table.h"

namespace gouraud::probes {

struct Drawing {
  std::function<void(const GlTable& gl)> frame;  ///< clear included; not finished
  /// What else is to be known after the frame: matrices, pixels of deeper targets. May be empty.
  std::function<std::vector<double>(const GlTable& gl)> numbers{};
};

struct Probe {
  std::string_view name;
  std::string_view shows;  ///< one sentence
  int width_px, height_px;
  Drawing (*setup)(const GlTable& gl, double knob);  ///< in a fresh context; keeps what the frame needs
  int depth_bits = 24;
  GLenum format = GL_RGBA, type = GL_UNSIGNED_BYTE;  ///< other than these: only `numbers` are asked for
};

/// Of the chart and of the sweeps.
const std::vector<Probe>& all_probes();
/// Throws std::runtime_error if no probe is called so.
const Probe& probe_of_name(std::string_view name);

std::vector<Probe> chart_probes();

/// Loads a projection for a target of this size, moved by what shift_pixels() said: the probes' pictures are moved over
/// the pixels by parts of one where exact area coverage is wanted.
void project(const GlTable& gl, const conformance::Matrix& matrix, int width_px, int height_px);
void shift_pixels(double x_px, double y_px);

/// Object coordinates are window coordinates, as conformance::pixel_space.
void project_pixels(const GlTable& gl, int width_px, int height_px);

}  // namespace gouraud::probes
