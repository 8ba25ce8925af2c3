// A grid of lit spheres: each row turns one knob of the material, from nothing on the left to full on the right.
// From the top: ambient, diffuse, specular, shininess, emission. The arrow keys move the light.
#include <GL/gl.h>

#include <cmath>
#include <numbers>

#include "demos/shell/shell.h"

namespace {

constexpr int rows = 5, columns = 6;
constexpr float pi = std::numbers::pi_v<float>;

float light_round_deg = -35.0f, light_up_deg = 40.0f, swing_deg = 0.0f;

struct Color {
  GLfloat rgba[4];
};

Color scaled(const Color& c, float s) {
  return {{c.rgba[0] * s, c.rgba[1] * s, c.rgba[2] * s, 1}};
}

constexpr Color row_color[rows] = {{{0.85f, 0.30f, 0.25f, 1}},
                                   {{0.90f, 0.62f, 0.20f, 1}},
                                   {{0.25f, 0.62f, 0.35f, 1}},
                                   {{0.22f, 0.45f, 0.80f, 1}},
                                   {{0.58f, 0.30f, 0.75f, 1}}};
constexpr Color white = {{1, 1, 1, 1}}, black = {{0, 0, 0, 1}};

struct Material {
  Color ambient, diffuse, specular, emission;
  float shininess;
};

// The material of one sphere: what all spheres of its row share, and the knob of that row at `amount` (0 to 1).
Material material_at(int row, float amount) {
  const Color color = row_color[row];
  Material m = {scaled(color, 0.5f), scaled(color, 0.8f), black, black, 0};
  switch (row) {
    case 0: m.ambient = scaled(color, 2 * amount), m.diffuse = scaled(color, 0.6f); break;
    case 1: m.diffuse = scaled(color, amount); break;
    case 2: m.specular = scaled(white, amount), m.shininess = 20; break;
    case 3: m.specular = white, m.shininess = std::pow(2.0f, 2 + 5 * amount); break;
    default: m.emission = scaled(color, 0.6f * amount); break;
  }
  return m;
}

void apply(const Material& m) {
  glMaterialfv(GL_FRONT, GL_AMBIENT, m.ambient.rgba);
  glMaterialfv(GL_FRONT, GL_DIFFUSE, m.diffuse.rgba);
  glMaterialfv(GL_FRONT, GL_SPECULAR, m.specular.rgba);
  glMaterialfv(GL_FRONT, GL_EMISSION, m.emission.rgba);
  glMaterialf(GL_FRONT, GL_SHININESS, m.shininess);
}

// One vertex of the unit sphere, whose normal is its position.
void sphere_vertex(float latitude, float longitude) {
  const float x = std::cos(latitude) * std::sin(longitude), y = std::sin(latitude);
  const float z = std::cos(latitude) * std::cos(longitude);
  glNormal3f(x, y, z);
  glVertex3f(x, y, z);
}

void sphere(int slices, int stacks) {
  for (int i = 0; i < stacks; ++i) {
    const float south = pi * (static_cast<float>(i) / static_cast<float>(stacks) - 0.5f);
    const float north = pi * (static_cast<float>(i + 1) / static_cast<float>(stacks) - 0.5f);
    glBegin(GL_QUAD_STRIP);
    for (int j = 0; j <= slices; ++j) {
      const float longitude = 2 * pi * static_cast<float>(j % slices) / static_cast<float>(slices);
      sphere_vertex(north, longitude);
      sphere_vertex(south, longitude);
    }
    glEnd();
  }
}

void init() {
  const GLfloat dim[] = {0.25f, 0.25f, 0.25f, 1};
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, dim);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glEnable(GL_NORMALIZE);
  glClearColor(0.11f, 0.12f, 0.15f, 1);
}

void reshape(int width_px, int height_px) {
  constexpr GLdouble half_width = 1.25 * columns, half_height = 1.25 * rows;
  const GLdouble aspect = static_cast<GLdouble>(width_px) / height_px;
  const GLdouble wider = std::fmax(1, aspect * half_height / half_width);
  const GLdouble taller = std::fmax(1, half_width / half_height / aspect);
  glViewport(0, 0, width_px, height_px);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glOrtho(-half_width * wider, half_width * wider, -half_height * taller, half_height * taller, -2, 2);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
}

void animate(double seconds) {
  swing_deg = static_cast<float>(30 * std::sin(0.8 * seconds));
}

void key(int key) {
  switch (key) {
    case shell::key_left: light_round_deg -= 5; break;
    case shell::key_right: light_round_deg += 5; break;
    case shell::key_up: light_up_deg += 5; break;
    case shell::key_down: light_up_deg -= 5; break;
    default: break;
  }
}

void draw() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

  const GLfloat toward_viewer[] = {0, 0, 1, 0};
  glPushMatrix();
  glRotatef(light_round_deg + swing_deg, 0, 1, 0);
  glRotatef(-light_up_deg, 1, 0, 0);
  glLightfv(GL_LIGHT0, GL_POSITION, toward_viewer);
  glPopMatrix();

  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      apply(material_at(row, static_cast<float>(column) / (columns - 1)));
      glPushMatrix();
      glTranslatef(2.5f * static_cast<float>(column) - 1.25f * (columns - 1),
                   1.25f * (rows - 1) - 2.5f * static_cast<float>(row), 0);
      sphere(48, 24);
      glPopMatrix();
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  return shell::run(argc, argv,
                    {.name = "materials",
                     .keys_help = "left and right move the light round, up and down raise and lower it",
                     .width_px = 720,
                     .height_px = 600,
                     .init = init,
                     .reshape = reshape,
                     .animate = animate,
                     .key = key,
                     .draw = draw});
}
