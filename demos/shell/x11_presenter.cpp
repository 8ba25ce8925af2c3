#include "demos/shell/x11_presenter.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <stdexcept>

namespace shell {
namespace {

constexpr unsigned long red_mask = 0xff0000;
constexpr unsigned long green_mask = 0x00ff00;
constexpr unsigned long blue_mask = 0x0000ff;

}  // namespace

X11Presenter::X11Presenter(void* display, unsigned long window) : display_(display), window_(window) {
  auto* const xdisplay = static_cast<Display*>(display);
  XWindowAttributes attributes{};
  XGetWindowAttributes(xdisplay, window, &attributes);
  const Visual& visual = *attributes.visual;
  if (attributes.depth < 24 || visual.red_mask != red_mask || visual.green_mask != green_mask ||
      visual.blue_mask != blue_mask) {
    throw std::runtime_error("the display does not show 24-bit colour; --out FILE writes a PNG instead");
  }
  depth_bits_ = attributes.depth;
  graphics_context_ = XCreateGC(xdisplay, window, 0, nullptr);
}

X11Presenter::~X11Presenter() {
  XFreeGC(static_cast<Display*>(display_), static_cast<GC>(graphics_context_));
}

void X11Presenter::show(const std::vector<uint8_t>& pixels, int width_px, int height_px) {
  XImage image{};
  image.width = width_px;
  image.height = height_px;
  image.format = ZPixmap;
  image.data = const_cast<char*>(reinterpret_cast<const char*>(pixels.data()));  // Xlib only reads it
  image.byte_order = LSBFirst;
  image.bitmap_bit_order = LSBFirst;
  image.bitmap_unit = 32;
  image.bitmap_pad = 32;
  image.depth = depth_bits_;
  image.bits_per_pixel = 32;
  image.bytes_per_line = width_px * 4;
  image.red_mask = red_mask;
  image.green_mask = green_mask;
  image.blue_mask = blue_mask;
  XInitImage(&image);

  auto* const xdisplay = static_cast<Display*>(display_);
  XPutImage(xdisplay, window_, static_cast<GC>(graphics_context_), &image, 0, 0, 0, 0, static_cast<unsigned>(width_px),
            static_cast<unsigned>(height_px));
  XFlush(xdisplay);
}

}  // namespace shell
