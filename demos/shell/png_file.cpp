#include "demos/shell/png_file.h"

#include <png.h>

#include <stdexcept>

namespace shell {

void write_png(const Canvas& canvas, const std::string& file) {
  const std::vector<uint8_t>& bgra = canvas.pixels();
  std::vector<uint8_t> bgr;
  bgr.reserve(bgra.size() / 4 * 3);
  for (size_t i = 0; i < bgra.size(); i += 4) bgr.insert(bgr.end(), &bgra[i], &bgra[i] + 3);

  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(canvas.width_px());
  image.height = static_cast<png_uint_32>(canvas.height_px());
  image.format = PNG_FORMAT_BGR;
  if (!png_image_write_to_file(&image, file.c_str(), 0, bgr.data(), 0, nullptr)) {
    throw std::runtime_error("cannot write " + file + ": " + image.message);
  }
}

}  // namespace shell
