// One traced call (GOURAUD_TRACE=calls): collects the arguments, and prints the line to stderr when it goes.
#pragma once

#include <GL/gl.h>

#include <charconv>
#include <string>

#include "api/registry/conversions.h"
#include "api/registry/enum_names.h"

namespace gouraud::api {

class CallTrace {
 public:
  explicit CallTrace(const char* command);
  ~CallTrace();
  CallTrace(const CallTrace&) = delete;
  CallTrace& operator=(const CallTrace&) = delete;

  template <class T>
  void add_number(T value) {
    separate();
    append(value);
  }
  /// A value below 256 that the group has no name for is printed as a number: it is a count, not an enum.
  void add_enum(GLenum value, EnumGroup group);
  void add_bits(GLbitfield bits, EnumGroup group);
  void add_boolean(GLboolean value);
  void add_pointer(const void* pointer);

  /// At most 16 of the `count` values that a pointer leads to.
  template <class T>
  void add_values(const T* values, GLsizei count) {
    if (values == nullptr) return add_pointer(values);
    separate();
    line_ += '{';
    for (GLsizei i = 0; i < count && i < most_values; ++i) {
      if (i > 0) line_ += ", ";
      append(values[i]);
    }
    line_ += count > most_values ? ", ...}" : "}";
  }

  /// The value or values of a parameter such as Light's: an enum, a number, or a vector in braces.
  template <class T>
  void add_parameter(ParameterShape shape, const T* values) {
    if (shape.values != 1) return add_values(values, shape.values);
    if (shape.is_enum && values[0] >= T(0) && values[0] < T(65536)) {
      return add_enum(static_cast<GLenum>(values[0]), EnumGroup::none);
    }
    add_number(values[0]);
  }
  /// Of a command that has one value, whatever the parameter takes.
  template <class T>
  void add_scalar(ParameterShape shape, T value) {
    shape.values = 1;
    add_parameter(shape, &value);
  }

 private:
  static constexpr GLsizei most_values = 16;

  template <class T>
  void append(T value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
    line_.append(digits, end);
  }
  void separate();

  std::string line_;
};

}  // namespace gouraud::api
