// Takes vertices in window space, gives planes of depth, colours and varyings [GL1.5 §3.5.1 eq 3.6, §3.4.1 eq 3.4].
// Perspective: with q = 1/w, colour = c0 + sum(lambda_i q_i (c_i - c0)) / sum(lambda_i q_i); both sums are planes.
#include "pipeline/raster/planes.h"

namespace gouraud::pipeline {
namespace {

float finite_or_zero(double value) { return std::isfinite(value) ? static_cast<float>(value) : 0.0f; }

std::array<float, 4> channels(const Rgba& color) { return {color.r, color.g, color.b, color.a}; }

/// 1/w of the vertices, relative to the largest so that tiny and huge w stay in range; all 1 if they are equal.
struct Weights {
  bool perspective;
  std::array<double, 3> q;
};
Weights weigh(const std::array<const WindowVertex*, 3>& vertices) {
  const float q0 = vertices[0]->w_inverse, q1 = vertices[1]->w_inverse, q2 = vertices[2]->w_inverse;
  if (q0 == q1 && q0 == q2) return {false, {1, 1, 1}};
  const double largest = 1.0 / static_cast<double>(std::max({q0, q1, q2}));
  return {true, {q0 * largest, q1 * largest, q2 * largest}};
}

/// A varying that is its base all over.
void make_constant(VaryingPlane& plane, std::size_t k, VaryingRecord& record) {
  plane = {0, 0, 0, plane.base, plane.base, plane.base};
  record.constant |= std::uint64_t{1} << k;
}

}  // namespace

DepthPlane make_depth_plane(const GradientBasis& basis, const std::array<ShadedVertex, 3>& vertices,
                            const PlaneTargets& targets) {
  std::array<double, 3> z;
  for (std::size_t i = 0; i < 3; ++i) {
    z[i] = std::clamp(static_cast<double>(vertices[i].window->z), 0.0, 1.0) * targets.depth_scale;
  }
  const Plane plane = make_plane(basis, z[0], z[1] - z[0], z[2] - z[0]);
  DepthPlane out;
  const auto [low, high] = std::minmax({z[0], z[1], z[2]});
  out.minimum = static_cast<float>(low);
  out.maximum = static_cast<float>(high);
  if (!std::isfinite(plane.origin) || !std::isfinite(plane.dx) || !std::isfinite(plane.dy)) {
    out.origin = z[0];
    return out;
  }
  out.origin = plane.origin;
  out.dx = plane.dx;
  out.dy = plane.dy;
  const double slope = std::abs(plane.dx) + std::abs(plane.dy);
  out.steep = slope > steep_slope(targets);
  return out;
}

void make_constant_color(Rgba color, const PlaneTargets& targets, ColorRecord& out) {
  const std::array<float, 4> value = channels(color);
  for (std::size_t k = 0; k < 4; ++k) out.base[k] = std::min(value[k], 1.0f) * targets.color_scale;
  out.variation = ColorVariation::constant;
  out.clamp = false;
}

void make_color_planes(const GradientBasis& basis, const std::array<ShadedVertex, 3>& vertices,
                       const PlaneTargets& targets, ColorRecord& out) {
  const std::array<float, 4> c0 = channels(vertices[0].color);
  const std::array<float, 4> c1 = channels(vertices[1].color);
  const std::array<float, 4> c2 = channels(vertices[2].color);
  if (c0 == c1 && c0 == c2) return make_constant_color(vertices[0].color, targets, out);

  const auto [perspective, weights] = weigh({vertices[0].window, vertices[1].window, vertices[2].window});
  const auto [q0, q1, q2] = weights;

  // Planes of the colours, or under perspective of their weighted distance from vertex 0.
  const double scale = targets.color_scale;
  double worst_overshoot = 0;
  bool over_one = false;
  for (std::size_t k = 0; k < 4; ++k) {
    const double rise1 = (static_cast<double>(c1[k]) - c0[k]) * q1, rise2 = (static_cast<double>(c2[k]) - c0[k]) * q2;
    const double start = perspective ? 0.0 : c0[k] * scale;
    const Plane plane = make_plane(basis, start, rise1 * scale, rise2 * scale);
    out.origin[k] = plane.origin;
    out.dx[k] = plane.dx;
    out.dy[k] = plane.dy;
    out.base[k] = c0[k] * targets.color_scale;
    const auto [low, high] = std::minmax({c0[k], c1[k], c2[k]});
    over_one |= high > 1.0f;
    out.minimum[k] = std::min(low, 1.0f) * targets.color_scale;
    out.maximum[k] = std::min(high, 1.0f) * targets.color_scale;
    worst_overshoot = std::max(worst_overshoot, (std::abs(plane.dx) + std::abs(plane.dy)) / scale);
  }
  worst_overshoot *= snap_overshoot;
  out.variation = perspective ? ColorVariation::perspective : ColorVariation::affine;
  if (perspective) {
    const Plane plane = make_plane(basis, q0, q1 - q0, q2 - q0);
    out.inverse_w_origin = plane.origin;
    out.inverse_w_dx = plane.dx;
    out.inverse_w_dy = plane.dy;
    const double lowest = std::min({q0, q1, q2});
    out.inverse_w_minimum = static_cast<float>(lowest);
    out.inverse_w_maximum = 1.0f;
    // A wrong 1/w scales the colour's distance from vertex 0, which is at most the range of the colours.
    worst_overshoot = (worst_overshoot + (std::abs(plane.dx) + std::abs(plane.dy)) * snap_overshoot) / lowest;
  }
  out.clamp = over_one || !(worst_overshoot < harmless_overshoot);
  if (!std::isfinite(worst_overshoot)) {
    for (std::size_t k = 0; k < 4; ++k) out.base[k] = finite_or_zero(std::min(c0[k], 1.0f) * targets.color_scale);
    out.variation = ColorVariation::constant;
    out.clamp = false;
  }
}

void make_varying_planes(const GradientBasis& basis, const std::array<const WindowVertex*, 3>& vertices,
                         const std::array<const float*, 3>& values, std::size_t count, VaryingRecord& out) {
  const auto [perspective, q] = weigh(vertices);
  const Plane inverse_w = make_plane(basis, q[0], q[1] - q[0], q[2] - q[0]);
  if (!std::isfinite(inverse_w.origin) || !std::isfinite(inverse_w.dx) || !std::isfinite(inverse_w.dy)) {
    return make_constant_varyings(values[0], count, out);
  }
  const auto [lowest, highest] = std::minmax({q[0], q[1], q[2]});
  out = {inverse_w.origin, inverse_w.dx, inverse_w.dy, static_cast<float>(lowest), static_cast<float>(highest), 0,
         perspective, true};
  auto* planes = reinterpret_cast<VaryingPlane*>(&out + 1);
  for (std::size_t k = 0; k < count; ++k) {
    const float v0 = values[0][k], v1 = values[1][k], v2 = values[2][k];
    const double rise1 = (static_cast<double>(v1) - v0) * q[1], rise2 = (static_cast<double>(v2) - v0) * q[2];
    const Plane plane = make_plane(basis, perspective ? 0.0 : v0, rise1, rise2);
    const auto [low, high] = std::minmax({v0, v1, v2});
    planes[k] = {plane.origin, plane.dx, plane.dy, finite_or_zero(v0), low, high};
    const bool finite = std::isfinite(plane.origin) && std::isfinite(plane.dx) && std::isfinite(plane.dy);
    if (!finite || (v0 == v1 && v0 == v2)) make_constant(planes[k], k, out);
  }
}

void make_constant_varyings(const float* values, std::size_t count, VaryingRecord& out) {
  out = {};
  auto* planes = reinterpret_cast<VaryingPlane*>(&out + 1);
  for (std::size_t k = 0; k < count; ++k) {
    planes[k].base = finite_or_zero(values[k]);
    make_constant(planes[k], k, out);
  }
}

}  // namespace gouraud::pipeline
