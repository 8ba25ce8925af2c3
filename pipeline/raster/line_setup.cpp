// Lines of width 1 and points of size 1 [GL1.5 §3.4.1, §3.3]: they list their pixels, triangles do not.
//
// A line makes the fragment of every diamond |x - xc| + |y - yc| < 1/2 that it touches, except the one that its end
// lies in. For a line more horizontal than vertical that is one pixel in every column whose centre it crosses, plus
// the start's diamond, less the end's. Both end points count as moved by (-eps, -eps^2), which decides all ties.
#include <cmath>
#include <new>
#include <optional>

#include "pipeline/raster/setup.h"

namespace gouraud::pipeline {
namespace {

constexpr std::int64_t half_pixel = subpixels / 2;

/// A position in 1/256 pixel, y up; pixel centres lie at multiples of 256.
struct SubpixelPoint {
  std::int64_t x = 0, y = 0;
};

std::int64_t snap(float coordinate) { return std::lrintf((coordinate - 0.5f) * subpixels); }

std::int64_t floor_divide(std::int64_t numerator, std::int64_t positive) {
  const std::int64_t quotient = numerator / positive;
  return quotient - (numerator % positive < 0 ? 1 : 0);
}

/// The pixel whose diamond holds the point moved by (-eps, -eps^2), if any.
std::optional<PixelPosition> diamond_around(SubpixelPoint p) {
  const std::int64_t i = floor_divide(p.x + half_pixel, subpixels), j = floor_divide(p.y + half_pixel, subpixels);
  const std::int64_t dx = p.x - i * subpixels, dy = p.y - j * subpixels;
  const std::int64_t distance = std::abs(dx) + std::abs(dy);
  const PixelPosition pixel{static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)};
  // On the boundary the shift leads inside from the right. (dx = 128 was rounded into the next pixel, as dx = -128:
  // from that pixel's right corner the shift leads inside the left neighbour.)
  if (distance < half_pixel || (distance == half_pixel && dx > 0)) return pixel;
  if (dx == -half_pixel && dy == 0) return PixelPosition{pixel.x - 1, pixel.y};
  return std::nullopt;
}

/// Appends the pixels of the line from a to b, in order.
void walk(SubpixelPoint a, SubpixelPoint b, std::vector<PixelPosition>& pixels) {
  const std::optional<PixelPosition> start = diamond_around(a), end = diamond_around(b);
  const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
  const auto major = [steep](SubpixelPoint p) { return steep ? p.y : p.x; };
  const auto minor = [steep](SubpixelPoint p) { return steep ? p.x : p.y; };
  const std::int64_t length = std::abs(major(b) - major(a));
  const std::int64_t direction = major(b) > major(a) ? 1 : -1;
  const std::int64_t rise = minor(b) - minor(a);

  // At the centre of column i the line's height is minor(a) + rise * direction * (256 i - major(a)) / length; the shift
  // moves a height on the border between two pixels up if the line rises to the right, and down otherwise. In rows
  // (steep lines) it moves it left.
  const bool border_goes_up = !steep && rise * direction > 0;
  const std::int64_t first = floor_divide(std::min(major(a), major(b)) + subpixels - 1, subpixels);
  const std::int64_t count = floor_divide(std::max(major(a), major(b)) + subpixels - 1, subpixels) - first;
  const auto pixel_at = [&](std::int64_t column) {
    const std::int64_t numerator = (minor(a) + half_pixel) * length + rise * direction * (column * subpixels - major(a));
    const std::int64_t row = floor_divide(numerator - (border_goes_up ? 0 : 1), subpixels * length);
    const auto i = static_cast<std::int32_t>(column), j = static_cast<std::int32_t>(row);
    return steep ? PixelPosition{j, i} : PixelPosition{i, j};
  };

  const auto ends_in = [&](PixelPosition pixel) { return end && *end == pixel; };
  const bool starts_in_diamond = start && !ends_in(*start);
  if (starts_in_diamond && (count == 0 || !(*start == pixel_at(direction > 0 ? first : first + count - 1)))) {
    pixels.push_back(*start);
  }
  for (std::int64_t k = 0; k < count; ++k) {
    const PixelPosition pixel = pixel_at(direction > 0 ? first + k : first + count - 1 - k);
    if (!ends_in(pixel)) pixels.push_back(pixel);
  }
}

PrimitiveRecord& new_record(const SetupState& state, void* memory) {
  auto& record = state.colors ? (new (memory) ColoredPrimitive)->record : *new (memory) PrimitiveRecord;
  record.binding = state.binding;
  return record;
}

}  // namespace

bool setup_line(const SetupState& state, const ProcessedVertices& vertices, const AssembledLine& line, void* memory,
                std::vector<PixelPosition>& pixels) {
  const WindowVertex& v0 = vertices.window[line.vertex[0]];
  const WindowVertex& v1 = vertices.window[line.vertex[1]];
  const std::int64_t top = (static_cast<std::int64_t>(state.target_height_px) - 1) * subpixels;
  const SubpixelPoint a{snap(v0.x), top - snap(v0.y_raster)}, b{snap(v1.x), top - snap(v1.y_raster)};
  if (a.x == b.x && a.y == b.y) return false;
  walk(a, b, pixels);
  if (pixels.empty()) return false;

  // Attributes vary along the line: t = (p - p0) . d / |d|^2 [GL1.5 §3.4.1 eq 3.3].
  PrimitiveRecord& record = new_record(state, memory);
  const double height = state.target_height_px;
  const Point2 p0{v0.x, height - v0.y_raster}, p1{v1.x, height - v1.y_raster};
  const double dx = p1.x - p0.x, dy = p1.y - p0.y, squared = dx * dx + dy * dy;
  const double scale = squared > 0 ? 1.0 / squared : 0.0;
  const GradientBasis basis{p0, {dx * scale, dy * scale}, {0, 0}};
  std::array<ShadedVertex, 3> shaded{ShadedVertex{&v0, {}}, ShadedVertex{&v1, {}}, ShadedVertex{&v1, {}}};
  record.depth = make_depth_plane(basis, shaded, state.targets);
  // End pixels' centres may lie beyond the end points; the specification extrapolates there.
  record.depth.minimum = 0;
  record.depth.maximum = static_cast<float>(state.targets.depth_scale);
  if (!state.colors) return true;

  ColorRecord& color = reinterpret_cast<ColoredPrimitive*>(memory)->color;
  if (state.flat) {
    make_constant_color(color_of_vertex(state, vertices, line.provoking, line.back), state.targets, color);
    return true;
  }
  shaded[0].color = color_of_vertex(state, vertices, line.vertex[0], line.back);
  shaded[1].color = shaded[2].color = color_of_vertex(state, vertices, line.vertex[1], line.back);
  make_color_planes(basis, shaded, state.targets, color);
  // Beyond an end a line is extrapolated too, up to what a color can be; in perspective only up to the ends' colors,
  // because 1/w may pass zero there.
  color.clamp = color.variation != ColorVariation::constant;
  if (color.variation == ColorVariation::affine) {
    color.minimum.fill(0.0f);
    color.maximum.fill(state.targets.color_scale);
  }
  return true;
}

bool setup_point(const SetupState& state, const ProcessedVertices& vertices, const AssembledPoint& point, void* memory,
                 PixelPosition& pixel) {
  const WindowVertex& vertex = vertices.window[point.vertex];
  const auto round_away = [](float coordinate) {
    const float scaled = coordinate * subpixels;
    return static_cast<std::int64_t>(std::floor(std::abs(scaled) + 0.5f)) * (scaled < 0 ? -1 : 1);
  };
  const std::int64_t x = round_away(vertex.x);
  const std::int64_t y = static_cast<std::int64_t>(state.target_height_px) * subpixels - round_away(vertex.y_raster);
  pixel = {static_cast<std::int32_t>(floor_divide(x, subpixels)), static_cast<std::int32_t>(floor_divide(y, subpixels))};

  PrimitiveRecord& record = new_record(state, memory);
  const std::array<ShadedVertex, 3> shaded{ShadedVertex{&vertex, {}}, ShadedVertex{&vertex, {}}, ShadedVertex{&vertex, {}}};
  record.depth = make_depth_plane({}, shaded, state.targets);
  if (state.colors) {
    make_constant_color(color_of_vertex(state, vertices, state.flat ? point.provoking : point.vertex, point.back),
                        state.targets, reinterpret_cast<ColoredPrimitive*>(memory)->color);
  }
  return true;
}

}  // namespace gouraud::pipeline
