#include "demos/shell/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#define GLFW_EXPOSE_NATIVE_X11
#include <GLFW/glfw3native.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "demos/shell/canvas.h"
#include "demos/shell/x11_presenter.h"

namespace shell {
namespace {

constexpr double frame_interval_s = 1.0 / 60;
constexpr double title_interval_s = 1.0;

std::string glfw_error() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description != nullptr ? description : "unknown reason";
}

// Ends GLFW, whichever way the loop is left.
struct GlfwSession {
  ~GlfwSession() { glfwTerminate(); }
};

// What the callbacks of GLFW need.
struct Events {
  const Demo& demo;
  bool redraw = true;
  int width_px = 0;
  int height_px = 0;
};

Events& events_of(GLFWwindow* window) {
  return *static_cast<Events*>(glfwGetWindowUserPointer(window));
}

void press(Events& events, int key) {
  if (events.demo.key != nullptr) events.demo.key(key);
  events.redraw = true;
}

void on_key(GLFWwindow* window, int key, int, int action, int) {
  if (action == GLFW_RELEASE) return;
  switch (key) {
    case GLFW_KEY_ESCAPE: glfwSetWindowShouldClose(window, GLFW_TRUE); break;
    case GLFW_KEY_LEFT: press(events_of(window), key_left); break;
    case GLFW_KEY_RIGHT: press(events_of(window), key_right); break;
    case GLFW_KEY_UP: press(events_of(window), key_up); break;
    case GLFW_KEY_DOWN: press(events_of(window), key_down); break;
    default: break;  // printable keys come through on_character, with the keyboard's layout applied
  }
}

void on_character(GLFWwindow* window, unsigned codepoint) {
  if (codepoint <= '~') press(events_of(window), static_cast<int>(codepoint));
}

void on_mouse_button(GLFWwindow* window, int, int action, int) {
  Events& events = events_of(window);
  if (action != GLFW_PRESS || events.demo.click == nullptr) return;
  double x = 0, y = 0;
  glfwGetCursorPos(window, &x, &y);
  events.demo.click(static_cast<int>(x), static_cast<int>(y));
  events.redraw = true;
}

void on_size(GLFWwindow* window, int width_px, int height_px) {
  Events& events = events_of(window);
  events.width_px = std::max(width_px, 1);
  events.height_px = std::max(height_px, 1);
  events.redraw = true;
}

void on_refresh(GLFWwindow* window) {
  events_of(window).redraw = true;
}

GLFWwindow* create_window(const Demo& demo, const Options& options) {
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  GLFWwindow* window = glfwCreateWindow(options.width_px, options.height_px, demo.name, nullptr, nullptr);
  if (window == nullptr) throw std::runtime_error("no window could be opened: " + glfw_error());
  return window;
}

// Averages the time of drawing and puts it into the window's title once a second.
class FrameTimeTitle {
 public:
  FrameTimeTitle(GLFWwindow* window, const char* name) : window_(window), name_(name), shown_at_s_(glfwGetTime()) {}

  void add(double drawing_s) {
    drawing_s_ += drawing_s;
    ++frames_;
    if (glfwGetTime() - shown_at_s_ < title_interval_s) return;
    char title[128];
    std::snprintf(title, sizeof title, "%s - %.2f ms a frame", name_, 1000 * drawing_s_ / frames_);
    glfwSetWindowTitle(window_, title);
    *this = FrameTimeTitle(window_, name_);
  }

 private:
  GLFWwindow* window_;
  const char* name_;
  double shown_at_s_;
  double drawing_s_ = 0;
  int frames_ = 0;
};

// Sleeps until there is something to draw: the next frame of an animation, or an event that asks for one.
void wait_for_frame(const Events& events, bool animated, double& next_frame_s) {
  if (!animated) {
    events.redraw ? glfwPollEvents() : glfwWaitEvents();
    return;
  }
  for (double wait_s; (wait_s = next_frame_s - glfwGetTime()) > 0;) glfwWaitEventsTimeout(wait_s);
  glfwPollEvents();
  next_frame_s = std::max(next_frame_s + frame_interval_s, glfwGetTime());
}

}  // namespace

bool open_display(std::string& reason) {
  if (glfwInit()) return true;
  reason = glfw_error();
  return false;
}

void run_in_window(const Demo& demo, const Options& options) {
  const GlfwSession session;
  GLFWwindow* const window = create_window(demo, options);
  X11Presenter presenter(glfwGetX11Display(), glfwGetX11Window(window));

  Events events{.demo = demo};
  glfwGetFramebufferSize(window, &events.width_px, &events.height_px);
  glfwSetWindowUserPointer(window, &events);
  glfwSetKeyCallback(window, on_key);
  glfwSetCharCallback(window, on_character);
  glfwSetMouseButtonCallback(window, on_mouse_button);
  glfwSetFramebufferSizeCallback(window, on_size);
  glfwSetWindowRefreshCallback(window, on_refresh);

  Canvas canvas(events.width_px, events.height_px);
  demo.init();
  demo.reshape(events.width_px, events.height_px);
  for (const int key : options.keys) press(events, key);
  if (demo.click != nullptr && options.click) demo.click(options.click->x, options.click->y);

  const bool animated = demo.animate != nullptr && !options.time_s;
  if (demo.animate != nullptr && options.time_s) demo.animate(*options.time_s);
  FrameTimeTitle title(window, demo.name);
  const double start_s = glfwGetTime();
  double next_frame_s = start_s;
  while (!glfwWindowShouldClose(window)) {
    wait_for_frame(events, animated, next_frame_s);
    if (!animated && !events.redraw) continue;
    events.redraw = false;
    if (events.width_px != canvas.width_px() || events.height_px != canvas.height_px()) {
      canvas.resize(events.width_px, events.height_px);
      demo.reshape(events.width_px, events.height_px);
    }
    const double begin_s = glfwGetTime();
    if (animated) demo.animate(begin_s - start_s);
    demo.draw();
    canvas.finish();
    if (demo.status != nullptr) {
      glfwSetWindowTitle(window, (std::string(demo.name) + " - " + demo.status()).c_str());
    } else {
      title.add(glfwGetTime() - begin_s);
    }
    presenter.show(canvas.pixels(), canvas.width_px(), canvas.height_px());
  }
}

}  // namespace shell
