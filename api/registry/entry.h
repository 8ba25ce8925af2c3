// What every generated entry point shares. An entry is: load the thread's context, one branch, the inlined command; the
// rare cases (no context, a call to be traced or compiled into a display list) leave by that branch.
#pragma once

#include <GL/gl.h>

#include <atomic>

#include "api/context/context.h"

#define GOURAUD_EXPORT __attribute__((visibility("default")))

namespace gouraud::api {

/// The current context if commands go straight to it; null if there is none, or if the call must be looked at first.
inline Context* direct_context() {
  Context* const context = current_context();
  return context != nullptr && !context->intercepting() ? context : nullptr;
}

/// While it lives, messages name `command`, unless another call is under way: commands that are made of others (a draw
/// from arrays that goes into a display list) call these.
class ProgramsCall {
 public:
  ProgramsCall(Context& context, const char* command)
      : context_(context), outermost_(context.programs_command() == nullptr) {
    if (outermost_) context_.set_programs_command(command);
  }
  ~ProgramsCall() {
    if (outermost_) context_.set_programs_command(nullptr);
  }
  ProgramsCall(const ProgramsCall&) = delete;
  ProgramsCall& operator=(const ProgramsCall&) = delete;
  /// True if the call is to be printed.
  bool traced() const { return outermost_ && context_.tracing_calls(); }

 private:
  Context& context_;
  bool outermost_;
};

/// GL_INVALID_OPERATION: `command` was called between glBegin and glEnd [GL1.5 §2.6.3].
void reject_inside_begin_end(Context& context, const char* command);

/// GL_INVALID_OPERATION: nobody has written `command` yet. Says so on stderr, the first time that `said` is passed.
void reject_unimplemented(Context& context, const char* command, std::atomic_flag& said);

/// GL_INVALID_ENUM: `command` has no such pname, or its pname takes more values than one.
void reject_parameter(Context& context, const char* command);

/// GL_OUT_OF_MEMORY: `command` threw. No exception crosses into the application.
void report_out_of_memory(Context& context, const char* command);

}  // namespace gouraud::api
