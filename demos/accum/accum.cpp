// The accumulation buffer: many pictures become one. Depth of field from eyes spread over a lens, motion blur from
// moments spread over the shutter's time, antialiasing from samples spread over a pixel.
// m goes from one to the next to none; left and right move the plane in focus, up and down change the number of passes.
#include <GL/gl.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "demos/shell/shell.h"
#include "demos/shell/solids.h"

namespace {

enum Effect { depth_of_field, motion_blur, antialiasing, none, effect_count };
int effect = depth_of_field;
int passes = 16;
float focus = 9.0f;  // distance of the plane in focus from the eye
float clock_s = 0.0f;
int width_px = 1, height_px = 1;

constexpr float near_z = 2, far_z = 40, half_height = 0.7f;
constexpr float lens_radius = 0.25f, shutter_s = 0.12f;

struct Sample {
  float x, y;  // in the unit disc, or in [0, 1] x [0, 1]
};

// The R2 sequence: even over the unit square for any number of samples.
Sample in_square(int i) {
  const float n = static_cast<float>(i) + 0.5f;
  return {std::fmod(0.7548777f * n, 1.0f), std::fmod(0.5698403f * n, 1.0f)};
}

Sample in_disc(int i) {
  const auto [u, v] = in_square(i);
  const float radius = std::sqrt(u), angle = 2 * std::numbers::pi_v<float> * v;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// A frustum whose eye stands at (eye.x, eye.y) while the plane in focus stays where it is, and whose picture is moved by
// `pixel` pixels.
void set_projection(Sample eye, Sample pixel) {
  const float half_width = half_height * static_cast<float>(width_px) / static_cast<float>(height_px);
  const float dx = -eye.x * near_z / focus - pixel.x * 2 * half_width / static_cast<float>(width_px);
  const float dy = -eye.y * near_z / focus - pixel.y * 2 * half_height / static_cast<float>(height_px);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(static_cast<double>(dx - half_width), static_cast<double>(dx + half_width), static_cast<double>(dy - half_height),
            static_cast<double>(dy + half_height), static_cast<double>(near_z), static_cast<double>(far_z));
  glTranslatef(-eye.x, -eye.y, 0);
  glMatrixMode(GL_MODELVIEW);
}

void scene(float time_s) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glLoadIdentity();
  glTranslatef(0, -0.8f, 0);
  for (int i = 0; i < 5; ++i) {
    const float n = static_cast<float>(i);
    glPushMatrix();
    glTranslatef(-2.4f + 1.25f * n, 0.9f, -5 - 3.0f * n);
    glRotatef(90 * time_s * (1 + n), 0.3f, 1, 0.2f);
    glColor3f(0.9f - 0.15f * n, 0.35f + 0.1f * n, 0.15f + 0.18f * n);
    shell::solid_torus(0.3f, 0.8f, 24, 48);
    glPopMatrix();
  }
  glColor3f(0.55f, 0.55f, 0.6f);
  glTranslatef(0, -0.4f, -16);
  shell::ground(14, 28, 1);
}

void init() {
  const GLfloat lamp[] = {2, 5, 1, 1};
  glLightfv(GL_LIGHT0, GL_POSITION, lamp);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_COLOR_MATERIAL);
  glEnable(GL_DEPTH_TEST);
  glClearColor(0.12f, 0.14f, 0.2f, 1);
}

void reshape(int new_width_px, int new_height_px) {
  width_px = new_width_px;
  height_px = new_height_px;
  glViewport(0, 0, width_px, height_px);
}

void animate(double seconds) {
  clock_s = static_cast<float>(seconds);
}

void key(int key) {
  switch (key) {
    case 'm': effect = (effect + 1) % effect_count; break;
    case shell::key_left: focus = std::max(focus - 1, 3.0f); break;
    case shell::key_right: focus = std::min(focus + 1, 20.0f); break;
    case shell::key_up: passes = std::min(passes * 2, 64); break;
    case shell::key_down: passes = std::max(passes / 2, 1); break;
    default: break;
  }
}

void draw() {
  if (effect == none) {
    set_projection({0, 0}, {0, 0});
    return scene(clock_s);
  }
  const float share = 1.0f / static_cast<float>(passes);
  for (int i = 0; i < passes; ++i) {
    const Sample disc = in_disc(i), square = in_square(i);
    const Sample eye = effect == depth_of_field ? Sample{lens_radius * disc.x, lens_radius * disc.y} : Sample{0, 0};
    const Sample pixel = effect == antialiasing ? Sample{square.x - 0.5f, square.y - 0.5f} : Sample{0, 0};
    set_projection(eye, pixel);
    scene(effect == motion_blur ? clock_s + shutter_s * static_cast<float>(i) * share : clock_s);
    glAccum(i == 0 ? GL_LOAD : GL_ACCUM, share);
  }
  glAccum(GL_RETURN, 1);
}

}  // namespace

int main(int argc, char** argv) {
  return shell::run(argc, argv,
                    {.name = "accum",
                     .keys_help = "m goes through depth of field, motion blur, antialiasing and none, left and right move "
                                  "the focus, up and down change the number of passes",
                     .width_px = 720,
                     .height_px = 480,
                     .init = init,
                     .reshape = reshape,
                     .animate = animate,
                     .key = key,
                     .draw = draw});
}
