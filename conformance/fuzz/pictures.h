// Random pictures: a few features of the GL switched on at random, and a few primitives. The same calls for every library.
//
// Each feature draws its numbers from a sequence of its own, so that a picture without one of its features is the same
// picture otherwise: that is how pictures.py finds the features that a difference needs.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <tuple>
#include <vector>

#include "conformance/scenes/shapes.h"
#include "gl_table.h"

namespace gouraud::conformance {

constexpr int picture_side_px = 64;

/// Random numbers of sensible kinds, and the table of commands.
class Brush {
 public:
  Brush(const GlTable& table, Random numbers) : gl(table), random(numbers) {}

  const GlTable& gl;
  Random random;

  int below(int count) { return random.below(count); }
  bool chance(int of) { return below(of) == 0; }
  float range(float lowest, float highest) { return random.range(lowest, highest); }
  GLenum one_of(std::initializer_list<GLenum> values) { return *(values.begin() + below(static_cast<int>(values.size()))); }
  GLenum comparison() { return static_cast<GLenum>(GL_NEVER + below(8)); }
  /// Of few values: products of them are seldom near a half.
  float level() { return static_cast<float>(below(16)) / 15.0f; }
  struct Four {
    float v[4];
  };
  Four color() {
    Four result{};
    for (float& value : result.v) value = level();
    return result;
  }
  Four point() {
    Four result{};
    for (float& value : result.v) value = range(-1.0f, 1.0f);
    return result;
  }
};

/// Calls a command with arguments from a braced tuple: they are drawn in order with every compiler.
template <class... Parameters, class... Arguments>
void in_order(void (*command)(Parameters...), const std::tuple<Arguments...>& arguments) {
  std::apply([command](const auto&... argument) { command(static_cast<Parameters>(argument)...); }, arguments);
}

/// What a picture may have beside its primitives. `prepare` comes before them.
struct Feature {
  const char* name;
  void (*prepare)(Brush& brush);
};

/// In the order in which they are prepared. Pixels come before the features that Mesa leaves out for them (it textures no
/// pixel rectangles, and fogs them as if they were at the eye).
std::span<const Feature> state_features();
std::span<const Feature> pixel_features();
std::span<const Feature> fragment_color_features();

/// Scales of 1, no biases, no maps.
void initial_pixel_transfer(const GlTable& gl);

/// Draws a few primitives, by Begin and End, arrays, buffers, lists or evaluators.
void draw_primitives(Brush& brush);

/// All of them; bit i of a mask is the feature i.
const std::vector<Feature>& all_features();

/// One to four of them (now and then more).
std::uint64_t choose_features(std::uint32_t seed);

/// The whole picture, cleared first. Pixel transfer and pixel storage are as they were at first when it is done.
void draw_picture(const GlTable& gl, std::uint32_t seed, std::uint64_t features);

}  // namespace gouraud::conformance
