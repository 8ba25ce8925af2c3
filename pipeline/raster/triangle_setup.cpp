// Triangles [GL1.5 §3.5.1]. Facing and culling use the area of the snapped triangle, coverage its edge functions;
// planes use the unsnapped positions. Window y comes from the top (y_raster), is snapped there, and turned over.
#include <cmath>
#include <new>

#include "pipeline/raster/setup.h"

namespace gouraud::pipeline {
namespace {

/// A snapped position, y up, in 1/256 pixel; pixel centres lie at multiples of 256.
struct SnappedPoint {
  std::int32_t x = 0, y = 0;
};

/// Nearest 1/256 pixel, ties to even, in float as MESA-RULES 3 says.
std::int32_t snap(float coordinate) { return static_cast<std::int32_t>(std::lrintf((coordinate - 0.5f) * subpixels)); }

SnappedPoint snap(const WindowVertex& vertex, std::int32_t target_height) {
  return {snap(vertex.x), (target_height - 1) * subpixels - snap(vertex.y_raster)};
}

Point2 position(const WindowVertex& vertex, std::int32_t target_height) {
  return {vertex.x, static_cast<double>(target_height) - static_cast<double>(vertex.y_raster)};
}

/// Twice the signed area: positive for counter-clockwise.
std::int64_t doubled_area(SnappedPoint a, SnappedPoint b, SnappedPoint c) {
  return static_cast<std::int64_t>(b.x - a.x) * (c.y - a.y) - static_cast<std::int64_t>(c.x - a.x) * (b.y - a.y);
}

/// The edge of a counter-clockwise triangle from `from` to `to`, positive inside. Left edges and horizontal bottom
/// edges own the samples on them; the others lose them by one unit (MESA-RULES 3).
EdgeFunction make_edge(SnappedPoint from, SnappedPoint to) {
  const std::int32_t a = from.y - to.y, b = to.x - from.x;
  const bool owns_its_samples = a > 0 || (a == 0 && b > 0);
  const std::int64_t at_origin = -(static_cast<std::int64_t>(a) * from.x + static_cast<std::int64_t>(b) * from.y);
  // At pixel (i, j): 256 a i + 256 b j + at_origin >= 0, which floor division by 256 does not change.
  return {(at_origin - (owns_its_samples ? 0 : 1)) >> subpixel_bits, a, b};
}

/// The basis for planes through three positions. Where the unsnapped triangle has no area its plane is not defined;
/// the snapped one's stands in.
GradientBasis make_basis(const std::array<Point2, 3>& p, const std::array<SnappedPoint, 3>& snapped) {
  const auto basis_of = [](const Point2& p0, const Point2& p1, const Point2& p2) {
    const double x1 = p1.x - p0.x, y1 = p1.y - p0.y, x2 = p2.x - p0.x, y2 = p2.y - p0.y;
    const double area = x1 * y2 - x2 * y1;
    const double scale = area == 0.0 ? 0.0 : 1.0 / area;
    return GradientBasis{p0, {y2 * scale, -x2 * scale}, {-y1 * scale, x1 * scale}};
  };
  const GradientBasis basis = basis_of(p[0], p[1], p[2]);
  if ((basis.first.x != 0.0 || basis.first.y != 0.0) && std::isfinite(basis.first.x + basis.first.y)) return basis;
  const auto unsnap = [](SnappedPoint s) { return Point2{s.x / 256.0 + 0.5, s.y / 256.0 + 0.5}; };
  return basis_of(unsnap(snapped[0]), unsnap(snapped[1]), unsnap(snapped[2]));
}

/// First pixel whose centre lies at or right of `subpixel`.
std::int32_t first_pixel_from(std::int32_t subpixel) { return (subpixel + subpixels - 1) >> subpixel_bits; }

}  // namespace

bool is_culled(CullMode cull, bool front) {
  return cull == CullMode::front_and_back || cull == (front ? CullMode::front : CullMode::back);
}

bool faces_front(const SetupState& state, const ProcessedVertices& vertices, const AssembledTriangle& triangle) {
  std::array<Point2, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = position(vertices.window[triangle.vertex[i]], state.target_height_px);
  const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
  return area != 0.0 && (area > 0.0) == (state.front_face == FrontFace::ccw);
}

bool setup_triangle(const SetupState& state, const ProcessedVertices& vertices, const AssembledTriangle& triangle,
                    void* memory) {
  std::array<std::uint16_t, 3> index = triangle.vertex;
  std::array<SnappedPoint, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = snap(vertices.window[index[i]], state.target_height_px);

  // Reject what no sample can hit.
  const auto [low_x, high_x] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [low_y, high_y] = std::minmax({p[0].y, p[1].y, p[2].y});
  const PixelRect box{first_pixel_from(low_x), first_pixel_from(low_y), (high_x >> subpixel_bits) + 1,
                      (high_y >> subpixel_bits) + 1};
  const PixelRect cut{std::max(box.x0, state.scissor.x0), std::max(box.y0, state.scissor.y0),
                      std::min(box.x1, state.scissor.x1), std::min(box.y1, state.scissor.y1)};
  if (cut.empty()) return false;

  // Decide facing, cull.
  const std::int64_t area = doubled_area(p[0], p[1], p[2]);
  if (area == 0) return false;
  const bool front = (area > 0) == (state.front_face == FrontFace::ccw);
  if (is_culled(state.cull, front)) return false;

  // Go around counter-clockwise. The last vertex stays last.
  if (area < 0) {
    std::swap(p[0], p[1]);
    std::swap(index[0], index[1]);
  }

  auto& record = state.colors ? (new (memory) ColoredPrimitive)->record : *new (memory) PrimitiveRecord;
  record.binding = state.binding;
  record.edges = {make_edge(p[0], p[1]), make_edge(p[1], p[2]), make_edge(p[2], p[0])};
  record.x0 = cut.x0;
  record.y0 = cut.y0;
  record.x1 = cut.x1;
  record.y1 = cut.y1;
  record.scissored = !(cut == box);

  // Lay the planes.
  std::array<ShadedVertex, 3> shaded;
  std::array<Point2, 3> unsnapped;
  for (std::size_t i = 0; i < 3; ++i) {
    shaded[i].window = &vertices.window[index[i]];
    unsnapped[i] = position(*shaded[i].window, state.target_height_px);
  }
  const GradientBasis basis = make_basis(unsnapped, p);
  record.depth = make_depth_plane(basis, shaded, state.targets);
  if (!state.colors) return true;

  auto& color = reinterpret_cast<ColoredPrimitive*>(memory)->color;
  const bool back = state.two_sided && !front;
  if (state.flat) {
    make_constant_color(color_of_vertex(state, vertices, triangle.provoking, back), state.targets, color);
  } else {
    for (std::size_t i = 0; i < 3; ++i) shaded[i].color = color_of_vertex(state, vertices, index[i], back);
    make_color_planes(basis, shaded, state.targets, color);
  }
  return true;
}

}  // namespace gouraud::pipeline
