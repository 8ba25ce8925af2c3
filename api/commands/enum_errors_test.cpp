// Every enum parameter of every command of GL 1.0-1.5, poured with every enum of the header: those of its set are taken
// as enums, each other is GL_INVALID_ENUM, and nothing changes [GL1.5 §2.5].
#include <gtest/gtest.h>

#include "api/commands/test_enum_sets.h"
#include "api/commands/test_error_cases.h"

namespace gouraud::api {
namespace {

// A call whose argument of number `index` is poured.
struct Poured {
  const CommandRow* command;
  std::vector<CommandArgument> arguments;
  std::size_t index;
  void (*prepare)();

  std::vector<CommandArgument> with(GLenum value) const {
    std::vector<CommandArgument> result = arguments;
    result[index].number = value;
    return result;
  }
};

void expect_refused(const Poured& poured, const std::set<GLenum>& values, GLenum error) {
  FullScreen screen;
  if (poured.prepare != nullptr) poured.prepare();
  const State state = screen.context.state;
  const StateDump before = dump_state();
  for (const GLenum value : values) {
    const std::vector<CommandArgument> arguments = poured.with(value);
    call(*poured.command, arguments);
    ASSERT_EQ(screen.context.take_error(), error) << text_of(*poured.command, arguments);
    ASSERT_TRUE(screen.context.state == state) << text_of(*poured.command, arguments);
  }
  ASSERT_FALSE(screen.context.inside_begin_end() || screen.context.compiling()) << poured.command->name;
  ASSERT_EQ(difference(before, dump_state()), "") << poured.command->name;
}

void expect_taken(const Poured& poured, const std::set<GLenum>& values, GLenum refusal) {
  for (const GLenum value : values) {
    FullScreen screen;
    if (poured.prepare != nullptr) poured.prepare();
    const std::vector<CommandArgument> arguments = poured.with(value);
    call(*poured.command, arguments);
    EXPECT_NE(screen.context.take_error(), refusal) << text_of(*poured.command, arguments);
  }
}

std::set<GLenum> all_but(const std::set<GLenum>& some) {
  std::set<GLenum> rest = every_enum();
  for (const GLenum value : some) rest.erase(value);
  return rest;
}

void pour(const Poured& poured, const char* parameter, const std::string& group) {
  const EnumSet* const set = find_set(poured.command->name, parameter);
  std::set<GLenum> taken;
  if (set == nullptr || set->base == EnumSet::Base::group) taken = group_members(group);
  if (set != nullptr) {
    taken.insert(set->more.begin(), set->more.end());
    for (const GLenum value : set->fewer) taken.erase(value);
    taken.insert(set->depending.begin(), set->depending.end());
  }
  // [GL1.5 §3.8.1]: an internal format of TexImage is a number, not an enum.
  const bool is_number = poured.command->parameters[poured.index] != 'e';
  const GLenum refusal = is_number ? GL_INVALID_VALUE : GL_INVALID_ENUM;
  expect_refused(poured, all_but(taken), refusal);
  if (set != nullptr) {
    for (const GLenum value : set->depending) taken.erase(value);
  }
  expect_taken(poured, taken, refusal);
}

TEST(EveryEnum, IsTakenIfItsParameterIsOfItAndElseRefused) {
  std::size_t parameters = 0;
  for (const CommandRow& row : command_rows()) {
    const auto model = std::find_if(model_calls.begin(), model_calls.end(), [&](const ModelCall& candidate) {
      return names(candidate.commands, row.name) && candidate.error == GL_NO_ERROR;
    });
    const bool has_model = model != model_calls.end();
    if (!row.core || (!has_model && !is_multi_tex_coord(row.name))) continue;
    const std::vector<CommandArgument> arguments = filled(row, has_model ? model->arguments : std::vector<double>{});
    const std::vector<std::string> parameter_names = words(row.names), groups = words(row.groups);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (row.parameters[i] != 'e' && groups[i] != "InternalFormat") continue;
      pour({&row, arguments, i, has_model ? model->prepare : nullptr}, parameter_names[i].c_str(), groups[i]);
      ++parameters;
    }
  }
  EXPECT_GT(parameters, 250u);
}

TEST(EveryEnum, ThatAParametersValueIsIsTakenIfTheParameterIsOfItAndElseRefused) {
  for (const ValueSet& set : value_sets) {
    for (const CommandRow& row : command_rows()) {
      if (!names(set.commands, row.name)) continue;
      std::vector<double> arguments = set.before;
      arguments.push_back(0);
      const Poured poured = {&row, filled(row, arguments), arguments.size() - 1, nullptr};
      const std::set<GLenum> taken(set.values.begin(), set.values.end());
      std::set<GLenum> refused;  // those that a float holds exactly: others round to who knows what
      for (const GLenum value : all_but(taken)) {
        if (value < 1 << 24) refused.insert(value);
      }
      expect_refused(poured, refused, GL_INVALID_ENUM);
      expect_taken(poured, taken, GL_INVALID_ENUM);
    }
  }
}

}  // namespace
}  // namespace gouraud::api
