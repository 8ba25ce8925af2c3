// All at once, as a simulator's viewer draws it: textured and cube-mapped bodies under two spot lights, one of which
// throws shadows, on a tiled floor that reflects them and runs into the fog; and a legend in bitmap text.
// r switches the reflection, s the shadows, f the fog.
#include <GL/gl.h>
#include <GL/glext.h>

#include <cmath>
#include <cstdio>

#include "demos/shell/font.h"
#include "demos/shell/images.h"
#include "demos/shell/shadow_map.h"
#include "demos/shell/shell.h"
#include "demos/shell/solids.h"

namespace {

constexpr float floor_half = 40;
constexpr int floor_cells = 100;
constexpr GLfloat air[] = {0.55f, 0.65f, 0.75f, 1};
constexpr shell::Vec3 lamp = {3.5f, 6, 4};

GLuint tiles = 0, wood = 0, chrome = 0, floor_list = 0, font = 0;
const shell::ShadowMap* shadow_map = nullptr;
bool reflects = true, shadows = true, foggy = true;
float clock_s = 0;
int height_px = 1;

GLuint make_texture(int size, shell::Color (*color_at)(float, float)) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  shell::upload_with_mipmaps(size, size, shell::make_image(size, size, color_at));
  return texture;
}

shell::Color floor_tile(float s, float t) {
  const bool joint = s < 0.02f || t < 0.02f || (s > 0.5f && s < 0.52f) || (t > 0.5f && t < 0.52f);
  return joint ? shell::Color{0.3f, 0.32f, 0.36f} : shell::checker(s, t, 2, {0.72f, 0.76f, 0.8f}, {0.45f, 0.52f, 0.6f});
}

shell::Color grain(float s, float t) {
  const float ring = std::sin(40 * (t + 0.05f * std::sin(9 * s)));
  return {0.62f + 0.12f * ring, 0.40f + 0.09f * ring, 0.22f + 0.06f * ring};
}

// Each face of the cube a gradient from dark below to light above, with a window of light on one of them.
GLuint make_chrome() {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_CUBE_MAP, texture);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  for (GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X; face <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z; ++face) {
    const auto texels = shell::make_image(64, 64, [face](float s, float t) {
      const bool window = face == GL_TEXTURE_CUBE_MAP_POSITIVE_Z && std::abs(s - 0.4f) < 0.2f && std::abs(t - 0.35f) < 0.2f;
      const float up = face == GL_TEXTURE_CUBE_MAP_POSITIVE_Y ? 1.0f : face == GL_TEXTURE_CUBE_MAP_NEGATIVE_Y ? 0.0f : 1 - t;
      const float light = window ? 1.0f : 0.25f + 0.6f * up;
      return shell::Color{light, light, 0.1f + 0.9f * light};
    });
    glTexImage2D(face, 0, GL_RGB, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  }
  return texture;
}

void init() {
  static const shell::ShadowMap map(2048);
  shadow_map = &map;
  tiles = make_texture(256, floor_tile);
  wood = make_texture(256, grain);
  chrome = make_chrome();
  font = shell::make_font(2);
  floor_list = glGenLists(1);
  glNewList(floor_list, GL_COMPILE);
  shell::ground(floor_half, floor_cells, 40);
  glEndList();

  const GLfloat ambient[] = {0.25f, 0.25f, 0.28f, 1}, warm[] = {0.75f, 0.7f, 0.6f, 1}, cool[] = {0.2f, 0.25f, 0.35f, 1};
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  glLightfv(GL_LIGHT0, GL_DIFFUSE, cool);
  glLightfv(GL_LIGHT1, GL_DIFFUSE, warm);
  glLightfv(GL_LIGHT1, GL_SPECULAR, warm);
  glLightf(GL_LIGHT1, GL_SPOT_CUTOFF, 40);
  glLightf(GL_LIGHT1, GL_SPOT_EXPONENT, 8);
  glEnable(GL_LIGHTING);
  glEnable(GL_COLOR_MATERIAL);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glEnable(GL_NORMALIZE);
  glDepthFunc(GL_LEQUAL);
  glFogfv(GL_FOG_COLOR, air);
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_START, 12);
  glFogf(GL_FOG_END, 36);
  glClearColor(air[0], air[1], air[2], 1);
}

void reshape(int width_px, int new_height_px) {
  height_px = new_height_px;
  shell::set_camera(width_px, new_height_px, 42, 0.5, 80);
}

void animate(double seconds) {
  clock_s = static_cast<float>(seconds);
}

void key(int key) {
  if (key == 'r') reflects = !reflects;
  if (key == 's') shadows = !shadows;
  if (key == 'f') foggy = !foggy;
}

void lamp_projection() {
  shell::perspective(80, 1, 2, 30);
}

void lamp_view() {
  shell::look_at(lamp, {0, 0.5f, 0}, {0, 1, 0});
}

void place_lights() {
  const GLfloat sky[] = {-0.4f, 1, 0.3f, 0}, at[] = {lamp.x, lamp.y, lamp.z, 1}, down[] = {-lamp.x, 0.5f - lamp.y, -lamp.z};
  glLightfv(GL_LIGHT0, GL_POSITION, sky);
  glLightfv(GL_LIGHT1, GL_POSITION, at);
  glLightfv(GL_LIGHT1, GL_SPOT_DIRECTION, down);
}

void chrome_ball() {
  constexpr GLenum coordinates[] = {GL_S, GL_T, GL_R};
  constexpr GLenum generators[] = {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R};
  glBindTexture(GL_TEXTURE_CUBE_MAP, chrome);
  glEnable(GL_TEXTURE_CUBE_MAP);
  for (int i = 0; i < 3; ++i) {
    glTexGeni(coordinates[i], GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP);
    glEnable(generators[i]);
  }
  glColor3f(0.9f, 0.9f, 0.95f);
  glPushMatrix();
  glTranslatef(0, 1.1f + 0.25f * std::sin(1.7f * clock_s), 0);
  shell::solid_sphere(0.9f, 64, 32);
  glPopMatrix();
  for (const GLenum generator : generators) glDisable(generator);
  glDisable(GL_TEXTURE_CUBE_MAP);
}

void wooden_boxes() {
  glBindTexture(GL_TEXTURE_2D, wood);
  glEnable(GL_TEXTURE_2D);
  glColor3f(1, 1, 1);
  for (int i = 0; i < 5; ++i) {
    glPushMatrix();
    glRotatef(72 * static_cast<float>(i) + 10 * clock_s, 0, 1, 0);
    glTranslatef(2.6f, 0.55f, 0);
    glRotatef(30 * clock_s, 0, 1, 0);
    shell::solid_box(0.9f, 1.1f, 0.9f);
    glPopMatrix();
  }
  glDisable(GL_TEXTURE_2D);
}

void ring() {
  const GLfloat shine[] = {0.8f, 0.8f, 0.8f, 1}, dull[] = {0, 0, 0, 1};
  glMaterialfv(GL_FRONT, GL_SPECULAR, shine);
  glMaterialf(GL_FRONT, GL_SHININESS, 60);
  glColor3f(0.8f, 0.2f, 0.15f);
  glPushMatrix();
  glTranslatef(0, 2.9f, 0);
  glRotatef(60 * clock_s, 1, 0.3f, 0);
  shell::solid_torus(0.15f, 0.8f, 24, 48);
  glPopMatrix();
  glMaterialfv(GL_FRONT, GL_SPECULAR, dull);
}

void bodies() {
  chrome_ball();
  wooden_boxes();
  ring();
}

// In the colour of the tiles, and where `alpha` is less than 1 blended over the reflection.
void tiled_floor(float alpha) {
  glBindTexture(GL_TEXTURE_2D, tiles);
  glEnable(GL_TEXTURE_2D);
  glColor4f(1, 1, 1, alpha);
  glCallList(floor_list);
  glDisable(GL_TEXTURE_2D);
}

void reflection() {
  const GLdouble above_the_floor[] = {0, 1, 0, 0};
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDepthMask(GL_FALSE);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, 1, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  glCallList(floor_list);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);

  glStencilFunc(GL_EQUAL, 1, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glPushMatrix();
  glScalef(1, -1, 1);
  place_lights();
  glClipPlane(GL_CLIP_PLANE0, above_the_floor);
  glEnable(GL_CLIP_PLANE0);
  glFrontFace(GL_CW);
  bodies();
  glFrontFace(GL_CCW);
  glDisable(GL_CLIP_PLANE0);
  glPopMatrix();
  glDisable(GL_STENCIL_TEST);
  place_lights();
}

// Without the lamp; then the lamp's light, and nothing else, where it reaches.
void lit_scene() {
  glEnable(GL_LIGHT0);
  glEnable(GL_LIGHT1);
  if (shadows) glDisable(GL_LIGHT1);
  if (reflects) reflection();
  if (reflects) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  }
  tiled_floor(reflects ? 0.75f : 1.0f);
  glDisable(GL_BLEND);
  bodies();
}

void lamp_light() {
  const GLfloat black[] = {0, 0, 0, 1}, ambient[] = {0.25f, 0.25f, 0.28f, 1};
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
  glFogfv(GL_FOG_COLOR, black);
  glDisable(GL_LIGHT0);
  glEnable(GL_LIGHT1);
  shadow_map->enable(lamp_projection, lamp_view);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  tiled_floor(1);
  bodies();
  glDisable(GL_BLEND);
  shadow_map->disable();
  glFogfv(GL_FOG_COLOR, air);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
}

void legend() {
  glDisable(GL_LIGHTING);
  glDisable(GL_FOG);
  glColor3f(0.1f, 0.1f, 0.15f);
  glWindowPos2i(10, height_px - 24);
  shell::draw_text(font, "reflection, shadow map, cube map, fog");
  glEnable(GL_LIGHTING);
}

void draw() {
  if (shadows) shadow_map->render(lamp_projection, lamp_view, bodies);
  foggy ? glEnable(GL_FOG) : glDisable(GL_FOG);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glLoadIdentity();
  shell::look_at({0, 3.2f, 9.5f}, {0, 1, 0}, {0, 1, 0});
  glRotatef(6 * clock_s, 0, 1, 0);
  place_lights();
  lit_scene();
  if (shadows) lamp_light();
  legend();
}

}  // namespace

int main(int argc, char** argv) {
  return shell::run(argc, argv,
                    {.name = "mirror",
                     .keys_help = "r switches the reflection, s the shadows, f the fog",
                     .width_px = 800,
                     .height_px = 600,
                     .init = init,
                     .reshape = reshape,
                     .animate = animate,
                     .key = key,
                     .draw = draw});
}
