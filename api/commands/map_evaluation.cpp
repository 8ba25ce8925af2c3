#include "api/commands/map_evaluation.h"

#include <cmath>

#include "api/commands/bernstein.h"
#include "pipeline/geometry/vertex_batch.h"

namespace gouraud::api {
namespace {

using Point = std::array<double, 4>;

// Where the domain's point lies between 0 and 1.
double parameter(const MapDomain& domain, double at) {
  const double first = domain.first, last = domain.last;
  return at == last ? 1.0 : (at - first) / (last - first);
}

// The sum of weight i times the point that begins at points[i * components].
template <class Number>
Point weighted_sum(const Number* points, std::size_t components, int order, const double* weights) {
  Point sum{};
  for (int i = 0; i < order; ++i, points += components) {
    for (std::size_t c = 0; c < components; ++c) sum[c] += weights[i] * static_cast<double>(points[c]);
  }
  return sum;
}

glm::vec4 to_vector(const Point& point) {
  return glm::vec4(static_cast<float>(point[0]), static_cast<float>(point[1]), static_cast<float>(point[2]),
                   static_cast<float>(point[3]));
}

// What a map does not give is 0, w and q are 1.
glm::vec4 homogeneous(Point point, std::size_t components) {
  if (components < 4) point[3] = 1.0;
  return to_vector(point);
}

glm::vec3 direction(const Point& point) {
  return glm::vec3(static_cast<float>(point[0]), static_cast<float>(point[1]), static_cast<float>(point[2]));
}

// The unit vector along du x dv; zero where the surface has no normal. A rational point's derivatives are those of
// (x/w, y/w, z/w) times w^2.
// choice: derivatives by the parameters of the unit square: a domain that runs backwards does not turn the normal. So
// does Mesa.
glm::vec3 surface_normal(const Point& p, Point du, Point dv, bool rational) {
  if (rational) {
    for (std::size_t c = 0; c < 3; ++c) {
      du[c] = du[c] * p[3] - p[c] * du[3];
      dv[c] = dv[c] * p[3] - p[c] * dv[3];
    }
  }
  const double x = du[1] * dv[2] - du[2] * dv[1], y = du[2] * dv[0] - du[0] * dv[2], z = du[0] * dv[1] - du[1] * dv[0];
  const double length = std::sqrt((x * x + y * y) + z * z);
  if (!(length > 0.0)) return glm::vec3(0.0f);
  return direction({x / length, y / length, z / length, 0.0});
}

bool is_used(std::size_t kind) {
  return kind != MapSelection::none;
}

}  // namespace

MapSelection select_maps(const EvalGroup& group, int dimensions, std::uint32_t demand) {
  const auto& enabled = dimensions == 1 ? group.map1_enabled : group.map2_enabled;
  const auto last_enabled = [&](std::size_t first, std::size_t last) {
    for (std::size_t kind = last + 1; kind-- > first;) {
      if (enabled[kind]) return kind;
    }
    return MapSelection::none;
  };
  MapSelection selection;
  selection.position = last_enabled(map_vertex_3, map_vertex_4);
  if (demand & pipeline::attribute_color) selection.color = last_enabled(map_color, map_color);
  if (demand & pipeline::attribute_texture_coordinates(0)) {
    selection.texture_coordinates = last_enabled(map_texture_coordinate_1, map_texture_coordinate_4);
  }
  if (demand & pipeline::attribute_normal) {
    selection.auto_normal = dimensions == 2 && group.auto_normal_enabled;
    if (!selection.auto_normal) selection.normal = last_enabled(map_normal, map_normal);
  }
  return selection;
}

void CurveEvaluator::evaluate(double u, EvaluatedValues& out) const {
  const auto value = [&](std::size_t kind) {
    const Map1& map = maps_[kind];
    std::array<double, max_eval_order> weights;
    bernstein(map.order, parameter(map.u, u), weights.data(), nullptr);
    return weighted_sum(map.points.data(), static_cast<std::size_t>(map_components[kind]), map.order, weights.data());
  };
  const auto components = [](std::size_t kind) { return static_cast<std::size_t>(map_components[kind]); };
  out.position = homogeneous(value(selection_.position), components(selection_.position));
  if (is_used(selection_.normal)) out.normal = direction(value(selection_.normal));
  if (is_used(selection_.color)) out.color = to_vector(value(selection_.color));
  if (is_used(selection_.texture_coordinates)) {
    out.texture_coordinates =
        homogeneous(value(selection_.texture_coordinates), components(selection_.texture_coordinates));
  }
}

SurfaceEvaluator::SurfaceEvaluator(const EvaluatorMaps& maps, const MapSelection& selection) : selection_(selection) {
  use(maps, selection.position, position_, selection.auto_normal);
  use(maps, selection.normal, normal_, false);
  use(maps, selection.color, color_, false);
  use(maps, selection.texture_coordinates, texture_coordinates_, false);
}

void SurfaceEvaluator::use(const EvaluatorMaps& maps, std::size_t kind, Part& part, bool slopes) {
  if (!is_used(kind)) return;
  part.map = &maps.two[kind];
  part.components = static_cast<std::size_t>(map_components[kind]);
  part.slopes = slopes;
  weight_count_ += static_cast<std::size_t>(part.map->u_order) * (slopes ? 2 : 1);
}

void SurfaceEvaluator::weigh(double u, double* weights) const {
  for (const Part* part : {&position_, &normal_, &color_, &texture_coordinates_}) {
    if (part->map == nullptr) continue;
    const int order = part->map->u_order;
    bernstein(order, parameter(part->map->u, u), weights, part->slopes ? weights + order : nullptr);
    weights += part->slopes ? 2 * order : order;
  }
}

void SurfaceEvaluator::set_row(double v) {
  for (Part* part : {&position_, &normal_, &color_, &texture_coordinates_}) {
    if (part->map == nullptr) continue;
    const Map2& map = *part->map;
    std::array<double, max_eval_order> weights, slopes;
    bernstein(map.v_order, parameter(map.v, v), weights.data(), part->slopes ? slopes.data() : nullptr);
    const float* points = map.points.data();
    for (std::size_t i = 0; i < static_cast<std::size_t>(map.u_order); ++i) {
      const auto keep = [&](const double* factors, std::array<double, 4 * max_eval_order>& curve) {
        const Point sum = weighted_sum(points, part->components, map.v_order, factors);
        for (std::size_t c = 0; c < part->components; ++c) curve[i * part->components + c] = sum[c];
      };
      keep(weights.data(), part->curve);
      if (part->slopes) keep(slopes.data(), part->curve_slope);
      points += part->components * static_cast<std::size_t>(map.v_order);
    }
  }
}

void SurfaceEvaluator::evaluate(const double* weights, EvaluatedValues& out) const {
  const auto value = [&weights](const Part& part) {
    const Point point = weighted_sum(part.curve.data(), part.components, part.map->u_order, weights);
    weights += part.map->u_order;
    return point;
  };
  const double* const position_weights = weights;
  const Point p = value(position_);
  out.position = homogeneous(p, position_.components);
  if (position_.slopes) {
    const Point du = value(position_);  // its weights are the slopes
    const Point dv =
        weighted_sum(position_.curve_slope.data(), position_.components, position_.map->u_order, position_weights);
    out.normal = surface_normal(p, du, dv, position_.components == 4);
  }
  if (normal_.map != nullptr) out.normal = direction(value(normal_));
  if (color_.map != nullptr) out.color = to_vector(value(color_));
  if (texture_coordinates_.map != nullptr) {
    out.texture_coordinates = homogeneous(value(texture_coordinates_), texture_coordinates_.components);
  }
}

}  // namespace gouraud::api
