#include "pipeline/draw/byte_count.h"

#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

namespace gouraud::pipeline {
namespace {

TEST(ByteCount, IsTheProduct) {
  EXPECT_EQ(byte_count({}), 1u);
  EXPECT_EQ(byte_count({640, 480, 4}), 1228800u);
  EXPECT_EQ(byte_count({640, 0, 4}), 0u);
}

TEST(ByteCount, OfWhatNoMemoryHoldsIsRefused) {
  constexpr std::int64_t most = std::numeric_limits<std::ptrdiff_t>::max();
  EXPECT_EQ(byte_count({most, 1}), static_cast<std::size_t>(most));
  EXPECT_THROW(byte_count({most, 2}), std::bad_alloc);
  EXPECT_THROW(byte_count({std::int64_t{1} << 32, std::int64_t{1} << 32}), std::bad_alloc);
  if constexpr (sizeof(std::size_t) == 4) {
    EXPECT_THROW(byte_count({16384, 16384, 16}), std::bad_alloc);
  }
}

}  // namespace
}  // namespace gouraud::pipeline
