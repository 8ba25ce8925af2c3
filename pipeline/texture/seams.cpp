#include "pipeline/texture/seams.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "pipeline/texture/texel_access.h"

namespace gouraud::pipeline {
namespace {

struct Face {
  int s_axis, s_sign, t_axis, t_sign, m_axis, m_sign;
};
constexpr std::array<Face, 6> faces{{{2, -1, 1, -1, 0, 1},
                                     {2, 1, 1, -1, 0, -1},
                                     {0, 1, 2, 1, 1, 1},
                                     {0, 1, 2, -1, 1, -1},
                                     {0, 1, 1, -1, 2, 1},
                                     {0, -1, 1, -1, 2, -1}}};

struct Place {
  int face, x, y;
};

/// The texel at (x, y) of a face, whose coordinates may lie one texel beyond one edge; nothing beyond a corner.
/// In units where the cube's half edge is n and texel x has its centre at 2 x + 1 - n.
std::optional<Place> wrap(int face, int x, int y, int n) {
  const bool x_outside = x < 0 || x >= n, y_outside = y < 0 || y >= n;
  if (!x_outside && !y_outside) return Place{face, x, y};
  if (x_outside && y_outside) return std::nullopt;
  const Face& from = faces[static_cast<std::size_t>(face)];
  // The texel's neighbour lies beyond the edge, as far from it on the next face: fold the step over.
  std::array<int, 3> direction{};
  const int sc = 2 * std::clamp(x, 0, n - 1) + 1 - n, tc = 2 * std::clamp(y, 0, n - 1) + 1 - n;
  const auto put = [&](int axis, int value) { direction[static_cast<std::size_t>(axis)] = value; };
  put(from.s_axis, from.s_sign * sc);
  put(from.t_axis, from.t_sign * tc);
  put(from.m_axis, from.m_sign * (n - 1));
  if (x_outside) put(from.s_axis, from.s_sign * (x < 0 ? -n : n));
  if (y_outside) put(from.t_axis, from.t_sign * (y < 0 ? -n : n));
  const int major = x_outside ? from.s_axis : from.t_axis;
  const int next = 2 * major + (direction[static_cast<std::size_t>(major)] < 0 ? 1 : 0);
  const Face& to = faces[static_cast<std::size_t>(next)];
  const int s = direction[static_cast<std::size_t>(to.s_axis)] * to.s_sign, t = direction[static_cast<std::size_t>(to.t_axis)] * to.t_sign;
  return Place{next, (s + n - 1) / 2, (t + n - 1) / 2};
}

Texel texel_at(const PreparedUnit& unit, int level, const Place& place) {
  const PreparedLevel& prepared = unit.level(place.face, level);
  const int border = prepared.border[0];
  const std::byte* texel = texel_address(*prepared.image, place.x + border, place.y + border, 0);
  return expand_channels(*prepared.image, stored_channels(unit.format, texel));
}

Texel mix(const Texel& a, const Texel& b, float weight) {
  Texel out;
  for (std::size_t k = 0; k < 4; ++k) out[k] = a[k] + (b[k] - a[k]) * weight;
  return out;
}

Texel filtered(const PreparedUnit& unit, int face, int level, int x, int y, float weight_x, float weight_y) {
  const int n = unit.level(face, level).size[0];
  std::array<Texel, 4> corner{};
  int missing = -1;
  for (int i = 0; i < 4; ++i) {
    const std::optional<Place> place = wrap(face, x + (i & 1), y + (i >> 1), n);
    if (place) corner[static_cast<std::size_t>(i)] = texel_at(unit, level, *place);
    else missing = i;
  }
  if (missing >= 0) {
    Texel& out = corner[static_cast<std::size_t>(missing)];
    for (std::size_t k = 0; k < 4; ++k) out[k] = (corner[0][k] + corner[1][k] + corner[2][k] + corner[3][k]) / 3.0f;
  }
  return mix(mix(corner[0], corner[1], weight_x), mix(corner[2], corner[3], weight_x), weight_y);
}

}  // namespace

void filter_across_seams(const PreparedUnit& unit, std::int32_t face, std::int32_t level, const float* s, const float* t,
                         std::uint64_t lanes, TexelBlock& out) {
  const auto size = static_cast<float>(unit.level(face, level).size[0]);
  for (std::uint64_t left = lanes; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    const auto place = [&](float c) { return c > 0.0f ? std::min(c, 1.0f) * size - 0.5f : -0.5f; };
    const auto below = [](float c) { return static_cast<int>(c) - (c < static_cast<float>(static_cast<int>(c)) ? 1 : 0); };
    const float u = place(s[lane]), v = place(t[lane]);
    const int x = below(u), y = below(v);
    const Texel texel = filtered(unit, face, level, x, y, u - static_cast<float>(x), v - static_cast<float>(y));
    for (std::size_t k = 0; k < 4; ++k) out.channel[k][lane] = texel[k];
  }
}

}  // namespace gouraud::pipeline
