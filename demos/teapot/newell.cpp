// Newell's numbers, written as what he drew: two profiles turned about the axis, and two tubes given by sections.
#include "demos/teapot/newell.h"

namespace {

// A profile's control point. `corner` is the coordinate that bends a quarter circle into a Bezier curve,
// (radius, 0), (radius, corner), (corner, radius), (0, radius): 0.56 times the radius, but at the lid's knob 0.45.
struct ProfilePoint {
  float radius, corner, height;
};

// From the rim's inner edge over the rim and down the belly to the middle of the bottom: four cubic pieces.
constexpr ProfilePoint body[] = {
    {1.4f, 0.784f, 2.4f},   {1.3375f, 0.749f, 2.53125f}, {1.4375f, 0.805f, 2.53125f}, {1.5f, 0.84f, 2.4f},
    {1.75f, 0.98f, 1.875f}, {2.0f, 1.12f, 1.35f},        {2.0f, 1.12f, 0.9f},         {2.0f, 1.12f, 0.45f},
    {1.5f, 0.84f, 0.225f},  {1.5f, 0.84f, 0.15f},        {1.5f, 0.84f, 0.075f},       {1.425f, 0.798f, 0.0f},
    {0.0f, 0.0f, 0.0f},
};

// From the tip of the knob to the lid's edge: two cubic pieces.
constexpr ProfilePoint lid[] = {
    {0.0f, 0.0f, 3.15f},   {0.8f, 0.45f, 3.15f},  {0.0f, 0.0f, 2.85f},  {0.2f, 0.112f, 2.7f},
    {0.4f, 0.224f, 2.55f}, {1.3f, 0.728f, 2.55f}, {1.3f, 0.728f, 2.4f},
};

// A section through a tube: its two control points in the plane y = 0, and how far it bulges to both sides.
struct Section {
  float x1, z1, x2, z2, bulge;
};

constexpr Section handle[] = {
    {-1.6f, 2.025f, -1.5f, 2.25f, 0.3f}, {-2.3f, 2.025f, -2.5f, 2.25f, 0.3f}, {-2.7f, 2.025f, -3.0f, 2.25f, 0.3f},
    {-2.7f, 1.8f, -3.0f, 1.8f, 0.3f},    {-2.7f, 1.575f, -3.0f, 1.35f, 0.3f}, {-2.5f, 1.125f, -2.65f, 0.9375f, 0.3f},
    {-2.0f, 0.9f, -1.9f, 0.6f, 0.3f},
};

constexpr Section spout[] = {
    {1.7f, 1.425f, 1.7f, 0.6f, 0.66f}, {2.6f, 1.425f, 3.1f, 0.825f, 0.66f},     {2.3f, 2.1f, 2.4f, 2.025f, 0.25f},
    {2.7f, 2.4f, 3.3f, 2.4f, 0.25f},   {2.8f, 2.475f, 3.525f, 2.49375f, 0.25f}, {2.9f, 2.475f, 3.45f, 2.5125f, 0.15f},
    {2.8f, 2.4f, 3.2f, 2.4f, 0.15f},
};

Vec3 quarter_turn(const Vec3& v) {
  return {-v.y, v.x, v.z};
}

// Turns one cubic piece of a profile, four points from `profile`, into four patches, one a quadrant.
void turn(const ProfilePoint* profile, std::vector<Patch>& patches) {
  Patch patch{};
  for (int i = 0; i < 4; ++i) {
    const auto [radius, corner, height] = profile[i];
    patch.point[i][0] = {radius, 0, height};
    patch.point[i][1] = {radius, corner, height};
    patch.point[i][2] = {corner, radius, height};
    patch.point[i][3] = {0, radius, height};
  }
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    patches.push_back(patch);
    for (auto& row : patch.point) {
      for (Vec3& point : row) point = quarter_turn(point);
    }
  }
}

// Spans one cubic piece of a tube, four sections from `section`, with a patch on either side of the plane y = 0.
void span(const Section* section, std::vector<Patch>& patches) {
  Patch left{}, right{};
  for (int i = 0; i < 4; ++i) {
    const auto [x1, z1, x2, z2, bulge] = section[i];
    const Vec3 around[4] = {{x1, 0, z1}, {x1, bulge, z1}, {x2, bulge, z2}, {x2, 0, z2}};
    for (int j = 0; j < 4; ++j) {
      left.point[i][j] = around[j];
      right.point[i][3 - j] = {around[j].x, -around[j].y, around[j].z};
    }
  }
  patches.push_back(left);
  patches.push_back(right);
}

}  // namespace

std::vector<Patch> newell_teapot() {
  std::vector<Patch> patches;
  for (int piece = 0; piece < 4; ++piece) turn(&body[3 * piece], patches);
  for (int piece = 0; piece < 2; ++piece) turn(&lid[3 * piece], patches);
  for (int piece = 0; piece < 2; ++piece) span(&handle[3 * piece], patches);
  for (int piece = 0; piece < 2; ++piece) span(&spout[3 * piece], patches);
  return patches;
}
