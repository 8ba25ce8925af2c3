// Computed backwards: what can reach the framebuffer decides which passes run, the passes decide what is interpolated,
// and that decides which vertex stages run and which attributes a vertex must bring.
#include "pipeline/draw/plan.h"

#include <array>
#include <cstdio>
#include <string_view>

#include "pipeline/draw/group_depth.h"
#include "pipeline/draw/phong_shading.h"
#include "pipeline/draw/plan_textures.h"
#include "pipeline/draw/small_triangles.h"
#include "pipeline/draw/varying_layout.h"
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
#include "pipeline/geometry/texture_coordinates.h"
#include "pipeline/texture/texture_pass.h"

namespace gouraud::pipeline {
namespace {

bool any_positional(const LightingState& lighting) {
  for (std::size_t i = 0; i < lighting.light_count; ++i) {
    if (lighting.lights[i].positional) return true;
  }
  return false;
}

struct Line {
  std::string& text;
  void operator()(std::string_view stage, std::string_view detail, std::string_view section) const {
    text.append("  ").append(stage);
    if (!detail.empty()) text.append(": ").append(detail);
    text.append("  [GL1.5 ").append(section).append("]\n");
  }
};

constexpr std::array<std::string_view, 8> compare_names{"never", "less", "equal", "lequal", "greater", "notequal", "gequal", "always"};

std::string describe_lights(const LightingState& lighting) {
  int positional = 0, spots = 0;
  for (std::size_t i = 0; i < lighting.light_count; ++i) {
    positional += lighting.lights[i].positional ? 1 : 0;
    spots += lighting.lights[i].spot ? 1 : 0;
  }
  std::string text = std::to_string(lighting.light_count) + (lighting.light_count == 1 ? " light" : " lights");
  if (positional > 0) text += ", " + std::to_string(positional) + " positional";
  if (spots > 0) text += ", " + std::to_string(spots) + " spot";
  if (lighting.two_sided) text += ", two-sided";
  if (lighting.local_viewer) text += ", local viewer";
  if (lighting.separate_specular) text += ", separate specular";
  if ((lighting.color_material_front | lighting.color_material_back) != 0) text += ", color material";
  return text;
}

constexpr std::array<std::string_view, 15> factor_names{
    "zero", "one", "source color", "1 - source color", "destination color", "1 - destination color", "source alpha",
    "1 - source alpha", "destination alpha", "1 - destination alpha", "constant color", "1 - constant color",
    "constant alpha", "1 - constant alpha", "saturated source alpha"};
constexpr std::array<std::string_view, 16> logic_op_names{
    "clear", "and", "and reverse", "copy", "and inverted", "noop", "xor", "or", "nor", "equiv", "invert", "or reverse",
    "copy inverted", "or inverted", "nand", "set"};

std::string describe_terms(const BlendTerms& terms) {
  constexpr std::array<std::string_view, 5> equations{"add", "subtract", "reverse subtract", "min", "max"};
  std::string text(equations[static_cast<std::size_t>(terms.equation)]);
  if (terms.equation == BlendEquation::min || terms.equation == BlendEquation::max) return text;
  const auto name = [](BlendFactor factor) { return factor_names[static_cast<std::size_t>(factor)]; };
  return text.append(" (").append(name(terms.source)).append(", ").append(name(terms.destination)).append(")");
}

std::string describe_stencil_face(const StencilFace& face) {
  constexpr std::array<std::string_view, 8> operations{"keep",   "zero",   "replace",        "increment",
                                                       "decrement", "invert", "increment wrap", "decrement wrap"};
  const auto name = [&](StencilOp op) { return operations[static_cast<std::size_t>(op)]; };
  std::string text(compare_names[static_cast<std::size_t>(face.func)]);
  if (!face.writes()) return text;
  return text.append(" (").append(name(face.fail)).append(", ").append(name(face.depth_fail)).append(", ")
      .append(name(face.depth_pass)).append(")");
}

std::string describe_stencil(const StencilState& stencil) {
  if (stencil.front == stencil.back) return describe_stencil_face(stencil.front);
  return "front " + describe_stencil_face(stencil.front) + ", back " + describe_stencil_face(stencil.back);
}

std::string describe_blending(const BlendState& blend) {
  if (blend.rgb == blend.alpha) return describe_terms(blend.rgb);
  return "color " + describe_terms(blend.rgb) + ", alpha " + describe_terms(blend.alpha);
}

std::string describe_length(float length_px) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", static_cast<double>(length_px));
  return text.data();
}

/// A line for each kind of primitive that is not rasterized the plain way.
void describe_rasterization(const DrawState& state, DrawnKinds kinds, const Line& line) {
  if (kinds.points && state.points != PointState{}) {
    std::string detail = (state.points.sprite ? "sprites of size " : "size ") + describe_length(state.points.size_px);
    if (state.points.attenuated) detail += ", attenuated";
    if (state.texturing.sprite_units != 0) detail += ", with coordinates of their own";
    line(state.points.smooth && !state.multisample.enabled ? "smooth points" : "points", detail, "§3.3");
  }
  if (kinds.lines && state.lines != LineState{}) {
    std::string detail = "width " + describe_length(state.lines.width_px);
    if (state.lines.stipple_pattern != 0xFFFF) detail += ", stippled";
    line(state.lines.smooth && !state.multisample.enabled ? "smooth lines" : "lines", detail, "§3.4.2");
  }
  if (kinds.filled && state.polygons.smooth) line("smooth polygons", "", "§3.5.3");
  if (state.polygons.offset_fill || state.polygons.offset_line || state.polygons.offset_point) line("polygon offset", "", "§3.5.5");
}

SecondaryColor secondary_color(const DrawState& state, const Plan& plan) {
  const bool has_one = state.lighting.enabled ? state.lighting.separate_specular : state.color_sum;
  if (!(plan.colors || plan.textured) || !has_one) return SecondaryColor::none;
  return plan.textured ? SecondaryColor::interpolated : SecondaryColor::summed_at_vertices;
}

/// Nothing but fog stands between interpolation and write: one pass does all three.
bool fogs_at_write(const DrawState& state, TargetFormat target, const Plan& plan) {
  const bool others = plan.textured || plan.phong || plan.blends || plan.coverage || plan.sample_alpha || plan.alpha_test ||
                      target.methods.keeps_colors() || state.multisample.enabled;
  return plan.fog && !others && target.color == ColorFormat::rgba8 && state.raster.color_write_mask == 0xF;
}

bool shades_before_depth(const DrawState& state, const Plan& plan) { return plan.alpha_test || state.raster.alpha_to_coverage != 0; }

/// Whether what the depth test will reject may go before it is shaded: rejecting must be all that comes of it, and nothing that is
/// drawn meanwhile may let a fragment pass that has failed.
bool rejects_hidden(const DrawState& state, TargetFormat target, const Plan& plan) {
  const CompareFunc func = state.raster.depth.func;
  return shades_before_depth(state, plan) && plan.depth && !plan.stencil && !plan.gathers && !target.methods.warps_depth() &&
         func != CompareFunc::notequal && func != CompareFunc::always;
}

/// Fragments get their final colours before the depth test only if the alpha test needs them.
FragmentPasses fragment_passes(const DrawState& state, TargetFormat target, const Plan& plan) {
  FragmentPasses passes;
  const bool has_varyings = plan.textured || plan.fog || plan.phong;
  const bool changes_textured = plan.secondary_color == SecondaryColor::interpolated || plan.fog || plan.coverage || plan.sample_alpha || plan.alpha_test;
  const bool packed = target.color == ColorFormat::rgba8 && plan.textured && !changes_textured && !plan.phong;
  const LanesWanted wanted = plan.phong ? LanesWanted::all : LanesWanted::covered;
  const bool fog_at_write = fogs_at_write(state, target, plan);
  const auto shade = [&] {
    if (plan.colors && !plan.phong && !fog_at_write) passes.add(color_interpolation_pass(target.methods.colors));
    if (has_varyings && !fog_at_write) passes.add(varying_interpolation_pass(target.methods.colors, wanted));
    if (plan.phong) passes.add(phong_shading_pass());
    if (plan.textured) passes.add(packed ? texture_words_pass() : texture_pass());
    if (plan.secondary_color == SecondaryColor::interpolated) passes.add(color_sum_pass(target.color));
    if (plan.fog && !fog_at_write) passes.add(fog_pass(state.raster.fog.mode, target.color));
    if (plan.coverage) passes.add(coverage_pass());
    passes.shaded = passes.count;
    if (plan.sample_alpha) passes.add(sample_alpha_pass(target.color));
  };
  if (plan.polygon_stipple) passes.add(polygon_stipple_pass());
  const auto depth_pass = target.methods.warps_depth() ? depth_method_pass : depth_test_pass;
  const FragmentPass depth_test = plan.depth && !plan.gathers ? depth_pass(state.raster.depth.func, target.depth) : nullptr;
  passes.rejects_early = rejects_hidden(state, target, plan);
  if (passes.rejects_early) {
    passes.add(hidden_fragments_pass());
    passes.inner_depth = depth_test;
  }
  passes.early = passes.count;
  const bool shades_first = shades_before_depth(state, plan);
  if (shades_first) shade();
  if (plan.alpha_test) passes.add(alpha_test_pass(target.color));
  if (plan.alpha_test && !plan.sample_alpha) passes.shaded = passes.count;
  if (plan.stencil) {
    passes.add(stencil_pass(target.depth));
    passes.inner_depth = depth_test;
  } else if (depth_test != nullptr) {
    passes.add(depth_test);
  }
  if (plan.counts_samples) passes.add(sample_count_pass());
  if (!shades_first) passes.early = passes.shaded = passes.count;
  const bool tests_depth_only = depth_test != nullptr && passes.early == 1 && (passes.pass[0] == depth_test || passes.rejects_early);
  if (tests_depth_only && !target.methods.warps_depth()) {
    passes.group_depth = group_depth_test(state.raster.depth.func, target.depth);
    if (!state.polygons.offset_fill) passes.small_triangles = small_triangle_tests(state.raster.depth.func, target.depth);
  }
  if (!plan.writes_color) return passes;
  const bool keeps_colors = plan.blends || plan.coverage || plan.sample_alpha || plan.alpha_test || has_varyings ||
                            target.methods.keeps_colors() ||   // between interpolation and write
                            state.multisample.enabled;         // one interpolation, several writes
  if (keeps_colors && !shades_first) shade();
  if (fog_at_write) {
    passes.add(fogged_color_write_pass(state.raster.fog.mode));
    return passes;
  }
  passes.add(keeps_colors ? blend_pass(state.raster, target.color, packed)
                                 : color_write_pass(target.color, state.raster.color_write_mask));
  return passes;
}

void demand_colors(const DrawState& state, Plan& plan) {
  const bool secondary = plan.secondary_color != SecondaryColor::none;
  plan.lighting = (plan.colors || secondary) && state.lighting.enabled;
  plan.vertex_colors = plan.colors && !state.lighting.enabled;
  plan.secondary_vertex_colors = secondary && !state.lighting.enabled;
  plan.normals = plan.lighting && state.lighting.light_count > 0;
  plan.eye_positions = state.report.eye_positions || state.points.attenuated ||
                       (plan.lighting && (any_positional(state.lighting) || (plan.normals && state.lighting.local_viewer)));
  const bool color_material = (state.lighting.color_material_front | state.lighting.color_material_back) != material_none;
  if (plan.vertex_colors || (plan.lighting && color_material)) plan.vertex_demand |= attribute_color;
  if (plan.secondary_vertex_colors) plan.vertex_demand |= attribute_secondary_color;
}

void demand_texture_coordinates(const DrawState& state, Plan& plan) {
  const auto demand = [&](int unit, int dimensions) {
    const auto k = static_cast<std::size_t>(unit);
    const TextureCoordinateNeeds needs = needs_of(state.texture_coordinates.unit[k], dimensions);
    if (needs.given) plan.vertex_demand |= attribute_texture_coordinates(unit);
    plan.eye_positions |= needs.position_eye;
    plan.normals |= needs.normal_eye;
  };
  for (std::size_t i = 0; !plan.reports && plan.textured && i < state.texturing.count; ++i) {
    demand(state.texturing.unit[i].unit, coordinate_dimensions(state.texturing.unit[i]));
  }
  for (int unit = 0; plan.reports && unit < max_texture_units; ++unit) {
    if ((state.report.texture_units >> unit & 1) != 0) demand(unit, 3);
  }
}

/// Which vertex stages, and which attributes, does that take?
void plan_vertices(const DrawState& state, Plan& plan) {
  demand_colors(state, plan);
  demand_texture_coordinates(state, plan);
  plan.eye_positions |= state.clip_planes.count > 0;
  if (plan.fog && state.raster.fog.from_coordinate) plan.vertex_demand |= attribute_fog_coordinate;
  if (plan.normals) plan.vertex_demand |= attribute_normal;
  const bool filled = state.assembly.polygon_mode_front == PolygonMode::fill && state.assembly.polygon_mode_back == PolygonMode::fill;
  if (!filled) plan.vertex_demand |= attribute_edge_flag;
}

std::string describe_coordinates(const TextureCoordinateSource& source, int unit) {
  constexpr std::array<std::string_view, 6> modes{"given", "object linear", "eye linear", "sphere map", "normal map", "reflection map"};
  std::string text = "unit " + std::to_string(unit);
  for (std::size_t c = 0; c < 4; ++c) {
    if (source.mode[c] == TexgenMode::given) continue;
    text.append(", ").append(1, "strq"[c]).append(" ").append(modes[static_cast<std::size_t>(source.mode[c])]);
  }
  if (source.transformed) text += ", transformed";
  return text;
}

}  // namespace

Plan make_plan(const DrawState& state, TargetFormat target) {
  Plan plan;
  plan.methods = target.methods;
  if (state.report.enabled) {
    plan.draws = plan.reports = true;
    plan.colors = state.report.colors;
    plan.textured = state.report.texture_units != 0;
    plan_vertices(state, plan);
    return plan;
  }

  // What can reach the framebuffer?
  const bool tests_depth = state.raster.depth.test_enabled && target.depth != DepthFormat::none;
  const bool none_passes = tests_depth && state.raster.depth.func == CompareFunc::never;
  const bool writes_depth = tests_depth && state.raster.depth.write_enabled;
  const bool writes_color = target.color != ColorFormat::none && state.raster.color_write_mask != 0 &&
                            state.raster.logic_op != LogicOp::noop && !none_passes;
  plan.alpha_test = state.raster.alpha_test.enabled;
  plan.sample_alpha = state.raster.alpha_to_coverage != 0 || (state.raster.alpha_to_one && (writes_color || plan.alpha_test));
  plan.stencil = state.raster.stencil.enabled;
  plan.writes_stencil = plan.stencil && state.raster.stencil.writes();
  plan.counts_samples = state.raster.counts_samples && !none_passes;
  const bool none_arrives =
      (plan.alpha_test && state.raster.alpha_test.func == CompareFunc::never) || state.raster.scissor.empty();
  plan.draws = (writes_color || (writes_depth && !none_passes) || plan.writes_stencil || plan.counts_samples) && !none_arrives;
  if (!plan.draws) return {};
  plan.follows_matrices = !target.methods.warps_depth();  // that takes one projection for all

  // Which passes does that take?
  plan.depth = tests_depth && (writes_depth || state.raster.depth.func != CompareFunc::always);
  const CompareFunc func = state.raster.depth.func;
  plan.gathers = target.methods.gathers_triangles() && plan.depth &&
                 (func == CompareFunc::less || func == CompareFunc::lequal || func == CompareFunc::greater || func == CompareFunc::gequal);
  const bool shades = writes_color || plan.alpha_test || plan.sample_alpha;
  plan.textured = shades && state.texturing.count > 0;
  plan.colors = shades && (!plan.textured || textures_read_color(state.texturing));
  plan.blends = writes_color && (state.raster.blend.enabled || state.raster.logic_op != LogicOp::copy);
  plan.polygon_stipple = state.raster.polygon_stipple.enabled;
  const bool smooth = state.points.smooth || state.lines.smooth || state.polygons.smooth;
  plan.coverage = shades && ((smooth && !state.multisample.enabled) || state.points.fade_threshold_px > 0);
  plan.writes_color = writes_color;
  plan.fog = plan.writes_color && state.raster.fog.mode != FogMode::none;
  plan.secondary_color = secondary_color(state, plan);
  plan.phong = target.methods.shading == ShadingMethod::phong && plan.colors && state.lighting.enabled && state.lighting.light_count > 0;
  plan.fragment = plan.filled = fragment_passes(state, target, plan);
  if (plan.coverage && !state.polygons.smooth) {
    Plan without = plan;
    without.coverage = false;
    plan.filled = fragment_passes(state, target, without);
  }

  plan_vertices(state, plan);
  if (plan.phong) {
    plan.lighting = plan.colors = false;
    plan.eye_positions = true;
  }
  return plan;
}

DrawnKinds kinds_of(const DrawState& state, const VertexBatch& batch) {
  DrawnKinds kinds{false, false, false};
  const auto add_polygons = [&](PolygonMode mode) {
    kinds.points |= mode == PolygonMode::point;
    kinds.lines |= mode == PolygonMode::line;
    kinds.filled |= mode == PolygonMode::fill;
  };
  for (const PrimitiveRange& range : batch.primitives) {
    switch (range.mode) {
      case PrimitiveMode::points:
        kinds.points = true;
        break;
      case PrimitiveMode::lines:
      case PrimitiveMode::line_loop:
      case PrimitiveMode::line_strip:
        kinds.lines = true;
        break;
      default:
        add_polygons(state.assembly.polygon_mode_front);
        add_polygons(state.assembly.polygon_mode_back);
    }
  }
  return kinds;
}

std::string describe(const Plan& plan, const DrawState& state, TargetFormat target, DrawnKinds kinds) {
  std::string text;
  const Line line{text};
  if (!plan.draws) {
    text = "plan: nothing can reach the framebuffer\n";
    return text;
  }
  text = "plan:\n";
  if (target.methods != Methods{}) text += "  methods: " + describe(target.methods) + "\n";
  line("transform to clip space", "", "§2.11.2");
  if (plan.eye_positions) line("transform to eye space", "", "§2.11.2");
  if (plan.normals) {
    constexpr std::array<std::string_view, 3> scaling{"", "rescaled", "normalized"};
    line("transform normals", scaling[static_cast<std::size_t>(state.transform.normal_scaling)], "§2.11.3");
  }
  if (plan.lighting || plan.phong) line(plan.phong ? "light fragments" : "light", describe_lights(state.lighting), "§2.14.1");
  if (plan.vertex_colors) line("clamp vertex colors", plan.secondary_vertex_colors ? "and secondary colors" : "", "§2.14.6");
  if (plan.secondary_color == SecondaryColor::summed_at_vertices) line("add the secondary color", "at the vertices", "§3.9");
  for (std::size_t i = 0; plan.textured && i < state.texturing.count; ++i) {
    const int unit = state.texturing.unit[i].unit;
    line("texture coordinates", describe_coordinates(state.texture_coordinates.unit[static_cast<std::size_t>(unit)], unit), "§2.11.4");
  }
  if (plan.fog) line("fog coordinate", state.raster.fog.from_coordinate ? "given" : "distance from the eye", "§3.10");
  const int planes = state.clip_planes.count;
  line("clip and project", planes == 0 ? "" : std::to_string(planes) + (planes == 1 ? " plane" : " planes"), "§2.12, §2.11.1");
  if (plan.reports) {
    line("report", "", "§5.2, §5.3");
    return text;
  }
  if (state.assembly.cull != CullMode::none) line("cull", "", "§3.5.1");
  line("rasterize", plan.colors && state.assembly.shade_model == ShadeModel::flat ? "flat" : "", "§3.5.1");
  describe_rasterization(state, kinds, line);
  if (plan.polygon_stipple) line("polygon stipple", "", "§3.5.2");
  const auto describe_shading = [&] {
    constexpr std::array<std::string_view, 4> modes{"", "linear", "exp", "exp2"};
    for (std::size_t i = 0; plan.textured && i < state.texturing.count; ++i) {
      line("texture", describe_unit(state.texturing.unit[i]), "§3.8.8, §3.8.13");
    }
    if (plan.secondary_color == SecondaryColor::interpolated) line("add the secondary color", "", "§3.9");
    if (plan.fog) line("fog", modes[static_cast<std::size_t>(state.raster.fog.mode)], "§3.10");
    const bool only_filled = !kinds.points && !kinds.lines;
    const bool covers = plan.coverage && (!only_filled || state.polygons.smooth);
    if (covers) line(state.multisample.enabled ? "point fade" : "coverage", "", state.multisample.enabled ? "§3.12" : "§3.11");
    if (plan.sample_alpha) line("alpha to samples", "", "§4.1.3");
  };
  const bool shades_first = shades_before_depth(state, plan);
  if (plan.fragment.rejects_early) line("reject hidden fragments", "", "§4.1.6");
  if (shades_first) describe_shading();
  if (plan.alpha_test) line("alpha test", compare_names[static_cast<std::size_t>(state.raster.alpha_test.func)], "§4.1.4");
  if (plan.stencil) line("stencil test", describe_stencil(state.raster.stencil), "§4.1.5");
  if (plan.depth) {
    std::string detail(compare_names[static_cast<std::size_t>(state.raster.depth.func)]);
    if (state.raster.depth.write_enabled) detail += ", write";
    line("depth test", detail, "§4.1.6");
  }
  if (plan.counts_samples) line("count samples", "", "§4.1.7");
  if (!shades_first) describe_shading();
  if (plan.blends && state.raster.blend.enabled) line("blend", describe_blending(state.raster.blend), "§4.1.8");
  if (plan.blends && !state.raster.blend.enabled) {
    line("logical operation", logic_op_names[static_cast<std::size_t>(state.raster.logic_op)], "§4.1.10");
  }
  if (plan.writes_color) {
    constexpr std::array<std::string_view, 4> formats{"", "8 bits", "16 bits", "float"};
    std::string detail(formats[static_cast<std::size_t>(target.color)]);
    if (state.raster.color_write_mask != 0xF) detail += ", masked";
    line("write color", detail, "§4.2.2");
  }
  return text;
}

}  // namespace gouraud::pipeline
