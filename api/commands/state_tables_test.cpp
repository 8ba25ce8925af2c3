// Every state variable that glGet, glIsEnabled and glGetPointerv know of Tables 6.5 to 6.32 has its initial value, in
// all four types [GL1.5 §6.1.2, §6.2]. What other queries give stands with their commands.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "api/commands/state_table.h"
#include "api/commands/test_dump.h"

namespace gouraud::api {
namespace {

enum class Meaning { plain, color };  // how it converts to integers [GL1.5 §6.1.2]
using enum Meaning;

struct Initial {
  GLenum pname;
  std::vector<double> values;
  Meaning meaning = plain;
};

const std::vector<double> identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
constexpr double all_ones = 4294967295.0;
constexpr int width_px = 48, height_px = 20;

const std::vector<Initial> current_values = {
    // [GL1.5 Table 6.5]
    {GL_CURRENT_COLOR, {1, 1, 1, 1}, color},
    {GL_CURRENT_SECONDARY_COLOR, {0, 0, 0, 1}, color},
    {GL_CURRENT_INDEX, {1}},
    {GL_CURRENT_TEXTURE_COORDS, {0, 0, 0, 1}},
    {GL_CURRENT_NORMAL, {0, 0, 1}, color},
    {GL_CURRENT_FOG_COORD, {0}},
    {GL_CURRENT_RASTER_POSITION, {0, 0, 0, 1}},
    {GL_CURRENT_RASTER_DISTANCE, {0}},
    {GL_CURRENT_RASTER_COLOR, {1, 1, 1, 1}, color},
    {GL_CURRENT_RASTER_INDEX, {1}},
    {GL_CURRENT_RASTER_TEXTURE_COORDS, {0, 0, 0, 1}},
    {GL_CURRENT_RASTER_POSITION_VALID, {1}},
    {GL_EDGE_FLAG, {1}},
};

const std::vector<Initial> vertex_arrays = {
    // [GL1.5 Tables 6.6 to 6.8]
    {GL_CLIENT_ACTIVE_TEXTURE, {GL_TEXTURE0}},
    {GL_VERTEX_ARRAY_SIZE, {4}},
    {GL_VERTEX_ARRAY_TYPE, {GL_FLOAT}},
    {GL_VERTEX_ARRAY_STRIDE, {0}},
    {GL_VERTEX_ARRAY_COUNT_EXT, {0}},
    {GL_NORMAL_ARRAY_TYPE, {GL_FLOAT}},
    {GL_NORMAL_ARRAY_STRIDE, {0}},
    {GL_NORMAL_ARRAY_COUNT_EXT, {0}},
    {GL_FOG_COORD_ARRAY_TYPE, {GL_FLOAT}},
    {GL_FOG_COORD_ARRAY_STRIDE, {0}},
    {GL_COLOR_ARRAY_SIZE, {4}},
    {GL_COLOR_ARRAY_TYPE, {GL_FLOAT}},
    {GL_COLOR_ARRAY_STRIDE, {0}},
    {GL_COLOR_ARRAY_COUNT_EXT, {0}},
    {GL_SECONDARY_COLOR_ARRAY_SIZE, {3}},
    {GL_SECONDARY_COLOR_ARRAY_TYPE, {GL_FLOAT}},
    {GL_SECONDARY_COLOR_ARRAY_STRIDE, {0}},
    {GL_INDEX_ARRAY_TYPE, {GL_FLOAT}},
    {GL_INDEX_ARRAY_STRIDE, {0}},
    {GL_INDEX_ARRAY_COUNT_EXT, {0}},
    {GL_TEXTURE_COORD_ARRAY_SIZE, {4}},
    {GL_TEXTURE_COORD_ARRAY_TYPE, {GL_FLOAT}},
    {GL_TEXTURE_COORD_ARRAY_STRIDE, {0}},
    {GL_TEXTURE_COORD_ARRAY_COUNT_EXT, {0}},
    {GL_EDGE_FLAG_ARRAY_STRIDE, {0}},
    {GL_EDGE_FLAG_ARRAY_COUNT_EXT, {0}},
    {GL_ARRAY_BUFFER_BINDING, {0}},
    {GL_VERTEX_ARRAY_BUFFER_BINDING, {0}},
    {GL_NORMAL_ARRAY_BUFFER_BINDING, {0}},
    {GL_COLOR_ARRAY_BUFFER_BINDING, {0}},
    {GL_INDEX_ARRAY_BUFFER_BINDING, {0}},
    {GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING, {0}},
    {GL_EDGE_FLAG_ARRAY_BUFFER_BINDING, {0}},
    {GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING, {0}},
    {GL_FOG_COORD_ARRAY_BUFFER_BINDING, {0}},
    {GL_ELEMENT_ARRAY_BUFFER_BINDING, {0}},
};

const std::vector<Initial> transformation = {
    // [GL1.5 Table 6.9]
    {GL_MODELVIEW_MATRIX, identity},
    {GL_PROJECTION_MATRIX, identity},
    {GL_TEXTURE_MATRIX, identity},
    {GL_TRANSPOSE_MODELVIEW_MATRIX, identity},
    {GL_TRANSPOSE_PROJECTION_MATRIX, identity},
    {GL_TRANSPOSE_TEXTURE_MATRIX, identity},
    {GL_VIEWPORT, {0, 0, width_px, height_px}},
    {GL_DEPTH_RANGE, {0, 1}, color},
    {GL_MODELVIEW_STACK_DEPTH, {1}},
    {GL_PROJECTION_STACK_DEPTH, {1}},
    {GL_TEXTURE_STACK_DEPTH, {1}},
    {GL_MATRIX_MODE, {GL_MODELVIEW}},
};

const std::vector<Initial> coloring_and_lighting = {
    // [GL1.5 Tables 6.10, 6.11]
    {GL_FOG_COLOR, {0, 0, 0, 0}, color},
    {GL_FOG_INDEX, {0}},
    {GL_FOG_DENSITY, {1}},
    {GL_FOG_START, {0}},
    {GL_FOG_END, {1}},
    {GL_FOG_MODE, {GL_EXP}},
    {GL_FOG_COORD_SRC, {GL_FRAGMENT_DEPTH}},
    {GL_SHADE_MODEL, {GL_SMOOTH}},
    {GL_COLOR_MATERIAL_PARAMETER, {GL_AMBIENT_AND_DIFFUSE}},
    {GL_COLOR_MATERIAL_FACE, {GL_FRONT_AND_BACK}},
    {GL_LIGHT_MODEL_AMBIENT, {0.2f, 0.2f, 0.2f, 1}, color},
    {GL_LIGHT_MODEL_LOCAL_VIEWER, {0}},
    {GL_LIGHT_MODEL_TWO_SIDE, {0}},
    {GL_LIGHT_MODEL_COLOR_CONTROL, {GL_SINGLE_COLOR}},
};

const std::vector<Initial> rasterization = {
    // [GL1.5 Tables 6.13, 6.14]
    {GL_POINT_SIZE, {1}},
    {GL_POINT_SIZE_MIN, {0}},
    {GL_POINT_SIZE_MAX, {255}},
    {GL_POINT_FADE_THRESHOLD_SIZE, {1}},
    {GL_POINT_DISTANCE_ATTENUATION, {1, 0, 0}},
    {GL_LINE_WIDTH, {1}},
    {GL_LINE_STIPPLE_PATTERN, {0xFFFF}},
    {GL_LINE_STIPPLE_REPEAT, {1}},
    {GL_CULL_FACE_MODE, {GL_BACK}},
    {GL_FRONT_FACE, {GL_CCW}},
    {GL_POLYGON_MODE, {GL_FILL, GL_FILL}},
    {GL_POLYGON_OFFSET_FACTOR, {0}},
    {GL_POLYGON_OFFSET_UNITS, {0}},
    {GL_POLYGON_OFFSET_BIAS_EXT, {0}},
    {GL_SAMPLE_COVERAGE_VALUE, {1}},
    {GL_SAMPLE_COVERAGE_INVERT, {0}},
};

const std::vector<Initial> textures = {
    // [GL1.5 Tables 6.15, 6.18]
    {GL_TEXTURE_BINDING_1D, {0}},       {GL_TEXTURE_BINDING_2D, {0}},       {GL_TEXTURE_BINDING_3D, {0}},
    {GL_TEXTURE_BINDING_CUBE_MAP, {0}}, {GL_ACTIVE_TEXTURE, {GL_TEXTURE0}},
};

const std::vector<Initial> pixel_operations = {
    // [GL1.5 Tables 6.19, 6.20]
    {GL_SCISSOR_BOX, {0, 0, width_px, height_px}},
    {GL_ALPHA_TEST_FUNC, {GL_ALWAYS}},
    {GL_ALPHA_TEST_REF, {0}, color},
    {GL_STENCIL_FUNC, {GL_ALWAYS}},
    {GL_STENCIL_VALUE_MASK, {all_ones}},
    {GL_STENCIL_WRITEMASK, {all_ones}},
    {GL_INDEX_WRITEMASK, {all_ones}},
    {GL_STENCIL_REF, {0}},
    {GL_STENCIL_FAIL, {GL_KEEP}},
    {GL_STENCIL_PASS_DEPTH_FAIL, {GL_KEEP}},
    {GL_STENCIL_PASS_DEPTH_PASS, {GL_KEEP}},
    {GL_DEPTH_FUNC, {GL_LESS}},
    {GL_BLEND_SRC_RGB, {GL_ONE}},
    {GL_BLEND_SRC_ALPHA, {GL_ONE}},
    {GL_BLEND_DST_RGB, {GL_ZERO}},
    {GL_BLEND_DST_ALPHA, {GL_ZERO}},
    {GL_BLEND_SRC, {GL_ONE}},
    {GL_BLEND_DST, {GL_ZERO}},
    {GL_BLEND_EQUATION, {GL_FUNC_ADD}},
    {GL_BLEND_COLOR, {0, 0, 0, 0}, color},
    {GL_LOGIC_OP_MODE, {GL_COPY}},
    {GL_DRAW_BUFFER, {GL_FRONT}},
    {GL_COLOR_WRITEMASK, {1, 1, 1, 1}},
    {GL_DEPTH_WRITEMASK, {1}},
    {GL_COLOR_CLEAR_VALUE, {0, 0, 0, 0}, color},
    {GL_INDEX_CLEAR_VALUE, {0}},
    {GL_DEPTH_CLEAR_VALUE, {1}, color},
    {GL_STENCIL_CLEAR_VALUE, {0}},
    {GL_ACCUM_CLEAR_VALUE, {0, 0, 0, 0}, color},
};

const std::vector<Initial> pixels = {
    // [GL1.5 Tables 6.21 to 6.23]
    {GL_UNPACK_SWAP_BYTES, {0}},
    {GL_UNPACK_LSB_FIRST, {0}},
    {GL_UNPACK_IMAGE_HEIGHT, {0}},
    {GL_UNPACK_SKIP_IMAGES, {0}},
    {GL_UNPACK_ROW_LENGTH, {0}},
    {GL_UNPACK_SKIP_ROWS, {0}},
    {GL_UNPACK_SKIP_PIXELS, {0}},
    {GL_UNPACK_ALIGNMENT, {4}},
    {GL_PACK_SWAP_BYTES, {0}},
    {GL_PACK_LSB_FIRST, {0}},
    {GL_PACK_IMAGE_HEIGHT, {0}},
    {GL_PACK_SKIP_IMAGES, {0}},
    {GL_PACK_ROW_LENGTH, {0}},
    {GL_PACK_SKIP_ROWS, {0}},
    {GL_PACK_SKIP_PIXELS, {0}},
    {GL_PACK_ALIGNMENT, {4}},
    {GL_MAP_COLOR, {0}},
    {GL_MAP_STENCIL, {0}},
    {GL_INDEX_SHIFT, {0}},
    {GL_INDEX_OFFSET, {0}},
    {GL_RED_SCALE, {1}},
    {GL_GREEN_SCALE, {1}},
    {GL_BLUE_SCALE, {1}},
    {GL_ALPHA_SCALE, {1}},
    {GL_DEPTH_SCALE, {1}},
    {GL_RED_BIAS, {0}},
    {GL_GREEN_BIAS, {0}},
    {GL_BLUE_BIAS, {0}},
    {GL_ALPHA_BIAS, {0}},
    {GL_DEPTH_BIAS, {0}},
    {GL_ZOOM_X, {1}},
    {GL_ZOOM_Y, {1}},
    {GL_PIXEL_MAP_I_TO_I_SIZE, {1}},
    {GL_PIXEL_MAP_S_TO_S_SIZE, {1}},
    {GL_PIXEL_MAP_I_TO_R_SIZE, {1}},
    {GL_PIXEL_MAP_I_TO_G_SIZE, {1}},
    {GL_PIXEL_MAP_I_TO_B_SIZE, {1}},
    {GL_PIXEL_MAP_I_TO_A_SIZE, {1}},
    {GL_PIXEL_MAP_R_TO_R_SIZE, {1}},
    {GL_PIXEL_MAP_G_TO_G_SIZE, {1}},
    {GL_PIXEL_MAP_B_TO_B_SIZE, {1}},
    {GL_PIXEL_MAP_A_TO_A_SIZE, {1}},
    {GL_READ_BUFFER, {GL_FRONT}},
};

const std::vector<Initial> evaluators_and_hints = {
    // [GL1.5 Tables 6.26, 6.27, 6.32]
    {GL_MAP1_GRID_DOMAIN, {0, 1}},
    {GL_MAP2_GRID_DOMAIN, {0, 1, 0, 1}},
    {GL_MAP1_GRID_SEGMENTS, {1}},
    {GL_MAP2_GRID_SEGMENTS, {1, 1}},
    {GL_PERSPECTIVE_CORRECTION_HINT, {GL_DONT_CARE}},
    {GL_POINT_SMOOTH_HINT, {GL_DONT_CARE}},
    {GL_LINE_SMOOTH_HINT, {GL_DONT_CARE}},
    {GL_POLYGON_SMOOTH_HINT, {GL_DONT_CARE}},
    {GL_FOG_HINT, {GL_DONT_CARE}},
    {GL_GENERATE_MIPMAP_HINT, {GL_DONT_CARE}},
    {GL_TEXTURE_COMPRESSION_HINT, {GL_DONT_CARE}},
    {GL_LIST_BASE, {0}},
    {GL_LIST_INDEX, {0}},
    {GL_LIST_MODE, {0}},
    {GL_ATTRIB_STACK_DEPTH, {0}},
    {GL_CLIENT_ATTRIB_STACK_DEPTH, {0}},
    {GL_NAME_STACK_DEPTH, {0}},
    {GL_RENDER_MODE, {GL_RENDER}},
    {GL_SELECTION_BUFFER_SIZE, {0}},
    {GL_FEEDBACK_BUFFER_SIZE, {0}},
    {GL_FEEDBACK_BUFFER_TYPE, {GL_2D}},
};

const std::vector<Initial> target = {
    // [GL1.5 Table 6.31], of the context below
    {GL_AUX_BUFFERS, {0}},      {GL_RGBA_MODE, {1}},         {GL_INDEX_MODE, {0}},      {GL_DOUBLEBUFFER, {0}},
    {GL_STEREO, {0}},           {GL_SAMPLE_BUFFERS, {0}},    {GL_SAMPLES, {0}},         {GL_RED_BITS, {8}},
    {GL_GREEN_BITS, {8}},       {GL_BLUE_BITS, {8}},         {GL_ALPHA_BITS, {8}},      {GL_INDEX_BITS, {0}},
    {GL_DEPTH_BITS, {24}},      {GL_STENCIL_BITS, {8}},      {GL_ACCUM_RED_BITS, {32}}, {GL_ACCUM_GREEN_BITS, {32}},
    {GL_ACCUM_BLUE_BITS, {32}}, {GL_ACCUM_ALPHA_BITS, {32}},
};

// The least that the specification allows [GL1.5 Tables 6.28 to 6.30].
const std::vector<Initial> least = {
    {GL_MAX_LIGHTS, {8}},
    {GL_MAX_CLIP_PLANES, {6}},
    {GL_MAX_MODELVIEW_STACK_DEPTH, {32}},
    {GL_MAX_PROJECTION_STACK_DEPTH, {2}},
    {GL_MAX_TEXTURE_STACK_DEPTH, {2}},
    {GL_SUBPIXEL_BITS, {4}},
    {GL_MAX_3D_TEXTURE_SIZE, {16}},
    {GL_MAX_TEXTURE_SIZE, {64}},
    {GL_MAX_TEXTURE_LOD_BIAS, {2}},
    {GL_MAX_CUBE_MAP_TEXTURE_SIZE, {16}},
    {GL_MAX_PIXEL_MAP_TABLE, {32}},
    {GL_MAX_NAME_STACK_DEPTH, {64}},
    {GL_MAX_LIST_NESTING, {64}},
    {GL_MAX_EVAL_ORDER, {8}},
    {GL_MAX_VIEWPORT_DIMS, {width_px, height_px}},
    {GL_MAX_ATTRIB_STACK_DEPTH, {16}},
    {GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, {16}},
    {GL_ALIASED_POINT_SIZE_RANGE, {1, 1}},
    {GL_SMOOTH_POINT_SIZE_RANGE, {1, 1}},
    {GL_SMOOTH_POINT_SIZE_GRANULARITY, {0}},
    {GL_ALIASED_LINE_WIDTH_RANGE, {1, 1}},
    {GL_SMOOTH_LINE_WIDTH_RANGE, {1, 1}},
    {GL_SMOOTH_LINE_WIDTH_GRANULARITY, {0}},
    {GL_MAX_ELEMENTS_INDICES, {1}},
    {GL_MAX_ELEMENTS_VERTICES, {1}},
    {GL_MAX_TEXTURE_UNITS, {2}},
    {GL_NUM_COMPRESSED_TEXTURE_FORMATS, {0}},
    {GL_COMPRESSED_TEXTURE_FORMATS, {}},
};

class StateTables : public ::testing::Test {
 protected:
  StateTables() {
    EXPECT_TRUE(context_.set_window_size(width_px, height_px, pipeline::ColorFormat::rgba8));
    make_current(&context_);
  }

 private:
  Context context_{{24, 8, 16}, nullptr};
};

template <class T>
std::vector<T> got(void (*get)(GLenum, T*), GLenum pname, std::size_t count) {
  std::vector<T> values(max_components, T{77});
  get(pname, values.data());
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << std::hex << pname;
  for (std::size_t i = count; i < values.size(); ++i) EXPECT_EQ(values[i], T{77}) << std::hex << pname;
  values.resize(count);
  return values;
}

// Rounded, the nearest integer that there is; colours, normals and depths by the linear map that takes 1 to the largest
// and -1 to the least integer.
GLint as_integer(double value, Meaning meaning) {
  if (meaning == plain) return static_cast<GLint>(std::min(std::floor(value + 0.5), 2147483647.0));
  return static_cast<GLint>(std::nearbyint((4294967295.0 * value - 1.0) / 2.0));
}

TEST_F(StateTables, InitialValuesInFourTypes) {
  for (const auto* table : {&current_values, &vertex_arrays, &transformation, &coloring_and_lighting, &rasterization,
                            &textures, &pixel_operations, &pixels, &evaluators_and_hints, &target}) {
    for (const auto& [pname, values, meaning] : *table) {
      const std::size_t count = values.size();
      const auto booleans = got(glGetBooleanv, pname, count);
      const auto integers = got(glGetIntegerv, pname, count);
      const auto floats = got(glGetFloatv, pname, count);
      const auto doubles = got(glGetDoublev, pname, count);
      for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ(booleans[i], values[i] != 0 ? GL_TRUE : GL_FALSE) << std::hex << pname;
        EXPECT_EQ(integers[i], as_integer(values[i], meaning)) << std::hex << pname;
        EXPECT_EQ(floats[i], static_cast<GLfloat>(values[i])) << std::hex << pname;
        EXPECT_EQ(doubles[i], values[i]) << std::hex << pname;
      }
    }
  }
}

TEST_F(StateTables, LimitsAreNotBelowTheLeast) {
  for (const auto& [pname, values, meaning] : least) {
    std::array<GLdouble, max_components> found{};
    glGetDoublev(pname, found.data());
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << std::hex << pname;
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_GE(found[i], values[i]) << std::hex << pname;
  }
}

TEST_F(StateTables, CapabilitiesAreOffButTwo) {
  for (const GLenum cap : all_capabilities()) {
    const bool on = cap == GL_DITHER || cap == GL_MULTISAMPLE;
    EXPECT_EQ(glIsEnabled(cap), on ? GL_TRUE : GL_FALSE) << std::hex << cap;
    GLint value = 77;
    glGetIntegerv(cap, &value);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << std::hex << cap;
    if (find_array(current_context()->state.vertex_arrays, cap) == nullptr) {
      EXPECT_EQ(value, on ? 1 : 0) << std::hex << cap;
    }
  }
}

// Every cap that the tables of [GL1.5 §6.2] ask IsEnabled for.
TEST_F(StateTables, KnowsEveryCapability) {
  std::vector<GLenum> caps = {GL_NORMALIZE,
                              GL_RESCALE_NORMAL,
                              GL_FOG,
                              GL_COLOR_SUM,
                              GL_LIGHTING,
                              GL_COLOR_MATERIAL,
                              GL_POINT_SMOOTH,
                              GL_LINE_SMOOTH,
                              GL_LINE_STIPPLE,
                              GL_CULL_FACE,
                              GL_POLYGON_SMOOTH,
                              GL_POLYGON_OFFSET_POINT,
                              GL_POLYGON_OFFSET_LINE,
                              GL_POLYGON_OFFSET_FILL,
                              GL_POLYGON_STIPPLE,
                              GL_MULTISAMPLE,
                              GL_SAMPLE_ALPHA_TO_COVERAGE,
                              GL_SAMPLE_ALPHA_TO_ONE,
                              GL_SAMPLE_COVERAGE,
                              GL_TEXTURE_1D,
                              GL_TEXTURE_2D,
                              GL_TEXTURE_3D,
                              GL_TEXTURE_CUBE_MAP,
                              GL_TEXTURE_GEN_S,
                              GL_TEXTURE_GEN_T,
                              GL_TEXTURE_GEN_R,
                              GL_TEXTURE_GEN_Q,
                              GL_SCISSOR_TEST,
                              GL_ALPHA_TEST,
                              GL_STENCIL_TEST,
                              GL_DEPTH_TEST,
                              GL_BLEND,
                              GL_DITHER,
                              GL_INDEX_LOGIC_OP,
                              GL_COLOR_LOGIC_OP,
                              GL_AUTO_NORMAL,
                              GL_VERTEX_ARRAY,
                              GL_NORMAL_ARRAY,
                              GL_FOG_COORD_ARRAY,
                              GL_COLOR_ARRAY,
                              GL_SECONDARY_COLOR_ARRAY,
                              GL_INDEX_ARRAY,
                              GL_TEXTURE_COORD_ARRAY,
                              GL_EDGE_FLAG_ARRAY};
  for (GLenum i = 0; i < 8; ++i) caps.push_back(GL_LIGHT0 + i);
  for (GLenum i = 0; i < 6; ++i) caps.push_back(GL_CLIP_PLANE0 + i);
  for (GLenum i = 0; i < 9; ++i) caps.insert(caps.end(), {GL_MAP1_COLOR_4 + i, GL_MAP2_COLOR_4 + i});
  for (const GLenum cap : caps) {
    glIsEnabled(cap);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << std::hex << cap;
  }
}

TEST_F(StateTables, PointersAreNullAtFirst) {
  for (const GLenum pname :
       {GL_VERTEX_ARRAY_POINTER, GL_NORMAL_ARRAY_POINTER, GL_COLOR_ARRAY_POINTER, GL_INDEX_ARRAY_POINTER,
        GL_TEXTURE_COORD_ARRAY_POINTER, GL_EDGE_FLAG_ARRAY_POINTER, GL_SECONDARY_COLOR_ARRAY_POINTER,
        GL_FOG_COORD_ARRAY_POINTER, GL_FEEDBACK_BUFFER_POINTER, GL_SELECTION_BUFFER_POINTER}) {
    void* pointer = &pointer;
    glGetPointerv(pname, &pointer);
    EXPECT_EQ(pointer, nullptr) << std::hex << pname;
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << std::hex << pname;
  }
}

}  // namespace
}  // namespace gouraud::api
