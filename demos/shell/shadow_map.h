// A shadow map of ARB_depth_texture and ARB_shadow, drawn into through ARB_framebuffer_object.
#pragma once

namespace shell {

class ShadowMap {
 public:
  // A square depth texture of `size` texels and a framebuffer object that holds nothing else.
  explicit ShadowMap(int size);

  // Draws the casters as the light sees them. `set_projection` multiplies the light's projection, `set_view` its view onto
  // the current matrix, which is the identity. Viewport and framebuffer are as before afterwards.
  void render(void (*set_projection)(), void (*set_view)(), void (*draw_casters)()) const;

  // From here on texture unit 1 compares: fragments in shadow get 0, the others 1, times what unit 0 gave. Call it with
  // the camera's view, and nothing else, in the modelview matrix: the generated coordinates are fixed to the world.
  void enable(void (*set_projection)(), void (*set_view)()) const;
  void disable() const;

 private:
  int size_ = 0;
  unsigned texture_ = 0, framebuffer_ = 0;
};

}  // namespace shell
