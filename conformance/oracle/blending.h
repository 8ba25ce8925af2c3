// Takes a fragment's colour and a pixel's, gives what the pixel holds afterwards, in an 8-bit buffer
// [GL1.5 §4.1.8, §4.1.10, §4.2.2]. choice: blending works on stored values: source and constant are rounded to 8 bits
// first, every product is rounded, sums are clamped (MESA-RULES 8).
#pragma once

#include "conformance/oracle/fragments.h"

namespace gouraud::oracle {

/// Writes the fragment's colour into `pixel`: blended or combined as `state` says, under the colour mask. False if the
/// result has a legal range, because source or destination has one, or might have been rounded the other way.
bool write_color(OraclePixel& pixel, const pipeline::RasterState& state, const Fragment& fragment);

/// Whether the fragment passes the alpha test, alpha and reference rounded to 8 bits [GL1.5 §4.1.4]; and whether an
/// error of color_slack_bytes, or what is legal where the fragment is extrapolated, would turn that.
struct AlphaVerdict {
  bool passes = true, ambiguous = false;
};
AlphaVerdict test_alpha(const pipeline::AlphaTestState& state, const Fragment& fragment);

}  // namespace gouraud::oracle
