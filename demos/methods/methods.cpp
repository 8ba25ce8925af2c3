// Every way to do a step: a key a step changes its method; the title shows milliseconds and the error that it makes.
// Keys 1 to 9, then a, b, ...: the steps in the order of the list, 0: all defaults. --methods "coverage=scanline,colors=affine" begins so.
// The error is against the same frame drawn with the defaults, which keep to the oracle within rounding.
// p: the next projection (projections.cpp): perspective, orthographic, oblique, and perspective by left-handed matrices.
#include <GL/gl.h>
#include <GL/gouraud.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "demos/methods/projections.h"
#include "demos/shell/circle.h"
#include "demos/shell/font.h"
#include "demos/shell/images.h"
#include "demos/shell/shell.h"
#include "demos/shell/solids.h"

namespace {

struct Step {
  std::string name;
  std::vector<std::string> methods;  // the first is the default
  size_t chosen = 0;
};

std::vector<Step> steps;
std::string first_methods;
int width_px = 0, height_px = 0;
unsigned font = 0, checker_texture = 0;
std::string status_text;
int projection = 0;

// The library's own table: lines of step, method, what it does, source.
void read_table() {
  std::istringstream lines(gouraudMethodTable());
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string step, method;
    std::getline(fields, step, '\t');
    std::getline(fields, method, '\t');
    if (steps.empty() || steps.back().name != step) steps.push_back({step, {}, 0});
    steps.back().methods.push_back(method);
  }
}

// Takes over what a string says, such as "coverage=scanline,colors=affine".
void choose(const std::string& methods) {
  std::istringstream items(methods);
  for (std::string item; std::getline(items, item, ',');) {
    const size_t sign = std::min(item.find('='), item.size());
    for (Step& step : steps) {
      const auto found = std::find(step.methods.begin(), step.methods.end(), item.substr(std::min(sign + 1, item.size())));
      if (step.name == item.substr(0, sign) && found != step.methods.end()) {
        step.chosen = static_cast<size_t>(found - step.methods.begin());
      }
    }
  }
}

std::string chosen_methods() {
  std::string text;
  for (const Step& step : steps) {
    if (step.chosen != 0) text += (text.empty() ? "" : ",") + step.name + "=" + step.methods[step.chosen];
  }
  return text;
}

void window_coordinates() {
  glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glOrtho(0, width_px, 0, height_px, -1, 1);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
}

// A checker to the horizon, and a ball of few faces.
void draw_perspective() {
  set_projection(projection, width_px, height_px, 5.1);
  const GLfloat position[] = {4, 5, 6, 0};  // of the camera's space, whichever hand that has
  glLightfv(GL_LIGHT0, GL_POSITION, position);
  shell::look_at({0, 1.6f, 5}, {0, 0.7f, 0}, {0, 1, 0});
  glEnable(GL_DEPTH_TEST);
  glColor3f(1, 1, 1);
  glBindTexture(GL_TEXTURE_2D, checker_texture);
  glEnable(GL_TEXTURE_2D);
  shell::ground(20, 1, 20);
  glDisable(GL_TEXTURE_2D);

  glEnable(GL_LIGHTING);
  glPushMatrix();
  glTranslatef(-1.3f, 1.1f, 0);
  glRotatef(20, 1, 1, 0);
  shell::solid_sphere(1, 9, 6);
  glPopMatrix();
  glDisable(GL_LIGHTING);

  // Two cards through each other: what is in front changes within both.
  glBegin(GL_QUADS);
  for (const float side : {1.0f, -1.0f}) {
    glColor3f(0.9f, side > 0 ? 0.7f : 0.2f, 0.2f);
    glVertex3f(0.6f, 0.2f, 0.8f * side);
    glVertex3f(2.2f, 0.2f, -0.8f * side);
    glColor3f(0.2f, 0.3f, 0.8f);
    glVertex3f(2.2f, 1.8f, -0.8f * side);
    glVertex3f(0.6f, 1.8f, 0.8f * side);
  }
  glEnd();
  glDisable(GL_DEPTH_TEST);
}

// Rays, rings and needles in the upper corners.
void draw_flat() {
  window_coordinates();
  const float size = static_cast<float>(std::min(width_px, height_px)) / 6;
  const float left = size * 1.2f, right = static_cast<float>(width_px) - size * 1.2f, y = static_cast<float>(height_px) - size * 1.2f;
  glBegin(GL_LINES);
  for (int i = 0; i < 36; ++i) {
    const float angle = static_cast<float>(i) * 0.17453293f;
    glColor3f(1, 0.9f, 0.5f);
    glVertex2f(left + 0.2f * size * std::cos(angle), y + 0.2f * size * std::sin(angle));
    glColor3f(0.3f, 0.6f, 1);
    glVertex2f(left + size * std::cos(angle), y + size * std::sin(angle));
  }
  glEnd();
  glColor3f(0.6f, 1, 0.6f);
  for (int ring = 1; ring <= 5; ++ring) {
    shell::draw_circle(static_cast<int>(left), static_cast<int>(y), static_cast<int>(size * (0.9f + 0.05f * static_cast<float>(ring))));
  }
  glBegin(GL_TRIANGLES);
  for (int i = 0; i < 60; ++i) {
    const float angle = static_cast<float>(i) * 0.10471976f, half = 0.004f + 0.0008f * static_cast<float>(i);
    glColor3f(1, 1, 1);
    glVertex2f(right + 2 * std::cos(angle), y + 2 * std::sin(angle));
    glColor3f(1, 0.3f, 0.3f);
    glVertex2f(right + size * std::cos(angle - half), y + size * std::sin(angle - half));
    glVertex2f(right + size * std::cos(angle + half), y + size * std::sin(angle + half));
  }
  glEnd();
}

void draw_scene() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw_perspective();
  draw_flat();
  glFinish();
}

// Draws the scene with these methods and reads it back.
std::vector<unsigned char> picture_by(const std::string& methods, double& milliseconds) {
  gouraudMethods(methods.c_str());
  const auto begin = std::chrono::steady_clock::now();
  draw_scene();
  milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  std::vector<unsigned char> pixels(static_cast<size_t>(4 * width_px) * static_cast<size_t>(height_px));
  glReadPixels(0, 0, width_px, height_px, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

void describe_error(const std::vector<unsigned char>& picture, const std::vector<unsigned char>& reference, double milliseconds) {
  double sum = 0;
  int largest = 0, different = 0;
  for (size_t i = 0; i < picture.size(); i += 4) {
    int worst = 0;
    for (size_t channel = i; channel < i + 3; ++channel) {
      const int distance = std::abs(picture[channel] - reference[channel]);
      sum += distance;
      worst = std::max(worst, distance);
    }
    largest = std::max(largest, worst);
    different += worst > 0 ? 1 : 0;
  }
  const double pixels = static_cast<double>(picture.size()) / 4;
  char text[200];
  std::snprintf(text, sizeof text, "%s: %.2f ms, error mean %.3f/255, largest %d/255, %.2f %% of the pixels",
                chosen_methods().empty() ? "the defaults" : chosen_methods().c_str(), milliseconds, sum / (3 * pixels), largest,
                100 * different / pixels);
  status_text = text;
}

// Of the step with this number in the list.
char key_of(size_t step) { return static_cast<char>(step < 9 ? '1' + step : 'a' + (step - 9)); }

// The steps with their keys and methods, by the defaults.
void draw_list() {
  gouraudMethods("");
  window_coordinates();
  glColor3f(0.1f, 0.12f, 0.16f);
  glRecti(4, 6, 240, 14 + shell::line_height_px * static_cast<int>(steps.size() + 1));
  int y = 12 + shell::line_height_px * static_cast<int>(steps.size());
  for (size_t i = 0; i < steps.size(); ++i, y -= shell::line_height_px) {
    const bool is_default = steps[i].chosen == 0;
    glColor3f(1, is_default ? 1.0f : 0.8f, is_default ? 1.0f : 0.2f);
    glRasterPos2i(10, y);
    shell::draw_text(font, (key_of(i) + (" " + steps[i].name) + ": " + steps[i].methods[steps[i].chosen]).c_str());
  }
  glColor3f(1, projection == 0 ? 1.0f : 0.8f, projection == 0 ? 1.0f : 0.2f);
  glRasterPos2i(10, y);
  shell::draw_text(font, (std::string("p projection: ") + projection_name(projection)).c_str());
}

void init() {
  read_table();
  choose(first_methods);
  font = shell::make_font();
  constexpr int size = 64;
  glGenTextures(1, &checker_texture);
  glBindTexture(GL_TEXTURE_2D, checker_texture);
  shell::upload_with_mipmaps(size, size, shell::make_image(size, size, [](float s, float t) {
                               return shell::checker(s, t, 2, {0.85f, 0.85f, 0.8f, 1}, {0.25f, 0.3f, 0.35f, 1});
                             }));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  const GLfloat material[] = {0.3f, 0.5f, 0.8f, 1}, white[] = {1, 1, 1, 1};
  glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);  // the viewer far away would stand at +z: GL's hand
  glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, material);
  glMaterialfv(GL_FRONT, GL_SPECULAR, white);
  glMaterialf(GL_FRONT, GL_SHININESS, 40);
  glEnable(GL_LIGHT0);
  glEnable(GL_NORMALIZE);
  glClearColor(0.1f, 0.12f, 0.16f, 1);
}

void reshape(int width, int height) {
  width_px = width;
  height_px = height;
  glViewport(0, 0, width, height);
}

void key(int key) {
  if (key == 'p') projection = (projection + 1) % projection_count;
  if (key == '0') projection = 0;
  for (size_t i = 0; i < steps.size(); ++i) {
    if (key == '0') steps[i].chosen = 0;
    if (key == key_of(i)) steps[i].chosen = (steps[i].chosen + 1) % steps[i].methods.size();
  }
}

void draw() {
  double reference_ms = 0, milliseconds = 0;
  const std::vector<unsigned char> reference = picture_by("", reference_ms);
  const std::vector<unsigned char> picture = picture_by(chosen_methods(), milliseconds);
  describe_error(picture, reference, milliseconds);
  draw_list();
}

const char* status() { return status_text.c_str(); }

}  // namespace

int main(int argc, char** argv) {
  std::vector<char*> arguments(argv, argv + argc);
  for (size_t i = 1; i + 1 < arguments.size(); ++i) {
    if (std::string(arguments[i]) != "--methods") continue;
    first_methods = arguments[i + 1];
    arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i), arguments.begin() + static_cast<std::ptrdiff_t>(i + 2));
    break;
  }
  arguments.push_back(nullptr);
  return shell::run(static_cast<int>(arguments.size()) - 1, arguments.data(),
                    {.name = "methods",
                     .keys_help = "1 to 9 and the letters from a on change the methods of the steps in the list, 0 resets them; p: the next projection (perspective, orthographic, oblique, left-handed); --methods \"step=name,...\" begins so",
                     .width_px = 640,
                     .height_px = 480,
                     .init = init,
                     .reshape = reshape,
                     .key = key,
                     .draw = draw,
                     .status = status});
}
