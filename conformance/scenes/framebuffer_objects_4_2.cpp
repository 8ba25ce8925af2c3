// Framebuffer objects [ARB_framebuffer_object], multisampling [GL1.5 §3.2.1, §4.1.3] and clip control [ARB_clip_control].
//
// Pictures are drawn into textures first, and then the window shows them: the oracle judges that by the texels that ours
// holds, and llvmpipe the whole. The oracle does not follow blits: of those llvmpipe is the judge.
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/texture_shapes.h"

namespace gouraud::conformance {
namespace {

GLuint bind_framebuffer(const GlTable& gl) {
  GLuint name = 0;
  gl.GenFramebuffers(1, &name);
  gl.BindFramebuffer(GL_FRAMEBUFFER, name);
  return name;
}

GLuint attach_renderbuffer(const GlTable& gl, GLenum attachment, GLenum format, int samples, int side) {
  GLuint name = 0;
  gl.GenRenderbuffers(1, &name);
  gl.BindRenderbuffer(GL_RENDERBUFFER, name);
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, side, side);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
  return name;
}

/// What is drawn into the pictures: a ring over a ground of this colour.
void draw_ring(const GlTable& gl, int side, float hue) {
  gl.Viewport(0, 0, side, side);
  gl.ClearColor(hue, 0.6f - 0.5f * hue, 0.2f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  look(gl, {.distance = 3.1f, .pitch_deg = 40, .yaw_deg = 90 * hue});
  draw_surface(gl, torus(0.95f, 0.38f, 24, 12), [&](const Surface::Point& p) { gl.Color3f(p.u, 0.9f - 0.8f * hue, p.v); });
}

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

void begin_samples(const GlTable& gl) {
  bind_framebuffer(gl);
  attach_renderbuffer(gl, GL_COLOR_ATTACHMENT0, GL_RGBA8, 4, 256);
  attach_renderbuffer(gl, GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8, 4, 256);
  clear_background(gl);
}
void resolve(const GlTable& gl) {
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl.BlitFramebuffer(0, 0, 256, 256, 0, 0, 256, 256, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

void resolved_rings(const GlTable& gl) {
  begin_samples(gl);
  gl.Enable(GL_DEPTH_TEST);
  draw_ring(gl, 256, 0.3f);
  gl.MatrixMode(GL_MODELVIEW);
  gl.Rotatef(83, 1, 0.2f, 0);
  draw_surface(gl, torus(0.95f, 0.2f, 24, 12), [&](const Surface::Point& p) { gl.Color3f(0.2f, p.u, p.v); });
  resolve(gl);
}

// Fans whose corners lie close together.
void resolved_slivers(const GlTable& gl) {
  begin_samples(gl);
  pixel_space(gl, 256, 256);
  Random random(17);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 300; ++i) {
    color_of(gl, random);
    const float x = random.range(5, 250), y = random.range(5, 250);
    for (int k = 0; k < 3; ++k) {
      const float dx = random.range(-20, 20);
      gl.Vertex2f(x + dx, y + random.range(-6, 6));
    }
  }
  gl.End();
  resolve(gl);
}

// A fragment's texels, its alpha test and what it is blended with: the tests are about all of its samples or each.
void resolved_floor(const GlTable& gl) {
  begin_samples(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_TEXTURE_2D);
  noise_image(gl, GL_TEXTURE_2D, 0, GL_RGBA, 32, 32, GL_RGBA, 5);
  filters(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_GREATER, 0.25f);
  look(gl, {.distance = 2.4f, .pitch_deg = 35});
  textured_floor(gl, 2);
  gl.Disable(GL_ALPHA_TEST);
  gl.Disable(GL_TEXTURE_2D);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  draw_surface(gl, torus(0.7f, 0.3f, 24, 12), [&](const Surface::Point& p) { gl.Color4f(p.u, 1, p.v, 0.6f); });
  resolve(gl);
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
  constexpr auto buffers = "§4.2.1", samples = "§3.2.1";
  constexpr Judge oracle = Judge::oracle_only, llvmpipe = Judge::llvmpipe;
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
      {.name = "fbo_blits", .section = buffers, .shows = "Six copies of a ring: whole, mirrored, cut, smaller, doubled, in a box.", .judge = llvmpipe, .draw = blits},
      {.name = "fbo_resolved_rings", .section = samples, .shows = "Two rings through each other, smooth edges.", .judge = llvmpipe, .draw = resolved_rings},
      {.name = "fbo_resolved_slivers", .section = samples, .shows = "300 slivers with smooth edges.", .judge = llvmpipe, .draw = resolved_slivers},
      {.name = "fbo_resolved_floor", .section = samples, .shows = "A floor with holes and a pale ring, smooth edges.", .judge = llvmpipe, .draw = resolved_floor},
      {.name = "clip_control_upper_left", .section = "§2.11.1", .shows = "A ring upside down, cut by the near plane.", .judge = Judge::polygons, .draw = upper_left},
      {.name = "clip_control_zero_to_one", .section = "§2.11.1", .shows = "The ring, cut further away.", .judge = Judge::polygons, .draw = zero_to_one},
  };
}

}  // namespace gouraud::conformance
