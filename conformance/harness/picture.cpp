#include "conformance/harness/picture.h"

namespace gouraud::conformance {
namespace {

constexpr std::uint64_t fnv_offset = 0xCBF29CE484222325u;
constexpr std::uint64_t fnv_prime = 0x100000001B3u;

class Fnv1a {
 public:
  void add_byte(std::uint8_t byte) { value_ = (value_ ^ byte) * fnv_prime; }
  void add_word(std::uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8) add_byte(static_cast<std::uint8_t>(word >> shift));
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = fnv_offset;
};

}  // namespace

std::uint64_t hash(const Picture& picture) {
  Fnv1a fnv;
  fnv.add_word(static_cast<std::uint32_t>(picture.width_px));
  fnv.add_word(static_cast<std::uint32_t>(picture.height_px));
  for (const std::uint8_t byte : picture.rgba) fnv.add_byte(byte);
  for (const std::uint32_t value : picture.depth) fnv.add_word(value);
  return fnv.value();
}

}  // namespace gouraud::conformance
