// What immediate mode gives to the pipeline, as a draw observer sees it.
#include "api/context/immediate.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "api/commands/begin_end.h"
#include "api/commands/current_values.h"
#include "api/commands/enables.h"
#include "api/commands/framebuffer_control.h"
#include "api/commands/lighting.h"
#include "api/commands/matrices.h"
#include "api/commands/rasterization.h"
#include "api/context/context.h"

namespace gouraud::api {
namespace {

using pipeline::PrimitiveMode;

struct SeenVertex {
  float x = 0.0f;
  float emission = 0.0f;  // front red
  bool operator==(const SeenVertex&) const = default;
};
struct SeenRange {
  PrimitiveMode mode;
  bool begins, ends;
  std::vector<SeenVertex> vertices;
};
struct SeenDraw {
  pipeline::DrawState state;
  std::int32_t count;
  std::size_t runs;
  std::vector<SeenRange> ranges;
};

struct Recorder : pipeline::DrawObserver {
  std::vector<SeenDraw> draws;
  void target_changed(const pipeline::Framebuffer&) override {}
  void clear(const pipeline::ClearState&) override {}
  void draw(const pipeline::DrawState& state, const pipeline::VertexBatch& batch) override {
    SeenDraw seen{state, batch.count, batch.material_runs.size(), {}};
    for (const pipeline::PrimitiveRange& range : batch.primitives) {
      EXPECT_LE(range.first + range.count, batch.count);
      SeenRange copy{range.mode, range.begins, range.ends, {}};
      for (std::int32_t i = range.first; i < range.first + range.count; ++i) {
        float emission = state.lighting.material.front.emission.x;
        for (const pipeline::MaterialRun& run : batch.material_runs) {
          if (run.first <= i) emission = run.material.front.emission.x;
        }
        copy.vertices.push_back({batch.position_object[0][static_cast<std::size_t>(i)], emission});
      }
      seen.ranges.push_back(copy);
    }
    for (const pipeline::MaterialRun& run : batch.material_runs) EXPECT_LT(run.first, batch.count);
    draws.push_back(seen);
  }
};

class ImmediateMode : public testing::Test {
 protected:
  ImmediateMode() : context_({}, nullptr) {
    EXPECT_TRUE(context_.set_window_size(16, 16, pipeline::ColorFormat::rgba8));
    context_.renderer().set_observer(&recorder_);
  }
  void vertices(int count) {
    for (int i = 0; i < count; ++i) Vertex4f(context_, static_cast<float>(next_++), 0, 0, 1);
  }
  void primitive(GLenum mode, int count) {
    Begin(context_, mode);
    vertices(count);
    End(context_);
  }
  void emission(float red) {
    const GLfloat value[] = {red, 0, 0, 1};
    Materialfv(context_, GL_FRONT_AND_BACK, GL_EMISSION, value);
  }
  const std::vector<SeenDraw>& draws() {
    context_.flush_vertices();
    return recorder_.draws;
  }

  Recorder recorder_;
  Context context_;
  int next_ = 0;
};

TEST_F(ImmediateMode, ConsecutivePrimitivesShareABatch) {
  primitive(GL_TRIANGLES, 3);
  primitive(GL_LINES, 2);
  Begin(context_, GL_QUADS);
  End(context_);
  ASSERT_EQ(draws().size(), 1u);
  EXPECT_EQ(draws()[0].count, 5);
  ASSERT_EQ(draws()[0].ranges.size(), 2u);
  EXPECT_EQ(draws()[0].ranges[1].mode, PrimitiveMode::lines);
}

TEST_F(ImmediateMode, OnlyAChangeThatThePictureCanShowSplitsTheBatch) {
  primitive(GL_POINTS, 1);
  Scalef(context_, 2, 2, 2);
  LoadIdentity(context_);
  PushMatrix(context_);
  Translatef(context_, 1, 1, 1);
  PopMatrix(context_);
  Enable(context_, GL_NORMALIZE);
  DepthFunc(context_, GL_GREATER);
  Enable(context_, GL_LIGHT3);
  ClearColor(context_, 1, 1, 1, 1);
  primitive(GL_POINTS, 1);
  Scalef(context_, 2, 2, 2);
  primitive(GL_POINTS, 1);
  ASSERT_EQ(draws().size(), 2u);
  EXPECT_EQ(draws()[0].count, 2);
  EXPECT_EQ(draws()[0].state.transform.modelview[0][0], 1.0f);
  EXPECT_EQ(draws()[1].state.transform.modelview[0][0], 2.0f);
}

TEST_F(ImmediateMode, WidthsOfLinesDoNotConcernTriangles) {
  primitive(GL_TRIANGLES, 3);
  LineWidth(context_, 3);
  PointSize(context_, 5);
  primitive(GL_TRIANGLES, 3);
  LineWidth(context_, 4);
  primitive(GL_LINES, 2);
  PolygonOffset(context_, 1, 1);
  Enable(context_, GL_POLYGON_SMOOTH);  // there are triangles
  primitive(GL_LINES, 2);
  LineWidth(context_, 2);
  primitive(GL_LINES, 2);
  Disable(context_, GL_POLYGON_SMOOTH);  // there are none
  primitive(GL_LINES, 2);
  ASSERT_EQ(draws().size(), 3u);
  EXPECT_EQ(draws()[0].count, 8);
  EXPECT_EQ(draws()[0].state.lines.width_px, 4.0f);
  EXPECT_EQ(draws()[1].state.lines.width_px, 4.0f);
  EXPECT_EQ(draws()[2].state.lines.width_px, 2.0f);
  EXPECT_EQ(draws()[2].count, 4);
}

TEST_F(ImmediateMode, WidthsOfLinesConcernTrianglesThatAreDrawnAsLines) {
  PolygonMode(context_, GL_FRONT, GL_LINE);
  primitive(GL_TRIANGLES, 3);
  LineWidth(context_, 3);
  primitive(GL_TRIANGLES, 3);
  EXPECT_EQ(draws().size(), 2u);
}

TEST_F(ImmediateMode, ClearComesAfterTheVerticesBeforeIt) {
  primitive(GL_POINTS, 1);
  Clear(context_, GL_COLOR_BUFFER_BIT);
  EXPECT_EQ(recorder_.draws.size(), 1u);
}

TEST_F(ImmediateMode, MaterialChangesBecomeRunsInsideAndBetweenPrimitives) {
  Enable(context_, GL_LIGHTING);
  emission(0.1f);
  Begin(context_, GL_TRIANGLES);
  vertices(1);
  emission(0.2f);
  emission(0.3f);
  vertices(1);
  emission(0.3f);
  vertices(1);
  End(context_);
  emission(0.4f);
  primitive(GL_POINTS, 1);
  emission(0.5f);
  ASSERT_EQ(draws().size(), 1u);
  EXPECT_EQ(draws()[0].runs, 2u);
  const auto& ranges = draws()[0].ranges;
  EXPECT_EQ(ranges[0].vertices, (std::vector<SeenVertex>{{0, 0.1f}, {1, 0.3f}, {2, 0.3f}}));
  EXPECT_EQ(ranges[1].vertices, (std::vector<SeenVertex>{{3, 0.4f}}));

  primitive(GL_POINTS, 1);
  ASSERT_EQ(draws().size(), 2u);
  EXPECT_EQ(draws()[1].runs, 0u);
  EXPECT_EQ(draws()[1].ranges[0].vertices[0].emission, 0.5f);
}

TEST_F(ImmediateMode, MaterialsWithoutLightingChangeNothing) {
  primitive(GL_POINTS, 1);
  emission(0.7f);
  primitive(GL_POINTS, 1);
  ASSERT_EQ(draws().size(), 1u);
  EXPECT_EQ(draws()[0].runs, 0u);
}

TEST_F(ImmediateMode, ParametersThatFollowTheColorMakeNoRuns) {
  Enable(context_, GL_LIGHTING);
  ColorMaterial(context_, GL_FRONT_AND_BACK, GL_EMISSION);
  Enable(context_, GL_COLOR_MATERIAL);
  Begin(context_, GL_POINTS);
  for (int i = 0; i < 5; ++i) {
    Color4f(context_, static_cast<float>(i), 0, 0, 1);
    emission(0.5f);
    vertices(1);
  }
  End(context_);
  ASSERT_EQ(draws().size(), 1u);
  EXPECT_EQ(draws()[0].runs, 0u);
  EXPECT_EQ(draws()[0].state.lighting.material, pipeline::MaterialPair());
}

TEST_F(ImmediateMode, KeepsTheDemandedAttributes) {
  Enable(context_, GL_LIGHTING);
  Enable(context_, GL_LIGHT0);
  Begin(context_, GL_POINTS);
  Normal3f(context_, 1, 2, 3);
  vertices(1);
  const auto& batch = context_.immediate.batch;
  EXPECT_EQ(batch.normal_object[0][0], 1.0f);
  EXPECT_EQ(batch.normal_object[2][0], 3.0f);
  End(context_);
  Disable(context_, GL_LIGHTING);
  Begin(context_, GL_POINTS);
  Color4f(context_, 5, 6, 7, 8);
  vertices(1);
  EXPECT_EQ(batch.color[0][0], 5.0f);
  EXPECT_EQ(batch.color[3][0], 8.0f);
  End(context_);
}

TEST_F(ImmediateMode, DropsVerticesThatCannotBeSeenOrBelongToNoPrimitive) {
  vertices(3);
  EXPECT_EQ(context_.immediate.batch.count, 0);
  ColorMask(context_, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  primitive(GL_TRIANGLES, 3000);
  EXPECT_TRUE(draws().empty());
  ColorMask(context_, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  primitive(GL_TRIANGLES, 3);
  EXPECT_EQ(draws().size(), 1u);
}

TEST_F(ImmediateMode, WithoutATargetDrawsNothing) {
  Context context({}, nullptr);
  Begin(context, GL_POINTS);
  Vertex4f(context, 0, 0, 0, 1);
  End(context);
  EXPECT_EQ(context.immediate.batch.count, 0);
}

TEST_F(ImmediateMode, ANewTargetEndsAnOpenPrimitive) {
  Begin(context_, GL_POINTS);
  vertices(2);
  ASSERT_TRUE(context_.set_window_size(4, 4, pipeline::ColorFormat::rgba8));
  EXPECT_FALSE(context_.inside_begin_end());
  EXPECT_EQ(recorder_.draws.size(), 1u);
  vertices(1);
  EXPECT_EQ(context_.immediate.batch.count, 0);
}

// The simple primitives that a vertex sequence makes, each as its vertices' numbers, in order: what assembly must find
// again in the ranges, however they are cut.
using Simple = std::vector<int>;

int orientation_start(PrimitiveMode mode, bool begins) {  // vertices before the first simple primitive that is new
  switch (mode) {
    case PrimitiveMode::line_strip:
      return 1;
    case PrimitiveMode::triangle_strip:
    case PrimitiveMode::quad_strip:
      return 2;
    case PrimitiveMode::triangle_fan:
    case PrimitiveMode::polygon:
      return 2;
    case PrimitiveMode::line_loop:
      return begins ? 1 : 2;
    default:
      return 0;
  }
}

void decompose(const SeenRange& range, std::vector<Simple>& out) {
  std::vector<int> v;
  for (const SeenVertex& vertex : range.vertices) v.push_back(static_cast<int>(vertex.x));
  const int n = static_cast<int>(v.size());
  const auto at = [&](int i) { return v[static_cast<std::size_t>(i)]; };
  const auto separate = [&](int size) {
    for (int i = 0; i + size <= n; i += size) out.emplace_back(v.begin() + i, v.begin() + i + size);
  };
  switch (range.mode) {
    case PrimitiveMode::points:
      return separate(1);
    case PrimitiveMode::lines:
      return separate(2);
    case PrimitiveMode::triangles:
      return separate(3);
    case PrimitiveMode::quads:
      return separate(4);
    default:
      break;
  }
  for (int i = orientation_start(range.mode, range.begins); i < n; ++i) {
    switch (range.mode) {
      case PrimitiveMode::line_strip:
        out.push_back({at(i - 1), at(i)});
        break;
      case PrimitiveMode::line_loop:
        out.push_back({at(i - 1), at(i)});
        break;
      case PrimitiveMode::triangle_strip:
        out.push_back(i % 2 == 0 ? Simple{at(i - 2), at(i - 1), at(i)} : Simple{at(i - 1), at(i - 2), at(i)});
        break;
      case PrimitiveMode::quad_strip:
        if (i % 2 == 1) out.push_back({at(i - 3), at(i - 2), at(i), at(i - 1)});
        break;
      default:
        out.push_back({at(0), at(i - 1), at(i)});
        break;
    }
  }
  if (range.mode == PrimitiveMode::line_loop && range.ends) out.push_back({at(n - 1), at(0)});
}

TEST_F(ImmediateMode, LongPrimitivesAreCutSoThatNothingIsLostOrDrawnTwice) {
  for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
    for (const int before : {0, 1, 500, 1007, 1008, 1009, 1019}) {
      for (const int count : {12, 1019, 1020, 1021, 1022, 2040, 5000}) {
        next_ = -before;
        primitive(GL_POINTS, before);
        primitive(mode, count);
        context_.flush_vertices();

        SeenRange whole{static_cast<PrimitiveMode>(mode), true, true, {}};
        for (int i = 0; i < count; ++i) whole.vertices.push_back({static_cast<float>(i), 0});
        std::vector<Simple> expected, found;
        decompose(whole, expected);
        bool first = true;
        for (const SeenDraw& draw : recorder_.draws) {
          for (const SeenRange& range : draw.ranges) {
            if (range.vertices[0].x < 0) continue;
            EXPECT_EQ(range.begins, first);
            first = false;
            decompose(range, found);
          }
        }
        EXPECT_TRUE(recorder_.draws.back().ranges.back().ends);
        EXPECT_EQ(found, expected) << "mode " << mode << ", " << count << " vertices after " << before;
        recorder_.draws.clear();
      }
    }
  }
}

TEST_F(ImmediateMode, CarriedVerticesKeepTheirMaterials) {
  Enable(context_, GL_LIGHTING);
  for (GLenum mode : {GL_LINE_STRIP, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_LINE_LOOP, GL_POINTS}) {
    next_ = 0;
    Begin(context_, mode);
    for (int i = 0; i < 3000; ++i) {
      emission(static_cast<float>(i / 2));
      vertices(1);
    }
    End(context_);
    context_.flush_vertices();
    for (const SeenDraw& draw : recorder_.draws) {
      for (const SeenVertex& vertex : draw.ranges[0].vertices) {
        ASSERT_EQ(vertex.emission, static_cast<float>(static_cast<int>(vertex.x) / 2)) << "mode " << mode;
      }
    }
    recorder_.draws.clear();
  }
}

}  // namespace
}  // namespace gouraud::api
