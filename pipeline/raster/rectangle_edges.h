// The rectangles that are multisampled lines and sprites, as edges [GL1.5 §3.3.3, §3.4.4].
#pragma once

#include "pipeline/raster/planes.h"
#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {

/// Edges of the rectangle that reaches `width` across from `from` to `to`, half of it to either side. The ends are apart.
///
/// Nothing is snapped: slopes have 23 bits behind the point, and the edges are right in the middle of the sides, so the
/// far ends of one of 16384 pixels are off by less than 1/1024 pixel and those of a usual one by nothing that counts. Left
/// and bottom edges own the samples on them.
/// Width: |a|, |b| <= 2^23 and a^2 + b^2 <= 2^46 (and a bit): inside a tile |value| < 64 * 1.42 * 2^23 < 2^30, and c < 2^50.
RectangleEdges edges_of_rectangle(Point2 from, Point2 to, double width);

}  // namespace gouraud::pipeline
