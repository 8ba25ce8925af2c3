// Reproducible elementary functions for kernels: included inside a kernel file, once per instruction set.
//
// Takes and gives vectors; polynomials and exact bit arithmetic only, so that every instruction set gives the same bits
// for every input, NaN and infinity included. Coefficients are minimax (Remez) on the reduced range.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_SIMD_MATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_SIMD_MATH_INL_H_
#undef GOURAUD_PIPELINE_SIMD_MATH_INL_H_
#else
#define GOURAUD_PIPELINE_SIMD_MATH_INL_H_
#endif

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// a if a > floor, else floor; NaN gives floor. (The targets' own maxima disagree about NaN.)
template <class D, class V = hn::Vec<D>>
HWY_INLINE V at_least(D, V a, V floor) {
  return hn::IfThenElse(hn::Gt(a, floor), a, floor);
}

/// a if a < ceiling, else ceiling; NaN gives ceiling.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V at_most(D, V a, V ceiling) {
  return hn::IfThenElse(hn::Lt(a, ceiling), a, ceiling);
}

/// Clamp to [0, 1]; NaN gives 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V clamp_to_unit(D d, V v) {
  return hn::IfThenElseZero(hn::Gt(v, hn::Zero(d)), hn::Min(v, hn::Set(d, static_cast<hn::TFromD<D>>(1))));
}

/// The layout of a floating-point type, and the polynomials that suit its precision.
template <class T>
struct ElementaryTraits;

template <>
struct ElementaryTraits<float> {
  static constexpr int mantissa_bits = 23;
  static constexpr std::uint32_t one_bits = 0x3F800000, sqrt_half_bits = 0x3F3504F3;
  static constexpr std::uint32_t integer_bits = 0x4B000000;  ///< of 2^23: its low bits hold an integer
  static constexpr float integer_base = 0x1p23f, rounding_magic = 0x1.8p23f, smallest_normal = 0x1p-126f;
  static constexpr float exp2_lowest = -126.0f, exp2_highest = 127.0f;
  /// log2(1 + t) / t for t in [sqrt(1/2) - 1, sqrt(2) - 1]; |t P(t) - log2(1 + t)| <= 8e-9.
  static constexpr float log2_polynomial[] = {1.4426948955708856f,   -0.72134713711451963f, 0.48092065298469268f,
                                              -0.36072015380236760f, 0.28769387086434898f,  -0.23855062857359674f,
                                              0.21713327934798122f,  -0.21006042599106294f, 0.12569628233764014f};
  /// (2^f - 1) / f for f in [-1/2, 1/2]; 2^f within 4e-9.
  static constexpr float exp2_polynomial[] = {0.69314718802622877f,   0.24022650760568126f,   0.055503571142190782f,
                                              0.0096180825572778524f, 0.0013390863364671234f, 0.00015453162945120691f};
};

template <>
struct ElementaryTraits<double> {
  static constexpr int mantissa_bits = 52;
  static constexpr std::uint64_t one_bits = 0x3FF0000000000000, sqrt_half_bits = 0x3FE6A09E667F3BCD;
  static constexpr std::uint64_t integer_bits = 0x4330000000000000;
  static constexpr double integer_base = 0x1p52, rounding_magic = 0x1.8p52, smallest_normal = 0x1p-1022;
  static constexpr double exp2_lowest = -1000.0, exp2_highest = 400.0;
  /// As above; |t P(t) - log2(1 + t)| <= 1.9e-10.
  static constexpr double log2_polynomial[] = {
      1.4426950450081091684,  -0.72134751052347130895, 0.48089740651950828336, -0.36067425125058978302,
      0.28859510825307052779, -0.24047886854777499558, 0.20476742793475905071, -0.17857038639535546182,
      0.17340918602261190613, -0.17136289389092660197, 0.097095622127935123977};
  /// As above; 2^f within 5e-11.
  static constexpr double exp2_polynomial[] = {
      0.69314718069952831765,   0.24022651061015811318,   0.055504103733794256107,   0.0096180387885104085205,
      0.0013333932471252491997, 0.0001546657729914244313, 0.000015196294020489082491};
};

/// c[0] + c[1] x + ... by Horner's rule.
template <class D, std::size_t terms, class V = hn::Vec<D>>
HWY_INLINE V polynomial(D d, const hn::TFromD<D> (&c)[terms], V x) {
  V sum = hn::Set(d, c[terms - 1]);
  for (std::size_t k = terms - 1; k-- > 0;) sum = hn::Add(hn::Mul(sum, x), hn::Set(d, c[k]));
  return sum;
}

/// The same of six coefficients, taken in pairs: five steps follow upon each other, not ten. (Fog waits for little else.)
template <class D, class V = hn::Vec<D>>
HWY_INLINE V polynomial(D d, const hn::TFromD<D> (&c)[6], V x) {
  const auto pair = [&](std::size_t k) HWY_ATTR { return hn::Add(hn::Set(d, c[k]), hn::Mul(hn::Set(d, c[k + 1]), x)); };
  const V square = hn::Mul(x, x);
  return hn::Add(pair(0), hn::Mul(square, hn::Add(pair(2), hn::Mul(square, pair(4)))));
}

/// log2 of the lanes of x. What is not a positive normal number (NaN too) counts as the smallest one; infinity gives
/// the first exponent past the largest number's. Exact for powers of two. Error: double 2.5e-10, near x = 1 also 2e-8
/// relative; float the larger of 1.2e-7 and 0.9e-7 relative.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V log2(D d, V x) {
  using Traits = ElementaryTraits<hn::TFromD<D>>;
  const hn::RebindToUnsigned<D> du;
  const auto bits = hn::BitCast(du, at_least(d, x, hn::Set(d, Traits::smallest_normal)));
  // x = 2^e (1 + t), with 1 + t in [sqrt(1/2), sqrt(2)]; `biased` is e + the exponent's bias.
  const auto biased =
      hn::ShiftRight<Traits::mantissa_bits>(hn::Add(bits, hn::Set(du, Traits::one_bits - Traits::sqrt_half_bits)));
  const auto one = hn::Set(du, Traits::one_bits);
  const auto reduced = hn::Sub(hn::Add(bits, one), hn::ShiftLeft<Traits::mantissa_bits>(biased));
  const V t = hn::Sub(hn::BitCast(d, reduced), hn::Set(d, 1));
  // An integer in the low bits of 2^mantissa_bits: converts it without an instruction that only some targets have.
  const V shifted = hn::BitCast(d, hn::Or(biased, hn::Set(du, Traits::integer_bits)));
  constexpr auto bias = static_cast<hn::TFromD<D>>(Traits::one_bits >> Traits::mantissa_bits);
  const V exponent = hn::Sub(shifted, hn::Set(d, Traits::integer_base + bias));
  return hn::Add(exponent, hn::Mul(t, polynomial(d, Traits::log2_polynomial, t)));
}

/// 2 to the power of the lanes of x, as exp2(), which it is for: x lies in [exp2_lowest, exp2_highest].
template <class D, class V = hn::Vec<D>>
HWY_INLINE V exp2_of_range(D d, V x) {
  using Traits = ElementaryTraits<hn::TFromD<D>>;
  const hn::RebindToUnsigned<D> du;
  // x = k + f with integer k and f in [-1/2, 1/2]; k stands in the low bits of the shifted number.
  const V magic = hn::Set(d, Traits::rounding_magic);
  const V shifted = hn::Add(x, magic);
  const V f = hn::Sub(x, hn::Sub(shifted, magic));
  const V power = hn::Add(hn::Mul(f, polynomial(d, Traits::exp2_polynomial, f)), hn::Set(d, 1));
  const auto scale = hn::ShiftLeft<Traits::mantissa_bits>(hn::BitCast(du, shifted));
  return hn::BitCast(d, hn::Add(hn::BitCast(du, power), scale));
}

/// 2^x of the lanes of x, which are first clamped to [-126, 127] (float) or [-1000, 400] (double); NaN counts as the
/// lower bound. Exact for integers. Relative error: double 6e-11; float 1.2e-7.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V exp2(D d, V x) {
  using Traits = ElementaryTraits<hn::TFromD<D>>;
  return exp2_of_range(d, hn::Min(at_least(d, x, hn::Set(d, Traits::exp2_lowest)), hn::Set(d, Traits::exp2_highest)));
}

/// x^y in double for y >= 0; x^0 = 1 for every x, 0^0 as well [GL1.5 §2.1.1]. An x that is not a positive normal number
/// (NaN too) counts as 0. Results are kept between 2^-1000 (or 0) and 2^400; between them the relative error is at most
/// 2e-10 (1 + y).
template <class D, class V = hn::Vec<D>>
HWY_INLINE V pow(D d, V x, V y) {
  static_assert(sizeof(hn::TFromD<D>) == sizeof(double), "the exponent multiplies log2's error: float cannot hold it");
  const V zero = hn::Zero(d);
  const auto positive = hn::Ge(x, hn::Set(d, ElementaryTraits<double>::smallest_normal));
  const V power = exp2(d, hn::Mul(y, log2(d, x)));
  return hn::IfThenElse(hn::Eq(y, zero), hn::Set(d, 1), hn::IfThenElseZero(positive, power));
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
