// Takes points, lines and triangles in window space, gives fragments [GL1.5 §3.3.1, §3.4.1, §3.5.1].
// Which pixels: in exact integers of the snapped positions. Their values: in double of the unsnapped ones.
#pragma once

#include <array>
#include <vector>

#include "conformance/oracle/fragments.h"
#include "conformance/oracle/targets.h"
#include "conformance/oracle/vertex.h"

namespace gouraud::oracle {

/// A whole number wide enough for products of two differences of positions on the grid of 2^-30 pixel.
__extension__ using Integer = __int128;

/// Twice the signed area of the snapped triangle, y up: positive if counter-clockwise.
Integer doubled_area(const SubpixelPoint& a, const SubpixelPoint& b, const SubpixelPoint& c);

/// What fragments are made for, and where they go.
struct FragmentSink {
  Samples* samples = nullptr;
  pipeline::MultisampleState multisample{};
  pipeline::RasterState state{};
  int subpixel_bits = 8;
  /// Flat colour; null: colours are interpolated.
  const VertexColors* flat_colors = nullptr;
  Face face = front;
  bool has_secondary = false;  ///< colours are sums of primary and secondary [GL1.5 §3.9], behind the textures if any
  pipeline::TexturingState texturing{};
  double depth_slack = 0;      ///< in window z
  double depth_offset = 0;     ///< of polygons, in window z [GL1.5 §3.5.5]
  pipeline::PointState points{};
  pipeline::LineState lines{};

  int depth_bits() const { return samples->front().depth_bits; }
  /// Whether sample k is drawn at all (SAMPLE_COVERAGE).
  bool draws(std::size_t k) const { return k < samples->size() && (multisample.sample_mask >> k & 1) != 0; }
  /// To sample k alone.
  void give(const Fragment& fragment, std::size_t k) const {
    if (draws(k)) write_fragment((*samples)[k], state, fragment, k);
  }
  /// To all samples that are drawn.
  void give(const Fragment& fragment) const {
    for (std::size_t k = 0; k < samples->size(); ++k) give(fragment, k);
  }
};

/// [GL1.5 §3.5.5 eqs 3.8, 3.9] of a triangle, in window z. r is one step of the depth buffer.
double polygon_offset(const pipeline::PolygonState& state, int depth_bits, const std::array<WindowVertex, 3>& vertices);

void rasterize_triangle(const FragmentSink& sink, const std::array<WindowVertex, 3>& vertices);

/// A triangle of a smooth polygon. A pixel gets one fragment: the share that all triangles cover, the values of the one
/// that covers most [GL1.5 §3.5.3].
struct SmoothPart {
  FragmentSink sink;  ///< its flat_colors: whether those below apply
  std::array<WindowVertex, 3> vertices;
  VertexColors flat_colors{};
};
void rasterize_smooth_polygon(const std::vector<SmoothPart>& parts);
/// `stipple_count` fragments (or unit rectangles) of stippled lines came before [GL1.5 §3.4.2]; it is moved on.
void rasterize_line(const FragmentSink& sink, const std::array<WindowVertex, 2>& vertices, std::int64_t& stipple_count);
/// Where multisampled, rectangles and discs that have the samples inside them [GL1.5 §3.3.3, §3.4.4].
/// `size_px` is not rounded yet.
void rasterize_point(const FragmentSink& sink, const WindowVertex& vertex, double size_px);

/// Whether the segment from a to b makes a fragment at pixel (x, y) [GL1.5 §3.4.1].
bool exits_diamond(const SubpixelPoint& a, const SubpixelPoint& b, int x, int y, int subpixel_bits);

/// The pixel of a point of size 1 at a window position: truncated, after rounding to a sub-pixel (MESA-RULES 5.4: half
/// away from the top left corner) [GL1.5 §3.3.1].
std::array<int, 2> pixel_of_point(double x, double y, int subpixel_bits);

/// Colour of a vertex on the sink's face, with the secondary colour added if the sink asks for it and has no textures.
Color color_of(const FragmentSink& sink, const VertexColors& colors);

}  // namespace gouraud::oracle
