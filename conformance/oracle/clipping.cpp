#include "conformance/oracle/clipping.h"

#include <algorithm>
#include <cmath>

#include "conformance/oracle/exact_sum.h"

namespace gouraud::oracle {
namespace {

/// Distances to the frustum's planes are positive inside: w - x, w + x, w - y, w + y, w + z (near), w - z (far).
/// And z, which takes the place of w + z where clip space is that deep only.
constexpr int frustum_planes = 6, near_at_zero = 6;

/// A plane of the frustum, or one of the user's, in eye space.
struct Plane {
  int frustum = 0;
  const glm::vec4* user = nullptr;
};

std::vector<Plane> all_planes(const pipeline::ClipPlaneState& user, bool zero_to_one) {
  std::vector<Plane> planes;
  for (int i = 0; i < frustum_planes; ++i) planes.push_back({i == 4 && zero_to_one ? near_at_zero : i, nullptr});
  for (std::size_t i = 0; i < user.count; ++i) planes.push_back({0, &user.plane_eye[i]});
  return planes;
}

template <typename T>
double user_distance(const std::array<T, 4>& eye, const glm::vec4& plane) {
  const double x = eye[0], y = eye[1], z = eye[2], w = eye[3];
  return ((x * plane.x + y * plane.y) + z * plane.z) + w * plane.w;
}

template <typename T>
T distance(const std::array<T, 4>& p, int plane) {
  switch (plane) {
    case 0:
      return -p[0] + p[3];
    case 1:
      return p[0] + p[3];
    case 2:
      return -p[1] + p[3];
    case 3:
      return p[1] + p[3];
    case 4:
      return p[2] + p[3];
    case near_at_zero:
      return p[2];
    default:
      return -p[2] + p[3];
  }
}

template <typename T>
T distance(const ClipVertex<T>& vertex, const Plane& plane) {
  if (plane.user != nullptr) return static_cast<T>(user_distance(vertex.position_eye, *plane.user));
  return distance(vertex.position, plane.frustum);
}

template <typename T>
bool has_finite_position(const ClipVertex<T>& vertex) {
  return std::ranges::all_of(vertex.position, [](T coordinate) { return std::isfinite(coordinate); });
}

Color mix(const Color& from, const Color& to, double t) {
  Color out;
  for (std::size_t i = 0; i < 4; ++i) out[i] = from[i] + t * (to[i] - from[i]);
  return out;
}

/// from + t (to - from): positions by `t`, colours by `t_exact`.
template <typename T>
ClipVertex<T> mix(const ClipVertex<T>& from, const ClipVertex<T>& to, T t, double t_exact) {
  ClipVertex<T> out;
  for (std::size_t i = 0; i < 4; ++i) {
    out.position[i] = from.position[i] + t * (to.position[i] - from.position[i]);
    out.position_eye[i] = from.position_eye[i] + t * (to.position_eye[i] - from.position_eye[i]);
  }
  const double fog = from.colors.fog_coordinate;
  out.colors.fog_coordinate = fog + t_exact * (to.colors.fog_coordinate - fog);
  for (const Face face : {front, back}) {
    out.colors.primary[face] = mix(from.colors.primary[face], to.colors.primary[face], t_exact);
    out.colors.secondary[face] = mix(from.colors.secondary[face], to.colors.secondary[face], t_exact);
  }
  for (std::size_t i = 0; i < from.colors.texture_coordinates.size(); ++i) {
    out.colors.texture_coordinates.push_back(mix(from.colors.texture_coordinates[i], to.colors.texture_coordinates[i], t_exact));
  }
  return out;
}

/// The distance as it is for the given coordinates, without rounding to T.
template <typename T>
double exact_distance(const ClipVertex<T>& vertex, const Plane& plane) {
  if (plane.user != nullptr) return user_distance(vertex.position_eye, *plane.user);
  Vector4 p;
  std::ranges::copy(vertex.position, p.begin());
  return distance(p, plane.frustum);
}

/// Where the edge between an inside and an outside vertex meets the plane, measured from the nearer end
/// (MESA-RULES 2.4).
template <typename T>
ClipVertex<T> intersect(const ClipVertex<T>& inside, const ClipVertex<T>& outside, const Plane& plane) {
  const T d_inside = distance(inside, plane), d_outside = distance(outside, plane);
  const double exact_inside = exact_distance(inside, plane), exact_outside = exact_distance(outside, plane);
  if (-d_outside < d_inside) {
    return mix(outside, inside, d_outside / (d_outside - d_inside), exact_outside / (exact_outside - exact_inside));
  }
  return mix(inside, outside, d_inside / (d_inside - d_outside), exact_inside / (exact_inside - exact_outside));
}

template <typename T>
ClippedPolygon<T> clip_to_plane(const ClippedPolygon<T>& polygon, const Plane& plane) {
  // w - x may overflow where w and x do not.
  const auto finite = [plane](const auto& vertex) { return std::isfinite(distance(vertex, plane)); };
  if (!std::ranges::all_of(polygon.vertices, finite)) return {};

  ClippedPolygon<T> out;
  out.is_cut = true;
  const auto add = [&out](const ClipVertex<T>& vertex, bool boundary) {
    out.vertices.push_back(vertex);
    out.boundary.push_back(boundary);
  };
  const std::size_t n = polygon.vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const ClipVertex<T>& here = polygon.vertices[i];
    const ClipVertex<T>& next = polygon.vertices[(i + 1) % n];
    const bool here_inside = distance(here, plane) >= 0, next_inside = distance(next, plane) >= 0;
    if (here_inside) add(here, polygon.boundary[i]);
    // Leaving, the new edge runs along the plane; coming back, along the old edge.
    if (here_inside && !next_inside) add(intersect(here, next, plane), true);
    if (!here_inside && next_inside) add(intersect(next, here, plane), polygon.boundary[i]);
  }
  return out;
}

template <typename T>
ExactSum exact_sum_distance(const ClipVertex<T>& vertex, const Plane& plane) {
  if (plane.user != nullptr) return {{user_distance(vertex.position_eye, *plane.user)}};
  if (plane.frustum == near_at_zero) return {{static_cast<double>(vertex.position[2])}};
  const double w = vertex.position[3], coordinate = vertex.position[static_cast<std::size_t>(plane.frustum / 2)];
  const bool is_upper = plane.frustum == 0 || plane.frustum == 2 || plane.frustum == 5;
  return {{is_upper ? -coordinate : coordinate, w}};
}

/// A line's crossing of a plane, from the signed distances of its ends: at t = d0 / (d0 - d1) from end 0.
struct Crossing {
  ExactSum d0, d1;

  /// t as a fraction with a positive denominator.
  ExactSum numerator() const { return d0.value() < 0 ? -d0 : d0; }
  ExactSum denominator() const { return d0.value() < 0 ? d1 - d0 : d0 - d1; }
};

bool is_before(const Crossing& a, const Crossing& b) {
  return (a.numerator() * b.denominator() - b.numerator() * a.denominator()).value() < 0;
}

/// (1 - t) v0 + t v1 = (d0 v1 - d1 v0) / (d0 - d1): positions rounded once.
template <typename T>
ClipVertex<T> vertex_at(const Crossing& crossing, const ClipVertex<T>& v0, const ClipVertex<T>& v1) {
  const double t = crossing.numerator().value() / crossing.denominator().value();
  ClipVertex<T> out = mix(v0, v1, static_cast<T>(t), t);
  for (std::size_t i = 0; i < 4; ++i) {
    const ExactSum c0{{static_cast<double>(v0.position[i])}}, c1{{static_cast<double>(v1.position[i])}};
    const ExactSum weighted = crossing.d0 * c1 - crossing.d1 * c0;
    out.position[i] = static_cast<T>(weighted.value() / (crossing.d0 - crossing.d1).value());
  }
  return out;
}

}  // namespace

template <typename T>
ClippedPolygon<T> clip_triangle(const std::array<ClipVertex<T>, 3>& triangle, unsigned boundary_edges,
                                const pipeline::ClipPlaneState& user, bool zero_to_one) {
  if (!std::ranges::all_of(triangle, [](const auto& vertex) { return has_finite_position(vertex); })) return {};
  ClippedPolygon<T> polygon;
  polygon.vertices.assign(triangle.begin(), triangle.end());
  for (unsigned i = 0; i < 3; ++i) polygon.boundary.push_back((boundary_edges >> i & 1) != 0);
  for (const Plane& plane : all_planes(user, zero_to_one)) {
    const auto violates = [plane](const auto& vertex) { return distance(vertex, plane) < 0; };
    if (std::ranges::any_of(triangle, violates)) polygon = clip_to_plane(polygon, plane);
  }
  if (polygon.vertices.size() < 3) return {};
  return polygon;
}

template <typename T>
std::optional<std::array<ClipVertex<T>, 2>> clip_line(const std::array<ClipVertex<T>, 2>& line,
                                                       const pipeline::ClipPlaneState& user, bool zero_to_one) {
  const auto& [v0, v1] = line;
  if (!has_finite_position(v0) || !has_finite_position(v1)) return {};
  // Where the line comes in and where it leaves.
  std::optional<Crossing> entry, exit;
  for (const Plane& plane : all_planes(user, zero_to_one)) {
    const Crossing here{exact_sum_distance(v0, plane), exact_sum_distance(v1, plane)};
    const bool inside0 = here.d0.value() >= 0, inside1 = here.d1.value() >= 0;
    if (!inside0 && !inside1) return {};
    if (!inside0 && (!entry || is_before(*entry, here))) entry = here;
    if (!inside1 && (!exit || is_before(here, *exit))) exit = here;
  }
  if (entry && exit && !is_before(*entry, *exit)) return {};
  std::array<ClipVertex<T>, 2> out = line;
  if (entry) out[0] = vertex_at(*entry, v0, v1);
  if (exit) out[1] = vertex_at(*exit, v0, v1);
  return out;
}

template <typename T>
bool in_view_volume(const ClipVertex<T>& point, const pipeline::ClipPlaneState& user, bool zero_to_one) {
  if (!has_finite_position(point)) return false;
  for (const Plane& plane : all_planes(user, zero_to_one)) {
    if (!(distance(point, plane) >= 0)) return false;
  }
  return true;
}

template ClippedPolygon<float> clip_triangle(const std::array<ClipVertex<float>, 3>&, unsigned, const pipeline::ClipPlaneState&, bool);
template ClippedPolygon<double> clip_triangle(const std::array<ClipVertex<double>, 3>&, unsigned, const pipeline::ClipPlaneState&, bool);
template std::optional<std::array<ClipVertex<float>, 2>> clip_line(const std::array<ClipVertex<float>, 2>&,
                                                                        const pipeline::ClipPlaneState&, bool);
template std::optional<std::array<ClipVertex<double>, 2>> clip_line(const std::array<ClipVertex<double>, 2>&,
                                                                        const pipeline::ClipPlaneState&, bool);
template bool in_view_volume(const ClipVertex<float>&, const pipeline::ClipPlaneState&, bool);
template bool in_view_volume(const ClipVertex<double>&, const pipeline::ClipPlaneState&, bool);

}  // namespace gouraud::oracle
