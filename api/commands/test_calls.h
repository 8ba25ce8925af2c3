// For tests: calling commands of the registry by name with arguments from tables.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "api/registry/proc_address.h"

#include "gl_commands.h"

namespace gouraud::api {

/// A call without an error in the initial state, or with the error that the initial state gives (PopMatrix). Arguments
/// that are missing, and all pointers, are filled by `filled`.
struct ModelCall {
  const char* commands;  // separated by spaces
  std::vector<double> arguments;
  GLenum error = GL_NO_ERROR;
  void (*prepare)() = nullptr;
};

inline bool names(const char* commands, std::string_view command) {
  const std::string padded = " " + std::string(commands) + " ";
  return padded.find(" " + std::string(command) + " ") != std::string::npos;
}

inline const GlTable& our_gl() {
  static const GlTable table = [] {
    GlTable result;
    load(result, [](const char* name) { return reinterpret_cast<void*>(proc_address(name)); });
    return result;
  }();
  return table;
}

/// Client memory that pointers lead to; zero before every call.
inline std::vector<std::byte>& client_memory() {
  static std::vector<std::byte> memory(1 << 16);
  return memory;
}

/// The arguments of a call: those given; pointers lead to client_memory(); numbers that are missing are 1, enums
/// GL_TEXTURE0 (of MultiTexCoord).
inline std::vector<CommandArgument> filled(const CommandRow& row, const std::vector<double>& given) {
  std::vector<CommandArgument> arguments;
  for (std::size_t i = 0; row.parameters[i] != '\0'; ++i) {
    const char kind = row.parameters[i];
    if (kind == 'p') {
      arguments.emplace_back(static_cast<void*>(client_memory().data()));
      if (i < given.size()) arguments.back().number = given[i];
    } else if (i < given.size()) {
      arguments.emplace_back(given[i]);
    } else {
      arguments.emplace_back(kind == 'e' ? static_cast<double>(GL_TEXTURE0) : 1.0);
    }
  }
  return arguments;
}

/// Puts the numbers given for the pointer of a command of the form Name{ifd}v, and for what follows it, into memory,
/// all else zero.
inline void fill_client_memory(const CommandRow& row, const std::vector<CommandArgument>& arguments) {
  std::fill(client_memory().begin(), client_memory().end(), std::byte{0});
  const std::string_view name = row.name;
  const auto put = [&](auto type) {
    using Type = decltype(type);
    std::byte* memory = client_memory().data();
    for (std::size_t i = std::string_view(row.parameters).find('p'); i < arguments.size();
         ++i, memory += sizeof(Type)) {
      const Type value = arguments[i].as<Type>();
      std::memcpy(memory, &value, sizeof(Type));
    }
  };
  if (name.ends_with("fv")) put(GLfloat{});
  if (name.ends_with("dv")) put(GLdouble{});
  if (name.ends_with("iv")) put(GLint{});
}

inline void call(const CommandRow& row, const std::vector<CommandArgument>& arguments) {
  fill_client_memory(row, arguments);
  row.call(our_gl(), arguments.data());
}

inline std::string text_of(const CommandRow& row, const std::vector<CommandArgument>& arguments) {
  const std::string_view kinds = row.parameters;  // behind them is what a pointer leads to
  std::string text = row.name;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    text += (i < kinds.size() && kinds[i] == 'p' ? " *" : " ") + std::to_string(arguments[i].number);
  }
  return text;
}

}  // namespace gouraud::api
