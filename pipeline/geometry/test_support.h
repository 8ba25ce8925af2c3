// For the tests of the vertex stages: batches of ordinary and of wild numbers, and a loop over the instruction sets.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/geometry/vertex_batch.h"
#include "pipeline/simd/dispatch.h"

namespace gouraud::pipeline {

/// Calls function() once for each instruction set that this machine has, with that one chosen.
template <class Function>
void for_each_target(const Function& function) {
  for (const simd::Target target :
       {simd::Target::baseline, simd::Target::sse4, simd::Target::avx2, simd::Target::avx512}) {
    if (!simd::target_supported(target)) continue;
    simd::set_target_for_test(target);
    SCOPED_TRACE(simd::target_name(target));
    function();
  }
  simd::set_target_for_test(std::nullopt);
}

/// Numbers from -1 to 1; a wild source also gives NaN, infinities, denormals, zeros and huge numbers.
class Numbers {
 public:
  explicit Numbers(unsigned seed, bool wild = false) : random_(seed), wild_(wild) {}
  float operator()() {
    constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    constexpr std::array<float, 10> wild{nan, inf, -inf, 1e38f, -3.4e38f, 1e-40f, -1e-45f, 0.0f, -0.0f, 1e20f};
    if (wild_ && random_() % 8 == 0) return wild[random_() % wild.size()];
    return static_cast<float>(random_() % 2000001) * 1e-6f - 1.0f;
  }
  unsigned below(unsigned bound) { return static_cast<unsigned>(random_() % bound); }

 private:
  std::mt19937 random_;
  bool wild_;
};

/// A batch of `count` vertices with all attributes.
inline std::unique_ptr<VertexBatch> random_batch(unsigned seed, std::int32_t count, bool wild = false) {
  auto batch = std::make_unique<VertexBatch>();
  Numbers number(seed, wild);
  batch->count = count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    for (std::size_t k = 0; k < 4; ++k)
      batch->position_object[k][i] = k == 3 ? 1.0f + 0.5f * number() : 5.0f * number();
    for (std::size_t k = 0; k < 3; ++k) batch->normal_object[k][i] = number();
    for (std::size_t k = 0; k < 4; ++k) batch->color[k][i] = 2.0f * number();
  }
  return batch;
}

/// Zeroed, so that runs can be compared as memory.
inline std::unique_ptr<ProcessedVertices> blank_vertices() {
  auto vertices = std::make_unique<ProcessedVertices>();
  std::memset(static_cast<void*>(vertices.get()), 0, sizeof(ProcessedVertices));
  return vertices;
}

/// True if the first `count` elements of two arrays have the same bits.
template <class Array>
bool same_bits(const Array& a, const Array& b, std::int32_t count) {
  return std::memcmp(a.data(), b.data(), static_cast<std::size_t>(count) * sizeof(a[0])) == 0;
}

/// The same, but any NaN equals any other: compilers may swap a sum's operands, and with them the payloads of NaNs.
template <std::size_t size>
bool same_numbers(const std::array<float, size>& a, const std::array<float, size>& b, std::int32_t count) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    if (std::memcmp(&a[i], &b[i], sizeof(float)) != 0 && !(std::isnan(a[i]) && std::isnan(b[i]))) return false;
  }
  return true;
}

}  // namespace gouraud::pipeline
