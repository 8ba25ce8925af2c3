// Edges: slivers down to no area, and edges that two triangles share.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "conformance/stability/sweeps.h"

namespace gouraud::stability {
namespace {

using conformance::Random;

constexpr int width = 240, height = 180;

/// 48 needles in all directions, `knob` pixels thick at one end.
Drawing slivers(const GlTable& gl, double knob) {
  probes::project_pixels(gl, width, height);
  return {[knob](const GlTable& table) {
    conformance::clear_background(table);
    Random random(6);
    table.Begin(GL_TRIANGLES);
    for (int i = 0; i < 48; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.37) / 48, x = std::cos(angle), y = std::sin(angle);
      const auto vertex = [&](double along, double across) {
        conformance::color_of(table, random);
        table.Vertex2f(static_cast<float>(120.3 + along * x - across * y), static_cast<float>(90.2 + along * y + across * x));
      };
      vertex(15, 0);
      vertex(85, -knob / 2);
      vertex(85, knob / 2);
    }
    table.End();
  }};
}

/// A net of triangles of `knob` pixels with jittered corners, each blended ONE/ONE with one step of 255.
Drawing net(const GlTable& gl, double knob) {
  probes::project_pixels(gl, width, height);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  const int columns = static_cast<int>(width / knob) + 1, rows = static_cast<int>(height / knob) + 1;
  std::vector<std::array<float, 2>> points;
  Random random(23);
  const auto jitter = static_cast<float>(0.2 * knob);
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const bool inner_x = column > 0 && column < columns, inner_y = row > 0 && row < rows;
      const float dx = random.range(-jitter, jitter), dy = random.range(-jitter, jitter);
      points.push_back({static_cast<float>(column * knob) + (inner_x ? dx : 0), static_cast<float>(row * knob) + (inner_y ? dy : 0)});
    }
  }
  return {[points = std::move(points), columns, rows](const GlTable& table) {
    table.ClearColor(0, 0, 0, 0);
    table.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    table.Color4f(1 / 255.0f, 1 / 255.0f, 1 / 255.0f, 1);
    table.Begin(GL_TRIANGLES);
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        for (const auto& [dr, dc] : {std::array{0, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}}) {
          table.Vertex2fv(points[static_cast<std::size_t>((row + dr) * (columns + 1) + column + dc)].data());
        }
      }
    }
    table.End();
  }};
}

constexpr int long_width = 16384, long_height = 8;

/// A band of triangles whose edges are about `knob` pixels long, blended ONE/ONE.
Drawing band(const GlTable& gl, double knob) {
  probes::project_pixels(gl, long_width, long_height);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  return {[knob](const GlTable& table) {
    table.ClearColor(0, 0, 0, 0);
    table.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    table.Color4f(1 / 255.0f, 1 / 255.0f, 1 / 255.0f, 1);
    Random random(41);
    table.Begin(GL_TRIANGLE_STRIP);
    table.Vertex2f(0, 0);
    table.Vertex2f(0, long_height);
    double x = 0;
    bool top = false;
    // The borders wander through the first and the last row, which are not judged.
    const auto next = [&] {
      const float y = top ? random.range(7.05f, 7.95f) : random.range(0.05f, 0.95f);
      table.Vertex2f(static_cast<float>(x), y);
      top = !top;
    };
    while (x < long_width) {
      x = std::min<double>(long_width, x + knob * static_cast<double>(random.range(0.3f, 1)));
      next();
    }
    next();
    table.End();
  }};
}

/// % of the pixels that were hit so often; the net covers all of them, and each belongs to one triangle.
template <class IsWrong>
double percent_of_hits(const Observed& observed, IsWrong is_wrong) {
  const conformance::Picture& picture = *observed.answer.picture;
  int wrong = 0;
  for (std::size_t i = 0; i < picture.pixel_count(); ++i) wrong += is_wrong(picture.rgba[4 * i]) ? 1 : 0;
  return 100.0 * wrong / static_cast<double>(picture.pixel_count());
}

/// The same of the band's inner rows.
template <class IsWrong>
double percent_of_band(const Observed& observed, IsWrong is_wrong) {
  const conformance::Picture& picture = *observed.answer.picture;
  int wrong = 0;
  for (std::size_t i = long_width; i < static_cast<std::size_t>(long_width) * (long_height - 1); ++i) wrong += is_wrong(picture.rgba[4 * i]) ? 1 : 0;
  return 100.0 * wrong / (long_width * (long_height - 2));
}

double band_holes(const Observed& observed) {
  return percent_of_band(observed, [](int hits) { return hits == 0; });
}
double band_doubles(const Observed& observed) {
  return percent_of_band(observed, [](int hits) { return hits > 1; });
}

double holes(const Observed& observed) {
  return percent_of_hits(observed, [](int hits) { return hits == 0; });
}
double double_hits(const Observed& observed) {
  return percent_of_hits(observed, [](int hits) { return hits > 1; });
}

}  // namespace

std::vector<Sweep> edge_sweeps() {
  return {
      {{"slivers_by_thickness", "48 needles whose thickness goes to zero", width, height, slivers},
       "thickness, pixels",
       powers(2, -10, 2),
       {{"coverage", "wrong coverage, % of the pixels drawn", coverage_percent},
        {"color", "mean colour error beyond rounding, 1/255", color_beyond_rounding}},
       {{"default", "coverage", 0, 4, 0.0}, {"default", "color", 0, 4, 0.01}},
       SweepReference::house,
       {"coverage", "colors"},
       [](double knob) { return knob; },
       true},
      {{"net_of_shared_edges", "a net of triangles, blended ONE/ONE", width, height, net},
       "triangle size, pixels",
       {0.5, 0.75, 1, 1.5, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48},
       {{"holes", "pixels that no triangle drew, %", holes}, {"doubles", "pixels drawn more than once, %", double_hits}},
       {{"default", "holes", 0, 48, 0.0},
        {"default", "doubles", 0, 48, 0.0},
        {"ownership=all", "doubles", 2, 48, {}, 0.01, "a sample on an edge belongs to both triangles"},
        {"ownership=none", "holes", 2, 48, {}, 0.01, "a sample on an edge belongs to no triangle"},
        {"coverage=barycentric", "doubles", 0, 48, {}, 0.01, "within epsilon of an edge both triangles have the sample"},
        {"llvmpipe", "holes", 0, 48, 0.0},
        {"llvmpipe", "doubles", 0, 48, 0.0}},
       SweepReference::none,
       {"coverage", "clipping"},
       [](double knob) { return knob; },
       true},
      {{"band_of_long_edges", "a band of triangles 8 pixels high, blended ONE/ONE", long_width, long_height, band},
       "length of the edges, pixels",
       powers(2, 2, 14),
       {{"holes", "pixels that no triangle drew, %", band_holes}, {"doubles", "pixels drawn more than once, %", band_doubles}},
       {{"default", "holes", 4, long_width, 0.0},
        {"default", "doubles", 4, long_width, 0.0},
        {"coverage=incremental", "doubles", 4, long_width, 0.0},
        {"coverage=float_steps", "doubles", 4, long_width, {}, 0.0005, "each addition rounds, and neighbours begin elsewhere"},
        {"coverage=barycentric,epsilon=0.01", "doubles", 4, long_width, {}, 1, "a hundredth of the area along each edge has two owners"}},
       SweepReference::none,
       {"coverage"},
       [](double knob) { return knob; },
       true},
  };
}

}  // namespace gouraud::stability
