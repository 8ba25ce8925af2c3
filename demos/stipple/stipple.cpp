// Line stipple, line widths, polygon stipple, and their smooth forms, on one sheet of paper.
// s switches antialiasing, up and down change the stipple's factor.
#include <GL/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "demos/shell/shell.h"

namespace {

constexpr float sheet_width = 640, sheet_height = 480;
bool smooth = false;
int factor = 1;
float turn_deg = 0;

constexpr GLushort dotted = 0x0101, dashed = 0x00FF, dash_dot_dash = 0x1C47, all = 0xFFFF;

// 32 x 32 bits, a diagonal weave: row y has a bit where the strand of that row runs.
std::array<GLubyte, 128> weave() {
  std::array<GLubyte, 128> bits{};
  for (unsigned y = 0; y < 32; ++y) {
    for (unsigned x = 0; x < 32; ++x) {
      const bool rising = (x + 32 - y) % 16 < 4, falling = (x + y) % 16 < 4;
      const bool over = ((x / 8 + y / 8) & 1u) != 0;
      if (over ? rising : falling) bits[y * 4 + x / 8] |= static_cast<GLubyte>(0x80u >> x % 8);
    }
  }
  return bits;
}

std::array<GLubyte, 128> screen_door() {
  std::array<GLubyte, 128> bits{};
  for (unsigned y = 0; y < 32; ++y) {
    for (unsigned byte = 0; byte < 4; ++byte) bits[y * 4 + byte] = y % 2 == 0 ? 0xAA : 0x55;
  }
  return bits;
}

void init() {
  glClearColor(0.96f, 0.95f, 0.90f, 1);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

void reshape(int width_px, int height_px) {
  glViewport(0, 0, width_px, height_px);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glOrtho(0, sheet_width, 0, sheet_height, -1, 1);
  glMatrixMode(GL_MODELVIEW);
}

void animate(double seconds) {
  turn_deg = static_cast<float>(std::fmod(12 * seconds, 360));
}

void key(int key) {
  if (key == 's') smooth = !smooth;
  if (key == shell::key_up) factor = std::min(factor + 1, 16);
  if (key == shell::key_down) factor = std::max(factor - 1, 1);
}

void line(float x0, float y0, float x1, float y1) {
  glBegin(GL_LINES);
  glVertex2f(x0, y0);
  glVertex2f(x1, y1);
  glEnd();
}

// Each row another pattern, each column another width.
void stippled_lines() {
  glEnable(GL_LINE_STIPPLE);
  float y = 450;
  for (const GLushort pattern : {dotted, dashed, dash_dot_dash, all}) {
    glLineStipple(factor, pattern);
    for (int i = 0; i < 3; ++i) {
      glLineWidth(1 + 3 * static_cast<float>(i));
      const float x = 30 + 200 * static_cast<float>(i);
      line(x, y, x + 170, y);
    }
    y -= 25;
  }
  // One strip: the pattern runs on over its corners.
  glLineStipple(2, dash_dot_dash);
  glLineWidth(2);
  glBegin(GL_LINE_STRIP);
  for (int i = 0; i < 14; ++i) glVertex2f(30 + 44.6f * static_cast<float>(i), i % 2 == 0 ? 310.0f : 340.0f);
  glEnd();
  glDisable(GL_LINE_STIPPLE);
}

void star_of_lines(float x, float y, float radius) {
  glPushMatrix();
  glTranslatef(x, y, 0);
  glRotatef(turn_deg, 0, 0, 1);
  for (int i = 0; i < 16; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / 16;
    glLineWidth(1 + 0.25f * static_cast<float>(i));
    line(0.2f * radius * std::cos(angle), 0.2f * radius * std::sin(angle), radius * std::cos(angle), radius * std::sin(angle));
  }
  glPopMatrix();
}

void polygon(float x, float y, float radius, int corners) {
  glPushMatrix();
  glTranslatef(x, y, 0);
  glRotatef(-turn_deg, 0, 0, 1);
  glBegin(GL_POLYGON);
  for (int i = 0; i < corners; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(corners);
    glVertex2f(radius * std::cos(angle), radius * std::sin(angle));
  }
  glEnd();
  glPopMatrix();
}

void stippled_polygons() {
  glEnable(GL_POLYGON_STIPPLE);
  glColor3f(0.1f, 0.3f, 0.6f);
  glPolygonStipple(weave().data());
  polygon(270, 150, 100, 6);
  glColor3f(0.7f, 0.2f, 0.2f);
  glPolygonStipple(screen_door().data());
  glRectf(380, 50, 480, 250);
  glDisable(GL_POLYGON_STIPPLE);
}

// Points of growing size along an arc.
void points() {
  glColor3f(0.1f, 0.1f, 0.1f);
  for (int i = 0; i < 9; ++i) {
    glPointSize(1 + 2.5f * static_cast<float>(i));
    glBegin(GL_POINTS);
    glVertex2f(510 + 13 * static_cast<float>(i), 60 + 22 * static_cast<float>(i));
    glEnd();
  }
}

void draw() {
  glClear(GL_COLOR_BUFFER_BIT);
  glLoadIdentity();
  for (const GLenum capability : {GL_LINE_SMOOTH, GL_POINT_SMOOTH, GL_BLEND}) {
    smooth ? glEnable(capability) : glDisable(capability);
  }
  glColor3f(0.1f, 0.1f, 0.1f);
  stippled_lines();
  star_of_lines(100, 150, 90);
  points();
  stippled_polygons();
}

}  // namespace

int main(int argc, char** argv) {
  return shell::run(argc, argv,
                    {.name = "stipple",
                     .keys_help = "s switches antialiasing, up and down change the stipple's factor",
                     .width_px = 640,
                     .height_px = 480,
                     .init = init,
                     .reshape = reshape,
                     .animate = animate,
                     .key = key,
                     .draw = draw});
}
