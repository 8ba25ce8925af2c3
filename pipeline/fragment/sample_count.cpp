// Takes a block behind the depth test, gives it on as it is, and its number of fragments to the counter [GL1.5 §4.1.7].
#include "pipeline/fragment/sample_count.h"

#include <bit>
#include <cstdint>

#include "pipeline/draw/sample_counter.h"
#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {

FragmentPass sample_count_pass() {
  return [](FragmentBlock& block, const TileTarget&) {
    block.primitive->binding->samples->add(block.x, block.y, static_cast<std::uint64_t>(std::popcount(block.coverage)));
  };
}

}  // namespace gouraud::pipeline
