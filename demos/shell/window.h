// The demo in a window.
#pragma once

#include <string>

#include "demos/shell/options.h"

namespace shell {

// Connects to the display. False where there is none; `reason` says why.
bool open_display(std::string& reason);

// Runs the demo until ESC or until the window is closed; call after open_display(). Throws std::runtime_error.
void run_in_window(const Demo& demo, const Options& options);

}  // namespace shell
