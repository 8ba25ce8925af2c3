// The narrow waist: every rasterizer makes FragmentBlocks, and nothing after it knows which one did.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace gouraud::pipeline {

/// What the passes do with a block, by the keys of the kernels that exist (their own small keys, not a product).
struct FragmentPasses {
  std::uint8_t depth = 0;
  std::uint8_t color = 0;
  bool operator==(const FragmentPasses&) const = default;
};

}  // namespace gouraud::pipeline
