// Puts a picture that lies in memory into an X11 window.
// choice: GLFW opens the window without any client API and we send the pixels with XPutImage. GLFW's own OSMesa
// contexts draw into memory but never show it (its swap does nothing in 3.3), and a GLX or EGL window would show our
// picture through the system's OpenGL, which is what these demos exist to do without. XPutImage needs only the core
// protocol, so it works on Xvfb, on XWayland and over a network; the shared-memory extension would save one copy.
#pragma once

#include <cstdint>
#include <vector>

namespace shell {

class X11Presenter {
 public:
  // `display` is a Display*, `window` a Window of Xlib, whose macros stay out of this header. Both outlive this.
  // Throws std::runtime_error where the window's pixels are not 8-bit red, green and blue in 32 bits.
  X11Presenter(void* display, unsigned long window);
  ~X11Presenter();
  X11Presenter(const X11Presenter&) = delete;
  X11Presenter& operator=(const X11Presenter&) = delete;

  // Shows width_px * height_px pixels of blue, green, red and an unused byte, the top row first.
  void show(const std::vector<uint8_t>& pixels, int width_px, int height_px);

 private:
  void* display_;
  unsigned long window_;
  void* graphics_context_;
  int depth_bits_ = 0;
};

}  // namespace shell
