#include "api/registry/entry.h"

#include <cstdio>

namespace gouraud::api {

void reject_inside_begin_end(Context& context, const char* command) {
  context.record_error(GL_INVALID_OPERATION, command, "not allowed between glBegin and glEnd");
}

void reject_unimplemented(Context& context, const char* command, std::atomic_flag& said) {
  if (!said.test_and_set()) std::fprintf(stderr, "gouraud: %s is not implemented\n", command);
  context.record_error(GL_INVALID_OPERATION, command, "not implemented");
}

void reject_parameter(Context& context, const char* command) {
  context.record_error(GL_INVALID_ENUM, command, "pname is unknown or takes a vector");
}

void report_out_of_memory(Context& context, const char* command) {
  context.record_error(GL_OUT_OF_MEMORY, command, "no memory");
}

}  // namespace gouraud::api
