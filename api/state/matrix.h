// Matrix arithmetic of the state machine [GL1.5 §2.11.2]: column major as GL's, in float, every product and sum
// rounded by itself, in the order that MESA-RULES 2.1 gives, so that matrices have Mesa's bits.
#pragma once

#include <glm/glm.hpp>

namespace gouraud::api {

/// a * b; each element ((a0 b0 + a1 b1) + a2 b2) + a3 b3.
glm::mat4 product(const glm::mat4& a, const glm::mat4& b);

/// m * v, summed in the same order.
glm::vec4 product(const glm::mat4& m, const glm::vec4& v);

/// A rotation by `angle_deg` about `axis`, which need not be of unit length. The identity if the axis is zero or not
/// finite; if the angle is not finite, the matrix is NaN where the angle matters.
glm::mat4 rotation(float angle_deg, const glm::vec3& axis);

/// The matrices of glFrustum and glOrtho, with divisions by zero giving infinities or NaN.
glm::mat4 frustum(float left, float right, float bottom, float top, float near_distance, float far_distance);
glm::mat4 orthographic(float left, float right, float bottom, float top, float near_distance, float far_distance);

/// Sine and cosine of an angle in radians, |angle| <= 2^20, to an error below 1e-15; no libm: the same bits everywhere.
struct SineCosine {
  double sine = 0.0, cosine = 1.0;
};
SineCosine sine_cosine(double angle_rad);

/// The inverse transpose of the upper 3x3 of `modelview`, which takes normals to eye space: computed in double, rounded
/// to float, always finite. choice: for a singular matrix, the cofactors without the division by the determinant.
glm::mat3 normal_matrix(const glm::mat4& modelview);

/// A plane of object space in eye space: the row vector times the inverse of `modelview`, in double. Not finite components
/// become 0. choice: of a singular matrix the cofactors stand for the inverse, as above.
glm::dvec4 to_eye(const glm::dvec4& plane_object, const glm::mat4& modelview);

/// The factor f of RESCALE_NORMAL [GL1.5 §2.11.3]: 1 / length of the third row of the inverse's upper 3x3. 1 if that is
/// not finite.
float rescale_factor(const glm::mat4& modelview);

}  // namespace gouraud::api
