// Takes fragments and clears, gives the picture [GL1.5 §4.1.2, §4.1.4 to §4.1.6, §4.2.2, §4.2.3].
// Keeps beside every ideal value the stored integer, because later tests work on stored values. Where a depth test
// hangs on less than the legal error (OracleOptions::depth_slack_units), both outcomes are kept as possible contents of
// the pixel; fragments of exactly the same ideal depth are equal, as repeated drawing must be [GL1.5 App. A].
#pragma once

#include <functional>
#include <optional>

#include "conformance/oracle/oracle.h"
#include "conformance/oracle/vertex.h"

namespace gouraud::oracle {

/// A fragment of pixel (x, y). Colours need no clamping; the bounds equal the values unless `extrapolated`.
struct Fragment {
  int x = 0, y = 0;
  Color color{}, color_lowest{}, color_highest{};
  double fog_coordinate = 0;
  /// Another one that is as legal, and all in between, if `extrapolated`.
  std::optional<double> other_fog_coordinate;
  double depth = 0;  ///< window z
  /// Window z that a conforming implementation may have computed: at most the slack away, within the vertices' range.
  double depth_lowest = 0, depth_highest = 0;
  bool extrapolated = false;
  double coverage = 1;  ///< of a smooth primitive: multiplies alpha [GL1.5 §3.11]
  double coverage_slack = 0;  ///< how far a conforming coverage may be from it
  bool may_be_absent = false;  ///< the sample is so near to an edge that either side is legal
  Face face = front;  ///< of the polygon that it is of; points and lines of their own are front
};

/// What a conforming colour may be off the ideal one before it is rounded to a byte or tested, in bytes: as much as filtered
/// texels are, whose coordinates are floats.
inline constexpr double color_slack_bytes = 0.01;

/// The largest depth that a buffer of so many bits can hold; 0 for no buffer.
double depth_units_of(int depth_bits);

/// A new picture: everything zero.
OraclePicture make_picture(int width_px, int height_px, int depth_bits);

/// Fog, scissor, the share of this sample in alpha [GL1.5 §4.1.3], alpha, stencil and depth test, blending, masks and write.
void write_fragment(OraclePicture& picture, const pipeline::RasterState& state, const Fragment& fragment, std::size_t sample = 0);

void clear_picture(OraclePicture& picture, const pipeline::ClearState& state);

/// A pixel with the ranges that hold all its possible contents.
struct PixelOutcomes {
  OraclePixel pixel;
  std::uint8_t flags = 0;  ///< PixelFlags
  /// Widens the ranges.
  void include(const PixelOutcomes& other);
};
PixelOutcomes with_all_outcomes(const OraclePicture& picture, std::size_t index);

/// Changes every possible content of the pixels inside `box`.
void change_pixels(OraclePicture& picture, const pipeline::PixelRect& box, const std::function<void(OraclePixel&)>& change);

}  // namespace gouraud::oracle
