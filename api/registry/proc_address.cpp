#include "api/registry/proc_address.h"

#include <algorithm>
#include <cstring>

namespace gouraud::api {

Proc proc_address(const char* name) {
  if (name == nullptr) return nullptr;
  const NamedProc* const end = named_procs + named_proc_count;
  const NamedProc* const found = std::lower_bound(named_procs, end, name, [](const NamedProc& row, const char* wanted) {
    return std::strcmp(row.name, wanted) < 0;
  });
  return found != end && std::strcmp(found->name, name) == 0 ? found->proc : nullptr;
}

}  // namespace gouraud::api
