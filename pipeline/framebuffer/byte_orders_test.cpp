#include "pipeline/framebuffer/byte_orders.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/simd/dispatch.h"

namespace gouraud::pipeline {
namespace {

constexpr std::byte guard{0xA5};

class ByteOrders : public testing::Test {
 protected:
  std::byte random_byte() { return static_cast<std::byte>(random_() & 0xFF); }
  ByteOrder random_order(int bytes_in) {
    ByteOrder order;
    for (std::int8_t& source : order.source) source = static_cast<std::int8_t>(static_cast<int>(random_() % static_cast<unsigned>(bytes_in + 2)) - 2);
    return order;
  }
  static std::byte expected(const ByteOrder& order, const std::byte* pixel, std::size_t k) {
    const std::int8_t source = order.source[k];
    return source >= 0 ? pixel[source] : source == ByteOrder::full ? std::byte{255} : std::byte{0};
  }
  template <class Test>
  static void on_every_target(Test test) {
    for (const auto target : {simd::Target::baseline, simd::Target::sse4, simd::Target::avx2, simd::Target::avx512}) {
      if (!simd::target_supported(target)) continue;
      simd::set_target_for_test(target);
      test();
    }
    simd::set_target_for_test({});
  }

 private:
  std::mt19937 random_{7};
};

TEST_F(ByteOrders, PutEachByteInItsPlaceAndTouchNothingElse) {
  on_every_target([&] {
    for (int in = 1; in <= 4; ++in) {
      for (int out = 1; out <= 4; ++out) {
        for (std::size_t pixels = 0; pixels < 70; ++pixels) {
          const ByteOrder order = random_order(in);
          const auto from_bytes = static_cast<std::size_t>(in), to_bytes = static_cast<std::size_t>(out);
          std::vector<std::byte> from(pixels * from_bytes), to(pixels * to_bytes + 2, guard);
          for (std::byte& byte : from) byte = random_byte();
          arrange_bytes(ByteArrangement(order, in, out), from.data(), pixels, to.data() + 1);
          ASSERT_EQ(to.front(), guard);
          ASSERT_EQ(to.back(), guard) << in << " to " << out << ", " << pixels;
          for (std::size_t i = 0; i < pixels * to_bytes; ++i) {
            ASSERT_EQ(to[i + 1], expected(order, &from[i / to_bytes * from_bytes], i % to_bytes)) << in << " to " << out << ", " << pixels;
          }
        }
      }
    }
  });
}

TEST_F(ByteOrders, OfATilesRowsAreThoseOfItsPixels) {
  std::vector<std::byte> tile(pixels_per_tile * 4);
  for (std::byte& byte : tile) byte = random_byte();
  on_every_target([&] {
    for (int out = 1; out <= 4; ++out) {
      const ByteOrder order = random_order(4);
      const auto to_bytes = static_cast<std::size_t>(out), stride = tile_size * to_bytes + 3;
      std::vector<std::byte> to(block_size * stride, guard);
      arrange_tile_rows(ByteArrangement(order, 4, out), tile.data(), block_size, to.data(), static_cast<std::ptrdiff_t>(stride));
      for (std::size_t y = 0; y < block_size; ++y) {
        for (std::size_t i = 0; i < stride; ++i) {
          const std::size_t x = i / to_bytes, at = x / block_size * pixels_per_block + y * block_size + x % block_size;
          ASSERT_EQ(to[y * stride + i], x < tile_size ? expected(order, &tile[4 * at], i % to_bytes) : guard) << out;
        }
      }
    }
  });
}

}  // namespace
}  // namespace gouraud::pipeline
