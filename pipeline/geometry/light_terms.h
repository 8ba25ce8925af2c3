// What lighting hands to its kernels: a light's constants over a run of vertices, a block of vertices [GL1.5 §2.14.1].
#pragma once

#include <array>
#include <cstddef>

namespace gouraud::pipeline {

using Triple = std::array<double, 3>;

/// Which way the light comes. A directional spot light shines on all vertices alike: its factor is in its colours.
enum class LightKind { directional, positional, spot };
/// What the highlight takes: nothing (it is black), or the half vector for a viewer at infinity or at the eye.
enum class Highlight { none, distant_viewer, local_viewer };
/// What is summed over the lights. `fused`: the lit colour, of products light x material. `split`: ambient, diffuse and
/// specular light apart, to be multiplied by each vertex's material; `two_sided`: those of both faces.
enum class Sums { fused, split, two_sided };

/// An exponent in [0, 128]. Most are whole numbers, whose powers are a few products.
struct Exponent {
  static constexpr int not_whole = -1;
  double value;
  int whole;  ///< `value`, or not_whole
};
inline Exponent make_exponent(double value) {
  const bool is_whole = value >= 0 && value <= 128 && value == static_cast<int>(value);
  return {value, is_whole ? static_cast<int>(value) : Exponent::not_whole};
}

struct LightTerms {
  LightKind kind;
  Highlight highlight;
  Triple position;     ///< eye space; directional: unit vector towards the light
  Triple half_vector;  ///< unit vector, only if directional and the viewer distant
  Triple attenuation, spot_direction;
  double spot_cutoff_cosine;
  Exponent spot_exponent;
  double directional_spot_factor;     ///< 1 but for directional spot lights
  Triple ambient, diffuse, specular;  ///< products with the material if the sums are fused
  Exponent shininess, shininess_back;
};

/// Vertices lit at a time: their inputs and sums stay in the first-level cache while light after light is added.
inline constexpr std::size_t light_block_size = 64;

struct alignas(64) LightBlock {
  using Row = std::array<double, light_block_size>;
  using Vectors = std::array<Row, 3>;
  Vectors normal, position, to_viewer;  ///< eye space; to_viewer: unit vectors, only for a local viewer
  Vectors ambient;                      ///< fused sums stand here
  Vectors diffuse[2], specular[2];      ///< front, back
};

}  // namespace gouraud::pipeline
