// Framebuffer objects [ARB_framebuffer_object] and clip control [ARB_clip_control].
//
// Pictures are drawn into textures first, and then the window shows them: the oracle judges that by the texels that ours
// holds, and llvmpipe the whole. The oracle follows blits.
#include "conformance/scenes/framebuffer_shapes.h"
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/texture_shapes.h"

namespace gouraud::conformance {
namespace {

void back_to_the_window(const GlTable& gl) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.Viewport(0, 0, 256, 256);
  gl.Disable(GL_DEPTH_TEST);
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.LoadIdentity();
  environment_mode(gl, GL_REPLACE);
}

void turned_rectangle(const GlTable& gl) {
  gl.Begin(GL_QUADS);
  gl.TexCoord2f(-0.1f, -0.1f);
  gl.Vertex2f(30.3f, 12.7f);
  gl.TexCoord2f(1.2f, -0.05f);
  gl.Vertex2f(240.1f, 40.2f);
  gl.TexCoord2f(1.1f, 1.15f);
  gl.Vertex2f(222.9f, 245.6f);
  gl.TexCoord2f(-0.15f, 1.05f);
  gl.Vertex2f(8.4f, 218.8f);
  gl.End();
}

// A picture of colours, with depth behind it, as a texture.
template <GLint format>
void render_to_texture(const GlTable& gl) {
  bind_framebuffer(gl);
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, format, 100, 100, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  filters(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  attach_renderbuffer(gl, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, 0, 100);
  gl.Enable(GL_DEPTH_TEST);
  draw_ring(gl, 100, 0.3f);
  back_to_the_window(gl);
  gl.Enable(GL_TEXTURE_2D);
  turned_rectangle(gl);
}

// The depths of a picture without colours.
void render_depths(const GlTable& gl) {
  bind_framebuffer(gl);
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, 100, 100, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, nullptr);
  filters(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  gl.Enable(GL_DEPTH_TEST);
  draw_ring(gl, 100, 0.3f);
  back_to_the_window(gl);
  gl.Enable(GL_TEXTURE_2D);
  turned_rectangle(gl);
}

// Every level is a picture of its own.
void render_to_levels(const GlTable& gl) {
  bind_framebuffer(gl);
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  int level = 0;
  for (int side = 128; side > 0; side /= 2) gl.TexImage2D(GL_TEXTURE_2D, level++, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  filters(gl, GL_TEXTURE_2D, GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR);
  level = 0;
  for (int side = 128; side > 0; side /= 2, ++level) {
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, level);
    draw_ring(gl, side, 0.12f * static_cast<float>(level));
  }
  back_to_the_window(gl);
  gl.Enable(GL_TEXTURE_2D);
  textured_floor(gl, 4);
}

// The levels behind the first are made of what was drawn into that.
void generated_levels(const GlTable& gl) {
  bind_framebuffer(gl);
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 128, 128, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  filters(gl, GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  draw_ring(gl, 128, 0.4f);
  gl.GenerateMipmap(GL_TEXTURE_2D);
  back_to_the_window(gl);
  gl.Enable(GL_TEXTURE_2D);
  textured_floor(gl, 4);
}

void render_to_cube_faces(const GlTable& gl) {
  bind_framebuffer(gl);
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, texture);
  for (GLenum face = 0; face < 6; ++face) {
    gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  }
  filters(gl, GL_TEXTURE_CUBE_MAP, GL_LINEAR, GL_LINEAR);
  for (GLenum face = 0; face < 6; ++face) {
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, texture, 0);
    draw_ring(gl, 64, 0.15f * static_cast<float>(face));
  }
  back_to_the_window(gl);
  gl.Enable(GL_TEXTURE_CUBE_MAP);
  gl.Enable(GL_CULL_FACE);
  for (const GLenum coordinate : {GL_S, GL_T, GL_R}) {
    gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP);
    gl.Enable(GL_TEXTURE_GEN_S + (coordinate - GL_S));
  }
  look(gl, {.distance = 4});
  draw_surface(gl, sphere(1.2f, 24, 24));
}

void render_to_slices(const GlTable& gl) {
  bind_framebuffer(gl);
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_3D, texture);
  gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, 80, 80, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  filters(gl, GL_TEXTURE_3D, GL_LINEAR, GL_LINEAR);
  wraps(gl, GL_TEXTURE_3D, GL_CLAMP_TO_EDGE);
  for (int slice = 0; slice < 4; ++slice) {
    gl.FramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_3D, texture, 0, slice);
    draw_ring(gl, 80, 0.3f * static_cast<float>(slice));
  }
  back_to_the_window(gl);
  gl.Enable(GL_TEXTURE_3D);
  gl.Begin(GL_QUADS);
  gl.TexCoord3f(0, 0, 0.1f);
  gl.Vertex2f(10.2f, 10.4f);
  gl.TexCoord3f(1, 0, 0.3f);
  gl.Vertex2f(244.6f, 14.8f);
  gl.TexCoord3f(1, 1, 0.95f);
  gl.Vertex2f(248.1f, 250.3f);
  gl.TexCoord3f(0, 1, 0.7f);
  gl.Vertex2f(6.7f, 241.9f);
  gl.End();
}

// Copies of one picture: the same size, cut, mirrored, smaller and larger.
void blits(const GlTable& gl) {
  bind_framebuffer(gl);
  attach_renderbuffer(gl, GL_COLOR_ATTACHMENT0, GL_RGBA8, 0, 100);
  attach_renderbuffer(gl, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, 0, 100);
  gl.Enable(GL_DEPTH_TEST);
  draw_ring(gl, 100, 0.3f);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  clear_background(gl);
  const auto blit = [&](int x0, int y0, int x1, int y1, GLenum filter) {
    gl.BlitFramebuffer(0, 0, 100, 100, x0, y0, x1, y1, GL_COLOR_BUFFER_BIT, filter);
  };
  blit(10, 10, 110, 110, GL_NEAREST);
  blit(240, 110, 140, 10, GL_NEAREST);
  blit(-30, 130, 70, 230, GL_LINEAR);
  blit(90, 130, 146, 186, GL_NEAREST);  // no centre between two texels
  blit(150, 130, 350, 330, GL_NEAREST);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(90, 192, 40, 40);
  blit(80, 185, 180, 285, GL_NEAREST);
  gl.Disable(GL_SCISSOR_TEST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

// All parts of depth and stencil: the same size, cut, mirrored, and stretched to odd sizes.
void blits_of_depths(const GlTable& gl) {
  bind_framebuffer(gl);
  attach_renderbuffer(gl, GL_COLOR_ATTACHMENT0, GL_RGBA8, 0, 100);
  attach_renderbuffer(gl, GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8, 0, 100);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_STENCIL_TEST);
  gl.ClearStencil(0);
  gl.Clear(GL_STENCIL_BUFFER_BIT);
  gl.StencilFunc(GL_ALWAYS, 1, 0xFF);
  gl.StencilOp(GL_KEEP, GL_INCR, GL_INCR);
  draw_ring(gl, 100, 0.3f);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  clear_background(gl);
  gl.Clear(GL_STENCIL_BUFFER_BIT);
  constexpr GLbitfield both = GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
  gl.BlitFramebuffer(0, 0, 100, 100, 10, 10, 110, 110, both, GL_NEAREST);
  gl.BlitFramebuffer(0, 0, 100, 100, 240, 120, 120, 20, both, GL_NEAREST);
  gl.BlitFramebuffer(20, 100, 95, 7, 6, 130, 83, 249, both, GL_NEAREST);
  gl.BlitFramebuffer(0, 0, 100, 100, 100, 130, 240, 240, GL_STENCIL_BUFFER_BIT, GL_NEAREST);
  // Colours where one, two and more fragments met, and everywhere a little in front of the farthest.
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.Viewport(0, 0, 256, 256);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  gl.DepthMask(GL_FALSE);
  pixel_space(gl, 256, 256);
  gl.LoadIdentity();
  for (int count = 1; count < 4; ++count) {
    gl.StencilFunc(count == 3 ? GL_LEQUAL : GL_EQUAL, count, 0xFF);
    gl.Color3f(0.3f * static_cast<float>(count), 0.8f, 0.2f);
    draw_rectangle(gl, 0, 0, 256, 256, 0.9f);
  }
}

// Interpolated copies: larger, smaller, of a part, mirrored, reaching out of the source.
void interpolated_blits(const GlTable& gl) {
  bind_framebuffer(gl);
  attach_renderbuffer(gl, GL_COLOR_ATTACHMENT0, GL_RGBA8, 0, 100);
  attach_renderbuffer(gl, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, 0, 100);
  gl.Enable(GL_DEPTH_TEST);
  draw_ring(gl, 100, 0.3f);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  clear_background(gl);
  const auto blit = [&](int sx0, int sy0, int sx1, int sy1, int x0, int y0, int x1, int y1) {
    gl.BlitFramebuffer(sx0, sy0, sx1, sy1, x0, y0, x1, y1, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  };
  blit(0, 0, 100, 100, 3, 3, 124, 141);
  blit(0, 0, 100, 100, 253, 120, 130, 4);
  blit(10, 20, 41, 52, 5, 150, 120, 250);
  blit(100, 0, 0, 100, 130, 150, 181, 193);
  blit(0, 0, 100, 100, 190, 150, 223, 183);
  blit(-20, -20, 30, 30, 190, 190, 250, 250);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

void clip_control(const GlTable& gl, GLenum origin, GLenum depth, float near) {
  clear_background(gl);
  gl.ClipControl(origin, depth);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_CULL_FACE);
  look(gl, {.distance = 3.1f, .pitch_deg = 40, .near = near});
  draw_surface(gl, torus(0.95f, 0.38f, 40, 20), [&](const Surface::Point& p) { gl.Color3f(p.u, 0.6f, p.v); });
}
void upper_left(const GlTable& gl) { clip_control(gl, GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE, 2.7f); }
void zero_to_one(const GlTable& gl) { clip_control(gl, GL_LOWER_LEFT, GL_ZERO_TO_ONE, 1.9f); }

}  // namespace

SceneList framebuffer_object_scenes() {
  constexpr auto buffers = "§4.2.1";
  constexpr Judge oracle = Judge::oracle_only, both = Judge::textures;
  return {
      {.name = "fbo_texture", .section = buffers, .shows = "A turned picture of a ring, repeated at its edges.", .judge = Judge::textures, .draw = render_to_texture<GL_RGBA8>},
      {.name = "fbo_texture_rgb", .section = buffers, .shows = "The same without alpha.", .judge = Judge::textures, .draw = render_to_texture<GL_RGB8>},
      {.name = "fbo_texture_luminance", .section = buffers, .shows = "The ring's red as luminance.", .judge = Judge::textures, .draw = render_to_texture<GL_LUMINANCE8>},
      {.name = "fbo_texture_luminance_alpha", .section = buffers, .shows = "The same with alpha.", .judge = Judge::textures, .draw = render_to_texture<GL_LUMINANCE8_ALPHA8>},
      {.name = "fbo_texture_intensity", .section = buffers, .shows = "The ring's red as intensity.", .judge = Judge::textures, .draw = render_to_texture<GL_INTENSITY8>},
      {.name = "fbo_depths", .section = buffers, .shows = "The ring's depths in shades of grey.", .judge = oracle, .draw = render_depths},
      {.name = "fbo_levels", .section = buffers, .shows = "A floor of rings, another ground a level.", .judge = oracle, .draw = render_to_levels},
      {.name = "fbo_generated_levels", .section = buffers, .shows = "A floor of rings that blur into the distance.", .judge = oracle, .draw = generated_levels},
      {.name = "fbo_cube_faces", .section = buffers, .shows = "A ball that shows a ring in each direction.", .judge = oracle, .draw = render_to_cube_faces},
      {.name = "fbo_slices", .section = buffers, .shows = "A slope through four pictures of a ring.", .judge = oracle, .draw = render_to_slices},
      {.name = "fbo_blits", .section = buffers, .shows = "Six copies of a ring: whole, mirrored, cut, smaller, doubled, in a box.", .judge = both, .draw = blits},
      {.name = "fbo_blits_of_depths", .section = buffers, .shows = "Three rings by their depths and stencils, and the stencil of a fourth.", .judge = oracle, .draw = blits_of_depths},
      {.name = "fbo_blits_interpolated", .section = buffers, .shows = "Six copies of a ring: larger, mirrored, a part, smaller, beyond its edge.", .judge = oracle, .draw = interpolated_blits},
      {.name = "clip_control_upper_left", .section = "§2.11.1", .shows = "A ring upside down, cut by the near plane.", .judge = Judge::polygons, .draw = upper_left},
      {.name = "clip_control_zero_to_one", .section = "§2.11.1", .shows = "The ring, cut further away.", .judge = Judge::polygons, .draw = zero_to_one},
  };
}

}  // namespace gouraud::conformance
