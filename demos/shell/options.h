// The command line that all demos share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "demos/shell/shell.h"

namespace shell {

// A pixel of the picture, y from the top.
struct Click {
  int x = 0, y = 0;
  bool operator==(const Click&) const = default;
};

struct Options {
  int width_px = 0;
  int height_px = 0;
  int frames = 1;
  std::string out;               // file name, or a pattern with one %d; empty: NAME.png
  std::optional<double> time_s;  // the clock stands at this time
  std::vector<int> keys;         // pressed before the first frame
  std::optional<Click> click;    // then the mouse, here
  bool headless = false;
  bool help = false;
};

// What --help prints.
std::string help_text(const Demo& demo);

// Reads the arguments after the program's name. On failure returns nothing and puts one line into `error`.
std::optional<Options> parse_options(const std::vector<std::string>& arguments, const Demo& demo, std::string& error);

// The file that frame `frame` goes to: `out` with its %d, %4d or %04d replaced by the number.
std::string frame_file(const std::string& out, int frame);

// Whether `out` numbers its frames, so that every frame is written and not only the last.
bool is_numbered(const std::string& out);

}  // namespace shell
