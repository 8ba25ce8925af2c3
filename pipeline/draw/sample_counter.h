// Where occlusion queries count [GL1.5 §4.1.7].
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace gouraud::pipeline {

/// How many fragments passed. Many threads may add at once: the sum of whole numbers does not depend on their order.
class SampleCounter {
 public:
  /// `x`, `y` is a block's first pixel: threads, which work on different tiles, mostly add to different shares.
  void add(std::int32_t x, std::int32_t y, std::uint64_t count) {
    const auto tile = static_cast<std::uint32_t>(x / tile_px + y / tile_px * row_step);
    shares_[tile % share_count].count.fetch_add(count, std::memory_order_relaxed);
  }
  /// Complete once all that was drawn has been rasterized.
  std::uint64_t total() const {
    std::uint64_t sum = 0;
    for (const Share& share : shares_) sum += share.count.load(std::memory_order_relaxed);
    return sum;
  }

 private:
  static constexpr std::int32_t tile_px = 64, row_step = 5;
  static constexpr std::uint32_t share_count = 16;
  struct alignas(64) Share {
    std::atomic<std::uint64_t> count{0};
  };
  std::array<Share, share_count> shares_{};
};

}  // namespace gouraud::pipeline
