// The window system of the demos, in the manner of GLUT: a demo fills in its callbacks and hands them to run().
// The GL context is current in every callback. The same demo runs in a window or, without one, writes PNG files.
#pragma once

namespace shell {

// Keys as `Demo::key` gets them: printable ASCII as itself, and these.
inline constexpr int key_left = 256;
inline constexpr int key_right = 257;
inline constexpr int key_up = 258;
inline constexpr int key_down = 259;

struct Demo {
  const char* name = "";       // window title and default PNG name
  const char* keys_help = "";  // what the keys do, one line for --help
  int width_px = 640;          // picture size where --size does not say otherwise
  int height_px = 480;
  void (*init)() = nullptr;                                // once, before anything else
  void (*reshape)(int width_px, int height_px) = nullptr;  // before the first frame and after every change of size
  void (*animate)(double seconds) = nullptr;               // before every frame: time since the start; null: a still
  void (*key)(int key) = nullptr;                          // a key was pressed; the frame is drawn anew afterwards
  void (*click)(int x, int y) = nullptr;                   // the mouse was pressed at this pixel, y from the top; as key
  void (*draw)() = nullptr;                                // one frame; the shell finishes and shows it
  const char* (*status)() = nullptr;                       // what the title says after the name, in place of the time
};

// Runs the demo until ESC or, headless, until the last frame. Returns the exit status: 0 done, 1 something failed
// (one line on stderr says what), 2 bad arguments.
int run(int argc, char** argv, const Demo& demo);

}  // namespace shell
