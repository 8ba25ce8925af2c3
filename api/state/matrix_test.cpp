#include "api/state/matrix.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace gouraud::api {
namespace {

TEST(SineCosine, IsWithinAFewUlpOfTheExactValue) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponents(-20.0, 19.9);
  for (int i = 0; i < 100000; ++i) {
    const double angle = std::exp2(exponents(random)) * (i % 2 == 0 ? 1.0 : -1.0);
    const SineCosine found = sine_cosine(angle);
    ASSERT_NEAR(found.sine, static_cast<double>(std::sin(static_cast<long double>(angle))), 1e-15) << angle;
    ASSERT_NEAR(found.cosine, static_cast<double>(std::cos(static_cast<long double>(angle))), 1e-15) << angle;
  }
}

TEST(Rotation, AboutACoordinateAxisHasExactZerosAndOnes) {
  const glm::mat4 z = rotation(90.0f, {0, 0, 2});
  EXPECT_EQ(z[0][1], 1.0f);
  EXPECT_EQ(z[1][0], -1.0f);
  EXPECT_EQ(z[0][0], -4.37113883e-8f);  // MESA-RULES 2.1: cos of the float nearest to pi/2
  EXPECT_EQ(z[2], glm::vec4(0, 0, 1, 0));
  EXPECT_EQ(rotation(90.0f, {0, -3, 0}), glm::transpose(rotation(90.0f, {0, 3, 0})));
  EXPECT_EQ(rotation(90.0f, {5, 0, 0})[1][2], 1.0f);
}

TEST(Rotation, TurnsCounterclockwiseAboutAnyAxisAndKeepsItFixed) {
  for (const glm::vec3 axis :
       {glm::vec3(1, 1, 1), glm::vec3(-2, 0.5f, 3), glm::vec3(1e-9f, 2e-9f, 0), glm::vec3(1e30f, -1e30f, 1e30f)}) {
    const glm::mat4 r = rotation(120.0f, axis);
    const glm::dvec3 u = glm::normalize(glm::dvec3(axis));
    const glm::dvec3 kept = glm::dmat3(r) * u;
    EXPECT_LT(glm::length(kept - u), 1e-6);
    EXPECT_NEAR(glm::determinant(glm::dmat3(r)), 1.0, 1e-6);
  }
  const glm::vec4 turned = rotation(120.0f, {1, 1, 1}) * glm::vec4(1, 0, 0, 1);
  EXPECT_NEAR(turned.y, 1.0f, 1e-6f);
}

TEST(Rotation, WithoutADirectionOrAngleIsDefined) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(rotation(30.0f, {0, 0, 0}), glm::mat4(1.0f));
  EXPECT_EQ(rotation(30.0f, {nan, 0, 1}), glm::mat4(1.0f));
  EXPECT_EQ(rotation(30.0f, {infinity, 0, 0}), glm::mat4(1.0f));
  EXPECT_TRUE(std::isnan(rotation(infinity, {1, 0, 0})[1][1]));
  EXPECT_TRUE(std::isfinite(rotation(3e38f, {1, 2, 0})[1][1]));
}

TEST(Projection, HasTheElementsOfTheSpecification) {
  const glm::mat4 f = frustum(-1, 3, -2, 2, 1, 5);
  EXPECT_EQ(f, glm::mat4(0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0.5f, 0, -1.5f, -1, 0, 0, -2.5f, 0));
  const glm::mat4 o = orthographic(0, 4, 0, 2, -1, 1);
  EXPECT_EQ(o, glm::mat4(0.5f, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, -1, -1, 0, 1));
}

TEST(NormalMatrix, IsTheInverseTranspose) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> values(-3.0f, 3.0f);
  for (int i = 0; i < 1000; ++i) {
    glm::mat4 m(1.0f);
    for (int k = 0; k < 16; ++k) m[k / 4][k % 4] = values(random);
    const glm::dmat3 exact = glm::inverse(glm::transpose(glm::dmat3(m)));
    const glm::mat3 found = normal_matrix(m);
    for (int k = 0; k < 9; ++k) {
      const double expected = exact[k / 3][k % 3];
      ASSERT_NEAR(found[k / 3][k % 3], expected,
                  1e-6 * std::fabs(expected) + 1e-9 / std::fabs(glm::determinant(exact)));
    }
  }
}

TEST(NormalMatrix, OfASingularOrInvalidMatrixIsFinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const glm::mat4& m : {glm::mat4(0.0f), glm::mat4(1e38f), glm::mat4(1e-38f), glm::mat4(nan)}) {
    const glm::mat3 n = normal_matrix(m);
    for (int k = 0; k < 9; ++k) EXPECT_TRUE(std::isfinite(n[k / 3][k % 3]));
    EXPECT_TRUE(std::isfinite(rescale_factor(m)));
  }
}

TEST(RescaleFactor, UndoesAUniformScale) {
  glm::mat4 m = rotation(33.0f, {1, 2, 3});
  for (int column = 0; column < 3; ++column) m[column] *= 4.0f;
  EXPECT_NEAR(rescale_factor(m), 4.0f, 1e-5f);  // the normal matrix divides by 4
}

}  // namespace
}  // namespace gouraud::api
