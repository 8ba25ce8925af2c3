// Text in window space, from bitmaps in display lists: a face of 5 x 7 dots, as on a dot matrix printer.
#pragma once

namespace shell {

// Characters this far apart, lines that far.
inline constexpr int glyph_advance_px = 6, line_height_px = 10;

// Makes the lists of all printable characters and returns their base: list base + c draws character c at the current
// raster position and moves it on. Each dot is `scale` pixels a side, 1 to 8.
unsigned make_font(int scale = 1);

// Draws text with the lists of a font at the raster position.
void draw_text(unsigned font, const char* text);

}  // namespace shell
