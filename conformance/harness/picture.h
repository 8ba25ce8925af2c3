// What one driver made of one scene, as the comparison sees it. Rows are bottom-up, pixels left to right.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "conformance/oracle/oracle.h"

namespace gouraud::conformance {

struct Picture {
  int width_px = 0, height_px = 0;
  int depth_bits = 0;                ///< of the stored depth; 0: there is none
  std::vector<std::uint8_t> rgba;    ///< four bytes a pixel, R G B A
  std::vector<std::uint32_t> depth;  ///< as stored, 0 .. 2^depth_bits - 1; empty without depth

  /// 1 where something was drawn, else 0. A driver's: the pixel differs in colour or depth from what the clear before
  /// left, whichever of two clear colours the scene was drawn on. The oracle's: a fragment was written there.
  std::vector<std::uint8_t> covered;

  std::vector<std::uint32_t> gl_errors;  ///< what glGetError said after the scene, in order
  /// Pixels whose colour or depth through glReadPixels differs from the memory that OSMesa hands out.
  std::uint64_t read_differences = 0;

  /// What is exact, unrounded; only from the oracle.
  std::optional<oracle::OraclePicture> exact;

  std::size_t pixel_count() const { return static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px); }
};

/// FNV-1a, 64 bits, over size, colour bytes and stored depth: equal pictures, equal hashes, on every machine.
std::uint64_t hash(const Picture& picture);

}  // namespace gouraud::conformance
