#include "pipeline/framebuffer/write.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/framebuffer/read.h"

namespace gouraud::pipeline {
namespace {

struct Formats {
  DepthFormat depth;
  int stencil_bits;
};

TEST(WrittenRows, AreReadBackAndLeaveTheRestAlone) {
  for (const Formats& formats : {Formats{DepthFormat::z24s8, 8}, Formats{DepthFormat::z16, 0}, Formats{DepthFormat::z32f, 8}}) {
    const Framebuffer target(70, 20, ColorFormat::rgba8, formats.depth, formats.stencil_bits);
    std::vector<double> depths;
    std::vector<std::uint8_t> stencils;
    for (int i = 0; i < 50; ++i) {
      depths.push_back(i / 49.0);
      stencils.push_back(static_cast<std::uint8_t>(5 * i + 3));
    }
    write_depth_row(target, 15, 9, 50, depths.data());
    write_stencil_row(target, 15, 9, 50, stencils.data(), 0xFF);
    write_stencil_row(target, 15, 9, 50, std::vector<std::uint8_t>(50, 0xF0).data(), 0x0F);
    std::vector<float> read(70);
    std::vector<std::uint8_t> read_stencil(70);
    for (int y = 0; y < 20; ++y) {
      read_depth_row_float(target, 0, y, 70, read.data());
      read_stencil_row(target, 0, y, 70, read_stencil.data());
      for (int x = 0; x < 70; ++x) {
        const bool inside = y == 9 && x >= 15 && x < 65;
        const auto i = static_cast<std::size_t>(x - 15), at = static_cast<std::size_t>(x);
        EXPECT_NEAR(read[at], inside ? depths[i] : 0.0, 1e-5);
        EXPECT_EQ(read_stencil[at], inside && formats.stencil_bits > 0 ? stencils[i] & 0xF0 : 0);
      }
    }
  }
}

TEST(DepthInUnits, IsClampedAndToNearest) {
  EXPECT_EQ(depth_in_units(0.5, DepthFormat::z24s8), 8388608.0f);
  EXPECT_EQ(depth_in_units(2.0, DepthFormat::z24s8), 16777215.0f);
  EXPECT_EQ(depth_in_units(-1.0, DepthFormat::z16), 0.0f);
  EXPECT_EQ(depth_in_units(std::nan(""), DepthFormat::z16), 0.0f);
  EXPECT_EQ(depth_in_units(0.25, DepthFormat::z32f), 0.25f);
}

}  // namespace
}  // namespace gouraud::pipeline
