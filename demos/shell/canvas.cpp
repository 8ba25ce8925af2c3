#include "demos/shell/canvas.h"

#include <GL/gl.h>

#include <cstdio>
#include <stdexcept>

namespace shell {
namespace {

constexpr int depth_bits = 24;
constexpr int stencil_bits = 8;
constexpr int accumulation_bits = 16;

}  // namespace

Canvas::Canvas(int width_px, int height_px)
    : context_(OSMesaCreateContextExt(OSMESA_BGRA, depth_bits, stencil_bits, accumulation_bits, nullptr)) {
  if (context_ == nullptr) throw std::runtime_error("no GL context could be made");
  resize(width_px, height_px);
  OSMesaPixelStore(OSMESA_Y_UP, 0);
}

Canvas::~Canvas() {
  OSMesaDestroyContext(context_);
}

void Canvas::resize(int width_px, int height_px) {
  if (!pixels_.empty()) glFinish();
  std::vector<uint8_t> fresh(static_cast<size_t>(width_px) * static_cast<size_t>(height_px) * 4);
  if (!OSMesaMakeCurrent(context_, fresh.data(), GL_UNSIGNED_BYTE, width_px, height_px)) {
    throw std::runtime_error("no picture of " + std::to_string(width_px) + "x" + std::to_string(height_px) +
                             " pixels could be made");
  }
  pixels_.swap(fresh);
  width_px_ = width_px;
  height_px_ = height_px;
}

void Canvas::finish() {
  glFinish();
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
    char text[64];
    std::snprintf(text, sizeof text, "drawing raised the GL error 0x%04x", error);
    throw std::runtime_error(text);
  }
}

}  // namespace shell
