#include "demos/methods/projections.h"

#include <GL/gl.h>

#include <cmath>

namespace {

constexpr double near_z = 0.3, far_z = 60, field_of_view_deg = 50;

// Half of the picture's height, seen from a distance of 1.
double half_height() { return std::tan(field_of_view_deg / 2 * 3.14159265358979 / 180); }

// The eye looks along -z; the sides of a frustum meet in it, and what is twice as far away is half as large.
void perspective(double aspect) {
  const double top = near_z * half_height();
  glFrustum(-top * aspect, top * aspect, -top, top, near_z, far_z);
}

// The sides of a box: parallels stay parallel, and nothing grows smaller with distance.
void orthographic(double aspect, double distance) {
  const double top = distance * half_height();
  glOrtho(-top * aspect, top * aspect, -top, top, near_z, far_z);
}

// The box pushed over: what faces the picture keeps its shape, and depth runs off to the upper right, at half of its
// length (a cabinet projection). The shear comes first, about the plane at `distance`, which it leaves where it is.
void oblique(double aspect, double distance) {
  orthographic(aspect, distance);
  constexpr double length = 0.5, angle = 0.7853981633974483;
  const double x = -length * std::cos(angle), y = -length * std::sin(angle);
  const GLdouble shear[16] = {1, 0, 0, 0, 0, 1, 0, 0, x, y, 1, 0, x * distance, y * distance, 0, 1};
  glMultMatrixd(shear);
}

// As Direct3D has it: the eye looks along +z (a left-handed space), w is z itself, and clip z runs from 0 to w. GL takes
// it if it is told where the near plane is: without ARB_clip_control near would be cut at -w, and half of the depth
// buffer's steps would lie idle. Written in rows, as that school writes it, which is what GL's columns are: there the
// vector stands on the left of the matrix.
//   w = 1 / tan(fov / 2) / aspect   h = 1 / tan(fov / 2)   q = far / (far - near)
void left_handed(double aspect) {
  const double h = 1 / half_height(), w = h / aspect, q = far_z / (far_z - near_z);
  const GLdouble rows[16] = {w, 0, 0, 0,  //
                             0, h, 0, 0,  //
                             0, 0, q, 1,  //
                             0, 0, -near_z * q, 0};
  glMultMatrixd(rows);
}

}  // namespace

const char* projection_name(int projection) {
  static const char* const names[] = {"perspective", "orthographic", "oblique", "perspective, left-handed"};
  return names[projection % projection_count];
}

void set_projection(int projection, int width_px, int height_px, double distance) {
  const double aspect = static_cast<double>(width_px) / height_px;
  const bool is_left_handed = projection % projection_count == 3;
  glViewport(0, 0, width_px, height_px);
  glClipControl(GL_LOWER_LEFT, is_left_handed ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  switch (projection % projection_count) {
    case 0: perspective(aspect); break;
    case 1: orthographic(aspect, distance); break;
    case 2: oblique(aspect, distance); break;
    default: left_handed(aspect); break;
  }
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  // Mirrored twice, in eye space and by the projection: the picture, and with it which way triangles turn, is the same.
  if (is_left_handed) glScalef(1, 1, -1);
}
