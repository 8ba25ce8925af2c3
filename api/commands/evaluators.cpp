// Takes points of the maps' domains, gives vertices to the immediate batch as if the application had [GL1.5 §5.1].
// EvalMesh evaluates a row of the grid at a time.
#include "api/commands/evaluators.h"

#include <array>
#include <cstdint>
#include <new>
#include <vector>

#include "api/commands/begin_end.h"
#include "api/commands/map_evaluation.h"
#include "api/registry/conversions.h"

namespace gouraud::api {
namespace {

/// Vertices from evaluated values in place of the current ones, which come back at the end.
class VertexSender {
 public:
  VertexSender(Context& context, const MapSelection& selection)
      : context_(context),
        sends_normal_(selection.auto_normal || selection.normal != MapSelection::none),
        sends_color_(selection.color != MapSelection::none),
        sends_texture_coordinates_(selection.texture_coordinates != MapSelection::none),
        normal_(context.state.current.normal_object),
        color_(context.state.current.color),
        texture_coordinates_(context.state.current.texture_coordinates[0]) {}
  ~VertexSender() {
    context_.state.current.normal_object = normal_;
    context_.state.current.color = color_;
    context_.state.current.texture_coordinates[0] = texture_coordinates_;
  }
  VertexSender(const VertexSender&) = delete;
  VertexSender& operator=(const VertexSender&) = delete;

  void send(const EvaluatedValues& values) {
    CurrentGroup& current = context_.state.current;
    if (sends_normal_) current.normal_object = values.normal;
    if (sends_color_) current.color = values.color;
    if (sends_texture_coordinates_) current.texture_coordinates[0] = values.texture_coordinates;
    Vertex4f(context_, values.position.x, values.position.y, values.position.z, values.position.w);
  }

 private:
  Context& context_;
  bool sends_normal_, sends_color_, sends_texture_coordinates_;
  glm::vec3 normal_;
  glm::vec4 color_, texture_coordinates_;
};

// The grid's coordinate i; its ends exactly.
double grid_coordinate(const MapGrid& grid, std::int64_t i) {
  if (i == grid.segments) return grid.domain.last;
  const double first = grid.domain.first, last = grid.domain.last;
  return static_cast<double>(i) * ((last - first) / grid.segments) + first;
}

void evaluate_vertex(Context& context, double u) {
  if (context.immediate.limit == 0) return;  // nothing keeps the vertex
  const MapSelection selection = select_maps(context.state.eval, 1, context.immediate.demand);
  if (selection.position == MapSelection::none) return;
  EvaluatedValues values;
  CurveEvaluator(context.state.maps, selection).evaluate(u, values);
  VertexSender(context, selection).send(values);
}

void evaluate_vertex(Context& context, double u, double v) {
  if (context.immediate.limit == 0) return;
  const MapSelection selection = select_maps(context.state.eval, 2, context.immediate.demand);
  if (selection.position == MapSelection::none) return;
  SurfaceEvaluator surface(context.state.maps, selection);
  std::array<double, 5 * max_eval_order> weights;
  surface.weigh(u, weights.data());
  surface.set_row(v);
  EvaluatedValues values;
  surface.evaluate(weights.data(), values);
  VertexSender(context, selection).send(values);
}

/// The part i1..i2 x j1..j2 of the grid, as EvalMesh2 walks it.
class MeshWalk {
 public:
  MeshWalk(Context& context, const MapSelection& selection, std::int64_t i1, std::int64_t i2, std::int64_t j1,
           std::int64_t j2)
      : context_(context), surface_(context.state.maps, selection), sender_(context, selection), j1_(j1), j2_(j2) {
    columns_ = static_cast<std::size_t>(i2 - i1 + 1);
    if (columns_ > most_columns) throw std::bad_alloc();
    weights_.resize(columns_ * surface_.weight_count());
    for (std::size_t c = 0; c < columns_; ++c) {
      surface_.weigh(grid_coordinate(context.state.eval.grid2_u, i1 + static_cast<std::int64_t>(c)), weights_of(c));
    }
  }

  /// Rows of quads [GL1.5 §5.1].
  /// choice: their diagonals are those of a triangle strip, as Mesa has them, where they make no other difference.
  void fill() {
    const State& state = context_.state;
    const bool shows_quads = state.lighting.shade_model == GL_FLAT || state.polygon.front_mode != GL_FILL || state.polygon.back_mode != GL_FILL ||
                             state.polygon.smooth_enabled || state.render_mode.mode != GL_RENDER;
    const auto row_mode = shows_quads ? pipeline::PrimitiveMode::quad_strip : pipeline::PrimitiveMode::triangle_strip;
    std::vector<EvaluatedValues> lower(columns_), upper(columns_);
    if (j1_ < j2_) evaluate_row(j1_, lower);
    for (std::int64_t j = j1_; j < j2_; ++j) {
      evaluate_row(j + 1, upper);
      context_.begin_primitive(row_mode);
      for (std::size_t c = 0; c < columns_; ++c) {
        sender_.send(lower[c]);
        sender_.send(upper[c]);
      }
      context_.end_primitive();
      lower.swap(upper);
    }
  }

  void lines() {
    std::vector<EvaluatedValues> row(columns_);
    for (std::int64_t j = j1_; j <= j2_; ++j) {
      evaluate_row(j, row);
      context_.begin_primitive(pipeline::PrimitiveMode::line_strip);
      for (const EvaluatedValues& values : row) sender_.send(values);
      context_.end_primitive();
    }
    for (std::size_t c = 0; c < columns_; ++c) {
      context_.begin_primitive(pipeline::PrimitiveMode::line_strip);
      for (std::int64_t j = j1_; j <= j2_; ++j) {
        surface_.set_row(v_of(j));
        surface_.evaluate(weights_of(c), row[0]);
        sender_.send(row[0]);
      }
      context_.end_primitive();
    }
  }

  void points() {
    EvaluatedValues values;
    context_.begin_primitive(pipeline::PrimitiveMode::points);
    for (std::int64_t j = j1_; j <= j2_; ++j) {
      surface_.set_row(v_of(j));
      for (std::size_t c = 0; c < columns_; ++c) {
        surface_.evaluate(weights_of(c), values);
        sender_.send(values);
      }
    }
    context_.end_primitive();
  }

 private:
  /// choice: a row of more points than this needs more memory than we give it.
  static constexpr std::size_t most_columns = 1 << 17;

  double* weights_of(std::size_t column) { return weights_.data() + column * surface_.weight_count(); }
  double v_of(std::int64_t j) const { return grid_coordinate(context_.state.eval.grid2_v, j); }
  void evaluate_row(std::int64_t j, std::vector<EvaluatedValues>& row) {
    surface_.set_row(v_of(j));
    for (std::size_t c = 0; c < columns_; ++c) surface_.evaluate(weights_of(c), row[c]);
  }

  Context& context_;
  SurfaceEvaluator surface_;
  VertexSender sender_;
  std::int64_t j1_, j2_;
  std::size_t columns_ = 0;
  std::vector<double> weights_;
};

// A mesh that runs out of memory ends its primitive.
template <class Walk>
void walk(Context& context, const Walk& steps) {
  try {
    steps();
  } catch (const std::bad_alloc&) {
    if (context.inside_begin_end()) context.end_primitive();
    throw;
  }
}

}  // namespace

void MapGrid1f(Context& context, GLint un, GLfloat u1, GLfloat u2) {
  if (un < 1) return context.record_error(GL_INVALID_VALUE, "glMapGrid1", "un is not positive");
  context.state.eval.grid1_u = {{u1, u2}, un};
}

void MapGrid2f(Context& context, GLint un, GLfloat u1, GLfloat u2, GLint vn, GLfloat v1, GLfloat v2) {
  if (un < 1 || vn < 1) return context.record_error(GL_INVALID_VALUE, "glMapGrid2", "un or vn is not positive");
  context.state.eval.grid2_u = {{u1, u2}, un};
  context.state.eval.grid2_v = {{v1, v2}, vn};
}

void EvalCoord1f(Context& context, GLfloat u) {
  evaluate_vertex(context, u);
}

void EvalCoord2f(Context& context, GLfloat u, GLfloat v) {
  evaluate_vertex(context, u, v);
}

void EvalPoint1(Context& context, GLint i) {
  evaluate_vertex(context, grid_coordinate(context.state.eval.grid1_u, i));
}

void EvalPoint2(Context& context, GLint i, GLint j) {
  const EvalGroup& eval = context.state.eval;
  evaluate_vertex(context, grid_coordinate(eval.grid2_u, i), grid_coordinate(eval.grid2_v, j));
}

void EvalMesh1(Context& context, GLenum mode, GLint i1, GLint i2) {
  if (mode != GL_POINT && mode != GL_LINE) {
    return context.record_error(GL_INVALID_ENUM, "glEvalMesh1", "mode is unknown");
  }
  if (!context.can_draw("glEvalMesh1")) return;
  context.refresh();
  const MapSelection selection = select_maps(context.state.eval, 1, context.plan().vertex_demand);
  if (selection.position == MapSelection::none || !context.plan().draws) return;
  const CurveEvaluator curve(context.state.maps, selection);
  walk(context, [&] {
    VertexSender sender(context, selection);
    EvaluatedValues values;
    context.begin_primitive(mode == GL_POINT ? pipeline::PrimitiveMode::points : pipeline::PrimitiveMode::line_strip);
    for (std::int64_t i = i1; i <= i2; ++i) {
      curve.evaluate(grid_coordinate(context.state.eval.grid1_u, i), values);
      sender.send(values);
    }
    context.end_primitive();
  });
}

void EvalMesh2(Context& context, GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2) {
  if (mode != GL_POINT && mode != GL_LINE && mode != GL_FILL) {
    return context.record_error(GL_INVALID_ENUM, "glEvalMesh2", "mode is unknown");
  }
  if (!context.can_draw("glEvalMesh2")) return;
  context.refresh();
  const MapSelection selection = select_maps(context.state.eval, 2, context.plan().vertex_demand);
  if (selection.position == MapSelection::none || !context.plan().draws || i1 > i2 || j1 > j2) return;
  walk(context, [&] {
    MeshWalk mesh(context, selection, i1, i2, j1, j2);
    if (mode == GL_FILL) mesh.fill();
    if (mode == GL_LINE) mesh.lines();
    if (mode == GL_POINT) mesh.points();
  });
}

}  // namespace gouraud::api
