// Takes three vertices in clip space, gives a record and the functions that find its pixels, without ever dividing a
// vertex by its w.
//
// With window coordinates X = x w, Y = y w (w is the clip coordinate), the matrix of the rows (X, Y, w) has an inverse whose
// columns are edge functions: function i is 1/w at vertex i, 0 at the others, and linear in the window. A pixel is
// inside where none is negative, which also says that it lies in front of the eye. Any quantity p that is linear in space
// is the sum of p_i times function i, times w; so 1/w is their sum, and depth (z/w) the sum of z_i times function i: the near
// and far planes are two more functions that a pixel is tested against. Nothing needs clipping, no new vertices, one
// setup a triangle. It costs a division and an inverse in double for each, and boxes as large as the viewport for
// triangles that reach behind the eye; corners are not snapped, so that pixels along edges may differ from the default's.
// Source: M. Olano, T. Greer, "Triangle scan conversion using 2D homogeneous coordinates", 1997.
#include "pipeline/raster/homogeneous.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <new>

#include "pipeline/raster/planes.h"
#include "pipeline/raster/tile_pixels.h"

namespace gouraud::pipeline {
namespace {

using Row = std::array<double, 3>;

/// What is in the window: the vertices as rows (X, Y, w), y up.
std::array<Row, 3> homogeneous_corners(const ViewportState& viewport, const ProcessedVertices& vertices, const AssembledTriangle& triangle) {
  const double half_width = 0.5 * viewport.width_px, half_height = 0.5 * viewport.height_px;
  const double center_x = viewport.x + half_width + viewport.sample_shift_x;
  const double center_y = viewport.y + half_height + viewport.sample_shift_y;
  std::array<Row, 3> rows;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto clip = [&](std::size_t k) { return static_cast<double>(vertices.position_clip[k][triangle.vertex[i]]); };
    const double w = clip(3), y = viewport.upper_left ? -clip(1) : clip(1);
    rows[i] = {clip(0) * half_width + center_x * w, y * half_height + center_y * w, w};
  }
  return rows;
}

Row cross(const Row& a, const Row& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The plane of a x + b y + c, whose origin is the centre of pixel (0, 0).
Plane plane_of(const Row& function) { return {0.5 * function[0] + 0.5 * function[1] + function[2], function[0], function[1]}; }

/// The sum of the planes, each times a number.
Plane sum(const std::array<Plane, 3>& planes, double f0, double f1, double f2) {
  return {planes[0].origin * f0 + planes[1].origin * f1 + planes[2].origin * f2,
          planes[0].dx * f0 + planes[1].dx * f1 + planes[2].dx * f2, planes[0].dy * f0 + planes[1].dy * f1 + planes[2].dy * f2};
}

bool is_finite(const Plane& plane) { return std::isfinite(plane.origin) && std::isfinite(plane.dx) && std::isfinite(plane.dy); }

/// The pixels that the triangle can touch: around its corners if all are in front of the eye, else all.
PixelRect box_of(const std::array<Row, 3>& corners, const PixelRect& limit) {
  double x0 = limit.x1, y0 = limit.y1, x1 = limit.x0, y1 = limit.y0;
  for (const Row& corner : corners) {
    if (!(corner[2] > 0)) return limit;
    x0 = std::min(x0, corner[0] / corner[2]);
    y0 = std::min(y0, corner[1] / corner[2]);
    x1 = std::max(x1, corner[0] / corner[2]);
    y1 = std::max(y1, corner[1] / corner[2]);
  }
  const auto within = [](double value, std::int32_t low, std::int32_t high) {
    return static_cast<std::int32_t>(std::clamp(value, static_cast<double>(low), static_cast<double>(high)));
  };
  return {within(std::floor(x0), limit.x0, limit.x1), within(std::floor(y0), limit.y0, limit.y1),
          within(std::ceil(x1), limit.x0, limit.x1), within(std::ceil(y1), limit.y0, limit.y1)};
}

/// The largest value of a plane on the pixels of the box.
double largest_in(const Plane& plane, const PixelRect& box) {
  return plane.origin + std::max(plane.dx * box.x0, plane.dx * (box.x1 - 1)) + std::max(plane.dy * box.y0, plane.dy * (box.y1 - 1));
}

void set_up_depth(const SetupState& state, const ViewportState& viewport, const Plane& z_ndc, DepthPlane& out) {
  const double scale = state.targets.depth_scale, range = viewport.depth_far - viewport.depth_near;
  const double factor = (viewport.zero_to_one ? range : 0.5 * range) * scale;
  const double start = (viewport.zero_to_one ? viewport.depth_near : 0.5 * (viewport.depth_far + viewport.depth_near)) * scale;
  out.origin = z_ndc.origin * factor + start;
  out.dx = z_ndc.dx * factor;
  out.dy = z_ndc.dy * factor;
  const double low = std::min(viewport.depth_near, viewport.depth_far) * scale;
  const double high = std::max(viewport.depth_near, viewport.depth_far) * scale;
  const double offset =
      state.polygons.offset_fill ? depth_offset(state.polygons, state.targets, out.dx, out.dy, high) : 0.0;
  out.origin += offset;
  out.minimum = static_cast<float>(std::clamp(low + offset, 0.0, scale));
  out.maximum = static_cast<float>(std::clamp(high + offset, 0.0, scale));
  out.steep = std::abs(out.dx) + std::abs(out.dy) > steep_slope(state.targets);
}

/// Functions of the vertices, scaled so that their sum, 1/w, is at most 1 in the box.
struct Weights {
  std::array<Plane, 3> function;
  Plane inverse_w;
};
constexpr float least_inverse_w = 1e-9f;

void set_up_colors(const SetupState& state, const Weights& weights, const std::array<Rgba, 3>& colors, ColorRecord& out) {
  const float scale = state.targets.color_scale;
  if (state.flat) return make_constant_color(colors[0], state.targets, out);
  const auto channel = [&](std::size_t i, std::size_t k) {
    const Rgba& c = colors[i];
    return std::array{c.r, c.g, c.b, c.a}[k] * scale;
  };
  const auto set_plane = [&](std::size_t k, const Plane& plane) {
    out.origin[k] = plane.origin;
    out.dx[k] = plane.dx;
    out.dy[k] = plane.dy;
  };
  for (std::size_t k = 0; k < 4; ++k) {
    const float c0 = channel(0, k), c1 = channel(1, k), c2 = channel(2, k);
    set_plane(k, sum(weights.function, 0, static_cast<double>(c1) - c0, static_cast<double>(c2) - c0));
    out.base[k] = c0;
    out.minimum[k] = std::min(std::min({c0, c1, c2}), scale);
    out.maximum[k] = std::min(std::max({c0, c1, c2}), scale);
  }
  out.inverse_w_origin = weights.inverse_w.origin;
  out.inverse_w_dx = weights.inverse_w.dx;
  out.inverse_w_dy = weights.inverse_w.dy;
  out.inverse_w_minimum = least_inverse_w;
  out.inverse_w_maximum = 1.0f;
  out.variation = ColorVariation::perspective;
  out.clamp = true;
}

void set_up_varyings(const Weights& weights, const std::array<std::array<float, max_varyings>, 3>& values, std::size_t count,
                     VaryingRecord& out) {
  out = {weights.inverse_w.origin, weights.inverse_w.dx, weights.inverse_w.dy, least_inverse_w, 1.0f, 0, true, true};
  auto* planes = reinterpret_cast<VaryingPlane*>(&out + 1);
  for (std::size_t k = 0; k < count; ++k) {
    const float v0 = values[0][k], v1 = values[1][k], v2 = values[2][k];
    const Plane plane = sum(weights.function, 0, static_cast<double>(v1) - v0, static_cast<double>(v2) - v0);
    if (is_finite(plane) && std::isfinite(v0)) {
      planes[k] = {plane.origin, plane.dx, plane.dy, v0, std::min({v0, v1, v2}), std::max({v0, v1, v2})};
    } else {
      const float value = std::isfinite(v0) ? v0 : 0.0f;
      planes[k] = {0, 0, 0, value, value, value};
      out.constant |= std::uint64_t{1} << k;
    }
  }
}

void rasterize_homogeneous(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  const MethodTriangle& triangle = method_triangle_of(primitive);
  const auto at = [](const MethodTriangle::Function& f, std::int32_t x, std::int32_t y) { return (f.origin + f.dx * x) + f.dy * y; };
  send_pixels(primitive, tile_x, tile_y, target, [&](std::int32_t x, std::int32_t y) {
    for (const MethodTriangle::Function& f : triangle.edge) {
      const double value = at(f, x, y);
      if (!(f.owns ? value >= 0 : value > 0)) return false;
    }
    return at(triangle.behind_near, x, y) >= 0 && at(triangle.before_far, x, y) >= 0;
  });
}

}  // namespace

void set_ray_corners(const ViewportState& viewport, const ProcessedVertices& vertices, const AssembledTriangle& triangle, MethodTriangle& shape) {
  const std::array<Row, 3> corners = homogeneous_corners(viewport, vertices, triangle);
  for (std::size_t i = 0; i < 3; ++i) {
    shape.ray[i] = {corners[i][0], corners[i][1], vertices.position_clip[2][triangle.vertex[i]], corners[i][2]};
  }
}

bool setup_homogeneous(const SetupState& state, const ViewportState& viewport, const ProcessedVertices& vertices,
                       const AssembledTriangle& triangle, void* memory, MethodTriangle& shape) {
  // Edge functions: columns of the inverse matrix, without its determinant, whose sign is the facing.
  const std::array<Row, 3> corners = homogeneous_corners(viewport, vertices, triangle);
  const Row c0 = cross(corners[1], corners[2]), c1 = cross(corners[2], corners[0]), c2 = cross(corners[0], corners[1]);
  const double determinant = corners[0][0] * c0[0] + corners[0][1] * c0[1] + corners[0][2] * c0[2];
  const bool front = (determinant > 0) == (state.front_face == FrontFace::ccw);
  if (!std::isfinite(determinant) || determinant == 0 || is_culled(state.cull, front)) return false;
  const PixelRect box = box_of(corners, state.scissor);
  if (box.empty()) return false;

  Weights weights;
  shape.smooth = false;
  shape.rasterize = rasterize_homogeneous;
  for (std::size_t i = 0; i < 3; ++i) {
    const Row& column = i == 0 ? c0 : i == 1 ? c1 : c2;
    // Neighbours have the same functions, but for their sign: of a sample on the edge one of them takes possession.
    const double sign = determinant > 0 ? 1.0 : -1.0;
    const Plane edge = plane_of({sign * column[0], sign * column[1], sign * column[2]});
    shape.edge[i] = {edge.origin, edge.dx, edge.dy, edge.dx > 0 || (edge.dx == 0 && edge.dy > 0)};
    weights.function[i] = plane_of({column[0] / determinant, column[1] / determinant, column[2] / determinant});
  }
  const auto z = [&](std::size_t i) { return static_cast<double>(vertices.position_clip[2][triangle.vertex[i]]); };
  const Plane z_ndc = sum(weights.function, z(0), z(1), z(2));
  // Distances of the vertices themselves, so that what lies on a plane (all, if near is next to nothing) is on it everywhere.
  const auto set_plane_test = [&](MethodTriangle::Function& test, double of_z, double of_w) {
    const auto distance = [&](std::size_t i) { return of_z * z(i) + of_w * corners[i][2]; };
    const Plane plane = sum(weights.function, distance(0), distance(1), distance(2));
    test = {plane.origin, plane.dx, plane.dy, true};
  };
  set_plane_test(shape.behind_near, 1, viewport.zero_to_one ? 0 : 1);
  set_plane_test(shape.before_far, -1, 1);
  weights.inverse_w = sum(weights.function, 1, 1, 1);
  const double largest = largest_in(weights.inverse_w, box);
  if (!is_finite(z_ndc) || !(largest > 0) || !std::isfinite(1.0 / largest)) return false;
  for (Plane* plane : {&weights.function[0], &weights.function[1], &weights.function[2], &weights.inverse_w}) {
    *plane = {plane->origin / largest, plane->dx / largest, plane->dy / largest};
    if (!is_finite(*plane)) return false;
  }

  // The record: as set_up_triangle writes it.
  auto* bytes = static_cast<std::byte*>(memory);
  PrimitiveRecord& record = state.colors ? (new (bytes) ColoredPrimitive)->record : *new (bytes) PrimitiveRecord;
  record.binding = state.binding;
  record.x0 = box.x0;
  record.y0 = box.y0;
  record.x1 = box.x1;
  record.y1 = box.y1;
  record.scissored = record.is_polygon = true;
  record.back = !front;
  record.shape = &shape;
  set_up_depth(state, viewport, z_ndc, record.depth);
  const auto shading = [&](std::size_t i) { return state.flat ? triangle.provoking : triangle.vertex[i]; };
  if (state.colors) {
    const auto color = [&](std::size_t i) { return color_of_vertex(state, vertices, shading(i), !front); };
    set_up_colors(state, weights, {color(0), color(1), color(2)}, reinterpret_cast<ColoredPrimitive&>(record).color);
  }
  if (const auto count = static_cast<std::size_t>(state.binding->varyings.count); count > 0) {
    std::array<std::array<float, max_varyings>, 3> values;
    for (std::size_t i = 0; i < 3; ++i) copy_varyings(state, vertices, triangle.vertex[i], shading(i), !front, values[i].data());
    const std::size_t before = state.colors ? sizeof(ColoredPrimitive) : sizeof(PrimitiveRecord);
    set_up_varyings(weights, values, count, *new (bytes + before) VaryingRecord);
  }
  return true;
}

}  // namespace gouraud::pipeline
