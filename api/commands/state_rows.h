// Writing a state value's components; for the files that hold the rows of the state table.
#pragma once

#include <glm/glm.hpp>

#include "api/commands/state_table.h"

namespace gouraud::api {

template <class... Numbers>
void set(StateValue& value, Numbers... numbers) {
  value.components = {static_cast<double>(numbers)...};
}

template <glm::length_t length>
void set(StateValue& value, const glm::vec<length, float>& v) {
  for (int i = 0; i < length; ++i) value.components[static_cast<std::size_t>(i)] = v[i];
}

inline void set(StateValue& value, const glm::mat4& m) {
  for (int i = 0; i < 16; ++i) value.components[static_cast<std::size_t>(i)] = m[i / 4][i % 4];
}

}  // namespace gouraud::api
