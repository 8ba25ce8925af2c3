// Who is charted: the default, every method, llvmpipe and softpipe, each in a process of its own on one core, and how
// they are asked for pictures and frames.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/harness/channel.h"
#include "conformance/harness/child_process.h"
#include "conformance/harness/drivers.h"
#include "conformance/speed/measure.h"

namespace gouraud::probes {

enum class Owner : std::uint8_t { ours_default, ours_method, llvmpipe, softpipe };

struct Contestant {
  std::string name;     ///< "default", "coverage=scanline", "llvmpipe"
  std::string step;     ///< what the method does otherwise: "coverage"; empty for the default and the drivers
  Owner owner;
  conformance::Command command;
  bool antialiases = false;  ///< judged by area coverage only
};

/// What the parent asks of probe_driver.
enum class Request : std::uint8_t {
  picture,  ///< + text, knob, whether coverage is wanted: answers (true, picture, numbers) or (false, text)
  begin,    ///< + text, knob: makes a context and draws a frame; answers true
  frames,   ///< + int: draws and finishes so many; answers with the Sample of all of them
};

struct Answer {
  std::optional<conformance::Picture> picture;
  std::vector<double> numbers;
  std::string failure;  ///< why there is no picture; a process that ended says how
};

/// A contestant's process; started when it is first needed, and anew after it ended.
class ProbeDriver {
 public:
  explicit ProbeDriver(const Contestant& contestant) : contestant_(contestant) {}

  Answer picture(std::string_view probe, double knob, bool coverage);
  /// Makes ready for frames(); false, with failure(), if the contestant cannot.
  bool begin(std::string_view probe, double knob);
  /// Seconds of processor time of one of `count` frames.
  double frames(int count);
  const std::string& failure() const { return failure_; }
  void stop() { process_.reset(); }

 private:
  void ensure_started();
  template <class Ask>
  bool guarded(Ask ask);

  Contestant contestant_;
  std::unique_ptr<conformance::ChildProcess> process_;
  std::string failure_;
};

/// The drivers of `paths` and our methods that match; every one on one core, all as they ship.
std::vector<Contestant> all_contestants(const conformance::Paths& paths);

}  // namespace gouraud::probes
