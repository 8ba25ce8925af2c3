// The control points of the Utah teapot.
#pragma once

#include <vector>

struct Vec3 {
  float x, y, z;
};

// A bicubic Bezier patch. The cross product of the tangents along the first and the second index points outwards.
struct Patch {
  Vec3 point[4][4];
};

// The 32 patches, z up, standing on z = 0 about the z axis, the spout towards +x: 6.5 long, 4 wide, 3.15 high.
std::vector<Patch> newell_teapot();
