#include "demos/shell/solids.h"

#include <GL/gl.h>

#include <cmath>
#include <numbers>

namespace shell {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

Vec3 minus(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Vec3 unit(const Vec3& v) {
  const float length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return {v.x / length, v.y / length, v.z / length};
}

// Part `i` of `n`; both ends of a closed circle fall together exactly.
float turn(int i, int n) {
  return 2 * pi * static_cast<float>(i % n) / static_cast<float>(n);
}

float share(int i, int n) {
  return static_cast<float>(i) / static_cast<float>(n);
}

}  // namespace

void perspective(double field_of_view_deg, double aspect, double near_z, double far_z) {
  const double top = near_z * std::tan(field_of_view_deg * std::numbers::pi / 360);
  glFrustum(-top * aspect, top * aspect, -top, top, near_z, far_z);
}

void look_at(const Vec3& eye, const Vec3& target, const Vec3& up) {
  const Vec3 forward = unit(minus(target, eye));
  const Vec3 side = unit(cross(forward, up));
  const Vec3 above = cross(side, forward);
  const GLfloat matrix[16] = {side.x, above.x, -forward.x, 0, side.y, above.y, -forward.y, 0,
                              side.z, above.z, -forward.z, 0, 0,      0,       0,          1};
  glMultMatrixf(matrix);
  glTranslatef(-eye.x, -eye.y, -eye.z);
}

void set_camera(int width_px, int height_px, double field_of_view_deg, double near_z, double far_z) {
  glViewport(0, 0, width_px, height_px);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  perspective(field_of_view_deg, static_cast<double>(width_px) / height_px, near_z, far_z);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
}

void solid_sphere(float radius, int slices, int stacks) {
  const auto vertex = [&](int slice, int stack) {
    const float latitude = pi * (share(stack, stacks) - 0.5f), longitude = turn(slice, slices);
    const float x = std::cos(latitude) * std::sin(longitude), z = std::cos(latitude) * std::cos(longitude);
    const float y = std::sin(latitude);
    glNormal3f(x, y, z);
    glTexCoord2f(share(slice, slices), share(stack, stacks));
    glVertex3f(radius * x, radius * y, radius * z);
  };
  for (int stack = 0; stack < stacks; ++stack) {
    glBegin(GL_QUAD_STRIP);
    for (int slice = 0; slice <= slices; ++slice) {
      vertex(slice, stack + 1);
      vertex(slice, stack);
    }
    glEnd();
  }
}

void solid_torus(float tube_radius, float ring_radius, int sides, int rings) {
  const auto vertex = [&](int side, int ring) {
    const float around_tube = turn(side, sides), around_ring = turn(ring, rings);
    const float outwards = std::cos(around_tube);
    glNormal3f(outwards * std::cos(around_ring), outwards * std::sin(around_ring), std::sin(around_tube));
    glTexCoord2f(share(ring, rings), share(side, sides));
    const float distance = ring_radius + tube_radius * outwards;
    glVertex3f(distance * std::cos(around_ring), distance * std::sin(around_ring), tube_radius * std::sin(around_tube));
  };
  for (int ring = 0; ring < rings; ++ring) {
    glBegin(GL_QUAD_STRIP);
    for (int side = 0; side <= sides; ++side) {
      vertex(side, ring);
      vertex(side, ring + 1);
    }
    glEnd();
  }
}

void solid_box(float width, float height, float depth) {
  // A face is given by its normal and the direction in which s grows; t grows along their cross product.
  constexpr Vec3 faces[6][2] = {{{1, 0, 0}, {0, 0, -1}}, {{-1, 0, 0}, {0, 0, 1}}, {{0, 1, 0}, {1, 0, 0}},
                                {{0, -1, 0}, {1, 0, 0}}, {{0, 0, 1}, {1, 0, 0}},  {{0, 0, -1}, {-1, 0, 0}}};
  constexpr float corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  glBegin(GL_QUADS);
  for (const auto& [normal, right] : faces) {
    const Vec3 above = cross(normal, right);
    glNormal3f(normal.x, normal.y, normal.z);
    for (const auto& [s, t] : corners) {
      const float a = s - 0.5f, b = t - 0.5f;
      glTexCoord2f(s, t);
      glVertex3f(width * (0.5f * normal.x + a * right.x + b * above.x),
                 height * (0.5f * normal.y + a * right.y + b * above.y),
                 depth * (0.5f * normal.z + a * right.z + b * above.z));
    }
  }
  glEnd();
}

void ground(float half, int cells, float repeats) {
  glNormal3f(0, 1, 0);
  const auto vertex = [&](int column, int row) {
    const float x = share(column, cells), z = share(row, cells);
    glTexCoord2f(repeats * x, repeats * (1 - z));
    glVertex3f(half * (2 * x - 1), 0, half * (2 * z - 1));
  };
  for (int row = 0; row < cells; ++row) {
    glBegin(GL_QUAD_STRIP);
    for (int column = 0; column <= cells; ++column) {
      vertex(column, row);
      vertex(column, row + 1);
    }
    glEnd();
  }
}

}  // namespace shell
