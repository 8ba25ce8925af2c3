// Values that a parameter of the right kind may not have, in every command of pixels and textures that names such
// [GL1.5 §3.6 to §3.8, §4.3, §6.1.4].
#include <gtest/gtest.h>

#include "api/commands/test_error_cases.h"
#include "api/commands/test_model_calls.h"

namespace gouraud::api {
namespace {

constexpr GLenum invalid_enum = GL_INVALID_ENUM, invalid_value = GL_INVALID_VALUE;
constexpr GLenum invalid_operation = GL_INVALID_OPERATION;

TEST(BadValues, OfPixelModes) {  // [GL1.5 §3.6.1, §3.6.3]
  std::vector<ModelCall> calls;
  for (const GLenum pname :
       {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_ALIGNMENT, GL_PACK_IMAGE_HEIGHT,
        GL_PACK_SKIP_IMAGES, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_ALIGNMENT,
        GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES}) {
    calls.push_back({"PixelStorei PixelStoref", {static_cast<double>(pname), -1}, invalid_value});
  }
  for (const double alignment : {0, 3, 5, 16}) {
    calls.push_back({"PixelStorei PixelStoref", {GL_PACK_ALIGNMENT, alignment}, invalid_value});
    calls.push_back({"PixelStorei PixelStoref", {GL_UNPACK_ALIGNMENT, alignment}, invalid_value});
  }
  for (const double size : {0, 257}) {
    calls.push_back({"PixelMapfv PixelMapuiv PixelMapusv", {GL_PIXEL_MAP_R_TO_R, size}, invalid_value});
  }
  for (const double map : {GL_PIXEL_MAP_I_TO_I, GL_PIXEL_MAP_S_TO_S, GL_PIXEL_MAP_I_TO_R, GL_PIXEL_MAP_I_TO_A}) {
    calls.push_back({"PixelMapfv PixelMapuiv PixelMapusv", {map, 3}, invalid_value});
  }
  expect_errors(calls);
}

TEST(BadValues, OfPixelRectangles) {  // [GL1.5 §3.6.4, §4.3.2]
  expect_errors({
      {"DrawPixels", {1, 1, GL_RGBA, GL_BITMAP}, invalid_enum},
      {"DrawPixels", {1, 1, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5}, invalid_operation},
      {"DrawPixels", {1, 1, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4}, invalid_operation},
      {"DrawPixels", {1, 1, GL_LUMINANCE, GL_UNSIGNED_INT_8_8_8_8_REV}, invalid_operation},
      {"ReadPixels", {0, 0, 1, 1, GL_RGBA, GL_BITMAP}, invalid_enum},
      {"ReadPixels", {0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE_3_3_2}, invalid_operation},
      {"ReadPixels", {0, 0, 1, 1, GL_RGB, GL_UNSIGNED_INT_10_10_10_2}, invalid_operation},
      {"ReadPixels", {0, 0, 1, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE}, invalid_operation},
      {"CopyPixels", {0, 0, 1, 1, GL_RGBA}, invalid_enum},
  });
}

TEST(BadValues, OfTextureImages) {  // [GL1.5 §3.8.1]
  std::vector<ModelCall> calls = {
      {"TexImage1D", {GL_TEXTURE_2D, 0, GL_RGBA, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE}, invalid_enum},
      {"TexImage2D", {GL_TEXTURE_CUBE_MAP, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE}, invalid_enum},
      {"TexImage2D", {GL_TEXTURE_2D, -1, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE}, invalid_value},
      {"TexImage2D", {GL_TEXTURE_2D, 15, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE}, invalid_value},
      {"TexImage2D", {GL_TEXTURE_2D, 0, 0, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE}, invalid_value},
      {"TexImage2D", {GL_TEXTURE_2D, 0, 5, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE}, invalid_value},
      {"TexImage2D", {GL_TEXTURE_2D, 0, 2147483647, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE}, invalid_value},
      {"TexImage2D", {GL_TEXTURE_2D, 0, GL_RGBA, 16385, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE}, invalid_value},
      {"TexImage2D", {GL_TEXTURE_2D, 0, GL_RGBA, 4, 2147483647, 0, GL_RGBA, GL_UNSIGNED_BYTE}, invalid_value},
      {"TexImage2D", {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 2, GL_RGBA, GL_UNSIGNED_BYTE}, invalid_value},
      {"TexImage2D", {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, -1, GL_RGBA, GL_UNSIGNED_BYTE}, invalid_value},
      {"TexImage2D", {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE}, invalid_enum},
      {"TexImage2D", {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_BITMAP}, invalid_enum},
      {"TexImage2D", {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5}, invalid_operation},
      {"TexImage2D", {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_DEPTH_COMPONENT, GL_FLOAT}, invalid_operation},
      {"TexImage2D", {GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 4, 4, 0, GL_RGBA, GL_FLOAT}, invalid_operation},
      {"TexImage2D", {GL_TEXTURE_CUBE_MAP_NEGATIVE_X, 0, GL_RGBA, 4, 2, 0, GL_RGBA, GL_FLOAT}, invalid_value},
      {"TexImage3D",
       {GL_TEXTURE_3D, 0, GL_DEPTH_COMPONENT, 4, 4, 4, 0, GL_DEPTH_COMPONENT, GL_FLOAT},
       invalid_operation},
      {"TexImage3D", {GL_TEXTURE_3D, 12, GL_RGBA, 1, 1, 1, 0, GL_RGBA, GL_FLOAT}, invalid_value},
      {"TexImage3D", {GL_TEXTURE_3D, 0, GL_RGBA, 1, 1, 2049, 0, GL_RGBA, GL_FLOAT}, invalid_value},
  };
  expect_errors(calls);
}

TEST(BadValues, OfPartsAndCopiesOfTextures) {  // [GL1.5 §3.8.2, §3.8.3]
  expect_errors({
      {"TexSubImage1D", {GL_TEXTURE_1D, 0, 0, 2, GL_RGBA, GL_FLOAT}, invalid_operation},
      {"TexSubImage1D", {GL_TEXTURE_1D, 0, -1, 2, GL_RGBA, GL_FLOAT}, invalid_value, define_textures},
      {"TexSubImage1D", {GL_TEXTURE_1D, 0, 3, 2, GL_RGBA, GL_FLOAT}, invalid_value, define_textures},
      {"TexSubImage2D", {GL_TEXTURE_2D, 0, 0, 3, 4, 2, GL_RGBA, GL_FLOAT}, invalid_value, define_textures},
      {"TexSubImage2D",
       {GL_TEXTURE_2D, 0, 2147483647, 0, 2147483647, 2, GL_RGBA, GL_FLOAT},
       invalid_value,
       define_textures},
      {"TexSubImage2D", {GL_TEXTURE_2D, 15, 0, 0, 1, 1, GL_RGBA, GL_FLOAT}, invalid_value, define_textures},
      {"TexSubImage2D",
       {GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4},
       invalid_operation,
       define_textures},
      {"TexSubImage3D", {GL_TEXTURE_3D, 0, 0, 0, 3, 1, 1, 2, GL_RGBA, GL_FLOAT}, invalid_value, define_textures},
      {"CopyTexImage2D", {GL_TEXTURE_2D, 0, 5, 0, 0, 4, 4, 0}, invalid_enum},
      {"CopyTexImage2D", {GL_TEXTURE_2D, 0, 3, 0, 0, 4, 4, 0}, invalid_enum},
      {"CopyTexImage2D", {GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 2}, invalid_value},
      {"CopyTexImage2D", {GL_TEXTURE_2D, -1, GL_RGBA, 0, 0, 4, 4, 0}, invalid_value},
      {"CopyTexImage2D", {GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 0, 0, 4, 2, 0}, invalid_value},
      {"CopyTexImage1D", {GL_TEXTURE_1D, 0, GL_RGBA, 0, 0, 16385, 0}, invalid_value},
      {"CopyTexSubImage1D", {GL_TEXTURE_1D, 0, 3, 0, 0, 2}, invalid_value, define_textures},
      {"CopyTexSubImage2D", {GL_TEXTURE_2D, 0, 0, -1, 0, 0, 2, 2}, invalid_value, define_textures},
      {"CopyTexSubImage2D", {GL_TEXTURE_2D, 1, 0, 0, 0, 0, 1, 1}, invalid_operation, define_textures},
      {"CopyTexSubImage3D", {GL_TEXTURE_3D, 0, 0, 0, 4, 0, 0, 1, 1}, invalid_value, define_textures},
      {"CompressedTexImage2D", {GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, 0, 7}, invalid_value},
      {"CompressedTexImage2D", {GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB, 4, 4, 0, 8}, invalid_enum},
      {"CompressedTexSubImage2D",
       {GL_TEXTURE_2D, 0, 1, 0, 2, 4, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 8},
       invalid_operation,
       define_compressed_texture},
      {"CompressedTexSubImage2D",
       {GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 16},
       invalid_operation,
       define_compressed_texture},
      {"GetCompressedTexImage", {GL_TEXTURE_2D, 0}, invalid_operation, define_textures},
      {"GetTexImage", {GL_TEXTURE_2D, 0, GL_COLOR_INDEX, GL_FLOAT}, invalid_enum, define_textures},
      {"GetTexImage", {GL_TEXTURE_2D, 15, GL_RGBA, GL_FLOAT}, invalid_value, define_textures},
      {"GetTexImage", {GL_TEXTURE_CUBE_MAP, 0, GL_RGBA, GL_FLOAT}, invalid_enum},
      {"GetTexLevelParameterfv GetTexLevelParameteriv", {GL_TEXTURE_2D, 15, GL_TEXTURE_WIDTH}, invalid_value},
      {"GetTexLevelParameterfv GetTexLevelParameteriv", {GL_TEXTURE_2D, -1, GL_TEXTURE_WIDTH}, invalid_value},
  });
}

void bind_1d() {
  glBindTexture(GL_TEXTURE_1D, 1);
}

TEST(BadValues, OfTextureParameters) {  // [GL1.5 §3.8.4, §3.8.12]
  std::vector<ModelCall> calls = {
      {"TexParameterf TexParameteri", {GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 1}, invalid_enum},
      {"BindTexture", {GL_TEXTURE_2D, 1}, invalid_operation, bind_1d},
      {"BindTexture", {GL_PROXY_TEXTURE_2D, 1}, invalid_enum},
      {"TexParameteri GetTexParameterfv", {GL_PROXY_TEXTURE_2D, GL_TEXTURE_MIN_LOD, 1}, invalid_enum},
      {"TexParameteri", {GL_TEXTURE_2D, GL_TEXTURE_RESIDENT, 1}, invalid_enum},
  };
  const struct {
    double pname, value;
    GLenum error;
  } parameters[] = {
      {GL_TEXTURE_WRAP_S, GL_LINEAR, invalid_enum},
      {GL_TEXTURE_WRAP_T, GL_LINEAR, invalid_enum},
      {GL_TEXTURE_WRAP_R, GL_LINEAR, invalid_enum},
      {GL_TEXTURE_MIN_FILTER, GL_REPEAT, invalid_enum},
      {GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR, invalid_enum},
      {GL_DEPTH_TEXTURE_MODE, GL_RGBA, invalid_enum},
      {GL_TEXTURE_COMPARE_MODE, GL_LEQUAL, invalid_enum},
      {GL_TEXTURE_COMPARE_FUNC, GL_NONE, invalid_enum},
      {GL_TEXTURE_BASE_LEVEL, -1, invalid_value},
      {GL_TEXTURE_MAX_LEVEL, -1, invalid_value},
      {GL_TEXTURE_MAX_ANISOTROPY_EXT, 0, invalid_value},
  };
  for (const auto& [pname, value, error] : parameters) {
    calls.push_back(
        {"TexParameterf TexParameterfv TexParameteri TexParameteriv", {GL_TEXTURE_2D, pname, value}, error});
  }
  expect_errors(calls);
}

TEST(BadValues, OfTextureEnvironment) {  // [GL1.5 §3.8.13]
  std::vector<ModelCall> calls = {
      {"TexEnvf TexEnvi", {GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 1}, invalid_enum},
      {"TexEnvi GetTexEnviv", {GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_ENV_MODE, GL_ADD}, invalid_enum},
      {"TexEnvi GetTexEnviv", {GL_TEXTURE_ENV, GL_TEXTURE_LOD_BIAS, 0}, invalid_enum},
      {"TexEnvi GetTexEnviv", {GL_TEXTURE_ENV, GL_COORD_REPLACE_ARB, 0}, invalid_enum},
  };
  const struct {
    double pname, value;
    GLenum error;
  } parameters[] = {
      {GL_TEXTURE_ENV_MODE, GL_LINEAR, invalid_enum},
      {GL_COMBINE_RGB, GL_DECAL, invalid_enum},
      {GL_COMBINE_ALPHA, GL_DOT3_RGB, invalid_enum},
      {GL_SRC0_RGB, GL_TEXTURE_2D, invalid_enum},
      {GL_SRC1_ALPHA, GL_TEXTURE0 + 8, invalid_enum},
      {GL_OPERAND0_RGB, GL_DST_COLOR, invalid_enum},
      {GL_OPERAND2_ALPHA, GL_SRC_COLOR, invalid_enum},
      {GL_RGB_SCALE, 3, invalid_value},
      {GL_ALPHA_SCALE, 0, invalid_value},
  };
  for (const auto& [pname, value, error] : parameters) {
    calls.push_back({"TexEnvf TexEnvfv TexEnvi TexEnviv", {GL_TEXTURE_ENV, pname, value}, error});
  }
  expect_errors(calls);
}

}  // namespace
}  // namespace gouraud::api
