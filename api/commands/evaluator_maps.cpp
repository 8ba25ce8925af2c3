// Takes maps and grids from the application and gives them back [GL1.5 §5.1, §6.1.3].
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "api/commands/evaluators.h"
#include "api/commands/state_rows.h"
#include "api/registry/conversions.h"

namespace gouraud::api {
namespace {

using enum ValueKind;

std::size_t kind_of(GLenum target, GLenum first) {
  return target - first < map_kinds ? target - first : map_kinds;
}

// What both dimensions of a map must satisfy.
template <class T>
bool accepts(Context& context, const char* command, std::size_t kind, T first, T last, GLint stride, GLint order) {
  const auto refuse = [&](const char* message) {
    context.record_error(GL_INVALID_VALUE, command, message);
    return false;
  };
  if (to_float(first) == to_float(last)) return refuse("the domain is empty");
  if (stride < map_components[kind]) return refuse("the stride is smaller than a point");
  if (order < 1 || order > max_eval_order) return refuse("the order is out of range");
  return true;
}

template <class T>
bool accepts_points(Context& context, const char* command, const T* points) {
  if (points == nullptr) {
    context.record_error(GL_INVALID_VALUE, command, "there are no points");
    return false;
  }
  if (context.state.texture.active_unit != 0) {
    context.record_error(GL_INVALID_OPERATION, command, "the active texture unit is not unit 0");
    return false;
  }
  return true;
}

// Appends the point `offset` values behind the first one. The application's memory need not be aligned.
template <class T>
void append_point(const T* points, std::size_t offset, std::size_t components, std::vector<float>& out) {
  std::array<T, 4> values{};
  const auto address = reinterpret_cast<std::uintptr_t>(points) + offset * sizeof(T);
  std::memcpy(values.data(), reinterpret_cast<const void*>(address), components * sizeof(T));
  for (std::size_t c = 0; c < components; ++c) out.push_back(to_float(values[c]));
}

template <class T>
void define(Context& context, const char* command, GLenum target, T u1, T u2, GLint stride, GLint order,
            const T* points) {
  const std::size_t kind = kind_of(target, GL_MAP1_COLOR_4);
  if (kind == map_kinds) return context.record_error(GL_INVALID_ENUM, command, "target is unknown");
  if (!accepts(context, command, kind, u1, u2, stride, order) || !accepts_points(context, command, points)) return;
  const auto components = static_cast<std::size_t>(map_components[kind]);
  Map1 map{order, {to_float(u1), to_float(u2)}, {}};
  map.points.reserve(static_cast<std::size_t>(order) * components);
  for (GLint i = 0; i < order; ++i) {
    append_point(points, static_cast<std::size_t>(i) * static_cast<std::size_t>(stride), components, map.points);
  }
  context.state.maps.one[kind] = std::move(map);
}

/// One direction of a surface.
template <class T>
struct Direction {
  T first, last;
  GLint stride, order;
  MapDomain domain() const { return {to_float(first), to_float(last)}; }
};

template <class T>
void define(Context& context, const char* command, GLenum target, const Direction<T>& u, const Direction<T>& v,
            const T* points) {
  const std::size_t kind = kind_of(target, GL_MAP2_COLOR_4);
  if (kind == map_kinds) return context.record_error(GL_INVALID_ENUM, command, "target is unknown");
  if (!accepts(context, command, kind, u.first, u.last, u.stride, u.order)) return;
  if (!accepts(context, command, kind, v.first, v.last, v.stride, v.order)) return;
  if (!accepts_points(context, command, points)) return;
  const auto components = static_cast<std::size_t>(map_components[kind]);
  Map2 map{u.order, v.order, u.domain(), v.domain(), {}};
  map.points.reserve(static_cast<std::size_t>(u.order) * static_cast<std::size_t>(v.order) * components);
  for (std::size_t i = 0; i < static_cast<std::size_t>(u.order); ++i) {
    for (std::size_t j = 0; j < static_cast<std::size_t>(v.order); ++j) {
      const std::size_t offset = i * static_cast<std::size_t>(u.stride) + j * static_cast<std::size_t>(v.stride);
      append_point(points, offset, components, map.points);
    }
  }
  context.state.maps.two[kind] = std::move(map);
}

// The values that a query of GetMap gives.
bool read_map(Context& context, const char* command, GLenum target, GLenum query, std::vector<double>& values) {
  const std::size_t kind1 = kind_of(target, GL_MAP1_COLOR_4), kind2 = kind_of(target, GL_MAP2_COLOR_4);
  const EvaluatorMaps& maps = context.state.maps;
  const Map1* const one = kind1 < map_kinds ? &maps.one[kind1] : nullptr;
  const Map2* const two = kind2 < map_kinds ? &maps.two[kind2] : nullptr;
  if (one == nullptr && two == nullptr) {
    context.record_error(GL_INVALID_ENUM, command, "target is unknown");
    return false;
  }
  const std::vector<float>& points = one != nullptr ? one->points : two->points;
  const auto give = [&values](auto... numbers) { values = {static_cast<double>(numbers)...}; };
  switch (query) {
    case GL_COEFF:
      values.assign(points.begin(), points.end());
      return true;
    case GL_ORDER:
      one != nullptr ? give(one->order) : give(two->u_order, two->v_order);
      return true;
    case GL_DOMAIN:
      one != nullptr ? give(one->u.first, one->u.last)
                     : give(two->u.first, two->u.last, two->v.first, two->v.last);
      return true;
    default:
      context.record_error(GL_INVALID_ENUM, command, "query is unknown");
      return false;
  }
}

template <class T, class Convert>
void get_map(Context& context, const char* command, GLenum target, GLenum query, T* v, Convert convert) {
  std::vector<double> values;
  if (!read_map(context, command, target, query, values)) return;
  for (const double value : values) *v++ = convert(value);
}

constexpr StateRow rows[] = {
    {GL_MAP1_GRID_DOMAIN, real, 2,
     [](const Context& c, StateValue& v) {
       const MapDomain& u = c.state.eval.grid1_u.domain;
       set(v, u.first, u.last);
     }},
    {GL_MAP1_GRID_SEGMENTS, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.eval.grid1_u.segments); }},
    {GL_MAP2_GRID_DOMAIN, real, 4,
     [](const Context& c, StateValue& v) {
       const MapDomain &u = c.state.eval.grid2_u.domain, &w = c.state.eval.grid2_v.domain;
       set(v, u.first, u.last, w.first, w.last);
     }},
    {GL_MAP2_GRID_SEGMENTS, integer, 2,
     [](const Context& c, StateValue& v) { set(v, c.state.eval.grid2_u.segments, c.state.eval.grid2_v.segments); }},
    {GL_MAX_EVAL_ORDER, integer, 1, [](const Context&, StateValue& v) { set(v, max_eval_order); }},
};

}  // namespace

void Map1f(Context& context, GLenum target, GLfloat u1, GLfloat u2, GLint stride, GLint order, const GLfloat* points) {
  define(context, "glMap1f", target, u1, u2, stride, order, points);
}

void Map1d(Context& context, GLenum target, GLdouble u1, GLdouble u2, GLint stride, GLint order,
           const GLdouble* points) {
  define(context, "glMap1d", target, u1, u2, stride, order, points);
}

void Map2f(Context& context, GLenum target, GLfloat u1, GLfloat u2, GLint ustride, GLint uorder, GLfloat v1,
           GLfloat v2, GLint vstride, GLint vorder, const GLfloat* points) {
  define<GLfloat>(context, "glMap2f", target, {u1, u2, ustride, uorder}, {v1, v2, vstride, vorder}, points);
}

void Map2d(Context& context, GLenum target, GLdouble u1, GLdouble u2, GLint ustride, GLint uorder, GLdouble v1,
           GLdouble v2, GLint vstride, GLint vorder, const GLdouble* points) {
  define<GLdouble>(context, "glMap2d", target, {u1, u2, ustride, uorder}, {v1, v2, vstride, vorder}, points);
}

void GetMapfv(Context& context, GLenum target, GLenum query, GLfloat* v) {
  get_map(context, "glGetMapfv", target, query, v, [](double value) { return static_cast<GLfloat>(value); });
}

void GetMapdv(Context& context, GLenum target, GLenum query, GLdouble* v) {
  get_map(context, "glGetMapdv", target, query, v, [](double value) { return value; });
}

void GetMapiv(Context& context, GLenum target, GLenum query, GLint* v) {
  get_map(context, "glGetMapiv", target, query, v, [](double value) { return to_integer(value, integer); });
}

std::span<const StateRow> evaluator_rows() {
  return rows;
}

}  // namespace gouraud::api
