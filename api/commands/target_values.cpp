#include "api/commands/target_values.h"

#include <algorithm>
#include <vector>

#include "pipeline/framebuffer/read.h"

namespace gouraud::api {

using pipeline::DepthFormat;

const char* missing_buffer(const pipeline::Framebuffer& target, PixelKind kind) {
  const bool has_depth = target.has_depth, has_stencil = target.stencil_bits != 0;
  switch (kind) {
    case PixelKind::color:
    case PixelKind::color_index: return nullptr;
    case PixelKind::depth: return has_depth ? nullptr : "there is no depth buffer";
    case PixelKind::stencil_index: return has_stencil ? nullptr : "there is no stencil buffer";
    case PixelKind::depth_stencil: return has_depth && has_stencil ? nullptr : "there are no depth and stencil buffers";
  }
  return nullptr;
}

void read_depths(const pipeline::Framebuffer& target, int x, int y, int count, double* depths) {
  if (target.depth_format == DepthFormat::z32f) {
    std::vector<float> floats(static_cast<std::size_t>(count));
    read_depth_row_float(target, x, y, count, floats.data());
    std::copy(floats.begin(), floats.end(), depths);
    return;
  }
  std::vector<std::uint32_t> units(static_cast<std::size_t>(count));
  read_depth_row(target, x, y, count, units.data());
  const auto most = static_cast<double>((std::uint64_t{1} << pipeline::depth_bits(target.depth_format)) - 1);
  std::transform(units.begin(), units.end(), depths, [most](std::uint32_t z) { return z / most; });
}

void read_stencils(const pipeline::Framebuffer& target, int x, int y, int count, std::uint32_t* stencils) {
  std::vector<std::uint8_t> values(static_cast<std::size_t>(count));
  read_stencil_row(target, x, y, count, values.data());
  std::copy(values.begin(), values.end(), stencils);
}

}  // namespace gouraud::api
