#include "conformance/probes/contestants.h"

#include <stdexcept>

#include "conformance/probes/methods.h"

namespace gouraud::probes {
namespace {

using conformance::ChildProcess;
using conformance::Command;
using conformance::Paths;
using conformance::Reader;
using conformance::Writer;

constexpr int answer_limit_s = 90;

Command driver_command(const Paths& paths, const std::string& library, const std::string& renderer) {
  Command command{paths.programs + "/probe_driver", {library, renderer}, {}, {}, true};
  command.dropped_environment = {"GALLIUM_", "GALLIVM_", "LP_", "MESA_", "GOURAUD_", "LD_LIBRARY_PATH", "LD_PRELOAD"};
  // Mesa's own leaks and races are not what our sanitizer builds look for.
  command.environment = {{"ASAN_OPTIONS", "detect_leaks=0"}, {"TSAN_OPTIONS", "report_bugs=0"}};
  return command;
}

Contestant ours(const Paths& paths, const Method& method) {
  const bool is_default = method.setting.empty();
  Contestant contestant{is_default ? "default" : method.setting, method.step,
                        is_default ? Owner::ours_default : Owner::ours_method,
                        driver_command(paths, paths.our_library, "Gouraud"), method.antialiases};
  contestant.command.environment.emplace_back("GOURAUD_THREADS", "1");
  if (!is_default) contestant.command.environment.emplace_back("GOURAUD_METHODS", method.setting);
  return contestant;
}

Contestant mesa(const Paths& paths, const std::string& name, Owner owner) {
  Contestant contestant{name, "", owner, driver_command(paths, paths.mesa_library, name), false};
  contestant.command.environment.emplace_back("GALLIUM_DRIVER", name);
  contestant.command.environment.emplace_back("LP_NUM_THREADS", "0");
  return contestant;
}

}  // namespace

void ProbeDriver::ensure_started() {
  if (!process_) process_ = std::make_unique<ChildProcess>(contestant_.command);
}

/// Runs `ask`; a process that ends or hangs is a failure that is told, and the next question starts another.
template <class Ask>
bool ProbeDriver::guarded(Ask ask) {
  try {
    ensure_started();
    ask();
    return true;
  } catch (const conformance::ChannelClosed&) {
    failure_ = "the process ended: " + process_->wait();
  } catch (const conformance::ChannelTimeout& timeout) {
    failure_ = timeout.what();
  }
  process_.reset();
  return false;
}

Answer ProbeDriver::picture(std::string_view probe, double knob, bool coverage) {
  Answer answer;
  const bool alive = guarded([&] {
    Writer out(process_->write_fd());
    Reader in(process_->read_fd(), answer_limit_s);
    out.value(Request::picture);
    out.text(probe);
    out.value(knob);
    out.value(coverage);
    if (in.value<bool>()) {
      answer.picture = in.picture();
      answer.numbers = in.array<double>();
    } else {
      answer.failure = in.text();
    }
  });
  if (!alive) answer.failure = failure_;
  return answer;
}

bool ProbeDriver::begin(std::string_view probe, double knob) {
  return guarded([&] {
    Writer out(process_->write_fd());
    out.value(Request::begin);
    out.text(probe);
    out.value(knob);
    Reader(process_->read_fd(), answer_limit_s).value<bool>();
  });
}

double ProbeDriver::frames(int count) {
  speed::Sample sample;
  const bool alive = guarded([&] {
    Writer out(process_->write_fd());
    out.value(Request::frames);
    out.value(count);
    sample = Reader(process_->read_fd(), answer_limit_s).value<speed::Sample>();
  });
  if (!alive) throw std::runtime_error(contestant_.name + ": " + failure_);
  return sample.cpu_s / count;
}

std::vector<Contestant> all_contestants(const Paths& paths) {
  std::vector<Contestant> contestants;
  for (const Method& method : all_methods(paths.our_library)) {
    // Only says who decides: affine or the default, as glHint has it.
    if (method.setting != "colors=hint") contestants.push_back(ours(paths, method));
  }
  contestants.push_back(mesa(paths, "llvmpipe", Owner::llvmpipe));
  contestants.push_back(mesa(paths, "softpipe", Owner::softpipe));
  return contestants;
}

}  // namespace gouraud::probes
