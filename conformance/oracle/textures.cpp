#include "conformance/oracle/textures.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "pipeline/texture/image.h"

namespace gouraud::oracle {
namespace {

using pipeline::BaseFormat;
using pipeline::CompareFunc;
using pipeline::Image;
using pipeline::MipFilter;
using pipeline::TexelFilter;
using pipeline::TexelFormat;
using pipeline::TextureTarget;
using pipeline::TextureUnitState;
using pipeline::WrapMode;

/// What a conforming implementation may err by: coordinates by this share of their size and of the texture, the level of
/// detail and depths by this much.
constexpr double coordinate_slack = 1.0 / (1 << 20), lod_slack = 2e-4, ratio_slack = 1e-5, depth_slack = 1e-6;

/// Signs of the errors that are tried out.
struct Errors {
  double s = 0, t = 0, r = 0, lod = 0;
};

template <class Word>
Word word_at(const std::byte* bytes, std::size_t index) {
  Word word;
  std::memcpy(&word, bytes + index * sizeof(Word), sizeof(Word));
  return word;
}

template <class Word>
double unorm_at(const std::byte* bytes, std::size_t index) {
  return word_at<Word>(bytes, index) / static_cast<double>(static_cast<Word>(~Word{0}));
}

const std::byte* texel_bytes(const Image& image, int x, int y, int z) {
  const auto size = static_cast<std::size_t>(bytes_per_texel(image.format));
  if (image.tiles) {
    // The tiles of a slice follow those of the one before.
    const int tiles_y = (image.height + pipeline::tile_size - 1) / pipeline::tile_size;
    const int tile_x = x / pipeline::tile_size, tile_y = y / pipeline::tile_size + z * tiles_y;
    if (const auto* cleared = image.tiles->waiting_clear(tile_x, tile_y)) return reinterpret_cast<const std::byte*>(cleared->data());
    const int block = y % 64 / 8 * 8 + x % 64 / 8, lane = y % 8 * 8 + x % 8;
    return image.tiles->tile_storage(tile_x, tile_y) + static_cast<std::size_t>(block * 64 + lane) * size;
  }
  const auto row = static_cast<std::size_t>(z) * static_cast<std::size_t>(image.height) + static_cast<std::size_t>(y);
  return image.texels.get() + (row * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) * size;
}

Vector4 stored(const Image& image, int x, int y, int z) {
  const std::byte* bytes = texel_bytes(image, x, y, z);
  Vector4 out{};
  const auto fill = [&](std::size_t count, auto value) {
    for (std::size_t k = 0; k < count; ++k) out[k] = value(bytes, k);
  };
  switch (image.format) {
    case TexelFormat::none: break;
    case TexelFormat::r8: fill(1, unorm_at<std::uint8_t>); break;
    case TexelFormat::rg8: fill(2, unorm_at<std::uint8_t>); break;
    case TexelFormat::rgba8: fill(4, unorm_at<std::uint8_t>); break;
    case TexelFormat::r16:
    case TexelFormat::z16: fill(1, unorm_at<std::uint16_t>); break;
    case TexelFormat::rg16: fill(2, unorm_at<std::uint16_t>); break;
    case TexelFormat::rgba16: fill(4, unorm_at<std::uint16_t>); break;
    case TexelFormat::rgba32f: fill(4, word_at<float>); break;
    case TexelFormat::z24s8: out[0] = (word_at<std::uint32_t>(bytes, 0) & 0xFFFFFF) / 16777215.0; break;
    case TexelFormat::z32f: fill(1, word_at<float>); break;
  }
  return out;
}

double linear_light(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

/// [GL1.5 Table 3.21] for four stored channels: of one-channel formats the first, of two-channel ones the first and second.
Color as_seen(BaseFormat format, const Vector4& c, bool four_channels) {
  switch (format) {
    case BaseFormat::alpha: return {0, 0, 0, four_channels ? c[3] : c[0]};
    case BaseFormat::luminance: return {c[0], c[0], c[0], 1};
    case BaseFormat::luminance_alpha: return {c[0], c[0], c[0], four_channels ? c[3] : c[1]};
    case BaseFormat::intensity:
    case BaseFormat::depth: return {c[0], c[0], c[0], c[0]};
    case BaseFormat::rgb: return {c[0], c[1], c[2], 1};
    case BaseFormat::rgba: break;
  }
  return {c[0], c[1], c[2], c[3]};
}

int dimensions(TextureTarget target) {
  return target == TextureTarget::one_d ? 1 : target == TextureTarget::three_d ? 3 : 2;
}

/// Coordinates on one face, in units where 1 is the texture's size, with derivatives.
struct Quotient {
  double value = 0, ddx = 0, ddy = 0;
};
Quotient quotient(double a, double ax, double ay, double b, double bx, double by) {
  return {a / b, (ax * b - a * bx) / (b * b), (ay * b - a * by) / (b * b)};
}

struct Located {
  int face = 0;
  std::array<Quotient, 3> at{};
  double compared = 0;
};

/// Cube maps [GL1.5 §3.8.6]: where the direction hits a face.
Located locate_on_cube(const TextureCoordinate& c, const Errors& errors) {
  std::array<double, 3> direction{c.value[0], c.value[1], c.value[2]};
  const double size = std::max({std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2])});
  const std::array<double, 3> sign{errors.s, errors.t, errors.r};
  for (std::size_t k = 0; k < 3; ++k) direction[k] += sign[k] * size * coordinate_slack;
  const double x = std::abs(direction[0]), y = std::abs(direction[1]), z = std::abs(direction[2]);
  const std::size_t major = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  const bool negative = direction[major] < 0;
  // [GL1.5 Table 3.20]: axis and sign of s_c and t_c.
  struct Axis {
    std::size_t axis;
    double sign;
  };
  constexpr std::array<std::array<Axis, 2>, 6> table{{{{{2, -1}, {1, -1}}}, {{{2, 1}, {1, -1}}}, {{{0, 1}, {2, 1}}},
                                                      {{{0, 1}, {2, -1}}}, {{{0, 1}, {1, -1}}}, {{{0, -1}, {1, -1}}}}};
  Located out;
  out.face = static_cast<int>(2 * major) + (negative ? 1 : 0);
  const double m = negative ? -1 : 1;
  for (std::size_t k = 0; k < 2; ++k) {
    const Axis& a = table[static_cast<std::size_t>(out.face)][k];
    const double scale = a.sign / 2;
    out.at[k] = quotient(scale * direction[a.axis], scale * c.ddx[a.axis], scale * c.ddy[a.axis], m * direction[major],
                         m * c.ddx[major], m * c.ddy[major]);
    out.at[k].value += 0.5;
  }
  return out;
}

Located locate(const TextureUnitState& unit, const TextureCoordinate& c, const Errors& errors) {
  if (unit.target == TextureTarget::cube_map) return locate_on_cube(c, errors);
  Located out;
  const std::array<double, 3> sign{errors.s, errors.t, errors.r};
  for (std::size_t k = 0; k < 3; ++k) {
    out.at[k] = quotient(c.value[k], c.ddx[k], c.ddy[k], c.value[3], c.ddx[3], c.ddy[3]);
    if (!std::isfinite(out.at[k].value)) out.at[k] = {};
    const double unit_size = unit.target == TextureTarget::rectangle ? 16.0 : 1.0;
    if (k < 2 || !unit.sampler.compares) out.at[k].value += sign[k] * coordinate_slack * (std::abs(out.at[k].value) + unit_size);
  }
  out.compared = std::clamp(out.at[2].value, 0.0, 1.0) + errors.r * depth_slack;
  return out;
}

/// One level of one face, filtered.
class Level {
 public:
  Level(const TextureUnitState& unit, int face, int level) : unit_(unit), face_(face), level_(level) {
    const Image& image = this->image(face);
    border_ = image.border;
    size_ = {image.width - 2 * border_, image.height, image.depth};
    for (int k = 1; k < dimensions(unit.target); ++k) size_[static_cast<std::size_t>(k)] -= 2 * border_;
  }

  Color filtered(const Located& at, TexelFilter filter) const {
    const auto count = static_cast<std::size_t>(dimensions(unit_.target));
    const bool linear = filter == TexelFilter::linear;
    const bool seamless = linear && unit_.sampler.seamless && unit_.target == TextureTarget::cube_map;
    std::array<double, 3> base{}, weight{};
    for (std::size_t k = 0; k < count; ++k) {
      const double u = seamless ? std::clamp(at.at[k].value, 0.0, 1.0) * size_[k] : texel_coordinate(k, at.at[k].value);
      base[k] = std::floor(linear ? u - 0.5 : u);
      weight[k] = linear ? u - 0.5 - base[k] : 0;
      // [GL1.5 §3.8.8 eq 3.19]: s = 1 is in the last texel.
      if (!linear && unit_.sampler.wrap[k] != WrapMode::clamp_to_border) base[k] = std::min(base[k], size_[k] - 1.0);
    }
    if (seamless) return across_seams(base, weight, at.compared);
    Color sum{};
    for (std::size_t corner = 0; corner < (linear ? std::size_t{1} << count : 1); ++corner) {
      std::array<int, 3> place{};
      double share = 1;
      for (std::size_t k = 0; k < count; ++k) {
        const bool second = (corner >> k & 1) != 0;
        place[k] = wrapped_index(k, static_cast<int>(base[k]) + (second ? 1 : 0));
        share *= second ? weight[k] : 1 - weight[k];
      }
      if (share == 0) continue;
      const Color texel = texel_at(face_, place, at.compared);
      for (std::size_t k = 0; k < 4; ++k) sum[k] += share * texel[k];
    }
    return sum;
  }

 private:
  const Image& image(int face) const {
    return unit_.texture->faces[static_cast<std::size_t>(face)][static_cast<std::size_t>(level_)];
  }

  /// [GL1.5 §3.8.7].
  double texel_coordinate(std::size_t k, double s) const {
    const double n = size_[k], scale = unit_.target == TextureTarget::rectangle ? 1.0 : n;
    if (unit_.sampler.mirrored_once[k]) s = std::abs(s);
    switch (unit_.sampler.wrap[k]) {
      case WrapMode::repeat: return (s - std::floor(s)) * n;
      case WrapMode::clamp: return std::clamp(s * scale, 0.0, n);
      case WrapMode::clamp_to_edge: return std::clamp(s * scale, 0.5, n - 0.5);
      case WrapMode::clamp_to_border: return std::clamp(s * scale, -0.5, n + 0.5);
      case WrapMode::mirrored_repeat: break;
    }
    const double whole = std::floor(s), fraction = s - whole;
    const bool even = std::fmod(whole, 2.0) == 0;
    return std::clamp((even ? fraction : 1 - fraction) * n, 0.5, n - 0.5);
  }

  int wrapped_index(std::size_t k, int i) const {
    const int n = size_[k];
    switch (unit_.sampler.wrap[k]) {
      case WrapMode::repeat: return (i % n + n) % n;
      case WrapMode::clamp_to_edge:
      case WrapMode::mirrored_repeat: return std::clamp(i, 0, n - 1);
      case WrapMode::clamp:
      case WrapMode::clamp_to_border: break;
    }
    return i;
  }

  /// A texel of the image or, beyond its border, the border colour, compared if the sampler says so [GL1.5 §3.8.14].
  Color texel_at(int face, const std::array<int, 3>& place, double compared) const {
    bool outside = false;
    std::array<int, 3> at = place;
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimensions(unit_.target)); ++k) {
      outside |= place[k] < -border_ || place[k] >= size_[k] + border_;
      at[k] += border_;
    }
    const Image& image = this->image(face);
    const glm::vec4& b = unit_.sampler.border_color;
    const BaseFormat format = seen_format(unit_);
    if (!unit_.sampler.compares) {
      if (outside && image.base_format == BaseFormat::depth) return as_seen(format, {b.x, 0, 0, b.x}, true);
      if (outside) return as_seen(format, {b.x, b.y, b.z, b.w}, true);
      Color texel = as_seen(format, stored(image, at[0], at[1], at[2]), bytes_per_texel(image.format) >= 4 && has_four_channels(image.format));
      for (std::size_t k = 0; image.srgb && k < 3; ++k) texel[k] = linear_light(texel[k]);
      return texel;
    }
    const double depth = outside ? static_cast<double>(b.x) : stored(image, at[0], at[1], at[2])[0];
    const double result = passes(compared, depth) ? 1 : 0;
    return as_seen(format, {result, 0, 0, result}, true);
  }

  static bool has_four_channels(TexelFormat format) {
    return format == TexelFormat::rgba8 || format == TexelFormat::rgba16 || format == TexelFormat::rgba32f;
  }

  bool passes(double r, double depth) const {
    switch (static_cast<CompareFunc>(unit_.sampler.compare_func)) {
      case CompareFunc::never: return false;
      case CompareFunc::less: return r < depth;
      case CompareFunc::equal: return r == depth;
      case CompareFunc::lequal: return r <= depth;
      case CompareFunc::greater: return r > depth;
      case CompareFunc::notequal: return r != depth;
      case CompareFunc::gequal: return r >= depth;
      case CompareFunc::always: break;
    }
    return true;
  }

  /// The texel beyond an edge is the nearest on the neighbouring face: the one that the direction through its centre,
  /// folded around the edge, hits. At a corner the fourth is the mean of three [ARB_seamless_cube_map].
  Color across_seams(const std::array<double, 3>& base, const std::array<double, 3>& weight, double compared) const {
    std::array<Color, 4> corner{};
    int missing = -1;
    const int n = size_[0];
    for (int i = 0; i < 4; ++i) {
      const int x = static_cast<int>(base[0]) + (i & 1), y = static_cast<int>(base[1]) + (i >> 1);
      const bool x_out = x < 0 || x >= n, y_out = y < 0 || y >= n;
      if (x_out && y_out) {
        missing = i;
        continue;
      }
      corner[static_cast<std::size_t>(i)] = x_out || y_out ? beyond_edge(x, y, compared) : texel_at(face_, {x, y, 0}, compared);
    }
    Color out;
    for (std::size_t k = 0; k < 4; ++k) {
      if (missing >= 0) corner[static_cast<std::size_t>(missing)][k] = (corner[0][k] + corner[1][k] + corner[2][k] + corner[3][k]) / 3;
      const double lower = corner[0][k] + (corner[1][k] - corner[0][k]) * weight[0];
      const double upper = corner[2][k] + (corner[3][k] - corner[2][k]) * weight[0];
      out[k] = lower + (upper - lower) * weight[1];
    }
    return out;
  }

  Color beyond_edge(int x, int y, double compared) const {
    const int n = size_[0];
    // The direction of a point on the face, at (s_c, t_c) with |m_a| = 1.
    const auto direction = [&](double sc, double tc) -> std::array<double, 3> {
      switch (face_) {
        case 0: return {1, -tc, -sc};
        case 1: return {-1, -tc, sc};
        case 2: return {sc, 1, tc};
        case 3: return {sc, -1, -tc};
        case 4: return {sc, -tc, 1};
        default: return {-sc, -tc, -1};
      }
    };
    const auto place = [n](int i) { return (2.0 * std::clamp(i, 0, n - 1) + 1) / n - 1; };
    // A point just over the edge: half a texel below it on the other side.
    std::array<double, 3> d = direction(x < 0 ? -1.0 : x >= n ? 1.0 : place(x), y < 0 ? -1.0 : y >= n ? 1.0 : place(y));
    const std::size_t own = static_cast<std::size_t>(face_) / 2;
    d[own] *= 1 - 1.0 / n;
    TextureCoordinate c;
    c.value = {d[0], d[1], d[2], 1};
    const Located at = locate_on_cube(c, {});
    const auto index = [n](double s) { return std::clamp(static_cast<int>(std::floor(s * n)), 0, n - 1); };
    return texel_at(at.face, {index(at.at[0].value), index(at.at[1].value), 0}, compared);
  }

  const TextureUnitState& unit_;
  int face_, level_, border_ = 0;
  std::array<int, 3> size_{};
};

/// Lengths of a pixel's sides in texels of the base level: P_x and P_y of EXT_texture_filter_anisotropic.
struct Footprint {
  double along_x = 0, along_y = 0;
  Footprint(const TextureUnitState& unit, const Located& at) {
    const Image& image = unit.texture->faces[0][unit.sampler.base_level];
    const std::array<int, 3> size{image.width, image.height, image.depth};
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimensions(unit.target)); ++k) {
      const double texels = unit.target == TextureTarget::rectangle ? 1.0 : size[k] - 2 * image.border;
      along_x = std::hypot(along_x, at.at[k].ddx * texels);
      along_y = std::hypot(along_y, at.at[k].ddy * texels);
    }
  }
  double longer() const { return std::max(along_x, along_y); }
};

/// [GL1.5 §3.8.8 eq 3.16, 3.17] of a footprint whose longer side is `rho`.
double level_of_detail(const TextureUnitState& unit, double rho) {
  const double lambda = (rho > 0 ? std::log2(rho) : -1000.0) + static_cast<double>(unit.sampler.lod_bias);
  return std::min(std::max(lambda, static_cast<double>(unit.sampler.min_lod)), static_cast<double>(unit.sampler.max_lod));
}

Color sample_at(const TextureUnitState& unit, const Located& at, double lambda) {
  const pipeline::SamplerState& sampler = unit.sampler;
  const auto level = [&](double index, TexelFilter filter) {
    return Level(unit, at.face, sampler.base_level + static_cast<int>(index)).filtered(at, filter);
  };
  if (lambda <= 0) return level(0, sampler.magnify);
  const double last = sampler.last_level - sampler.base_level;
  switch (sampler.mip) {
    case MipFilter::none: return level(0, sampler.minify);
    case MipFilter::nearest: return level(std::clamp(std::ceil(lambda + 0.5) - 1, 0.0, last), sampler.minify);
    case MipFilter::linear: break;
  }
  if (lambda >= last) return level(last, sampler.minify);
  const double first = std::floor(lambda), share = lambda - first;
  Color a = level(first, sampler.minify);
  const Color b = level(first + 1, sampler.minify);
  for (std::size_t k = 0; k < 4; ++k) a[k] += (b[k] - a[k]) * share;
  return a;
}

/// The mean of N samples along the longer side of the pixel's footprint [EXT_texture_filter_anisotropic], one if the
/// filter is isotropic.
/// choice: a ratio within 1/1024 above a whole number counts as that.
Color sample(const TextureUnitState& unit, const TextureCoordinate& coordinate, const Errors& errors) {
  const Located at = locate(unit, coordinate, errors);
  const Footprint footprint(unit, at);
  const double shorter = std::min(footprint.along_x, footprint.along_y), most = static_cast<double>(unit.sampler.max_anisotropy);
  const double ratio = footprint.longer() == 0 ? 1 : shorter == 0 ? most : footprint.longer() / shorter * (1 + errors.lod * ratio_slack);
  const double count = std::clamp(std::ceil(ratio - 1.0 / 1024), 1.0, most);
  const double lambda = level_of_detail(unit, footprint.longer() / count) + errors.lod * lod_slack;
  Color sum{};
  for (double i = 1; i <= count; ++i) {
    Located moved = at;
    const double pixels = i / (count + 1) - 0.5;
    for (Quotient& q : moved.at) q.value += pixels * (footprint.along_x > footprint.along_y ? q.ddx : q.ddy);
    const Color one = sample_at(unit, moved, lambda);
    for (std::size_t k = 0; k < 4; ++k) sum[k] += one[k] / count;
  }
  return sum;
}

/// The errors that could make a difference.
std::vector<Errors> errors_to_try(const TextureUnitState& unit) {
  const bool nearest = unit.sampler.minify == TexelFilter::nearest || unit.sampler.magnify == TexelFilter::nearest;
  const bool cube = unit.target == TextureTarget::cube_map;
  const bool coordinates = nearest || unit.sampler.compares || (cube && !unit.sampler.seamless);
  const bool third = unit.sampler.compares || ((nearest || !unit.sampler.seamless) && (cube || unit.target == TextureTarget::three_d));
  const bool lod = unit.sampler.mip != MipFilter::none || unit.sampler.minify != unit.sampler.magnify || unit.sampler.max_anisotropy > 1;
  std::vector<Errors> out;
  for (int i = 0; i < 16; ++i) {
    const auto sign = [&](int bit, bool wanted) { return !wanted ? 0.0 : (i & bit) != 0 ? 1.0 : -1.0; };
    if ((!coordinates && (i & 3) != 0) || (!third && (i & 4) != 0) || (!lod && (i & 8) != 0)) continue;
    if (coordinates || third || lod) out.push_back({sign(1, coordinates), sign(2, coordinates), sign(4, third), sign(8, lod)});
  }
  return out;
}

/// Texels that are no more apart count as one: environments make differences at most eight times as large.
constexpr double same_texel = 1.0 / 16384;

/// What a unit's texture may give: without errors first, then whatever else errors make of it.
std::vector<Color> possible_texels(const TextureUnitState& unit, const TextureCoordinate& coordinate) {
  std::vector<Color> out{sample(unit, coordinate, {})};
  for (const Errors& errors : errors_to_try(unit)) {
    const Color other = sample(unit, coordinate, errors);
    const bool is_known = std::ranges::any_of(out, [&](const Color& known) {
      double distance = 0;
      for (std::size_t k = 0; k < 4; ++k) distance = std::max(distance, std::abs(known[k] - other[k]));
      return distance <= same_texel;
    });
    if (!is_known) out.push_back(other);
  }
  return out;
}

Color textured(const pipeline::TexturingState& state, const Color& primary, std::span<const Color> texels) {
  Color color = primary;
  for (std::size_t i = 0; i < state.count; ++i) color = apply_environment(state, i, primary, color, texels);
  return color;
}

}  // namespace

BaseFormat seen_format(const TextureUnitState& unit) {
  const BaseFormat format = unit.texture->faces[0][unit.sampler.base_level].base_format;
  if (format != BaseFormat::depth) return format;
  switch (unit.sampler.depth_mode) {
    case pipeline::DepthTextureMode::luminance: return BaseFormat::luminance;
    case pipeline::DepthTextureMode::alpha: return BaseFormat::alpha;
    case pipeline::DepthTextureMode::red: return BaseFormat::rgb;
    case pipeline::DepthTextureMode::intensity: break;
  }
  return BaseFormat::intensity;
}

TexturedColor apply_textures(const pipeline::TexturingState& state, const Color& primary,
                             std::span<const TextureCoordinate> coordinates) {
  std::vector<std::vector<Color>> possible;
  for (std::size_t i = 0; i < state.count; ++i) possible.push_back(possible_texels(state.unit[i], coordinates[i]));
  // Every unit's outcomes with every other's, counted like digits.
  std::vector<std::size_t> chosen(state.count);
  TexturedColor out;
  for (bool first = true, more = true; more; first = false) {
    std::vector<Color> texels;
    for (std::size_t i = 0; i < state.count; ++i) texels.push_back(possible[i][chosen[i]]);
    const Color color = textured(state, primary, texels);
    if (first) out.color = out.lowest = out.highest = color;
    for (std::size_t k = 0; k < 4; ++k) {
      out.lowest[k] = std::min(out.lowest[k], color[k]);
      out.highest[k] = std::max(out.highest[k], color[k]);
    }
    std::size_t digit = 0;
    while (digit < state.count && ++chosen[digit] == possible[digit].size()) chosen[digit++] = 0;
    more = digit < state.count;
  }
  return out;
}

}  // namespace gouraud::oracle
