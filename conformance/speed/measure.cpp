#include "conformance/speed/measure.h"

#include <algorithm>
#include <cstddef>

#include <time.h>

namespace gouraud::speed {
namespace {

double seconds(clockid_t clock) {
  timespec time{};
  ::clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double middle(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 != 0 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace

Sample now() { return {seconds(CLOCK_PROCESS_CPUTIME_ID), seconds(CLOCK_MONOTONIC)}; }

Sample median(const std::vector<Sample>& samples) {
  std::vector<double> cpu, wall;
  for (const Sample& sample : samples) {
    cpu.push_back(sample.cpu_s);
    wall.push_back(sample.wall_s);
  }
  return {middle(cpu), middle(wall)};
}

}  // namespace gouraud::speed
