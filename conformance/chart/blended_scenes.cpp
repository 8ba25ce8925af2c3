// Blending, where each pixel counts each fragment; and edges, judged by the area that they cover.
#include <array>
#include <cmath>
#include <numbers>

#include "conformance/chart/scenes.h"

namespace gouraud::chart {
namespace {

using conformance::color_of;
using conformance::Random;

constexpr int width = chart_width_px, height = chart_height_px;
// Area coverage takes many pictures: smaller ones.
constexpr int area_width = 200, area_height = 150;

Drawing layers(const GlTable& gl, double) {
  project_pixels(gl, width, height);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  return {[](const GlTable& table) {
    conformance::clear_background(table);
    Random random(21);
    table.Begin(GL_TRIANGLES);
    for (int i = 0; i < 24; ++i) {
      const float dx = random.range(-40, 40), dy = random.range(-40, 40);
      for (const auto& [x, y] : {std::array{10.0f, 20.0f}, {390.0f, 60.0f}, {180.0f, 290.0f}}) {
        const float red = random.range(0, 1), green = random.range(0, 1), blue = random.range(0, 1);
        table.Color4f(red, green, blue, random.range(0.05f, 0.4f));
        table.Vertex2f(x + dx, y + dy);
      }
    }
    table.End();
  }};
}

/// A net of jittered points, each triangle of it added once: an even grey, if no pixel is left out or hit twice.
Drawing shared_edges(const GlTable& gl, double) {
  project_pixels(gl, width, height);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  constexpr int columns = 66, rows = 50;
  constexpr float cell = 6;
  std::vector<std::array<float, 2>> net;
  Random random(17);
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const float x = static_cast<float>(column) * cell + random.range(-1.4f, 1.4f);
      net.push_back({x + 2, static_cast<float>(row) * cell + random.range(-1.4f, 1.4f)});
    }
  }
  return {[net = std::move(net)](const GlTable& table) {
    table.ClearColor(0, 0, 0, 0);
    table.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    table.Color4f(0.25f, 0.25f, 0.25f, 0.25f);
    const auto vertex = [&](int row, int column) { table.Vertex2fv(net[static_cast<std::size_t>(row * (columns + 1) + column)].data()); };
    table.Begin(GL_TRIANGLES);
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        for (const auto& [dr, dc] : {std::array{0, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}}) vertex(row + dr, column + dc);
      }
    }
    table.End();
  }};
}

/// A fan of wedges, edges in all directions.
Drawing edges(const GlTable& gl, double) {
  project_pixels(gl, area_width, area_height);
  return {[](const GlTable& table) {
    conformance::clear_background(table);
    table.Begin(GL_TRIANGLES);
    constexpr int wedges = 28;
    for (int i = 0; i < wedges; ++i) {
      if (i % 2 == 0) {
        table.Color3f(0.95f, 0.95f, 0.8f);
      } else {
        table.Color3f(0.1f, 0.25f, 0.5f);
      }
      table.Vertex2f(100.2f, 75.3f);
      for (const double corner : {i + 0.1, i + 0.85}) {
        const double angle = 2 * std::numbers::pi * corner / wedges;
        table.Vertex2f(static_cast<float>(100.2 + 92 * std::cos(angle)), static_cast<float>(75.3 + 68 * std::sin(angle)));
      }
    }
    table.End();
  }};
}

/// A checker of polygons to the horizon: far away its fields are smaller than pixels.
Drawing polygon_checker(const GlTable& gl, double) {
  project(gl, conformance::perspective(45, static_cast<float>(area_width) / area_height, 0.5f, 200), area_width, area_height);
  conformance::load_model_view(gl, conformance::multiply(conformance::rotation(9, 0), conformance::translation(0, -1.5f, 0)));
  return {[](const GlTable& table) {
    conformance::clear_background(table);
    table.Begin(GL_TRIANGLES);
    for (int z = 0; z < 60; ++z) {
      for (int x = -14; x < 14; ++x) {
        const float shade = (x + z) % 2 == 0 ? 0.9f : 0.15f;
        table.Color3f(shade, shade, shade);
        for (const auto& [dx, dz] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
          table.Vertex3f(static_cast<float>(x + dx), 0, -1 - static_cast<float>(z + dz));
        }
      }
    }
    table.End();
  }};
}

}  // namespace

std::vector<ChartScene> blended_scenes() {
  return {
      {{"layers", "24 Gouraud layers blended over each other", width, height, layers}, polygon_steps},
      {{"shared_edges", "6,600 triangles of a net, blended ONE/ONE: even grey where each pixel is drawn once", width, height,
        shared_edges},
       flat_steps},
      {{"edges", "wedges in all directions; the reference is the area that they cover", area_width, area_height, edges},
       flat_steps, ReferenceKind::area},
      {{"polygon_checker", "a checker of polygons to the horizon; the reference is the area covered", area_width, area_height,
        polygon_checker},
       flat_steps, ReferenceKind::area},
  };
}

}  // namespace gouraud::chart
