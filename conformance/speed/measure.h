// How times are taken and how the two programs of this folder speak: the driver draws what it is told to and answers
// with a Sample (harness/channel.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gouraud::speed {

/// Seconds of processor time of all threads of this process, and of the clock on the wall.
struct Sample {
  double cpu_s = 0.0, wall_s = 0.0;
};

/// Now, on clocks whose zero does not matter; the wall clock is the same in all processes.
Sample now();

inline Sample operator-(const Sample& end, const Sample& start) {
  return {end.cpu_s - start.cpu_s, end.wall_s - start.wall_s};
}

/// Of each clock by itself. At least one sample.
Sample median(const std::vector<Sample>& samples);

/// What speed asks of speed_driver.
enum class Request : std::uint8_t {
  begin,    ///< + text: the workload; answers once its data is made and its first frame finished
  frame,    ///< draws and finishes a frame; answers with its Sample
  context,  ///< makes a context, draws the first frame, finishes, destroys it; answers with the Sample of all that
};

}  // namespace gouraud::speed
