// What flows between the oracle's stages.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace gouraud::oracle {

using Vector3 = std::array<double, 3>;
using Vector4 = std::array<double, 4>;
using Color = std::array<double, 4>;  ///< RGBA

enum Face : std::uint8_t { front = 0, back = 1 };

/// What is interpolated besides depth: colours of a vertex on its front and back, clamped to [0, 1] [GL1.5 §2.14.6], and
/// more. Without separate specular colour, and without a colour sum, the secondary colour is black.
struct VertexColors {
  std::array<Color, 2> primary{}, secondary{};
  double fog_coordinate = 0;
  std::vector<Vector4> texture_coordinates;  ///< s, t, r, q of each textured unit, in order
};

/// A vertex in clip space; positions in float (MESA-RULES' chain) or double (the true picture).
template <typename T>
struct ClipVertex {
  std::array<T, 4> position{};
  VertexColors colors;
  std::array<T, 4> position_eye{};  ///< where there are clip planes of the user
};

/// A position in units of a sub-pixel, y up. The centre of pixel (i, j) is (i, j) * 2^bits: the half pixel is already
/// taken off.
struct SubpixelPoint {
  std::int64_t x = 0, y = 0;
  bool operator==(const SubpixelPoint&) const = default;
};

/// A vertex in window space, y up. Doubles hold the floats of the chain exactly.
struct WindowVertex {
  double x = 0, y = 0, z = 0;
  double w_inverse = 0;
  SubpixelPoint snapped;
  VertexColors colors;
};

}  // namespace gouraud::oracle
