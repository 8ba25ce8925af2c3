// Circles of single pixels, as raster displays drew them before there were triangles.
#pragma once

#include <vector>

namespace shell {

struct Pixel {
  int x = 0, y = 0;
  bool operator==(const Pixel&) const = default;
};

// The pixels of a circle about (0, 0), each once. The second octant, from the top to the diagonal, is walked by additions
// alone: a decision value says whether the midpoint between the two next pixels lies inside the circle (Pitteway 1967;
// Bresenham 1977). The other seven octants mirror it. A radius of 0 gives one pixel, a negative one none.
std::vector<Pixel> midpoint_circle(int radius);

// Draws the circle about a pixel as points of size 1, in the current colour; object coordinates must be window
// coordinates.
void draw_circle(int x, int y, int radius);

}  // namespace shell
