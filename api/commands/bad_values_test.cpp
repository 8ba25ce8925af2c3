// Values that a parameter of the right kind may not have, in every command that names such [GL1.5 §2 to §5]: vertices,
// arrays, transformation, lighting, rasterization, tests, evaluators, selection, lists.
#include <gtest/gtest.h>

#include "api/commands/test_error_cases.h"
#include "api/commands/test_model_calls.h"

namespace gouraud::api {
namespace {

constexpr GLenum invalid_enum = GL_INVALID_ENUM, invalid_value = GL_INVALID_VALUE;
constexpr GLenum invalid_operation = GL_INVALID_OPERATION;

TEST(BadValues, OfVertexArraysAndBuffers) {  // [GL1.5 §2.8, §2.9]
  expect_errors({
      {"Begin DrawArrays DrawElements DrawRangeElements MultiDrawArrays MultiDrawElements",
       {GL_POLYGON + 1},
       invalid_enum},
      {"ActiveTexture ClientActiveTexture", {GL_TEXTURE0 + 8}, invalid_enum},
      {"ActiveTexture ClientActiveTexture", {GL_TEXTURE0 - 1}, invalid_enum},
      {"MultiTexCoord1f MultiTexCoord2dv MultiTexCoord3s MultiTexCoord4iv", {GL_TEXTURE0 + 8}, invalid_enum},
      {"VertexPointer", {1, GL_FLOAT, 0}, invalid_value},
      {"VertexPointer TexCoordPointer ColorPointer", {5, GL_FLOAT, 0}, invalid_value},
      {"TexCoordPointer", {0, GL_FLOAT, 0}, invalid_value},
      {"ColorPointer SecondaryColorPointer", {2, GL_FLOAT, 0}, invalid_value},
      {"SecondaryColorPointer", {4, GL_FLOAT, 0}, invalid_value},
      {"VertexPointer TexCoordPointer", {3, GL_BYTE, 0}, invalid_enum},
      {"VertexPointer TexCoordPointer", {3, GL_UNSIGNED_INT, 0}, invalid_enum},
      {"NormalPointer", {GL_UNSIGNED_BYTE, 0}, invalid_enum},
      {"IndexPointer", {GL_UNSIGNED_SHORT, 0}, invalid_enum},
      {"FogCoordPointer", {GL_INT, 0}, invalid_enum},
      {"EnableClientState DisableClientState", {GL_LIGHTING}, invalid_enum},
      {"DrawArrays", {GL_POINTS, -1, 1}, invalid_value},
      {"DrawElements", {GL_POINTS, 1, GL_INT}, invalid_enum},
      {"DrawElements", {GL_POINTS, 1, GL_FLOAT}, invalid_enum},
      {"DrawRangeElements", {GL_POINTS, 2, 1, 1, GL_UNSIGNED_BYTE}, invalid_value},
      {"BufferSubData GetBufferSubData", {GL_ARRAY_BUFFER, 8, 57}, invalid_value, bind_buffer_with_data},
      {"BufferSubData GetBufferSubData", {GL_ARRAY_BUFFER, 65, 0}, invalid_value, bind_buffer_with_data},
      {"BufferSubData GetBufferSubData", {GL_ARRAY_BUFFER, 9e18, 9e18}, invalid_value, bind_buffer_with_data},
      {"BufferSubData GetBufferSubData", {GL_ELEMENT_ARRAY_BUFFER, 0, 0}, invalid_operation, bind_buffer_with_data},
      {"MapBuffer", {GL_ELEMENT_ARRAY_BUFFER, GL_READ_ONLY}, invalid_operation, bind_buffer_with_data},
      {"UnmapBuffer", {GL_ELEMENT_ARRAY_BUFFER}, invalid_operation, map_buffer},
      {"GetBufferParameteriv", {GL_ELEMENT_ARRAY_BUFFER, GL_BUFFER_SIZE}, invalid_operation, map_buffer},
      {"GetBufferPointerv", {GL_ELEMENT_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER}, invalid_operation, map_buffer},
  });
}

void select_with_names() {
  static GLuint buffer[16];
  glSelectBuffer(16, buffer);
  glRenderMode(GL_SELECT);
}
void full_matrix_stack() {
  for (int i = 1; i < max_modelview_stack_depth; ++i) glPushMatrix();
}
void full_attribute_stacks() {
  for (int i = 0; i < max_attrib_stack_depth; ++i) glPushAttrib(0);
  for (int i = 0; i < max_client_attrib_stack_depth; ++i) glPushClientAttrib(0);
}
void full_name_stack() {
  select_with_names();
  for (int i = 0; i < max_name_stack_depth; ++i) glPushName(1);
}
void second_unit() {
  glActiveTexture(GL_TEXTURE1);
}

TEST(BadValues, OfTransformationAndStacks) {  // [GL1.5 §2.11, §2.12, §6.1.14]
  expect_errors({
      {"MatrixMode", {GL_COLOR}, invalid_enum},
      {"Frustum", {-1, 1, -1, 1, 0, 1}, invalid_value},
      {"Frustum", {-1, 1, -1, 1, 1, 0}, invalid_value},
      {"Frustum", {-1, 1, -1, 1, -1, 1}, invalid_value},
      {"Frustum Ortho", {1, 1, -1, 1, 1, 2}, invalid_value},
      {"Frustum Ortho", {-1, 1, 2, 2, 1, 2}, invalid_value},
      {"Frustum Ortho", {-1, 1, -1, 1, 2, 2}, invalid_value},
      {"PushMatrix", {}, GL_STACK_OVERFLOW, full_matrix_stack},
      {"PushAttrib PushClientAttrib", {0}, GL_STACK_OVERFLOW, full_attribute_stacks},
      {"ClipPlane GetClipPlane", {GL_CLIP_PLANE0 + 8}, invalid_enum},
      {"ClipPlane GetClipPlane", {GL_CLIP_PLANE0 - 1}, invalid_enum},
      {"TexGend TexGenf TexGeni", {GL_S, GL_OBJECT_PLANE, 1}, invalid_enum},
      {"TexGend TexGenf TexGeni TexGendv TexGenfv TexGeniv", {GL_S, GL_TEXTURE_GEN_MODE, GL_LINEAR}, invalid_enum},
      {"TexGend TexGenf TexGeni TexGendv TexGenfv TexGeniv", {GL_R, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP}, invalid_enum},
      {"TexGend TexGenf TexGeni TexGendv TexGenfv TexGeniv", {GL_Q, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP}, invalid_enum},
      {"TexGend TexGenf TexGeni TexGendv TexGenfv TexGeniv",
       {GL_Q, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP},
       invalid_enum},
      {"Enable Disable IsEnabled", {GL_LIGHT0 + 8}, invalid_enum},
      {"Enable Disable IsEnabled", {GL_CLIP_PLANE0 + 8}, invalid_enum},
      {"Enable Disable", {GL_FOG_MODE}, invalid_enum},
  });
}

TEST(BadValues, OfLighting) {  // [GL1.5 §2.14]
  expect_errors({
      {"Lightf Lightfv Lighti Lightiv GetLightfv GetLightiv", {GL_LIGHT0 + 8, GL_SPOT_EXPONENT, 1}, invalid_enum},
      {"Lightf Lighti", {GL_LIGHT0, GL_AMBIENT, 1}, invalid_enum},
      {"Lightf Lightfv Lighti Lightiv", {GL_LIGHT0, GL_SPOT_EXPONENT, 129}, invalid_value},
      {"Lightf Lightfv Lighti Lightiv", {GL_LIGHT0, GL_SPOT_EXPONENT, -1}, invalid_value},
      {"Lightf Lightfv Lighti Lightiv", {GL_LIGHT0, GL_SPOT_CUTOFF, 91}, invalid_value},
      {"Lightf Lightfv Lighti Lightiv", {GL_LIGHT0, GL_SPOT_CUTOFF, 181}, invalid_value},
      {"Lightf Lightfv Lighti Lightiv", {GL_LIGHT0, GL_SPOT_CUTOFF, -1}, invalid_value},
      {"Lightf Lightfv Lighti Lightiv", {GL_LIGHT0, GL_CONSTANT_ATTENUATION, -1}, invalid_value},
      {"Lightf Lightfv Lighti Lightiv", {GL_LIGHT0, GL_LINEAR_ATTENUATION, -1}, invalid_value},
      {"Lightf Lightfv Lighti Lightiv", {GL_LIGHT0, GL_QUADRATIC_ATTENUATION, -1}, invalid_value},
      {"LightModelf LightModeli", {GL_LIGHT_MODEL_AMBIENT, 1}, invalid_enum},
      {"LightModelf LightModelfv LightModeli LightModeliv", {GL_LIGHT_MODEL_COLOR_CONTROL, GL_SMOOTH}, invalid_enum},
      {"Materialf Materiali", {GL_FRONT, GL_AMBIENT, 1}, invalid_enum},
      {"Materialf Materialfv Materiali Materialiv", {GL_FRONT, GL_SHININESS, 129}, invalid_value},
      {"Materialf Materialfv Materiali Materialiv", {GL_FRONT, GL_SHININESS, -1}, invalid_value},
      {"GetMaterialfv GetMaterialiv", {GL_FRONT_AND_BACK, GL_AMBIENT}, invalid_enum},
      {"GetMaterialfv GetMaterialiv", {GL_FRONT, GL_AMBIENT_AND_DIFFUSE}, invalid_enum},
      {"ColorMaterial", {GL_FRONT, GL_SHININESS}, invalid_enum},
  });
}

TEST(BadValues, OfRasterization) {  // [GL1.5 §3.3 to §3.5, §3.10]
  expect_errors({
      {"PointSize LineWidth", {0}, invalid_value},
      {"PointSize LineWidth", {-1}, invalid_value},
      {"PointParameterf PointParameteri", {GL_POINT_DISTANCE_ATTENUATION, 1}, invalid_enum},
      {"PointParameterf PointParameterfv PointParameteri PointParameteriv", {GL_POINT_SIZE_MIN, -1}, invalid_value},
      {"PointParameterf PointParameterfv PointParameteri PointParameteriv", {GL_POINT_SIZE_MAX, -1}, invalid_value},
      {"PointParameterf PointParameterfv PointParameteri PointParameteriv",
       {GL_POINT_FADE_THRESHOLD_SIZE, -1},
       invalid_value},
      {"PolygonMode", {GL_FRONT, GL_LINES}, invalid_enum},
      {"Fogf Fogi", {GL_FOG_COLOR, 1}, invalid_enum},
      {"Fogf Fogfv Fogi Fogiv", {GL_FOG_DENSITY, -1}, invalid_value},
      {"Fogf Fogfv Fogi Fogiv", {GL_FOG_MODE, GL_NEAREST}, invalid_enum},
      {"Fogf Fogfv Fogi Fogiv", {GL_FOG_COORD_SRC, GL_FOG}, invalid_enum},
  });
}

TEST(BadValues, OfFragmentsAndBuffers) {  // [GL1.5 §4.1, §4.2]
  expect_errors({
      {"Clear", {1}, invalid_value},
      {"BlendFunc", {GL_ONE, GL_SRC_ALPHA_SATURATE}, invalid_enum},
      {"BlendFuncSeparate", {GL_ONE, GL_SRC_ALPHA_SATURATE, GL_ONE, GL_ONE}, invalid_enum},
      {"BlendFuncSeparate", {GL_ONE, GL_ONE, GL_ONE, GL_SRC_ALPHA_SATURATE}, invalid_enum},
      {"DrawBuffer ReadBuffer", {GL_BACK_RIGHT}, invalid_operation},
      {"DrawBuffer ReadBuffer", {GL_AUX0}, invalid_operation},
      {"ReadBuffer", {GL_FRONT_AND_BACK}, invalid_enum},
      {"BeginQuery", {GL_SAMPLES_PASSED, 0}, invalid_operation},
      {"BeginQuery", {GL_SAMPLES_PASSED, 2}, invalid_operation, begin_query},
      {"DeleteQueries", {-1}, invalid_value},
      {"StencilFunc", {GL_ALWAYS + 1, 0, 0}, invalid_enum},
      {"AlphaFunc DepthFunc", {GL_NEVER - 1}, invalid_enum},
  });
}

TEST(BadValues, OfSpecialFunctions) {  // [GL1.5 §5.1 to §5.4]
  expect_errors({
      {"Map1d Map1f", {GL_MAP1_VERTEX_3, 1, 1, 3, 4}, invalid_value},
      {"Map1d Map1f", {GL_MAP1_VERTEX_3, 0, 1, 2, 4}, invalid_value},
      {"Map1d Map1f", {GL_MAP1_VERTEX_3, 0, 1, 3, 0}, invalid_value},
      {"Map1d Map1f", {GL_MAP1_VERTEX_3, 0, 1, 3, 31}, invalid_value},
      {"Map1d Map1f", {GL_MAP2_VERTEX_3, 0, 1, 3, 4}, invalid_enum},
      {"Map1d Map1f", {GL_MAP1_VERTEX_3, 0, 1, 3, 4}, invalid_operation, second_unit},
      {"Map2d Map2f", {GL_MAP2_VERTEX_3, 1, 1, 3, 4, 0, 1, 12, 4}, invalid_value},
      {"Map2d Map2f", {GL_MAP2_VERTEX_3, 0, 1, 3, 4, 1, 1, 12, 4}, invalid_value},
      {"Map2d Map2f", {GL_MAP2_VERTEX_3, 0, 1, 2, 4, 0, 1, 12, 4}, invalid_value},
      {"Map2d Map2f", {GL_MAP2_VERTEX_3, 0, 1, 3, 4, 0, 1, 2, 4}, invalid_value},
      {"Map2d Map2f", {GL_MAP2_VERTEX_3, 0, 1, 3, 0, 0, 1, 12, 4}, invalid_value},
      {"Map2d Map2f", {GL_MAP2_VERTEX_3, 0, 1, 3, 4, 0, 1, 12, 31}, invalid_value},
      {"Map2d Map2f", {GL_MAP1_VERTEX_3, 0, 1, 3, 4, 0, 1, 12, 4}, invalid_enum},
      {"MapGrid1d MapGrid1f", {0, 0, 1}, invalid_value},
      {"MapGrid2d MapGrid2f", {0, 0, 1, 1, 0, 1}, invalid_value},
      {"MapGrid2d MapGrid2f", {1, 0, 1, -1, 0, 1}, invalid_value},
      {"EvalMesh1", {GL_FILL, 0, 1}, invalid_enum},
      {"RenderMode", {GL_SELECT}, invalid_operation},
      {"RenderMode", {GL_FEEDBACK}, invalid_operation},
      {"SelectBuffer", {1}, invalid_operation, select_with_names},
      {"LoadName", {1}, invalid_operation, select_with_names},
      {"PopName", {}, GL_STACK_UNDERFLOW, select_with_names},
      {"PushName", {1}, GL_STACK_OVERFLOW, full_name_stack},
      {"NewList", {0, GL_COMPILE}, invalid_value},
      {"NewList", {2, GL_COMPILE}, invalid_operation, open_list},
      {"CallLists", {1, GL_DOUBLE}, invalid_enum},
  });
}

}  // namespace
}  // namespace gouraud::api
