// The oracle: what the picture is by the specification, in double and exact integers, one plain page per stage. It sees
// the same draws as the pipeline (as a DrawObserver), shares only the data headers with it, and keeps its own pictures: of
// every framebuffer, one a sample (targets.h).
//
// What is taken as given, and what is exact from there on (PositionModel::snapped, the default):
// - Window positions (x, y, z, 1/w) are those of the float chain that MESA-RULES 2.2-2.4 prescribes, clipping included;
//   they are part of the house's specification. Coverage is exact for these positions snapped to 1/256 pixel.
// - Depth is the plane through a (clipped) triangle's unsnapped float window positions; colours are perspective-correct
//   over the same positions, from vertex colours that are computed in double; a vertex that the clipper made gets its
//   colour from the double intersection parameter. Values stay inside the range of the triangle's vertices.
// PositionModel::exact replaces the float chain by double, and the grid of 1/256 pixel by one of 2^-30: the true
// picture, from which both ours and Mesa's can be measured.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "pipeline/draw/draw_observer.h"

namespace gouraud::oracle {

enum class PositionModel : std::uint8_t { snapped, exact };

struct OracleOptions {
  PositionModel positions = PositionModel::snapped;
  /// How far a conforming depth may be from the ideal one before it is rounded, in depth buffer units. Half a unit: the
  /// stored integer is then at most 1 unit from the ideal value (ARCHITECTURE §5). Depth tests whose outcome hangs on
  /// this much are ambiguous.
  double depth_slack_units = 0.5;
};

/// What a pixel holds, under one outcome of its ambiguous depth tests.
struct OraclePixel {
  std::array<double, 4> color{};               ///< RGBA in [0, 1], not quantised
  std::array<std::uint8_t, 4> color_unorm8{};  ///< as stored: round to nearest even of color * 255
  /// Bounds of what a conforming implementation may have computed before it quantised. Equal to `color`, except where
  /// the pixel is extrapolated (PixelFlags).
  std::array<float, 4> color_lowest{}, color_highest{};
  double depth_units = 0.0;        ///< ideal depth * (2^bits - 1), not quantised; 0 without a depth buffer
  std::uint32_t depth_stored = 0;  ///< round to nearest even of depth_units
  std::uint32_t depth_lowest = 0, depth_highest = 0;  ///< what a conforming implementation may have stored
  std::uint8_t stencil = 0;
  /// The accumulation buffer's sums, RGBA in [-1, 1], and their bounds as of `color`.
  std::array<double, 4> accum{};
  std::array<float, 4> accum_lowest{}, accum_highest{};
  bool operator==(const OraclePixel&) const = default;
};

/// Facts about a pixel, OR-ed over all fragments that met it since its colour was last cleared.
enum PixelFlags : std::uint8_t {
  pixel_covered = 1,  ///< a fragment was made here (inside the scissor box), whether it passed the depth test or not
  /// A depth or alpha test, or a blended coverage, hung on less than the legal error; `alternatives` holds the other outcomes if they differ.
  pixel_depth_ambiguous = 2,
  /// A fragment's sample lies outside its unsnapped triangle (snapping covered it), where no specification says what
  /// its values are. Ours: the triangle's planes, kept inside the range of the vertices. Legal: any value that the
  /// triangle has within the half sub-pixel by which snapping can have moved it, and any value of the triangle at all
  /// if its colour changes by more than 1/255 over that distance (slivers). Or it lies beyond the end of a line in
  /// perspective: legal is all from the end's colour to the equation's value. Or a texture's nearest texel, level,
  /// face or comparison hangs on less than the legal error: legal is all from one outcome to the other.
  pixel_extrapolated = 4,
  /// More outcomes than `max_alternatives`: the picture's further outcomes were dropped.
  pixel_alternatives_lost = 8,
};

inline constexpr std::size_t max_alternatives = 7;

/// Rows bottom-up, pixel (x, y) at index y * width_px + x.
struct OraclePicture {
  int width_px = 0, height_px = 0;
  int depth_bits = 0;               ///< 0 (no depth buffer), 16 or 24
  std::vector<OraclePixel> pixels;  ///< ambiguous tests decided by the rounded ideal values
  std::vector<std::uint8_t> flags;  ///< PixelFlags
  /// Fragments that passed all tests, and wrote colour or depth, since the pixel's colour was last cleared.
  std::vector<std::int32_t> fragments_written;
  /// Other possible contents, by pixel index, none equal to another or to `pixels`.
  std::unordered_map<std::size_t, std::vector<OraclePixel>> alternatives;
  /// Vertices lit on a knife's edge, where an error of 1e-6 switches a highlight or a spot light on or off (eq 2.2: n .
  /// VP is all but 0; eq 2.5: on the rim of the cone). A scene with such vertices does not judge fairly.
  std::int64_t knife_edge_vertices = 0;

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) + static_cast<std::size_t>(x);
  }
  /// How many pixels have any of these flags.
  std::size_t count(std::uint8_t flag_bits) const;
};

/// How far one pixel of another renderer is from the oracle's.
struct PixelError {
  double color = 0.0;        ///< largest distance of a byte from 255 * the ideal (the legal range, if extrapolated)
  double depth = 0.0;        ///< distance of the integer from the ideal units (likewise); 0 without a depth buffer
  bool alternative = false;  ///< measured from an alternative, because that one is nearer
};

/// Measures a pixel from whichever of the oracle's possible outcomes is nearest: an outcome that is within 1/255 and
/// 1 unit is taken before any that is not. `depth` is the stored integer; pass `compare_depth = false` if unknown.
PixelError measure(const OraclePicture& picture, int x, int y, const std::array<std::uint8_t, 4>& rgba_unorm8,
                   std::uint32_t depth, bool compare_depth = true);

struct SmoothPart;  // rasterize.h
class Targets;      // targets.h

/// What goes on where a batch was cut.
struct Carried {
  std::int64_t stipple_count = 0;
  bool clipped_quads = false;
  std::vector<SmoothPart> smooth_parts;  ///< of the smooth polygon that is being drawn
};

/// Install with gouraud::set_draw_observer. Every draw, clear and blit is carried out at once, on the calling thread.
class Oracle : public pipeline::DrawObserver {
 public:
  explicit Oracle(const OracleOptions& options = {});
  ~Oracle() override;
  Oracle(const Oracle&) = delete;
  Oracle& operator=(const Oracle&) = delete;

  void target_changed(const pipeline::Framebuffer& target) override;
  void draw(const pipeline::DrawState& state, const pipeline::VertexBatch& batch) override;
  void clear(const pipeline::ClearState& state) override;
  void accumulate(const pipeline::AccumState& state) override;
  void blit(const pipeline::Framebuffer& source, const pipeline::Blit& blit) override;
  void rectangle(const pipeline::DrawState& state, const pipeline::FragmentSource& source,
                 const pipeline::PixelRectangle& rectangle) override;
  void bitmap(const pipeline::DrawState& state, const pipeline::FragmentSource& source,
              const pipeline::Bitmap& bitmap) override;
  void write(const pipeline::DirectRectangle& rectangle) override;

  /// Of the target; of several samples the first one's.
  const OraclePicture& picture() const;
  const std::vector<OraclePicture>& samples() const { return *samples_; }

 private:
  OracleOptions options_;
  std::unique_ptr<Targets> targets_;
  pipeline::Framebuffer target_;
  std::vector<OraclePicture>* samples_ = nullptr;  ///< the target's
  Carried carried_;
};

}  // namespace gouraud::oracle
