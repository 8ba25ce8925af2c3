// Shadow mapping with the fixed function: the light draws its depths into a texture through a framebuffer object, then
// every fragment's distance from the light is compared with them. Lit where the light sees it, ambient elsewhere.
// Left and right move the light, s switches the shadows.
#include <GL/gl.h>

#include <cmath>

#include "demos/shell/shadow_map.h"
#include "demos/shell/shell.h"
#include "demos/shell/solids.h"

namespace {

float light_deg = 35, clock_s = 0;
bool shadows = true;
const shell::ShadowMap* shadow_map = nullptr;

shell::Vec3 light_position() {
  const float angle = light_deg * 0.017453293f;
  return {6 * std::sin(angle), 7, 6 * std::cos(angle)};
}

void light_projection() {
  shell::perspective(50, 1, 3, 20);
}

void light_view() {
  shell::look_at(light_position(), {0, 0.5f, 0}, {0, 1, 0});
}

void bodies() {
  glPushMatrix();
  glTranslatef(0, 1.7f, 0);
  glRotatef(45 * clock_s, 0.5f, 1, 0);
  glColor3f(0.9f, 0.6f, 0.15f);
  shell::solid_torus(0.35f, 1.1f, 32, 64);
  glPopMatrix();
  for (int i = 0; i < 4; ++i) {
    glPushMatrix();
    glRotatef(90 * static_cast<float>(i) + 15 * clock_s, 0, 1, 0);
    glTranslatef(2.4f, 0.6f, 0);
    glColor3f(0.3f + 0.2f * static_cast<float>(i), 0.5f, 0.9f - 0.2f * static_cast<float>(i));
    i % 2 == 0 ? shell::solid_box(0.8f, 1.2f, 0.8f) : shell::solid_sphere(0.6f, 32, 16);
    glPopMatrix();
  }
}

void scene() {
  glColor3f(0.75f, 0.75f, 0.7f);
  shell::ground(6, 24, 1);
  bodies();
}

void init() {
  static const shell::ShadowMap map(1024);
  shadow_map = &map;
  const GLfloat dim[] = {0.3f, 0.3f, 0.35f, 1}, none[] = {0, 0, 0, 1};
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, dim);
  glLightfv(GL_LIGHT0, GL_AMBIENT, none);
  glEnable(GL_LIGHTING);
  glEnable(GL_COLOR_MATERIAL);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glEnable(GL_NORMALIZE);
  glDepthFunc(GL_LEQUAL);
  glClearColor(0.35f, 0.4f, 0.5f, 1);
}

void reshape(int width_px, int height_px) {
  shell::set_camera(width_px, height_px, 40, 1, 50);
}

void animate(double seconds) {
  clock_s = static_cast<float>(seconds);
}

void key(int key) {
  if (key == 's') shadows = !shadows;
  if (key == shell::key_left) light_deg -= 5;
  if (key == shell::key_right) light_deg += 5;
}

// First all in ambient light, then the light added where it reaches.
void draw() {
  if (shadows) shadow_map->render(light_projection, light_view, bodies);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glLoadIdentity();
  shell::look_at({-2, 5, 10}, {0, 0.8f, 0}, {0, 1, 0});
  glDisable(GL_LIGHT0);
  scene();

  const auto [x, y, z] = light_position();
  const GLfloat position[] = {x, y, z, 1}, black[] = {0, 0, 0, 1}, dim[] = {0.3f, 0.3f, 0.35f, 1};
  glLightfv(GL_LIGHT0, GL_POSITION, position);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
  glEnable(GL_LIGHT0);
  if (shadows) shadow_map->enable(light_projection, light_view);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  scene();
  glDisable(GL_BLEND);
  if (shadows) shadow_map->disable();
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, dim);
}

}  // namespace

int main(int argc, char** argv) {
  return shell::run(argc, argv,
                    {.name = "shadow",
                     .keys_help = "left and right move the light, s switches the shadows",
                     .width_px = 640,
                     .height_px = 480,
                     .init = init,
                     .reshape = reshape,
                     .animate = animate,
                     .key = key,
                     .draw = draw});
}
