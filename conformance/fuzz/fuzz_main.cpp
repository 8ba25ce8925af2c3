// fuzz LIBRARY SEED CALLS
//
// Makes random calls through a libOSMesa and writes what each one raises, and every 20 calls which state has changed, on
// stdout: the same text for every library that does the same (fuzz.py compares). Every 400 calls there is a new context.
// It writes "crashed" where a library brought its context down.
#include <cstdlib>
#include <exception>
#include <stdexcept>

#include <sys/resource.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include "conformance/fuzz/random_calls.h"
#include "conformance/harness/offscreen.h"

namespace gouraud::conformance {
namespace {

constexpr int side_px = 64, calls_a_context = 400, calls_between_looks = 20;
constexpr rlim_t longest_s = 10;  // of processor time

void run_context(const OsmesaFunctions& osmesa, std::uint32_t seed) {
  OffscreenContext context(osmesa, side_px, side_px, 24);
  CallLog log(context.gl());
  StateWatch watch(context.gl());
  Random random(seed * 2654435761u + 1);
  for (int i = 0; i < calls_a_context; ++i) {
    if (i % calls_between_looks == 0) watch.print_changes();
    random_call(log, random);
    std::fflush(stdout);
  }
}

/// Each context in a process of its own: Mesa does not survive all that is asked of it.
void run(const OsmesaFunctions& osmesa, std::uint32_t seed, int calls) {
  for (int done = 0; done < calls; done += calls_a_context, ++seed) {
    std::printf("context of seed %u\n", seed);
    std::fflush(stdout);
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("fork failed");
    if (child == 0) {
      const rlimit longest{longest_s, longest_s};
      ::setrlimit(RLIMIT_CPU, &longest);
      run_context(osmesa, seed);
      std::_Exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    if (status != 0) std::printf("\ncrashed\n");
  }
}

}  // namespace
}  // namespace gouraud::conformance

int main(int argc, char** argv) {
  using namespace gouraud::conformance;
  try {
    if (argc != 4) throw std::runtime_error("usage: fuzz LIBRARY SEED CALLS");
    run(load_osmesa(argv[1]), static_cast<std::uint32_t>(std::atoi(argv[2])), std::atoi(argv[3]));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fuzz: %s\n", error.what());
    return 2;
  }
}
