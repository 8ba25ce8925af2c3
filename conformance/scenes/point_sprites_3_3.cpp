// Point sprites: squares over which texture coordinates run [ARB_point_sprite].
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/texture_shapes.h"

namespace gouraud::conformance {
namespace {

void begin(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Enable(GL_POINT_SPRITE_ARB);
  gl.TexEnvi(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, GL_TRUE);
}

// Sizes of any fraction at places of any fraction; the vertices' own coordinates count for nothing.
void draw_sprites(const GlTable& gl, float first_size, float step) {
  Random random(77);
  for (int i = 0; i < 25; ++i) {
    gl.PointSize(first_size + step * static_cast<float>(i));
    gl.Begin(GL_POINTS);
    color_of(gl, random);
    gl.TexCoord4f(random.range(-3, 3), random.range(-3, 3), random.range(-3, 3), random.range(0.5f, 2));
    gl.Vertex2f(26.13f + 50.7f * static_cast<float>(i % 5), 26.41f + 50.3f * static_cast<float>(i / 5));
    gl.End();
  }
}

// A texture without symmetry: which corner is which can be seen.
template <GLint filter>
void textured(const GlTable& gl) {
  begin(gl);
  noise_image(gl, GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, GL_RGBA, 21);
  filters(gl, GL_TEXTURE_2D, filter, filter);
  gl.Enable(GL_TEXTURE_2D);
  draw_sprites(gl, 3.3f, 1.77f);
}

void mipmapped(const GlTable& gl) {
  begin(gl);
  colored_levels(gl, GL_TEXTURE_2D, 32);
  filters(gl, GL_TEXTURE_2D, GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
  environment_mode(gl, GL_REPLACE);
  draw_sprites(gl, 1.3f, 1.77f);
}

// The second unit keeps the vertex's coordinates, and a texture matrix moves them.
void one_unit_of_two(const GlTable& gl) {
  begin(gl);
  noise_image(gl, GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, GL_RGBA, 22);
  filters(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
  gl.ActiveTexture(GL_TEXTURE1);
  noise_image(gl, GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, GL_RGBA, 23);
  filters(gl, GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST);
  gl.Enable(GL_TEXTURE_2D);
  gl.MatrixMode(GL_TEXTURE);
  gl.Scalef(0.5f, 0.25f, 1);
  gl.MultiTexCoord2f(GL_TEXTURE1, 0.77f, 0.31f);
  draw_sprites(gl, 7.3f, 1.3f);
}

// r is 0 and q is 1, whatever the vertex says: the first slice, its half below the border.
void three_dimensional(const GlTable& gl) {
  begin(gl);
  const auto texels = noise(4 * 4 * 4 * 4, 24);
  gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  filters(gl, GL_TEXTURE_3D, GL_LINEAR, GL_LINEAR);
  wraps(gl, GL_TEXTURE_3D, GL_CLAMP_TO_EDGE);
  gl.Enable(GL_TEXTURE_3D);
  draw_sprites(gl, 9.1f, 1.4f);
}

// Particles that shrink with the distance and let what is behind show through.
void attenuated(const GlTable& gl) {
  clear_background(gl);
  look(gl, {.distance = 4.2f, .pitch_deg = 24});
  gl.Enable(GL_POINT_SPRITE_ARB);
  gl.TexEnvi(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, GL_TRUE);
  const auto texels = smooth_texels(16, 16, 4, 25);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  filters(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_GREATER, 0.23f);
  gl.Enable(GL_DEPTH_TEST);
  gl.PointSize(30);
  const float terms[3] = {5.3f, 0, 0};
  gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, terms);
  gl.Begin(GL_POINTS);
  for (const Surface::Point& point : torus(0.95f, 0.38f, 24, 8).points) {
    gl.Color4f(point.u * 0.9f, 0.3f, point.v * 0.9f, 0.6f);
    gl.Vertex3fv(point.position.data());
  }
  gl.End();
}

// The corners of polygons are points too; COORD_REPLACE without POINT_SPRITE is nothing; PopAttrib brings both back.
void polygon_corners_and_restored(const GlTable& gl) {
  begin(gl);
  noise_image(gl, GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, GL_RGBA, 26);
  filters(gl, GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST);
  gl.Enable(GL_TEXTURE_2D);
  gl.PointSize(23.4f);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
  textured_rectangle(gl, 40.3f, 30.7f, 100.1f, 90.9f, 0.1f, 0.1f, 0.9f, 0.9f);
  gl.PushAttrib(GL_POINT_BIT);
  gl.Disable(GL_POINT_SPRITE_ARB);
  textured_rectangle(gl, 140.3f, 30.7f, 200.1f, 90.9f, 0.1f, 0.1f, 0.9f, 0.9f);
  gl.PopAttrib();
  gl.PushAttrib(GL_POINT_BIT);
  gl.TexEnvi(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, GL_FALSE);
  textured_rectangle(gl, 40.3f, 130.7f, 100.1f, 190.9f, 0.1f, 0.1f, 0.9f, 0.9f);
  gl.PopAttrib();
  textured_rectangle(gl, 140.3f, 130.7f, 200.1f, 190.9f, 0.1f, 0.1f, 0.9f, 0.9f);
}

}  // namespace

SceneList point_sprite_scenes() {
  constexpr auto section = "§3.3";
  constexpr auto judge = Judge::lines_and_points;
  return {
      {.name = "point_sprites_nearest", .section = section, .shows = "Squares that all show the same 64 texels.", .judge = judge, .draw = textured<GL_NEAREST>},
      {.name = "point_sprites_linear", .section = section, .shows = "The same, blurred.", .judge = judge, .draw = textured<GL_LINEAR>},
      {.name = "point_sprites_mipmapped", .section = section, .shows = "Squares whose level goes with their size.", .judge = Judge::oracle_only, .draw = mipmapped},
      {.name = "point_sprites_one_unit_of_two", .section = section, .shows = "Squares of texels, each times one texel of another texture.", .judge = judge, .draw = one_unit_of_two},
      {.name = "point_sprites_3d", .section = section, .shows = "Squares of the first slice of a texture.", .judge = judge, .draw = three_dimensional},
      {.name = "point_sprites_attenuated", .section = section, .shows = "A ring of ragged particles.", .judge = judge, .draw = attenuated},
      {.name = "point_sprites_corners", .section = section, .shows = "Four squares' corners, those left below and right above as sprites.", .judge = judge, .draw = polygon_corners_and_restored},
  };
}

}  // namespace gouraud::conformance
