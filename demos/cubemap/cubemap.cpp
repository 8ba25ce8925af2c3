// A cube map of a landscape: seen as the sky around, and reflected by a torus and a ball through generated texture
// coordinates. r goes from reflection map to normal map, left and right turn the view.
#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <cmath>

#include "demos/shell/images.h"
#include "demos/shell/shell.h"
#include "demos/shell/solids.h"

namespace {

constexpr int face_size = 256;
bool reflects = true;
float view_deg = 30, clock_s = 0;

float mix(float a, float b, float t) {
  return a + (b - a) * std::clamp(t, 0.0f, 1.0f);
}

// What is seen in a direction: a sky with a sun over a plain of fields.
shell::Color landscape(const shell::Vec3& direction) {
  const float length = std::sqrt(direction.x * direction.x + direction.y * direction.y + direction.z * direction.z);
  const float x = direction.x / length, y = direction.y / length, z = direction.z / length;
  if (y < 0) {
    const float distance = std::min(-1 / std::min(y, -0.01f), 20.0f);
    const shell::Color field = shell::checker(x * distance + 64, z * distance + 64, 1, {0.35f, 0.5f, 0.2f}, {0.55f, 0.5f, 0.3f});
    const float haze = distance / 20;
    return {mix(field.r, 0.75f, haze), mix(field.g, 0.8f, haze), mix(field.b, 0.85f, haze)};
  }
  const float to_sun = 0.48f * x + 0.6f * y + 0.64f * z;
  const float sun = std::pow(std::max(to_sun, 0.0f), 400.0f) * 1.5f + 0.25f * std::pow(std::max(to_sun, 0.0f), 12.0f);
  return {mix(0.75f, 0.15f, y) + sun, mix(0.8f, 0.35f, y) + 0.9f * sun, mix(0.85f, 0.75f, y) + 0.7f * sun};
}

// The direction of (s, t) on a face [GL1.5 Table 3.20].
shell::Vec3 direction_of(GLenum face, float s, float t) {
  const float a = 2 * s - 1, b = 2 * t - 1;
  switch (face) {
    case GL_TEXTURE_CUBE_MAP_POSITIVE_X: return {1, -b, -a};
    case GL_TEXTURE_CUBE_MAP_NEGATIVE_X: return {-1, -b, a};
    case GL_TEXTURE_CUBE_MAP_POSITIVE_Y: return {a, 1, b};
    case GL_TEXTURE_CUBE_MAP_NEGATIVE_Y: return {a, -1, -b};
    case GL_TEXTURE_CUBE_MAP_POSITIVE_Z: return {a, -b, 1};
    default: return {-a, -b, -1};
  }
}

void make_cube_map() {
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_GENERATE_MIPMAP, GL_TRUE);
  for (GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X; face <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z; ++face) {
    const auto texels = shell::make_image(face_size, face_size,
                                          [face](float s, float t) { return landscape(direction_of(face, s, t)); });
    glTexImage2D(face, 0, GL_RGBA, face_size, face_size, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  }
}

void init() {
  make_cube_map();
  glEnable(GL_TEXTURE_CUBE_MAP);
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_NORMALIZE);
}

void reshape(int width_px, int height_px) {
  shell::set_camera(width_px, height_px, 45, 0.5, 50);
}

void animate(double seconds) {
  clock_s = static_cast<float>(seconds);
}

void key(int key) {
  if (key == 'r') reflects = !reflects;
  if (key == shell::key_left) view_deg -= 5;
  if (key == shell::key_right) view_deg += 5;
}

constexpr GLenum coordinates[] = {GL_S, GL_T, GL_R};
constexpr GLenum generators[] = {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R};

// The sky is a box around the eye whose corners are their own texture coordinates.
void sky() {
  constexpr float corners[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
  constexpr int faces[6][4] = {{0, 1, 2, 3}, {5, 4, 7, 6}, {4, 0, 3, 7}, {1, 5, 6, 2}, {3, 2, 6, 7}, {4, 5, 1, 0}};
  glDepthMask(GL_FALSE);
  glBegin(GL_QUADS);
  for (const auto& face : faces) {
    for (const int corner : face) {
      const auto& [x, y, z] = corners[corner];
      glTexCoord3f(x, y, z);
      glVertex3f(5 * x, 5 * y, 5 * z);
    }
  }
  glEnd();
  glDepthMask(GL_TRUE);
}

// Texture coordinates are generated in eye space; the texture matrix turns them back to the world's axes.
void mirrors() {
  glMatrixMode(GL_TEXTURE);
  glPushMatrix();
  glRotatef(-view_deg, 0, 1, 0);
  glRotatef(-15, 1, 0, 0);
  glMatrixMode(GL_MODELVIEW);
  for (int i = 0; i < 3; ++i) {
    glTexGeni(coordinates[i], GL_TEXTURE_GEN_MODE, reflects ? GL_REFLECTION_MAP : GL_NORMAL_MAP);
    glEnable(generators[i]);
  }
  glPushMatrix();
  glRotatef(40 * clock_s, 0.3f, 1, 0.1f);
  shell::solid_torus(0.35f, 1.1f, 48, 96);
  glPopMatrix();
  shell::solid_sphere(0.5f, 64, 32);
  for (const GLenum generator : generators) glDisable(generator);
  glMatrixMode(GL_TEXTURE);
  glPopMatrix();
  glMatrixMode(GL_MODELVIEW);
}

void draw() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glLoadIdentity();
  glRotatef(15, 1, 0, 0);
  glRotatef(view_deg, 0, 1, 0);
  sky();
  glLoadIdentity();
  glTranslatef(0, 0, -4.5f);
  glRotatef(15, 1, 0, 0);
  glRotatef(view_deg, 0, 1, 0);
  mirrors();
}

}  // namespace

int main(int argc, char** argv) {
  return shell::run(argc, argv,
                    {.name = "cubemap",
                     .keys_help = "r switches between reflection and normal map, left and right turn the view",
                     .width_px = 640,
                     .height_px = 480,
                     .init = init,
                     .reshape = reshape,
                     .animate = animate,
                     .key = key,
                     .draw = draw});
}
