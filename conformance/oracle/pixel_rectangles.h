// Takes bitmaps and pixel rectangles, gives fragments by the rules as they are written: every pixel of the window asks
// whether its centre is inside [GL1.5 §3.6.4, §3.7].
#pragma once

#include "conformance/oracle/fragments.h"
#include "conformance/oracle/targets.h"
#include "pipeline/draw/draw_observer.h"

namespace gouraud::oracle {

void draw_rectangle(Samples& samples, const pipeline::DrawState& state, const pipeline::FragmentSource& source,
                    const pipeline::PixelRectangle& rectangle);
void draw_bitmap(Samples& samples, const pipeline::DrawState& state, const pipeline::FragmentSource& source,
                 const pipeline::Bitmap& bitmap);
/// Stencil and depth past all tests but the scissor [GL1.5 §4.3.1].
void write_directly(Samples& samples, const pipeline::DirectRectangle& rectangle);

}  // namespace gouraud::oracle
