#include "pipeline/geometry/texture_coordinates.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/geometry/normals.h"
#include "pipeline/geometry/test_support.h"
#include "pipeline/geometry/transform.h"

namespace gouraud::pipeline {
namespace {

constexpr TextureCoordinateLayout all_four{0, 3, true};

struct Texgen {
  explicit Texgen(unsigned seed, bool wild = false) : batch(random_batch(seed, 100, wild)) {
    Numbers number(seed + 1, wild);
    for (auto& array : batch->texture_coordinates[1]) {
      for (float& value : array) value = 3 * number();
    }
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) {
        transform.modelview[column][row] = (row == column ? 1.0f : 0.0f) + 0.3f * number();
        source.matrix[column][row] = 2 * number();
      }
      source.plane[static_cast<std::size_t>(column)] = {number(), number(), number(), number()};
    }
    transform.normal_scaling = NormalScaling::normalize;
  }
  void run() {
    transform_to_clip(transform, *batch, *vertices);
    transform_to_eye(transform, *batch, *vertices);
    transform_normals(transform, *batch, *vertices);
    make_texture_coordinates(source, all_four, 1, *batch, *vertices);
  }
  double eye(std::size_t k, std::size_t i) const { return vertices->position_eye[k][i]; }
  double dot(const glm::vec4& plane, const auto& position, std::size_t i) const {
    double sum = 0;
    for (int k = 0; k < 4; ++k) sum += static_cast<double>(plane[k]) * position[static_cast<std::size_t>(k)][i];
    return sum;
  }
  /// [GL1.5 §2.11.4].
  std::array<double, 3> reflection(std::size_t i) const {
    const double length = std::hypot(eye(0, i), eye(1, i), eye(2, i));
    double along = 0;
    for (std::size_t k = 0; k < 3; ++k) along += vertices->normal_eye[k][i] * eye(k, i) / length;
    std::array<double, 3> r;
    for (std::size_t k = 0; k < 3; ++k) r[k] = eye(k, i) / length - 2 * vertices->normal_eye[k][i] * along;
    return r;
  }

  TransformState transform;
  TextureCoordinateSource source;
  std::unique_ptr<VertexBatch> batch;
  std::unique_ptr<ProcessedVertices> vertices = blank_vertices();
};

TEST(TextureCoordinates, FollowTheFormulasOfAllModes) {
  for_each_target([] {
    Texgen texgen(1);
    texgen.source.mode = {TexgenMode::object_linear, TexgenMode::eye_linear, TexgenMode::reflection_map, TexgenMode::given};
    texgen.run();
    for (std::size_t i = 0; i < 100; ++i) {
      const auto& v = texgen.vertices->varying;
      EXPECT_NEAR(v[0][i], texgen.dot(texgen.source.plane[0], texgen.batch->position_object, i), 1e-6);
      EXPECT_NEAR(v[1][i], texgen.dot(texgen.source.plane[1], texgen.vertices->position_eye, i), 1e-6);
      EXPECT_NEAR(v[2][i], texgen.reflection(i)[2], 1e-6);
      EXPECT_EQ(v[3][i], texgen.batch->texture_coordinates[1][3][i]);
    }
    texgen.source.mode = {TexgenMode::sphere_map, TexgenMode::sphere_map, TexgenMode::normal_map, TexgenMode::given};
    texgen.run();
    for (std::size_t i = 0; i < 100; ++i) {
      const std::array<double, 3> r = texgen.reflection(i);
      const double m = 2 * std::hypot(r[0], r[1], r[2] + 1);
      EXPECT_NEAR(texgen.vertices->varying[0][i], r[0] / m + 0.5, 1e-7);
      EXPECT_NEAR(texgen.vertices->varying[1][i], r[1] / m + 0.5, 1e-7);
      EXPECT_EQ(texgen.vertices->varying[2][i], texgen.vertices->normal_eye[2][i]);
    }
  });
}

TEST(TextureCoordinates, AreMultipliedByTheMatrixLast) {
  Texgen texgen(2);
  texgen.source.mode[0] = TexgenMode::object_linear;
  texgen.source.transformed = true;
  texgen.run();
  for (std::size_t i = 0; i < 100; ++i) {
    const auto& given = texgen.batch->texture_coordinates[1];
    const double s = texgen.dot(texgen.source.plane[0], texgen.batch->position_object, i);
    for (int row = 0; row < 4; ++row) {
      double sum = s * texgen.source.matrix[0][row];
      for (int c = 1; c < 4; ++c) sum += static_cast<double>(given[static_cast<std::size_t>(c)][i]) * texgen.source.matrix[c][row];
      EXPECT_NEAR(texgen.vertices->varying[static_cast<std::size_t>(row)][i], sum, 2e-6);
    }
  }
}

TEST(TextureCoordinates, HaveTheSameBitsOnEveryInstructionSetAndAreFinite) {
  constexpr std::array<TexgenMode, 6> modes{TexgenMode::given, TexgenMode::object_linear, TexgenMode::eye_linear,
                                            TexgenMode::sphere_map, TexgenMode::normal_map, TexgenMode::reflection_map};
  for (const bool transformed : {false, true}) {
    for (unsigned round = 0; round < 6; ++round) {
      std::unique_ptr<ProcessedVertices> reference;
      for_each_target([&] {
        Texgen texgen(round, true);
        for (std::size_t c = 0; c < 3; ++c) texgen.source.mode[c] = modes[(round + c) % 6];
        if (texgen.source.mode[2] == TexgenMode::sphere_map) texgen.source.mode[2] = TexgenMode::eye_linear;
        texgen.source.transformed = transformed;
        texgen.run();
        if (!reference) reference = std::move(texgen.vertices);
        else
          for (std::size_t k = 0; k < 4; ++k) EXPECT_TRUE(same_numbers(reference->varying[k], texgen.vertices->varying[k], 100));
      });
    }
  }
}

TEST(SphereMap, OfTheDirectionThatHasNoPlaceIsTheMiddle) {
  Texgen texgen(3);
  texgen.transform.modelview = glm::mat4(1.0f);
  for (std::size_t k = 0; k < 4; ++k) texgen.batch->position_object[k][0] = k == 2 ? -2.0f : k == 3 ? 1.0f : 0.0f;
  for (std::size_t k = 0; k < 3; ++k) texgen.batch->normal_object[k][0] = k == 0 ? 1.0f : 0.0f;
  texgen.source.mode = {TexgenMode::sphere_map, TexgenMode::sphere_map, TexgenMode::given, TexgenMode::given};
  texgen.run();
  EXPECT_EQ(texgen.vertices->varying[0][0], 0.5f);
  EXPECT_EQ(texgen.vertices->varying[1][0], 0.5f);
}

TEST(FogCoordinates, AreTheDistanceFromTheEyePlaneOrGiven) {
  Texgen texgen(4);
  texgen.batch->fog_coordinate[0].fill(-7.0f);
  transform_to_eye(texgen.transform, *texgen.batch, *texgen.vertices);
  FogState fog;
  fog.mode = FogMode::exp;
  make_fog_coordinates(texgen.transform, fog, *texgen.batch, texgen.vertices->varying[5]);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(texgen.vertices->varying[5][i], std::abs(texgen.vertices->position_eye[2][i]));
  fog.from_coordinate = true;
  make_fog_coordinates(texgen.transform, fog, *texgen.batch, texgen.vertices->varying[5]);
  EXPECT_EQ(texgen.vertices->varying[5][99], -7.0f);
}

}  // namespace
}  // namespace gouraud::pipeline
