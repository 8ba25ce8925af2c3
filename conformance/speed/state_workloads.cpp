#include "conformance/speed/state_workloads.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace gouraud::speed {
namespace {

constexpr int width_px = 1920, height_px = 1080;
constexpr float pi = std::numbers::pi_v<float>;
using Vec3 = std::array<float, 3>;
using Vec4 = std::array<float, 4>;

void set_camera(const GlTable& gl) {
  const double aspect = static_cast<double>(width_px) / height_px;
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Frustum(-0.5 * aspect, 0.5 * aspect, -0.5, 0.5, 1.0, 10.0);
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  gl.Enable(GL_DEPTH_TEST);
}

void set_light(const GlTable& gl) {
  const Vec4 position{0.3f, 0.5f, 1.0f, 0.0f}, white{1, 1, 1, 1};
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position.data());
  gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, white.data());
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_LIGHTING);
}

/// 50 screens of four colours, each with its own alpha.
Frame blended_layers(const GlTable& gl) {
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  return [](const GlTable& table) {
    table.Clear(GL_COLOR_BUFFER_BIT);
    table.Begin(GL_QUADS);
    for (int i = 0; i < 50; ++i) {
      const float tone = 0.02f * static_cast<float>(i), alpha = 0.1f + 0.01f * static_cast<float>(i);
      table.Color4f(tone, 0, 1, alpha);
      table.Vertex2f(-1, -1);
      table.Color4f(1, tone, 0, 0.5f * alpha);
      table.Vertex2f(1, -1);
      table.Color4f(0, 1, tone, alpha);
      table.Vertex2f(1, 1);
      table.Color4f(1, 1, 1 - tone, 0.7f * alpha);
      table.Vertex2f(-1, 1);
    }
    table.End();
  };
}

/// Half a sphere of 100 strips, seen from both sides, in the fog.
Frame fog_clip_two_sided(const GlTable& gl) {
  set_camera(gl);
  set_light(gl);
  const Vec4 front{0.3f, 0.6f, 0.9f, 1}, back{0.9f, 0.5f, 0.2f, 1}, mist{0.6f, 0.6f, 0.6f, 1};
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  gl.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, front.data());
  gl.Materialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, back.data());
  gl.Fogi(GL_FOG_MODE, GL_EXP2);
  gl.Fogf(GL_FOG_DENSITY, 0.2f);
  gl.Fogfv(GL_FOG_COLOR, mist.data());
  gl.Enable(GL_FOG);
  gl.Translatef(0, 0, -3.5f);
  const double plane[4] = {0.2, -0.3, -1, 0.4};
  gl.ClipPlane(GL_CLIP_PLANE0, plane);
  gl.Enable(GL_CLIP_PLANE0);
  constexpr std::size_t stacks = 100, slices = 200;
  std::vector<Vec3> points;
  for (std::size_t stack = 0; stack < stacks; ++stack) {
    for (std::size_t i = 0; i < 2 * (slices + 1); ++i) {
      const float latitude = pi * (static_cast<float>(stack + 1 - i % 2) / stacks - 0.5f);
      const float longitude = 2.0f * pi * static_cast<float>(i / 2) / slices;
      points.push_back({std::cos(latitude) * std::cos(longitude), std::sin(latitude), std::cos(latitude) * std::sin(longitude)});
    }
  }
  gl.Enable(GL_NORMALIZE);
  gl.Scalef(1.5f, 1.5f, 1.5f);
  return [points = std::move(points)](const GlTable& table) {
    table.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const Vec3* point = points.data();
    for (std::size_t stack = 0; stack < stacks; ++stack) {
      table.Begin(GL_TRIANGLE_STRIP);
      for (std::size_t i = 0; i < 2 * (slices + 1); ++i, ++point) {
        table.Normal3fv(point->data());
        table.Vertex3fv(point->data());
      }
      table.End();
    }
  };
}

/// 20,000 lit tetrahedra, each with its own material and matrix.
Frame small_draws(const GlTable& gl) {
  set_camera(gl);
  set_light(gl);
  return [](const GlTable& table) {
    constexpr int columns = 200, rows = 100;
    constexpr Vec3 corners[4] = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
    constexpr int faces[4][3] = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    table.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int i = 0; i < columns * rows; ++i) {
      const auto column = static_cast<float>(i % columns), row = static_cast<float>(i / columns);
      const Vec4 diffuse{column / columns, row / rows, 0.5f, 1};
      table.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, diffuse.data());
      table.PushMatrix();
      table.Translatef(7.0f * (column / columns - 0.5f), 3.9f * (row / rows - 0.5f), -4.0f);
      table.Rotatef(3.0f * column + row, 0.6f, 0.8f, 0);
      table.Begin(GL_TRIANGLES);
      for (const auto& face : faces) {
        const Vec3 &a = corners[face[0]], &b = corners[face[1]], &c = corners[face[2]];
        table.Normal3f(0.577f * (a[0] + b[0] + c[0]), 0.577f * (a[1] + b[1] + c[1]), 0.577f * (a[2] + b[2] + c[2]));
        for (const Vec3* corner : {&a, &b, &c}) table.Vertex3f(0.01f * (*corner)[0], 0.01f * (*corner)[1], 0.01f * (*corner)[2]);
      }
      table.End();
      table.PopMatrix();
    }
  };
}

}  // namespace

std::vector<Workload> state_workloads() {
  return {
      {"blended_layers", "50 blended Gouraud layers", width_px, height_px, blended_layers},
      {"fog_clip_two_sided", "fog, clip plane, two-sided lighting", width_px, height_px, fog_clip_two_sided},
      {"small_draws", "20,000 small draws, material and matrix each", width_px, height_px, small_draws},
  };
}

}  // namespace gouraud::speed
