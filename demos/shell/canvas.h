// A GL context that draws into memory of ours, through the OSMesa interface.
#pragma once

#include <GL/osmesa.h>

#include <cstdint>
#include <string>
#include <vector>

namespace shell {

class Canvas {
 public:
  // Makes the context, current in this thread, with a picture of the given size (pixels, each at least 1).
  // Throws std::runtime_error where the library cannot.
  Canvas(int width_px, int height_px);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  // A new picture of another size. What it shows is undefined until it is drawn.
  void resize(int width_px, int height_px);

  // Waits for the drawing to end; afterwards pixels() is the picture.
  // Throws std::runtime_error where the frame raised a GL error.
  void finish();

  // Four bytes a pixel: blue, green, red, alpha; the top row first; no padding.
  const std::vector<uint8_t>& pixels() const { return pixels_; }
  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }

 private:
  OSMesaContext context_ = nullptr;
  std::vector<uint8_t> pixels_;
  int width_px_ = 0;
  int height_px_ = 0;
};

}  // namespace shell
