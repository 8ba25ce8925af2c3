// probe_driver LIBRARY RENDERER    draws the probes it is asked for over file descriptor 4, answers over 3
//
// RENDERER is a word that GL_RENDERER must contain.

#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "conformance/probes/contestants.h"
#include "conformance/probes/probe.h"
#include "conformance/harness/coverage_watch.h"
#include "conformance/harness/offscreen.h"

namespace gouraud::probes {
namespace {

using conformance::CoverageWatch;
using conformance::OffscreenContext;
using conformance::OsmesaFunctions;
using conformance::Picture;

constexpr int patience_s = 3600;  // for the parent, who may be busy with another driver

/// A context of a format that OffscreenContext does not have; what is in it is read by the probe itself.
class DeepContext {
 public:
  DeepContext(const OsmesaFunctions& osmesa, const Probe& probe)
      : osmesa_(osmesa), context_(osmesa.CreateContextExt(probe.format, probe.depth_bits, 0, 0, nullptr)) {
    constexpr std::size_t most_bytes_a_pixel = 16;
    memory_.resize(static_cast<std::size_t>(probe.width_px) * static_cast<std::size_t>(probe.height_px) * most_bytes_a_pixel);
    if (context_ == nullptr ||
        !osmesa_.MakeCurrent(context_, memory_.data(), probe.type, probe.width_px, probe.height_px) ||
        !load(gl_, osmesa_.GetProcAddress)) {
      if (context_ != nullptr) osmesa_.DestroyContext(context_);
      throw std::runtime_error("no context of this format");
    }
  }
  ~DeepContext() {
    osmesa_.MakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    osmesa_.DestroyContext(context_);
  }
  DeepContext(const DeepContext&) = delete;
  DeepContext& operator=(const DeepContext&) = delete;
  const GlTable& gl() const { return gl_; }

 private:
  const OsmesaFunctions& osmesa_;
  void* context_;
  std::vector<std::uint8_t> memory_;
  GlTable gl_;
};

class Server {
 public:
  Server(const std::string& library, const std::string& renderer) : osmesa_(conformance::load_osmesa(library)) {
    const OffscreenContext context(osmesa_, 8, 8, 24);
    const std::string name = reinterpret_cast<const char*>(context.gl().GetString(GL_RENDERER));
    if (name.find(renderer) == std::string::npos) throw std::runtime_error("GL_RENDERER is \"" + name + "\"");
  }

  /// Until the parent closes its end.
  int serve() {
    try {
      while (true) answer(in_.value<Request>());
    } catch (const conformance::ChannelClosed&) {
      return 0;
    }
  }

 private:
  void answer(Request request) {
    switch (request) {
      case Request::picture: answer_picture(); break;
      case Request::begin: begin(); break;
      case Request::frames: out_.value(timed(in_.value<int>())); break;
    }
  }

  void answer_picture() {
    const std::string name = in_.text();
    const auto knob = in_.value<double>();
    const auto coverage = in_.value<bool>();
    context_.reset();
    try {
      const Probe& probe = probe_of_name(name);
      std::vector<double> numbers;
      const Picture picture = draw(probe, knob, coverage, numbers);
      out_.value(true);
      out_.picture(picture);
      out_.array(numbers);
    } catch (const conformance::ChannelClosed&) {
      throw;
    } catch (const std::exception& error) {
      out_.value(false);
      out_.text(error.what());
    }
  }

  Picture draw(const Probe& probe, double knob, bool coverage, std::vector<double>& numbers) {
    const auto draw_frame = [&](const GlTable& gl) {
      const Drawing drawing = probe.setup(gl, knob);
      drawing.frame(gl);
      gl.Finish();
      return drawing;
    };
    if (probe.format != GL_RGBA || probe.type != GL_UNSIGNED_BYTE) {
      DeepContext context(osmesa_, probe);
      numbers = draw_frame(context.gl()).numbers(context.gl());
      return {};
    }
    Picture picture;
    {
      OffscreenContext context(osmesa_, probe.width_px, probe.height_px, probe.depth_bits);
      const Drawing drawing = draw_frame(context.gl());
      picture = context.read();
      if (drawing.numbers) numbers = drawing.numbers(context.gl());
      picture.gl_errors = context.take_errors();
    }
    if (coverage) {
      OffscreenContext context(osmesa_, probe.width_px, probe.height_px, probe.depth_bits);
      CoverageWatch watch(context);
      draw_frame(watch.gl());
      picture.covered = watch.covered(picture);
    }
    return picture;
  }

  void begin() {
    const Probe& probe = probe_of_name(in_.text());
    const auto knob = in_.value<double>();
    context_.reset();
    context_.emplace(osmesa_, probe.width_px, probe.height_px, probe.depth_bits);
    drawing_ = probe.setup(context_->gl(), knob);
    draw_frame();
    out_.value(true);
  }

  /// After a frame that warms the caches up.
  speed::Sample timed(int count) {
    draw_frame();
    const speed::Sample start = speed::now();
    for (int i = 0; i < count; ++i) draw_frame();
    return speed::now() - start;
  }

  void draw_frame() {
    drawing_.frame(context_->gl());
    context_->gl().Finish();
  }

  OsmesaFunctions osmesa_;
  std::optional<OffscreenContext> context_;
  Drawing drawing_;
  conformance::Reader in_{conformance::child_input_fd, patience_s};
  conformance::Writer out_{conformance::child_output_fd};
};

int run(const std::vector<std::string>& arguments) {
  if (arguments.size() != 2) throw std::runtime_error("usage: probe_driver LIBRARY RENDERER");
  return Server(arguments[0], arguments[1]).serve();
}

}  // namespace
}  // namespace gouraud::probes

int main(int argc, char** argv) {
  try {
    return gouraud::probes::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "probe_driver: %s\n", error.what());
    return 2;
  }
}
