// Surfaces: meshes under light, floors in perspective, depths that are far apart or equal.
#include <cmath>
#include <numbers>

#include "conformance/chart/scenes.h"
#include "conformance/scenes/texture_shapes.h"

namespace gouraud::chart {
namespace {

using conformance::light;
using conformance::material;
using conformance::Matrix;
using conformance::Orbit;
using conformance::Random;
using conformance::Surface;

constexpr float aspect = static_cast<float>(chart_width_px) / chart_height_px;
constexpr GLenum both = GL_FRONT_AND_BACK;

void camera(const GlTable& gl, const Orbit& orbit) {
  project(gl, conformance::perspective(orbit.fov_y_deg, aspect, orbit.near, orbit.far), chart_width_px, chart_height_px);
  const Matrix turned = conformance::multiply(conformance::rotation(orbit.pitch_deg, 0), conformance::rotation(orbit.yaw_deg, 1));
  conformance::load_model_view(gl, conformance::multiply(conformance::translation(0, 0, -orbit.distance), turned));
}

void lamp(const GlTable& gl, GLenum name, const conformance::Four& position, const conformance::Four& color) {
  light(gl, name, GL_POSITION, position);
  light(gl, name, GL_DIFFUSE, color);
  light(gl, name, GL_SPECULAR, color);
}

void shine(const GlTable& gl, const conformance::Four& diffuse, float shininess) {
  material(gl, both, GL_AMBIENT, {0.1f, 0.1f, 0.12f, 1});
  material(gl, both, GL_DIFFUSE, diffuse);
  material(gl, both, GL_SPECULAR, {0.7f, 0.7f, 0.7f, 1});
  gl.Materialf(both, GL_SHININESS, shininess);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, conformance::Four{0.8f, 0.8f, 0.8f, 1}.data());
}

Drawing dense_mesh(const GlTable& gl, double) {
  conformance::black_lighting(gl, 2);
  gl.Enable(GL_DEPTH_TEST);
  camera(gl, {.distance = 5});
  lamp(gl, GL_LIGHT0, {3, 4, 5, 1}, {0.9f, 0.8f, 0.6f, 1});
  lamp(gl, GL_LIGHT1, {-1, 0.4f, 0.3f, 0}, {0.2f, 0.3f, 0.6f, 1});
  shine(gl, {0.7f, 0.5f, 0.3f, 1}, 24);
  return {[mesh = conformance::torus(1.25f, 0.55f, 120, 60)](const GlTable& table) {
    conformance::clear_background(table);
    draw_surface(table, mesh);
  }};
}

/// One quadrilateral to the horizon, of strong colours: perspective-correct or not is all there is to see.
Drawing color_floor(const GlTable& gl, double) {
  gl.Enable(GL_DEPTH_TEST);
  camera(gl, {.distance = 3, .pitch_deg = 12, .near = 0.2f, .far = 60});
  return {[](const GlTable& table) {
    conformance::clear_background(table);
    table.Begin(GL_TRIANGLES);
    constexpr float far = 40, side = 12;
    const auto corner = [&](float x, float z, float red, float green, float blue) {
      table.Color3f(red, green, blue);
      table.Vertex3f(x, 0, z);
    };
    corner(-side, 2, 1, 0, 0);
    corner(side, 2, 0, 1, 0);
    corner(side, -far, 0, 0, 1);
    corner(-side, 2, 1, 0, 0);
    corner(side, -far, 0, 0, 1);
    corner(-side, -far, 1, 1, 0);
    table.End();
  }};
}

/// A checker to the horizon, trilinear.
Drawing checker_floor(const GlTable& gl, double) {
  constexpr int size = 64;
  std::vector<std::uint8_t> texels;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) texels.push_back((x / 8 + y / 8) % 2 == 0 ? 230 : 30);
  }
  gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, size, size, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels.data());
  conformance::filters(gl, GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  conformance::environment_mode(gl, GL_REPLACE);
  gl.Enable(GL_TEXTURE_2D);
  gl.Enable(GL_DEPTH_TEST);
  camera(gl, {.distance = 3, .pitch_deg = 14, .near = 0.2f, .far = 60});
  return {[](const GlTable& table) {
    conformance::clear_background(table);
    table.Begin(GL_TRIANGLES);
    for (const auto& [x, z] : {std::array{-9.0f, 2.5f}, {9.0f, 2.5f}, {9.0f, -30.0f}, {-9.0f, 2.5f}, {9.0f, -30.0f}, {-9.0f, -30.0f}}) {
      table.TexCoord2f(x / 4, z / 4);
      table.Vertex3f(x, 0, z);
    }
    table.End();
  }};
}

/// Near 0.1, far 10,000: pairs of cards, a card of each pair a thousandth of its distance behind the other.
Drawing far_depths(const GlTable& gl, double) {
  gl.Enable(GL_DEPTH_TEST);
  project(gl, conformance::perspective(50, aspect, 0.1f, 10000), chart_width_px, chart_height_px);
  return {[](const GlTable& table) {
    conformance::clear_background(table);
    for (int i = 0; i < 16; ++i) {
      const auto distance = static_cast<float>(std::pow(10.0, i / 4.0)), half = 0.1f * distance;
      const float x = (static_cast<float>(i % 4) - 1.5f) * 0.3f * distance, y = (static_cast<float>(i / 4) - 1.5f) * 0.22f * distance;
      for (const float behind : {1.001f, 1.0f}) {
        table.Begin(GL_TRIANGLES);
        table.Color3f(behind > 1 ? 0.9f : 0.1f, 0.5f, behind > 1 ? 0.1f : 0.8f);
        for (const auto& [dx, dy] : {std::array{-1.0f, -1.0f}, {1.0f, -0.9f}, {0.9f, 1.0f}}) {
          // Tilted, so that all depths between occur.
          table.Vertex3f(x + dx * half, y + dy * half, -distance * behind * (1 + 0.3f * dx));
        }
        table.End();
      }
    }
  }};
}

/// Cards on a tilted board, lifted by polygon offset alone.
Drawing decals(const GlTable& gl, double) {
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.PolygonOffset(-1, -1);
  camera(gl, {.distance = 4.5f, .pitch_deg = 28});
  return {[](const GlTable& table) {
    conformance::clear_background(table);
    const auto card = [&](float x, float z, float half) {
      table.Begin(GL_TRIANGLE_FAN);
      table.Vertex3f(x - half, 0, z + half);
      table.Vertex3f(x + half, 0, z + 0.7f * half);
      table.Vertex3f(x + 0.8f * half, 0, z - half);
      table.Vertex3f(x - half, 0, z - 0.9f * half);
      table.End();
    };
    table.Disable(GL_POLYGON_OFFSET_FILL);
    table.Color3f(0.8f, 0.8f, 0.7f);
    card(0, 0, 2.2f);
    table.Enable(GL_POLYGON_OFFSET_FILL);
    Random random(5);
    for (int i = 0; i < 25; ++i) {
      conformance::color_of(table, random);
      card(static_cast<float>(i % 5) * 0.75f - 1.5f, static_cast<float>(i / 5) * 0.75f - 1.5f, 0.3f);
    }
    table.Disable(GL_POLYGON_OFFSET_FILL);
  }};
}

/// The corners' normals of a ball of 8 by 5 faces; at knob 1 each face is cut finely with the normals between, which is
/// what the few corners stand for.
Drawing highlight(const GlTable& gl, double knob) {
  conformance::black_lighting(gl, 1);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_NORMALIZE);
  camera(gl, {.distance = 4});
  lamp(gl, GL_LIGHT0, {3, 4, 6, 1}, {0.9f, 0.9f, 0.9f, 1});
  shine(gl, {0.2f, 0.4f, 0.7f, 1}, 40);
  const int cuts = knob > 0 ? 24 : 1;
  return {[cuts, ball = conformance::sphere(1.2f, 6, 9)](const GlTable& table) {
    conformance::clear_background(table);
    conformance::draw_cut_surface(table, ball, cuts);
  }};
}

/// Three bars that lie over each other in a ring: no order of drawing is right, only depth is.
Drawing cycle(const GlTable& gl, double) {
  gl.Enable(GL_DEPTH_TEST);
  camera(gl, {.distance = 5, .pitch_deg = 0, .yaw_deg = 0});
  return {[](const GlTable& table) {
    conformance::clear_background(table);
    for (int bar = 0; bar < 3; ++bar) {
      table.PushMatrix();
      table.Rotatef(static_cast<float>(120 * bar), 0, 0, 1);
      table.Begin(GL_TRIANGLE_STRIP);
      table.Color3f(bar == 0 ? 0.9f : 0.2f, bar == 1 ? 0.9f : 0.2f, bar == 2 ? 0.9f : 0.2f);
      table.Vertex3f(-1.6f, -0.9f, -0.5f);
      table.Vertex3f(-1.6f, -0.4f, -0.5f);
      table.Color3f(0.8f, 0.8f, 0.8f);
      table.Vertex3f(1.6f, -0.9f, 0.5f);
      table.Vertex3f(1.6f, -0.4f, 0.5f);
      table.End();
      table.PopMatrix();
    }
  }};
}

Probe probe(std::string_view name, std::string_view shows, Drawing (*setup)(const GlTable&, double)) {
  return {name, shows, chart_width_px, chart_height_px, setup};
}

}  // namespace

std::vector<ChartScene> surface_scenes() {
  return {
      {probe("dense_mesh", "a torus of 14,400 lit triangles, two lights, highlights", dense_mesh), lit_steps},
      {probe("color_floor", "two triangles to the horizon with a colour at each corner", color_floor), polygon_steps},
      {probe("checker_floor", "a checker texture to the horizon, trilinear", checker_floor), polygon_steps},
      {probe("far_depths", "cards from 1 to 5,600 units away in pairs a thousandth apart, near 0.1, far 10,000", far_depths), flat_steps},
      {probe("decals", "cards in the plane of a board, lifted by polygon offset", decals), flat_steps},
      {probe("highlight", "a ball of 108 triangles with a highlight; the reference has the normals between the corners", highlight),
       lit_steps, ReferenceKind::finer_mesh},
      {probe("cycle", "three bars, each over the next", cycle), polygon_steps},
  };
}

}  // namespace gouraud::chart
