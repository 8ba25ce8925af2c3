// A mirror by stencil: the floor marks its pixels, the scene is drawn upside down where they are marked, and the floor
// is blended over it. A clip plane keeps what lies below the floor out of the reflection.
// p switches the clip plane, left and right go round.
#include <GL/gl.h>

#include <cmath>

#include "demos/shell/shell.h"
#include "demos/shell/solids.h"

namespace {

float view_deg = 25.0f, clock_s = 0.0f;
bool clips = true;
constexpr float mirror_half = 3.0f;

void init() {
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_COLOR_MATERIAL);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_NORMALIZE);
  const GLfloat shine[] = {0.7f, 0.7f, 0.7f, 1};
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 40);
  glClearColor(0.55f, 0.65f, 0.75f, 1);
  glClearStencil(0);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

void reshape(int width_px, int height_px) {
  shell::set_camera(width_px, height_px, 40, 1, 50);
}

void animate(double seconds) {
  clock_s = static_cast<float>(seconds);
}

void key(int key) {
  if (key == 'p') clips = !clips;
  if (key == shell::key_left) view_deg -= 5;
  if (key == shell::key_right) view_deg += 5;
}

void bodies() {
  const GLfloat lamp[] = {2, 6, 3, 1};
  glLightfv(GL_LIGHT0, GL_POSITION, lamp);
  glPushMatrix();
  glTranslatef(0, 1.35f + 0.6f * std::sin(1.1f * clock_s), 0);
  glRotatef(50 * clock_s, 0.4f, 1, 0);
  glColor3f(0.9f, 0.55f, 0.1f);
  shell::solid_torus(0.35f, 1, 32, 64);
  glPopMatrix();
  for (int i = 0; i < 3; ++i) {
    glPushMatrix();
    glRotatef(120 * static_cast<float>(i) - 20 * clock_s, 0, 1, 0);
    glTranslatef(2.1f, 0.45f, 0);
    glColor3f(0.2f + 0.3f * static_cast<float>(i), 0.3f, 0.8f - 0.3f * static_cast<float>(i));
    shell::solid_sphere(0.45f, 32, 16);
    glPopMatrix();
  }
}

// Ones in the stencil buffer where the mirror can be seen.
void mark_mirror() {
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, 1, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  shell::ground(mirror_half, 1, 1);
  glEnable(GL_DEPTH_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void reflection() {
  const GLdouble above_the_floor[] = {0, 1, 0, 0};
  glStencilFunc(GL_EQUAL, 1, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glPushMatrix();
  glScalef(1, -1, 1);
  glClipPlane(GL_CLIP_PLANE0, above_the_floor);
  if (clips) glEnable(GL_CLIP_PLANE0);
  bodies();
  glDisable(GL_CLIP_PLANE0);
  glPopMatrix();
}

void glass() {
  glEnable(GL_BLEND);
  glColor4f(0.25f, 0.35f, 0.4f, 0.45f);
  shell::ground(mirror_half, 12, 1);
  glDisable(GL_BLEND);
  glDisable(GL_STENCIL_TEST);
}

void draw() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glLoadIdentity();
  shell::look_at({0, 4, 9}, {0, 0.6f, 0}, {0, 1, 0});
  glRotatef(view_deg, 0, 1, 0);
  mark_mirror();
  reflection();
  glass();
  bodies();
}

}  // namespace

int main(int argc, char** argv) {
  return shell::run(argc, argv,
                    {.name = "stencil_mirror",
                     .keys_help = "p switches the clip plane, left and right go round the mirror",
                     .width_px = 640,
                     .height_px = 480,
                     .init = init,
                     .reshape = reshape,
                     .animate = animate,
                     .key = key,
                     .draw = draw});
}
