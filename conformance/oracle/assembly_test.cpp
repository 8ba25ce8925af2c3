#include "conformance/oracle/assembly.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gouraud::oracle {
namespace {

using pipeline::PrimitiveMode;

std::vector<Primitive> assembled(PrimitiveMode mode, int count, bool begins = true, bool ends = true) {
  return assemble({mode, begins, ends, 0, count});
}

TEST(Assembly, CountsPrimitives) {
  const std::vector<std::pair<PrimitiveMode, std::size_t>> of_seven_vertices{
      {PrimitiveMode::points, 7},       {PrimitiveMode::lines, 3},     {PrimitiveMode::line_loop, 7},
      {PrimitiveMode::line_strip, 6},   {PrimitiveMode::triangles, 2}, {PrimitiveMode::triangle_strip, 5},
      {PrimitiveMode::triangle_fan, 5}, {PrimitiveMode::quads, 2},     {PrimitiveMode::quad_strip, 4},
      {PrimitiveMode::polygon, 5}};
  for (const auto& [mode, expected] : of_seven_vertices) {
    EXPECT_EQ(assembled(mode, 7).size(), expected);
    EXPECT_EQ(assembled(mode, 0).size(), 0u);
    if (mode != PrimitiveMode::points) {
      EXPECT_EQ(assembled(mode, 1).size(), 0u);
    }
  }
}

TEST(Assembly, StripsKeepTheirOrientation) {
  const auto strip = assembled(PrimitiveMode::triangle_strip, 5);
  EXPECT_EQ(strip[0].vertex, (std::array{0, 1, 2}));
  EXPECT_EQ(strip[1].vertex, (std::array{2, 1, 3}));
  EXPECT_EQ(strip[2].vertex, (std::array{2, 3, 4}));
  EXPECT_EQ(strip[1].provoking, 3);
}

TEST(Assembly, QuadDiagonalsFollowTheState) {
  EXPECT_EQ(assembled(PrimitiveMode::quads, 4)[0].vertex, (std::array{0, 1, 2}));
  const auto quads = assemble({PrimitiveMode::quads, true, true, 8, 4}, {.diagonal_02 = false});
  EXPECT_EQ(quads[0].vertex, (std::array{8, 9, 11}));
  EXPECT_EQ(quads[1].vertex, (std::array{9, 10, 11}));
  EXPECT_EQ(quads[0].provoking, 11);
}

/// Edges of the polygon, each as often as it is flagged as a boundary edge.
std::vector<std::pair<int, int>> boundary(const std::vector<Primitive>& primitives) {
  std::vector<std::pair<int, int>> out;
  for (const Primitive& primitive : primitives) {
    for (unsigned i = 0; i < 3; ++i) {
      if (primitive.boundary_edges >> i & 1) out.emplace_back(primitive.vertex[i], primitive.vertex[(i + 1) % 3]);
    }
  }
  std::ranges::sort(out);
  return out;
}

TEST(Assembly, BoundaryEdgesAreThePolygons) {
  const std::vector<std::pair<int, int>> around{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  EXPECT_EQ(boundary(assembled(PrimitiveMode::quads, 4)), around);
  EXPECT_EQ(boundary(assembled(PrimitiveMode::polygon, 4)), around);
  EXPECT_EQ(boundary(assemble({PrimitiveMode::quads, true, true, 0, 4}, {.diagonal_02 = false})),
            around);
  EXPECT_EQ(boundary(assembled(PrimitiveMode::quad_strip, 4)),
            (std::vector<std::pair<int, int>>{{0, 1}, {1, 3}, {2, 0}, {3, 2}}));
  EXPECT_EQ(boundary(assembled(PrimitiveMode::triangle_fan, 4)).size(), 6u);
}

/// A primitive of n vertices cut after `cut` of them, with the vertices of the second range renamed to what they are.
std::vector<Primitive> in_two_ranges(PrimitiveMode mode, int n, int cut) {
  const bool from_first =
      mode == PrimitiveMode::line_loop || mode == PrimitiveMode::triangle_fan || mode == PrimitiveMode::polygon;
  std::vector<int> renamed;
  if (from_first)
    renamed = {0, cut - 1};
  else if (mode == PrimitiveMode::line_strip)
    renamed = {cut - 1};
  else
    renamed = {cut - 2, cut - 1};
  for (int i = cut; i < n; ++i) renamed.push_back(i);
  std::vector<Primitive> out = assembled(mode, cut, true, false);
  for (Primitive primitive : assembled(mode, static_cast<int>(renamed.size()), false, true)) {
    for (int& v : primitive.vertex) v = renamed[static_cast<std::size_t>(v)];
    primitive.provoking = renamed[static_cast<std::size_t>(primitive.provoking)];
    out.push_back(primitive);
  }
  return out;
}

TEST(Assembly, ContinuedRangesMakeTheSamePrimitives) {
  for (const PrimitiveMode mode : {PrimitiveMode::line_strip, PrimitiveMode::line_loop, PrimitiveMode::triangle_strip,
                                   PrimitiveMode::triangle_fan, PrimitiveMode::quad_strip, PrimitiveMode::polygon}) {
    const auto whole = assembled(mode, 10), cut = in_two_ranges(mode, 10, 6);
    ASSERT_EQ(whole.size(), cut.size()) << static_cast<int>(mode);
    for (std::size_t i = 0; i < whole.size(); ++i) {
      EXPECT_EQ(whole[i].vertex, cut[i].vertex) << static_cast<int>(mode) << ' ' << i;
      EXPECT_EQ(whole[i].provoking, cut[i].provoking);
      EXPECT_EQ(whole[i].boundary_edges, cut[i].boundary_edges);
    }
  }
}

}  // namespace
}  // namespace gouraud::oracle
