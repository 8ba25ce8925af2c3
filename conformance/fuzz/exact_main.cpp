// fuzz_exact SEED COUNT [FEATURES]
//
// Draws the random pictures of the seeds from SEED on with ours, watched by the oracle, those of odd seeds with four samples a
// pixel, and prints each that is not what the oracle allows: how many pixels are off, and the fewest features that it needs. FEATURES, a mask in hexadecimal, is taken
// instead of those that a seed chooses, and the pixels are listed then. Fails if a picture is off.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "api/gouraud.h"
#include "conformance/fuzz/pictures.h"
#include "conformance/harness/linked_osmesa.h"
#include "conformance/harness/offscreen.h"
#include "conformance/oracle/oracle.h"

namespace gouraud::conformance {
namespace {

/// As the scenes are judged [ARCHITECTURE §5].
constexpr double most_color = 1.0, most_depth = 1.0;

struct Exact {
  Picture ours;
  oracle::OraclePicture oracle;
};

/// Draws into a framebuffer of four samples a pixel, and resolves that.
void draw_sampled(const GlTable& gl, std::uint32_t seed, std::uint64_t features) {
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  const auto attach = [&gl](GLenum attachment, GLenum format) {
    GLuint name = 0;
    gl.GenRenderbuffers(1, &name);
    gl.BindRenderbuffer(GL_RENDERBUFFER, name);
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, 4, format, picture_side_px, picture_side_px);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
  };
  attach(GL_COLOR_ATTACHMENT0, GL_RGBA8);
  attach(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8);
  draw_picture(gl, seed, features);
  gl.Disable(GL_SCISSOR_TEST);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl.BlitFramebuffer(0, 0, picture_side_px, picture_side_px, 0, 0, picture_side_px, picture_side_px, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

Exact draw(std::uint32_t seed, std::uint64_t features) {
  OffscreenContext context(linked_osmesa, picture_side_px, picture_side_px, 24);
  oracle::Oracle oracle;
  if (!set_draw_observer(&oracle)) throw std::runtime_error("set_draw_observer found no context");
  const bool sampled = seed % 2 != 0;
  sampled ? draw_sampled(context.gl(), seed, features) : draw_picture(context.gl(), seed, features);
  Exact result{context.read(), oracle.picture()};
  set_draw_observer(nullptr);
  return result;
}

oracle::PixelError error_at(const Exact& exact, int x, int y) {
  const std::size_t index = exact.oracle.index(x, y);
  if ((exact.oracle.flags[index] & oracle::pixel_alternatives_lost) != 0) return {};
  const std::uint8_t* const rgba = &exact.ours.rgba[4 * index];
  return oracle::measure(exact.oracle, x, y, {rgba[0], rgba[1], rgba[2], rgba[3]}, exact.ours.depth[index]);
}

bool is_off(const oracle::PixelError& error) { return error.color > most_color || error.depth > most_depth; }

/// Pixels that the oracle does not allow; `tell` is called with each.
template <class Tell>
int pixels_off(const Exact& exact, Tell tell) {
  int count = 0;
  for (int y = 0; y < picture_side_px; ++y) {
    for (int x = 0; x < picture_side_px; ++x) {
      const oracle::PixelError error = error_at(exact, x, y);
      if (!is_off(error)) continue;
      ++count;
      tell(x, y, error);
    }
  }
  return count;
}
int pixels_off(const Exact& exact) {
  return pixels_off(exact, [](int, int, const oracle::PixelError&) {});
}

/// Whether the picture judges fairly at all.
bool is_off(std::uint32_t seed, std::uint64_t features) {
  const Exact exact = draw(seed, features);
  return exact.oracle.knife_edge_vertices == 0 && pixels_off(exact) > 0;
}

/// Drops features as long as the difference stays.
std::uint64_t minimal(std::uint32_t seed, std::uint64_t features) {
  for (std::size_t i = 0; i < all_features().size(); ++i) {
    const std::uint64_t without = features & ~(std::uint64_t{1} << i);
    if (without != features && is_off(seed, without)) features = without;
  }
  return features;
}

std::string names_of(std::uint64_t features) {
  std::string names;
  for (std::size_t i = 0; i < all_features().size(); ++i) {
    if ((features >> i & 1) != 0) names += std::string(" ") + all_features()[i].name;
  }
  return names;
}

void list_pixels(const Exact& exact) {
  pixels_off(exact, [&](int x, int y, const oracle::PixelError& error) {
    const std::size_t index = exact.oracle.index(x, y);
    const oracle::OraclePixel& pixel = exact.oracle.pixels[index];
    const std::uint8_t* const rgba = &exact.ours.rgba[4 * index];
    std::printf("  (%d, %d): colour off by %.2f, depth by %.2f; ours %d %d %d %d, %u; the oracle's", x, y, error.color, error.depth, rgba[0], rgba[1],
                rgba[2], rgba[3], exact.ours.depth[index]);
    for (std::size_t c = 0; c < 4; ++c) {
      std::printf(" %.2f (%.2f to %.2f)", 255 * pixel.color[c], 255.0 * static_cast<double>(pixel.color_lowest[c]), 255.0 * static_cast<double>(pixel.color_highest[c]));
    }
    std::printf(", %.1f; flags %d\n", pixel.depth_units, exact.oracle.flags[index]);
  });
}

/// True if it is off.
bool judge(std::uint32_t seed, std::uint64_t features, bool lists) {
  if (!is_off(seed, features)) return false;
  const std::uint64_t fewest = lists ? features : minimal(seed, features);
  const Exact exact = draw(seed, fewest);
  std::printf("%u %llx: %d pixels,%s\n", seed, static_cast<unsigned long long>(fewest), pixels_off(exact), names_of(fewest).c_str());
  if (lists) list_pixels(exact);
  std::fflush(stdout);
  return true;
}

}  // namespace
}  // namespace gouraud::conformance

int main(int argc, char** argv) {
  using namespace gouraud::conformance;
  try {
    if (argc != 3 && argc != 4) throw std::runtime_error("usage: fuzz_exact SEED COUNT [FEATURES]");
    const auto first = static_cast<std::uint32_t>(std::strtoul(argv[1], nullptr, 10));
    const auto count = static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10));
    int cases = 0;
    for (std::uint32_t seed = first; seed != first + count; ++seed) {
      cases += judge(seed, argc == 4 ? std::strtoull(argv[3], nullptr, 16) : choose_features(seed), argc == 4) ? 1 : 0;
    }
    std::printf("%u pictures, %d off\n", count, cases);
    return cases > 0 ? 1 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fuzz_exact: %s\n", error.what());
    return 2;
  }
}
