#include "conformance/oracle/texture_coordinates.h"

#include <cmath>

#include "conformance/oracle/lighting.h"

namespace gouraud::oracle {
namespace {

using pipeline::TexgenMode;

Vector4 times(const glm::mat4& m, const Vector4& v) {
  Vector4 out{};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      out[static_cast<std::size_t>(row)] += static_cast<double>(m[column][row]) * v[static_cast<std::size_t>(column)];
    }
  }
  return out;
}

double dot(const glm::vec4& plane, const Vector4& v) {
  return static_cast<double>(plane.x) * v[0] + static_cast<double>(plane.y) * v[1] + static_cast<double>(plane.z) * v[2] +
         static_cast<double>(plane.w) * v[3];
}

/// From the eye to the vertex, of length 1.
Vector3 view_direction(const Vector4& position_eye) {
  const double length = std::hypot(position_eye[0], position_eye[1], position_eye[2]);
  if (length == 0) return {};
  return {position_eye[0] / length, position_eye[1] / length, position_eye[2] / length};
}

/// r = u - 2 n (n . u).
Vector3 reflection(const Vector4& position_eye, const Vector3& normal) {
  const Vector3 u = view_direction(position_eye);
  const double twice = 2 * (normal[0] * u[0] + normal[1] * u[1] + normal[2] * u[2]);
  return {u[0] - twice * normal[0], u[1] - twice * normal[1], u[2] - twice * normal[2]};
}

double sphere_map(const Vector3& r, std::size_t coordinate) {
  const double m = 2 * std::hypot(r[0], r[1], r[2] + 1);
  return r[coordinate] / m + 0.5;
}

}  // namespace

std::vector<Vector4> texture_coordinates(const pipeline::DrawState& state, const pipeline::VertexBatch& batch, int index) {
  const auto i = static_cast<std::size_t>(index);
  const auto gather = [i](const auto& arrays) {
    return Vector4{arrays[0][i], arrays[1][i], arrays[2][i], arrays[3][i]};
  };
  const Vector4 position = gather(batch.position_object), position_eye = times(state.transform.modelview, position);
  std::vector<Vector4> out;
  for (std::size_t k = 0; k < state.texturing.count; ++k) {
    const std::size_t unit = state.texturing.unit[k].unit;
    const pipeline::TextureCoordinateSource& source = state.texture_coordinates.unit[unit];
    Vector4 coordinate{};
    for (std::size_t c = 0; c < 4; ++c) {
      const glm::vec4& plane = source.plane[c];
      switch (source.mode[c]) {
        case TexgenMode::given: coordinate[c] = batch.texture_coordinates[unit][c][i]; break;
        case TexgenMode::object_linear: coordinate[c] = dot(plane, position); break;
        case TexgenMode::eye_linear: coordinate[c] = dot(plane, position_eye); break;
        case TexgenMode::sphere_map: coordinate[c] = sphere_map(reflection(position_eye, Lighting(state, batch).normal_to_eye(index)), c); break;
        case TexgenMode::normal_map: coordinate[c] = Lighting(state, batch).normal_to_eye(index)[c]; break;
        case TexgenMode::reflection_map: coordinate[c] = reflection(position_eye, Lighting(state, batch).normal_to_eye(index))[c]; break;
      }
    }
    if (source.transformed) coordinate = times(source.matrix, coordinate);
    for (double& c : coordinate) c = std::isfinite(c) ? c : 0;
    out.push_back(coordinate);
  }
  return out;
}

}  // namespace gouraud::oracle
