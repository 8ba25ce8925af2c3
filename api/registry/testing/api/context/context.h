// Stands in for the real context, so that the entry points are tested without the state machine.
#pragma once

#include <GL/gl.h>

#include <string>
#include <vector>

namespace gouraud::api {

class Context {
 public:
  bool inside_begin_end() const { return inside; }
  bool intercepting() const { return tracing || open_list; }
  bool tracing_calls() const { return tracing; }
  bool compiling() const { return open_list; }
  const char* programs_command() const { return programs; }
  void set_programs_command(const char* command) { programs = command; }
  void record_error(GLenum code, const char* command, const char* message) {
    error = code;
    error_text = std::string(command) + ": " + message;
  }

  bool inside = false, tracing = false, open_list = false;
  const char* programs = nullptr;
  GLenum error = GL_NO_ERROR;
  std::string error_text;
  std::string called;             // the handler that ran last
  std::vector<double> arguments;  // and what it was given
};

extern constinit thread_local Context* test_context;
inline Context* current_context() {
  return test_context;
}

}  // namespace gouraud::api
