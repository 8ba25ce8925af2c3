// The Utah teapot: Martin Newell's Bezier patches of 1975 in Jim Blinn's flattened proportions, evaluated here.
// The arrow keys turn it; + and - change the fineness, w shows the mesh, f switches between flat and smooth shading.
#include <GL/gl.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "demos/shell/shell.h"
#include "demos/teapot/newell.h"

namespace {

float turn_x_deg = 18.0f, turn_y_deg = -28.0f, spin_deg = 0.0f;
int grid = 12;
bool wire = false, flat = false;

Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vec3 operator*(float s, const Vec3& v) {
  return {s * v.x, s * v.y, s * v.z};
}
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
float length(const Vec3& v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

// The cubic Bernstein polynomials at t, and their derivatives.
struct Weights {
  float value[4], slope[4];
};

Weights bernstein(float t) {
  const float s = 1 - t;
  return {{s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t},
          {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t}};
}

Vec3 blend(const Patch& patch, const float across[4], const float along[4]) {
  Vec3 sum = {0, 0, 0};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) sum = sum + across[i] * along[j] * patch.point[i][j];
  }
  return sum;
}

// One vertex with the surface's true normal, the cross product of its two tangents. At the tip of the lid and in the
// middle of the bottom a whole edge of the patch is one point and a tangent vanishes; there the normal is the axis.
void vertex(const Patch& patch, float u, float v) {
  const Weights wu = bernstein(u), wv = bernstein(v);
  const Vec3 position = blend(patch, wu.value, wv.value);
  Vec3 normal = cross(blend(patch, wu.slope, wv.value), blend(patch, wu.value, wv.slope));
  if (length(normal) < 1e-5f) normal = {0, 0, position.z > 1 ? 1.0f : -1.0f};
  glNormal3f(normal.x, normal.y, normal.z);
  glVertex3f(position.x, position.y, position.z);
}

void draw_patch(const Patch& patch) {
  const float step = 1.0f / static_cast<float>(grid);
  for (int i = 0; i < grid; ++i) {
    glBegin(GL_QUAD_STRIP);
    for (int j = 0; j <= grid; ++j) {
      vertex(patch, static_cast<float>(i) * step, static_cast<float>(j) * step);
      vertex(patch, static_cast<float>(i + 1) * step, static_cast<float>(j) * step);
    }
    glEnd();
  }
}

void draw_teapot() {
  static const std::vector<Patch> patches = newell_teapot();
  for (const Patch& patch : patches) draw_patch(patch);
}

constexpr GLfloat sun[] = {3, 7, 4, 0};  // y up, towards the light

// A round table that fades into the background, and on it the teapot's shadow, laid flat by a projection along the
// sun's rays. Both lie in one plane, so they are painted one over the other without a depth test.
void draw_table_and_shadow() {
  constexpr float pi = std::numbers::pi_v<float>, radius = 14;
  constexpr int sides = 96;
  glDisable(GL_LIGHTING);
  glDisable(GL_DEPTH_TEST);
  glBegin(GL_TRIANGLE_FAN);
  glColor3f(0.62f, 0.64f, 0.68f);
  glVertex3f(0, 0, 0);
  glColor3f(0.16f, 0.18f, 0.22f);
  for (int i = 0; i <= sides; ++i) {
    const float angle = 2 * pi * static_cast<float>(i % sides) / sides;
    glVertex3f(radius * std::sin(angle), 0, radius * std::cos(angle));
  }
  glEnd();

  const GLfloat onto_table[16] = {1, 0, 0, 0, -sun[0] / sun[1], 0, -sun[2] / sun[1], 0, 0, 0, 1, 0, 0, 0, 0, 1};
  glColor3f(0.24f, 0.25f, 0.29f);
  glPushMatrix();
  glMultMatrixf(onto_table);
  glRotatef(spin_deg, 0, 1, 0);
  glRotatef(-90, 1, 0, 0);
  draw_teapot();
  glPopMatrix();
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_LIGHTING);
}

void init() {
  const GLfloat fill_color[] = {0.20f, 0.25f, 0.35f, 1}, ambient[] = {0.18f, 0.18f, 0.20f, 1};
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  glLightfv(GL_LIGHT1, GL_DIFFUSE, fill_color);
  glLightfv(GL_LIGHT1, GL_SPECULAR, fill_color);

  const GLfloat copper[] = {0.78f, 0.38f, 0.20f, 1}, shine[] = {0.75f, 0.62f, 0.50f, 1};
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, copper);
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 48);

  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_LIGHT1);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_NORMALIZE);
  glClearColor(0.16f, 0.18f, 0.22f, 1);
}

void reshape(int width_px, int height_px) {
  const GLdouble aspect = static_cast<GLdouble>(width_px) / height_px;
  glViewport(0, 0, width_px, height_px);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-0.25 * aspect, 0.25 * aspect, -0.25, 0.25, 1, 60);
  glMatrixMode(GL_MODELVIEW);
}

void animate(double seconds) {
  spin_deg = static_cast<float>(std::fmod(24.0 * seconds, 360.0));
}

void key(int key) {
  switch (key) {
    case shell::key_left: turn_y_deg -= 5; break;
    case shell::key_right: turn_y_deg += 5; break;
    case shell::key_up: turn_x_deg = std::min(turn_x_deg + 5, 90.0f); break;
    case shell::key_down: turn_x_deg = std::max(turn_x_deg - 5, 3.0f); break;
    case '+': grid = std::min(grid + 1, 40); break;
    case '-': grid = std::max(grid - 1, 1); break;
    case 'w': wire = !wire; break;
    case 'f': flat = !flat; break;
    default: break;
  }
}

void draw() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glLoadIdentity();
  glTranslatef(0, -1.3f, -13);
  glRotatef(turn_x_deg, 1, 0, 0);
  glRotatef(turn_y_deg, 0, 1, 0);
  draw_table_and_shadow();

  const GLfloat fill[] = {-6, 3, 2, 0};
  glLightfv(GL_LIGHT0, GL_POSITION, sun);
  glLightfv(GL_LIGHT1, GL_POSITION, fill);
  glShadeModel(flat ? GL_FLAT : GL_SMOOTH);
  glPolygonMode(GL_FRONT_AND_BACK, wire ? GL_LINE : GL_FILL);
  glRotatef(spin_deg, 0, 1, 0);
  glRotatef(-90, 1, 0, 0);
  draw_teapot();
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glShadeModel(GL_SMOOTH);
}

}  // namespace

int main(int argc, char** argv) {
  return shell::run(argc, argv,
                    {.name = "teapot",
                     .keys_help = "the arrow keys turn the teapot, + and - change its fineness, w shows the mesh, "
                                  "f switches between flat and smooth shading",
                     .width_px = 800,
                     .height_px = 600,
                     .init = init,
                     .reshape = reshape,
                     .animate = animate,
                     .key = key,
                     .draw = draw});
}
