// Evaluates the enabled maps of one dimension at points of their domain [GL1.5 §5.1].
//
// A surface is evaluated as a tensor product: a row of constant v first becomes a curve in u, whose points are then
// cheap. The same sums in the same order whichever way a point is asked for, so a mesh meets EvalCoord's points exactly.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/glm.hpp>

#include "api/state/state.h"

namespace gouraud::api {

/// The values that a vertex can get from maps; those that none gives stay what they were.
struct EvaluatedValues {
  glm::vec4 position{0.0f, 0.0f, 0.0f, 1.0f};
  glm::vec3 normal{0.0f};
  glm::vec4 color{1.0f};
  glm::vec4 texture_coordinates{0.0f, 0.0f, 0.0f, 1.0f};
};

/// The maps that count for a draw: those enabled, with the most components, whose values its vertices demand.
struct MapSelection {
  static constexpr std::size_t none = map_kinds;
  std::size_t position = none;  ///< none: nothing is drawn
  std::size_t normal = none, color = none, texture_coordinates = none;
  bool auto_normal = false;  ///< the normal comes from the surface
};

/// `demand`: VertexAttribute bits.
MapSelection select_maps(const EvalGroup& group, int dimensions, std::uint32_t demand);

/// Curves in one parameter.
class CurveEvaluator {
 public:
  CurveEvaluator(const EvaluatorMaps& maps, const MapSelection& selection) : maps_(maps.one), selection_(selection) {}
  void evaluate(double u, EvaluatedValues& out) const;

 private:
  const std::array<Map1, map_kinds>& maps_;
  MapSelection selection_;
};

/// Surfaces: first a row, then its points.
class SurfaceEvaluator {
 public:
  SurfaceEvaluator(const EvaluatorMaps& maps, const MapSelection& selection);

  /// Doubles that the weights of one u take.
  std::size_t weight_count() const { return weight_count_; }
  void weigh(double u, double* weights) const;
  void set_row(double v);
  /// At the row's v and at the u of the weights.
  void evaluate(const double* weights, EvaluatedValues& out) const;

 private:
  /// A map in use, and the row's curve.
  struct Part {
    const Map2* map = nullptr;
    std::size_t components = 0;
    bool slopes = false;
    std::array<double, 4 * max_eval_order> curve, curve_slope;  ///< the slope by v
  };
  void use(const EvaluatorMaps& maps, std::size_t kind, Part& part, bool slopes);

  MapSelection selection_;
  Part position_, normal_, color_, texture_coordinates_;
  std::size_t weight_count_ = 0;
};

}  // namespace gouraud::api
