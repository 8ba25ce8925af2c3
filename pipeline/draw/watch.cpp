#include "pipeline/draw/watch.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <utility>

#include "pipeline/draw/phong_shading.h"
#include "pipeline/fragment/alpha.h"
#include "pipeline/fragment/blend.h"
#include "pipeline/fragment/color_sum.h"
#include "pipeline/fragment/color_write.h"
#include "pipeline/fragment/coverage.h"
#include "pipeline/fragment/depth.h"
#include "pipeline/fragment/depth_methods.h"
#include "pipeline/fragment/fog.h"
#include "pipeline/fragment/interpolation_methods.h"
#include "pipeline/fragment/polygon_stipple.h"
#include "pipeline/fragment/sample_alpha.h"
#include "pipeline/fragment/sample_count.h"
#include "pipeline/fragment/stencil.h"
#include "pipeline/fragment/varyings.h"
#include "pipeline/raster/primitive.h"
#include "pipeline/texture/texture_pass.h"

namespace gouraud::pipeline {
namespace {

[[gnu::format(printf, 2, 3)]] void append(std::string& text, const char* format, ...) {
  std::array<char, 256> line{};
  std::va_list values;
  va_start(values, format);
  std::vsnprintf(line.data(), line.size(), format, values);
  va_end(values);
  text += line.data();
}

/// What the pixel holds.
struct Stored {
  std::array<int, 4> color{};  ///< of an 8-bit target
  double depth = 0;            ///< in [0, 1]
  int stencil = -1;            ///< -1: not in the depth buffer's words
  bool operator==(const Stored&) const = default;
};

template <class Word>
Word load(const std::byte* pixels, std::int32_t pixel) {
  Word word;
  std::memcpy(&word, pixels + static_cast<std::size_t>(pixel) * sizeof word, sizeof word);
  return word;
}

Stored stored_at(const TileTarget& target, TargetFormat format, std::int32_t pixel) {
  Stored stored;
  if (target.color != nullptr && format.color == ColorFormat::rgba8) {
    const auto bytes = load<std::array<std::uint8_t, 4>>(target.color, pixel);
    std::copy(bytes.begin(), bytes.end(), stored.color.begin());
  }
  if (target.depth == nullptr) return stored;
  switch (format.depth) {
    case DepthFormat::none: return stored;
    case DepthFormat::z16: stored.depth = load<std::uint16_t>(target.depth, pixel); break;
    case DepthFormat::z24s8: {
      const auto word = load<std::uint32_t>(target.depth, pixel);
      stored.depth = word & 0xFFFFFFu;
      stored.stencil = static_cast<int>(word >> 24);
      break;
    }
    case DepthFormat::z32: stored.depth = load<std::uint32_t>(target.depth, pixel); break;
    case DepthFormat::z32f: stored.depth = static_cast<double>(load<float>(target.depth, pixel)); break;
  }
  stored.depth /= depth_scale(format.depth);
  return stored;
}

/// The watched pixel's lane in the block, or -1.
int lane_of(const Watch& watch, const FragmentBlock& block) {
  const std::int32_t dx = watch.x - block.x, dy = watch.y - block.y;
  return dx >= 0 && dx < 8 && dy >= 0 && dy < 8 ? dy * 8 + dx : -1;
}

std::string describe_fragment(const PixelWatch& watch, const FragmentBlock& block) {
  const PrimitiveRecord& record = *block.primitive;
  std::string text;
  const char* const kind = !record.is_polygon ? "a point, line or image" : record.back ? "a polygon's back" : "a polygon";
  append(text, "pixel %d,%d: draw %lld, a fragment of %s", watch.watch.x, watch.watch.y, static_cast<long long>(watch.draw), kind);
  if (watch.target.depth != DepthFormat::none && record.binding->image == nullptr) {
    const DepthPlane& plane = record.depth;
    const double depth = (plane.origin + plane.dx * watch.watch.x) + plane.dy * watch.watch.y;
    append(text, ", depth %.7f", std::clamp<double>(depth, plane.minimum, plane.maximum) / depth_scale(watch.target.depth));
  }
  return text + "\n";
}

void append_change(std::string& text, const Stored& before, const Stored& after) {
  if (after.depth != before.depth) append(text, ", depth %.7f -> %.7f", before.depth, after.depth);
  if (after.stencil != before.stencil) append(text, ", stencil %d -> %d", before.stencil, after.stencil);
  if (after.color != before.color) {
    const auto &b = before.color, &a = after.color;
    append(text, ", color (%d %d %d %d) -> (%d %d %d %d)", b[0], b[1], b[2], b[3], a[0], a[1], a[2], a[3]);
  }
}

constexpr std::string_view coloring[] = {"interpolate colors", "texture", "light the fragment", "add the secondary color", "fog", "coverage"};
bool is_coloring(std::string_view name) { return std::ranges::find(coloring, name) != std::end(coloring); }

std::string describe_step(const PixelWatch& watch, std::size_t i, const FragmentBlock& block, int lane, const Stored& before, const Stored& after) {
  const std::string_view name = watch.names[i];
  std::string text = "  " + std::string(name);
  if ((block.coverage >> lane & 1) == 0) {
    append(text, ": fails");
    if (name.find("depth") != name.npos) append(text, " against %.7f", before.depth);
    append_change(text, before, after);
    return text + "\n";
  }
  if (is_coloring(name)) {
    const bool in_words = watch.passes.pass[i] == texture_words_pass();
    const auto behind_textures = [&](std::size_t k) { return watch.names[k] == "texture"; };
    bool textured = false;
    for (std::size_t k = 0; k <= i; ++k) textured |= behind_textures(k);
    const float scale = textured ? color_scale(watch.target.color) : watch.color_scale;
    std::array<double, 4> color{};
    for (std::size_t c = 0; c < 4; ++c) {
      const auto at = static_cast<std::size_t>(lane);
      const int byte = block.words.word[at] >> (8 * c) & 0xFF;
      color[c] = in_words ? byte / 255.0 : static_cast<double>(block.color[c][at] / scale);
    }
    append(text, ": (%.4f %.4f %.4f %.4f)", color[0], color[1], color[2], color[3]);
  } else if (name.find("test") != name.npos) {
    append(text, ": passes");
    if (name.find("depth") != name.npos && after.depth == before.depth) append(text, " against %.7f", before.depth);
  }
  append_change(text, before, after);
  return text + "\n";
}

template <std::size_t i>
void step(FragmentBlock& block, const TileTarget& target) {
  const PixelWatch& watch = *block.primitive->binding->watch;
  const int lane = lane_of(watch.watch, block);
  if (lane < 0 || (block.coverage >> lane & 1) == 0) return watch.passes.pass[i](block, target);
  std::string text = i == 0 ? describe_fragment(watch, block) : std::string();
  const Stored before = stored_at(target, watch.target, block.first_pixel + lane);
  watch.passes.pass[i](block, target);
  const Stored after = stored_at(target, watch.target, block.first_pixel + lane);
  watch.watch.tell(text + describe_step(watch, i, block, lane, before, after));
}

template <std::size_t... i>
constexpr std::array<FragmentPass, sizeof...(i)> all_steps(std::index_sequence<i...>) {
  return {step<i>...};
}
constexpr auto steps = all_steps(std::make_index_sequence<FragmentPasses::max_passes>());

std::string_view name_of(FragmentPass pass, const DrawState& state, const Plan& plan, TargetFormat target) {
  const std::pair<FragmentPass, std::string_view> names[] = {
      {polygon_stipple_pass(), "polygon stipple test"},
      {color_interpolation_pass(target.methods.colors), "interpolate colors"},
      {varying_interpolation_pass(target.methods.colors, LanesWanted::all), "interpolate coordinates"},
      {varying_interpolation_pass(target.methods.colors, LanesWanted::covered), "interpolate coordinates"},
      {phong_shading_pass(), "light the fragment"},
      {texture_pass(), "texture"},
      {texture_words_pass(), "texture"},
      {color_sum_pass(target.color), "add the secondary color"},
      {coverage_pass(), "coverage"},
      {sample_alpha_pass(target.color), "alpha to samples"},
      {alpha_test_pass(target.color), "alpha test"},
      {hidden_fragments_pass(), "depth test before shading"},
      {depth_test_pass(state.raster.depth.func, target.depth), "depth test"},
      {stencil_pass(target.depth), plan.depth ? "stencil and depth test" : "stencil test"},
      {sample_count_pass(), "count samples"},
  };
  for (const auto& [known, name] : names) {
    if (known == pass) return name;
  }
  if (plan.fog && pass == fog_pass(state.raster.fog.mode, target.color)) return "fog";
  if (plan.fog && pass == fogged_color_write_pass(state.raster.fog.mode)) return "fog and write color";
  if (target.methods.warps_depth() && pass == depth_method_pass(state.raster.depth.func, target.depth)) return "depth test";
  return plan.blends ? "blend and write color" : "write color";
}

}  // namespace

PixelWatch make_pixel_watch(const Watch& watch, std::int64_t draw, const FragmentPasses& passes, const DrawState& state,
                            const Plan& plan, TargetFormat target) {
  PixelWatch result{watch, draw, passes, {}, target, plan.textured ? 1.0f : color_scale(target.color)};
  for (std::size_t i = 0; i < static_cast<std::size_t>(passes.count); ++i) {
    result.names[i] = name_of(passes.pass[i], state, plan, target);
  }
  return result;
}

FragmentPasses watched(const FragmentPasses& passes) {
  FragmentPasses result = passes;
  for (std::size_t i = 0; i < static_cast<std::size_t>(passes.count); ++i) result.pass[i] = steps[i];
  result.small_triangles = {};
  result.group_depth = nullptr;
  result.early = result.shaded = 0;  // a fragment's passes one after the other, anew for each sample
  return result;
}

std::string describe_vertex(const DrawState& state, const Plan& plan, const VertexBatch& batch, const ProcessedVertices& vertices,
                            std::int32_t vertex) {
  const auto i = static_cast<std::size_t>(vertex);
  std::string text;
  const auto line = [&](const char* name, const auto& arrays) {
    append(text, "  %s (", name);
    for (std::size_t c = 0; c < arrays.size(); ++c) append(text, c == 0 ? "%g" : " %g", static_cast<double>(arrays[c][i]));
    text += ")\n";
  };
  line("object space", batch.position_object);
  if (plan.eye_positions) line("eye space", vertices.position_eye);
  if (plan.normals) line("normal in eye space", vertices.normal_eye);
  line("clip space", vertices.position_clip);
  const std::uint16_t outcode = vertices.outcode[i];
  if (outcode != 0) {
    constexpr std::array<const char*, 7> planes{"right", "left", "top", "bottom", "near", "far", "no number"};
    text += "  outside:";
    for (std::size_t k = 0; k < planes.size(); ++k) {
      if ((outcode >> k & 1) != 0) append(text, " %s", planes[k]);
    }
    text += (outcode >= outside_clip_plane_0 ? " a clip plane\n" : "\n");
  } else {
    const double w = vertices.position_clip[3][i];
    append(text, "  normalized (%g %g %g)\n", vertices.position_clip[0][i] / w, vertices.position_clip[1][i] / w, vertices.position_clip[2][i] / w);
    const WindowVertex& window = vertices.window[i];
    append(text, "  window (%g %g %g)\n", static_cast<double>(window.x), state.viewport.target_height_px - static_cast<double>(window.y_raster),
           static_cast<double>(window.z));
  }
  const Rgba& color = vertices.color_front[i];
  if (plan.colors) {
    append(text, "  %s (%g %g %g %g)\n", plan.lighting ? "lit color" : "color", static_cast<double>(color.r), static_cast<double>(color.g),
           static_cast<double>(color.b), static_cast<double>(color.a));
  }
  return text;
}

}  // namespace gouraud::pipeline
