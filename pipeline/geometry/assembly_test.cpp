#include "pipeline/geometry/assembly.h"

#include <algorithm>
#include <memory>
#include <ostream>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

namespace gouraud::pipeline {
namespace {

constexpr std::array all_modes{PrimitiveMode::points,       PrimitiveMode::lines,     PrimitiveMode::line_loop,
                               PrimitiveMode::line_strip,   PrimitiveMode::triangles, PrimitiveMode::triangle_strip,
                               PrimitiveMode::triangle_fan, PrimitiveMode::quads,     PrimitiveMode::quad_strip,
                               PrimitiveMode::polygon};

/// A primitive in letters: vertex 0 is "a". "abc c" is the triangle abc whose provoking vertex is c; edges that are no
/// boundary are told by a dash: "ab-c" has no boundary from b to c, and a dash at the end none from c to a.
std::string letters(const AssembledPrimitives& primitives) {
  const auto letter = [](unsigned index) { return std::string(1, static_cast<char>('a' + index)); };
  std::string text;
  for (const AssembledPoint& p : primitives.points) text += letter(p.vertex) + " " + letter(p.provoking) + ", ";
  for (const AssembledLine& l : primitives.lines) {
    text += letter(l.vertex[0]) + letter(l.vertex[1]) + " " + letter(l.provoking) + ", ";
  }
  for (const AssembledTriangle& t : primitives.triangles) {
    for (unsigned k = 0; k < 3; ++k) text += letter(t.vertex[k]) + ((t.edges >> k & 1) != 0 ? "" : "-");
    text += " " + letter(t.provoking) + ", ";
  }
  return text.substr(0, text.empty() ? 0 : text.size() - 2);
}

std::string assembled(PrimitiveMode mode, std::int32_t count, QuadDiagonal diagonal = QuadDiagonal::from_0_to_2) {
  AssembledPrimitives out;
  assemble({mode, true, true, 0, count}, {.diagonal = diagonal}, out);
  return letters(out);
}

TEST(Assembly, OfPointsAndLines) {
  EXPECT_EQ(assembled(PrimitiveMode::points, 3), "a a, b b, c c");
  EXPECT_EQ(assembled(PrimitiveMode::lines, 4), "ab b, cd d");
  EXPECT_EQ(assembled(PrimitiveMode::line_strip, 4), "ab b, bc c, cd d");
  EXPECT_EQ(assembled(PrimitiveMode::line_loop, 4), "ab b, bc c, cd d, da a");
}

TEST(Assembly, OfTriangles) {
  EXPECT_EQ(assembled(PrimitiveMode::triangles, 6), "abc c, def f");
  EXPECT_EQ(assembled(PrimitiveMode::triangle_strip, 6), "abc c, cbd d, cde e, edf f");
  EXPECT_EQ(assembled(PrimitiveMode::triangle_fan, 5), "abc c, acd d, ade e");
}

TEST(Assembly, OfSmoothQuadsHasTheDiagonalFromTheFirstVertex) {
  EXPECT_EQ(assembled(PrimitiveMode::quads, 8), "abc- d, a-cd d, efg- h, e-gh h");
}

TEST(Assembly, OfQuadStripsHasTheDiagonalToTheLastVertexAndEitherHalfFirst) {
  EXPECT_EQ(assembled(PrimitiveMode::quad_strip, 4), "abd- d, a-dc d");
  AssembledPrimitives out;
  assemble({PrimitiveMode::quad_strip, true, true, 0, 4}, {.strips_far_half_first = true}, out);
  EXPECT_EQ(letters(out), "ca-d d, abd- d");
}

TEST(Assembly, QuadsAreClippedTogether) {
  auto batch = std::make_unique<VertexBatch>();
  auto vertices = std::make_unique<ProcessedVertices>();
  std::fill_n(vertices->outcode.begin(), 16, std::uint16_t{0});
  for (const std::int32_t first : {0, 4, 12}) batch->primitives.push_back({PrimitiveMode::quads, true, true, first, 4});
  batch->primitives.insert(batch->primitives.begin() + 2, {PrimitiveMode::triangle_fan, true, true, 8, 4});
  EXPECT_FALSE(are_quads_clipped(*batch, *vertices, 0));
  vertices->outcode[9] = vertices->outcode[15] = 1;
  EXPECT_FALSE(are_quads_clipped(*batch, *vertices, 0)) << "those after another primitive are drawn apart";
  EXPECT_TRUE(are_quads_clipped(*batch, *vertices, 3));
  vertices->outcode[7] = 1;
  EXPECT_TRUE(are_quads_clipped(*batch, *vertices, 0));
  EXPECT_FALSE(begins_quads(*batch, 1));
  batch->primitives[1].origin = PrimitiveOrigin::arrays;
  EXPECT_TRUE(begins_quads(*batch, 1));
  EXPECT_FALSE(are_quads_clipped(*batch, *vertices, 0)) << "those of arrays are drawn apart, too";
}

TEST(Assembly, OfFlatQuadsHasTheOtherDiagonal) {
  EXPECT_EQ(assembled(PrimitiveMode::quads, 4, QuadDiagonal::from_1_to_3), "ab-d d, bcd- d");
}

TEST(Assembly, OfQuadStripsTurnsEachQuadTheSameWay) {
  EXPECT_EQ(assembled(PrimitiveMode::quad_strip, 6), "abd- d, a-dc d, cdf- f, c-fe f");
}

TEST(Assembly, OfPolygonsIsAFanThatTheFirstVertexProvokes) {
  EXPECT_EQ(assembled(PrimitiveMode::polygon, 3), "bca a");
  EXPECT_EQ(assembled(PrimitiveMode::polygon, 5), "bc-a a, cd-a- a, dea- a");
}

TEST(Assembly, DropsWhatIsIncomplete) {
  const auto same = [](PrimitiveMode mode, std::int32_t count, std::int32_t complete) {
    EXPECT_EQ(assembled(mode, count), assembled(mode, complete)) << count << " vertices";
  };
  for (const PrimitiveMode mode : all_modes) EXPECT_EQ(assembled(mode, 0), "");
  for (const PrimitiveMode mode : {PrimitiveMode::lines, PrimitiveMode::line_strip, PrimitiveMode::line_loop})
    same(mode, 1, 0);
  for (const PrimitiveMode mode : {PrimitiveMode::triangles, PrimitiveMode::triangle_strip, PrimitiveMode::triangle_fan,
                                   PrimitiveMode::polygon, PrimitiveMode::quads, PrimitiveMode::quad_strip}) {
    same(mode, 1, 0);
    same(mode, 2, 0);
  }
  same(PrimitiveMode::quads, 3, 0);
  same(PrimitiveMode::quad_strip, 3, 0);
  same(PrimitiveMode::lines, 5, 4);
  same(PrimitiveMode::triangles, 7, 6);
  same(PrimitiveMode::triangles, 8, 6);
  same(PrimitiveMode::quads, 7, 4);
  same(PrimitiveMode::quad_strip, 7, 6);
}

TEST(Assembly, OfALoopOfTwoVerticesGoesThereAndBack) {
  EXPECT_EQ(assembled(PrimitiveMode::line_loop, 2), "ab b, ba a");
}

TEST(Assembly, CountsVerticesFromTheRangesFirstAndAppends) {
  AssembledPrimitives out;
  assemble({PrimitiveMode::triangles, true, true, 0, 3}, {}, out);
  assemble({PrimitiveMode::triangle_fan, true, true, 3, 4}, {}, out);
  EXPECT_EQ(letters(out), "abc c, def f, dfg g");
}

/// Where a primitive may be cut, and which vertices its next range repeats: as PrimitiveRange documents.
struct Cutting {
  std::int32_t unit;     ///< vertices of a range are a multiple of this
  bool repeats_first;    ///< the very first vertex
  std::int32_t repeats;  ///< and the last ones
};
Cutting cutting_of(PrimitiveMode mode) {
  switch (mode) {
    case PrimitiveMode::points:
      return {1, false, 0};
    case PrimitiveMode::lines:
      return {2, false, 0};
    case PrimitiveMode::line_strip:
      return {1, false, 1};
    case PrimitiveMode::triangles:
      return {3, false, 0};
    case PrimitiveMode::quads:
      return {4, false, 0};
    case PrimitiveMode::triangle_strip:
    case PrimitiveMode::quad_strip:
      return {2, false, 2};
    case PrimitiveMode::line_loop:
    case PrimitiveMode::triangle_fan:
    case PrimitiveMode::polygon:
      break;
  }
  return {1, true, 1};
}

/// The primitives of `count` vertices in ranges of at most `room` vertices each; vertices named as in the whole.
std::string assembled_in_pieces(PrimitiveMode mode, QuadDiagonal diagonal, std::int32_t count, std::int32_t room) {
  const Cutting cutting = cutting_of(mode);
  AssembledPrimitives whole;
  std::vector<std::uint16_t> names;  // of the range's vertices
  std::int32_t next = 0;
  for (bool begins = true; begins || next < count; begins = false) {
    if (!begins && cutting.repeats_first) names = {0, names.back()};
    if (!begins && !cutting.repeats_first) names.erase(names.begin(), names.end() - cutting.repeats);
    const std::int32_t limit = room / cutting.unit * cutting.unit;
    while (static_cast<std::int32_t>(names.size()) < limit && next < count)
      names.push_back(static_cast<std::uint16_t>(next++));
    AssembledPrimitives part;
    assemble({mode, begins, next == count, 0, static_cast<std::int32_t>(names.size())}, {.diagonal = diagonal}, part);
    for (AssembledPoint p : part.points) whole.points.push_back({names[p.vertex], names[p.provoking], p.back});
    for (AssembledLine l : part.lines)
      whole.lines.push_back({{names[l.vertex[0]], names[l.vertex[1]]}, names[l.provoking], l.back});
    for (AssembledTriangle t : part.triangles) {
      whole.triangles.push_back(
          {{names[t.vertex[0]], names[t.vertex[1]], names[t.vertex[2]]}, names[t.provoking], t.edges});
    }
  }
  return letters(whole);
}

TEST(Assembly, OfRangesCutInTheMiddleEqualsTheUncutOne) {
  for (const PrimitiveMode mode : all_modes) {
    for (const QuadDiagonal diagonal : {QuadDiagonal::from_0_to_2, QuadDiagonal::from_1_to_3}) {
      for (std::int32_t count = 1; count <= 24; ++count) {
        for (std::int32_t room = 4; room <= 12; ++room) {
          ASSERT_EQ(assembled_in_pieces(mode, diagonal, count, room), assembled(mode, count, diagonal))
              << "mode " << static_cast<int>(mode) << ", " << count << " vertices in ranges of " << room;
        }
      }
    }
  }
}

}  // namespace
}  // namespace gouraud::pipeline
