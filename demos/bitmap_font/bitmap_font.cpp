// Text as legacy programs wrote it: one bitmap a character in display lists, glRasterPos or glWindowPos, glCallLists.
// Labels stay upright and of one size while the globe that they name turns.
#include <GL/gl.h>

#include <cmath>
#include <cstdio>
#include <iterator>

#include "demos/shell/font.h"
#include "demos/shell/shell.h"
#include "demos/shell/solids.h"

namespace {

struct Place {
  const char* name;
  float latitude_deg, longitude_deg;
};

constexpr Place places[] = {{"Salt Lake City", 40.8f, -111.9f}, {"Chapel Hill", 35.9f, -79.1f},  {"Cambridge", 52.2f, 0.1f},
                            {"Paris", 48.9f, 2.4f},             {"Novosibirsk", 55.0f, 82.9f},   {"Tokyo", 35.7f, 139.7f},
                            {"Sydney", -33.9f, 151.2f},         {"Cape Town", -33.9f, 18.4f},    {"Quito", -0.2f, -78.5f},
                            {"Reykjavik", 64.1f, -21.9f},       {"Ushuaia", -54.8f, -68.3f},     {"Nairobi", -1.3f, 36.8f}};

GLuint small_font = 0, large_font = 0;
float turn_deg = 0;
int height_px = 1;

shell::Vec3 on_globe(const Place& place) {
  constexpr float radian = 0.017453293f;
  const float latitude = place.latitude_deg * radian, longitude = place.longitude_deg * radian;
  return {std::cos(latitude) * std::sin(longitude), std::sin(latitude), std::cos(latitude) * std::cos(longitude)};
}

void init() {
  small_font = shell::make_font();
  large_font = shell::make_font(3);
  glEnable(GL_DEPTH_TEST);
  glClearColor(0.02f, 0.05f, 0.12f, 1);
}

void reshape(int width_px, int new_height_px) {
  height_px = new_height_px;
  shell::set_camera(width_px, new_height_px, 30, 1, 20);
}

void animate(double seconds) {
  turn_deg = static_cast<float>(std::fmod(15 * seconds, 360));
}

void globe() {
  glColor3f(0.05f, 0.12f, 0.25f);
  shell::solid_sphere(0.99f, 64, 32);
  glColor3f(0.25f, 0.45f, 0.65f);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  shell::solid_sphere(1, 24, 12);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void labels() {
  glPointSize(4);
  for (const Place& place : places) {
    const auto [x, y, z] = on_globe(place);
    glColor3f(1, 0.75f, 0.2f);
    glBegin(GL_POINTS);
    glVertex3f(1.01f * x, 1.01f * y, 1.01f * z);
    glEnd();
    glColor3f(1, 1, 1);
    glRasterPos3f(1.03f * x, 1.03f * y, 1.03f * z);
    glBitmap(0, 0, 0, 0, 5, -3, nullptr);  // beside the point
    shell::draw_text(small_font, place.name);
  }
}

void captions() {
  glColor3f(0.9f, 0.9f, 0.9f);
  glWindowPos2i(12, height_px - 34);
  shell::draw_text(large_font, "Around the globe");
  char text[64];
  std::snprintf(text, sizeof text, "turned by %.1f degrees; %zu places", static_cast<double>(turn_deg), std::size(places));
  glWindowPos2i(12, 12);
  shell::draw_text(small_font, text);
}

void draw() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glLoadIdentity();
  shell::look_at({0, 1.2f, 4.4f}, {0, 0, 0}, {0, 1, 0});
  glRotatef(turn_deg - 20, 0, 1, 0);
  globe();
  labels();
  captions();
}

}  // namespace

int main(int argc, char** argv) {
  return shell::run(argc, argv,
                    {.name = "bitmap_font",
                     .keys_help = "the globe turns by itself",
                     .width_px = 640,
                     .height_px = 560,
                     .init = init,
                     .reshape = reshape,
                     .animate = animate,
                     .draw = draw});
}
