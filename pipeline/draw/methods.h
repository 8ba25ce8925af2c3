// Methods: where the field knows several ways to do a step, which of them is used. Initial values are the conforming
// ones; the others are here to be compared with them, and each says in its file what it is good for and where it fails.
//
// A method is chosen where a plan is made or a batch is drawn, never for a pixel: the plan takes other passes, the
// renderer another way to the bins. A plan without methods is the same plan as if there were none.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace gouraud::pipeline {

/// Which pixels a filled triangle covers [GL1.5 §3.5.1].
enum class CoverageMethod : std::uint8_t {
  blocks8, blocks4, blocks16, blocks64, bounding_box, incremental, scanline, barycentric, homogeneous, float_edges, float_steps
};

/// Who gets a sample that lies exactly on an edge: one of the triangles that share it, all, or none.
enum class OwnershipMethod : std::uint8_t { top_left, all, none };

/// What becomes of triangles that lie partly outside the clip volume [GL1.5 §2.12]. Lines, points, polygons that are not
/// filled and the user's clip planes are clipped as ever.
enum class ClippingMethod : std::uint8_t { clip_space, guard_band, homogeneous, none };

/// How lines become pixels [GL1.5 §3.4].
enum class LineMethod : std::uint8_t { diamond_exit, naive, dda, bresenham, coverage };

/// How colours, texture coordinates and all else but depth vary over a primitive [GL1.5 §3.4.1, §3.5.1].
/// `hint`: as PERSPECTIVE_CORRECTION_HINT says; whoever makes a plan has resolved it.
enum class InterpolationMethod : std::uint8_t { perspective, affine, affine8, affine16, barycentric, hint };

/// What a depth buffer holds [GL1.5 §4.1.6]. z16 to z_reversed are formats of the window's buffer (z: the visual's own);
/// drawing into anything else, they are z.
enum class DepthMethod : std::uint8_t { z, z16, z24, z32, z_float, z_reversed, w, w16, painter, ray };

/// Whether colours vary over a primitive: as the shade model says, not at all, or lit anew at every fragment.
enum class ShadingMethod : std::uint8_t { gouraud, flat, phong };

/// The cosine that a highlight is a power of [GL1.5 §2.14.1]: between normal and half vector, or mirrored light and viewer.
enum class HighlightMethod : std::uint8_t { half_vector, reflection };
/// Whose powers: ours, of equal bits everywhere, or the C library's.
enum class PowerMethod : std::uint8_t { reproducible, libm };

/// How much of a pixel is covered: by its centre, by the area of triangles, or by the mean of many samples.
enum class AntialiasingMethod : std::uint8_t {
  none, area, multisample4, supersample2, supersample4, supersample8, supersample16, supersample32
};

struct Methods {
  CoverageMethod coverage = CoverageMethod::blocks8;
  OwnershipMethod ownership = OwnershipMethod::top_left;
  float epsilon = 1e-4f;  ///< of CoverageMethod::barycentric, in [0, 1]
  ClippingMethod clipping = ClippingMethod::clip_space;
  LineMethod lines = LineMethod::diamond_exit;
  InterpolationMethod colors = InterpolationMethod::perspective;
  DepthMethod depth = DepthMethod::z;
  ShadingMethod shading = ShadingMethod::gouraud;
  HighlightMethod highlight = HighlightMethod::half_vector;
  PowerMethod power = PowerMethod::reproducible;
  AntialiasingMethod antialiasing = AntialiasingMethod::none;
  bool operator==(const Methods&) const = default;

  /// Triangles do not go the way of those that wait in the bins, but each with a MethodTriangle beside its record.
  /// Triangles reach the rasterizer that leave the viewport: its rectangle has to be cut out.
  bool leaves_viewport() const { return clipping != ClippingMethod::clip_space || coverage == CoverageMethod::homogeneous; }
  bool shapes_triangles() const {
    return coverage != CoverageMethod::blocks8 || ownership != OwnershipMethod::top_left || colors == InterpolationMethod::barycentric || gathers_triangles();
  }
  /// Lighting follows the equations to the letter.
  bool lights_plainly() const { return highlight != HighlightMethod::half_vector || power != PowerMethod::reproducible; }
  /// The window's depth buffer has another format than its visual.
  bool formats_depth() const { return depth >= DepthMethod::z16 && depth <= DepthMethod::z_reversed; }
  /// Near is 1 and far 0: what compares with, clears or names a depth has it turned round.
  bool reverses_depth() const { return depth == DepthMethod::z_reversed; }
  /// Depths are not those of DepthPlanes.
  bool warps_depth() const { return depth == DepthMethod::w || depth == DepthMethod::w16; }
  /// Triangles wait until all that may hide each other are there.
  bool gathers_triangles() const { return depth == DepthMethod::painter || depth == DepthMethod::ray; }
  /// Lines are walked pixel by pixel.
  bool walks_lines() const { return lines != LineMethod::diamond_exit && lines != LineMethod::coverage; }
  /// Colours do not go from their planes right into the target.
  bool keeps_colors() const { return colors >= InterpolationMethod::affine8; }
};

/// One way to do a step. The first row of a step is its default.
struct MethodRow {
  std::string_view step, name;
  std::string_view line;    ///< what it does
  std::string_view source;  ///< author and year, or the section of the specification
};
std::span<const MethodRow> method_rows();

/// From "step=name,step=name"; steps that are not named have their default, the last one counts. An empty string gives
/// the defaults. Nothing if a step or a name is not known: then `error` says, in one line, what could have stood there.
std::optional<Methods> parse_methods(std::string_view text, std::string& error);

/// The steps that do not have their default, as parse_methods takes them.
std::string describe(const Methods& methods);

struct DrawState;
/// What can be said in the state of a draw: shading, smoothness, which way depth runs. The rest is the plan's and the
/// renderer's. To a fresh state: twice is not once.
void apply_methods(const Methods& methods, DrawState& state);

}  // namespace gouraud::pipeline
