// The oracle: what the picture is by the specification, in double and exact integers, one plain page per stage. It sees
// the same draws as the pipeline (as a DrawObserver), shares only the data headers with it, and keeps its own picture.
//
// What is taken as given, and what is exact from there on (PositionModel::snapped, the default):
// - Window positions (x, y, z, 1/w) are those of the float chain that MESA-RULES 2.2-2.4 prescribes, clipping included;
//   they are part of the house's specification. Coverage is exact for these positions snapped to 1/256 pixel.
// - Depth is the plane through a (clipped) triangle's unsnapped float window positions; colours are perspective-correct
//   over the same positions, from vertex colours that are computed in double; a vertex that the clipper made gets its
//   colour from the double intersection parameter. Values stay inside the range of the triangle's (line's) vertices.
// PositionModel::exact replaces the float chain by double, and the grid of 1/256 pixel by one of 2^-30: the true picture,
// from which both ours and Mesa's can be measured.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
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
  double depth_units = 0.0;                    ///< ideal depth * (2^bits - 1), not quantised; 0 without a depth buffer
  std::uint32_t depth_stored = 0;              ///< round to nearest even of depth_units
  std::uint32_t depth_lowest = 0, depth_highest = 0;  ///< what a conforming implementation may have stored
  std::int32_t fragments = 0;  ///< fragments of points, lines and polygons written since the pixel was last cleared
  bool operator==(const OraclePixel&) const = default;
};

/// Facts about a pixel, OR-ed over all fragments that met it since it was last cleared.
enum PixelFlags : std::uint8_t {
  pixel_covered = 1,  ///< a fragment was made here (inside the scissor box), whether it passed the depth test or not
  /// A depth test hung on less than the legal error; `alternatives` holds the other outcomes if they differ.
  pixel_depth_ambiguous = 2,
  /// A written fragment's sample lies outside its unsnapped triangle (snapping covered it): the value is the plane's,
  /// clamped to the range of the vertices.
  pixel_extrapolated = 4,
  /// More outcomes than `max_alternatives`: the picture's further outcomes were dropped.
  pixel_alternatives_lost = 8,
};

inline constexpr std::size_t max_alternatives = 7;

/// Rows bottom-up, pixel (x, y) at index y * width_px + x.
struct OraclePicture {
  int width_px = 0, height_px = 0;
  int depth_bits = 0;                ///< 0 (no depth buffer), 16 or 24
  std::vector<OraclePixel> pixels;   ///< ambiguous tests decided by the rounded ideal values
  std::vector<std::uint8_t> flags;   ///< PixelFlags
  /// Other possible contents, by pixel index, none equal to another or to `pixels`.
  std::unordered_map<std::size_t, std::vector<OraclePixel>> alternatives;

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) + static_cast<std::size_t>(x);
  }
  /// How many pixels have any of these flags.
  std::size_t count(std::uint8_t flag_bits) const;
};

/// How far one pixel of another renderer is from the oracle's.
struct PixelError {
  double color = 0.0;  ///< largest |byte - 255 * ideal| over the four channels
  double depth = 0.0;  ///< |integer - ideal units|; 0 without a depth buffer
  bool alternative = false;  ///< measured from an alternative, because that one is nearer
};

/// Measures a pixel from whichever of the oracle's possible outcomes is nearest (by colour, then depth; an outcome that
/// is within 1/255 and 1 unit is taken before any that is not). `depth` is the stored integer; pass
/// `compare_depth = false` if it is not known.
PixelError measure(const OraclePicture& picture, int x, int y, const std::array<std::uint8_t, 4>& rgba_unorm8,
                   std::uint32_t depth, bool compare_depth = true);

/// Install with gouraud::set_draw_observer. Every draw and clear is carried out at once, on the calling thread.
class Oracle : public pipeline::DrawObserver {
 public:
  explicit Oracle(const OracleOptions& options = {});
  ~Oracle() override;
  Oracle(const Oracle&) = delete;
  Oracle& operator=(const Oracle&) = delete;

  void target_changed(int width_px, int height_px, int depth_bits, int stencil_bits) override;
  void draw(const pipeline::DrawState& state, const pipeline::VertexBatch& batch) override;
  void clear(const pipeline::ClearState& state) override;

  const OraclePicture& picture() const { return picture_; }

 private:
  OracleOptions options_;
  OraclePicture picture_;
};

}  // namespace gouraud::oracle
