// From a GL function's name to the function, for OSMesaGetProcAddress and its like.
#pragma once

#include <cstddef>

namespace gouraud::api {

using Proc = void (*)();

/// The entry point called `name` ("glBegin", "glActiveTextureARB"), or null if the library has none or name is null.
Proc proc_address(const char* name);

struct NamedProc {
  const char* name;
  Proc proc;
};

// Generated, sorted by name.
extern const NamedProc named_procs[];
extern const std::size_t named_proc_count;

}  // namespace gouraud::api
