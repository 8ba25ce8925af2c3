// A spot light sweeps over a checkered floor, and a small blue lamp circles above it and fades with distance.
// Light is computed at vertices only, so the floor is cut finely: g shows what becomes of the cone on a coarse one.
// Left and right narrow and widen the cone, up and down sharpen and soften it.
#include <GL/gl.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "demos/shell/shell.h"

namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float floor_half = 6.0f;
constexpr int tiles = 12;

float cutoff_deg = 26.0f, exponent = 16.0f;
int cuts_per_tile = 16;
float clock_s = 0.0f;

struct Vec3 {
  float x, y, z;
};

constexpr Vec3 spot_position = {0, 4.6f, 0};

Vec3 spot_target() {
  return {2.6f * std::sin(0.7f * clock_s), 0, 0.2f + 1.7f * std::cos(0.9f * clock_s)};
}

Vec3 lamp_position() {
  return {3.9f * std::cos(0.5f * clock_s + 3.3f), 0.9f, 3.9f * std::sin(0.5f * clock_s + 3.3f)};
}

void sphere(int slices, int stacks) {
  for (int i = 0; i < stacks; ++i) {
    glBegin(GL_QUAD_STRIP);
    for (int j = 0; j <= slices; ++j) {
      const float longitude = 2 * pi * static_cast<float>(j % slices) / static_cast<float>(slices);
      for (int k = i + 1; k >= i; --k) {
        const float latitude = pi * (static_cast<float>(k) / static_cast<float>(stacks) - 0.5f);
        const float x = std::cos(latitude) * std::sin(longitude), z = std::cos(latitude) * std::cos(longitude);
        glNormal3f(x, std::sin(latitude), z);
        glVertex3f(x, std::sin(latitude), z);
      }
    }
    glEnd();
  }
}

// One tile of the floor with its corner at (x, z), as strips of small quads.
void floor_tile(float x, float z, float size, int cuts) {
  const float step = size / static_cast<float>(cuts);
  for (int i = 0; i < cuts; ++i) {
    const float z_far = z + step * static_cast<float>(i), z_near = z + step * static_cast<float>(i + 1);
    glBegin(GL_QUAD_STRIP);
    for (int j = 0; j <= cuts; ++j) {
      const float x_here = x + step * static_cast<float>(j);
      glVertex3f(x_here, 0, z_far);
      glVertex3f(x_here, 0, z_near);
    }
    glEnd();
  }
}

void checkered_floor() {
  constexpr float size = 2 * floor_half / tiles;
  const GLfloat shine[] = {0.15f, 0.15f, 0.15f, 1};
  glMaterialfv(GL_FRONT, GL_SPECULAR, shine);
  glMaterialf(GL_FRONT, GL_SHININESS, 20);
  glNormal3f(0, 1, 0);
  for (int row = 0; row < tiles; ++row) {
    for (int column = 0; column < tiles; ++column) {
      (row + column) % 2 == 0 ? glColor3f(0.85f, 0.82f, 0.75f) : glColor3f(0.36f, 0.26f, 0.22f);
      floor_tile(-floor_half + size * static_cast<float>(column), -floor_half + size * static_cast<float>(row), size,
                 cuts_per_tile);
    }
  }
}

void balls() {
  const GLfloat shine[] = {0.8f, 0.8f, 0.8f, 1};
  glMaterialfv(GL_FRONT, GL_SPECULAR, shine);
  glMaterialf(GL_FRONT, GL_SHININESS, 60);
  for (int i = 0; i < 6; ++i) {
    const float angle = 2 * pi * static_cast<float>(i) / 6;
    glColor3f(0.55f + 0.35f * std::cos(angle), 0.55f + 0.35f * std::cos(angle + 2.1f),
              0.55f + 0.35f * std::cos(angle - 2.1f));
    glPushMatrix();
    glTranslatef(2.5f * std::cos(angle), 0.6f, 2.5f * std::sin(angle));
    glScalef(0.6f, 0.6f, 0.6f);
    sphere(40, 20);
    glPopMatrix();
  }
}

// The lamps themselves: unlit, in the colour of their light.
void glowing_ball(const Vec3& at, float radius, const GLfloat color[3]) {
  glDisable(GL_LIGHTING);
  glColor3fv(color);
  glPushMatrix();
  glTranslatef(at.x, at.y, at.z);
  glScalef(radius, radius, radius);
  sphere(20, 10);
  glPopMatrix();
  glEnable(GL_LIGHTING);
}

void place_lights() {
  const Vec3 target = spot_target(), lamp = lamp_position();
  const GLfloat position[] = {spot_position.x, spot_position.y, spot_position.z, 1};
  const GLfloat direction[] = {target.x - position[0], target.y - position[1], target.z - position[2]};
  glLightfv(GL_LIGHT0, GL_POSITION, position);
  glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, direction);
  glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, cutoff_deg);
  glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, exponent);

  const GLfloat lamp_at[] = {lamp.x, lamp.y, lamp.z, 1};
  glLightfv(GL_LIGHT1, GL_POSITION, lamp_at);
}

constexpr GLfloat warm[] = {1.6f, 1.45f, 1.15f, 1}, blue[] = {0.5f, 0.85f, 1.5f, 1};

void init() {
  const GLfloat night[] = {0.10f, 0.11f, 0.16f, 1};
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, night);
  glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
  glLightfv(GL_LIGHT0, GL_DIFFUSE, warm);
  glLightfv(GL_LIGHT0, GL_SPECULAR, warm);
  glLightfv(GL_LIGHT1, GL_DIFFUSE, blue);
  glLightfv(GL_LIGHT1, GL_SPECULAR, blue);
  glLightf(GL_LIGHT1, GL_CONSTANT_ATTENUATION, 0.5f);
  glLightf(GL_LIGHT1, GL_LINEAR_ATTENUATION, 0.2f);
  glLightf(GL_LIGHT1, GL_QUADRATIC_ATTENUATION, 0.25f);
  glColorMaterial(GL_FRONT, GL_AMBIENT_AND_DIFFUSE);
  glEnable(GL_COLOR_MATERIAL);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_LIGHT1);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glEnable(GL_NORMALIZE);
  glClearColor(0.02f, 0.02f, 0.04f, 1);
}

void reshape(int width_px, int height_px) {
  const GLdouble aspect = static_cast<GLdouble>(width_px) / height_px;
  glViewport(0, 0, width_px, height_px);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-0.33 * aspect, 0.33 * aspect, -0.33, 0.33, 1, 40);
  glMatrixMode(GL_MODELVIEW);
}

void animate(double seconds) {
  clock_s = static_cast<float>(seconds);
}

void key(int key) {
  switch (key) {
    case shell::key_left: cutoff_deg = std::max(cutoff_deg - 2, 2.0f); break;
    case shell::key_right: cutoff_deg = std::min(cutoff_deg + 2, 60.0f); break;
    case shell::key_up: exponent = std::max(exponent - 4, 0.0f); break;
    case shell::key_down: exponent = std::min(exponent + 4, 128.0f); break;
    case 'g': cuts_per_tile = cuts_per_tile == 1 ? 16 : 1; break;
    default: break;
  }
}

void draw() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glLoadIdentity();
  glTranslatef(0, -0.9f, -15);
  glRotatef(36, 1, 0, 0);
  glRotatef(20, 0, 1, 0);
  place_lights();
  checkered_floor();
  balls();
  glowing_ball(spot_position, 0.15f, warm);
  glowing_ball(lamp_position(), 0.12f, blue);
}

}  // namespace

int main(int argc, char** argv) {
  return shell::run(argc, argv,
                    {.name = "spot",
                     .keys_help = "left and right narrow and widen the cone, up and down soften and sharpen it, "
                                  "g switches between a fine and a coarse floor",
                     .width_px = 800,
                     .height_px = 600,
                     .init = init,
                     .reshape = reshape,
                     .animate = animate,
                     .key = key,
                     .draw = draw});
}
