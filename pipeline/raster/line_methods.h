// Lines walked pixel by pixel: the methods "lines=naive", "dda" and "bresenham", for lines of one pixel without a stipple.
#pragma once

#include <vector>

#include "pipeline/draw/methods.h"
#include "pipeline/raster/line_coverage.h"
#include "pipeline/raster/planes.h"

namespace gouraud::pipeline {

/// Appends the pixels of the line between two window positions, y up, in order from `a` to `b`. Both are at most 2^16 from the
/// origin.
///
/// naive: y = m x + b for every column. Steep lines have one pixel a column and so fall to pieces, an upright one is a dot.
/// dda: as many steps as the longer side has pixels, each the sum of the last and the slope, in float. One multiplication
/// and no gap; rounding adds up along the line, and both ends are drawn, so that the joints of a strip are drawn twice.
/// (The digital differential analyzer: an instrument of the 1950s, in textbooks since W. Newman, R. Sproull, 1973.)
/// bresenham: integers alone, an error term decides whether to step aside; the ends are whole pixels, so that lines which
/// move by less than a pixel jump. (J. Bresenham, "Algorithm for computer control of a digital plotter", 1965.)
void walk_line(LineMethod method, Point2 a, Point2 b, std::vector<PixelPosition>& pixels);

}  // namespace gouraud::pipeline
