// What a draw looks like to the pipeline: canonical, immutable, trivially copyable, without GLenums or names.
//
// Canonical: two GL states that give the same picture give equal DrawStates. A disabled feature's fields hold their
// initial values below; a light that can add nothing is absent; a scissor box that covers the target is the target.
// The snapshot (api/snapshot) makes it; the planner, the stages and the oracle read it.
//
// Spaces: object -> eye -> clip -> (divide) -> window. Window space is GL's: y up, pixel (i, j) has its centre at
// (i + 0.5, j + 0.5). Colours are RGBA, not clamped unless their name says so.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include <glm/glm.hpp>

#include "pipeline/draw/limits.h"
#include "pipeline/draw/texture_state.h"

namespace gouraud::pipeline {

/// Primitive modes of Begin [GL1.5 §2.6.1].
enum class PrimitiveMode : std::uint8_t {
  points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan, quads, quad_strip, polygon
};

enum class CompareFunc : std::uint8_t { never, less, equal, lequal, greater, notequal, gequal, always };
enum class PolygonMode : std::uint8_t { fill, line, point };
enum class CullMode : std::uint8_t { none, front, back, front_and_back };
enum class FrontFace : std::uint8_t { ccw, cw };
enum class ShadeModel : std::uint8_t { smooth, flat };
/// What happens to the length of an eye-space normal [GL1.5 §2.11.3].
enum class NormalScaling : std::uint8_t { none, rescale, normalize };

/// Matrices, column major as GL's, and the viewport [GL1.5 §2.11].
struct TransformState {
  glm::mat4 modelview{1.0f};
  glm::mat4 projection{1.0f};
  /// projection * modelview, in float, each element ((a0*b0 + a1*b1) + a2*b2) + a3*b3 (MESA-RULES 2.1).
  glm::mat4 modelview_projection{1.0f};
  /// Transposed inverse of the upper 3x3 of the modelview: takes normals to eye space. Identity if no stage needs normals.
  glm::mat3 normal_matrix{1.0f};
  NormalScaling normal_scaling = NormalScaling::none;
  /// The factor f of RESCALE_NORMAL [GL1.5 §2.11.3]; 1 otherwise.
  float rescale_factor = 1.0f;
  bool operator==(const TransformState&) const = default;
};

/// glViewport and glDepthRange, and how window space lies in the framebuffer [GL1.5 §2.11.1].
struct ViewportState {
  std::int32_t x = 0, y = 0, width_px = 0, height_px = 0;
  double depth_near = 0.0, depth_far = 1.0;  ///< in [0, 1]
  /// Height of the target. Window y is computed from the top (MESA-RULES 2.3: y_raster = target_height - y_window)
  /// before it is snapped, so that snapping rounds the same way as Mesa's.
  std::int32_t target_height_px = 0;
  bool upper_left = false;   ///< y = -1 in normalized device coordinates is the viewport's top [ARB_clip_control]
  bool zero_to_one = false;  ///< the near plane is z = 0, not z = -w [ARB_clip_control]
  /// Where samples lie: window positions are moved so that a sample stands in a pixel's centre. 0 in a DrawState.
  float sample_shift_x = 0.0f, sample_shift_y = 0.0f;
  bool operator==(const ViewportState&) const = default;
};

/// A material face [GL1.5 Table 2.11]. Alpha of the lit colour is diffuse alpha.
struct Material {
  glm::vec4 ambient{0.2f, 0.2f, 0.2f, 1.0f};
  glm::vec4 diffuse{0.8f, 0.8f, 0.8f, 1.0f};
  glm::vec4 specular{0.0f, 0.0f, 0.0f, 1.0f};
  glm::vec4 emission{0.0f, 0.0f, 0.0f, 1.0f};
  float shininess = 0.0f;  ///< in [0, 128]
  bool operator==(const Material&) const = default;
};
struct MaterialPair {
  Material front, back;
  bool operator==(const MaterialPair&) const = default;
};

/// Material parameters that follow the vertex colour (ColorMaterial), as a set of bits, one set a face [GL1.5 §2.14.3].
enum MaterialBits : std::uint8_t {
  material_none = 0, material_ambient = 1, material_diffuse = 2, material_specular = 4, material_emission = 8
};

/// One enabled light that can contribute, ready for use in eye space [GL1.5 §2.14.1].
struct PreparedLight {
  glm::vec4 ambient{0.0f}, diffuse{0.0f}, specular{0.0f};
  bool positional = false;
  /// Positional: the light's eye position divided by its w. Directional: unit vector towards the light
  /// (zero if the direction given was zero).
  glm::vec3 position_eye{0.0f};
  /// Attenuation 1 / (k0 + k1 d + k2 d^2); (1, 0, 0) means none. Always (1, 0, 0) for directional lights.
  glm::vec3 attenuation{1.0f, 0.0f, 0.0f};
  bool spot = false;  ///< cutoff is not 180
  glm::vec3 spot_direction_eye{0.0f};  ///< unit vector; zero if not a spot
  float spot_cutoff_cosine = -1.0f;
  float spot_exponent = 0.0f;
  bool operator==(const PreparedLight&) const = default;
};

/// [GL1.5 §2.14]. If !enabled everything else has its initial value and vertices keep their current colours.
struct LightingState {
  bool enabled = false;
  bool two_sided = false;
  bool local_viewer = false;
  bool separate_specular = false;
  std::uint8_t color_material_front = material_none, color_material_back = material_none;
  std::uint8_t light_count = 0;
  glm::vec4 scene_ambient{0.0f};  ///< light model ambient
  std::array<PreparedLight, max_lights> lights{};  ///< the first light_count, in ascending GL light number
  /// Material in force at the first vertex of a batch; VertexBatch::material_runs change it later. `back` equals
  /// `front` unless two_sided. Parameters that follow the vertex colour hold initial values.
  MaterialPair material{};
  bool operator==(const LightingState&) const = default;
};

/// User clip planes [GL1.5 §2.12]: a vertex is inside where dot(plane, position_eye) >= 0.
struct ClipPlaneState {
  std::uint8_t count = 0;
  std::array<glm::vec4, max_clip_planes> plane_eye{};  ///< the first `count`, enabled ones in ascending order; else 0
  bool operator==(const ClipPlaneState&) const = default;
};

/// [GL1.5 §3.10]. If the mode is `none` all has its initial value; a mode's foreign parameters are 0.
enum class FogMode : std::uint8_t { none, linear, exp, exp2 };
struct FogState {
  FogMode mode = FogMode::none;
  bool from_coordinate = false;  ///< the vertex's fog coordinate; else the distance |z_eye| (MESA-RULES 6)
  float density = 0.0f, start = 0.0f, end = 0.0f;
  glm::vec3 color{0.0f};  ///< in [0, 1]
  bool operator==(const FogState&) const = default;
};

/// Assembly and facing [GL1.5 §2.14.1, §3.5.1, §3.5.4].
struct AssemblyState {
  ShadeModel shade_model = ShadeModel::smooth;
  FrontFace front_face = FrontFace::ccw;
  CullMode cull = CullMode::none;
  PolygonMode polygon_mode_front = PolygonMode::fill, polygon_mode_back = PolygonMode::fill;
  bool operator==(const AssemblyState&) const = default;
};

/// Sizes and widths beyond are drawn as this one [GL1.5 §3.3, §3.4.2].
inline constexpr float most_wide_px = 255.0f;

/// [GL1.5 §3.3], ARB_point_sprite. Sizes are in [1, most_wide_px]; those of plain points without attenuation are whole.
/// Where multisampled (MultisampleState), points are sampled discs: `smooth` unless sprites.
struct PointState {
  float size_px = 1.0f;  ///< as drawn; if attenuated: before that, and > 0
  bool smooth = false;   ///< a disc with the area that it covers of each pixel; never a sprite
  bool sprite = false;   ///< a square of exactly that size
  bool attenuated = false;
  /// Of the distance d from the eye: size / sqrt(a + b d + c d^2), kept in [smallest_px, largest_px]. Initial values
  /// unless attenuated.
  glm::vec3 attenuation{1.0f, 0.0f, 0.0f};
  float smallest_px = 1.0f, largest_px = most_wide_px;
  /// Multisampled points that are smaller are drawn with this size, and their alpha fades; 0 if none is.
  float fade_threshold_px = 0.0f;
  bool operator==(const PointState&) const = default;
};

/// [GL1.5 §3.4]. Where multisampled (MultisampleState), lines are sampled rectangles: `smooth`.
struct LineState {
  float width_px = 1.0f;  ///< in [1, most_wide_px]; whole unless smooth
  bool smooth = false;    ///< a rectangle with the area that it covers of each pixel
  std::uint16_t stipple_pattern = 0xFFFF;  ///< bit 0 first; 0xFFFF: not stippled
  std::int32_t stipple_factor = 1;         ///< in [1, 256]; 1 if not stippled
  bool operator==(const LineState&) const = default;
};

/// [GL1.5 §3.5.3, §3.5.5] of filled polygons, and of those drawn as lines and points. Offsets are absent (initial) if
/// there is no depth, if no face is drawn in a mode that is offset, or if all terms are 0.
struct PolygonState {
  bool smooth = false;  ///< polygons that are filled; false where multisampled
  bool offset_fill = false, offset_line = false, offset_point = false;
  float offset_factor = 0.0f, offset_units = 0.0f;
  float offset_bias = 0.0f;  ///< in window z, whatever the buffer's step
  bool operator==(const PolygonState&) const = default;
};

/// [GL1.5 §3.5.2]. Row r holds the pixels with y mod 32 = r, its bit k those with x mod 32 = k. All zero if not enabled.
struct PolygonStippleState {
  bool enabled = false;
  std::array<std::uint32_t, 32> rows{};
  bool operator==(const PolygonStippleState& other) const {
    return enabled == other.enabled && (!enabled || rows == other.rows);
  }
};

/// Pixels [x0, x1) x [y0, y1) of the target, y up.
struct PixelRect {
  std::int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
  bool operator==(const PixelRect&) const = default;
};

/// [GL1.5 §4.1.6]. Without a test there is no write either.
struct DepthState {
  bool test_enabled = false;
  bool write_enabled = false;
  CompareFunc func = CompareFunc::always;
  bool operator==(const DepthState&) const = default;
};

/// [GL1.5 §4.1.5], with EXT_stencil_wrap.
enum class StencilOp : std::uint8_t { keep, zero, replace, increment, decrement, invert, increment_wrap, decrement_wrap };

/// The stencil test of fragments of one facing. What cannot have an effect is initial: operations of outcomes that cannot
/// happen or whose bits are masked, and bits of reference and masks that nothing reads.
struct StencilFace {
  CompareFunc func = CompareFunc::always;
  std::uint8_t reference = 0, compare_mask = 0xFF, write_mask = 0xFF;
  StencilOp fail = StencilOp::keep, depth_fail = StencilOp::keep, depth_pass = StencilOp::keep;
  bool writes() const { return fail != StencilOp::keep || depth_fail != StencilOp::keep || depth_pass != StencilOp::keep; }
  bool operator==(const StencilFace&) const = default;
};

/// [GL1.5 §4.1.5]. If !enabled all is initial; a test that passes all and changes nothing is not enabled, nor is one
/// without a stencil buffer. `back` is of polygons that face away (EXT_stencil_two_side); it equals `front` if there is
/// one test for both faces, or if back faces are culled.
struct StencilState {
  bool enabled = false;
  StencilFace front{}, back{};
  bool writes() const { return front.writes() || back.writes(); }
  bool operator==(const StencilState&) const = default;
};

/// [GL1.5 §4.1.4]. If !enabled, or if the function is `never`, the reference is 0; `always` is not enabled.
struct AlphaTestState {
  bool enabled = false;
  CompareFunc func = CompareFunc::always;
  float reference = 0.0f;  ///< in [0, 1]
  bool operator==(const AlphaTestState&) const = default;
};

/// [GL1.5 §4.1.8]. min and max take no factors.
enum class BlendEquation : std::uint8_t { add, subtract, reverse_subtract, min, max };

/// [GL1.5 §4.1.8 Table 4.1].
enum class BlendFactor : std::uint8_t {
  zero, one, source_color, one_minus_source_color, destination_color, one_minus_destination_color, source_alpha,
  one_minus_source_alpha, destination_alpha, one_minus_destination_alpha, constant_color, one_minus_constant_color,
  constant_alpha, one_minus_constant_alpha, source_alpha_saturate
};

/// How one group of channels is blended; (one, zero, add) replaces.
struct BlendTerms {
  BlendEquation equation = BlendEquation::add;
  BlendFactor source = BlendFactor::one, destination = BlendFactor::zero;
  bool operator==(const BlendTerms&) const = default;
};

/// [GL1.5 §4.1.8]. Absent (all initial) if it would replace. Terms of channels that are not written replace; those of
/// alpha name alpha where they could name colour; the constant is 0 if no factor takes it.
struct BlendState {
  bool enabled = false;
  BlendTerms rgb{}, alpha{};
  glm::vec4 constant{0.0f};  ///< in [0, 1]
  bool operator==(const BlendState&) const = default;
};

/// [GL1.5 §4.1.10 Table 4.2].
enum class LogicOp : std::uint8_t {
  clear, and_, and_reverse, copy, and_inverted, noop, xor_, or_, nor, equiv, invert, or_reverse, copy_inverted,
  or_inverted, nand, set
};

/// [GL1.5 §3.2.1, §4.1.3]. Off (all initial) unless the target has several samples and MULTISAMPLE is enabled.
struct MultisampleState {
  bool enabled = false;  ///< each sample has its own place in the pixel; else all have the pixel's centre
  std::uint8_t sample_mask = 0xF;  ///< bit k: sample k is drawn (SAMPLE_COVERAGE); what alpha does is RasterState's
  bool operator==(const MultisampleState&) const = default;
};

/// Everything that fragments need after rasterization: small, interned, referred to by the bins until a flush.
struct RasterState {
  /// Where fragments may land: scissor box (if enabled) and target, intersected.
  PixelRect scissor{};
  DepthState depth{};
  std::uint8_t color_write_mask = 0xF;  ///< bit 0 red, 1 green, 2 blue, 3 alpha; 0 if the target has no colour
  /// [GL1.5 §4.1.3] of a multisampled draw: among how many samples a fragment's alpha chooses (0: it does not), and
  /// whether alpha is 1 from there on.
  std::uint8_t alpha_to_coverage = 0;
  bool alpha_to_one = false;
  AlphaTestState alpha_test{};
  BlendState blend{};
  /// `copy` without a logic operation, and on floating-point targets, where it has no meaning. Excludes blending.
  LogicOp logic_op = LogicOp::copy;
  FogState fog{};
  PolygonStippleState polygon_stipple{};  ///< of filled polygons; not of lines, points and pixel images
  StencilState stencil{};
  /// An occlusion query counts the fragments that pass the depth test [GL1.5 §4.1.7].
  bool counts_samples = false;
  bool operator==(const RasterState&) const = default;

  /// Whether fragments need their colour: for the target or for a test.
  bool needs_colors() const {
    return color_write_mask != 0 || alpha_to_coverage != 0 || (alpha_test.enabled && alpha_test.func != CompareFunc::never);
  }
};
static_assert(std::is_trivially_copyable_v<RasterState> && sizeof(RasterState) <= 512);

/// Vertices that are reported to the application instead of rasterized: feedback, selection and the raster position
/// [GL1.5 §2.13, §5.2, §5.3]. What reaches the framebuffer does not matter then: nothing does.
struct ReportState {
  bool enabled = false;
  bool colors = false;         ///< primary and secondary colour are wanted
  bool eye_positions = false;  ///< the distance from the eye is wanted
  /// Bit k: all four coordinates of unit k are wanted, textured or not; TextureCoordinatesState has their sources.
  std::uint8_t texture_units = 0;
  bool operator==(const ReportState&) const = default;
};

struct DrawState {
  TransformState transform{};
  ViewportState viewport{};
  LightingState lighting{};
  AssemblyState assembly{};
  PointState points{};
  LineState lines{};
  PolygonState polygons{};
  ClipPlaneState clip_planes{};
  /// Without lighting: whether the secondary colour of the vertices is added (COLOR_SUM) [GL1.5 §3.9].
  bool color_sum = false;
  MultisampleState multisample{};
  TextureCoordinatesState texture_coordinates{};
  TexturingState texturing{};
  RasterState raster{};
  ReportState report{};
  bool operator==(const DrawState&) const = default;
};
static_assert(std::is_trivially_copyable_v<DrawState>);

/// glClear of the chosen buffers under scissor and masks [GL1.5 §4.2.3].
struct ClearState {
  bool color = false, depth = false, stencil = false, accum = false;
  PixelRect scissor{};
  std::uint8_t color_write_mask = 0xF;
  glm::vec4 clear_color{0.0f};  ///< clamped to [0, 1]
  double clear_depth = 1.0;     ///< in [0, 1]
  std::uint32_t clear_stencil = 0, stencil_write_mask = ~0u;
  glm::vec4 clear_accum{0.0f};  ///< in [-1, 1]
  bool operator==(const ClearState&) const = default;
};

/// [GL1.5 §4.2.4]: load and accumulate take the colour buffer into the accumulation buffer, `give_back` is the way back.
enum class AccumOp : std::uint8_t { accumulate, load, add, multiply, give_back };

/// One accumulation of all pixels inside the scissor box.
struct AccumState {
  AccumOp op = AccumOp::accumulate;
  float value = 0.0f;  ///< finite; in [-1, 1] for add and multiply
  PixelRect scissor{};
  std::uint8_t color_write_mask = 0xF;  ///< of give_back
  bool operator==(const AccumState&) const = default;
};

/// From edge to edge; an edge after its opposite flips.
struct BlitRect {
  std::int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// glBlitFramebuffer [ARB_framebuffer_object].
struct Blit {
  BlitRect source, destination;
  PixelRect scissor{};  ///< of the destination, inside it
  bool color = false, depth = false, stencil = false;
  bool linear = false;  ///< colour between pixels is interpolated; else that of the nearest pixel is taken
};

}  // namespace gouraud::pipeline
