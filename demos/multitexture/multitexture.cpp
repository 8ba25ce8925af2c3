// Light maps: a room whose walls have bricks on texture unit 0 and, multiplied onto them, precomputed light on unit 1.
// The lamp swings: its light map slides over the floor by the texture matrix. m switches the light maps.
#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <cmath>

#include "demos/shell/images.h"
#include "demos/shell/shell.h"
#include "demos/shell/solids.h"

namespace {

GLuint brick_texture = 0, floor_texture = 0, wall_light = 0, lamp_light = 0;
bool light_maps = true;
float swing = 0, view_deg = 0;

GLuint make_texture(int size, shell::Color (*color_at)(float, float), GLint wrap) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  shell::upload_with_mipmaps(size, size, shell::make_image(size, size, color_at));
  return texture;
}

// A pool of warm light on bluish darkness.
shell::Color pool_of_light(float s, float t) {
  const float dx = s - 0.5f, dy = t - 0.5f, distance = std::sqrt(dx * dx + dy * dy);
  const float light = std::clamp(1.25f - 3.2f * distance, 0.0f, 1.0f);
  return {0.16f + 0.84f * light, 0.16f + 0.76f * light, 0.24f + 0.46f * light};
}

// Three lamps under the ceiling.
shell::Color wall_washers(float s, float t) {
  float light = 0;
  for (const float lamp : {0.2f, 0.5f, 0.8f}) {
    const float across = std::abs(s - lamp) / (0.03f + 0.14f * (1 - t));
    light += std::clamp(1 - across * across, 0.0f, 1.0f) * (0.25f + 0.75f * t);
  }
  light = std::min(light, 1.0f);
  return {0.18f + 0.82f * light, 0.18f + 0.74f * light, 0.26f + 0.5f * light};
}

void init() {
  brick_texture = make_texture(256, [](float s, float t) { return shell::bricks(s, t, 8); }, GL_REPEAT);
  floor_texture = make_texture(
      256, [](float s, float t) { return shell::checker(s, t, 4, {0.85f, 0.8f, 0.7f}, {0.35f, 0.28f, 0.25f}); }, GL_REPEAT);
  wall_light = make_texture(128, wall_washers, GL_CLAMP_TO_EDGE);
  lamp_light = make_texture(128, pool_of_light, GL_CLAMP_TO_EDGE);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_TEXTURE_2D);
}

void reshape(int width_px, int height_px) {
  shell::set_camera(width_px, height_px, 60, 0.1, 50);
}

void animate(double seconds) {
  swing = 0.22f * static_cast<float>(std::sin(1.2 * seconds));
  view_deg = 12.0f * static_cast<float>(std::sin(0.4 * seconds));
}

void key(int key) {
  if (key == 'm') light_maps = !light_maps;
}

// Corner i of a quad: unit 0 repeats its texture, unit 1 covers the quad once.
void surface(const shell::Vec3 (&corners)[4], float repeat_s, float repeat_t) {
  constexpr float unit_square[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  glBegin(GL_QUADS);
  for (int i = 0; i < 4; ++i) {
    const auto& [s, t] = unit_square[i];
    glMultiTexCoord2f(GL_TEXTURE0, repeat_s * s, repeat_t * t);
    glMultiTexCoord2f(GL_TEXTURE1, s, t);
    glVertex3f(corners[i].x, corners[i].y, corners[i].z);
  }
  glEnd();
}

void bind(GLuint texture, GLuint light, float light_shift) {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, light);
  light_maps ? glEnable(GL_TEXTURE_2D) : glDisable(GL_TEXTURE_2D);
  glMatrixMode(GL_TEXTURE);
  glLoadIdentity();
  glTranslatef(light_shift, 0, 0);
  glMatrixMode(GL_MODELVIEW);
  glActiveTexture(GL_TEXTURE0);
}

void draw() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glLoadIdentity();
  glRotatef(14, 1, 0, 0);
  glTranslatef(0, -2.1f, -5.5f);
  glRotatef(view_deg, 0, 1, 0);
  glColor3f(1, 1, 1);
  bind(floor_texture, lamp_light, swing);
  surface({{-4, 0, 4}, {4, 0, 4}, {4, 0, -4}, {-4, 0, -4}}, 4, 4);
  bind(brick_texture, wall_light, 0);
  surface({{-4, 0, -4}, {4, 0, -4}, {4, 4, -4}, {-4, 4, -4}}, 3, 1.5f);
  surface({{-4, 0, 4}, {-4, 0, -4}, {-4, 4, -4}, {-4, 4, 4}}, 3, 1.5f);
  surface({{4, 0, -4}, {4, 0, 4}, {4, 4, 4}, {4, 4, -4}}, 3, 1.5f);
}

}  // namespace

int main(int argc, char** argv) {
  return shell::run(argc, argv,
                    {.name = "multitexture",
                     .keys_help = "m switches the light maps",
                     .width_px = 640,
                     .height_px = 480,
                     .init = init,
                     .reshape = reshape,
                     .animate = animate,
                     .key = key,
                     .draw = draw});
}
