#include "api/context/context.h"

#include <gtest/gtest.h>

#include <memory>
#include <thread>

#include "api/gouraud.h"

namespace gouraud::api {
namespace {

constexpr auto rgba8 = pipeline::ColorFormat::rgba8;

TEST(Errors, TheFirstOneSticksUntilItIsTaken) {
  Context context({}, nullptr);
  EXPECT_EQ(context.take_error(), static_cast<GLenum>(GL_NO_ERROR));
  context.record_error(GL_INVALID_VALUE, "glA", "");
  context.record_error(GL_INVALID_ENUM, "glB", "");
  EXPECT_EQ(context.take_error(), static_cast<GLenum>(GL_INVALID_VALUE));
  EXPECT_EQ(context.take_error(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(Errors, AbortAtTheCulpritOnDemand) {
  EXPECT_DEATH(
      {
        setenv("GOURAUD_ABORT_ON_ERROR", "1", 1);
        Context context({}, nullptr);
        context.record_error(GL_INVALID_VALUE, "glViewport", "width is negative");
      },
      "glViewport: GL_INVALID_VALUE: width is negative");
}

TEST(CurrentContext, IsThisThreadsAlone) {
  Context context({}, nullptr);
  make_current(&context);
  EXPECT_EQ(current_context(), &context);
  std::thread([] { EXPECT_EQ(current_context(), nullptr); }).join();
  make_current(nullptr);
  EXPECT_EQ(current_context(), nullptr);
}

TEST(CurrentContext, IsReleasedWithACopyOut) {
  Context a({}, nullptr), b({}, nullptr);
  int copies = 0;
  a.copy_out = [&] { ++copies; };
  make_current(&a);
  make_current(&a);
  EXPECT_EQ(copies, 0);
  make_current(&b);
  EXPECT_EQ(copies, 1);
  make_current(nullptr);
  EXPECT_EQ(copies, 1);
}

TEST(CurrentContext, IsNoneAfterItsDestruction) {
  auto context = std::make_unique<Context>(ContextConfig{}, nullptr);
  make_current(context.get());
  context.reset();
  EXPECT_EQ(current_context(), nullptr);
}

TEST(Target, OnlyTheFirstOneSetsViewportAndScissorBox) {
  Context context({}, nullptr);
  EXPECT_EQ(context.target(), nullptr);
  ASSERT_TRUE(context.set_window_size(30, 20, rgba8));
  EXPECT_EQ(context.state.viewport.width_px, 30);
  EXPECT_EQ(context.state.scissor.height_px, 20);
  const pipeline::Framebuffer* const first = context.target();
  ASSERT_TRUE(context.set_window_size(30, 20, rgba8));
  EXPECT_EQ(context.target(), first);
  ASSERT_TRUE(context.set_window_size(50, 60, rgba8));
  EXPECT_EQ(context.target()->width_px, 50);
  EXPECT_EQ(context.state.viewport.width_px, 30);
  EXPECT_EQ(context.state.scissor.height_px, 20);
}

TEST(Target, OfAnImpossibleSizeIsRefusedAndTheOldOneKept) {
  Context context({}, nullptr);
  ASSERT_TRUE(context.set_window_size(8, 8, rgba8));
  for (const int size : {0, -1, max_target_size_px + 1}) {
    EXPECT_FALSE(context.set_window_size(size, 8, rgba8));
    EXPECT_FALSE(context.set_window_size(8, size, rgba8));
  }
  EXPECT_EQ(context.target()->width_px, 8);
}

TEST(Target, HasTheDepthBufferOfTheConfiguration) {
  using pipeline::DepthFormat;
  EXPECT_EQ(depth_format({0, 8, 0}), DepthFormat::none);
  EXPECT_EQ(depth_format({16, 0, 0}), DepthFormat::z16);
  EXPECT_EQ(depth_format({16, 8, 0}), DepthFormat::z24s8);
  EXPECT_EQ(depth_format({24, 0, 0}), DepthFormat::z24s8);
  EXPECT_EQ(depth_format({32, 8, 0}), DepthFormat::z32f);
}

struct CountingObserver : pipeline::DrawObserver {
  int targets = 0;
  void target_changed(const pipeline::Framebuffer&) override { ++targets; }
  void draw(const pipeline::DrawState&, const pipeline::VertexBatch&) override {}
  void clear(const pipeline::ClearState&) override {}
};

TEST(DrawObserver, NeedsACurrentContextAndLearnsOfTheTargetAtOnce) {
  CountingObserver observer;
  EXPECT_FALSE(set_draw_observer(&observer));
  Context context({}, nullptr);
  ASSERT_TRUE(context.set_window_size(8, 8, rgba8));
  make_current(&context);
  EXPECT_TRUE(set_draw_observer(&observer));
  EXPECT_EQ(observer.targets, 1);
  EXPECT_TRUE(set_draw_observer(nullptr));
  make_current(nullptr);
}

}  // namespace
}  // namespace gouraud::api
