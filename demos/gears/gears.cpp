// The classic three gears, with the sizes, colours and light that they have had since 1991.
// Left and right, up and down turn the view, z and Z tilt it.
#include <GL/gl.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "demos/shell/shell.h"

namespace {

struct Gear {
  float inner_radius, outer_radius, width;
  int teeth;
  float tooth_depth;
  float x, y;              // where the axle stands
  float turns, phase_deg;  // turns for each turn of the red gear, and the offset that makes the teeth mesh
  GLfloat color[4];
};

constexpr Gear gears[] = {
    {1.0f, 4.0f, 1.0f, 20, 0.7f, -3.0f, -2.0f, 1.0f, 0.0f, {0.8f, 0.1f, 0.0f, 1.0f}},
    {0.5f, 2.0f, 2.0f, 10, 0.7f, 3.1f, -2.0f, -2.0f, -9.0f, {0.0f, 0.8f, 0.2f, 1.0f}},
    {1.3f, 2.0f, 0.5f, 10, 0.7f, -3.1f, 4.2f, -2.0f, -25.0f, {0.2f, 0.2f, 1.0f, 1.0f}},
};

constexpr float degrees_per_second = 70.0f;

float view_x_deg = 20.0f, view_y_deg = 30.0f, view_z_deg = 0.0f;
float angle_deg = 0.0f;

struct Point {
  float x, y;
};

Point on_circle(float radius, float angle_rad) {
  return {radius * std::cos(angle_rad), radius * std::sin(angle_rad)};
}

// The rim of a gear, counterclockwise and closed: for each tooth its foot, its tip on both sides, and its other foot.
std::vector<Point> outline(const Gear& gear) {
  const float foot = gear.outer_radius - gear.tooth_depth / 2;
  const float tip = gear.outer_radius + gear.tooth_depth / 2;
  const int corners = 4 * gear.teeth;
  std::vector<Point> points;
  for (int i = 0; i <= corners; ++i) {
    const bool at_tip = i % 4 == 1 || i % 4 == 2;
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i % corners) / static_cast<float>(corners);
    points.push_back(on_circle(at_tip ? tip : foot, angle));
  }
  return points;
}

// The hole for the axle: as many corners as the outline, so that a quad strip joins the two.
std::vector<Point> bore(const Gear& gear) {
  const int corners = 4 * gear.teeth;
  std::vector<Point> points;
  for (int i = 0; i <= corners; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i % corners) / static_cast<float>(corners);
    points.push_back(on_circle(gear.inner_radius, angle));
  }
  return points;
}

void draw_gear(const Gear& gear) {
  const std::vector<Point> rim = outline(gear), hole = bore(gear);
  const float front = gear.width / 2, back = -gear.width / 2;
  glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, gear.color);

  glShadeModel(GL_FLAT);
  glNormal3f(0, 0, 1);
  glBegin(GL_QUAD_STRIP);
  for (size_t i = 0; i < rim.size(); ++i) {
    glVertex3f(hole[i].x, hole[i].y, front);
    glVertex3f(rim[i].x, rim[i].y, front);
  }
  glEnd();

  glNormal3f(0, 0, -1);
  glBegin(GL_QUAD_STRIP);
  for (size_t i = 0; i < rim.size(); ++i) {
    glVertex3f(rim[i].x, rim[i].y, back);
    glVertex3f(hole[i].x, hole[i].y, back);
  }
  glEnd();

  glBegin(GL_QUADS);
  for (size_t i = 0; i + 1 < rim.size(); ++i) {
    const Point a = rim[i], b = rim[i + 1];
    glNormal3f(b.y - a.y, a.x - b.x, 0);
    glVertex3f(a.x, a.y, front);
    glVertex3f(a.x, a.y, back);
    glVertex3f(b.x, b.y, back);
    glVertex3f(b.x, b.y, front);
  }
  glEnd();

  glShadeModel(GL_SMOOTH);
  glBegin(GL_QUAD_STRIP);
  for (const Point p : hole) {
    glNormal3f(-p.x, -p.y, 0);
    glVertex3f(p.x, p.y, back);
    glVertex3f(p.x, p.y, front);
  }
  glEnd();
}

void init() {
  const GLfloat light_position[] = {5, 5, 10, 0};
  glLightfv(GL_LIGHT0, GL_POSITION, light_position);
  glEnable(GL_CULL_FACE);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_NORMALIZE);
}

void reshape(int width_px, int height_px) {
  const GLdouble h = static_cast<GLdouble>(height_px) / width_px;
  glViewport(0, 0, width_px, height_px);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-1, 1, -h, h, 5, 60);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glTranslatef(0, 0, -40);
}

void animate(double seconds) {
  angle_deg = static_cast<float>(std::fmod(degrees_per_second * seconds, 360.0));
}

void key(int key) {
  switch (key) {
    case shell::key_left: view_y_deg += 5; break;
    case shell::key_right: view_y_deg -= 5; break;
    case shell::key_up: view_x_deg += 5; break;
    case shell::key_down: view_x_deg -= 5; break;
    case 'z': view_z_deg += 5; break;
    case 'Z': view_z_deg -= 5; break;
    default: break;
  }
}

void draw() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glPushMatrix();
  glRotatef(view_x_deg, 1, 0, 0);
  glRotatef(view_y_deg, 0, 1, 0);
  glRotatef(view_z_deg, 0, 0, 1);
  for (const Gear& gear : gears) {
    glPushMatrix();
    glTranslatef(gear.x, gear.y, 0);
    glRotatef(gear.turns * angle_deg + gear.phase_deg, 0, 0, 1);
    draw_gear(gear);
    glPopMatrix();
  }
  glPopMatrix();
}

}  // namespace

int main(int argc, char** argv) {
  return shell::run(argc, argv,
                    {.name = "gears",
                     .keys_help = "the arrow keys turn the view, z and Z tilt it",
                     .width_px = 600,
                     .height_px = 600,
                     .init = init,
                     .reshape = reshape,
                     .animate = animate,
                     .key = key,
                     .draw = draw});
}
