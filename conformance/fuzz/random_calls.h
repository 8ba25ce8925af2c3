// Random calls of the GL, the same for every library: which commands, with which arguments, and what they answer.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

#include "conformance/scenes/shapes.h"
#include "gl_table.h"

namespace gouraud::conformance {

/// Calls commands and writes a line for each on stdout: name, arguments, and the error that it raised.
class CallLog {
 public:
  explicit CallLog(const GlTable& table) : gl(table) {}

  /// Arguments come in a tuple, so that random ones are drawn in order.
  template <class Result, class... Parameters, class... Arguments>
  Result call(const char* name, Result (*command)(Parameters...), const std::tuple<Arguments...>& arguments) {
    std::printf("%s", name);
    std::apply([](const auto&... argument) { (print(argument), ...); }, arguments);
    const auto run = [&](const auto&... argument) { return command(static_cast<Parameters>(argument)...); };
    if constexpr (std::is_void_v<Result>) {
      std::apply(run, arguments);
      print_error();
    } else {
      const Result result = std::apply(run, arguments);
      std::printf(" =");
      print(result);
      print_error();
      return result;
    }
  }

  const GlTable& gl;
  bool inside_begin_end = false;  ///< errors are asked for behind the End

 private:
  static void print(double value) { std::printf(" %.9g", value); }
  static void print(float value) { std::printf(" %.9g", static_cast<double>(value)); }
  static void print(int value) { std::printf(" %d", value); }
  static void print(GLenum value) { std::printf(" 0x%x", value); }
  static void print(GLboolean value) { std::printf(" %d", value); }
  static void print(GLushort value) { std::printf(" %d", value); }
  static void print(std::int64_t value) { std::printf(" %lld", static_cast<long long>(value)); }
  template <class T>
  static void print(T* pointer) {
    if constexpr (std::is_same_v<std::remove_const_t<T>, float> || std::is_same_v<std::remove_const_t<T>, double> ||
                  std::is_same_v<std::remove_const_t<T>, int>) {
      for (int i = 0; i < 4; ++i) print(pointer[i]);
    } else {
      std::printf(" %s", pointer == nullptr ? "null" : "pointer");
    }
  }
  void print_error() {
    if (inside_begin_end) {
      std::printf("\n");
      return;
    }
    if (const GLenum error = gl.GetError(); error != GL_NO_ERROR) std::printf(" -> error 0x%x", error);
    std::printf("\n");
  }
};

/// Makes one random call, or a few that belong together. Sequences of them leave no Begin open.
void random_call(CallLog& log, Random& random);

/// Writes every state variable that has changed since the last time, a line each; the error of a query as a negative number.
class StateWatch {
 public:
  explicit StateWatch(const GlTable& gl) : gl_(gl) {}
  void print_changes();

 private:
  void read();
  void read_variables();
  void read_lighting();
  void read_textures();
  void read_maps();
  void note(std::uint32_t group, std::uint32_t name, std::span<const double> values);

  const GlTable& gl_;
  struct Entry {
    std::uint32_t group, name;
    std::vector<double> values;
    bool operator==(const Entry&) const = default;
  };
  std::vector<Entry> before_, now_;
};

}  // namespace gouraud::conformance
