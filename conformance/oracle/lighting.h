// Takes object-space vertices, gives their colours [GL1.5 §2.11.3, §2.14.1-2.14.6].
// Everything in double, in eye space, from the modelview matrix as given. Points are homogeneous: a vertex is divided
// by its eye w, as the vectors of §2.14.1 are defined. 0^0 = 1 [GL1.5 §2.1.1]. A zero vector stays zero when
// normalised. Leaves out flat shading and the choice between front and back: assembly knows them.
#pragma once

#include <cstdint>

#include "conformance/oracle/vertex.h"
#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/vertex_batch.h"

namespace gouraud::oracle {

/// What lighting does to one batch.
class Lighting {
 public:
  /// `state` and `batch` must outlive the object.
  Lighting(const pipeline::DrawState& state, const pipeline::VertexBatch& batch);

  /// Colours of the batch's vertex `index`, clamped. Without lighting the vertex's own colour.
  VertexColors shade(int index);

  /// The normal in eye space, scaled as the state says [GL1.5 §2.11.3].
  Vector3 normal_to_eye(int index) const;

  /// How many of the vertices shaded so far were lit on a knife's edge (OraclePicture).
  std::int64_t knife_edges() const { return knife_edges_; }

 private:
  struct Lit {
    Color primary{}, secondary{};
  };
  Lit light(const Vector3& position_eye, const Vector3& normal_eye, const pipeline::Material& material);
  const pipeline::DrawState& state_;
  const pipeline::VertexBatch& batch_;
  std::array<Vector3, 3> inverse_{};  ///< of the modelview's upper 3x3, [row][column]
  double rescale_ = 1.0;
  bool on_knife_edge_ = false;
  std::int64_t knife_edges_ = 0;
};

}  // namespace gouraud::oracle
