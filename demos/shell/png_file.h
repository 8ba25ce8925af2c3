// Writes a picture as a PNG file.
#pragma once

#include <string>

#include "demos/shell/canvas.h"

namespace shell {

// Writes the canvas as 8-bit RGB; alpha is left out, as a window would not show it either.
// Throws std::runtime_error with the file's name and libpng's reason.
void write_png(const Canvas& canvas, const std::string& file);

}  // namespace shell
