// Smooth points, lines and polygons: what share of each pixel they cover [GL1.5 §3.3.1, §3.4.2, §3.5.3].
#pragma once

#include <array>
#include <vector>

#include "conformance/oracle/rasterize.h"

namespace gouraud::oracle {

struct Place {
  double x = 0, y = 0;
};
using Outline = std::vector<Place>;

/// The part of a convex outline inside pixel (x, y).
Outline clipped_to_pixel(Outline outline, int x, int y);
/// Positive, whichever way it turns.
double area_of(const Outline& outline);
/// Of an outline with an area.
Place centroid_of(const Outline& outline);

/// What a disc covers of pixel (x, y): the integral of its chords, in closed form.
double disc_in_pixel(const Place& center, double radius, int x, int y);

/// Conforming coverages are exact, to within rounding, or as good as the strips that a disc is cut into.
inline constexpr double coverage_rounding = 1e-3 / 255, disc_slack = 0.4 / 255;

/// Less than this of a pixel makes no fragment.
inline constexpr double least_coverage = 1.0 / (1 << 20);

}  // namespace gouraud::oracle
