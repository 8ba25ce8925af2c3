// Selection: a click draws the scene once more in select mode, through a keyhole of five pixels, and the hit records
// name what was under it. The nearest body lights up and its name is written. Headless: --click X,Y.
#include <GL/gl.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "demos/shell/font.h"
#include "demos/shell/shell.h"
#include "demos/shell/solids.h"

namespace {

constexpr int rows = 3, columns = 5;
constexpr GLuint nothing = ~0u;
constexpr const char* shapes[] = {"sphere", "torus", "box"};

int width_px = 1, height_px = 1;
GLuint font = 0, picked = nothing;
int hits = 0;
float clock_s = 0;

void set_projection() {
  shell::perspective(40, static_cast<double>(width_px) / height_px, 1, 60);
}

void set_view() {
  glLoadIdentity();
  shell::look_at({0, 6, 12}, {0, 0, 0}, {0, 1, 0});
}

void body(int row, int column) {
  const GLuint name = static_cast<GLuint>(row * columns + column);
  glLoadName(name);
  const GLfloat glow[] = {0.5f, 0.45f, 0.1f, 1}, none[] = {0, 0, 0, 1};
  glMaterialfv(GL_FRONT, GL_EMISSION, name == picked ? glow : none);
  glColor3f(0.3f + 0.12f * static_cast<float>(column), 0.65f - 0.1f * static_cast<float>(column), 0.35f + 0.25f * static_cast<float>(row));
  glPushMatrix();
  glTranslatef(2.2f * static_cast<float>(column - columns / 2), 0.5f * std::sin(clock_s + static_cast<float>(column + row)),
               2.6f * static_cast<float>(row - rows / 2));
  glRotatef(30 * clock_s, 0.2f, 1, 0.4f);
  if (row == 0) shell::solid_sphere(0.75f, 32, 16);
  if (row == 1) shell::solid_torus(0.28f, 0.65f, 24, 32);
  if (row == 2) shell::solid_box(1.1f, 1.1f, 1.1f);
  glPopMatrix();
}

void bodies() {
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) body(row, column);
  }
}

// The hit with the smallest depth. A record is: number of names, nearest and farthest depth, the names.
GLuint nearest(const GLuint* record, int count) {
  GLuint best = nothing, best_depth = ~0u;
  for (int i = 0; i < count; ++i) {
    const GLuint names = record[0];
    if (names > 0 && record[1] <= best_depth) {
      best_depth = record[1];
      best = record[2 + names];
    }
    record += 3 + names;
  }
  return best;
}

// Scales the picture so that five pixels around (x, y) fill it, as gluPickMatrix does.
void keyhole(int x, int y) {
  constexpr float size_px = 5;
  const auto width = static_cast<float>(width_px), height = static_cast<float>(height_px);
  glTranslatef((width - 2 * (static_cast<float>(x) + 0.5f)) / size_px, (height - 2 * (static_cast<float>(y) + 0.5f)) / size_px, 0);
  glScalef(width / size_px, height / size_px, 1);
}

void click(int x, int y_from_top) {
  std::array<GLuint, 512> buffer{};
  glSelectBuffer(static_cast<GLsizei>(buffer.size()), buffer.data());
  glRenderMode(GL_SELECT);
  glInitNames();
  glPushName(0);
  glMatrixMode(GL_PROJECTION);
  glPushMatrix();
  glLoadIdentity();
  keyhole(x, height_px - 1 - y_from_top);
  set_projection();
  glMatrixMode(GL_MODELVIEW);
  set_view();
  bodies();
  glMatrixMode(GL_PROJECTION);
  glPopMatrix();
  glMatrixMode(GL_MODELVIEW);
  hits = glRenderMode(GL_RENDER);
  picked = nearest(buffer.data(), hits);
}

void init() {
  const GLfloat light[] = {1, 3, 2, 0};
  glLightfv(GL_LIGHT0, GL_POSITION, light);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_COLOR_MATERIAL);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glClearColor(0.12f, 0.13f, 0.17f, 1);
  font = shell::make_font(2);
}

void reshape(int new_width_px, int new_height_px) {
  width_px = new_width_px;
  height_px = new_height_px;
  glViewport(0, 0, width_px, height_px);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  set_projection();
  glMatrixMode(GL_MODELVIEW);
}

void animate(double seconds) {
  clock_s = static_cast<float>(seconds);
}

void caption() {
  const std::string what = picked == nothing ? "click on a body"
                                             : std::string(shapes[picked / columns]) + " " +
                                                   std::to_string(picked % columns + 1) + ", of " + std::to_string(hits) +
                                                   (hits == 1 ? " hit" : " hits");
  glDisable(GL_LIGHTING);
  glColor3f(1, 1, 0.8f);
  glWindowPos2i(12, 12);
  shell::draw_text(font, what.c_str());
  glEnable(GL_LIGHTING);
}

void draw() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  set_view();
  bodies();
  caption();
}

}  // namespace

int main(int argc, char** argv) {
  return shell::run(argc, argv,
                    {.name = "pick",
                     .keys_help = "the mouse picks a body",
                     .width_px = 640,
                     .height_px = 480,
                     .init = init,
                     .reshape = reshape,
                     .animate = animate,
                     .click = click,
                     .draw = draw});
}
