#include "conformance/oracle/lighting.h"

#include <algorithm>
#include <cmath>

namespace gouraud::oracle {
namespace {

/// Where a switch in the equations hangs on an error of single precision.
constexpr double knife_edge = 1e-6;

double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The operator (.) of §2.14.1.
double positive_dot(const Vector3& a, const Vector3& b) {
  return std::max(dot(a, b), 0.0);
}

Vector3 add(const Vector3& a, const Vector3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector3 scale(const Vector3& a, double s) {
  return {a[0] * s, a[1] * s, a[2] * s};
}

Vector3 normalized(const Vector3& a) {
  const double length = std::hypot(a[0], a[1], a[2]);
  return length > 0 ? scale(a, 1.0 / length) : Vector3{};
}

Vector3 widen(const glm::vec3& a) {
  return {a.x, a.y, a.z};
}
Color widen(const glm::vec4& a) {
  return {a.x, a.y, a.z, a.w};
}

/// sum += factor * a * b on RGB. A product that is black adds nothing, whatever the factor.
void accumulate(Color& sum, double factor, const glm::vec4& a, const glm::vec4& b) {
  for (int i = 0; i < 3; ++i) {
    const double product = static_cast<double>(a[i]) * static_cast<double>(b[i]);
    if (product != 0) sum[static_cast<std::size_t>(i)] += factor * product;
  }
}

bool is_black(const glm::vec4& a, const glm::vec4& b) {
  return a.x * b.x == 0 && a.y * b.y == 0 && a.z * b.z == 0;
}

/// [GL1.5 §2.14.6]; NaN becomes 0.
Color clamped(const Color& color) {
  Color out;
  for (std::size_t i = 0; i < 4; ++i) out[i] = color[i] > 0 ? std::min(color[i], 1.0) : 0.0;
  return out;
}

/// Rows of the inverse of the upper 3x3 of `m`; false if it is singular.
bool invert_upper_3x3(const glm::mat4& m, std::array<Vector3, 3>& inverse) {
  const auto at = [&m](std::size_t row, std::size_t column) {
    return static_cast<double>(m[static_cast<int>(column % 3)][static_cast<int>(row % 3)]);
  };
  const auto cofactor = [&at](std::size_t row, std::size_t column) {
    return at(row + 1, column + 1) * at(row + 2, column + 2) - at(row + 1, column + 2) * at(row + 2, column + 1);
  };
  const double determinant = at(0, 0) * cofactor(0, 0) + at(0, 1) * cofactor(0, 1) + at(0, 2) * cofactor(0, 2);
  if (determinant == 0 || !std::isfinite(determinant)) return false;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) inverse[row][column] = cofactor(column, row) / determinant;
  }
  return true;
}

/// The material in force at a vertex: the last run that begins at or before it.
const pipeline::MaterialPair& material_at(const pipeline::DrawState& state, const pipeline::VertexBatch& batch,
                                          int index) {
  const pipeline::MaterialPair* material = &state.lighting.material;
  for (const pipeline::MaterialRun& run : batch.material_runs) {
    if (run.first <= index) material = &run.material;
  }
  return *material;
}

/// [GL1.5 §2.14.3]
pipeline::Material track_color(pipeline::Material material, std::uint8_t bits, const glm::vec4& color) {
  if (bits & pipeline::material_ambient) material.ambient = color;
  if (bits & pipeline::material_diffuse) material.diffuse = color;
  if (bits & pipeline::material_specular) material.specular = color;
  if (bits & pipeline::material_emission) material.emission = color;
  return material;
}

}  // namespace

Lighting::Lighting(const pipeline::DrawState& state, const pipeline::VertexBatch& batch)
    : state_(state), batch_(batch) {
  const pipeline::TransformState& transform = state.transform;
  if (invert_upper_3x3(transform.modelview, inverse_)) {
    rescale_ = 1.0 / std::hypot(inverse_[2][0], inverse_[2][1], inverse_[2][2]);
  } else {
    // The inverse of a singular matrix is arbitrary: take the pipeline's.
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) {
        inverse_[row][column] = transform.normal_matrix[static_cast<int>(row)][static_cast<int>(column)];
      }
    }
    rescale_ = transform.rescale_factor;
  }
}

/// (nx ny nz) M^-1 [GL1.5 §2.11.3]
Vector3 Lighting::normal_to_eye(int index) const {
  const auto i = static_cast<std::size_t>(index);
  Vector3 normal{};
  for (std::size_t row = 0; row < 3; ++row) {
    normal = add(normal, scale(inverse_[row], static_cast<double>(batch_.normal_object[row][i])));
  }
  switch (state_.transform.normal_scaling) {
    case pipeline::NormalScaling::rescale:
      return scale(normal, rescale_);
    case pipeline::NormalScaling::normalize:
      return normalized(normal);
    case pipeline::NormalScaling::none:
      break;
  }
  return normal;
}

Lighting::Lit Lighting::light(const Vector3& position_eye, const Vector3& normal_eye,
                              const pipeline::Material& material) {
  const pipeline::LightingState& lighting = state_.lighting;
  Lit lit;
  for (std::size_t i = 0; i < 3; ++i) lit.primary[i] = material.emission[static_cast<int>(i)];
  lit.primary[3] = material.diffuse.w;
  accumulate(lit.primary, 1.0, material.ambient, lighting.scene_ambient);
  Color& specular_sum = lighting.separate_specular ? lit.secondary : lit.primary;

  for (std::size_t i = 0; i < lighting.light_count; ++i) {
    const pipeline::PreparedLight& source = lighting.lights[i];
    const Vector3 offset = add(widen(source.position_eye), scale(position_eye, -1.0));
    const Vector3 to_light = source.positional ? normalized(offset) : widen(source.position_eye);

    // Attenuation and spot light [GL1.5 §2.14.1 eq 2.4, 2.5].
    double factor = 1.0;
    if (source.positional) {
      const double d = std::hypot(offset[0], offset[1], offset[2]);
      const Vector3 k = widen(source.attenuation);
      factor = 1.0 / (k[0] + k[1] * d + k[2] * d * d);
    }
    if (source.spot) {
      const double cosine = positive_dot(scale(to_light, -1.0), widen(source.spot_direction_eye));
      const double cutoff = source.spot_cutoff_cosine;
      if (std::abs(cosine - cutoff) < knife_edge) on_knife_edge_ = true;
      factor *= cosine >= cutoff ? std::pow(cosine, static_cast<double>(source.spot_exponent)) : 0.0;
    }

    // Ambient, diffuse, specular [GL1.5 §2.14.1 eq 2.2, 2.3].
    accumulate(lit.primary, factor, material.ambient, source.ambient);
    const double n_dot_vp = positive_dot(normal_eye, to_light);
    accumulate(lit.primary, factor * n_dot_vp, material.diffuse, source.diffuse);
    if (is_black(material.specular, source.specular)) continue;
    const Vector3 to_eye = lighting.local_viewer ? normalized(scale(position_eye, -1.0)) : Vector3{0, 0, 1};
    const Vector3 half_vector = normalized(add(to_light, to_eye));
    const double highlight = std::pow(positive_dot(normal_eye, half_vector), static_cast<double>(material.shininess));
    if (std::abs(dot(normal_eye, to_light)) < knife_edge && highlight > knife_edge) on_knife_edge_ = true;
    if (n_dot_vp > 0) accumulate(specular_sum, factor * highlight, material.specular, source.specular);
  }
  return lit;
}

VertexColors Lighting::shade(int index) {
  const auto i = static_cast<std::size_t>(index);
  const pipeline::LightingState& lighting = state_.lighting;
  const glm::vec4 color(batch_.color[0][i], batch_.color[1][i], batch_.color[2][i], batch_.color[3][i]);
  VertexColors out;
  if (!lighting.enabled) {
    out.primary[front] = out.primary[back] = clamped(widen(color));
    if (state_.color_sum) {
      const glm::vec4 secondary(batch_.secondary_color[0][i], batch_.secondary_color[1][i], batch_.secondary_color[2][i], 0);
      out.secondary[front] = out.secondary[back] = clamped(widen(secondary));
    }
    return out;
  }

  Vector4 eye{};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      eye[row] += static_cast<double>(state_.transform.modelview[static_cast<int>(column)][static_cast<int>(row)]) *
                  static_cast<double>(batch_.position_object[column][i]);
    }
  }
  const double divisor = eye[3] == 0 ? 1.0 : eye[3];
  const Vector3 position{eye[0] / divisor, eye[1] / divisor, eye[2] / divisor};
  const Vector3 normal = lighting.light_count > 0 ? normal_to_eye(index) : Vector3{};
  const pipeline::MaterialPair& material = material_at(state_, batch_, index);

  on_knife_edge_ = false;
  const Lit lit = light(position, normal, track_color(material.front, lighting.color_material_front, color));
  out.primary[front] = out.primary[back] = clamped(lit.primary);
  out.secondary[front] = out.secondary[back] = clamped(lit.secondary);
  if (lighting.two_sided) {
    const Lit lit_back =
        light(position, scale(normal, -1.0), track_color(material.back, lighting.color_material_back, color));
    out.primary[back] = clamped(lit_back.primary);
    out.secondary[back] = clamped(lit_back.secondary);
  }
  if (on_knife_edge_) ++knife_edges_;
  return out;
}

}  // namespace gouraud::oracle
