#include "conformance/scenes/framebuffer_shapes.h"

#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {

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

void draw_ring(const GlTable& gl, int side, float hue) {
  gl.Viewport(0, 0, side, side);
  gl.ClearColor(hue, 0.6f - 0.5f * hue, 0.2f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  look(gl, {.distance = 3.1f, .pitch_deg = 40, .yaw_deg = 90 * hue});
  draw_surface(gl, torus(0.95f, 0.38f, 24, 12), [&](const Surface::Point& p) { gl.Color3f(p.u, 0.9f - 0.8f * hue, p.v); });
}

}  // namespace gouraud::conformance
