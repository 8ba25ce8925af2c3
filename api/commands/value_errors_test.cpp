// Every number that a command of GL 1.0-1.5 takes: the values that the specification refuses give its error and change
// nothing; a parameter that no rule here names takes every number of its type [GL1.5 §2.5].
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "api/commands/test_enum_sets.h"
#include "api/commands/test_error_cases.h"

namespace gouraud::api {
namespace {

constexpr GLenum invalid_value = GL_INVALID_VALUE, invalid_operation = GL_INVALID_OPERATION;
constexpr double most = 2147483647.0, least = -2147483648.0, most_unsigned = 4294967295.0;
constexpr double infinity = std::numeric_limits<double>::infinity(), nan_value = std::numeric_limits<double>::quiet_NaN();

/// In the model call of each command that has the parameter, these values of it give the error.
struct Refusal {
  const char* commands;  // separated by spaces; "": all that have the parameter
  const char* parameter;
  std::vector<double> values;
  GLenum error;
};

const std::vector<Refusal> refusals = {
    // [GL1.5 §2.8]
    {"VertexPointer", "size", {least, -1, 0, 1, 5, most}, invalid_value},
    {"TexCoordPointer", "size", {least, -1, 0, 5, most}, invalid_value},
    {"ColorPointer", "size", {least, -1, 0, 2, 5, most}, invalid_value},
    {"SecondaryColorPointer", "size", {least, -1, 0, 2, 4, most}, invalid_value},
    {"DrawArrays", "first", {least, -1}, invalid_value},
    {"ArrayElement", "i", {least, -1}, invalid_value},
    {"DrawRangeElements", "start", {4, most, most_unsigned}, invalid_value},
    // [GL1.5 §2.9]
    {"BufferData", "size", {4e18}, GL_OUT_OF_MEMORY},
    {"BufferSubData GetBufferSubData", "offset", {9, 64, 4e18}, invalid_value},
    {"BufferSubData GetBufferSubData", "size", {57, 4e18}, invalid_value},
    // [GL1.5 §2.11.2]
    {"Frustum", "zNear", {-infinity, -1, 0, 2}, invalid_value},
    {"Frustum", "zFar", {-infinity, -1, 0, 1}, invalid_value},
    {"Ortho", "zNear", {2}, invalid_value},
    {"Ortho", "zFar", {1}, invalid_value},
    {"Frustum Ortho", "left", {1}, invalid_value},
    {"Frustum Ortho", "right", {-1}, invalid_value},
    {"Frustum Ortho", "bottom", {1}, invalid_value},
    {"Frustum Ortho", "top", {-1}, invalid_value},
    // [GL1.5 §3.3, §3.4]
    {"PointSize", "size", {-infinity, -1, -1e-45, 0, nan_value}, invalid_value},
    {"LineWidth", "width", {-infinity, -1, -1e-45, 0, nan_value}, invalid_value},
    // [GL1.5 §3.6.3]: maps from indices have sizes that are powers of two.
    {"PixelMapfv PixelMapuiv PixelMapusv", "mapsize", {0, 3, 257, most}, invalid_value},
    // [GL1.5 §3.8.1 to §3.8.3, §6.1.3, §6.1.4]
    {"", "level", {least, -1, 16, most}, invalid_value},
    {"", "border", {least, -1, 2, most}, invalid_value},
    {"CompressedTexImage2D", "border", {1}, invalid_operation},  // [EXT_texture_compression_s3tc]
    {"TexImage1D TexImage2D CopyTexImage1D CopyTexImage2D CompressedTexImage2D", "width", {16385, most}, invalid_value},
    {"TexImage2D CopyTexImage2D CompressedTexImage2D", "height", {16385, most}, invalid_value},
    {"TexImage3D", "width", {2049, most}, invalid_value},
    {"TexImage3D", "height", {2049, most}, invalid_value},
    {"TexImage3D", "depth", {2049, most}, invalid_value},
    {"TexSubImage1D CopyTexSubImage1D TexSubImage2D CopyTexSubImage2D TexSubImage3D CopyTexSubImage3D",
     "width",
     {4, most},
     invalid_value},
    {"TexSubImage2D CopyTexSubImage2D TexSubImage3D CopyTexSubImage3D", "height", {4, most}, invalid_value},
    {"TexSubImage3D", "depth", {4, most}, invalid_value},
    {"TexSubImage1D CopyTexSubImage1D TexSubImage2D CopyTexSubImage2D TexSubImage3D CopyTexSubImage3D",
     "xoffset",
     {least, -1, 3, most},
     invalid_value},
    {"TexSubImage2D CopyTexSubImage2D TexSubImage3D CopyTexSubImage3D", "yoffset", {least, -1, 3, most}, invalid_value},
    {"TexSubImage3D", "zoffset", {least, -1, 3, most}, invalid_value},
    {"CopyTexSubImage3D", "zoffset", {least, -1, 4, most}, invalid_value},
    {"CompressedTexImage2D CompressedTexSubImage2D", "imageSize", {0, 7, 9, most}, invalid_value},
    {"CompressedTexImage2D CompressedTexSubImage2D", "width", {0, 5, 8, most}, invalid_value},
    {"CompressedTexImage2D CompressedTexSubImage2D", "height", {0, 5, 8, most}, invalid_value},
    {"CompressedTexSubImage2D", "xoffset", {least, -4, 4}, invalid_value},
    {"CompressedTexSubImage2D", "yoffset", {least, -4, 4}, invalid_value},
    // [GL1.5 §4.1.7]
    {"BeginQuery", "id", {0}, invalid_operation},
    {"GetQueryObjectiv GetQueryObjectuiv", "id", {0, 2, most_unsigned}, invalid_operation},
    // [GL1.5 §5.1]
    {"Map1d Map1f", "stride", {least, -1, 0, 2}, invalid_value},
    {"Map2d Map2f", "ustride", {least, -1, 0, 2}, invalid_value},
    {"Map2d Map2f", "vstride", {least, -1, 0, 2}, invalid_value},
    {"Map1d Map1f", "order", {least, -1, 0, 31, most}, invalid_value},
    {"Map2d Map2f", "uorder", {least, -1, 0, 31, most}, invalid_value},
    {"Map2d Map2f", "vorder", {least, -1, 0, 31, most}, invalid_value},
    {"Map1d Map1f Map2d Map2f", "u1", {1}, invalid_value},
    {"Map1d Map1f Map2d Map2f", "u2", {0}, invalid_value},
    {"Map2d Map2f", "v1", {1}, invalid_value},
    {"Map2d Map2f", "v2", {0}, invalid_value},
    {"", "un", {least, -1, 0}, invalid_value},
    {"", "vn", {least, -1, 0}, invalid_value},
    // [GL1.5 §5.4]; choice: as NewList, as Mesa has it.
    {"NewList CallList", "list", {0}, invalid_value},
};

/// The first call of a command that gives no error; arguments are empty if there is none.
Case model_of(const CommandRow& row) {
  bool known = false;
  for (const ModelCall& model : model_calls) {
    if (!names(model.commands, row.name)) continue;
    if (model.error == GL_NO_ERROR) return {&row, filled(row, model.arguments), GL_NO_ERROR, model.prepare};
    known = true;
  }
  return {&row, known ? std::vector<CommandArgument>{} : filled(row, {}), GL_NO_ERROR, nullptr};
}

bool concerns(const Refusal& refusal, const CommandRow& row, const std::string& parameter) {
  return parameter == refusal.parameter && (refusal.commands[0] == '\0' || names(refusal.commands, row.name));
}

/// Calls function(case, index, name) for every parameter of a core command's model call.
template <class Function>
void for_every_parameter(const Function& function) {
  for (const CommandRow& row : command_rows()) {
    if (!row.core) continue;
    const Case model = model_of(row);
    const std::vector<std::string> parameters = words(row.names);
    for (std::size_t i = 0; i < model.arguments.size(); ++i) function(model, i, parameters[i]);
  }
}

std::vector<CommandArgument> with(const Case& model, std::size_t index, double value) {
  std::vector<CommandArgument> arguments = model.arguments;
  arguments[index].number = value;
  return arguments;
}

TEST(EveryNumber, ThatTheSpecificationRefusesIsRefused) {
  std::set<const Refusal*> used;
  for_every_parameter([&](const Case& model, std::size_t i, const std::string& parameter) {
    for (const Refusal& refusal : refusals) {
      if (!concerns(refusal, *model.command, parameter)) continue;
      used.insert(&refusal);
      for (const double value : refusal.values) expect_error(model, with(model, i, value), refusal.error);
    }
  });
  EXPECT_EQ(used.size(), refusals.size());
}

TEST(EveryNumber, ThatNoRuleRefusesIsTaken) {
  // What a size or count admits upwards, memory decides: of these, zero. Values of pnames have tests of their own.
  const auto numbers = [](char kind) -> std::vector<double> {
    switch (kind) {
      case 'f':
      case 'd':
        return {0, -1, 1e-45, 1e38, -1e38, infinity, -infinity, nan_value};
      case 'i':
        return {0, -1, most, least};
      case 'u':
        return {0, most_unsigned};
      case 'b':
        return {0, 255};
      case 's':
      case 'n':
        return {0};
      default:
        return {};
    }
  };
  int taken = 0;
  for_every_parameter([&](const Case& model, std::size_t i, const std::string& parameter) {
    const bool ruled = std::any_of(refusals.begin(), refusals.end(), [&](const Refusal& refusal) {
      return concerns(refusal, *model.command, parameter);
    });
    if (ruled || parameter == "param" || parameter == "internalformat") return;
    for (const double value : numbers(model.command->parameters[i])) {
      expect_error(model, with(model, i, value), GL_NO_ERROR);
      ++taken;
    }
  });
  EXPECT_GT(taken, 2000);
}

TEST(EveryBit, ThatIsNoBufferIsRefusedByClear) {  // [GL1.5 §4.2.3]
  const GLbitfield buffers = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT;
  std::vector<ModelCall> calls;
  for (int bit = 0; bit < 32; ++bit) {
    const GLbitfield mask = 1u << bit;
    calls.push_back({"Clear", {static_cast<double>(mask)}, (mask & buffers) != 0 ? GLenum{GL_NO_ERROR} : invalid_value});
    calls.push_back({"PushAttrib PushClientAttrib", {static_cast<double>(mask)}, GL_NO_ERROR});
  }
  expect_errors(calls);
}

}  // namespace
}  // namespace gouraud::api
