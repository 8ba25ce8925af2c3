// The way of a draw through the oracle's stages, and the measure of other pictures.
#include "conformance/oracle/oracle.h"

#include <algorithm>
#include <cmath>

#include "conformance/oracle/accumulation.h"
#include "conformance/oracle/assembly.h"
#include "conformance/oracle/blits.h"
#include "conformance/oracle/clipping.h"
#include "conformance/oracle/fragments.h"
#include "conformance/oracle/lighting.h"
#include "conformance/oracle/pixel_rectangles.h"
#include "conformance/oracle/positions.h"
#include "conformance/oracle/rasterize.h"
#include "conformance/oracle/targets.h"
#include "conformance/oracle/texture_coordinates.h"
#include "conformance/oracle/fog.h"

namespace gouraud::oracle {
namespace {

using pipeline::CullMode;
using pipeline::PolygonMode;

/// Draws the primitives of one batch; positions in T.
template <typename T>
class Draw {
 public:
  Draw(const pipeline::DrawState& state, const pipeline::VertexBatch& batch, const OracleOptions& options,
       Samples& samples, Carried& carried)
      : state_(state), smooth_parts_(carried.smooth_parts), stipple_count_(carried.stipple_count), clipped_quads_(carried.clipped_quads) {
    sink_.samples = &samples;
    sink_.multisample = state.multisample;
    sink_.state = state.raster;
    sink_.subpixel_bits = subpixel_bits<T>;
    sink_.points = state.points;
    sink_.lines = state.lines;
    sink_.texturing = state.texturing;
    sink_.has_secondary = state.lighting.enabled ? state.lighting.separate_specular : state.color_sum;
    if (sink_.depth_bits() > 0) sink_.depth_slack = options.depth_slack_units / depth_units_of(sink_.depth_bits());

    const auto matrix = combined_matrix<T>(state.transform);
    const auto modelview = modelview_matrix<T>(state.transform);
    Lighting lighting(state, batch);
    for (int i = 0; i < batch.count; ++i) {
      std::array<float, 4> position;
      for (std::size_t k = 0; k < 4; ++k) position[k] = batch.position_object[k][static_cast<std::size_t>(i)];
      VertexColors colors = lighting.shade(i);
      colors.texture_coordinates = texture_coordinates(state, batch, i);
      if (state.raster.fog.mode != pipeline::FogMode::none) colors.fog_coordinate = fog_coordinate(state, batch, i);
      vertices_.push_back({to_clip_space<T>(matrix, position), colors, to_clip_space<T>(modelview, position)});
      sizes_.push_back(point_size(position));
    }
    samples.front().knife_edge_vertices += lighting.knife_edges();
  }

  /// A Begin, or the next of independent lines.
  void reset_stipple() { stipple_count_ = 0; }

  /// As MESA-RULES 2.5 has it; `i` counts the batch's ranges, and must go up.
  QuadSplit split_of_quads(const pipeline::VertexBatch& batch, std::size_t i) {
    using pipeline::PrimitiveMode;
    const std::vector<pipeline::PrimitiveRange>& ranges = batch.primitives;
    const pipeline::PrimitiveRange& range = ranges[i];
    if (range.mode == PrimitiveMode::quads && (i == 0 || !are_drawn_together(ranges[i - 1], range))) {
      clipped_quads_ = (clipped_quads_ && !range.begins) || is_clipped(batch, range);
      for (std::size_t k = i + 1; k < ranges.size() && are_drawn_together(ranges[k - 1], ranges[k]); ++k) {
        clipped_quads_ = clipped_quads_ || is_clipped(batch, ranges[k]);
      }
    }
    const pipeline::AssemblyState& assembly = state_.assembly;
    const bool filled = assembly.polygon_mode_front == PolygonMode::fill && assembly.polygon_mode_back == PolygonMode::fill;
    const bool in_pieces = !filled || sink_.state.polygon_stipple.enabled;
    const bool plain = !in_pieces && assembly.shade_model == pipeline::ShadeModel::smooth;
    const bool from_list = range.origin == pipeline::PrimitiveOrigin::display_list;
    return {.diagonal_02 = plain && !clipped_quads_ && !range.indexed && !from_list,
            .strips_far_half_first = range.mode == PrimitiveMode::quad_strip && (in_pieces || is_clipped(batch, range))};
  }

  void draw(const Primitive& primitive) {
    if (!primitive.continues) finish_polygon();
    const bool flat = state_.assembly.shade_model == pipeline::ShadeModel::flat;
    sink_.flat_colors = flat ? &vertex(primitive.provoking).colors : nullptr;
    sink_.face = front;
    sink_.depth_offset = 0;
    switch (primitive.vertex_count) {
      case 1:
        draw_point(primitive);
        break;
      case 2:
        draw_line({vertex(primitive.vertex[0]), vertex(primitive.vertex[1])});
        break;
      default:
        draw_triangle(primitive);
    }
  }

  /// What comes next belongs to no polygon before it.
  void finish_polygon() {
    if (!smooth_parts_.empty()) rasterize_smooth_polygon(smooth_parts_);
    smooth_parts_.clear();
  }

 private:
  const ClipVertex<T>& vertex(int i) const { return vertices_[static_cast<std::size_t>(i)]; }

  static bool are_drawn_together(const pipeline::PrimitiveRange& a, const pipeline::PrimitiveRange& b) {
    const auto may = [](const pipeline::PrimitiveRange& range) {
      return range.mode == pipeline::PrimitiveMode::quads && !range.indexed && range.origin == pipeline::PrimitiveOrigin::begin_end;
    };
    return may(a) && may(b);
  }

  bool is_clipped(const pipeline::VertexBatch& batch, const pipeline::PrimitiveRange& range) const {
    const int left_over = range.count % (range.mode == pipeline::PrimitiveMode::quads ? 4 : 2);
    for (int n = range.first; n < range.first + range.count - left_over; ++n) {
      const int named = range.indexed ? batch.elements[static_cast<std::size_t>(n)] : n;
      if (!in_view_volume(vertex(named), state_.clip_planes, state_.viewport.zero_to_one)) return true;
    }
    return false;
  }

  void draw_point(const Primitive& primitive) {
    const ClipVertex<T>& point = vertex(primitive.vertex[0]);
    if (!in_view_volume(point, state_.clip_planes, state_.viewport.zero_to_one)) return;
    if (const auto window = to_window_space(point, state_.viewport)) rasterize_point(sink_, *window, size_of(primitive, 0));
  }

  /// As attenuated by the distance from the eye [GL1.5 §3.3].
  double point_size(const std::array<float, 4>& position_object) const {
    const pipeline::PointState& points = state_.points;
    if (!points.attenuated) return static_cast<double>(points.size_px);
    double squared = 0;
    for (int row = 0; row < 3; ++row) {
      double component = 0;
      for (int k = 0; k < 4; ++k) component += static_cast<double>(state_.transform.modelview[k][row]) * static_cast<double>(position_object[static_cast<std::size_t>(k)]);
      squared += component * component;
    }
    const auto& [a, b, c] = std::array<double, 3>{points.attenuation.x, points.attenuation.y, points.attenuation.z};
    const double size = static_cast<double>(points.size_px) * std::sqrt(1 / (a + b * std::sqrt(squared) + c * squared));
    return std::min(std::max(size, static_cast<double>(points.smallest_px)), static_cast<double>(points.largest_px));
  }
  double size_of(const Primitive& primitive, std::size_t corner) const {
    return sizes_[static_cast<std::size_t>(primitive.vertex[std::min<std::size_t>(corner, 2)])];
  }

  void draw_line(const std::array<ClipVertex<T>, 2>& line) {
    // The stipple of a clipped line goes as that of the whole one: the specification leaves it open [GL1.5 §3.4.2].
    const auto whole_a = to_window_space(line[0], state_.viewport), whole_b = to_window_space(line[1], state_.viewport);
    const bool known = line[0].position[3] > 0 && line[1].position[3] > 0 && whole_a && whole_b;
    const std::int64_t before = stipple_count_;
    const auto fragments_between = [&](const WindowVertex& from, const WindowVertex& to) {
      const bool steep = std::abs(whole_b->y - whole_a->y) > std::abs(whole_b->x - whole_a->x);
      const double length = steep ? std::abs(to.y - from.y) : std::abs(to.x - from.x);
      return length < 1e6 ? std::llround(length) : 0;  // farther: bad input, and where its counter stands is left open
    };
    const bool inside = in_view_volume(line[0], state_.clip_planes, state_.viewport.zero_to_one) && in_view_volume(line[1], state_.clip_planes, state_.viewport.zero_to_one);
    const auto clipped = clip_line(line, state_.clip_planes, state_.viewport.zero_to_one);
    if (!inside && known) stipple_count_ = before + fragments_between(*whole_a, *whole_b);
    if (!clipped) return;
    const auto a = to_window_space((*clipped)[0], state_.viewport), b = to_window_space((*clipped)[1], state_.viewport);
    if (!a || !b) return;
    if (inside) return rasterize_line(sink_, {*a, *b}, stipple_count_);
    std::int64_t count = before + (known ? fragments_between(*whole_a, *a) : 0);
    rasterize_line(sink_, {*a, *b}, count);
  }

  void draw_triangle(const Primitive& primitive) {
    const ClippedPolygon<T> clipped =
        clip_triangle<T>({vertex(primitive.vertex[0]), vertex(primitive.vertex[1]), vertex(primitive.vertex[2])},
                         primitive.boundary_edges, state_.clip_planes, state_.viewport.zero_to_one);
    std::vector<WindowVertex> polygon;
    for (const ClipVertex<T>& corner : clipped.vertices) {
      const auto window = to_window_space(corner, state_.viewport);
      if (!window) return;
      polygon.push_back(*window);
    }
    if (polygon.size() < 3) return;
    const pipeline::AssemblyState& assembly = state_.assembly;
    if (assembly.polygon_mode_front == PolygonMode::fill && assembly.polygon_mode_back == PolygonMode::fill) {
      fill(polygon, [](const auto& t) { return sign(doubled_area(t[0].snapped, t[1].snapped, t[2].snapped)); });
      return;
    }

    if (!primitive.continues) reset_stipple();
    // Lines and points: facing by the area of the whole polygon, unsnapped [GL1.5 §2.14.1 eq 2.6].
    const int area_sign = sign(unsnapped_area(polygon));
    if (!select_face(area_sign)) return;
    switch (sink_.face == front ? assembly.polygon_mode_front : assembly.polygon_mode_back) {
      case PolygonMode::fill:
        fill(polygon, [area_sign](const auto&) { return area_sign; });
        break;
      case PolygonMode::line:
        if (state_.polygons.offset_line) sink_.depth_offset = offset_of({polygon[0], polygon[1], polygon[2]});
        outline(polygon, clipped.boundary, clipped.is_cut);
        break;
      case PolygonMode::point:
        if (state_.polygons.offset_point) sink_.depth_offset = offset_of({polygon[0], polygon[1], polygon[2]});
        for (std::size_t i = 0; i < polygon.size(); ++i) {
          if (clipped.boundary[i]) rasterize_point(sink_, polygon[i], size_of(primitive, i));
        }
    }
  }

  template <typename Number>
  static int sign(Number area) {
    return area > 0 ? 1 : area < 0 ? -1 : 0;
  }

  static double unsnapped_area(const std::vector<WindowVertex>& polygon) {
    double area = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const WindowVertex &o = polygon[0], &a = polygon[i - 1], &b = polygon[i];
      area += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
    }
    return area;
  }

  /// Sets the face that a polygon of this area shows; false if it is culled [GL1.5 §2.14.1, §3.5.1].
  bool select_face(int area_sign) {
    const bool ccw_is_front = state_.assembly.front_face == pipeline::FrontFace::ccw;
    sink_.face = (ccw_is_front ? area_sign > 0 : area_sign < 0) ? front : back;
    switch (state_.assembly.cull) {
      case CullMode::none:
        return true;
      case CullMode::front:
        return sink_.face != front;
      case CullMode::back:
        return sink_.face != back;
      case CullMode::front_and_back:
        break;
    }
    return false;
  }

  /// As a fan of triangles (i - 1, i, 0), as the clipper's rules say (MESA-RULES 2.4).
  template <typename AreaSign>
  void fill(const std::vector<WindowVertex>& polygon, AreaSign area_sign) {
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const std::array<WindowVertex, 3> triangle{polygon[i - 1], polygon[i], polygon[0]};
      if (!select_face(area_sign(triangle))) continue;
      sink_.depth_offset = state_.polygons.offset_fill ? offset_of(triangle) : 0.0;
      if (!state_.polygons.smooth) {
        rasterize_triangle(sink_, triangle);
      } else if (doubled_area(triangle[0].snapped, triangle[1].snapped, triangle[2].snapped) != 0) {
        smooth_parts_.push_back({sink_, triangle, sink_.flat_colors != nullptr ? *sink_.flat_colors : VertexColors{}});
      }
    }
  }

  double offset_of(const std::array<WindowVertex, 3>& triangle) const {
    return polygon_offset(state_.polygons, sink_.depth_bits(), triangle);
  }

  /// The specification says nothing of the order, which decides where edges meet in a pixel. Mesa draws the edges 2-0,
  /// 0-1, 1-2 of each triangle (i - 1, i, 0) of a clipped polygon, so the polygon's in order (MESA-RULES 2.4, 5.5).
  void outline(const std::vector<WindowVertex>& polygon, const std::vector<bool>& boundary, bool clipped) {
    const std::size_t n = polygon.size(), first = clipped ? 0 : n - 1;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = (first + k) % n;
      if (boundary[i]) rasterize_line(sink_, {polygon[i], polygon[(i + 1) % n]}, stipple_count_);
    }
  }

  const pipeline::DrawState& state_;
  FragmentSink sink_;
  std::vector<ClipVertex<T>> vertices_;
  std::vector<double> sizes_;  ///< of points at the vertices
  std::vector<SmoothPart>& smooth_parts_;
  std::int64_t& stipple_count_;
  bool& clipped_quads_;
};

/// Edge flags: of separate triangles, quads and polygons drawn as lines or points [GL1.5 §2.6.2].
void apply_edge_flags(const pipeline::VertexBatch& batch, const pipeline::PrimitiveRange& range,
                      const pipeline::AssemblyState& assembly, Primitive& primitive) {
  using pipeline::PrimitiveMode;
  const bool has_flags = range.mode == PrimitiveMode::triangles || range.mode == PrimitiveMode::quads || range.mode == PrimitiveMode::polygon;
  const bool filled = assembly.polygon_mode_front == PolygonMode::fill && assembly.polygon_mode_back == PolygonMode::fill;
  for (std::size_t i = 0; has_flags && !filled && i < 3; ++i) {
    if (batch.edge_flag[static_cast<std::size_t>(primitive.vertex[i])] == 0) primitive.boundary_edges &= ~(1u << i);
  }
}

template <typename T>
void draw_batch(const pipeline::DrawState& state, const pipeline::VertexBatch& batch, const OracleOptions& options,
                Samples& samples, Carried& carried) {
  Draw<T> draw(state, batch, options, samples, carried);
  for (std::size_t i = 0; i < batch.primitives.size(); ++i) {
    const pipeline::PrimitiveRange& range = batch.primitives[i];
    if (range.begins) draw.reset_stipple();
    const QuadSplit split = draw.split_of_quads(batch, i);
    for (Primitive& primitive : assemble(range, split)) {
      if (range.indexed) resolve_elements(batch, primitive);
      if (range.mode == pipeline::PrimitiveMode::lines) draw.reset_stipple();
      apply_edge_flags(batch, range, state.assembly, primitive);
      draw.draw(primitive);
    }
    const bool goes_on = range.mode == pipeline::PrimitiveMode::polygon && !range.ends;
    if (!goes_on) draw.finish_polygon();
  }
}

double distance_to_range(double value, double lowest, double highest) {
  return std::max({lowest - value, value - highest, 0.0});
}

PixelError measure_content(const OraclePixel& pixel, bool extrapolated, const std::array<std::uint8_t, 4>& rgba_unorm8,
                           std::uint32_t depth, bool compare_depth) {
  PixelError error;
  for (std::size_t i = 0; i < 4; ++i) {
    const double lowest = extrapolated ? static_cast<double>(pixel.color_lowest[i]) : pixel.color[i];
    const double highest = extrapolated ? static_cast<double>(pixel.color_highest[i]) : pixel.color[i];
    error.color = std::max(error.color, distance_to_range(rgba_unorm8[i], 255.0 * lowest, 255.0 * highest));
  }
  if (compare_depth) {
    const double lowest = extrapolated ? std::min<double>(pixel.depth_lowest, pixel.depth_units) : pixel.depth_units;
    const double highest = extrapolated ? std::max<double>(pixel.depth_highest, pixel.depth_units) : pixel.depth_units;
    error.depth = distance_to_range(depth, lowest, highest);
  }
  return error;
}

}  // namespace

Oracle::Oracle(const OracleOptions& options) : options_(options), targets_(std::make_unique<Targets>()) {}
Oracle::~Oracle() = default;

void Oracle::target_changed(const pipeline::Framebuffer& target) {
  target_ = target;
  samples_ = &targets_->pictures_of(target);
}

const OraclePicture& Oracle::picture() const { return samples_->front(); }

void Oracle::draw(const pipeline::DrawState& state, const pipeline::VertexBatch& batch) {
  if (options_.positions == PositionModel::snapped) {
    draw_batch<float>(state, batch, options_, *samples_, carried_);
  } else {
    draw_batch<double>(state, batch, options_, *samples_, carried_);
  }
}

void Oracle::rectangle(const pipeline::DrawState& state, const pipeline::FragmentSource& source,
                       const pipeline::PixelRectangle& rectangle) {
  draw_rectangle(*samples_, state, source, rectangle);
}

void Oracle::bitmap(const pipeline::DrawState& state, const pipeline::FragmentSource& source, const pipeline::Bitmap& bitmap) {
  draw_bitmap(*samples_, state, source, bitmap);
}

void Oracle::write(const pipeline::DirectRectangle& rectangle) { write_directly(*samples_, rectangle); }

void Oracle::clear(const pipeline::ClearState& state) {
  for (OraclePicture& picture : *samples_) clear_picture(picture, state);
}

void Oracle::accumulate(const pipeline::AccumState& state) {
  for (OraclePicture& picture : *samples_) accumulate_picture(picture, state);
}

void Oracle::blit(const pipeline::Framebuffer& source, const pipeline::Blit& wanted) {
  const Samples from = targets_->pictures_of(source);  // a copy: it may be the target itself
  samples_ = &targets_->pictures_of(target_);
  pipeline::Blit blit = wanted;
  blit.color &= !source.color.empty() && !target_.color.empty();
  blit.depth &= source.has_depth && target_.has_depth;
  blit.stencil &= source.stencil_bits > 0 && target_.stencil_bits > 0;
  samples_->front().knife_edge_vertices += from.front().knife_edge_vertices;
  blit_samples(from, *samples_, blit, target_.color_channels);
}

std::size_t OraclePicture::count(std::uint8_t flag_bits) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(flags, [flag_bits](std::uint8_t f) { return (f & flag_bits) != 0; }));
}

PixelError measure(const OraclePicture& picture, int x, int y, const std::array<std::uint8_t, 4>& rgba_unorm8,
                   std::uint32_t depth, bool compare_depth) {
  const std::size_t index = picture.index(x, y);
  const bool extrapolated = (picture.flags[index] & pixel_extrapolated) != 0;
  const auto measured = [&](const OraclePixel& pixel) {
    return measure_content(pixel, extrapolated, rgba_unorm8, depth, compare_depth && picture.depth_bits > 0);
  };
  PixelError best = measured(picture.pixels[index]);
  const auto found = picture.alternatives.find(index);
  if (found == picture.alternatives.end()) return best;
  const auto badness = [](const PixelError& e) { return std::max(e.color, e.depth); };
  for (const OraclePixel& other : found->second) {
    PixelError error = measured(other);
    error.alternative = true;
    if (badness(error) < badness(best)) best = error;
  }
  return best;
}

}  // namespace gouraud::oracle
