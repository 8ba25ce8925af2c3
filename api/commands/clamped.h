// Parameters of type clampf and clampd [GL1.5 §2.3, Table 2.2].
#pragma once

#include <glm/glm.hpp>

namespace gouraud::api {

/// `value` clamped to [0, 1]; NaN gives 0.
template <class T>
constexpr T clamped(T value) {
  return value >= T(1) ? T(1) : value > T(0) ? value : T(0);
}

inline glm::vec4 clamped(const glm::vec4& v) {
  return glm::vec4(clamped(v.x), clamped(v.y), clamped(v.z), clamped(v.w));
}

}  // namespace gouraud::api
