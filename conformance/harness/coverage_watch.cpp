#include "conformance/harness/coverage_watch.h"

#include <array>
#include <cstddef>
#include <cstring>

namespace gouraud::conformance {
namespace {

CoverageWatch* current = nullptr;

}  // namespace

CoverageWatch::CoverageWatch(OffscreenContext& context)
    : context_(context), gl_(context.gl()), background_(context.read()), plain_background_(background_) {
  covered_.resize(background_.pixel_count());
  gl_.Clear = &watched_clear;
  current = this;
}

CoverageWatch::~CoverageWatch() { current = nullptr; }

void APIENTRY CoverageWatch::watched_clear(GLbitfield mask) { current->clear(mask); }

void CoverageWatch::clear(GLbitfield mask) {
  const GlTable& gl = context_.gl();
  mark(context_.read(), background_);

  std::array<float, 4> color;
  gl.GetFloatv(GL_COLOR_CLEAR_VALUE, color.data());
  gl.Clear(mask);
  const Picture plain = context_.read();

  std::array<float, 4> other = color;
  for (float& channel : other) channel += channel < 0.5f ? 0.5f : -0.5f;
  gl.ClearColor(other[0], other[1], other[2], other[3]);
  gl.Clear(mask);
  gl.ClearColor(color[0], color[1], color[2], color[3]);
  background_ = context_.read();

  // Where the two differ the clear reached the channel; elsewhere the plain background stays as it was. A pixel whose
  // four channels were all cleared begins anew.
  for (std::size_t pixel = 0; pixel < covered_.size(); ++pixel) {
    int cleared_channels = 0;
    for (std::size_t i = 4 * pixel; i < 4 * pixel + 4; ++i) {
      if (plain.rgba[i] == background_.rgba[i]) continue;
      plain_background_.rgba[i] = plain.rgba[i];
      ++cleared_channels;
    }
    if (cleared_channels == 4) covered_[pixel] = 0;
  }
  plain_background_.depth = plain.depth;
}

std::vector<std::uint8_t> CoverageWatch::covered(const Picture& plain) {
  mark(context_.read(), background_);
  mark(plain, plain_background_);
  return covered_;
}

void CoverageWatch::mark(const Picture& now, const Picture& background) {
  for (std::size_t i = 0; i < covered_.size(); ++i) {
    const bool color_differs = std::memcmp(&now.rgba[4 * i], &background.rgba[4 * i], 4) != 0;
    const bool depth_differs = !now.depth.empty() && now.depth[i] != background.depth[i];
    if (color_differs || depth_differs) covered_[i] = 1;
  }
}

}  // namespace gouraud::conformance
