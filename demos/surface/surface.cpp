// Evaluators: a lit Bezier surface from 4 x 4 control points, and a curve along its rim. The control points wave.
// c shows the control net, l the surface as lines, up and down change how finely it is evaluated.
#include <GL/gl.h>

#include <algorithm>
#include <cmath>

#include "demos/shell/shell.h"
#include "demos/shell/solids.h"

namespace {

bool show_net = true, as_lines = false;
int steps = 24;
float clock_s = 0.0f;
GLfloat control[4][4][3];

void move_control_points() {
  for (int v = 0; v < 4; ++v) {
    for (int u = 0; u < 4; ++u) {
      GLfloat* const point = control[v][u];
      point[0] = static_cast<float>(u) - 1.5f;
      point[1] = static_cast<float>(v) - 1.5f;
      const bool inner = u % 3 != 0 && v % 3 != 0;
      point[2] = (inner ? 2.2f : 0.8f) * std::sin(1.3f * clock_s + 1.9f * static_cast<float>(u) + 2.7f * static_cast<float>(v));
    }
  }
}

void init() {
  const GLfloat light[] = {1, 2, 4, 0}, highlight[] = {0.8f, 0.8f, 0.8f, 1};
  glLightfv(GL_LIGHT0, GL_POSITION, light);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  const GLfloat outside[] = {0.2f, 0.5f, 0.8f, 1}, inside[] = {0.85f, 0.45f, 0.15f, 1};
  glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, outside);
  glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, inside);
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, highlight);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 50);
  glEnable(GL_LIGHT0);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_AUTO_NORMAL);
  glEnable(GL_NORMALIZE);
  glFrontFace(GL_CW);  // so EvalMesh2 winds what its normals look out of
  glEnable(GL_MAP2_VERTEX_3);
  glEnable(GL_MAP1_VERTEX_3);
  glClearColor(0.08f, 0.08f, 0.1f, 1);
}

void reshape(int width_px, int height_px) {
  shell::set_camera(width_px, height_px, 40, 1, 30);
}

void animate(double seconds) {
  clock_s = static_cast<float>(seconds);
}

void key(int key) {
  switch (key) {
    case 'c': show_net = !show_net; break;
    case 'l': as_lines = !as_lines; break;
    case shell::key_up: steps = std::min(steps * 2, 96); break;
    case shell::key_down: steps = std::max(steps / 2, 3); break;
    default: break;
  }
}

void control_net() {
  glColor3f(0.9f, 0.9f, 0.3f);
  for (int i = 0; i < 4; ++i) {
    glBegin(GL_LINE_STRIP);
    for (const auto& point : control[i]) glVertex3fv(point);
    glEnd();
    glBegin(GL_LINE_STRIP);
    for (const auto& row : control) glVertex3fv(row[i]);
    glEnd();
  }
  glPointSize(5);
  glBegin(GL_POINTS);
  for (const auto& row : control) {
    for (const auto& point : row) glVertex3fv(point);
  }
  glEnd();
}

void rim() {
  glColor3f(0.9f, 0.2f, 0.3f);
  glLineWidth(3);
  glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 4, &control[0][0][0]);
  glMapGrid1f(3 * steps, 0, 1);
  glEvalMesh1(GL_LINE, 0, 3 * steps);
  glLineWidth(1);
}

void draw() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  move_control_points();
  glLoadIdentity();
  shell::look_at({2.2f, -5.2f, 3.6f}, {0, 0, -0.1f}, {0, 0, 1});
  glEnable(GL_LIGHTING);
  glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 4, 0, 1, 12, 4, &control[0][0][0]);
  glMapGrid2f(steps, 0, 1, steps, 0, 1);
  glEvalMesh2(as_lines ? GL_LINE : GL_FILL, 0, steps, 0, steps);
  glDisable(GL_LIGHTING);
  rim();
  if (show_net) control_net();
}

}  // namespace

int main(int argc, char** argv) {
  return shell::run(argc, argv,
                    {.name = "surface",
                     .keys_help = "c shows the control net, l draws lines, up and down evaluate finer and coarser",
                     .width_px = 640,
                     .height_px = 480,
                     .init = init,
                     .reshape = reshape,
                     .animate = animate,
                     .key = key,
                     .draw = draw});
}
