// Every number that a pname stands before: for each command of the form Name{f,i,d}[v](..., pname, number) of GL 1.5 and
// our extensions, and each pname of it whose value is no enum, numbers below, at and above every limit, the ends of each
// type, infinities and NaN. What the specification refuses is GL_INVALID_VALUE and changes nothing [GL1.5 §2.5].
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "api/commands/test_enum_sets.h"
#include "api/commands/test_error_cases.h"

#include "parameter_shapes.h"

namespace gouraud::api {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), nan_value = std::numeric_limits<double>::quiet_NaN();

struct Range {
  double low, high;  // both belong to it
};

/// What follows these arguments of every form of the command (Light: Lightf, Lightfv, Lighti, Lightiv).
struct Numbers {
  const char* command;
  std::vector<double> before;       // the pname last
  std::vector<Range> allowed = {};  // none: every number is, NaN as well
  bool whole = false;               // an integer: floats are rounded to the nearest first [GL1.5 §6.1.2]
  int count = 1;                    // of numbers; of more than one, each is tried while the others are zero
  GLenum error_above = GL_INVALID_VALUE;

  double pname() const { return before.back(); }
};

void add(std::vector<Numbers>& rows, const Numbers& row, std::initializer_list<double> pnames) {
  for (const double pname : pnames) {
    rows.push_back(row);
    rows.back().before.push_back(pname);
  }
}

// [GL1.5 Table 2.8, Table 2.7, §2.14.1]
void add_lighting(std::vector<Numbers>& rows) {
  for (const double light : {GL_LIGHT0, GL_LIGHT7}) {
    add(rows, {"Light", {light}, {{0, 128}}}, {GL_SPOT_EXPONENT});
    add(rows, {"Light", {light}, {{0, 90}, {180, 180}}}, {GL_SPOT_CUTOFF});
    add(rows, {"Light", {light}, {{0, infinity}}},
        {GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION});
    add(rows, {.command = "Light", .before = {light}, .count = 4}, {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION});
    add(rows, {.command = "Light", .before = {light}, .count = 3}, {GL_SPOT_DIRECTION});
  }
  for (const double face : {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}) {
    add(rows, {"Material", {face}, {{0, 128}}}, {GL_SHININESS});
    add(rows, {.command = "Material", .before = {face}, .count = 4},
        {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT_AND_DIFFUSE});
    add(rows, {.command = "Material", .before = {face}, .count = 3}, {GL_COLOR_INDEXES});
  }
  add(rows, {"LightModel", {}}, {GL_LIGHT_MODEL_LOCAL_VIEWER, GL_LIGHT_MODEL_TWO_SIDE});
  add(rows, {.command = "LightModel", .before = {}, .count = 4}, {GL_LIGHT_MODEL_AMBIENT});
}

// [GL1.5 §2.11.4, §3.3, §3.10]
void add_coordinates_points_and_fog(std::vector<Numbers>& rows) {
  for (const double coordinate : {GL_S, GL_T, GL_R, GL_Q}) {
    add(rows, {.command = "TexGen", .before = {coordinate}, .count = 4}, {GL_OBJECT_PLANE, GL_EYE_PLANE});
  }
  add(rows, {"PointParameter", {}, {{0, infinity}}}, {GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX, GL_POINT_FADE_THRESHOLD_SIZE});
  add(rows, {.command = "PointParameter", .before = {}, .count = 3}, {GL_POINT_DISTANCE_ATTENUATION});
  add(rows, {"Fog", {}, {{0, infinity}}}, {GL_FOG_DENSITY});
  add(rows, {"Fog", {}}, {GL_FOG_START, GL_FOG_END, GL_FOG_INDEX});
  add(rows, {.command = "Fog", .before = {}, .count = 4}, {GL_FOG_COLOR});
}

// [GL1.5 Table 3.19, Table 3.22] [EXT_texture_filter_anisotropic, ARB_texture_rectangle, ARB_point_sprite]
void add_textures(std::vector<Numbers>& rows) {
  for (const double target : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_RECTANGLE_ARB}) {
    add(rows, {"TexParameter", {target}},
        {GL_TEXTURE_PRIORITY, GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD, GL_TEXTURE_LOD_BIAS, GL_GENERATE_MIPMAP});
    add(rows, {.command = "TexParameter", .before = {target}, .count = 4}, {GL_TEXTURE_BORDER_COLOR});
    add(rows, {"TexParameter", {target}, {{1, infinity}}}, {GL_TEXTURE_MAX_ANISOTROPY_EXT});
    add(rows, {"TexParameter", {target}, {{0, infinity}}, true}, {GL_TEXTURE_MAX_LEVEL});
    const bool rectangle = target == GL_TEXTURE_RECTANGLE_ARB;
    add(rows, {"TexParameter", {target}, {{0, rectangle ? 0 : infinity}}, true, 1, GL_INVALID_OPERATION}, {GL_TEXTURE_BASE_LEVEL});
  }
  add(rows, {"TexEnv", {GL_TEXTURE_ENV}, {{1, 1}, {2, 2}, {4, 4}}}, {GL_RGB_SCALE, GL_ALPHA_SCALE});
  add(rows, {.command = "TexEnv", .before = {GL_TEXTURE_ENV}, .count = 4}, {GL_TEXTURE_ENV_COLOR});
  add(rows, {"TexEnv", {GL_TEXTURE_FILTER_CONTROL}}, {GL_TEXTURE_LOD_BIAS});
  add(rows, {"TexEnv", {GL_POINT_SPRITE_ARB}, {{0, 0}, {1, 1}}}, {GL_COORD_REPLACE_ARB});
}

// [GL1.5 Table 3.1, Table 3.2, Table 4.4]
void add_pixels(std::vector<Numbers>& rows) {
  add(rows, {"PixelStore", {}}, {GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST, GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST});
  add(rows, {"PixelStore", {}, {{0, infinity}}, true},
      {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES,
       GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_IMAGES});
  add(rows, {"PixelStore", {}, {{1, 1}, {2, 2}, {4, 4}, {8, 8}}, true}, {GL_UNPACK_ALIGNMENT, GL_PACK_ALIGNMENT});
  add(rows, {"PixelTransfer", {}},
      {GL_MAP_COLOR, GL_MAP_STENCIL, GL_INDEX_SHIFT, GL_INDEX_OFFSET, GL_RED_SCALE, GL_RED_BIAS, GL_GREEN_SCALE, GL_GREEN_BIAS,
       GL_BLUE_SCALE, GL_BLUE_BIAS, GL_ALPHA_SCALE, GL_ALPHA_BIAS, GL_DEPTH_SCALE, GL_DEPTH_BIAS});
}

const std::vector<Numbers> numbers = [] {
  std::vector<Numbers> rows;
  add_lighting(rows);
  add_coordinates_points_and_fog(rows);
  add_textures(rows);
  add_pixels(rows);
  return rows;
}();

std::vector<double> limits_of(const Numbers& row) {
  std::vector<double> limits;
  for (const Range& range : row.allowed) {
    for (const double limit : {range.low, range.high}) {
      if (std::isfinite(limit)) limits.push_back(limit);
    }
  }
  return limits;
}

std::vector<double> whole_candidates(const Numbers& row) {
  std::vector<double> values = {-2147483648.0, -16777217, -1, 0, 1, 16777217, 2147483647};
  for (const double limit : limits_of(row)) values.insert(values.end(), {limit - 1, limit, limit + 1});
  return values;
}

std::vector<double> real_candidates(const Numbers& row) {
  constexpr float most = std::numeric_limits<float>::max(), least = std::numeric_limits<float>::denorm_min();
  std::vector<double> values = {-infinity, -double{most}, -1, -double{least}, -0.0, 0, double{least}, 1, double{most}, infinity, nan_value};
  for (const double limit : limits_of(row)) {
    const auto exact = static_cast<float>(limit);
    const double below = std::nextafter(exact, -most), above = std::nextafter(exact, most);
    values.insert(values.end(), {limit - 1, limit - 0.75, limit - 0.25, below, limit, above, limit + 0.25, limit + 0.75, limit + 1});
  }
  return values;
}

GLenum expected_error(const Numbers& row, double value) {
  if (row.allowed.empty()) return GL_NO_ERROR;
  const double kept = row.whole ? std::round(value) : value;
  const auto holds = [kept](const Range& range) { return kept >= range.low && kept <= range.high; };
  if (std::any_of(row.allowed.begin(), row.allowed.end(), holds)) return GL_NO_ERROR;
  return kept > row.allowed.back().high ? row.error_above : GLenum{GL_INVALID_VALUE};
}

/// Tries the row's numbers through one form; how many were refused.
int expect_numbers(const Numbers& row, const CommandRow& form) {
  const std::string_view name = form.name;
  const bool is_integer = name.ends_with("i") || name.ends_with("iv");
  int refused = 0;
  for (const double value : is_integer ? whole_candidates(row) : real_candidates(row)) {
    for (int which = 0; which < row.count; ++which) {
      std::vector<double> given = row.before;
      given.push_back(which == 0 ? value : 0.0);
      std::vector<CommandArgument> arguments = filled(form, given);
      for (int i = 1; i < row.count; ++i) arguments.emplace_back(i == which ? value : 0.0);
      const GLenum error = expected_error(row, value);
      expect_error({&form, arguments, error, nullptr}, arguments, error);
      refused += error != GL_NO_ERROR ? 1 : 0;
    }
  }
  return refused;
}

TEST(EveryNumberBehindAPname, IsTakenInItsRangesAndElseRefused) {
  int refused = 0;
  for (const Numbers& row : numbers) {
    int forms = 0;
    for (const CommandRow& form : command_rows()) {
      const std::string_view name = form.name;
      if (!form.core || !name.starts_with(row.command)) continue;
      const std::string_view suffix = name.substr(std::string_view(row.command).size());
      const bool scalar = suffix == "f" || suffix == "i" || suffix == "d";
      const bool vector = suffix == "fv" || suffix == "iv" || suffix == "dv";
      if (!vector && (!scalar || row.count > 1)) continue;
      refused += expect_numbers(row, form);
      ++forms;
    }
    EXPECT_GE(forms, 2) << row.command;
  }
  EXPECT_GT(refused, 1500);
}

// The commands' own lists of parameters, from which their forms are made, hold no number that has no row above.
TEST(EveryNumberBehindAPname, HasARow) {
  std::set<std::pair<std::string, GLenum>> rows;
  for (const Numbers& row : numbers) rows.emplace(row.command, static_cast<GLenum>(row.pname()));
  std::set<std::pair<std::string, GLenum>> expected;
  const std::pair<const char*, ParameterShape (*)(GLenum)> shapes[] = {
      {"Light", shape_of_light},       {"LightModel", shape_of_light_model},
      {"Material", shape_of_material}, {"Fog", shape_of_fog},
      {"TexEnv", shape_of_tex_env},    {"PointParameter", shape_of_point_parameter},
      {"TexGen", shape_of_tex_gen},    {"TexParameter", shape_of_tex_parameter},
  };
  for (const auto& [command, shape_of] : shapes) {
    for (const GLenum pname : every_enum()) {
      if (const ParameterShape shape = shape_of(pname); shape.values > 0 && !shape.is_enum) expected.emplace(command, pname);
    }
  }
  for (const GLenum pname : group_members("PixelStoreParameter")) expected.emplace("PixelStore", pname);
  for (const GLenum pname : group_members("PixelTransferParameter")) expected.emplace("PixelTransfer", pname);
  EXPECT_EQ(rows, expected);
}

// [GL1.5 §3.6.3, Table 3.3]: 256 entries are what this implementation has; maps from indices take powers of two.
TEST(EveryNumberBehindAPname, OfAPixelMapIsItsSize) {
  const std::set<GLenum> maps = group_members("PixelMap");
  EXPECT_EQ(maps.size(), 10u);
  for (const CommandRow& form : command_rows()) {
    if (!names("PixelMapfv PixelMapuiv PixelMapusv", form.name)) continue;
    for (const GLenum map : maps) {
      const bool from_index = map <= GL_PIXEL_MAP_I_TO_A;
      for (const int size : {-2147483647 - 1, -1, 0, 1, 2, 3, 4, 5, 128, 255, 256, 257, 512, 2147483647}) {
        const bool fits = size >= 1 && size <= 256 && (!from_index || (size & (size - 1)) == 0);
        const std::vector<CommandArgument> arguments = filled(form, {static_cast<double>(map), static_cast<double>(size)});
        const GLenum error = fits ? GL_NO_ERROR : GL_INVALID_VALUE;
        expect_error({&form, arguments, error, nullptr}, arguments, error);
      }
    }
  }
}

struct EvaluatorMap {
  GLenum first, second;  // the targets of one and of two dimensions
  int components;
};
constexpr EvaluatorMap evaluator_maps[] = {
    {GL_MAP1_COLOR_4, GL_MAP2_COLOR_4, 4},
    {GL_MAP1_INDEX, GL_MAP2_INDEX, 1},
    {GL_MAP1_NORMAL, GL_MAP2_NORMAL, 3},
    {GL_MAP1_TEXTURE_COORD_1, GL_MAP2_TEXTURE_COORD_1, 1},
    {GL_MAP1_TEXTURE_COORD_2, GL_MAP2_TEXTURE_COORD_2, 2},
    {GL_MAP1_TEXTURE_COORD_3, GL_MAP2_TEXTURE_COORD_3, 3},
    {GL_MAP1_TEXTURE_COORD_4, GL_MAP2_TEXTURE_COORD_4, 4},
    {GL_MAP1_VERTEX_3, GL_MAP2_VERTEX_3, 3},
    {GL_MAP1_VERTEX_4, GL_MAP2_VERTEX_4, 4},
};

// [GL1.5 §5.1]: the least stride is the target's.
TEST(EveryNumberBehindATarget, OfAMapIsAnOrderAStrideOrADomain) {
  std::vector<ModelCall> calls;
  for (const EvaluatorMap& map : evaluator_maps) {
    const double first = map.first, second = map.second, k = map.components;
    const auto call = [&](double u1, double u2, double stride, double order, GLenum error) {
      calls.push_back({"Map1f Map1d", {first, u1, u2, stride, order}, error});
      calls.push_back({"Map2f Map2d", {second, u1, u2, stride, order, 0, 1, k, 2}, error});
      calls.push_back({"Map2f Map2d", {second, 0, 1, k, 2, u1, u2, stride, order}, error});
    };
    for (const double order : {1.0, 2.0, 30.0}) call(0, 1, k, order, GL_NO_ERROR);
    for (const double order : {-2147483648.0, -1.0, 0.0, 31.0, 2147483647.0}) call(0, 1, k, order, GL_INVALID_VALUE);
    for (const double stride : {k, k + 1, 40.0}) call(0, 1, stride, 2, GL_NO_ERROR);
    for (const double stride : {-2147483648.0, -1.0, 0.0, k - 1}) call(0, 1, stride, 2, GL_INVALID_VALUE);
    for (const double end : {-1.0, 0.0, 0.5, 1e30, infinity}) call(end, end, k, 2, GL_INVALID_VALUE);
    for (const double end : {-infinity, -1.0, 1e-40, 1e30, infinity, nan_value}) {
      call(0, end, k, 2, GL_NO_ERROR);
      call(end, 0, k, 2, GL_NO_ERROR);
    }
  }
  expect_errors(calls);
}

}  // namespace
}  // namespace gouraud::api
