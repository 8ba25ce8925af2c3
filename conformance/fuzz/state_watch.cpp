// All state that queries give [GL1.5 §6.1, §6.2], each in all types that it can be asked for in.
#include <algorithm>
#include <type_traits>

#include "conformance/fuzz/random_calls.h"

namespace gouraud::conformance {
namespace {

// What the tables of [GL1.5 §6.2] ask glGet for. Left out: sizes of buffers and limits, which may differ.
constexpr GLenum variables[] = {
      GL_CURRENT_COLOR, GL_CURRENT_SECONDARY_COLOR, GL_CURRENT_INDEX, GL_CURRENT_TEXTURE_COORDS, GL_CURRENT_NORMAL,
      GL_CURRENT_FOG_COORD, GL_CURRENT_RASTER_POSITION, GL_CURRENT_RASTER_DISTANCE, GL_CURRENT_RASTER_COLOR,
      GL_CURRENT_RASTER_INDEX, GL_CURRENT_RASTER_TEXTURE_COORDS, GL_CURRENT_RASTER_POSITION_VALID, GL_EDGE_FLAG,
      GL_CLIENT_ACTIVE_TEXTURE, GL_VERTEX_ARRAY_SIZE, GL_VERTEX_ARRAY_TYPE, GL_VERTEX_ARRAY_STRIDE,
      GL_NORMAL_ARRAY_TYPE, GL_NORMAL_ARRAY_STRIDE, GL_FOG_COORD_ARRAY_TYPE, GL_FOG_COORD_ARRAY_STRIDE,
      GL_COLOR_ARRAY_SIZE, GL_COLOR_ARRAY_TYPE, GL_COLOR_ARRAY_STRIDE, GL_SECONDARY_COLOR_ARRAY_SIZE,
      GL_SECONDARY_COLOR_ARRAY_TYPE, GL_SECONDARY_COLOR_ARRAY_STRIDE, GL_INDEX_ARRAY_TYPE, GL_INDEX_ARRAY_STRIDE,
      GL_TEXTURE_COORD_ARRAY_SIZE, GL_TEXTURE_COORD_ARRAY_TYPE, GL_TEXTURE_COORD_ARRAY_STRIDE,
      GL_EDGE_FLAG_ARRAY_STRIDE, GL_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BUFFER_BINDING,
      GL_NORMAL_ARRAY_BUFFER_BINDING, GL_COLOR_ARRAY_BUFFER_BINDING, GL_INDEX_ARRAY_BUFFER_BINDING,
      GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING, GL_EDGE_FLAG_ARRAY_BUFFER_BINDING,
      GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING, GL_FOG_COORD_ARRAY_BUFFER_BINDING, GL_ELEMENT_ARRAY_BUFFER_BINDING,
      GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX, GL_TEXTURE_MATRIX, GL_TRANSPOSE_MODELVIEW_MATRIX,
      GL_TRANSPOSE_PROJECTION_MATRIX, GL_TRANSPOSE_TEXTURE_MATRIX, GL_VIEWPORT, GL_DEPTH_RANGE,
      GL_MODELVIEW_STACK_DEPTH, GL_PROJECTION_STACK_DEPTH, GL_TEXTURE_STACK_DEPTH, GL_MATRIX_MODE, GL_FOG_COLOR,
      GL_FOG_INDEX, GL_FOG_DENSITY, GL_FOG_START, GL_FOG_END, GL_FOG_MODE, GL_FOG_COORD_SRC, GL_SHADE_MODEL,
      GL_COLOR_MATERIAL_PARAMETER, GL_COLOR_MATERIAL_FACE, GL_LIGHT_MODEL_AMBIENT, GL_LIGHT_MODEL_LOCAL_VIEWER,
      GL_LIGHT_MODEL_TWO_SIDE, GL_LIGHT_MODEL_COLOR_CONTROL, GL_POINT_SIZE, GL_POINT_SIZE_MIN,
      GL_POINT_FADE_THRESHOLD_SIZE, GL_POINT_DISTANCE_ATTENUATION, GL_LINE_WIDTH, GL_LINE_STIPPLE_PATTERN,
      GL_LINE_STIPPLE_REPEAT, GL_CULL_FACE_MODE, GL_FRONT_FACE, GL_POLYGON_MODE, GL_POLYGON_OFFSET_FACTOR,
      GL_POLYGON_OFFSET_UNITS, GL_SAMPLE_COVERAGE_VALUE, GL_SAMPLE_COVERAGE_INVERT, GL_TEXTURE_BINDING_1D,
      GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_3D, GL_TEXTURE_BINDING_CUBE_MAP, GL_ACTIVE_TEXTURE, GL_SCISSOR_BOX,
      GL_ALPHA_TEST_FUNC, GL_ALPHA_TEST_REF, GL_STENCIL_FUNC, GL_STENCIL_VALUE_MASK, GL_STENCIL_WRITEMASK,
      GL_INDEX_WRITEMASK, GL_STENCIL_REF, GL_STENCIL_FAIL, GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_PASS_DEPTH_PASS,
      GL_DEPTH_FUNC, GL_BLEND_SRC_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_DST_RGB, GL_BLEND_DST_ALPHA, GL_BLEND_SRC,
      GL_BLEND_DST, GL_BLEND_EQUATION, GL_BLEND_COLOR, GL_LOGIC_OP_MODE, GL_DRAW_BUFFER, GL_COLOR_WRITEMASK,
      GL_DEPTH_WRITEMASK, GL_COLOR_CLEAR_VALUE, GL_INDEX_CLEAR_VALUE, GL_DEPTH_CLEAR_VALUE, GL_STENCIL_CLEAR_VALUE,
      GL_ACCUM_CLEAR_VALUE, GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES,
      GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_ALIGNMENT, GL_PACK_SWAP_BYTES,
      GL_PACK_LSB_FIRST, GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_IMAGES, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS,
      GL_PACK_SKIP_PIXELS, GL_PACK_ALIGNMENT, GL_MAP_COLOR, GL_MAP_STENCIL, GL_INDEX_SHIFT, GL_INDEX_OFFSET,
      GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE, GL_RED_BIAS, GL_GREEN_BIAS,
      GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_DEPTH_BIAS, GL_ZOOM_X, GL_ZOOM_Y, GL_PIXEL_MAP_I_TO_I_SIZE,
      GL_PIXEL_MAP_S_TO_S_SIZE, GL_PIXEL_MAP_I_TO_R_SIZE, GL_PIXEL_MAP_I_TO_G_SIZE, GL_PIXEL_MAP_I_TO_B_SIZE,
      GL_PIXEL_MAP_I_TO_A_SIZE, GL_PIXEL_MAP_R_TO_R_SIZE, GL_PIXEL_MAP_G_TO_G_SIZE, GL_PIXEL_MAP_B_TO_B_SIZE,
      GL_PIXEL_MAP_A_TO_A_SIZE, GL_READ_BUFFER, GL_MAP1_GRID_DOMAIN, GL_MAP2_GRID_DOMAIN, GL_MAP1_GRID_SEGMENTS,
      GL_MAP2_GRID_SEGMENTS, GL_PERSPECTIVE_CORRECTION_HINT, GL_POINT_SMOOTH_HINT, GL_LINE_SMOOTH_HINT,
      GL_POLYGON_SMOOTH_HINT, GL_FOG_HINT, GL_GENERATE_MIPMAP_HINT, GL_TEXTURE_COMPRESSION_HINT, GL_LIST_BASE,
      GL_LIST_INDEX, GL_LIST_MODE, GL_ATTRIB_STACK_DEPTH, GL_CLIENT_ATTRIB_STACK_DEPTH, GL_NAME_STACK_DEPTH,
      GL_RENDER_MODE, GL_SELECTION_BUFFER_SIZE, GL_FEEDBACK_BUFFER_SIZE, GL_FEEDBACK_BUFFER_TYPE, GL_RGBA_MODE,
      GL_INDEX_MODE, GL_DOUBLEBUFFER, GL_STEREO, GL_RED_BITS, GL_GREEN_BITS, GL_BLUE_BITS, GL_ALPHA_BITS,
      GL_INDEX_BITS, GL_DEPTH_BITS, GL_STENCIL_BITS,
};

constexpr GLenum capabilities[] = {
      GL_NORMALIZE, GL_RESCALE_NORMAL, GL_FOG, GL_COLOR_SUM, GL_LIGHTING, GL_COLOR_MATERIAL, GL_POINT_SMOOTH,
      GL_LINE_SMOOTH, GL_LINE_STIPPLE, GL_CULL_FACE, GL_POLYGON_SMOOTH, GL_POLYGON_OFFSET_POINT,
      GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_FILL, GL_POLYGON_STIPPLE, GL_MULTISAMPLE, GL_SAMPLE_ALPHA_TO_COVERAGE,
      GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE, GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP,
      GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q, GL_SCISSOR_TEST, GL_ALPHA_TEST,
      GL_STENCIL_TEST, GL_DEPTH_TEST, GL_BLEND, GL_DITHER, GL_INDEX_LOGIC_OP, GL_COLOR_LOGIC_OP, GL_AUTO_NORMAL,
      GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_FOG_COORD_ARRAY, GL_COLOR_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_INDEX_ARRAY,
      GL_TEXTURE_COORD_ARRAY, GL_EDGE_FLAG_ARRAY,
};

/// What no query gives.
template <class T>
constexpr T untouched = std::is_same_v<T, GLboolean> ? T{77} : std::is_unsigned_v<T> ? static_cast<T>(3131961357u) : static_cast<T>(-77777);

/// The values before the first that the query left alone.
template <class T>
std::vector<double> written(std::span<const T> values) {
  std::vector<double> result;
  for (const T value : values) {
    if (value == untouched<T>) break;
    result.push_back(static_cast<double>(value));
  }
  return result;
}

template <class T, class Query>
std::vector<double> asked(Query query) {
  std::array<T, 40> values;
  values.fill(untouched<T>);
  query(values.data());
  return written<T>(values);
}

}  // namespace

void StateWatch::note(std::uint32_t group, std::uint32_t name, std::span<const double> values) {
  now_.push_back({group, name, {values.begin(), values.end()}});
  if (const GLenum error = gl_.GetError(); error != GL_NO_ERROR) now_.back().values.push_back(-static_cast<double>(error));
}

void StateWatch::read_variables() {
  for (const GLenum name : variables) {
    note(0x1, name, asked<GLfloat>([&](GLfloat* v) { gl_.GetFloatv(name, v); }));
    note(0x2, name, asked<GLint>([&](GLint* v) { gl_.GetIntegerv(name, v); }));
    note(0x3, name, asked<GLdouble>([&](GLdouble* v) { gl_.GetDoublev(name, v); }));
    note(0x4, name, asked<GLboolean>([&](GLboolean* v) { gl_.GetBooleanv(name, v); }));
  }
  const auto note_cap = [&](GLenum cap) {
    const double on = gl_.IsEnabled(cap);
    note(0x5, cap, {&on, 1});
  };
  for (const GLenum cap : capabilities) note_cap(cap);
  for (GLenum i = 0; i < 8; ++i) note_cap(GL_LIGHT0 + i);
  for (GLenum i = 0; i < 6; ++i) note_cap(GL_CLIP_PLANE0 + i);
  for (GLenum i = 0; i < 9; ++i) {
    note_cap(GL_MAP1_COLOR_4 + i);
    note_cap(GL_MAP2_COLOR_4 + i);
  }
  for (GLenum i = 0; i < 6; ++i) note(0x6, i, asked<GLdouble>([&](GLdouble* v) { gl_.GetClipPlane(GL_CLIP_PLANE0 + i, v); }));
}

void StateWatch::read_lighting() {
  for (GLenum light = 0; light < 8; ++light) {
    for (GLenum pname = GL_AMBIENT; pname <= GL_QUADRATIC_ATTENUATION; ++pname) {
      note(0x10 + light, pname, asked<GLfloat>([&](GLfloat* v) { gl_.GetLightfv(GL_LIGHT0 + light, pname, v); }));
      note(0x20 + light, pname, asked<GLint>([&](GLint* v) { gl_.GetLightiv(GL_LIGHT0 + light, pname, v); }));
    }
  }
  for (const GLenum face : {GL_FRONT, GL_BACK}) {
    for (const GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS}) {
      note(face, pname, asked<GLfloat>([&](GLfloat* v) { gl_.GetMaterialfv(face, pname, v); }));
      note(face + 0x10000, pname, asked<GLint>([&](GLint* v) { gl_.GetMaterialiv(face, pname, v); }));
    }
  }
}

void StateWatch::read_textures() {
  for (const GLenum pname : {GL_TEXTURE_ENV_MODE, GL_TEXTURE_ENV_COLOR, GL_COMBINE_RGB, GL_COMBINE_ALPHA, GL_SOURCE0_RGB, GL_SOURCE1_RGB,
                             GL_SOURCE2_RGB, GL_SOURCE0_ALPHA, GL_OPERAND0_RGB, GL_OPERAND2_ALPHA, GL_RGB_SCALE, GL_ALPHA_SCALE}) {
    note(0x30, pname, asked<GLfloat>([&](GLfloat* v) { gl_.GetTexEnvfv(GL_TEXTURE_ENV, pname, v); }));
    note(0x31, pname, asked<GLint>([&](GLint* v) { gl_.GetTexEnviv(GL_TEXTURE_ENV, pname, v); }));
  }
  note(0x32, 0, asked<GLfloat>([&](GLfloat* v) { gl_.GetTexEnvfv(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, v); }));
  for (const GLenum coordinate : {GL_S, GL_T, GL_R, GL_Q}) {
    for (const GLenum pname : {GL_TEXTURE_GEN_MODE, GL_OBJECT_PLANE, GL_EYE_PLANE}) {
      note(coordinate, pname, asked<GLfloat>([&](GLfloat* v) { gl_.GetTexGenfv(coordinate, pname, v); }));
      note(coordinate + 0x10000, pname, asked<GLint>([&](GLint* v) { gl_.GetTexGeniv(coordinate, pname, v); }));
    }
  }
  for (const GLenum target : {GL_TEXTURE_1D, GL_TEXTURE_2D}) {
    for (const GLenum pname : {GL_TEXTURE_BORDER_COLOR, GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T,
                               GL_TEXTURE_WRAP_R, GL_TEXTURE_PRIORITY, GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD, GL_TEXTURE_BASE_LEVEL,
                               GL_TEXTURE_MAX_LEVEL, GL_DEPTH_TEXTURE_MODE, GL_TEXTURE_COMPARE_MODE, GL_TEXTURE_COMPARE_FUNC, GL_GENERATE_MIPMAP}) {
      note(target, pname, asked<GLfloat>([&](GLfloat* v) { gl_.GetTexParameterfv(target, pname, v); }));
      note(target + 0x10000, pname, asked<GLint>([&](GLint* v) { gl_.GetTexParameteriv(target, pname, v); }));
    }
    for (const GLenum pname : {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_BORDER, GL_TEXTURE_INTERNAL_FORMAT, GL_TEXTURE_RED_SIZE,
                               GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_LUMINANCE_SIZE, GL_TEXTURE_DEPTH_SIZE}) {
      std::vector<double> values = asked<GLint>([&](GLint* v) { gl_.GetTexLevelParameteriv(target, 0, pname, v); });
      // How many bits a component has is the library's choice.
      if (pname >= GL_TEXTURE_RED_SIZE && !values.empty()) values[0] = values[0] > 0;
      note(target + 0x20000, pname, values);
    }
  }
  for (const GLenum target : {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER}) {
    for (const GLenum pname : {GL_BUFFER_SIZE, GL_BUFFER_USAGE, GL_BUFFER_ACCESS, GL_BUFFER_MAPPED}) {
      note(target, pname, asked<GLint>([&](GLint* v) { gl_.GetBufferParameteriv(target, pname, v); }));
    }
  }
}

void StateWatch::read_maps() {
  for (GLenum i = 0; i < 9; ++i) {
    for (const GLenum target : {GL_MAP1_COLOR_4 + i, GL_MAP2_COLOR_4 + i}) {
      for (const GLenum query : {GL_ORDER, GL_DOMAIN}) {
        note(target, query, asked<GLdouble>([&](GLdouble* v) { gl_.GetMapdv(target, query, v); }));
      }
      std::array<GLfloat, 4096> points;
      points.fill(untouched<GLfloat>);
      gl_.GetMapfv(target, GL_COEFF, points.data());
      std::vector<double> values = written<GLfloat>(points);
      note(target, GL_COEFF, std::span(values).first(std::min<std::size_t>(values.size(), 24)));
    }
  }
  for (GLenum map = GL_PIXEL_MAP_I_TO_I; map <= GL_PIXEL_MAP_A_TO_A; ++map) {
    note(0x40, map, asked<GLfloat>([&](GLfloat* v) { gl_.GetPixelMapfv(map, v); }));
    note(0x41, map, asked<GLuint>([&](GLuint* v) { gl_.GetPixelMapuiv(map, v); }));
  }
  std::array<GLubyte, 128> stipple{};
  gl_.GetPolygonStipple(stipple.data());
  std::uint32_t hash = 0;
  for (const GLubyte byte : stipple) hash = hash * 31 + byte;
  const double sum = hash;
  note(0x42, 0, {&sum, 1});
}

void StateWatch::read() {
  now_.clear();
  read_variables();
  read_lighting();
  read_textures();
  read_maps();
}

void StateWatch::print_changes() {
  read();
  for (std::size_t i = 0; i < now_.size(); ++i) {
    if (i < before_.size() && before_[i] == now_[i]) continue;
    std::printf("  state 0x%x 0x%x:", now_[i].group, now_[i].name);
    for (const double value : now_[i].values) std::printf(" %.9g", value);
    std::printf("\n");
  }
  before_ = now_;
}

}  // namespace gouraud::conformance
