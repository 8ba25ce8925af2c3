// speed_driver LIBRARY RENDERER               draws what it is asked for over file descriptor 4, answers over 3
// speed_driver --first-frame LIBRARY RENDERER draws one frame as soon as it can, and writes when that was
//
// RENDERER is a word that GL_RENDERER must contain.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "conformance/harness/channel.h"
#include "conformance/harness/child_process.h"
#include "conformance/harness/offscreen.h"
#include "conformance/speed/measure.h"
#include "conformance/speed/workloads.h"

namespace gouraud::speed {
namespace {

using conformance::child_input_fd;
using conformance::child_output_fd;
using conformance::ChannelClosed;
using conformance::load_osmesa;
using conformance::OffscreenContext;
using conformance::OsmesaFunctions;
using conformance::Reader;
using conformance::Writer;

constexpr int first_frame_width_px = 640, first_frame_height_px = 480, depth_bits = 24;
constexpr int patience_s = 3600;  // for the parent, who may be busy with another driver

void check_renderer(const GlTable& gl, const std::string& expected) {
  const std::string renderer = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
  if (renderer.find(expected) == std::string::npos) {
    throw std::runtime_error("GL_RENDERER is \"" + renderer + "\", not \"" + expected + "\"");
  }
}

void draw_in_fresh_context(const OsmesaFunctions& osmesa) {
  OffscreenContext context(osmesa, first_frame_width_px, first_frame_height_px, depth_bits);
  draw_first_frame(context.gl());
  context.gl().Finish();
}

/// Writes the samples at the start of main and when the first frame was finished.
int first_frame(const std::string& library, const std::string& renderer) {
  const Sample start = now();
  const OsmesaFunctions osmesa = load_osmesa(library);
  OffscreenContext context(osmesa, first_frame_width_px, first_frame_height_px, depth_bits);
  draw_first_frame(context.gl());
  context.gl().Finish();
  const Sample end = now();
  check_renderer(context.gl(), renderer);
  Writer out(child_output_fd);
  out.value(start);
  out.value(end);
  return 0;
}

const Workload& workload_of_name(const std::string& name) {
  const auto found = std::ranges::find(all_workloads(), name, &Workload::name);
  if (found == all_workloads().end()) throw std::runtime_error("no workload is called " + name);
  return *found;
}

class Server {
 public:
  Server(const std::string& library, const std::string& renderer) : osmesa_(load_osmesa(library)) {
    check_renderer(OffscreenContext(osmesa_, 8, 8, depth_bits).gl(), renderer);
  }

  /// Until the parent closes its end.
  int serve() {
    try {
      while (true) answer(in_.value<Request>());
    } catch (const ChannelClosed&) {
      return 0;
    }
  }

 private:
  void answer(Request request) {
    switch (request) {
      case Request::begin: begin(workload_of_name(in_.text())); break;
      case Request::frame: out_.value(timed([this] { draw_frame(); })); break;
      case Request::context:
        context_.reset();
        out_.value(timed([this] { draw_in_fresh_context(osmesa_); }));
        break;
    }
  }

  template <class Work>
  static Sample timed(Work work) {
    const Sample start = now();
    work();
    return now() - start;
  }

  void begin(const Workload& workload) {
    context_.reset();
    context_.emplace(osmesa_, workload.width_px, workload.height_px, depth_bits);
    frame_ = workload.setup(context_->gl());
    draw_frame();
    const GLenum error = context_->gl().GetError();
    if (error != GL_NO_ERROR) throw std::runtime_error(std::string(workload.name) + " raises a GL error");
    out_.value(true);
  }

  void draw_frame() {
    frame_(context_->gl());
    context_->gl().Finish();
  }

  OsmesaFunctions osmesa_;
  std::optional<OffscreenContext> context_;
  Frame frame_;
  Reader in_{child_input_fd, patience_s};
  Writer out_{child_output_fd};
};

int run(const std::vector<std::string>& arguments) {
  if (arguments.size() == 3 && arguments[0] == "--first-frame") return first_frame(arguments[1], arguments[2]);
  if (arguments.size() == 2) return Server(arguments[0], arguments[1]).serve();
  throw std::runtime_error("usage: speed_driver [--first-frame] LIBRARY RENDERER");
}

}  // namespace
}  // namespace gouraud::speed

int main(int argc, char** argv) {
  try {
    return gouraud::speed::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "speed_driver: %s\n", error.what());
    return 2;
  }
}
