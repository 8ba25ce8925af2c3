// Adds one light to a block of vertices [GL1.5 §2.14.1]: included inside a kernel file, once per instruction set.
//
// All in double: the specular exponent multiplies the error of n . h by up to 128. What a light has and what a material
// reflects is settled per run of vertices, by the choice among 27 kernels; no kernel looks at state.
#include <hwy/highway.h>

#include "pipeline/geometry/light_terms.h"

#if defined(GOURAUD_PIPELINE_GEOMETRY_LIGHT_KERNELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_GEOMETRY_LIGHT_KERNELS_INL_H_
#undef GOURAUD_PIPELINE_GEOMETRY_LIGHT_KERNELS_INL_H_
#else
#define GOURAUD_PIPELINE_GEOMETRY_LIGHT_KERNELS_INL_H_
#endif

#include "pipeline/simd/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using LightTag = hn::CappedTag<double, 8>;
using LightVector = hn::Vec<LightTag>;

/// Keep results finite where a vertex sits in the light or all attenuation constants are 0: black light stays black.
inline constexpr double least_distance = 1e-100, most_light = 1e100, most_power = 0x1p400;

struct Vector3 {
  LightVector x, y, z;
};

HWY_INLINE LightVector spread(double value) {
  return hn::Set(LightTag(), value);
}
HWY_INLINE Vector3 spread(const Triple& v) {
  return {spread(v[0]), spread(v[1]), spread(v[2])};
}
HWY_INLINE Vector3 load(const LightBlock::Vectors& rows, std::size_t i) {
  const LightTag d;
  return {hn::Load(d, &rows[0][i]), hn::Load(d, &rows[1][i]), hn::Load(d, &rows[2][i])};
}
HWY_INLINE LightVector dot(const Vector3& a, const Vector3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Vector3 add_scaled(const Vector3& a, LightVector s, const Vector3& b) {
  return {hn::Add(a.x, hn::Mul(s, b.x)), hn::Add(a.y, hn::Mul(s, b.y)), hn::Add(a.z, hn::Mul(s, b.z))};
}
HWY_INLINE Vector3 subtract(const Vector3& a, const Vector3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

/// x^exponent for a whole exponent >= 0; x^0 = 1. Kept below most_power, as pow does.
HWY_INLINE LightVector whole_power(LightVector x, int exponent) {
  LightVector result = spread(1);
  while (true) {
    if ((exponent & 1) != 0) result = hn::Mul(result, x);
    exponent >>= 1;
    if (exponent == 0) break;
    x = hn::Mul(x, x);
  }
  return at_most(LightTag(), result, spread(most_power));
}

HWY_INLINE LightVector power(LightVector x, const Exponent& exponent) {
  if (exponent.whole != Exponent::not_whole) return whole_power(x, exponent.whole);
  return pow(LightTag(), x, spread(exponent.value));
}

/// x^exponent from x^2: no square root unless the exponent is odd.
HWY_INLINE LightVector power_of_root(LightVector x_squared, const Exponent& exponent) {
  if (exponent.whole == Exponent::not_whole) return pow(LightTag(), x_squared, spread(exponent.value * 0.5));
  const LightVector even = whole_power(x_squared, exponent.whole >> 1);
  return (exponent.whole & 1) != 0 ? hn::Mul(even, hn::Sqrt(x_squared)) : even;
}

/// The light as one vector of vertices sees it: VP (of length `distance`), and what the light's strength is there.
struct Incidence {
  Vector3 to_light;
  LightVector distance;
  LightVector strength;  ///< attenuation times spot factor [GL1.5 §2.14.1 eqs 2.4 and 2.5]
  LightVector strength_by_distance;
};

template <LightKind kind>
HWY_INLINE Incidence incidence(const LightTerms& light, const LightBlock& block, std::size_t i) {
  const LightTag d;
  const LightVector one = spread(1);
  if constexpr (kind == LightKind::directional) return {spread(light.position), one, one, one};

  Incidence in;
  in.to_light = subtract(spread(light.position), load(block.position, i));
  in.distance = at_least(d, hn::Sqrt(dot(in.to_light, in.to_light)), spread(least_distance));
  const auto& [k0, k1, k2] = light.attenuation;
  const LightVector weakening =
      hn::Add(spread(k0), hn::Mul(in.distance, hn::Add(spread(k1), hn::Mul(in.distance, spread(k2)))));
  in.strength_by_distance = at_most(d, hn::Div(one, hn::Mul(in.distance, weakening)), spread(most_light));
  in.strength = hn::Mul(in.strength_by_distance, in.distance);
  if constexpr (kind == LightKind::spot) {
    const LightVector along = dot(in.to_light, spread(light.spot_direction));
    const LightVector cosine = hn::Neg(hn::Div(along, in.distance));
    // The cutoff is at most 90 degrees. deviation: the section compares max(cosine, 0), so that a cutoff of just 90
    // degrees with exponent 0 would light what is behind the light as well.
    const auto in_cone = hn::Ge(cosine, spread(light.spot_cutoff_cosine));
    const LightVector factor = hn::IfThenElseZero(in_cone, power(cosine, light.spot_exponent));
    in.strength = hn::Mul(in.strength, factor);
    in.strength_by_distance = hn::Mul(in.strength_by_distance, factor);
  }
  return in;
}

/// max(n . h, 0)^shininess [GL1.5 §2.14.1 eq 2.3]. `back` lanes use -n and the back material's shininess.
template <LightKind kind, Highlight highlight, bool two_sided>
HWY_INLINE LightVector specular_factor(const LightTerms& light, const LightBlock& block, std::size_t i,
                                       const Vector3& normal, const Incidence& in, hn::Mask<LightTag> back) {
  const auto positive_part = [&](LightVector n_dot_h, LightVector value) HWY_ATTR {
    if constexpr (two_sided) n_dot_h = hn::IfThenElse(back, hn::Neg(n_dot_h), n_dot_h);
    return hn::IfThenElseZero(hn::Gt(n_dot_h, hn::Zero(LightTag())), value);
  };
  const auto raise = [&](auto power_function, LightVector x) HWY_ATTR {
    LightVector result = power_function(x, light.shininess);
    if constexpr (two_sided) {
      if (light.shininess.value != light.shininess_back.value) {
        result = hn::IfThenElse(back, power_function(x, light.shininess_back), result);
      }
    }
    return result;
  };
  if constexpr (kind == LightKind::directional && highlight == Highlight::distant_viewer) {
    const LightVector n_dot_h = dot(normal, spread(light.half_vector));
    const LightVector cosine = positive_part(n_dot_h, two_sided ? hn::Abs(n_dot_h) : n_dot_h);
    return raise([](LightVector x, const Exponent& e) HWY_ATTR { return power(x, e); }, cosine);
  } else {
    Vector3 half = in.to_light;
    if constexpr (highlight == Highlight::local_viewer) {
      half = add_scaled(half, in.distance, load(block.to_viewer, i));
    } else {
      half.z = hn::Add(half.z, in.distance);
    }
    const LightVector n_dot_h = dot(normal, half);
    const LightVector squared = positive_part(n_dot_h, hn::Div(hn::Mul(n_dot_h, n_dot_h), dot(half, half)));
    return raise([](LightVector x, const Exponent& e) HWY_ATTR { return power_of_root(x, e); }, squared);
  }
}

/// sum += factor * color
HWY_INLINE void accumulate(LightBlock::Vectors& sum, std::size_t i, LightVector factor, const Triple& color) {
  const LightTag d;
  for (std::size_t k = 0; k < 3; ++k) {
    hn::Store(hn::Add(hn::Load(d, &sum[k][i]), hn::Mul(factor, spread(color[k]))), d, &sum[k][i]);
  }
}

/// What one light gives to the vertices: factors of its colours. `back` only if two-sided.
struct Factors {
  LightVector ambient, diffuse, highlight, diffuse_back, highlight_back;
};

template <LightKind kind, Highlight highlight, Sums sums>
HWY_INLINE void accumulate(const LightTerms& light, const Factors& f, LightBlock& block, std::size_t i) {
  const LightTag d;
  constexpr bool has_ambient = kind != LightKind::directional, has_highlight = highlight != Highlight::none;
  if constexpr (sums == Sums::fused) {
    for (std::size_t k = 0; k < 3; ++k) {
      LightVector color = hn::Mul(f.diffuse, spread(light.diffuse[k]));
      if constexpr (has_ambient) color = hn::Add(color, hn::Mul(f.ambient, spread(light.ambient[k])));
      if constexpr (has_highlight) color = hn::Add(color, hn::Mul(f.highlight, spread(light.specular[k])));
      hn::Store(hn::Add(hn::Load(d, &block.ambient[k][i]), color), d, &block.ambient[k][i]);
    }
  } else {
    if constexpr (has_ambient) accumulate(block.ambient, i, f.ambient, light.ambient);
    accumulate(block.diffuse[0], i, f.diffuse, light.diffuse);
    if constexpr (has_highlight) accumulate(block.specular[0], i, f.highlight, light.specular);
    if constexpr (sums == Sums::two_sided) {
      accumulate(block.diffuse[1], i, f.diffuse_back, light.diffuse);
      if constexpr (has_highlight) accumulate(block.specular[1], i, f.highlight_back, light.specular);
    }
  }
}

template <LightKind kind, Highlight highlight, Sums sums>
void add_light(const LightTerms& light, std::size_t count, LightBlock& block) {
  const LightTag d;
  constexpr bool two_sided = sums == Sums::two_sided;
  const LightVector zero = hn::Zero(d);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const Vector3 normal = load(block.normal, i);
    const Incidence in = incidence<kind>(light, block, i);
    const LightVector n_dot_vp = dot(normal, in.to_light);
    const LightVector diffuse = hn::Mul(in.strength_by_distance, n_dot_vp);
    const auto front = hn::Gt(n_dot_vp, zero), back = hn::Lt(n_dot_vp, zero);
    Factors f{in.strength, hn::IfThenElseZero(front, diffuse), zero, zero, zero};
    if constexpr (two_sided) f.diffuse_back = hn::IfThenElseZero(back, hn::Neg(diffuse));
    if constexpr (highlight != Highlight::none) {
      const LightVector shine = specular_factor<kind, highlight, two_sided>(light, block, i, normal, in, back);
      const LightVector bright = hn::Mul(in.strength, shine);
      f.highlight = hn::IfThenElseZero(front, bright);
      if constexpr (two_sided) f.highlight_back = hn::IfThenElseZero(back, bright);
    }
    accumulate<kind, highlight, sums>(light, f, block, i);
  }
}

using LightKernel = void (*)(const LightTerms& light, std::size_t count, LightBlock& block);

template <LightKind kind, Highlight highlight>
LightKernel kernel_for(Sums sums) {
  switch (sums) {
    case Sums::fused:
      return add_light<kind, highlight, Sums::fused>;
    case Sums::split:
      return add_light<kind, highlight, Sums::split>;
    case Sums::two_sided:
      break;
  }
  return add_light<kind, highlight, Sums::two_sided>;
}
template <LightKind kind>
LightKernel kernel_for(Highlight highlight, Sums sums) {
  switch (highlight) {
    case Highlight::none:
      return kernel_for<kind, Highlight::none>(sums);
    case Highlight::distant_viewer:
      return kernel_for<kind, Highlight::distant_viewer>(sums);
    case Highlight::local_viewer:
      break;
  }
  return kernel_for<kind, Highlight::local_viewer>(sums);
}
inline LightKernel kernel_for(const LightTerms& light, Sums sums) {
  switch (light.kind) {
    case LightKind::directional:
      return kernel_for<LightKind::directional>(light.highlight, sums);
    case LightKind::positional:
      return kernel_for<LightKind::positional>(light.highlight, sums);
    case LightKind::spot:
      break;
  }
  return kernel_for<LightKind::spot>(light.highlight, sums);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
