#include "conformance/stability/off_features.h"

#include <array>
#include <cstdint>

#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

constexpr Four odd_color{0.3f, 0.6f, 0.2f, 0.7f};
constexpr GLenum faces = GL_FRONT_AND_BACK;

void current_values(const GlTable& gl) {
  gl.SecondaryColor3f(0.3f, 0.6f, 0.2f);
  gl.FogCoordf(2.5f);
  gl.EdgeFlag(GL_FALSE);
  for (GLenum unit = 0; unit < 4; ++unit) gl.MultiTexCoord4f(GL_TEXTURE0 + unit, 0.3f, 0.6f, 0.2f, 2.0f);
}

void normal_transformation(const GlTable& gl) {
  gl.Normal3f(0.3f, 0.6f, 0.2f);
  gl.Enable(GL_NORMALIZE);
  gl.Enable(GL_RESCALE_NORMAL);
}

void array_pointers(const GlTable& gl) {
  static const std::array<float, 64> numbers{};
  gl.VertexPointer(3, GL_FLOAT, 16, numbers.data());
  gl.NormalPointer(GL_FLOAT, 16, numbers.data());
  gl.ColorPointer(4, GL_FLOAT, 16, numbers.data());
  gl.SecondaryColorPointer(3, GL_FLOAT, 16, numbers.data());
  gl.FogCoordPointer(GL_FLOAT, 16, numbers.data());
  gl.EdgeFlagPointer(16, numbers.data());
  gl.TexCoordPointer(2, GL_FLOAT, 16, numbers.data());
}

void buffer_objects(const GlTable& gl) {
  static const std::array<float, 64> numbers{};
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  gl.BindBuffer(GL_ARRAY_BUFFER, name);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof numbers, numbers.data(), GL_STATIC_DRAW);
}

void texture_matrices(const GlTable& gl) {
  gl.MatrixMode(GL_TEXTURE);
  gl.Scalef(2, 3, 4);
  gl.MatrixMode(GL_MODELVIEW);
}

void clip_planes(const GlTable& gl) {
  constexpr std::array<double, 4> plane{0.3, 0.6, 0.2, -0.5};
  for (GLenum i = 0; i < 6; ++i) gl.ClipPlane(GL_CLIP_PLANE0 + i, plane.data());
}

void raster_position(const GlTable& gl) { gl.WindowPos3f(3, 4, 0.5f); }

void light_parameters(const GlTable& gl, GLenum name) {
  gl.Lightfv(name, GL_AMBIENT, odd_color.data());
  gl.Lightfv(name, GL_DIFFUSE, odd_color.data());
  gl.Lightfv(name, GL_SPECULAR, odd_color.data());
  gl.Lightfv(name, GL_POSITION, odd_color.data());
  gl.Lightfv(name, GL_SPOT_DIRECTION, odd_color.data());
  gl.Lightf(name, GL_SPOT_CUTOFF, 30);
  gl.Lightf(name, GL_SPOT_EXPONENT, 7);
  gl.Lightf(name, GL_LINEAR_ATTENUATION, 0.5f);
}

template <int number>
void light_parameters_of(const GlTable& gl) {
  light_parameters(gl, GL_LIGHT0 + number);
}

void black_light(const GlTable& gl) {
  constexpr Four black{0, 0, 0, 1};
  for (const GLenum name : {GL_LIGHT1, GL_LIGHT2}) {
    light_parameters(gl, name);
    for (const GLenum color : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) gl.Lightfv(name, color, black.data());
    gl.Enable(name);
  }
}

void lighting(const GlTable& gl) {
  for (GLenum i = 0; i < 8; ++i) {
    light_parameters(gl, GL_LIGHT0 + i);
    gl.Enable(GL_LIGHT0 + i);
  }
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, odd_color.data());
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
  gl.ColorMaterial(GL_FRONT, GL_SPECULAR);
  gl.Enable(GL_COLOR_MATERIAL);
}

void materials(const GlTable& gl) {
  for (const GLenum color : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION}) gl.Materialfv(faces, color, odd_color.data());
  gl.Materialf(faces, GL_SHININESS, 30);
}

void back_material(const GlTable& gl) {
  for (const GLenum color : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION}) gl.Materialfv(GL_BACK, color, odd_color.data());
  gl.Materialf(GL_BACK, GL_SHININESS, 30);
}

void color_material(const GlTable& gl) { gl.ColorMaterial(GL_FRONT, GL_SPECULAR); }

void point_parameters(const GlTable& gl) {
  gl.PointParameterf(GL_POINT_SIZE_MAX, 5);
  gl.PointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 3);
}

void line_stipple(const GlTable& gl) { gl.LineStipple(3, 0x5AC3); }

void polygon_offset(const GlTable& gl) { gl.PolygonOffset(3, 4); }

void polygon_stipple(const GlTable& gl) {
  std::array<std::uint8_t, 128> pattern{};
  for (std::size_t i = 0; i < pattern.size(); ++i) pattern[i] = static_cast<std::uint8_t>(37 * i);
  gl.PolygonStipple(pattern.data());
}

void culling(const GlTable& gl) {
  gl.CullFace(GL_FRONT);
  gl.FrontFace(GL_CW);
}

void pixel_storage(const GlTable& gl) {
  for (const GLenum pname : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_PACK_ROW_LENGTH}) gl.PixelStorei(pname, 3);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

void pixel_transfer(const GlTable& gl) {
  for (const GLenum pname : {GL_RED_SCALE, GL_GREEN_BIAS, GL_DEPTH_SCALE, GL_ALPHA_BIAS}) gl.PixelTransferf(pname, 0.5f);
  gl.PixelTransferi(GL_MAP_COLOR, 1);
  gl.PixelTransferi(GL_INDEX_SHIFT, 2);
  constexpr std::array<float, 4> map{0.1f, 0.7f, 0.3f, 1.0f};
  gl.PixelMapfv(GL_PIXEL_MAP_R_TO_R, 4, map.data());
  gl.PixelZoom(2, -3);
}

void texture_images(const GlTable& gl) {
  constexpr std::array<std::uint8_t, 4 * 16> texels{};
  for (GLenum unit = 0; unit < 4; ++unit) {
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, odd_color.data());
  }
  gl.ActiveTexture(GL_TEXTURE0);
}

void texture_enabled_without_image(const GlTable& gl) { gl.Enable(GL_TEXTURE_2D); }

void texture_environment(const GlTable& gl) {
  for (GLenum unit = 0; unit < 4; ++unit) {
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_INTERPOLATE);
    gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, odd_color.data());
    gl.TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 1.5f);
  }
  gl.ActiveTexture(GL_TEXTURE0);
}

void texture_generation(const GlTable& gl) {
  for (const GLenum coordinate : {GL_S, GL_T, GL_R, GL_Q}) {
    gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    gl.TexGenfv(coordinate, GL_OBJECT_PLANE, odd_color.data());
    gl.TexGenfv(coordinate, GL_EYE_PLANE, odd_color.data());
  }
  for (const GLenum cap : {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q}) gl.Enable(cap);
}

void fog(const GlTable& gl) {
  gl.Fogi(GL_FOG_MODE, GL_LINEAR);
  gl.Fogf(GL_FOG_START, 2);
  gl.Fogf(GL_FOG_END, 7);
  gl.Fogf(GL_FOG_DENSITY, 3);
  gl.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  gl.Fogfv(GL_FOG_COLOR, odd_color.data());
}

void multisampling(const GlTable& gl) {
  gl.Disable(GL_MULTISAMPLE);
  gl.SampleCoverage(0.3f, GL_TRUE);
  for (const GLenum cap : {GL_SAMPLE_COVERAGE, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE}) gl.Enable(cap);
}

void scissor_box(const GlTable& gl) { gl.Scissor(3, 4, 50, 60); }

void scissor_of_everything(const GlTable& gl) {
  gl.Scissor(-5, -5, 5000, 5000);
  gl.Enable(GL_SCISSOR_TEST);
}

void alpha_function(const GlTable& gl) { gl.AlphaFunc(GL_LESS, 0.5f); }

void alpha_test_that_passes(const GlTable& gl) {
  gl.AlphaFunc(GL_ALWAYS, 0.5f);
  gl.Enable(GL_ALPHA_TEST);
}

void stencil(const GlTable& gl) {
  gl.StencilFunc(GL_LESS, 3, 0x0F);
  gl.StencilOp(GL_INCR, GL_INVERT, GL_REPLACE);
  gl.StencilMask(0x3F);
}

void stencil_test_that_does_nothing(const GlTable& gl) {
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  gl.StencilFunc(GL_ALWAYS, 3, 0x0F);
  gl.Enable(GL_STENCIL_TEST);
}

void depth_function(const GlTable& gl) {
  gl.DepthFunc(GL_GEQUAL);
  gl.DepthMask(GL_FALSE);
}

void occlusion_query(const GlTable& gl) {
  GLuint name = 0;
  gl.GenQueries(1, &name);
  gl.BeginQuery(GL_SAMPLES_PASSED, name);
  gl.EndQuery(GL_SAMPLES_PASSED);
}

void blending(const GlTable& gl) {
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_CONSTANT_COLOR, GL_DST_COLOR);
  gl.BlendEquation(GL_FUNC_SUBTRACT);
  gl.BlendColor(0.3f, 0.6f, 0.2f, 0.7f);
}

void blending_that_replaces(const GlTable& gl) {
  gl.BlendFunc(GL_ONE, GL_ZERO);
  gl.Enable(GL_BLEND);
}

void logic_operation(const GlTable& gl) { gl.LogicOp(GL_XOR); }

void copying_logic_operation(const GlTable& gl) {
  gl.LogicOp(GL_COPY);
  gl.Enable(GL_COLOR_LOGIC_OP);
}

void clear_values(const GlTable& gl) {
  gl.ClearAccum(0.3f, 0.6f, 0.2f, 0.7f);
  gl.ClearStencil(3);
  gl.ClearIndex(3);
}

void evaluators(const GlTable& gl) {
  constexpr std::array<float, 3 * 9> points{};
  gl.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 4, points.data());
  gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 3, 3, 0, 1, 9, 3, points.data());
  gl.Map1f(GL_MAP1_COLOR_4, 0, 1, 4, 4, points.data());
  gl.MapGrid1f(5, 0, 1);
  gl.Enable(GL_MAP1_VERTEX_3);
  gl.Enable(GL_MAP2_VERTEX_3);
  gl.Enable(GL_AUTO_NORMAL);
}

void selection_and_feedback(const GlTable& gl) {
  static std::array<GLuint, 64> hits;
  static std::array<GLfloat, 64> values;
  gl.SelectBuffer(64, hits.data());
  gl.FeedbackBuffer(64, GL_4D_COLOR_TEXTURE, values.data());
}

void display_list(const GlTable& gl) {
  gl.NewList(gl.GenLists(1), GL_COMPILE);
  gl.Enable(GL_FOG);
  gl.Begin(GL_LINES);
  gl.Vertex2f(0, 0);
  gl.Vertex2f(1, 1);
  gl.End();
  gl.EndList();
}

void hints(const GlTable& gl) {
  for (const GLenum target : {GL_FOG_HINT, GL_LINE_SMOOTH_HINT, GL_POINT_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT, GL_GENERATE_MIPMAP_HINT}) {
    gl.Hint(target, GL_FASTEST);
  }
}

void attribute_stacks(const GlTable& gl) {
  gl.PushAttrib(GL_ALL_ATTRIB_BITS);
  gl.PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
}

void fog_that_is_on(const GlTable& gl) { gl.Enable(GL_FOG); }
void clip_plane_that_is_on(const GlTable& gl) { gl.Enable(GL_CLIP_PLANE0); }

/// Everything that Enable knows and that is off, on and off again.
void enables(const GlTable& gl) {
  for (const GLenum cap : {GL_COLOR_SUM, GL_FOG, GL_POINT_SMOOTH, GL_LINE_SMOOTH, GL_LINE_STIPPLE, GL_POLYGON_SMOOTH, GL_POLYGON_STIPPLE,
                           GL_POLYGON_OFFSET_FILL, GL_SCISSOR_TEST, GL_ALPHA_TEST, GL_STENCIL_TEST, GL_BLEND, GL_COLOR_LOGIC_OP,
                           GL_CLIP_PLANE0, GL_TEXTURE_2D, GL_CULL_FACE, GL_POINT_SPRITE_ARB}) {
    gl.Enable(cap);
    gl.Disable(cap);
  }
}

}  // namespace

const std::vector<OffFeature>& off_features() {
  static const std::vector<OffFeature> features{
      {"current_values", current_values},
      {"array_pointers", array_pointers},
      {"buffer_objects", buffer_objects},
      {"normal_transformation", normal_transformation, true},
      {"texture_matrices", texture_matrices},
      {"clip_planes", clip_planes},
      {"raster_position", raster_position},
      {"light_1", light_parameters_of<1>},
      {"light_2", light_parameters_of<2>},
      {"light_3", light_parameters_of<3>},
      {"light_4", light_parameters_of<4>},
      {"light_5", light_parameters_of<5>},
      {"light_6", light_parameters_of<6>},
      {"light_7", light_parameters_of<7>},
      {"black_lights", black_light},
      {"lighting", lighting, true},
      {"materials", materials, true},
      {"back_material", back_material},
      {"color_material", color_material},
      {"point_parameters", point_parameters},
      {"line_stipple", line_stipple},
      {"polygon_offset", polygon_offset},
      {"polygon_stipple", polygon_stipple},
      {"culling", culling},
      {"pixel_storage", pixel_storage},
      {"pixel_transfer", pixel_transfer},
      {"texture_images", texture_images},
      {"texture_enabled_without_image", texture_enabled_without_image},
      {"texture_environment", texture_environment},
      {"texture_generation", texture_generation},
      {"fog", fog},
      {"multisampling", multisampling},
      {"scissor_box", scissor_box},
      {"scissor_of_everything", scissor_of_everything},
      {"alpha_function", alpha_function},
      {"alpha_test_that_passes", alpha_test_that_passes},
      {"stencil", stencil},
      {"stencil_test_that_does_nothing", stencil_test_that_does_nothing},
      {"depth_function", depth_function, true},
      {"occlusion_query", occlusion_query},
      {"blending", blending},
      {"blending_that_replaces", blending_that_replaces},
      {"logic_operation", logic_operation},
      {"copying_logic_operation", copying_logic_operation},
      {"clear_values", clear_values},
      {"evaluators", evaluators},
      {"selection_and_feedback", selection_and_feedback},
      {"display_list", display_list},
      {"hints", hints},
      {"attribute_stacks", attribute_stacks},
      {"enables", enables},
      {"on_fog", fog_that_is_on},
      {"on_clip_plane", clip_plane_that_is_on},
  };
  return features;
}

}  // namespace gouraud::conformance
