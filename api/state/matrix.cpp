#include "api/state/matrix.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

#include "pipeline/simd/float_mode.h"

namespace gouraud::api {

namespace {

/// A matrix column, of which the compiler computes the four elements at once, each as if alone.
using Column = float __attribute__((vector_size(4 * sizeof(float))));
using Columns = std::array<Column, 4>;

Columns columns_of(const glm::mat4& m) {
  return std::bit_cast<Columns>(m);
}

Column sum_of_columns(const Columns& m, const glm::vec4& factors) {
  return ((m[0] * factors.x + m[1] * factors.y) + m[2] * factors.z) + m[3] * factors.w;
}

}  // namespace

glm::mat4 product(const glm::mat4& a, const glm::mat4& b) {
  const pipeline::IeeeFloats floats;
  const Columns columns = columns_of(a);
  Columns result;
  for (int i = 0; i < 4; ++i) result[static_cast<std::size_t>(i)] = sum_of_columns(columns, b[i]);
  return std::bit_cast<glm::mat4>(result);
}

glm::vec4 product(const glm::mat4& m, const glm::vec4& v) {
  const pipeline::IeeeFloats floats;
  return std::bit_cast<glm::vec4>(sum_of_columns(columns_of(m), v));
}

namespace {

/// -1 / (k (k - 1)): what turns a term of the sine's or cosine's series, times r^2, into the next.
constexpr std::array<double, 19> minus_reciprocal = [] {
  std::array<double, 19> result{};
  for (std::size_t k = 2; k < result.size(); ++k) result[k] = -1.0 / (static_cast<double>(k) * static_cast<double>(k - 1));
  return result;
}();

}  // namespace

SineCosine sine_cosine(double angle_rad) {
  // Reduce to r in [-pi/4, pi/4] by quadrants. The first two parts of pi/2 have 33 bits, so that their products with
  // quadrants below 2^20 are exact.
  constexpr double two_over_pi = 0.63661977236758134308;
  constexpr double half_pi_1 = 0x1.921fb544p+0, half_pi_2 = 0x1.0b4611a6p-34, half_pi_3 = 0x1.3198a2e037073p-69;
  const double quadrants = std::nearbyint(angle_rad * two_over_pi);
  const double r = ((angle_rad - quadrants * half_pi_1) - quadrants * half_pi_2) - quadrants * half_pi_3;

  // Taylor series: the first term left out is below 1e-17 for |r| <= pi/4.
  const double r2 = r * r;
  double sine = 0.0, cosine = 0.0;
  for (std::size_t k = 17; k >= 3; k -= 2) sine = (1.0 + sine) * (r2 * minus_reciprocal[k]);
  for (std::size_t k = 18; k >= 2; k -= 2) cosine = (1.0 + cosine) * (r2 * minus_reciprocal[k]);
  sine = r + r * sine;
  cosine = 1.0 + cosine;

  switch (static_cast<int>(quadrants) & 3) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

namespace {

struct FloatSineCosine {
  float sine, cosine;
};

// As Mesa: the angle in radians is rounded to float first, so a rotation by 90 degrees has cosine -4.37e-8, not 0.
// choice: angles beyond a million degrees are first reduced, exactly, to one turn.
FloatSineCosine rotation_sine_cosine(float angle_deg) {
  if (!std::isfinite(angle_deg)) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    return {nan, nan};
  }
  double reduced_deg = angle_deg;
  if (std::fabs(reduced_deg) > 1e6) reduced_deg = std::fmod(reduced_deg, 360.0);
  const float angle_rad = static_cast<float>(reduced_deg * 3.14159265358979323846 / 180.0);
  const SineCosine exact = sine_cosine(angle_rad);
  return {static_cast<float>(exact.sine), static_cast<float>(exact.cosine)};
}

glm::mat4 rotation_about_axis(int axis, float s, float c) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  glm::mat4 result(1.0f);
  result[u][u] = c;
  result[v][v] = c;
  result[u][v] = s;
  result[v][u] = -s;
  return result;
}

// The axis at unit length; zero if it has no direction. Lengths that float cannot square go through double.
glm::vec3 unit_axis(const glm::vec3& axis) {
  const float length = std::sqrt((axis.x * axis.x + axis.y * axis.y) + axis.z * axis.z);
  if (length > 1e-4f && std::isfinite(length)) return glm::vec3(axis.x / length, axis.y / length, axis.z / length);
  const glm::dvec3 wide(axis);
  const double wide_length = std::sqrt((wide.x * wide.x + wide.y * wide.y) + wide.z * wide.z);
  if (!(wide_length > 0.0) || !std::isfinite(wide_length)) return glm::vec3(0.0f);
  return glm::vec3(wide / wide_length);
}

}  // namespace

glm::mat4 rotation(float angle_deg, const glm::vec3& axis) {
  const pipeline::IeeeFloats floats;
  const auto [s, c] = rotation_sine_cosine(angle_deg);

  // An axis of the coordinate system: exact zeros and ones elsewhere.
  for (int i = 0; i < 3; ++i) {
    if (axis[i] != 0.0f && std::isfinite(axis[i]) && axis[(i + 1) % 3] == 0.0f && axis[(i + 2) % 3] == 0.0f) {
      return rotation_about_axis(i, axis[i] < 0.0f ? -s : s, c);
    }
  }

  // R = u uT + cos (I - u uT) + sin S, in the form (1 - cos) u uT + cos I + sin S.
  const glm::vec3 u = unit_axis(axis);
  if (u == glm::vec3(0.0f)) return glm::mat4(1.0f);
  const float one_minus_c = 1.0f - c;
  const float xx = u.x * u.x, yy = u.y * u.y, zz = u.z * u.z;
  const float xy = u.x * u.y, yz = u.y * u.z, zx = u.z * u.x;
  const float xs = u.x * s, ys = u.y * s, zs = u.z * s;
  return glm::mat4(one_minus_c * xx + c, one_minus_c * xy + zs, one_minus_c * zx - ys, 0.0f,  //
                   one_minus_c * xy - zs, one_minus_c * yy + c, one_minus_c * yz + xs, 0.0f,  //
                   one_minus_c * zx + ys, one_minus_c * yz - xs, one_minus_c * zz + c, 0.0f,  //
                   0.0f, 0.0f, 0.0f, 1.0f);
}

glm::mat4 frustum(float left, float right, float bottom, float top, float near_distance, float far_distance) {
  const pipeline::IeeeFloats floats;
  glm::mat4 m(0.0f);
  m[0][0] = (2.0f * near_distance) / (right - left);
  m[1][1] = (2.0f * near_distance) / (top - bottom);
  m[2][0] = (right + left) / (right - left);
  m[2][1] = (top + bottom) / (top - bottom);
  m[2][2] = -(far_distance + near_distance) / (far_distance - near_distance);
  m[2][3] = -1.0f;
  m[3][2] = -(2.0f * far_distance * near_distance) / (far_distance - near_distance);
  return m;
}

glm::mat4 orthographic(float left, float right, float bottom, float top, float near_distance, float far_distance) {
  const pipeline::IeeeFloats floats;
  glm::mat4 m(1.0f);
  m[0][0] = 2.0f / (right - left);
  m[1][1] = 2.0f / (top - bottom);
  m[2][2] = -2.0f / (far_distance - near_distance);
  m[3][0] = -(right + left) / (right - left);
  m[3][1] = -(top + bottom) / (top - bottom);
  m[3][2] = -(far_distance + near_distance) / (far_distance - near_distance);
  return m;
}

namespace {

float to_finite_float(double value) {
  constexpr double largest = std::numeric_limits<float>::max();
  if (std::isnan(value)) return 0.0f;
  return static_cast<float>(value > largest ? largest : value < -largest ? -largest : value);
}

// The cofactors of the upper 3x3 and its determinant: the inverse transpose is cofactors / determinant.
struct Cofactors {
  glm::dmat3 matrix;
  double determinant;
};
Cofactors cofactors_of(const glm::mat4& m) {
  const glm::dvec3 a(m[0].x, m[0].y, m[0].z), b(m[1].x, m[1].y, m[1].z), c(m[2].x, m[2].y, m[2].z);
  const glm::dvec3 bc = glm::cross(b, c);
  return {glm::dmat3(bc, glm::cross(c, a), glm::cross(a, b)), (a.x * bc.x + a.y * bc.y) + a.z * bc.z};
}

bool invertible(double determinant) {
  return determinant != 0.0 && std::isfinite(determinant);
}

}  // namespace

glm::mat3 normal_matrix(const glm::mat4& modelview) {
  const pipeline::IeeeFloats floats;
  const auto [cofactors, determinant] = cofactors_of(modelview);
  const double divisor = invertible(determinant) ? determinant : 1.0;
  glm::mat3 result;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) result[column][row] = to_finite_float(cofactors[column][row] / divisor);
  }
  return result;
}

float rescale_factor(const glm::mat4& modelview) {
  const pipeline::IeeeFloats floats;
  const auto [cofactors, determinant] = cofactors_of(modelview);
  // Row 3 of the inverse is column 3 of the inverse transpose.
  const glm::dvec3 row = cofactors[2] / (invertible(determinant) ? determinant : 1.0);
  const double f = 1.0 / std::sqrt((row.x * row.x + row.y * row.y) + row.z * row.z);
  return std::isfinite(f) && f > 0.0 ? to_finite_float(f) : 1.0f;
}

glm::dvec4 to_eye(const glm::dvec4& plane_object, const glm::mat4& modelview) {
  const pipeline::IeeeFloats floats;
  const glm::dmat4 m(modelview);
  // Cofactor (row, column) belongs to the inverse's element (column, row), so plane . inverse is a sum over columns.
  const auto minor = [&](int row, int column) {
    std::array<int, 3> r{}, c{};
    for (std::size_t k = 0; k < 3; ++k) {
      r[k] = static_cast<int>(k) + (static_cast<int>(k) >= row ? 1 : 0);
      c[k] = static_cast<int>(k) + (static_cast<int>(k) >= column ? 1 : 0);
    }
    const auto at = [&](std::size_t i, std::size_t j) { return m[c[j]][r[i]]; };
    return at(0, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1)) - at(0, 1) * (at(1, 0) * at(2, 2) - at(1, 2) * at(2, 0)) +
           at(0, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0));
  };
  const auto cofactor = [&](int row, int column) { return (row + column) % 2 == 0 ? minor(row, column) : -minor(row, column); };
  double determinant = 0.0;
  for (int column = 0; column < 4; ++column) determinant += m[column][0] * cofactor(0, column);
  const double divisor = std::isfinite(determinant) && determinant != 0.0 ? determinant : 1.0;
  glm::dvec4 result(0.0);
  for (int row = 0; row < 4; ++row) {
    double sum = 0.0;
    for (int column = 0; column < 4; ++column) sum += plane_object[column] * cofactor(row, column);
    result[row] = std::isfinite(sum / divisor) ? sum / divisor : 0.0;
  }
  return result;
}

}  // namespace gouraud::api
