// How the processor treats floats while the pipeline computes: as IEEE 754 has it, whatever the program has set.
//
// Takes nothing and gives nothing: a scope. A program may round otherwise (fesetround) or flush denormals to zero (code
// built with -ffast-math sets that for the whole process), and the same calls must give the same bytes nevertheless.
// The matrices of the state machine (api/state/matrix.cpp) take it too. Leaves out: conversions of arguments.
#pragma once

#include <cfloat>
#include <cstdint>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

// On 32-bit x86 the compiler must be told: -msse2 -mfpmath=sse.
static_assert(FLT_EVAL_METHOD == 0, "floats are computed as floats and doubles as doubles");

namespace gouraud::pipeline {

/// Rounds to nearest and keeps denormals until it is destroyed; then all is as it was. Costs a read of the control
/// register where nothing is to be done. Threads that are made meanwhile begin so.
class IeeeFloats {
 public:
  IeeeFloats() : before_(read()) {
    if ((before_ & control_bits) != ordinary) write((before_ & ~control_bits) | ordinary);
  }
  ~IeeeFloats() {
    if ((before_ & control_bits) != ordinary) write(before_);
  }
  IeeeFloats(const IeeeFloats&) = delete;
  IeeeFloats& operator=(const IeeeFloats&) = delete;

 private:
#if defined(__SSE2__)
  using Register = unsigned;
  // MXCSR: flush to zero, rounding (2 bits), exceptions masked (6 bits), denormals are zero.
  static constexpr Register control_bits = 0x8000 | 0x6000 | 0x1F80 | 0x0040, ordinary = 0x1F80;
  static Register read() { return _mm_getcsr(); }
  static void write(Register value) { _mm_setcsr(value); }
#elif defined(__aarch64__)
  using Register = std::uint64_t;
  // FPCR: flush to zero (also of half floats), rounding, default NaN, traps.
  static constexpr Register control_bits = 0x7C89F00, ordinary = 0;
  static Register read() {
    Register value;
    __asm__ volatile("mrs %0, fpcr" : "=r"(value));
    return value;
  }
  static void write(Register value) { __asm__ volatile("msr fpcr, %0" : : "r"(value)); }
#else
  using Register = unsigned;
  static constexpr Register control_bits = 0, ordinary = 0;
  static Register read() { return 0; }
  static void write(Register) {}
#endif

  Register before_;
};

}  // namespace gouraud::pipeline
