#include "pipeline/simd/dispatch.h"

#include <array>
#include <atomic>
#include <cstdlib>

namespace gouraud::pipeline::simd {
namespace {

constexpr std::array<std::string_view, 4> names{"baseline", "sse4", "avx2", "avx512"};
constexpr int undecided = -1;
std::atomic<int> current{undecided};

Target best_supported() {
  for (Target target : {Target::avx512, Target::avx2, Target::sse4}) {
    if (target_supported(target)) return target;
  }
  return Target::baseline;
}

Target from_environment() {
  const char* wanted = std::getenv("GOURAUD_SIMD");
  if (wanted == nullptr) return best_supported();
  for (size_t i = 0; i < names.size(); ++i) {
    const auto target = static_cast<Target>(i);
    if (names[i] == wanted && target_supported(target)) return target;
  }
  return best_supported();
}

}  // namespace

bool target_supported([[maybe_unused]] Target target) {
  if (target == Target::baseline) return true;
#if defined(__x86_64__) || defined(__i386__)
  // What Highway's three x86 targets assume of the CPU, but for F16C: clang 14 cannot ask for it, and every CPU with
  // AVX2 has it.
  const bool sse4 = __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul") && __builtin_cpu_supports("aes");
  const bool avx2 = sse4 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                    __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512cd");
  switch (target) {
    case Target::avx512: return avx512 && (HWY_TARGETS & HWY_AVX3) != 0;
    case Target::avx2: return avx2 && (HWY_TARGETS & HWY_AVX2) != 0;
    case Target::sse4: return sse4 && (HWY_TARGETS & HWY_SSE4) != 0;
    case Target::baseline: break;
  }
#endif
  return false;
}

Target chosen_target() {
  int value = current.load(std::memory_order_relaxed);
  if (value == undecided) {
    value = static_cast<int>(from_environment());
    current.store(value, std::memory_order_relaxed);
  }
  return static_cast<Target>(value);
}

void set_target_for_test(std::optional<Target> target) {
  current.store(target ? static_cast<int>(*target) : undecided, std::memory_order_relaxed);
}

std::string_view target_name(Target target) { return names[static_cast<size_t>(target)]; }

}  // namespace gouraud::pipeline::simd
