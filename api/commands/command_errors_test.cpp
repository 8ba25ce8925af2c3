// Every command of GL 1.0-1.5, from the registry: a call between Begin and End where §2.6.3 does not list it, and
// every size that is negative: the specification's error, and nothing changes [GL1.5 §2.5]. Enums: enum_errors_test.cpp;
// other numbers: value_errors_test.cpp.
#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "api/commands/test_error_cases.h"
#include "api/commands/test_model_calls.h"

namespace gouraud::api {
namespace {

constexpr GLenum invalid_value = GL_INVALID_VALUE;
constexpr GLenum invalid_operation = GL_INVALID_OPERATION, no_error = GL_NO_ERROR;

// One or more for every command of GL 1.0-1.5.
std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const CommandRow& row : command_rows()) {
    if (!row.core) continue;
    const std::size_t before = cases.size();
    for (const ModelCall& model : model_calls) {
      if (names(model.commands, row.name)) {
        cases.push_back({&row, filled(row, model.arguments), model.error, model.prepare});
      }
    }
    if (cases.size() == before) cases.push_back({&row, filled(row, {}), no_error, nullptr});
  }
  return cases;
}

TEST(EveryCommand, IsAcceptedOrRefusedAsTheInitialStateHasIt) {
  std::set<std::string> commands;
  for (const Case& call_of : all_cases()) {
    expect_error(call_of, call_of.arguments, call_of.error);
    commands.insert(call_of.command->name);
  }
  EXPECT_EQ(commands.size(), 452u);
}

TEST(EveryCommand, IsRefusedBetweenBeginAndEndUnlessListed) {
  int refused = 0;
  for (const Case& call_of : all_cases()) {
    const CommandRow& row = *call_of.command;
    if (row.legal_inside_begin_end || std::strcmp(row.name, "End") == 0) continue;
    FullScreen screen;
    const State state = screen.context.state;
    const StateDump before = dump_state();
    glBegin(GL_TRIANGLES);
    call(row, call_of.arguments);
    EXPECT_TRUE(screen.context.inside_begin_end()) << row.name;
    glEnd();
    EXPECT_EQ(glGetError(), invalid_operation) << row.name;
    EXPECT_TRUE(screen.context.state == state) << row.name;
    EXPECT_EQ(difference(before, dump_state()), "") << row.name;
    ++refused;
  }
  EXPECT_GE(refused, 452 - 179);
}

TEST(EveryCommand, ThatSection263ListsPassesBetweenBeginAndEnd) {
  int passed = 0;
  for (const Case& call_of : all_cases()) {
    if (!call_of.command->legal_inside_begin_end || call_of.error != GL_NO_ERROR) continue;
    FullScreen screen;
    glBegin(GL_TRIANGLES);
    call(*call_of.command, call_of.arguments);
    glEnd();
    EXPECT_EQ(glGetError(), no_error) << call_of.command->name;
    ++passed;
  }
  EXPECT_EQ(passed, 179);
}

TEST(EverySize, BelowZeroIsRefused) {
  for (const Case& call_of : all_cases()) {
    if (call_of.error != GL_NO_ERROR) continue;
    for (std::size_t i = 0; i < call_of.arguments.size(); ++i) {
      const char kind = call_of.command->parameters[i];
      if (kind != 's' && kind != 'n') continue;
      for (const double bad : {-1.0, -2147483648.0}) {
        std::vector<CommandArgument> arguments = call_of.arguments;
        arguments[i].number = bad;
        expect_error(call_of, arguments, invalid_value);
      }
    }
  }
}

}  // namespace
}  // namespace gouraud::api
