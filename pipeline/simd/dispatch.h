// Which instruction set the kernels run on: one function pointer a kernel, chosen once.
//
// A kernel file is compiled once per instruction set by Highway's foreach_target. Debian ships Highway's own
// run-time part only as a shared library, and this library depends on nothing but the C++ runtime, so the choice
// among the compiled variants is made here.
//
// A kernel file looks like this:
//
//   #undef HWY_TARGET_INCLUDE
//   #define HWY_TARGET_INCLUDE "pipeline/fragment/depth.cpp"   // itself
//   #include <hwy/foreach_target.h>
//   #include <hwy/highway.h>
//   HWY_BEFORE_NAMESPACE();
//   namespace gouraud::pipeline::HWY_NAMESPACE { void kernel(...) {...} }
//   HWY_AFTER_NAMESPACE();
//   #if HWY_ONCE
//   namespace gouraud::pipeline { auto* best_kernel() { return GOURAUD_SIMD_PICK(kernel); } }
//   #endif
//
// Kernels use no fused multiply-add (Highway's MulAdd is fused on some targets only), no reciprocal or square root
// estimates, and no operation whose result depends on the number of lanes: every target gives the same bits.
#pragma once

#include <optional>
#include <string_view>

#include <hwy/detect_targets.h>

namespace gouraud::pipeline::simd {

/// Instruction sets in ascending order. `baseline` is what the compiler may always assume (on x86-64 one lane at a time:
/// Highway 1.0 has no SSE2 target; on Arm NEON).
enum class Target { baseline, sse4, avx2, avx512 };

/// The instruction set in use: the best that this CPU has, or the one that the environment variable GOURAUD_SIMD
/// names (baseline, sse4, avx2, avx512) if the CPU has it. Chosen at the first call.
Target chosen_target();

/// True if this CPU and this build can run `target`.
bool target_supported(Target target);

/// Makes later calls of chosen_target() return `target` (which must be supported), or the default again if empty.
/// Affects plans made afterwards; not to be called while another thread draws.
void set_target_for_test(std::optional<Target> target);

std::string_view target_name(Target target);

template <class Function>
Function pick(Function baseline, Function sse4, Function avx2, Function avx512) {
  switch (chosen_target()) {
    case Target::avx512: return avx512;
    case Target::avx2: return avx2;
    case Target::sse4: return sse4;
    case Target::baseline: break;
  }
  return baseline;
}

}  // namespace gouraud::pipeline::simd

#if HWY_TARGETS & HWY_SSE4
#define GOURAUD_SIMD_SSE4(kernel) &N_SSE4::kernel
#else
#define GOURAUD_SIMD_SSE4(kernel) &HWY_STATIC_DISPATCH(kernel)
#endif
#if HWY_TARGETS & HWY_AVX2
#define GOURAUD_SIMD_AVX2(kernel) &N_AVX2::kernel
#else
#define GOURAUD_SIMD_AVX2(kernel) &HWY_STATIC_DISPATCH(kernel)
#endif
#if HWY_TARGETS & HWY_AVX3
#define GOURAUD_SIMD_AVX512(kernel) &N_AVX3::kernel
#else
#define GOURAUD_SIMD_AVX512(kernel) &HWY_STATIC_DISPATCH(kernel)
#endif
/// The variant of `kernel` for the chosen instruction set; used after foreach_target, under HWY_ONCE.
#define GOURAUD_SIMD_PICK(kernel)                                                                               \
  ::gouraud::pipeline::simd::pick(&HWY_STATIC_DISPATCH(kernel), GOURAUD_SIMD_SSE4(kernel), GOURAUD_SIMD_AVX2(kernel), \
                                  GOURAUD_SIMD_AVX512(kernel))
