#include "conformance/fuzz/pictures.h"

#include <bit>

namespace gouraud::conformance {
namespace {

/// A sequence of its own for every seed and purpose.
Random sequence(std::uint32_t seed, std::uint32_t purpose) {
  std::uint32_t state = seed * 2654435761u ^ (purpose + 1) * 2246822519u;
  state = (state ^ state >> 15) * 3266489917u;
  return Random((state ^ state >> 13) | 1u);
}

constexpr std::uint32_t choosing = 1000, background = 1001, primitives = 1002;

}  // namespace

void initial_pixel_transfer(const GlTable& gl) {
  for (const GLenum name : {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE}) gl.PixelTransferf(name, 1.0f);
  for (const GLenum name : {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS}) gl.PixelTransferf(name, 0.0f);
  gl.PixelTransferi(GL_MAP_COLOR, GL_FALSE);
}

const std::vector<Feature>& all_features() {
  static const std::vector<Feature> features = [] {
    std::vector<Feature> all;
    for (const std::span<const Feature> some : {state_features(), pixel_features(), fragment_color_features()}) all.insert(all.end(), some.begin(), some.end());
    return all;
  }();
  return features;
}

std::uint64_t choose_features(std::uint32_t seed) {
  Random random = sequence(seed, choosing);
  const int count = random.below(6) == 0 ? 8 : 1 + random.below(4);
  std::uint64_t features = 0;
  for (int i = 0; i < count; ++i) features |= std::uint64_t{1} << random.below(static_cast<int>(all_features().size()));
  return features;
}

void draw_picture(const GlTable& gl, std::uint32_t seed, std::uint64_t features) {
  Brush clear(gl, sequence(seed, background));
  const Brush::Four color = clear.color();
  gl.ClearColor(color.v[0], color.v[1], color.v[2], color.v[3]);
  gl.ClearStencil(clear.below(3));
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  gl.Viewport(0, 0, picture_side_px, picture_side_px);
  gl.TexCoord3f(0.3f, 0.6f, 0.8f);  // no face of a cube map lies in the direction of (0, 0, 0)
  for (std::uint64_t rest = features; rest != 0; rest &= rest - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(rest));
    Brush brush(gl, sequence(seed, static_cast<std::uint32_t>(i)));
    all_features()[i].prepare(brush);
  }
  Brush brush(gl, sequence(seed, primitives));
  draw_primitives(brush);
  initial_pixel_transfer(gl);
}

}  // namespace gouraud::conformance
