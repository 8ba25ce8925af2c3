// Texture filters side by side on a floor that runs to the horizon: without mipmaps, and four ways with them.
// Up and down move the level-of-detail bias, w changes the wrap mode.
#include <GL/gl.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "demos/shell/font.h"
#include "demos/shell/images.h"
#include "demos/shell/shell.h"

namespace {

struct Filter {
  const char* name;
  GLint minify, magnify;
};
constexpr std::array<Filter, 6> filters{{{"nearest", GL_NEAREST, GL_NEAREST},
                                         {"linear", GL_LINEAR, GL_LINEAR},
                                         {"nearest in nearest", GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST},
                                         {"linear in nearest", GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR},
                                         {"nearest in both", GL_NEAREST_MIPMAP_LINEAR, GL_NEAREST},
                                         {"linear in both", GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR}}};
constexpr std::array<GLint, 3> wraps{GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE};

std::array<GLuint, filters.size()> textures{};
GLuint font = 0;
std::size_t wrap = 0;
float bias = 0, way = 0;
int width_px = 1, height_px = 1;
float half_width = 1;  // of the window, at a distance of 1

void init() {
  constexpr int size = 256;
  const auto texels = shell::make_image(size, size, [](float s, float t) {
    const shell::Color tile = shell::checker(s, t, 8, {0.92f, 0.9f, 0.85f}, {0.15f, 0.2f, 0.35f});
    const float dx = s - 0.5f, dy = t - 0.5f;
    return std::abs(std::sqrt(dx * dx + dy * dy) - 0.33f) < 0.04f ? shell::Color{0.85f, 0.25f, 0.1f} : tile;
  });
  glGenTextures(static_cast<GLsizei>(textures.size()), textures.data());
  for (std::size_t i = 0; i < filters.size(); ++i) {
    glBindTexture(GL_TEXTURE_2D, textures[i]);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filters[i].minify);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filters[i].magnify);
    shell::upload_with_mipmaps(size, size, texels);
  }
  font = shell::make_font();
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glClearColor(0.55f, 0.7f, 0.85f, 1);
}

// The picture's middle lies below the horizon, but the eye looks level: so strips have upright sides.
void reshape(int new_width_px, int new_height_px) {
  width_px = new_width_px;
  height_px = new_height_px;
  constexpr double near = 0.2, half_height = 0.4142;  // tan of 22.5 degrees
  half_width = static_cast<float>(half_height * width_px / height_px);
  glViewport(0, 0, width_px, height_px);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-near * half_width, near * half_width, -1.6 * near * half_height, 0.4 * near * half_height, near, 200);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
}

void animate(double seconds) {
  way = static_cast<float>(std::fmod(0.3 * seconds, 4));
}

void key(int key) {
  if (key == 'w') wrap = (wrap + 1) % wraps.size();
  if (key == shell::key_up) bias += 0.25f;
  if (key == shell::key_down) bias -= 0.25f;
}

// A strip of floor that shows between x0 and x1 at a distance of 1: the same texture everywhere.
void strip(float x0, float x1) {
  constexpr float near_distance = 0.5f, far_distance = 150, eye_height = 1;
  glBegin(GL_QUADS);
  for (const auto& [x, distance] : {std::array{x0, near_distance}, {x1, near_distance}, {x1, far_distance}, {x0, far_distance}}) {
    glTexCoord2f(0.5f * x * distance, 0.5f * distance + way);
    glVertex3f(x * distance, -eye_height, -distance);
  }
  glEnd();
}

void draw() {
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_TEXTURE_2D);
  glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, bias);
  const float width = 2 * half_width / static_cast<float>(filters.size());
  for (std::size_t i = 0; i < filters.size(); ++i) {
    glBindTexture(GL_TEXTURE_2D, textures[i]);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wraps[wrap]);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wraps[wrap]);
    const float x = -half_width + width * static_cast<float>(i);
    strip(x + width * 0.015f, x + width * 0.985f);
  }
  glDisable(GL_TEXTURE_2D);
  glColor3f(0.1f, 0.1f, 0.1f);
  for (std::size_t i = 0; i < filters.size(); ++i) {
    glWindowPos2i(width_px * static_cast<int>(i) / static_cast<int>(filters.size()) + 8, height_px * 21 / 25);
    shell::draw_text(font, filters[i].name);
  }
}

}  // namespace

int main(int argc, char** argv) {
  return shell::run(argc, argv,
                    {.name = "texture",
                     .keys_help = "up and down move the level-of-detail bias, w changes the wrap mode",
                     .width_px = 900,
                     .height_px = 480,
                     .init = init,
                     .reshape = reshape,
                     .animate = animate,
                     .key = key,
                     .draw = draw});
}
