// Multisampling [GL1.5 §3.2.1, §3.3.3, §3.4.4, §3.5.6, §4.1.3]: four samples a pixel, resolved by a blit [EXT_framebuffer_multisample].
//
// The oracle judges: polygons by the samples' own places, lines as rectangles, points as discs. Mesa draws lines and points
// otherwise, so that its pictures of those are reported only.

#include "conformance/scenes/framebuffer_shapes.h"
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/texture_shapes.h"

namespace gouraud::conformance {
namespace {

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

void lines_and_points(const GlTable& gl) {
  begin_samples(gl);
  pixel_space(gl, 256, 256);
}

// A fan of each of three widths.
void resolved_lines(const GlTable& gl) {
  lines_and_points(gl);
  Random random(23);
  for (int fan = 0; fan < 3; ++fan) {
    const float x = fan == 1 ? 180.3f : 70.6f, y = 50.0f + 70.0f * static_cast<float>(fan);
    gl.LineWidth(1.0f + 1.7f * static_cast<float>(fan));
    for (int i = 0; i < 24; ++i) {
      gl.Begin(GL_LINES);
      color_of(gl, random);
      const float dx = random.range(-65, 70), dy = random.range(-45, 60);
      gl.Vertex2f(x + 0.2f * dx, y + 0.2f * dy);
      color_of(gl, random);
      gl.Vertex2f(x + dx, y + dy);
      gl.End();
    }
  }
  resolve(gl);
}

void resolved_stipples(const GlTable& gl) {
  lines_and_points(gl);
  gl.Enable(GL_LINE_STIPPLE);
  gl.LineWidth(3.0f);
  for (int i = 0; i < 12; ++i) {
    gl.LineStipple(1 + i % 3, static_cast<GLushort>(0x3F17 + 0x421 * i));
    gl.Color3f(0.08f * static_cast<float>(i), 0.9f, 0.4f);
    gl.Begin(GL_LINE_STRIP);
    gl.Vertex2f(10.3f, 6.2f + 20.0f * static_cast<float>(i));
    gl.Vertex2f(120.9f, 21.7f + 19.0f * static_cast<float>(i));
    gl.Vertex2f(243.1f, 9.4f + 20.3f * static_cast<float>(i));
    gl.End();
  }
  resolve(gl);
}

// The outlines of a ring, a little in front of its faces.
void resolved_outlines(const GlTable& gl) {
  begin_samples(gl);
  gl.Enable(GL_DEPTH_TEST);
  draw_ring(gl, 256, 0.3f);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  gl.Enable(GL_POLYGON_OFFSET_LINE);
  gl.PolygonOffset(-1.0f, -4.0f);
  gl.Color3f(1, 1, 0.8f);
  draw_surface(gl, torus(0.95f, 0.38f, 24, 12));
  resolve(gl);
}

void resolved_points(const GlTable& gl) {
  lines_and_points(gl);
  Random random(31);
  for (int i = 0; i < 250; ++i) {
    color_of(gl, random);
    gl.PointSize(random.range(0.6f, 14.0f));
    const float x = random.range(6, 250);
    gl.Begin(GL_POINTS);
    gl.Vertex2f(x, random.range(6, 250));
    gl.End();
  }
  resolve(gl);
}

// Points that are smaller than the threshold fade.
void resolved_fading_points(const GlTable& gl) {
  lines_and_points(gl);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl.PointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 6.0f);
  Random random(37);
  for (int i = 0; i < 150; ++i) {
    color_of(gl, random);
    gl.PointSize(random.range(1.5f, 9.0f));
    const float x = random.range(6, 250);
    gl.Begin(GL_POINTS);
    gl.Vertex2f(x, random.range(6, 250));
    gl.End();
  }
  resolve(gl);
}

void resolved_sprites(const GlTable& gl) {
  lines_and_points(gl);
  gl.Enable(GL_TEXTURE_2D);
  noise_image(gl, GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, GL_RGBA, 5);
  filters(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
  wraps(gl, GL_TEXTURE_2D, GL_CLAMP_TO_EDGE);
  environment_mode(gl, GL_REPLACE);
  gl.Enable(GL_POINT_SPRITE_ARB);
  gl.TexEnvi(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, GL_TRUE);
  Random random(41);
  for (int i = 0; i < 30; ++i) {
    gl.PointSize(random.range(5.0f, 40.0f));
    const float x = random.range(25, 230);
    gl.Begin(GL_POINTS);
    gl.Vertex2f(x, random.range(25, 230));
    gl.End();
  }
  resolve(gl);
}

// What alpha leaves of the samples: a floor of smooth holes, opaque where it is drawn at all.
template <bool to_one>
void alpha_to_coverage(const GlTable& gl) {
  begin_samples(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  if (to_one) gl.Enable(GL_SAMPLE_ALPHA_TO_ONE);
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_GREATER, 0.6f);
  if (to_one) gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE);
  gl.Enable(GL_TEXTURE_2D);
  const std::vector<std::uint8_t> texels = smooth_texels(32, 32, 4, 3);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  filters(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
  environment_mode(gl, GL_REPLACE);
  look(gl, {.distance = 2.4f, .pitch_deg = 55});
  draw_surface(gl, floor_grid(2.2f, 1), [&](const Surface::Point& p) { gl.TexCoord2f(1.5f * p.u, 1.5f * p.v); });
  gl.Disable(GL_TEXTURE_2D);
  draw_surface(gl, torus(0.7f, 0.3f, 24, 12), [&](const Surface::Point& p) { gl.Color4f(0.9f, 0.3f, p.u, p.v); });
  resolve(gl);
}

// Shares of the samples, by value and inverted; what is left of a pixel stays.
void sample_coverage(const GlTable& gl) {
  begin_samples(gl);
  gl.Enable(GL_SAMPLE_COVERAGE);
  pixel_space(gl, 256, 256);
  for (int i = 0; i < 18; ++i) {
    gl.SampleCoverage(static_cast<float>(i % 9) / 8.0f, i >= 9 ? GL_TRUE : GL_FALSE);
    const float x = 16.3f + 24.0f * static_cast<float>(i % 9), y = i >= 9 ? 140.4f : 20.7f;
    gl.Color3f(0.1f * static_cast<float>(i % 9), 0.8f, i >= 9 ? 0.9f : 0.1f);
    gl.Begin(GL_TRIANGLES);
    gl.Vertex2f(x, y);
    gl.Vertex2f(x + 29.2f, y + 17.4f);
    gl.Vertex2f(x + 8.1f, y + 90.9f);
    gl.End();
  }
  resolve(gl);
}

// Without multisampling every sample has the pixel's centre; smooth lines, points and polygons are smooth.
void samples_together(const GlTable& gl) {
  begin_samples(gl);
  gl.Disable(GL_MULTISAMPLE);
  pixel_space(gl, 256, 256);
  Random random(47);
  for (int pass = 0; pass < 2; ++pass) {
    if (pass == 1) {
      for (const GLenum cap : {GL_BLEND, GL_POINT_SMOOTH, GL_LINE_SMOOTH, GL_POLYGON_SMOOTH}) gl.Enable(cap);
      gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    }
    gl.PointSize(9);
    gl.LineWidth(3);
    for (const GLenum mode : {GL_TRIANGLES, GL_LINES, GL_POINTS}) {
      gl.Begin(mode);
      for (int i = 0; i < 36; ++i) {
        if (mode != GL_TRIANGLES || i % 3 == 0) color_of(gl, random);
        const float x = random.range(8, 120);
        gl.Vertex2f(x + 128.0f * static_cast<float>(pass), random.range(8, 248));
      }
      gl.End();
    }
  }
  resolve(gl);
}

// Longer than a batch of vertices: nothing shows where it was cut, smooth without multisampling and sampled with it.
template <bool multisampled>
void resolved_long_polygons(const GlTable& gl) {
  begin_samples(gl);
  pixel_space(gl, 256, 256);
  if (!multisampled) gl.Disable(GL_MULTISAMPLE);
  gl.Enable(GL_POLYGON_SMOOTH);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  polygon_rings(gl, 2500);
  resolve(gl);
}

// Bitmaps and images have all samples of their pixels; triangles beneath and above.
void resolved_images(const GlTable& gl) {
  begin_samples(gl);
  pixel_space(gl, 256, 256);
  Random random(53);
  const std::vector<std::uint8_t> pixels = smooth_texels(60, 50, 4, 9), bits = noise(8 * 64, 4);
  for (int i = 0; i < 3; ++i) {
    gl.Begin(GL_TRIANGLES);
    for (int k = 0; k < 12; ++k) {
      color_of(gl, random);
      const float x = random.range(8, 248);
      gl.Vertex2f(x, random.range(8, 248));
    }
    gl.End();
    gl.RasterPos2f(20.0f + 70.0f * static_cast<float>(i), 30.5f);
    gl.DrawPixels(60, 50, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    gl.RasterPos2f(150.2f - 60.0f * static_cast<float>(i), 150.8f);
    gl.Bitmap(64, 64, 0, 0, 0, 0, bits.data());
  }
  resolve(gl);
}

// A part, moved and mirrored, and another sample's depth and stencil with it.
void resolved_parts(const GlTable& gl) {
  begin_samples(gl);
  gl.Enable(GL_DEPTH_TEST);
  draw_ring(gl, 256, 0.3f);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl.BlitFramebuffer(30, 40, 150, 170, 5, 7, 125, 137, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  gl.BlitFramebuffer(90, 40, 210, 170, 250, 135, 130, 5, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.BlitFramebuffer(30, 80, 230, 180, 220, 150, 20, 250, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

// A copy with all its samples, drawn on, and a picture of one sample that gets four.
void samples_to_samples(const GlTable& gl) {
  begin_samples(gl);
  gl.Enable(GL_DEPTH_TEST);
  draw_ring(gl, 256, 0.3f);
  GLint first = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &first);
  begin_samples(gl);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(first));
  gl.BlitFramebuffer(0, 0, 256, 256, 0, 0, 256, 256, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  gl.MatrixMode(GL_MODELVIEW);
  gl.Rotatef(83, 1, 0.2f, 0);
  draw_surface(gl, torus(0.95f, 0.2f, 24, 12), [&](const Surface::Point& p) { gl.Color3f(0.2f, p.u, p.v); });
  GLint second = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &second);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(second));
  resolve(gl);
}

// Faces that look this way are filled, those behind are points.
void resolved_faces_by_mode(const GlTable& gl) {
  begin_samples(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.PolygonMode(GL_FRONT, GL_FILL);
  gl.PolygonMode(GL_BACK, GL_POINT);
  gl.PointSize(3.7f);
  look(gl, {.distance = 2.6f, .pitch_deg = 40, .yaw_deg = 27});
  draw_surface(gl, half_pipe(0.8f, 1.6f, 9, 9), [&](const Surface::Point& p) { gl.Color3f(p.u, 0.63f, p.v); });
  gl.MatrixMode(GL_MODELVIEW);
  gl.Rotatef(150, 0, 1, 0);
  draw_surface(gl, half_pipe(0.5f, 1.8f, 9, 9), [&](const Surface::Point& p) { gl.Color3f(0.2f, p.u, p.v); });
  resolve(gl);
}

// Thousands of triangles of a few samples each.
void resolved_fine_mesh(const GlTable& gl) {
  begin_samples(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 3.1f, .pitch_deg = 40, .yaw_deg = 27});
  draw_surface(gl, torus(0.95f, 0.38f, 120, 60), [&](const Surface::Point& p) { gl.Color3f(p.u, 0.63f, p.v); });
  resolve(gl);
}

}  // namespace

SceneList multisampling_scenes() {
  constexpr auto samples = "§3.2.1", operations = "§4.1.3";
  constexpr Judge oracle = Judge::oracle_only;
  return {
      {.name = "fbo_resolved_rings", .section = "§3.2.1", .shows = "Two rings through each other, smooth edges.", .judge = Judge::textures, .draw = resolved_rings},
      {.name = "fbo_resolved_slivers", .section = "§3.2.1", .shows = "300 slivers with smooth edges.", .judge = Judge::textures, .draw = resolved_slivers},
      {.name = "fbo_resolved_floor", .section = "§3.2.1", .shows = "A floor with holes and a pale ring, smooth edges.", .judge = Judge::textures, .draw = resolved_floor},
      {.name = "fbo_resolved_faces_by_mode", .section = "§3.5.6", .shows = "Two gutters whose backs are dots.", .judge = oracle, .draw = resolved_faces_by_mode},
      {.name = "fbo_resolved_fine_mesh", .section = "§3.5.6", .shows = "A ring of thousands of triangles.", .judge = oracle, .draw = resolved_fine_mesh},
      {.name = "fbo_resolved_lines", .section = "§3.4.4", .shows = "Three fans of lines, wider each.", .judge = oracle, .draw = resolved_lines},
      {.name = "fbo_resolved_stipples", .section = "§3.4.4", .shows = "Twelve bent lines of dashes.", .judge = oracle, .draw = resolved_stipples},
      {.name = "fbo_resolved_outlines", .section = "§3.4.4", .shows = "A ring with the outlines of its faces.", .judge = oracle, .draw = resolved_outlines},
      {.name = "fbo_resolved_points", .section = "§3.3.3", .shows = "250 discs of many sizes.", .judge = oracle, .draw = resolved_points},
      {.name = "fbo_resolved_fading_points", .section = "§3.3", .shows = "150 discs, the small ones pale.", .judge = oracle, .draw = resolved_fading_points},
      {.name = "fbo_resolved_sprites", .section = "§3.3.3", .shows = "30 squares with a picture.", .judge = oracle, .draw = resolved_sprites},
      {.name = "fbo_alpha_to_coverage", .section = operations, .shows = "A floor and a ring that fade in five steps.", .judge = oracle, .draw = alpha_to_coverage<false>},
      {.name = "fbo_alpha_to_one", .section = operations, .shows = "The same, glowing.", .judge = oracle, .draw = alpha_to_coverage<true>},
      {.name = "fbo_sample_coverage", .section = operations, .shows = "Two rows of triangles, paler and paler, and the other way.", .judge = oracle, .draw = sample_coverage},
      {.name = "fbo_samples_together", .section = samples, .shows = "Triangles, lines and points with jagged edges on the left, smooth ones on the right.", .judge = oracle, .draw = samples_together},
      {.name = "fbo_smooth_polygons_long", .section = samples, .shows = "Two discs of 2500 corners with smooth edges, without a seam.", .judge = oracle, .draw = resolved_long_polygons<false>},
      {.name = "fbo_sampled_polygons_long", .section = "§3.5.6", .shows = "The discs with sampled edges: smooth means nothing.", .judge = oracle, .draw = resolved_long_polygons<true>},
      {.name = "fbo_resolved_images", .section = samples, .shows = "Triangles, images and bitmaps over each other.", .judge = oracle, .draw = resolved_images},
      {.name = "fbo_resolved_parts", .section = samples, .shows = "Three parts of a ring, one turned around, one mirrored.", .judge = oracle, .draw = resolved_parts},
      {.name = "fbo_samples_to_samples", .section = samples, .shows = "Two rings through each other.", .judge = oracle, .draw = samples_to_samples},
  };
}

}  // namespace gouraud::conformance
