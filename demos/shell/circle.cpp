#include "demos/shell/circle.h"

#include <GL/gl.h>

namespace shell {
namespace {

// The mirror images of a pixel of the second octant: four where it lies on an axis or on the diagonal, else eight.
void add_mirrored(std::vector<Pixel>& pixels, int x, int y) {
  const auto add = [&](int a, int b) {
    pixels.push_back({a, b});
    if (a != 0) pixels.push_back({-a, b});
    if (b != 0) pixels.push_back({a, -b});
    if (a != 0 && b != 0) pixels.push_back({-a, -b});
  };
  add(x, y);
  if (x != y) add(y, x);
}

}  // namespace

std::vector<Pixel> midpoint_circle(int radius) {
  std::vector<Pixel> pixels;
  if (radius < 0) return pixels;
  // x^2 + y^2 - radius^2 at the midpoint (x + 1, y - 1/2), less 1/4, which no integer comparison misses.
  int decision = 1 - radius;
  for (int x = 0, y = radius; x <= y; ++x) {
    add_mirrored(pixels, x, y);
    if (decision < 0) {
      decision += 2 * x + 3;  // the midpoint is inside: keep y
    } else {
      decision += 2 * (x - y) + 5;
      --y;
    }
  }
  return pixels;
}

void draw_circle(int x, int y, int radius) {
  glBegin(GL_POINTS);
  for (const Pixel pixel : midpoint_circle(radius)) {
    glVertex2f(static_cast<GLfloat>(x + pixel.x) + 0.5f, static_cast<GLfloat>(y + pixel.y) + 0.5f);
  }
  glEnd();
}

}  // namespace shell
