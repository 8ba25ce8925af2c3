#include "pipeline/draw/methods.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>

#include "pipeline/draw/draw_state.h"

namespace gouraud::pipeline {
namespace {

/// A row, and what it means.
struct Choice {
  MethodRow row;
  void (*choose)(Methods& methods);
  bool (*chosen)(const Methods& methods);
};

template <auto member, auto value>
constexpr Choice choice(MethodRow row) {
  return {row, [](Methods& methods) { methods.*member = value; },
          [](const Methods& methods) { return methods.*member == value; }};
}
/// A number: any in [0, 1] may stand there, these rows are examples. The first is the default.
constexpr std::string_view epsilon_step = "epsilon";
constexpr Choice epsilon_row(std::string_view name) {
  return {{epsilon_step, name, "of coverage=barycentric, as a share of the area: any number from 0 to 1", "as taught"}, nullptr, nullptr};
}

template <auto value>
constexpr auto coverage = choice<&Methods::coverage, value>;
template <auto value>
constexpr auto ownership = choice<&Methods::ownership, value>;
template <auto value>
constexpr auto clipping = choice<&Methods::clipping, value>;
template <auto value>
constexpr auto lines = choice<&Methods::lines, value>;
template <auto value>
constexpr auto colors = choice<&Methods::colors, value>;
template <auto value>
constexpr auto depth = choice<&Methods::depth, value>;
template <auto value>
constexpr auto highlight = choice<&Methods::highlight, value>;
template <auto value>
constexpr auto power = choice<&Methods::power, value>;
template <auto value>
constexpr auto antialiasing = choice<&Methods::antialiasing, value>;
template <auto value>
constexpr auto shading = choice<&Methods::shading, value>;

constexpr std::array choices{
    coverage<CoverageMethod::blocks8>({"coverage", "blocks8", "integer edge functions; 8x8 blocks and tiles wholly in or out skip the test",
                                       "Greene 1996; Abrash 2009"}),
    coverage<CoverageMethod::blocks4>({"coverage", "blocks4", "the same by cells of 4x4", "Greene 1996"}),
    coverage<CoverageMethod::blocks16>({"coverage", "blocks16", "the same by cells of 16x16", "Greene 1996"}),
    coverage<CoverageMethod::blocks64>({"coverage", "blocks64", "the same, no cell smaller than a tile left out", "Greene 1996"}),
    coverage<CoverageMethod::bounding_box>({"coverage", "bounding_box", "every edge function evaluated anew at every pixel of the box",
                                            "Pineda 1988, without his increments"}),
    coverage<CoverageMethod::incremental>({"coverage", "incremental", "edge functions stepped from pixel to pixel by additions", "Pineda 1988"}),
    coverage<CoverageMethod::scanline>({"coverage", "scanline", "spans between edges that are walked row by row, in float", "Wylie, Romney, Evans, Erdahl 1967"}),
    coverage<CoverageMethod::barycentric>({"coverage", "barycentric", "three areas that add up to the whole, to within epsilon, in float", "as taught, after Moebius 1827"}),
    coverage<CoverageMethod::homogeneous>({"coverage", "homogeneous", "edge functions of homogeneous coordinates, in double; nothing is clipped", "Olano and Greer 1997"}),
    coverage<CoverageMethod::float_edges>({"coverage", "float_edges", "edge functions in float, corners not snapped", "Pineda 1988"}),
    coverage<CoverageMethod::float_steps>({"coverage", "float_steps", "edge functions in float, stepped from pixel to pixel", "Pineda 1988"}),

    epsilon_row("0.0001"), epsilon_row("0"), epsilon_row("1e-06"), epsilon_row("0.001"), epsilon_row("0.01"),

    ownership<OwnershipMethod::top_left>({"ownership", "top_left", "left and bottom edges own the samples on them: each pixel once", "GL 1.5, 3.5.1"}),
    ownership<OwnershipMethod::all>({"ownership", "all", "every edge owns its samples: shared edges are drawn twice", "the missing rule"}),
    ownership<OwnershipMethod::none>({"ownership", "none", "no edge owns its samples: shared edges have holes", "the missing rule"}),

    clipping<ClippingMethod::clip_space>({"clipping", "clip_space", "polygons cut at the planes of the clip volume, before the division", "Sutherland and Hodgman 1974"}),
    clipping<ClippingMethod::guard_band>({"clipping", "guard_band", "what crosses the window's sides alone is left to the rasterizer", "Direct3D 7, 1999"}),
    clipping<ClippingMethod::homogeneous>({"clipping", "homogeneous", "triangles that would be cut have homogeneous edge functions instead", "Olano and Greer 1997"}),
    clipping<ClippingMethod::none>({"clipping", "none", "all is divided by w, wherever it lies", "the missing stage"}),

    lines<LineMethod::diamond_exit>({"lines", "diamond_exit", "pixels whose diamonds the line leaves, end points included", "GL 1.5, 3.4.1"}),
    lines<LineMethod::naive>({"lines", "naive", "y = m x + b for every column: steep lines fall to pieces", "as taught"}),
    lines<LineMethod::dda>({"lines", "dda", "slopes added step by step, in float", "Newman and Sproull 1973"}),
    lines<LineMethod::bresenham>({"lines", "bresenham", "integers alone, between whole pixels", "Bresenham 1965"}),
    lines<LineMethod::coverage>({"lines", "coverage", "a rectangle with the area that it covers of each pixel, blended", "GL 1.5, 3.4.2.1; Gupta and Sproull 1981"}),

    colors<InterpolationMethod::perspective>({"colors", "perspective", "colour/w and 1/w are linear in the window, their quotient is exact",
                                              "Blinn 1992; Heckbert and Moreton 1991"}),
    colors<InterpolationMethod::affine>({"colors", "affine", "linear in the window, as if all had one depth", "Gouraud 1971"}),
    colors<InterpolationMethod::affine8>({"colors", "affine8", "exact at every 8th pixel of a row, linear between", "Abrash 1997 (Quake, 1996)"}),
    colors<InterpolationMethod::affine16>({"colors", "affine16", "exact at every 16th pixel of a row, linear between", "Abrash 1997 (Quake, 1996)"}),
    colors<InterpolationMethod::barycentric>({"colors", "barycentric", "the vertices' values weighted by areas at every pixel, in float", "Moebius 1827; Blinn 1992"}),
    colors<InterpolationMethod::hint>({"colors", "hint", "affine where PERSPECTIVE_CORRECTION_HINT is FASTEST", "GL 1.5, 5.6"}),

    depth<DepthMethod::z>({"depth", "z", "window depth, in the bits of the visual (16, 24 or float)", "Catmull 1974"}),
    depth<DepthMethod::z16>({"depth", "z16", "window depth as a fixed-point number of 16 bits", "Catmull 1974"}),
    depth<DepthMethod::z24>({"depth", "z24", "window depth as a fixed-point number of 24 bits", "Catmull 1974"}),
    depth<DepthMethod::z32>({"depth", "z32", "window depth as a fixed-point number of 32 bits; vertices bring no more than 24", "Catmull 1974"}),
    depth<DepthMethod::z_float>({"depth", "float", "window depth as a 32-bit float: finest where depth is coarse already", "ARB_depth_buffer_float"}),
    depth<DepthMethod::z_reversed>({"depth", "reversed", "a 32-bit float that is 1 near by and 0 far away: equally fine everywhere",
                                    "Lapidous and Jiao 1999; ARB_clip_control"}),
    depth<DepthMethod::w>({"depth", "w", "the distance, in equal steps from near to far, 24 bits", "Blinn 1998"}),
    depth<DepthMethod::w16>({"depth", "w16", "the distance, in equal steps from near to far, 16 bits", "Blinn 1998"}),
    depth<DepthMethod::painter>({"depth", "painter", "triangles sorted by their mean depth, the farthest first; no buffer", "Newell, Newell, Sancha 1972"}),
    depth<DepthMethod::ray>({"depth", "ray", "for each pixel the first triangle that its ray meets; no buffer", "Appel 1968; Moeller and Trumbore 1997"}),

    shading<ShadingMethod::gouraud>({"shading", "gouraud", "lit at the vertices, interpolated (flat where the shade model says so)", "Gouraud 1971"}),
    shading<ShadingMethod::flat>({"shading", "flat", "one colour a primitive, whatever the shade model", "Bouknight 1970"}),
    shading<ShadingMethod::phong>({"shading", "phong", "normals interpolated, every fragment lit", "Phong 1975"}),

    highlight<HighlightMethod::half_vector>({"highlight", "half_vector", "the power of (normal . half vector)", "Blinn 1977; GL 1.5, 2.14.1"}),
    highlight<HighlightMethod::reflection>({"highlight", "reflection", "the power of (mirrored light . viewer)", "Phong 1975"}),

    power<PowerMethod::reproducible>({"power", "reproducible", "powers of equal bits on every machine", "pipeline/simd/math-inl.h"}),
    power<PowerMethod::libm>({"power", "libm", "powers of the C library", "C, pow"}),

    antialiasing<AntialiasingMethod::none>({"antialiasing", "none", "one sample, in the middle of the pixel", "GL 1.5, 3.5.1"}),
    antialiasing<AntialiasingMethod::area>({"antialiasing", "area", "triangles blended by the exact area that they cover of each pixel", "Catmull 1978"}),
    antialiasing<AntialiasingMethod::multisample4>({"antialiasing", "multisample4", "four samples, each in a row and a column of its own", "Akeley 1993"}),
    antialiasing<AntialiasingMethod::supersample2>({"antialiasing", "supersample2", "2x2 samples, each shaded", "Crow 1977"}),
    antialiasing<AntialiasingMethod::supersample4>({"antialiasing", "supersample4", "4x4 samples, each shaded", "Crow 1977"}),
    antialiasing<AntialiasingMethod::supersample8>({"antialiasing", "supersample8", "8x8 samples, each shaded", "Crow 1977"}),
    antialiasing<AntialiasingMethod::supersample16>({"antialiasing", "supersample16", "16x16 samples, each shaded", "Crow 1977"}),
    antialiasing<AntialiasingMethod::supersample32>({"antialiasing", "supersample32", "32x32 samples, each shaded", "Crow 1977"}),
};

constexpr auto rows = [] {
  std::array<MethodRow, choices.size()> result{};
  for (std::size_t i = 0; i < choices.size(); ++i) result[i] = choices[i].row;
  return result;
}();

/// "a, b or c": the names of a step, or the steps if `step` is empty.
std::string alternatives(std::string_view step) {
  std::string text;
  std::string_view last;
  for (const MethodRow& row : rows) {
    const std::string_view word = step.empty() ? row.step : row.step == step ? row.name : std::string_view();
    if (word.empty() || word == last) continue;
    if (!text.empty()) text += ", ";
    text += word;
    last = word;
  }
  const std::size_t comma = text.rfind(", ");
  if (comma != std::string::npos) text.replace(comma, 2, " or ");
  return text;
}

std::string quoted(std::string_view text) { return "'" + std::string(text.substr(0, 40)) + "'"; }

bool read_epsilon(std::string_view text, float& epsilon) {
  float value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc{} || end != text.data() + text.size() || !(value >= 0 && value <= 1)) return false;
  epsilon = value;
  return true;
}

/// Carries out one "step=name". False if it cannot.
bool choose(std::string_view item, Methods& methods, std::string& error) {
  const std::size_t sign = item.find('=');
  if (sign == std::string_view::npos) {
    error = "method " + quoted(item) + " is not of the form step=name";
    return false;
  }
  const std::string_view step = item.substr(0, sign), name = item.substr(sign + 1);
  if (step == epsilon_step) {
    if (read_epsilon(name, methods.epsilon)) return true;
    error = "method epsilon=" + quoted(name) + " is not a number from 0 to 1";
    return false;
  }
  bool known = false;
  for (const Choice& choice : choices) {
    if (choice.row.step != step) continue;
    known = true;
    if (choice.row.name == name) {
      choice.choose(methods);
      return true;
    }
  }
  error = known ? "method " + std::string(step) + "=" + quoted(name) + " is not known; it may be " + alternatives(step)
                : "step " + quoted(step) + " is not known; it may be " + alternatives({});
  return false;
}

}  // namespace

std::span<const MethodRow> method_rows() { return rows; }

std::optional<Methods> parse_methods(std::string_view text, std::string& error) {
  Methods methods;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    if (end > 0 && !choose(text.substr(0, end), methods, error)) return std::nullopt;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return methods;
}

std::string describe(const Methods& methods) {
  std::string text;
  std::string_view last_step;
  for (const Choice& choice : choices) {
    const bool is_default = choice.row.step != last_step;
    last_step = choice.row.step;
    const bool is_number = choice.chosen == nullptr;
    if (is_number ? !is_default || methods.epsilon == Methods{}.epsilon : is_default || !choice.chosen(methods)) continue;
    if (!text.empty()) text += ',';
    text.append(choice.row.step).append("=");
    if (is_number) {
      std::array<char, 32> number;
      text.append(number.data(), std::to_chars(number.begin(), number.end(), methods.epsilon).ptr);
    } else {
      text += choice.row.name;
    }
  }
  return text;
}

namespace {

/// The share of a pixel that is covered counts only where something blends it in.
void blend_by_coverage(DrawState& state) {
  if (state.raster.blend.enabled || state.raster.logic_op != LogicOp::copy || state.raster.color_write_mask == 0) return;
  const BlendTerms over{BlendEquation::add, BlendFactor::source_alpha, BlendFactor::one_minus_source_alpha};
  state.raster.blend.enabled = true;
  if ((state.raster.color_write_mask & 7) != 0) state.raster.blend.rgb = over;
  if ((state.raster.color_write_mask & 8) != 0) state.raster.blend.alpha = over;
}

/// Clip z becomes what is left of w beyond it, as a program that reverses depth has its projection: in double, from the
/// projection's own rows, before anything is rounded away.
/// Depth ranges, comparisons and polygon offsets turn round with it.
void reverse_depth(DrawState& state) {
  TransformState& transform = state.transform;
  const double share = state.viewport.zero_to_one ? 1.0 : 0.5;
  std::array<double, 4> row{};
  for (int c = 0; c < 4; ++c) {
    const double w = transform.projection[c][3], z = transform.projection[c][2];
    row[static_cast<std::size_t>(c)] = share * (w - z);
  }
  for (int c = 0; c < 4; ++c) {
    double element = 0;
    for (int k = 0; k < 4; ++k) element += row[static_cast<std::size_t>(k)] * static_cast<double>(transform.modelview[c][k]);
    transform.modelview_projection[c][2] = static_cast<float>(element);
  }
  for (int c = 0; c < 4; ++c) transform.projection[c][2] = static_cast<float>(row[static_cast<std::size_t>(c)]);
  state.viewport.zero_to_one = true;
  const double near = state.viewport.depth_near, far = state.viewport.depth_far;
  state.viewport.depth_near = 1.0 - far;
  state.viewport.depth_far = 1.0 - near;
  CompareFunc& func = state.raster.depth.func;
  if (func == CompareFunc::less || func == CompareFunc::greater) {
    func = func == CompareFunc::less ? CompareFunc::greater : CompareFunc::less;
  } else if (func == CompareFunc::lequal || func == CompareFunc::gequal) {
    func = func == CompareFunc::lequal ? CompareFunc::gequal : CompareFunc::lequal;
  }
  state.polygons.offset_factor = -state.polygons.offset_factor;
  state.polygons.offset_units = -state.polygons.offset_units;
  state.polygons.offset_bias = -state.polygons.offset_bias;
}

}  // namespace

void apply_methods(const Methods& methods, DrawState& state) {
  if (methods.reverses_depth() && !state.report.enabled) reverse_depth(state);
  if (methods.shading == ShadingMethod::flat) state.assembly.shade_model = ShadeModel::flat;
  if (methods.lines == LineMethod::coverage) {
    state.lines.smooth = true;
    blend_by_coverage(state);
  }
  if (methods.antialiasing == AntialiasingMethod::area) {
    state.polygons.smooth = true;
    blend_by_coverage(state);
  }
}

}  // namespace gouraud::pipeline
