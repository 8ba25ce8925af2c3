// For tests: a current context with a small target.
#pragma once

#include <cstdint>
#include <vector>

#include <GL/gl.h>
#include <gtest/gtest.h>

#include "api/context/context.h"

namespace gouraud::api {

inline constexpr int side_px = 32;

/// A context that is current while it lives, and its picture.
struct Screen {
  explicit Screen(Context* share_with = nullptr) : context({}, share_with) {
    EXPECT_TRUE(context.set_window_size(side_px, side_px, pipeline::ColorFormat::rgba8));
    make_current(&context);
  }
  std::vector<std::uint32_t> pixels() {
    std::vector<std::uint32_t> result(side_px * side_px);
    glReadPixels(0, 0, side_px, side_px, GL_RGBA, GL_UNSIGNED_BYTE, result.data());
    return result;
  }
  Context context;
};

}  // namespace gouraud::api
