// Fog in an avenue of columns: what is far away fades into the colour of the air.
// f goes from linear to exponential to squared exponential fog to none; up and down make it thinner and thicker.
#include <GL/gl.h>

#include <algorithm>
#include <cmath>

#include "demos/shell/shell.h"
#include "demos/shell/solids.h"

namespace {

constexpr GLenum modes[] = {GL_LINEAR, GL_EXP, GL_EXP2};
int mode = 1;  // 3: no fog
float density = 0.06f;
float way = 0.0f;
constexpr float column_distance = 4.0f;
constexpr int columns = 16;
constexpr GLfloat air[] = {0.62f, 0.68f, 0.74f, 1};

void init() {
  const GLfloat sun[] = {0.6f, 1, 0.5f, 0}, glow[] = {0.35f, 0.35f, 0.4f, 1};
  glLightfv(GL_LIGHT0, GL_POSITION, sun);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, glow);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_COLOR_MATERIAL);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glFogfv(GL_FOG_COLOR, air);
  glHint(GL_FOG_HINT, GL_NICEST);
  glClearColor(air[0], air[1], air[2], 1);
}

void reshape(int width_px, int height_px) {
  shell::set_camera(width_px, height_px, 55, 0.5, 100);
}

void animate(double seconds) {
  way = static_cast<float>(std::fmod(1.5 * seconds, column_distance));
}

void key(int key) {
  if (key == 'f') mode = (mode + 1) % 4;
  if (key == shell::key_up) density = std::max(density * 0.8f, 0.005f);
  if (key == shell::key_down) density = std::min(density * 1.25f, 1.0f);
}

void set_fog() {
  if (mode == 3) return glDisable(GL_FOG);
  glEnable(GL_FOG);
  glFogi(GL_FOG_MODE, static_cast<GLint>(modes[mode]));
  glFogf(GL_FOG_DENSITY, density);
  glFogf(GL_FOG_START, 2);
  glFogf(GL_FOG_END, 2 + 2.5f / density);
}

void column(float x, float z) {
  glPushMatrix();
  glTranslatef(x, 0, z);
  glColor3f(0.75f, 0.7f, 0.6f);
  glPushMatrix();
  glTranslatef(0, 0.15f, 0);
  shell::solid_box(1.2f, 0.3f, 1.2f);
  glTranslatef(0, 1.75f, 0);
  shell::solid_box(0.7f, 3.2f, 0.7f);
  glTranslatef(0, 1.75f, 0);
  shell::solid_box(1.2f, 0.3f, 1.2f);
  glPopMatrix();
  glColor3f(0.75f, 0.3f, 0.2f);
  glTranslatef(0, 4.3f, 0);
  shell::solid_sphere(0.5f, 32, 16);
  glPopMatrix();
}

void draw() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  set_fog();
  glLoadIdentity();
  shell::look_at({0.4f, 2, 0}, {0, 2, -10}, {0, 1, 0});
  glPushMatrix();
  glTranslatef(0, 0, way - 30);
  glColor3f(0.45f, 0.5f, 0.4f);
  shell::ground(40, 40, 1);
  glPopMatrix();
  for (int i = 0; i < columns; ++i) {
    const float z = way - column_distance * static_cast<float>(i);
    column(-3, z);
    column(3, z);
  }
}

}  // namespace

int main(int argc, char** argv) {
  return shell::run(argc, argv,
                    {.name = "fog",
                     .keys_help = "f goes through the fog modes, up and down make it thinner and thicker",
                     .width_px = 800,
                     .height_px = 500,
                     .init = init,
                     .reshape = reshape,
                     .animate = animate,
                     .key = key,
                     .draw = draw});
}
