// For tests: a call, the error that it must give, and nothing else that may change [GL1.5 §2.5].
#pragma once

#include <vector>

#include <GL/gl.h>
#include <gtest/gtest.h>

#include "api/commands/test_calls.h"
#include "api/commands/test_dump.h"

namespace gouraud::api {

/// A current context with every buffer.
struct FullScreen {
  FullScreen() {
    EXPECT_TRUE(context.set_window_size(16, 16, pipeline::ColorFormat::rgba8));
    make_current(&context);
  }
  Context context{{24, 8, 16}, nullptr};
};

struct Case {
  const CommandRow* command;
  std::vector<CommandArgument> arguments;
  GLenum error;
  void (*prepare)();
};

/// Calls it in a new context; the error must come, and if one is to come, nothing else may change.
inline void expect_error(const Case& call_of, const std::vector<CommandArgument>& arguments, GLenum error) {
  FullScreen screen;
  if (call_of.prepare != nullptr) call_of.prepare();
  ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << call_of.command->name << ": its preparation";
  const bool compares = error != GL_NO_ERROR && !screen.context.compiling();
  const State state = screen.context.state;
  const StateDump before = compares ? dump_state() : StateDump{};
  call(*call_of.command, arguments);
  const GLenum found = screen.context.take_error();
  EXPECT_EQ(found, error) << text_of(*call_of.command, arguments);
  if (!compares || found == GLenum{GL_NO_ERROR}) return;
  EXPECT_TRUE(screen.context.state == state) << text_of(*call_of.command, arguments);
  EXPECT_EQ(difference(before, dump_state()), "") << text_of(*call_of.command, arguments);
}

/// All commands of all rows; a name that is no command fails.
inline void expect_errors(const std::vector<ModelCall>& calls) {
  for (const ModelCall& model : calls) {
    bool found = false;
    for (const CommandRow& row : command_rows()) {
      if (!names(model.commands, row.name)) continue;
      const std::vector<CommandArgument> arguments = filled(row, model.arguments);
      expect_error({&row, arguments, model.error, model.prepare}, arguments, model.error);
      found = true;
    }
    EXPECT_TRUE(found) << model.commands;
  }
}

}  // namespace gouraud::api
