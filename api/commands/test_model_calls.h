// For tests: for every command of GL 1.0-1.5 that takes more than numbers, calls that the initial state accepts.
#pragma once

#include <GL/gl.h>

#include "api/commands/test_calls.h"

namespace gouraud::api {

inline void bind_buffer_with_data() {
  glBindBuffer(GL_ARRAY_BUFFER, 1);
  glBufferData(GL_ARRAY_BUFFER, 64, nullptr, GL_STATIC_DRAW);
}
inline void map_buffer() {
  bind_buffer_with_data();
  glMapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE);
}
inline void define_textures() {
  glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
}
inline void define_compressed_texture() {
  glTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
}
inline void define_query() {
  glBeginQuery(GL_SAMPLES_PASSED, 1);
  glEndQuery(GL_SAMPLES_PASSED);
}
inline void begin_query() {
  glBeginQuery(GL_SAMPLES_PASSED, 1);
}
inline void open_list() {
  glNewList(1, GL_COMPILE);
}
inline void push_everything() {
  glPushMatrix();
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
}

inline const std::vector<ModelCall> model_calls = {
    {"CullFace", {GL_FRONT}},
    {"FrontFace", {GL_CW}},
    {"Hint", {GL_FOG_HINT, GL_NICEST}},
    {"PolygonMode", {GL_FRONT, GL_LINE}},
    {"Scissor Viewport", {1, 2, 3, 4}},
    {"TexParameterf TexParameterfv TexParameteri TexParameteriv", {GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, 1}},
    {"TexImage1D", {GL_TEXTURE_1D, 0, GL_RGBA, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE}},
    {"TexImage2D", {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE}},
    {"TexImage2D", {GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE}},
    {"TexImage2D", {GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE}},
    {"TexImage3D", {GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE}},
    {"TexSubImage1D", {GL_TEXTURE_1D, 0, 1, 2, GL_RGBA, GL_UNSIGNED_BYTE}, GL_NO_ERROR, define_textures},
    {"TexSubImage2D", {GL_TEXTURE_2D, 0, 1, 1, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE}, GL_NO_ERROR, define_textures},
    {"TexSubImage3D", {GL_TEXTURE_3D, 0, 1, 1, 1, 2, 2, 2, GL_RGBA, GL_FLOAT}, GL_NO_ERROR, define_textures},
    {"CopyTexImage1D", {GL_TEXTURE_1D, 0, GL_RGBA, 0, 0, 4, 0}},
    {"CopyTexImage2D", {GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 0}},
    {"CopyTexSubImage1D", {GL_TEXTURE_1D, 0, 1, 0, 0, 2}, GL_NO_ERROR, define_textures},
    {"CopyTexSubImage2D", {GL_TEXTURE_2D, 0, 1, 1, 0, 0, 2, 2}, GL_NO_ERROR, define_textures},
    {"CopyTexSubImage3D", {GL_TEXTURE_3D, 0, 1, 1, 1, 0, 0, 2, 2}, GL_NO_ERROR, define_textures},
    {"CompressedTexImage1D", {GL_TEXTURE_1D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 0, 8}, GL_INVALID_ENUM},
    {"CompressedTexImage2D", {GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, 0, 8}},
    {"CompressedTexImage3D", {GL_TEXTURE_3D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, 4, 0, 32}, GL_INVALID_ENUM},
    {"CompressedTexSubImage1D", {GL_TEXTURE_1D, 0, 0, 4, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 8}, GL_INVALID_ENUM},
    {"CompressedTexSubImage2D",
     {GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 8},
     GL_NO_ERROR,
     define_compressed_texture},
    {"CompressedTexSubImage3D",
     {GL_TEXTURE_3D, 0, 0, 0, 0, 4, 4, 4, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 32},
     GL_INVALID_ENUM},
    {"GetCompressedTexImage", {GL_TEXTURE_2D, 0}, GL_NO_ERROR, define_compressed_texture},
    {"GetTexImage", {GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE}, GL_NO_ERROR, define_textures},
    {"GetTexParameterfv GetTexParameteriv", {GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD}},
    {"GetTexLevelParameterfv GetTexLevelParameteriv", {GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH}},
    {"BindTexture", {GL_TEXTURE_2D, 1}},
    {"DeleteTextures GenTextures PrioritizeTextures DeleteBuffers GenBuffers DeleteQueries GenQueries", {1}},
    {"AreTexturesResident", {1}, GL_INVALID_VALUE},
    {"TexEnvf TexEnvfv TexEnvi TexEnviv", {GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 1}},
    {"TexGend TexGenf TexGeni", {GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP}},
    {"TexGendv TexGenfv TexGeniv", {GL_S, GL_OBJECT_PLANE}},
    {"GetTexEnvfv GetTexEnviv", {GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE}},
    {"GetTexGendv GetTexGenfv GetTexGeniv", {GL_S, GL_TEXTURE_GEN_MODE}},
    {"DrawBuffer ReadBuffer", {GL_FRONT}},
    {"Clear", {GL_COLOR_BUFFER_BIT}},
    {"Enable Disable IsEnabled", {GL_LIGHTING}},
    {"EnableClientState DisableClientState", {GL_VERTEX_ARRAY}},
    {"BlendFunc", {GL_ONE, GL_ZERO}},
    {"BlendFuncSeparate", {GL_ONE, GL_ZERO, GL_ONE, GL_ZERO}},
    {"BlendEquation", {GL_MIN}},
    {"LogicOp", {GL_XOR}},
    {"StencilFunc", {GL_LESS, 1, 2}},
    {"StencilOp", {GL_ZERO, GL_INVERT, GL_REPLACE}},
    {"DepthFunc", {GL_GREATER}},
    {"AlphaFunc", {GL_LESS, 0.5}},
    {"PixelStorei PixelStoref", {GL_PACK_SKIP_ROWS, 1}},
    {"PixelTransferi PixelTransferf", {GL_RED_BIAS, 1}},
    {"PixelMapfv PixelMapuiv PixelMapusv", {GL_PIXEL_MAP_I_TO_R, 2}},
    {"GetPixelMapfv GetPixelMapuiv GetPixelMapusv", {GL_PIXEL_MAP_I_TO_R}},
    {"ReadPixels", {0, 0, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE}},
    {"DrawPixels", {2, 2, GL_RGBA, GL_UNSIGNED_BYTE}},
    {"CopyPixels", {0, 0, 2, 2, GL_COLOR}},
    {"Bitmap", {8, 8, 0, 0, 1, 1}},
    {"GetBooleanv GetDoublev GetFloatv GetIntegerv", {GL_VIEWPORT}},
    {"GetString", {GL_VERSION}},
    {"GetPointerv", {GL_VERTEX_ARRAY_POINTER}},
    {"NewList", {1, GL_COMPILE}},
    {"EndList", {}, GL_INVALID_OPERATION},
    {"EndList", {}, GL_NO_ERROR, open_list},
    {"CallLists", {1, GL_UNSIGNED_BYTE}},
    {"Begin", {GL_TRIANGLES}},
    {"End", {}, GL_INVALID_OPERATION},
    {"ClipPlane GetClipPlane", {GL_CLIP_PLANE5}},
    {"ColorMaterial", {GL_FRONT, GL_SPECULAR}},
    {"Fogf Fogfv Fogi Fogiv", {GL_FOG_DENSITY, 2}},
    {"Lightf Lightfv Lighti Lightiv", {GL_LIGHT7, GL_SPOT_EXPONENT, 3}},
    {"LightModelf LightModelfv LightModeli LightModeliv", {GL_LIGHT_MODEL_TWO_SIDE, 1}},
    {"Materialf Materialfv Materiali Materialiv", {GL_BACK, GL_SHININESS, 3}},
    {"GetLightfv GetLightiv", {GL_LIGHT7, GL_SPOT_EXPONENT}},
    {"GetMaterialfv GetMaterialiv", {GL_BACK, GL_SHININESS}},
    {"ShadeModel", {GL_FLAT}},
    {"PointParameterf PointParameterfv PointParameteri PointParameteriv", {GL_POINT_SIZE_MIN, 2}},
    {"FeedbackBuffer", {16, GL_3D}},
    {"SelectBuffer", {16}},
    {"RenderMode", {GL_RENDER}},
    {"LoadName PushName PopName", {1}},
    {"Accum", {GL_LOAD, 1}},
    {"PopAttrib PopClientAttrib PopMatrix", {}, GL_STACK_UNDERFLOW},
    {"PopAttrib PopClientAttrib PopMatrix", {}, GL_NO_ERROR, push_everything},
    {"PushAttrib", {GL_ALL_ATTRIB_BITS}},
    {"PushClientAttrib", {GL_CLIENT_ALL_ATTRIB_BITS}},
    {"Map1d Map1f", {GL_MAP1_VERTEX_3, 0, 1, 3, 4}},
    {"Map2d Map2f", {GL_MAP2_VERTEX_3, 0, 1, 3, 4, 0, 1, 12, 4}},
    {"GetMapdv GetMapfv GetMapiv", {GL_MAP1_VERTEX_3, GL_ORDER}},
    {"MapGrid1d MapGrid1f", {4, 0, 1}},
    {"MapGrid2d MapGrid2f", {4, 0, 1, 4, 0, 1}},
    {"EvalMesh1", {GL_LINE, 0, 4}},
    {"EvalMesh2", {GL_FILL, 0, 4, 0, 4}},
    {"Frustum Ortho", {-1, 1, -1, 1, 1, 2}},
    {"MatrixMode", {GL_PROJECTION}},
    {"DrawArrays", {GL_TRIANGLES, 0, 3}},
    {"MultiDrawArrays", {GL_TRIANGLES, 0, 0, 1}},
    {"DrawElements", {GL_TRIANGLES, 3, GL_UNSIGNED_BYTE}},
    {"MultiDrawElements", {GL_TRIANGLES, 0, GL_UNSIGNED_BYTE, 0, 1}},
    {"DrawRangeElements", {GL_TRIANGLES, 0, 3, 3, GL_UNSIGNED_BYTE}},
    {"VertexPointer TexCoordPointer ColorPointer SecondaryColorPointer", {3, GL_FLOAT, 12}},
    {"IndexPointer NormalPointer FogCoordPointer", {GL_FLOAT, 12}},
    {"EdgeFlagPointer", {1}},
    {"InterleavedArrays", {GL_V3F, 12}},
    {"ActiveTexture ClientActiveTexture", {GL_TEXTURE1}},
    {"SampleCoverage", {0.5, 1}},
    {"BeginQuery", {GL_SAMPLES_PASSED, 1}},
    {"EndQuery", {GL_SAMPLES_PASSED}, GL_INVALID_OPERATION},
    {"EndQuery", {GL_SAMPLES_PASSED}, GL_NO_ERROR, begin_query},
    {"GetQueryiv", {GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS}},
    {"GetQueryObjectiv GetQueryObjectuiv", {1, GL_QUERY_RESULT}, GL_INVALID_OPERATION},
    {"GetQueryObjectiv GetQueryObjectuiv", {1, GL_QUERY_RESULT}, GL_INVALID_OPERATION, begin_query},
    {"GetQueryObjectiv GetQueryObjectuiv", {1, GL_QUERY_RESULT}, GL_NO_ERROR, define_query},
    {"BindBuffer", {GL_ARRAY_BUFFER, 1}},
    {"BufferData", {GL_ARRAY_BUFFER, 64, 0, GL_STATIC_DRAW}, GL_INVALID_OPERATION},
    {"BufferData", {GL_ARRAY_BUFFER, 64, 0, GL_STREAM_READ}, GL_NO_ERROR, bind_buffer_with_data},
    {"BufferSubData GetBufferSubData", {GL_ARRAY_BUFFER, 8, 56}, GL_NO_ERROR, bind_buffer_with_data},
    {"BufferSubData GetBufferSubData", {GL_ARRAY_BUFFER, 8, 56}, GL_INVALID_OPERATION, map_buffer},
    {"MapBuffer", {GL_ARRAY_BUFFER, GL_WRITE_ONLY}, GL_NO_ERROR, bind_buffer_with_data},
    {"MapBuffer", {GL_ARRAY_BUFFER, GL_WRITE_ONLY}, GL_INVALID_OPERATION, map_buffer},
    {"UnmapBuffer", {GL_ARRAY_BUFFER}, GL_NO_ERROR, map_buffer},
    {"UnmapBuffer", {GL_ARRAY_BUFFER}, GL_INVALID_OPERATION, bind_buffer_with_data},
    {"GetBufferParameteriv", {GL_ARRAY_BUFFER, GL_BUFFER_SIZE}, GL_NO_ERROR, bind_buffer_with_data},
    {"GetBufferPointerv", {GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER}, GL_NO_ERROR, bind_buffer_with_data},
};

}  // namespace gouraud::api
