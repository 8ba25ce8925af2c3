#include "conformance/fuzz/random_calls.h"

#include <cmath>

namespace gouraud::conformance {
namespace {

using Enums = std::initializer_list<GLenum>;

/// One sequence of calls: the table, and what it is drawn from.
class Fuzzer {
 public:
  Fuzzer(CallLog& log, Random& random) : log_(log), gl_(log.gl), random_(random) {}

  void transformation();
  void lighting();
  void rasterization();
  void textures();
  void texture_images();
  void fragments();
  void pixels();
  void enables();
  void attributes();
  void stacks();
  void arrays();
  void buffers();
  void evaluators();
  void lists();
  void feedback();
  void selection();
  void objects();
  void draw();

 private:
  int below(int count) { return random_.below(count); }
  /// Now and then none of them.
  GLenum one_of(Enums values) {
    if (below(25) == 0) return static_cast<GLenum>(below(2) == 0 ? 0x1000 + below(0x200) : below(16));
    return *(values.begin() + below(static_cast<int>(values.size())));
  }
  GLenum good(Enums values) { return *(values.begin() + below(static_cast<int>(values.size()))); }
  float number() {
    switch (below(6)) {
      case 0: return static_cast<float>(below(5) - 2);
      case 1: return 0.25f * static_cast<float>(below(9));
      case 2: return random_.range(-20, 20);
      default: return random_.range(-1, 1);
    }
  }
  int integer() { return below(8) == 0 ? below(2000) - 1000 : below(12) - 2; }
  GLboolean flag() { return static_cast<GLboolean>(below(2)); }
  const float* floats() {
    for (float& value : floats_) value = number();
    return floats_.data();
  }
  const int* integers() {
    for (int& value : integers_) value = below(4) == 0 ? static_cast<int>(random_.next()) : integer();
    return integers_.data();
  }
  const double* doubles() {
    for (double& value : doubles_) value = number();
    return doubles_.data();
  }
  template <class Command, class... Arguments>
  auto call(const char* name, Command command, const Arguments&... arguments) {
    return log_.call(name, command, std::tuple<Arguments...>(arguments...));
  }
  /// The same with one kind of value of four.
  template <class F, class Fv, class I, class Iv>
  void set(const char* name, F f, Fv fv, I i, Iv iv, GLenum target, GLenum pname, const Enums& values) {
    for (float& value : floats_) value = std::floor(number());  // Mesa cuts off what the specification rounds
    switch (below(5)) {
      case 0: return call(name, f, target, pname, floats_[0]);
      case 1: return call(name, fv, target, pname, static_cast<const float*>(floats_.data()));
      case 2: return call(name, i, target, pname, integer());
      case 3: return call(name, iv, target, pname, integers());
      default: return call(name, i, target, pname, static_cast<int>(one_of(values)));
    }
  }
  GLenum compare() { return one_of({GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS}); }
  GLenum face() { return one_of({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}); }
  GLenum mode() {
    return good({GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON});
  }
  void primitive(GLenum mode);
  void position(const char* name, bool raster);

  CallLog& log_;
  const GlTable& gl_;
  Random& random_;
  static inline std::array<float, 1024> floats_;
  static inline std::array<int, 64> integers_;
  static inline std::array<double, 64> doubles_;
};

void Fuzzer::transformation() {
  switch (below(16)) {
    case 0: return call("MatrixMode", gl_.MatrixMode, one_of({GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}));
    case 1: return call("LoadIdentity", gl_.LoadIdentity);
    case 2: return call("PushMatrix", gl_.PushMatrix);
    case 3: return call("PopMatrix", gl_.PopMatrix);
    case 4: { const float x = number(), y = number(), z = number(); return call("Translatef", gl_.Translatef, x, y, z); }
    case 5: { const float a = 30 * number(), x = number(), y = number(), z = number(); return call("Rotatef", gl_.Rotatef, a, x, y, z); }
    case 6: { const float x = number(), y = number(), z = number(); return call("Scalef", gl_.Scalef, x, y, z); }
    case 7: return call("LoadMatrixf", gl_.LoadMatrixf, floats());
    case 8: return call("MultMatrixd", gl_.MultMatrixd, doubles());
    case 9: return call("LoadTransposeMatrixd", gl_.LoadTransposeMatrixd, doubles());
    case 10: return call("MultTransposeMatrixf", gl_.MultTransposeMatrixf, floats());
    case 11: { const double l = number(), r = number(), n = number(), f = number(); return call("Frustum", gl_.Frustum, l, r, -1.0, 1.5, n, f); }
    case 12: { const double l = number(), r = number(), n = number(), f = number(); return call("Ortho", gl_.Ortho, l, r, -1.0, 1.5, n, f); }
    case 13: { const int x = integer(), y = integer(), w = integer(), h = integer(); return call("Viewport", gl_.Viewport, x, y, w, h); }
    case 14: { const double n = number(), f = number(); return call("DepthRange", gl_.DepthRange, n, f); }
    default: return call("ClipPlane", gl_.ClipPlane, static_cast<GLenum>(GL_CLIP_PLANE0 + below(6)), doubles());
  }
}

void Fuzzer::lighting() {
  const GLenum light = static_cast<GLenum>(GL_LIGHT0 + below(9));
  const GLenum light_pname = one_of({GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_SPOT_DIRECTION, GL_SPOT_EXPONENT, GL_SPOT_CUTOFF,
                                     GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION});
  const GLenum model = one_of({GL_LIGHT_MODEL_AMBIENT, GL_LIGHT_MODEL_LOCAL_VIEWER, GL_LIGHT_MODEL_TWO_SIDE, GL_LIGHT_MODEL_COLOR_CONTROL});
  const GLenum material = one_of({GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS, GL_AMBIENT_AND_DIFFUSE, GL_COLOR_INDEXES});
  switch (below(8)) {
    case 0:
    case 1:  // Mesa takes colours and positions of one number
      if (light_pname <= GL_SPOT_DIRECTION) return below(2) == 0 ? call("Lightfv", gl_.Lightfv, light, light_pname, floats()) : call("Lightiv", gl_.Lightiv, light, light_pname, integers());
      return set("Light", gl_.Lightf, gl_.Lightfv, gl_.Lighti, gl_.Lightiv, light, light_pname, {GL_POSITION});
    case 2: return below(2) == 0 ? call("LightModelfv", gl_.LightModelfv, model, floats()) : call("LightModeliv", gl_.LightModeliv, model, integers());
    case 3:
      if (model == GL_LIGHT_MODEL_AMBIENT) return call("LightModelfv", gl_.LightModelfv, model, floats());
      return call("LightModeli", gl_.LightModeli, model, static_cast<int>(one_of({0, 1, GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR})));
    case 4:
    case 5: {
      const GLenum f = face();
      if (material != GL_SHININESS) return below(2) == 0 ? call("Materialfv", gl_.Materialfv, f, material, floats()) : call("Materialiv", gl_.Materialiv, f, material, integers());
      return set("Material", gl_.Materialf, gl_.Materialfv, gl_.Materiali, gl_.Materialiv, f, material, {GL_AMBIENT});
    }
    case 6: { const GLenum f = face(); return call("ColorMaterial", gl_.ColorMaterial, f, material); }
    default: return call("ShadeModel", gl_.ShadeModel, one_of({GL_FLAT, GL_SMOOTH}));
  }
}

void Fuzzer::rasterization() {
  const GLenum fog = one_of({GL_FOG_MODE, GL_FOG_DENSITY, GL_FOG_START, GL_FOG_END, GL_FOG_COLOR, GL_FOG_INDEX, GL_FOG_COORD_SRC});
  const GLenum point = one_of({GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX, GL_POINT_FADE_THRESHOLD_SIZE, GL_POINT_DISTANCE_ATTENUATION});
  // Mesa takes colours and factors of one number.
  const bool fog_color = fog == GL_FOG_COLOR, factors = point == GL_POINT_DISTANCE_ATTENUATION;
  switch (below(16)) {
    case 0: return call("PointSize", gl_.PointSize, number());
    case 1: return call("LineWidth", gl_.LineWidth, number());
    case 2: { const int factor = integer(); return call("LineStipple", gl_.LineStipple, factor, static_cast<GLushort>(random_.next())); }
    case 3: return call("CullFace", gl_.CullFace, face());
    case 4: return call("FrontFace", gl_.FrontFace, one_of({GL_CW, GL_CCW}));
    case 5: { const GLenum f = face(); return call("PolygonMode", gl_.PolygonMode, f, one_of({GL_POINT, GL_LINE, GL_FILL})); }
    case 6: { const float factor = number(), units = number(); return call("PolygonOffset", gl_.PolygonOffset, factor, units); }
    case 7: return call("PolygonStipple", gl_.PolygonStipple, reinterpret_cast<const GLubyte*>(integers()));
    case 8: return factors ? call("PointParameterfv", gl_.PointParameterfv, point, floats()) : call("PointParameterf", gl_.PointParameterf, point, number());
    case 9: return call("PointParameterfv", gl_.PointParameterfv, point, floats());
    case 10: return factors ? call("PointParameterfv", gl_.PointParameterfv, point, floats()) : call("PointParameteri", gl_.PointParameteri, point, integer());
    case 11: return fog_color ? call("Fogfv", gl_.Fogfv, fog, floats()) : call("Fogf", gl_.Fogf, fog, number());
    case 12: return call("Fogfv", gl_.Fogfv, fog, floats());
    case 13: return call("Fogiv", gl_.Fogiv, fog, integers());
    case 14: return fog_color ? call("Fogiv", gl_.Fogiv, fog, integers()) : call("Fogi", gl_.Fogi, fog, static_cast<int>(one_of({GL_LINEAR, GL_EXP, GL_EXP2, GL_FOG_COORD, GL_FRAGMENT_DEPTH})));
    default: { const GLenum target = one_of({GL_FOG_HINT, GL_LINE_SMOOTH_HINT, GL_PERSPECTIVE_CORRECTION_HINT, GL_GENERATE_MIPMAP_HINT, GL_TEXTURE_COMPRESSION_HINT}); return call("Hint", gl_.Hint, target, one_of({GL_FASTEST, GL_NICEST, GL_DONT_CARE})); }
  }
}

void Fuzzer::textures() {
  const GLenum env = one_of({GL_TEXTURE_ENV_MODE, GL_TEXTURE_ENV_COLOR, GL_COMBINE_RGB, GL_COMBINE_ALPHA, GL_SOURCE0_RGB, GL_SOURCE1_ALPHA, GL_OPERAND0_RGB, GL_OPERAND2_ALPHA, GL_RGB_SCALE, GL_ALPHA_SCALE});
  const Enums env_values{GL_MODULATE, GL_DECAL, GL_REPLACE, GL_BLEND, GL_ADD, GL_COMBINE, GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA, GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT, GL_PRIMARY_COLOR, GL_SRC_COLOR, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_ALPHA, 2, 4};
  const GLenum coordinate = one_of({GL_S, GL_T, GL_R, GL_Q});
  const GLenum parameter = one_of({GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R, GL_TEXTURE_BORDER_COLOR, GL_TEXTURE_PRIORITY, GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD, GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL, GL_DEPTH_TEXTURE_MODE, GL_TEXTURE_COMPARE_MODE, GL_TEXTURE_COMPARE_FUNC, GL_GENERATE_MIPMAP});
  const Enums parameter_values{GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR, GL_CLAMP, GL_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT, GL_LUMINANCE, GL_INTENSITY, GL_ALPHA, GL_NONE, GL_COMPARE_R_TO_TEXTURE, GL_LESS, GL_GEQUAL, 1};
  const GLenum target = one_of({GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP});
  switch (below(8)) {
    case 0:
    case 1:  // Mesa knows more sources than GL 1.5, numbers 0 and 1 among them
      if (env >= GL_SOURCE0_RGB && env <= GL_SOURCE2_ALPHA) return call("TexEnvi", gl_.TexEnvi, GL_TEXTURE_ENV, env, static_cast<int>(good(env_values)));
      if (env == GL_TEXTURE_ENV_COLOR) return call("TexEnvfv", gl_.TexEnvfv, GL_TEXTURE_ENV, env, floats());
      return set("TexEnv", gl_.TexEnvf, gl_.TexEnvfv, gl_.TexEnvi, gl_.TexEnviv, GL_TEXTURE_ENV, env, env_values);
    case 2: return set("TexEnvLodBias", gl_.TexEnvf, gl_.TexEnvfv, gl_.TexEnvi, gl_.TexEnviv, GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, {1});
    case 3: {
      const GLenum pname = one_of({GL_TEXTURE_GEN_MODE, GL_OBJECT_PLANE, GL_EYE_PLANE});
      if (pname != GL_TEXTURE_GEN_MODE) return call("TexGendv", gl_.TexGendv, coordinate, pname, doubles());  // Mesa takes planes of one number
      return set("TexGen", gl_.TexGenf, gl_.TexGenfv, gl_.TexGeni, gl_.TexGeniv, coordinate, pname, {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_REFLECTION_MAP, GL_NORMAL_MAP});
    }
    case 4:
    case 5: return set("TexParameter", gl_.TexParameterf, gl_.TexParameterfv, gl_.TexParameteri, gl_.TexParameteriv, target, parameter, parameter_values);
    case 6: return call("ActiveTexture", gl_.ActiveTexture, static_cast<GLenum>(GL_TEXTURE0 + below(8)));
    default: return call("BindTexture", gl_.BindTexture, target, static_cast<GLenum>(below(5)));
  }
}

void Fuzzer::texture_images() {
  const void* const texels = floats();
  const int internal = static_cast<int>(one_of({GL_RGBA, GL_RGB, GL_LUMINANCE, GL_ALPHA8, GL_INTENSITY, GL_RGB5_A1, GL_LUMINANCE_ALPHA, 1, 2, 3, 4, GL_RGBA16, GL_R3_G3_B2}));
  const GLenum format = one_of({GL_RGBA, GL_RGB, GL_LUMINANCE, GL_BGRA, GL_RED, GL_ALPHA});
  const GLenum type = one_of({GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT_5_6_5, GL_UNSIGNED_INT_8_8_8_8, GL_BYTE, GL_UNSIGNED_SHORT});
  const int level = below(4) == 0 ? integer() : 0, width = 4 << below(3), height = below(4) == 0 ? integer() : 4 << below(3), border = 0;  // Mesa drops borders
  switch (below(6)) {
    case 0:
    case 1: return call("TexImage2D", gl_.TexImage2D, one_of({GL_TEXTURE_2D, GL_PROXY_TEXTURE_2D}), level, internal, width, height, border, format, type, texels);
    case 2: return call("TexImage1D", gl_.TexImage1D, one_of({GL_TEXTURE_1D, GL_PROXY_TEXTURE_1D}), level, internal, width, border, format, type, texels);
    case 3: { const int x = integer(), y = integer(); return call("TexSubImage2D", gl_.TexSubImage2D, one_of({GL_TEXTURE_2D}), level, x, y, below(5), below(5), format, type, texels); }
    case 4: { const int x = integer(), y = integer(); return call("CopyTexImage2D", gl_.CopyTexImage2D, one_of({GL_TEXTURE_2D}), level, static_cast<GLenum>(internal), x, y, width, height, border); }
    default: { const int x = integer(), y = integer(); return call("CopyTexSubImage2D", gl_.CopyTexSubImage2D, one_of({GL_TEXTURE_2D}), level, x, y, 0, 0, below(5), below(5)); }
  }
}

void Fuzzer::fragments() {
  // Mesa takes SRC_ALPHA_SATURATE as a destination factor, too.
  const auto destination = [&] { return good({GL_ZERO, GL_ONE, GL_SRC_COLOR, GL_DST_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_CONSTANT_ALPHA}); };
  const auto factor = [&] { return one_of({GL_ZERO, GL_ONE, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_DST_COLOR, GL_ONE_MINUS_DST_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_ALPHA, GL_SRC_ALPHA_SATURATE}); };
  const auto op = [&] { return one_of({GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP}); };
  const float r = number(), g = number(), b = number(), a = number();
  const int x = integer(), y = integer();
  switch (below(22)) {
    case 0: { const GLenum func = compare(); return call("AlphaFunc", gl_.AlphaFunc, func, r); }
    case 1: { const GLenum func = compare(); return call("StencilFunc", gl_.StencilFunc, func, x, random_.next()); }
    case 2: { const GLenum f = op(), z = op(), p = op(); return call("StencilOp", gl_.StencilOp, f, z, p); }
    case 3: return call("StencilMask", gl_.StencilMask, random_.next());
    case 4: return call("ClearStencil", gl_.ClearStencil, x);
    case 5: return call("DepthFunc", gl_.DepthFunc, compare());
    case 6: return call("DepthMask", gl_.DepthMask, flag());
    case 7: { const GLenum s = factor(), d = destination(); return call("BlendFunc", gl_.BlendFunc, s, d); }
    case 8: { const GLenum s = factor(), d = destination(), sa = factor(), da = destination(); return call("BlendFuncSeparate", gl_.BlendFuncSeparate, s, d, sa, da); }
    case 9: return call("BlendEquation", gl_.BlendEquation, one_of({GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX}));
    case 10: return call("BlendColor", gl_.BlendColor, r, g, b, a);
    case 11: return call("LogicOp", gl_.LogicOp, static_cast<GLenum>(GL_CLEAR + below(17)));
    case 12: { const GLboolean m = flag(), n = flag(); return call("ColorMask", gl_.ColorMask, m, n, n, m); }
    case 13: return call("IndexMask", gl_.IndexMask, random_.next());
    case 14: return call("DrawBuffer", gl_.DrawBuffer, one_of({GL_FRONT, GL_NONE, GL_FRONT_LEFT, GL_BACK, GL_LEFT, GL_FRONT_AND_BACK, GL_AUX0}));
    case 15: return call("ReadBuffer", gl_.ReadBuffer, one_of({GL_FRONT, GL_NONE, GL_FRONT_LEFT, GL_BACK, GL_LEFT, GL_RIGHT, GL_AUX0}));
    case 16: { const int w = integer(), h = integer(); return call("Scissor", gl_.Scissor, x, y, w, h); }
    case 17: return call("ClearColor", gl_.ClearColor, r, g, b, a);
    case 18: return call("ClearDepth", gl_.ClearDepth, static_cast<double>(r));
    case 19: return call("ClearAccum", gl_.ClearAccum, r, g, b, a);
    case 20: return call("ClearIndex", gl_.ClearIndex, static_cast<float>(x));
    default: return call("SampleCoverage", gl_.SampleCoverage, r, flag());
  }
}

void Fuzzer::pixels() {
  const GLenum store = one_of({GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_ALIGNMENT, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES, GL_PACK_ALIGNMENT, GL_PACK_ROW_LENGTH, GL_PACK_SWAP_BYTES});
  const GLenum transfer = one_of({GL_MAP_COLOR, GL_MAP_STENCIL, GL_INDEX_SHIFT, GL_INDEX_OFFSET, GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_DEPTH_SCALE, GL_DEPTH_BIAS});
  const GLenum map = static_cast<GLenum>(GL_PIXEL_MAP_I_TO_I + below(11));
  const int size = below(6) == 0 ? -integer() : 1 << below(4);
  switch (below(7)) {
    case 0: return call("PixelStorei", gl_.PixelStorei, store, below(9));
    case 1: return call("PixelStoref", gl_.PixelStoref, store, 0.5f * static_cast<float>(below(9)));
    case 2: return call("PixelTransferi", gl_.PixelTransferi, transfer, integer());
    case 3: return call("PixelTransferf", gl_.PixelTransferf, transfer, std::floor(number()));
    case 4:  // Mesa keeps entries in [0, 1]; by the specification that happens where they are used
      for (float& value : floats_) value = 0.25f * static_cast<float>(below(5));
      return call("PixelMapfv", gl_.PixelMapfv, map == GL_PIXEL_MAP_S_TO_S ? GL_PIXEL_MAP_R_TO_R : map, size, floats_.data());
    case 5: return call("PixelMapuiv", gl_.PixelMapuiv, map, size < 1 ? size : 1 << below(4), reinterpret_cast<const GLuint*>(integers()));
    default: { const float x = number(), y = number(); return call("PixelZoom", gl_.PixelZoom, x, y); }
  }
}

void Fuzzer::enables() {
  const GLenum cap = one_of({GL_NORMALIZE, GL_RESCALE_NORMAL, GL_FOG, GL_COLOR_SUM, GL_LIGHTING, GL_COLOR_MATERIAL, GL_POINT_SMOOTH, GL_LINE_SMOOTH, GL_LINE_STIPPLE, GL_CULL_FACE, GL_POLYGON_SMOOTH, GL_POLYGON_OFFSET_POINT, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_FILL, GL_POLYGON_STIPPLE, GL_MULTISAMPLE, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE, GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q, GL_SCISSOR_TEST, GL_ALPHA_TEST, GL_STENCIL_TEST, GL_DEPTH_TEST, GL_BLEND, GL_DITHER, GL_INDEX_LOGIC_OP, GL_COLOR_LOGIC_OP, GL_AUTO_NORMAL, GL_LIGHT0, GL_LIGHT3, GL_LIGHT7, GL_CLIP_PLANE0, GL_CLIP_PLANE5, GL_MAP1_VERTEX_3, GL_MAP2_VERTEX_4, GL_MAP1_NORMAL, GL_MAP1_INDEX, GL_VERTEX_ARRAY});
  below(2) == 0 ? call("Enable", gl_.Enable, cap) : call("Disable", gl_.Disable, cap);
}

void Fuzzer::attributes() {
  const float x = number(), y = number(), z = number(), w = number();
  const GLenum unit = static_cast<GLenum>(GL_TEXTURE0 + below(8));  // Mesa takes the name of any unit modulo 8
  switch (below(log_.inside_begin_end ? 11 : 14)) {
    case 0: return call("Color4f", gl_.Color4f, x, y, z, w);
    case 1: return call("Color3iv", gl_.Color3iv, integers());
    case 2: return call("Color4us", gl_.Color4us, static_cast<GLushort>(random_.next()), GLushort{1}, GLushort{65535}, GLushort{0});
    case 3: return call("SecondaryColor3f", gl_.SecondaryColor3f, x, y, z);
    case 4: return call("Normal3f", gl_.Normal3f, x, y, z);
    case 5: return call("Normal3iv", gl_.Normal3iv, integers());
    case 6: return call("FogCoordf", gl_.FogCoordf, x);
    case 7: return call("TexCoord2f", gl_.TexCoord2f, x, y);
    case 8: return call("MultiTexCoord4f", gl_.MultiTexCoord4f, unit, x, y, z, w);
    case 9: return call("EdgeFlag", gl_.EdgeFlag, flag());
    case 10: return call("Indexf", gl_.Indexf, x);
    case 11: return call("RasterPos4f", gl_.RasterPos4f, x, y, z, w);
    case 12: return call("WindowPos3f", gl_.WindowPos3f, 10 * x, 10 * y, z);
    default: return call("RasterPos3iv", gl_.RasterPos3iv, integers());
  }
}

void Fuzzer::stacks() {
  GLint list = 0;
  gl_.GetIntegerv(GL_LIST_INDEX, &list);
  if (list != 0) return;  // see PopAttrib below
  GLint depth = 0;
  gl_.GetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth);
  switch (below(4)) {
    case 0:
      if (depth > 0) return;  // Mesa forgets changes that were made before an inner PushAttrib
      return call("PushAttrib", gl_.PushAttrib, static_cast<GLenum>(below(2) == 0 ? GL_ALL_ATTRIB_BITS : 1u << below(20)));
    case 1: {
      std::array<float, 4> color;
      gl_.GetFloatv(GL_CURRENT_COLOR, color.data());  // else Mesa sets the latest current values after it has restored them
      return call("PopAttrib", gl_.PopAttrib);
    }
    case 2: return call("PushClientAttrib", gl_.PushClientAttrib, static_cast<GLenum>(below(2) == 0 ? GL_CLIENT_ALL_ATTRIB_BITS : 1u << below(3)));
    default: return call("PopClientAttrib", gl_.PopClientAttrib);
  }
}

void Fuzzer::arrays() {
  const void* const data = floats();
  const GLenum type = one_of({GL_FLOAT, GL_DOUBLE, GL_SHORT, GL_INT, GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT});
  const int size = below(6), stride = 4 * below(5);  // Mesa keeps size and type even if the stride is wrong
  switch (below(11)) {
    case 0: return call("VertexPointer", gl_.VertexPointer, size, type, stride, data);
    case 1: return call("NormalPointer", gl_.NormalPointer, type, stride, data);
    case 2: return call("ColorPointer", gl_.ColorPointer, size, type, stride, data);
    case 3: return call("SecondaryColorPointer", gl_.SecondaryColorPointer, size == 4 ? 3 : size, type, stride, data);
    case 4: return call("FogCoordPointer", gl_.FogCoordPointer, type, stride, data);
    case 5: return call("TexCoordPointer", gl_.TexCoordPointer, size, type, stride, data);
    case 6: return call("EdgeFlagPointer", gl_.EdgeFlagPointer, stride, data);
    case 7: return call("IndexPointer", gl_.IndexPointer, type, stride, data);
    case 8: return call("ClientActiveTexture", gl_.ClientActiveTexture, static_cast<GLenum>(GL_TEXTURE0 + below(9)));
    case 9: return call("InterleavedArrays", gl_.InterleavedArrays, static_cast<GLenum>(GL_V2F + below(15)), stride, data);
    default: {
      const GLenum array = one_of({GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_INDEX_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_EDGE_FLAG_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_FOG_COORD_ARRAY});
      return below(2) == 0 ? call("EnableClientState", gl_.EnableClientState, array) : call("DisableClientState", gl_.DisableClientState, array);
    }
  }
}

void Fuzzer::buffers() {
  const GLenum target = one_of({GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER});
  const void* const data = floats();
  const auto size = static_cast<std::int64_t>(below(6) == 0 ? integer() : below(200)), offset = static_cast<std::int64_t>(integer());
  switch (below(6)) {
    case 0:
    case 1: return call("BindBuffer", gl_.BindBuffer, target, static_cast<GLenum>(below(5)));
    case 2: return call("BufferData", gl_.BufferData, target, size, data, one_of({GL_STATIC_DRAW, GL_STREAM_READ, GL_DYNAMIC_COPY}));
    case 3: return call("BufferSubData", gl_.BufferSubData, target, offset, size, data);
    case 4: call("MapBuffer", gl_.MapBuffer, target, one_of({GL_READ_WRITE})); return;
    default: call("UnmapBuffer", gl_.UnmapBuffer, target); return;
  }
}

void Fuzzer::evaluators() {
  const GLenum map = static_cast<GLenum>(below(9));
  const float u1 = number(), u2 = number(), v1 = number(), v2 = number();
  const int order = below(6) == 0 ? integer() : 1 + below(5), stride = below(5) == 0 ? integer() : 4;
  switch (below(5)) {  // no EvalCoord: it changes the current normal and colour of Mesa
    case 0:
    case 1: return call("Map1f", gl_.Map1f, GL_MAP1_COLOR_4 + map, u1, u2, stride, order, floats());
    case 2: return call("Map2f", gl_.Map2f, GL_MAP2_COLOR_4 + map, u1, u2, stride, order, v1, v2, 20, 3, floats());
    case 3: return call("MapGrid1f", gl_.MapGrid1f, integer(), u1, u2);
    default: { const int nu = integer(), nv = integer(); return call("MapGrid2f", gl_.MapGrid2f, nu, u1, u2, nv, v1, v2); }
  }
}

void Fuzzer::lists() {
  const auto name = static_cast<GLenum>(below(6));
  switch (below(8)) {
    case 0: return call("NewList", gl_.NewList, name, one_of({GL_COMPILE}));  // Mesa loses its way in lists that are executed as well
    case 1:
    case 2:
    case 3: return call("EndList", gl_.EndList);
    case 4: return call("CallList", gl_.CallList, name);
    case 5: return call("ListBase", gl_.ListBase, name);
    case 6: return call("DeleteLists", gl_.DeleteLists, name, below(3) - 1);
    default: call("IsList", gl_.IsList, name); return;
  }
}

void Fuzzer::primitive(GLenum mode) {
  log_.inside_begin_end = true;
  call("Begin", gl_.Begin, mode);
  for (int i = below(9); i >= 0; --i) {
    if (below(4) == 0) attributes();
    const float x = random_.range(-1.3f, 1.3f), y = random_.range(-1.3f, 1.3f), z = random_.range(-1.3f, 1.3f);
    call("Vertex3f", gl_.Vertex3f, x, y, z);
  }
  log_.inside_begin_end = false;
  call("End", gl_.End);
}

/// Of points and lines: of polygons Mesa reports the triangles that clipping splits them into, and in strips and loops it
/// lets a line begin where the one before it was clipped. Without textures: it leaves their matrices out while they are off.
void Fuzzer::feedback() {
  static std::array<GLfloat, 4096> buffer;
  buffer.fill(-77777);
  call("ShadeModel", gl_.ShadeModel, GLenum{GL_SMOOTH});  // flat lines of Mesa's are flat if they are clipped
  call("FeedbackBuffer", gl_.FeedbackBuffer, below(6) == 0 ? 1 + below(40) : 4096, good({GL_2D, GL_3D, GL_3D_COLOR}), buffer.data());
  call("RenderMode", gl_.RenderMode, GLenum{GL_FEEDBACK});
  for (int i = below(3); i >= 0; --i) {
    if (below(3) == 0) call("PassThrough", gl_.PassThrough, number());
    primitive(good({GL_POINTS, GL_LINES}));
  }
  call("RenderMode", gl_.RenderMode, GLenum{GL_RENDER});
  for (std::size_t i = 0; i < buffer.size() && buffer[i] != -77777; ++i) std::printf("%s%.6g", i % 16 == 0 ? "\n  values " : " ", static_cast<double>(buffer[i]));
  std::printf("\n");
}

void Fuzzer::selection() {
  static std::array<GLuint, 256> buffer;
  buffer.fill(77777);
  call("SelectBuffer", gl_.SelectBuffer, below(6) == 0 ? 1 + below(12) : 256, buffer.data());
  call("RenderMode", gl_.RenderMode, GLenum{GL_SELECT});
  for (int i = below(8); i >= 0; --i) {
    const auto name = static_cast<GLenum>(below(100));
    switch (below(5)) {
      case 0: call("InitNames", gl_.InitNames); break;
      case 1: call("PushName", gl_.PushName, name); break;
      case 2: call("LoadName", gl_.LoadName, name); break;
      case 3: call("PopName", gl_.PopName); break;
      default: primitive(good({GL_POINTS, GL_LINES}));  // of polygons Mesa reports modes and offsets as well
    }
  }
  call("RenderMode", gl_.RenderMode, GLenum{GL_RENDER});
  std::printf("  hits");
  // Depths are scaled to 32 bits: what is beyond the 20th is rounding.
  for (std::size_t i = 0; i < buffer.size() && buffer[i] != 77777; ++i) std::printf(" %.6g", static_cast<double>(buffer[i]));
  std::printf("\n");
}

void Fuzzer::objects() {
  const auto name = static_cast<GLuint>(below(5));
  switch (below(6)) {
    // No textures are deleted: PopAttrib of Mesa binds them again. No queries: Mesa deletes some while one is active.
    case 0: call("IsQuery", gl_.IsQuery, name); return;
    case 1: return call("DeleteBuffers", gl_.DeleteBuffers, 1, &name);
    case 2: call("IsTexture", gl_.IsTexture, name); return;
    case 3: call("IsBuffer", gl_.IsBuffer, name); return;
    case 4: return call("BeginQuery", gl_.BeginQuery, one_of({GL_SAMPLES_PASSED}), name);
    default: return call("EndQuery", gl_.EndQuery, one_of({GL_SAMPLES_PASSED}));
  }
}

void Fuzzer::draw() {
  switch (below(4)) {
    case 0: return call("Clear", gl_.Clear, static_cast<GLenum>(good({GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT, GL_ACCUM_BUFFER_BIT, 0x4500, 0x10000})));
    case 1: return call("Rectf", gl_.Rectf, -0.5f, number(), 0.5f, number());
    default: return primitive(mode());
  }
}

}  // namespace

void random_call(CallLog& log, Random& random) {
  constexpr std::array<void (Fuzzer::*)(), 18> kinds{
      &Fuzzer::transformation, &Fuzzer::lighting, &Fuzzer::rasterization, &Fuzzer::textures,   &Fuzzer::texture_images, &Fuzzer::fragments,
      &Fuzzer::pixels,         &Fuzzer::enables,  &Fuzzer::attributes,    &Fuzzer::stacks,     &Fuzzer::arrays,         &Fuzzer::buffers,
      &Fuzzer::evaluators,     &Fuzzer::lists,    &Fuzzer::feedback,      &Fuzzer::selection,  &Fuzzer::objects,        &Fuzzer::draw};
  Fuzzer fuzzer(log, random);
  (fuzzer.*kinds[static_cast<std::size_t>(random.below(static_cast<int>(kinds.size())))])();
}

}  // namespace gouraud::conformance
