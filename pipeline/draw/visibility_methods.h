// Which surface is seen, without a depth buffer: the methods "depth=painter" and "depth=ray".
//
// Triangles with a depth test that keeps the nearer one (or the farther one) are gathered until something else is to be
// drawn, or the picture is to be complete. Then either goes over all of them:
//
// painter: sorts them by the mean depth of their corners and draws the farthest first. No memory for a buffer, and blending comes out
// right; but every layer of the picture is drawn, sorting takes n log n, and no order is right for triangles that pass
// through each other or overlap in a cycle, nor is the mean depth for large ones beside small ones.
// Source: M. Newell, R. Newell, T. Sancha, "A solution to the hidden surface problem", 1972, without its splitting.
//
// ray: asks for each pixel which triangle the ray from the eye through its centre meets first, and draws that one alone. One surface a
// pixel: nothing is shaded that is not seen, nothing shines through. The triangles of a tile are all tried for each of its pixels.
// Sources: A. Appel, "Some techniques for shading machine renderings of solids", 1968; T. Moeller, B. Trumbore, "Fast, minimum storage
// ray/triangle intersection", 1997.
//
// Lines and points are drawn when they come, over the triangles before them. No depths are written.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/draw/methods.h"
#include "pipeline/draw/tiles.h"
#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/raster/method_shape.h"
#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {

class GatheredTriangles {
 public:
  bool empty() const { return triangles_.empty(); }
  /// A triangle of the sample; its record and shape last until the bins have run. `nearest`: the smaller depth is seen.
  void add(const PrimitiveRecord& record, std::int32_t sample, bool nearest);
  /// Gives them to the bins, in the order or in the form of the method.
  void give_to(TileBins& bins, DepthMethod method);

 private:
  struct Gathered {
    const PrimitiveRecord* record = nullptr;
    double depth = 0;  ///< larger is farther
    std::int32_t sample = 0;
  };
  void give_rays(TileBins& bins, std::size_t first, std::size_t end);
  std::vector<Gathered> triangles_;
};

}  // namespace gouraud::pipeline
