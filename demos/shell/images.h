// Pictures to put on surfaces, computed rather than loaded. RGBA, 8 bits a channel, rows from the bottom up.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace shell {

struct Color {
  float r = 0, g = 0, b = 0, a = 1;
};

// width x height texels; texel (x, y) has the colour at its centre, ((x + 0.5) / width, (y + 0.5) / height).
std::vector<std::uint8_t> make_image(int width, int height, const std::function<Color(float s, float t)>& color_at);

// `fields` x `fields` squares of two colours.
Color checker(float s, float t, int fields, const Color& even, const Color& odd);

// A wall of bricks, rows of them shifted by half a brick.
Color bricks(float s, float t, int rows);

// Uploads an image to the texture bound to GL_TEXTURE_2D, with all its mipmaps.
void upload_with_mipmaps(int width, int height, const std::vector<std::uint8_t>& texels);

}  // namespace shell
