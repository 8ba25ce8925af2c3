#include "demos/shell/shell.h"

#include <chrono>
#include <cstdio>
#include <exception>

#include "demos/shell/canvas.h"
#include "demos/shell/options.h"
#include "demos/shell/png_file.h"
#include "demos/shell/window.h"

namespace shell {
namespace {

constexpr double frame_interval_s = 1.0 / 60;

// Draws the frames at simulated times, so that the same arguments give the same pictures on every machine.
void run_headless(const Demo& demo, const Options& options) {
  Canvas canvas(options.width_px, options.height_px);
  demo.init();
  demo.reshape(options.width_px, options.height_px);
  if (demo.key != nullptr) {
    for (const int key : options.keys) demo.key(key);
  }
  if (demo.click != nullptr && options.click) {
    if (demo.animate != nullptr) demo.animate(options.time_s.value_or(0));
    demo.click(options.click->x, options.click->y);
  }

  const bool numbered = is_numbered(options.out);
  std::chrono::duration<double, std::milli> drawing{};
  for (int frame = 0; frame < options.frames; ++frame) {
    const auto begin = std::chrono::steady_clock::now();
    if (demo.animate != nullptr) demo.animate(options.time_s.value_or(frame * frame_interval_s));
    demo.draw();
    canvas.finish();
    drawing += std::chrono::steady_clock::now() - begin;
    if (numbered || frame + 1 == options.frames) write_png(canvas, frame_file(options.out, frame));
  }
  if (demo.status != nullptr) std::printf("%s: %s\n", demo.name, demo.status());
  std::printf("%s: wrote %s (%dx%d; %d frame%s, %.2f ms each)\n", demo.name, options.out.c_str(), options.width_px,
              options.height_px, options.frames, options.frames == 1 ? "" : "s", drawing.count() / options.frames);
}

}  // namespace

int run(int argc, char** argv, const Demo& demo) {
  std::string error;
  const auto options = parse_options({argv + 1, argv + argc}, demo, error);
  if (!options) {
    std::fprintf(stderr, "%s: %s\n", demo.name, error.c_str());
    return 2;
  }
  if (options->help) {
    std::fputs(help_text(demo).c_str(), stdout);
    return 0;
  }
  try {
    std::string reason;
    if (!options->headless && open_display(reason)) {
      run_in_window(demo, *options);
      return 0;
    }
    if (!options->headless) std::printf("%s: no window (%s), so writing a picture\n", demo.name, reason.c_str());
    run_headless(demo, *options);
    return 0;
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "%s: %s\n", demo.name, failure.what());
    return 1;
  }
}

}  // namespace shell
