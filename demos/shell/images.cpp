#include "demos/shell/images.h"

#include <GL/gl.h>

#include <algorithm>
#include <cmath>

namespace shell {
namespace {

std::uint8_t byte(float value) {
  return static_cast<std::uint8_t>(255 * std::clamp(value, 0.0f, 1.0f) + 0.5f);
}

}  // namespace

std::vector<std::uint8_t> make_image(int width, int height, const std::function<Color(float s, float t)>& color_at) {
  std::vector<std::uint8_t> texels;
  texels.reserve(static_cast<size_t>(width) * static_cast<size_t>(height) * 4);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Color color = color_at((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                                   (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
      for (const float channel : {color.r, color.g, color.b, color.a}) texels.push_back(byte(channel));
    }
  }
  return texels;
}

Color checker(float s, float t, int fields, const Color& even, const Color& odd) {
  const auto field = [fields](float coordinate) { return static_cast<int>(std::floor(coordinate * static_cast<float>(fields))); };
  return (field(s) + field(t)) % 2 == 0 ? even : odd;
}

Color bricks(float s, float t, int rows) {
  constexpr float joint = 0.06f;
  const float v = t * static_cast<float>(rows), row = std::floor(v);
  const float u = s * static_cast<float>(rows) * 0.5f + (std::fmod(row, 2.0f) == 0 ? 0.0f : 0.5f);
  const float along = (u - std::floor(u)) * 2, up = v - row;
  const bool is_joint = along < joint || along > 2 - joint || up < joint || up > 1 - joint;
  if (is_joint) return {0.62f, 0.60f, 0.56f};
  const float tone = 0.85f + 0.15f * std::sin(12.9898f * std::floor(u) + 78.233f * row);
  return {0.62f * tone, 0.27f * tone, 0.20f * tone};
}

void upload_with_mipmaps(int width, int height, const std::vector<std::uint8_t>& texels) {
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
}

}  // namespace shell
