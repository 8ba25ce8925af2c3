// Nanoseconds a vertex of each vertex stage: a full batch, again and again. GOURAUD_SIMD chooses the instruction set.
#include <cmath>
#include <memory>
#include <random>

#include <benchmark/benchmark.h>

#include "pipeline/geometry/assembly.h"
#include "pipeline/geometry/clipping.h"
#include "pipeline/geometry/colors.h"
#include "pipeline/geometry/lighting.h"
#include "pipeline/geometry/normals.h"
#include "pipeline/geometry/transform.h"
#include "pipeline/geometry/viewport.h"

namespace gouraud::pipeline {
namespace {

struct Scene {
  TransformState transform;
  ViewportState viewport{0, 0, 640, 480, 0.0, 1.0, 480};
  VertexBatch batch;
  ProcessedVertices vertices;
};

/// A unit sphere three units before the eye.
std::unique_ptr<Scene> make_scene() {
  auto scene = std::make_unique<Scene>();
  scene->transform.modelview[3] = {0, 0, -3, 1};
  scene->transform.projection = {{1.5f, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, -1.2f, -1}, {0, 0, -2.2f, 0}};
  scene->transform.modelview_projection = scene->transform.projection * scene->transform.modelview;
  scene->transform.normal_scaling = NormalScaling::normalize;
  std::mt19937 random(1);
  std::normal_distribution<float> number;
  for (std::size_t i = 0; i < batch_capacity; ++i) {
    const glm::vec3 v(number(random), number(random), number(random));
    const float scale = 1 / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    for (int k = 0; k < 3; ++k) {
      scene->batch.position_object[static_cast<std::size_t>(k)][i] =
          scene->batch.normal_object[static_cast<std::size_t>(k)][i] = v[k] * scale;
      scene->batch.color[static_cast<std::size_t>(k)][i] = v[k];
    }
    scene->batch.position_object[3][i] = scene->batch.color[3][i] = 1;
  }
  scene->batch.count = batch_capacity;
  transform_to_clip(scene->transform, scene->batch, scene->vertices);
  transform_to_eye(scene->transform, scene->batch, scene->vertices);
  transform_normals(scene->transform, scene->batch, scene->vertices);
  project_to_window(scene->viewport, scene->vertices);
  return scene;
}

void report(benchmark::State& state) {
  state.counters["ns/vertex"] = benchmark::Counter(static_cast<double>(state.iterations()) * batch_capacity * 1e-9,
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void transform_clip(benchmark::State& state) {
  const auto scene = make_scene();
  for (auto _ : state) transform_to_clip(scene->transform, scene->batch, scene->vertices);
  report(state);
}
void transform_eye(benchmark::State& state) {
  const auto scene = make_scene();
  for (auto _ : state) transform_to_eye(scene->transform, scene->batch, scene->vertices);
  report(state);
}
void normals(benchmark::State& state) {
  const auto scene = make_scene();
  scene->transform.normal_scaling = static_cast<NormalScaling>(state.range(0));
  for (auto _ : state) transform_normals(scene->transform, scene->batch, scene->vertices);
  report(state);
}
void colors(benchmark::State& state) {
  const auto scene = make_scene();
  for (auto _ : state) clamp_vertex_colors(scene->batch, scene->vertices);
  report(state);
}
void project(benchmark::State& state) {
  const auto scene = make_scene();
  for (auto _ : state) project_to_window(scene->viewport, scene->vertices);
  report(state);
}
void assemble_range(benchmark::State& state) {
  AssembledPrimitives out;
  for (auto _ : state) {
    out.triangles.clear();
    out.lines.clear();
    out.points.clear();
    assemble({static_cast<PrimitiveMode>(state.range(0)), true, true, 0, batch_capacity}, {}, out);
    benchmark::DoNotOptimize(out);
  }
  report(state);
}

/// Nanoseconds a triangle or line, each of which crosses a plane.
void clip_triangles(benchmark::State& state) {
  const auto scene = make_scene();
  auto& clip = scene->vertices.position_clip;
  for (std::size_t i = 0; i < 3; ++i) clip[0][i] = clip[1][i] = clip[2][i] = 0, clip[3][i] = 1;
  clip[0][1] = clip[1][2] = 3;
  project_to_window(scene->viewport, scene->vertices);
  std::vector<AssembledTriangle> out;
  for (auto _ : state) {
    out.clear();
    scene->vertices.count = batch_capacity;
    clip_triangle({{0, 1, 2}, 2, 7}, scene->viewport, {false, true, false, false}, scene->vertices, out);
    benchmark::DoNotOptimize(out.data());
  }
}
void clip_lines(benchmark::State& state) {
  const auto scene = make_scene();
  auto& clip = scene->vertices.position_clip;
  for (std::size_t i = 0; i < 2; ++i)
    clip[1][i] = clip[2][i] = 0, clip[3][i] = 1, clip[0][i] = static_cast<float>(i) * 3;
  project_to_window(scene->viewport, scene->vertices);
  for (auto _ : state) {
    AssembledLine line{{0, 1}, 1, false};
    scene->vertices.count = batch_capacity;
    benchmark::DoNotOptimize(clip_line(line, scene->viewport, {false, true, false, false}, scene->vertices));
  }
}

enum LightBits {
  positional = 1,
  attenuated = 2,
  spot = 4,
  specular = 8,
  local = 16,
  two_sided = 32,
  separate = 64,
  color_material = 128
};

/// Arguments: number of lights, LightBits.
void light(benchmark::State& state) {
  const auto scene = make_scene();
  const auto bits = static_cast<int>(state.range(1));
  LightingState lighting;
  lighting.enabled = true;
  lighting.light_count = static_cast<std::uint8_t>(state.range(0));
  lighting.local_viewer = (bits & local) != 0;
  lighting.two_sided = (bits & two_sided) != 0;
  lighting.separate_specular = (bits & separate) != 0;
  lighting.color_material_front = (bits & color_material) != 0 ? material_ambient | material_diffuse : material_none;
  lighting.color_material_back = lighting.two_sided ? lighting.color_material_front : std::uint8_t{material_none};
  for (std::size_t i = 0; i < lighting.light_count; ++i) {
    PreparedLight& source = lighting.lights[i];
    source.diffuse = {0.2f, 0.3f, 0.4f, 1};
    if ((bits & specular) != 0) source.specular = {0.3f, 0.3f, 0.3f, 1};
    source.positional = (bits & positional) != 0;
    source.position_eye = source.positional ? glm::vec3(2, 2, static_cast<float>(i)) : glm::vec3(0.6f, 0, 0.8f);
    if ((bits & attenuated) != 0) source.attenuation = {1, 0.1f, 0.1f};
    source.spot = (bits & spot) != 0;
    source.spot_direction_eye = {0, 0, -1};
    source.spot_cutoff_cosine = 0.1f;
    source.spot_exponent = 2;
  }
  if ((bits & specular) != 0)
    lighting.material.front.specular = lighting.material.back.specular = {0.5f, 0.5f, 0.5f, 1};
  lighting.material.front.shininess = lighting.material.back.shininess = 32;
  for (auto _ : state) light_vertices(lighting, scene->batch, scene->vertices);
  report(state);
}

BENCHMARK(transform_clip);
BENCHMARK(transform_eye);
BENCHMARK(normals)->DenseRange(0, 2);
BENCHMARK(colors);
BENCHMARK(project);
BENCHMARK(assemble_range)->DenseRange(0, 9);
BENCHMARK(clip_triangles);
BENCHMARK(clip_lines);
BENCHMARK(light)
    ->Args({0, 0})
    ->Args({1, 0})
    ->Args({1, specular})
    ->Args({4, 0})
    ->Args({4, specular})
    ->Args({4, specular | local})
    ->Args({4, positional})
    ->Args({4, positional | specular})
    ->Args({4, positional | attenuated | specular})
    ->Args({4, positional | attenuated | spot | specular})
    ->Args({4, positional | specular | local})
    ->Args({4, positional | specular | separate | color_material})
    ->Args({4, positional | specular | two_sided})
    ->Args({8, positional | attenuated | spot | specular | local | two_sided | separate | color_material});

}  // namespace
}  // namespace gouraud::pipeline

BENCHMARK_MAIN();
