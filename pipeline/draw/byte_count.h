// How many bytes so many things of so many bytes are, where memory may be 32 bits wide: a picture of the largest size is
// not, and a product that wrapped around would be memory that is too small.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <new>

namespace gouraud::pipeline {

/// The product of counts, none negative. Throws std::bad_alloc if no block of memory can be so large.
inline std::size_t byte_count(std::initializer_list<std::int64_t> counts) {
  std::ptrdiff_t product = 1;
  for (const std::int64_t count : counts) {
    if (__builtin_mul_overflow(product, count, &product)) throw std::bad_alloc();
  }
  return static_cast<std::size_t>(product);
}

}  // namespace gouraud::pipeline
