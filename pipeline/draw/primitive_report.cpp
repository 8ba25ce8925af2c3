#include "pipeline/draw/primitive_report.h"

#include <utility>
#include <vector>

#include "pipeline/geometry/assembly.h"
#include "pipeline/geometry/clipping.h"
#include "pipeline/geometry/outlines.h"
#include "pipeline/geometry/viewport.h"
#include "pipeline/raster/setup.h"

namespace gouraud::pipeline {
namespace {

class Reporter {
 public:
  Reporter(const DrawState& state, const Plan& plan, const VaryingLayout& varyings, const VertexBatch& batch,
           ProcessedVertices& vertices, PrimitiveReceiver& receiver)
      : state_(state),
        plan_(plan),
        varyings_(varyings),
        vertices_(vertices),
        receiver_(receiver),
        count_(vertices.count),
        two_sided_(plan.lighting && state.lighting.two_sided),
        flat_(state.assembly.shade_model == ShadeModel::flat),
        attributes_{plan.eye_positions, plan.colors, two_sided_, false, varyings.of_vertices(), &state.clip_planes},
        edge_flag_((plan.vertex_demand & attribute_edge_flag) != 0 ? batch.edge_flag.data() : nullptr),
        elements_(batch.elements.data()) {}

  void report(const PrimitiveRange& range) {
    assembled_ = {};
    if (outline_count(range) == 0) assemble(range, {}, assembled_);
    if (range.indexed) resolve_elements(elements_ + range.first, assembled_);
    for (const AssembledPoint& point : assembled_.points) {
      if (vertices_.outcode[point.vertex] == 0) receiver_.point(vertex(point.vertex, point.vertex, false));
    }
    bool starts = range.begins;
    for (const AssembledLine& line : assembled_.lines) {
      report_line(line, starts);
      starts = range.mode == PrimitiveMode::lines;
    }
    for (std::int32_t i = 0; i < outline_count(range); ++i) {
      make_outline(range, i, edge_flag_, elements_, outline_);
      report_outline();
      vertices_.count = count_;
    }
  }

 private:
  ReportedVertex vertex(std::uint16_t index, std::uint16_t provoking, bool back) const {
    ReportedVertex result;
    result.position_window = window_position(state_.viewport, vertices_, index);
    result.w_clip = vertices_.position_clip[3][index];
    if (plan_.colors) {
      const Rgba& color = (back ? vertices_.color_back : vertices_.color_front)[flat_ ? provoking : index];
      result.color = glm::vec4(color.r, color.g, color.b, color.a);
    }
    if (plan_.textured) result.texture_coordinates = texture_coordinates_of(varyings_, 0, vertices_, index);
    return result;
  }

  void report_line(AssembledLine line, bool starts) {
    const unsigned outcodes = vertices_.outcode[line.vertex[0]] | vertices_.outcode[line.vertex[1]];
    if (outcodes == 0 || clip_line(line, state_.viewport, attributes_, vertices_)) {
      receiver_.line(vertex(line.vertex[0], line.provoking, false), vertex(line.vertex[1], line.provoking, false),
                     starts);
    }
    vertices_.count = count_;
  }

  /// The sign of the polygon's area decides [GL1.5 §2.14.1 eq 2.6]; zero counts as back, as for triangles.
  bool faces_front() const {
    double area = 0;
    for (std::size_t i = 0; i < outline_.size; ++i) {
      const WindowVertex &a = vertices_.window[outline_.vertex[i]],
                         &b = vertices_.window[outline_.vertex[i + 1 < outline_.size ? i + 1 : 0]];
      area -= static_cast<double>(a.x) * b.y_raster - static_cast<double>(b.x) * a.y_raster;  // y_raster runs down
    }
    return area != 0.0 && (area > 0.0) == (state_.assembly.front_face == FrontFace::ccw);
  }

  void report_outline() {
    if (!clip_outline(outline_, state_.viewport, attributes_, vertices_)) return;
    const bool front = faces_front();
    if (is_culled(state_.assembly.cull, front)) return;
    polygon_.clear();
    for (std::size_t i = 0; i < outline_.size; ++i) {
      polygon_.push_back(vertex(outline_.vertex[i], outline_.provoking, two_sided_ && !front));
    }
    const PolygonMode mode = front ? state_.assembly.polygon_mode_front : state_.assembly.polygon_mode_back;
    if (mode == PolygonMode::fill) return receiver_.polygon(polygon_);
    bool starts = true;
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      if (!outline_.boundary[i]) continue;
      if (mode == PolygonMode::point) {
        receiver_.point(polygon_[i]);
      } else {
        receiver_.line(polygon_[i], polygon_[i + 1 < polygon_.size() ? i + 1 : 0], std::exchange(starts, false));
      }
    }
  }

  const DrawState& state_;
  const Plan& plan_;
  const VaryingLayout& varyings_;
  ProcessedVertices& vertices_;
  PrimitiveReceiver& receiver_;
  const std::int32_t count_;  ///< of the batch's vertices
  const bool two_sided_, flat_;
  const ClipAttributes attributes_;
  const std::uint8_t* const edge_flag_;
  const std::uint16_t* const elements_;
  AssembledPrimitives assembled_;
  Outline outline_;
  std::vector<ReportedVertex> polygon_;
};

}  // namespace

glm::vec4 texture_coordinates_of(const VaryingLayout& varyings, int unit, const ProcessedVertices& vertices,
                                 std::uint16_t index) {
  const std::int8_t first = varyings.texture_coordinates[static_cast<std::size_t>(unit)].first;
  if (first < 0) return glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
  const auto* const arrays = &vertices.varying[static_cast<std::size_t>(first)];
  return glm::vec4(arrays[0][index], arrays[1][index], arrays[2][index], arrays[3][index]);
}

void report_primitives(const DrawState& state, const Plan& plan, const VaryingLayout& varyings, const VertexBatch& batch,
                       ProcessedVertices& vertices, PrimitiveReceiver& receiver) {
  Reporter reporter(state, plan, varyings, batch, vertices, receiver);
  for (const PrimitiveRange& range : batch.primitives) reporter.report(range);
}

}  // namespace gouraud::pipeline
