#include "api/registry/enum_names.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace gouraud::api {

const char* name_in_group(GLenum value, EnumGroup group) {
  const EnumName* const end = enum_names + enum_name_count;
  const std::pair wanted(group, value);
  const EnumName* const found = std::lower_bound(enum_names, end, wanted, [](const EnumName& row, const auto& key) {
    return std::pair(row.group, row.value) < key;
  });
  return found != end && std::pair(found->group, found->value) == wanted ? found->name : nullptr;
}

const char* enum_name(GLenum value, EnumGroup group) {
  if (const char* const name = name_in_group(value, group)) return name;
  if (const char* const name = name_in_group(value, EnumGroup::none)) return name;
  thread_local char digits[16];
  std::snprintf(digits, sizeof(digits), "0x%04X", value);
  return digits;
}

}  // namespace gouraud::api
