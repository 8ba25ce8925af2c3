#include "api/registry/call_trace.h"

#include <cstdint>
#include <cstdio>

namespace gouraud::api {

CallTrace::CallTrace(const char* command) : line_(command) {
  line_ += '(';
}

CallTrace::~CallTrace() {
  line_ += ")\n";
  std::fputs(line_.c_str(), stderr);
}

void CallTrace::add_enum(GLenum value, EnumGroup group) {
  const bool is_number = value < 256 && name_in_group(value, group) == nullptr;
  if (is_number) return add_number(value);
  separate();
  line_ += enum_name(value, group);
}

void CallTrace::add_bits(GLbitfield bits, EnumGroup group) {
  separate();
  if (bits == 0) line_ += '0';
  if (const char* const all = name_in_group(bits, group)) {
    line_ += all;
    return;
  }
  const char* separator = "";
  for (GLbitfield rest = bits; rest != 0; rest &= rest - 1) {
    line_ += separator;
    line_ += enum_name(rest & (~rest + 1), group);
    separator = " | ";
  }
}

void CallTrace::add_boolean(GLboolean value) {
  separate();
  line_ += value ? "GL_TRUE" : "GL_FALSE";
}

void CallTrace::add_pointer(const void* pointer) {
  separate();
  if (pointer == nullptr) {
    line_ += "NULL";
    return;
  }
  char digits[32];
  std::snprintf(digits, sizeof(digits), "0x%llx",
                static_cast<unsigned long long>(reinterpret_cast<std::uintptr_t>(pointer)));
  line_ += digits;
}

void CallTrace::separate() {
  if (line_.back() != '(') line_ += ", ";
}

}  // namespace gouraud::api
