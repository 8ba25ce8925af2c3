// Takes bitmaps and pixel rectangles, gives fragments by the rules as they are written: every pixel of the window asks
// whether its centre is inside [GL1.5 §3.6.4, §3.7]. Leaves out texture and fog.
#pragma once

#include "conformance/oracle/fragments.h"
#include "conformance/oracle/targets.h"
#include "pipeline/draw/draw_observer.h"

namespace gouraud::oracle {

void draw_rectangle(Samples& samples, const pipeline::DrawState& state, const pipeline::FragmentSource& source,
                    const pipeline::PixelRectangle& rectangle);
void draw_bitmap(Samples& samples, const pipeline::DrawState& state, const pipeline::FragmentSource& source,
                 const pipeline::Bitmap& bitmap);

}  // namespace gouraud::oracle
