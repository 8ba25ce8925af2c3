// For tests: which enums each parameter takes: gl.xml's group, and where that is not what the specification says, what
// is. And which values a parameter takes whose pname is of enums.
#pragma once

#include <algorithm>
#include <set>
#include <sstream>

#include "api/commands/test_model_calls.h"

namespace gouraud::api {

using Enums = std::vector<GLenum>;

inline std::vector<std::string> words(const char* text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

inline const std::set<GLenum>& every_enum() {
  static const std::set<GLenum> values = [] {
    std::set<GLenum> result = {0xBAD, 0x7FFFFFFF, 0xFFFFFFFF};
    for (const EnumRow& row : enum_rows()) result.insert(row.value);
    return result;
  }();
  return values;
}

inline std::set<GLenum> group_members(std::string_view group) {
  std::set<GLenum> result;
  for (const EnumRow& row : enum_rows()) {
    for (const std::string& name : words(row.groups)) {
      if (name == group) result.insert(row.value);
    }
  }
  return result;
}

/// How the enums of a parameter differ from gl.xml's group, all its enums of GL 1.5 and of our extensions.
struct EnumSet {
  const char *commands, *parameter;
  enum class Base { group, nothing } base;
  Enums more, fewer;
  /// Of the set: whether these are taken, another argument decides; see value_sets and the BadValues tests.
  Enums depending;
};

/// `value` follows `before`: these enums are taken, every other is GL_INVALID_ENUM.
struct ValueSet {
  const char* commands;
  std::vector<double> before;
  Enums values;
};

namespace sets {

constexpr auto group = EnumSet::Base::group, nothing = EnumSet::Base::nothing;

constexpr GLenum faces[] = {GL_TEXTURE_CUBE_MAP_POSITIVE_X, GL_TEXTURE_CUBE_MAP_NEGATIVE_X,
                            GL_TEXTURE_CUBE_MAP_POSITIVE_Y, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y,
                            GL_TEXTURE_CUBE_MAP_POSITIVE_Z, GL_TEXTURE_CUBE_MAP_NEGATIVE_Z};

inline Enums joined(Enums a, const Enums& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
inline Enums range(GLenum first, GLenum last) {
  Enums result;
  for (GLenum value = first; value <= last; ++value) result.push_back(value);
  return result;
}
inline Enums with_faces(Enums targets) {
  targets.insert(targets.end(), std::begin(faces), std::end(faces));
  return targets;
}

inline const Enums images_2d = with_faces({GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE_ARB});
inline const Enums packed_types = {GL_UNSIGNED_BYTE_2_3_3_REV,     GL_UNSIGNED_SHORT_5_6_5,
                                   GL_UNSIGNED_SHORT_5_6_5_REV,    GL_UNSIGNED_SHORT_4_4_4_4_REV,
                                   GL_UNSIGNED_SHORT_1_5_5_5_REV,  GL_UNSIGNED_INT_8_8_8_8_REV,
                                   GL_UNSIGNED_INT_2_10_10_10_REV, GL_UNSIGNED_INT_24_8_EXT,
                                   GL_FLOAT_32_UNSIGNED_INT_24_8_REV};
inline const Enums not_formats = {GL_UNSIGNED_SHORT, GL_UNSIGNED_INT, GL_RG_INTEGER};
inline const Enums sizes_of_images = {
    GL_TEXTURE_WIDTH,      GL_TEXTURE_HEIGHT,     GL_TEXTURE_DEPTH,      GL_TEXTURE_INTERNAL_FORMAT,
    GL_TEXTURE_BORDER,     GL_TEXTURE_RED_SIZE,   GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
    GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_STENCIL_SIZE_EXT, GL_TEXTURE_LUMINANCE_SIZE,
    GL_TEXTURE_INTENSITY_SIZE};
inline const Enums plain_formats = {GL_ALPHA,
                                    GL_LUMINANCE,
                                    GL_LUMINANCE_ALPHA,
                                    GL_RGB2_EXT,
                                    GL_COMPRESSED_ALPHA,
                                    GL_COMPRESSED_LUMINANCE,
                                    GL_COMPRESSED_LUMINANCE_ALPHA,
                                    GL_COMPRESSED_INTENSITY,
                                    GL_SLUMINANCE_ALPHA_EXT,
                                    GL_SLUMINANCE8_ALPHA8_EXT,
                                    GL_SLUMINANCE_EXT,
                                    GL_SLUMINANCE8_EXT,
                                    GL_COMPRESSED_SRGB_EXT,
                                    GL_COMPRESSED_SRGB_ALPHA_EXT,
                                    GL_COMPRESSED_SLUMINANCE_EXT,
                                    GL_COMPRESSED_SLUMINANCE_ALPHA_EXT};
// [ARB_texture_rg]: floats are of ARB_texture_float, integers of EXT_texture_integer, and we have neither.
inline const Enums no_texture_formats = {
    GL_STENCIL_INDEX, GL_STENCIL_INDEX1_EXT, GL_STENCIL_INDEX4_EXT, GL_STENCIL_INDEX8_EXT, GL_STENCIL_INDEX16_EXT,
    GL_R16F,          GL_R32F,               GL_RG16F,              GL_RG32F,              GL_R8I,
    GL_R8UI,          GL_R16I,               GL_R16UI,              GL_R32I,               GL_R32UI,
    GL_RG8I,          GL_RG8UI,              GL_RG16I,              GL_RG16UI,             GL_RG32I,
    GL_RG32UI};
inline const Enums s3tc = {GL_COMPRESSED_RGB_S3TC_DXT1_EXT,        GL_COMPRESSED_RGBA_S3TC_DXT1_EXT,
                           GL_COMPRESSED_RGBA_S3TC_DXT3_EXT,       GL_COMPRESSED_RGBA_S3TC_DXT5_EXT,
                           GL_COMPRESSED_SRGB_S3TC_DXT1_EXT,       GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT,
                           GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT, GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT};
inline const Enums combiner_parameters = {GL_COMBINE_RGB,      GL_COMBINE_ALPHA,    GL_SRC0_RGB,       GL_SRC1_RGB,
                                          GL_SRC2_RGB,         GL_SRC0_ALPHA,       GL_SRC1_ALPHA,     GL_SRC2_ALPHA,
                                          GL_OPERAND0_RGB,     GL_OPERAND1_RGB,     GL_OPERAND2_RGB,   GL_OPERAND0_ALPHA,
                                          GL_OPERAND1_ALPHA,   GL_OPERAND2_ALPHA,   GL_RGB_SCALE,      GL_ALPHA_SCALE};

inline const Enums enum_texture_parameters = {GL_TEXTURE_WRAP_S,       GL_TEXTURE_WRAP_T,     GL_TEXTURE_WRAP_R,
                                              GL_TEXTURE_MIN_FILTER,   GL_TEXTURE_MAG_FILTER, GL_DEPTH_TEXTURE_MODE,
                                              GL_TEXTURE_COMPARE_MODE, GL_TEXTURE_COMPARE_FUNC};
inline const Enums scalar_texture_parameters =
    joined(enum_texture_parameters, {GL_TEXTURE_PRIORITY, GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD, GL_TEXTURE_BASE_LEVEL,
                                     GL_TEXTURE_MAX_LEVEL, GL_TEXTURE_LOD_BIAS, GL_GENERATE_MIPMAP,
                                     GL_TEXTURE_MAX_ANISOTROPY_EXT});
inline const Enums more_state = {GL_MULTISAMPLE,
                                 GL_SAMPLE_ALPHA_TO_COVERAGE,
                                 GL_SAMPLE_ALPHA_TO_ONE,
                                 GL_SAMPLE_COVERAGE,
                                 GL_MAX_SAMPLES_EXT,
                                 GL_MAX_SHININESS_NV,
                                 GL_MAX_SPOT_EXPONENT_NV,
                                 GL_TEXTURE_CUBE_MAP,
                                 GL_TEXTURE_CUBE_MAP_SEAMLESS,
                                 GL_TEXTURE_RECTANGLE_ARB,
                                 GL_MAX_RECTANGLE_TEXTURE_SIZE_ARB,
                                 GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT,
                                 GL_CLIENT_ACTIVE_TEXTURE,
                                 GL_MAX_TEXTURE_UNITS,
                                 GL_TRANSPOSE_MODELVIEW_MATRIX,
                                 GL_TRANSPOSE_PROJECTION_MATRIX,
                                 GL_TRANSPOSE_TEXTURE_MATRIX,
                                 GL_POINT_SIZE_MIN,
                                 GL_POINT_SIZE_MAX,
                                 GL_POINT_DISTANCE_ATTENUATION,
                                 GL_POINT_SPRITE_ARB,
                                 GL_FOG_COORD_SRC,
                                 GL_CURRENT_FOG_COORD,
                                 GL_COLOR_SUM,
                                 GL_CURRENT_SECONDARY_COLOR,
                                 GL_FOG_COORD_ARRAY,
                                 GL_FOG_COORD_ARRAY_TYPE,
                                 GL_FOG_COORD_ARRAY_STRIDE,
                                 GL_FOG_COORD_ARRAY_BUFFER_BINDING,
                                 GL_SECONDARY_COLOR_ARRAY,
                                 GL_SECONDARY_COLOR_ARRAY_SIZE,
                                 GL_SECONDARY_COLOR_ARRAY_TYPE,
                                 GL_SECONDARY_COLOR_ARRAY_STRIDE,
                                 GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING,
                                 GL_VERTEX_ARRAY_BUFFER_BINDING,
                                 GL_NORMAL_ARRAY_BUFFER_BINDING,
                                 GL_COLOR_ARRAY_BUFFER_BINDING,
                                 GL_INDEX_ARRAY_BUFFER_BINDING,
                                 GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING,
                                 GL_EDGE_FLAG_ARRAY_BUFFER_BINDING,
                                 GL_PIXEL_PACK_BUFFER_BINDING_ARB,
                                 GL_PIXEL_UNPACK_BUFFER_BINDING_ARB,
                                 GL_ARRAY_ELEMENT_LOCK_FIRST_EXT,
                                 GL_ARRAY_ELEMENT_LOCK_COUNT_EXT,
                                 GL_CLIP_ORIGIN,
                                 GL_CLIP_DEPTH_MODE,
                                 GL_STENCIL_TEST_TWO_SIDE_EXT,
                                 GL_ACTIVE_STENCIL_FACE_EXT,
                                 GL_STENCIL_BACK_FUNC_ATI,
                                 GL_STENCIL_BACK_FAIL_ATI,
                                 GL_STENCIL_BACK_PASS_DEPTH_FAIL_ATI,
                                 GL_STENCIL_BACK_PASS_DEPTH_PASS_ATI,
                                 GL_BLEND_EQUATION_ALPHA_EXT};

}  // namespace sets

inline const std::vector<EnumSet> enum_sets = [] {
  using namespace sets;
  return std::vector<EnumSet>{
      // [GL1.5 §2.8 Table 2.4]
      {"ColorPointer SecondaryColorPointer", "type", group, {GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE}, {}, {}},
      {"IndexPointer", "type", group, {GL_UNSIGNED_BYTE}, {}, {}},
      {"EnableClientState DisableClientState",
       "array",
       nothing,
       {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_INDEX_ARRAY, GL_FOG_COORD_ARRAY,
        GL_EDGE_FLAG_ARRAY, GL_TEXTURE_COORD_ARRAY},
       {},
       {}},
      {"GetPointerv", "pname", group, {GL_FOG_COORD_ARRAY_POINTER, GL_SECONDARY_COLOR_ARRAY_POINTER}, {}, {}},
      // [ARB_pixel_buffer_object]; whether a buffer is bound there, the model call decides.
      {"BindBuffer BufferData BufferSubData GetBufferSubData MapBuffer UnmapBuffer GetBufferParameteriv GetBufferPointerv",
       "target",
       group,
       {GL_PIXEL_PACK_BUFFER_ARB, GL_PIXEL_UNPACK_BUFFER_ARB},
       {},
       {}},
      // [GL1.5 §2.11.4]: GL_SPHERE_MAP is for GL_S and GL_T alone.
      {"TexGend TexGenf TexGeni", "coord", group, {}, {}, {GL_R, GL_Q}},
      {"TexGend TexGenf TexGeni", "pname", group, {}, {GL_OBJECT_PLANE, GL_EYE_PLANE}, {}},
      {"TexGendv TexGenfv TexGeniv", "pname", group, {}, {}, {GL_TEXTURE_GEN_MODE}},
      // [GL1.5 §2.14.2]: the forms of one value take no parameter of more.
      {"Lightf Lighti", "pname", group, {}, {GL_POSITION, GL_SPOT_DIRECTION}, {}},
      {"Lightfv Lightiv GetLightfv GetLightiv", "pname", group, {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}, {}, {}},
      {"LightModelf LightModeli", "pname", group, {}, {GL_LIGHT_MODEL_AMBIENT}, {GL_LIGHT_MODEL_COLOR_CONTROL}},
      {"LightModelfv LightModeliv", "pname", group, {}, {}, {GL_LIGHT_MODEL_COLOR_CONTROL}},
      {"Materialf Materiali", "pname", nothing, {GL_SHININESS}, {}, {}},
      {"GetMaterialfv GetMaterialiv", "pname", group, {}, {GL_AMBIENT_AND_DIFFUSE}, {}},
      {"GetMaterialfv GetMaterialiv", "face", group, {}, {GL_FRONT_AND_BACK}, {}},
      // [GL1.5 §3.3, §3.10]
      {"PointParameterfv PointParameteriv", "pname", group, {GL_POINT_DISTANCE_ATTENUATION}, {}, {}},
      {"Fogf Fogi", "pname", group, {GL_FOG_COORD_SRC}, {GL_FOG_COLOR}, {GL_FOG_MODE, GL_FOG_COORD_SRC}},
      {"Fogfv Fogiv", "pname", group, {GL_FOG_COORD_SRC}, {}, {GL_FOG_MODE, GL_FOG_COORD_SRC}},
      // [GL1.5 §3.6.4, §4.3.2]; types and formats go together [EXT_packed_depth_stencil, GL1.5 Table 3.5].
      {"DrawPixels ReadPixels", "format", group, {}, not_formats, {GL_DEPTH_STENCIL_EXT}},
      {"TexImage1D TexImage2D TexImage3D TexSubImage1D TexSubImage2D TexSubImage3D",
       "format",
       group,
       {},
       joined(not_formats, {GL_STENCIL_INDEX}),
       {GL_DEPTH_STENCIL_EXT}},
      {"GetTexImage",
       "format",
       group,
       {},
       joined(not_formats, {GL_STENCIL_INDEX, GL_COLOR_INDEX}),
       {GL_DEPTH_STENCIL_EXT}},
      {"DrawPixels ReadPixels GetTexImage TexImage1D TexImage2D TexImage3D TexSubImage1D TexSubImage2D TexSubImage3D",
       "type",
       group,
       packed_types,
       {},
       {GL_BITMAP}},
      {"CopyPixels", "type", group, {GL_DEPTH_STENCIL_EXT}, {}, {}},
      // [GL1.5 §3.8.1 to §3.8.4]
      {"TexImage1D", "target", nothing, {GL_TEXTURE_1D, GL_PROXY_TEXTURE_1D}, {}, {}},
      {"TexImage2D",
       "target",
       nothing,
       joined(images_2d, {GL_PROXY_TEXTURE_2D, GL_PROXY_TEXTURE_CUBE_MAP, GL_PROXY_TEXTURE_RECTANGLE_ARB}),
       {},
       {}},
      {"TexImage3D", "target", nothing, {GL_TEXTURE_3D, GL_PROXY_TEXTURE_3D}, {}, {}},
      {"CopyTexImage1D TexSubImage1D CopyTexSubImage1D", "target", nothing, {GL_TEXTURE_1D}, {}, {}},
      {"CopyTexImage2D TexSubImage2D CopyTexSubImage2D CompressedTexSubImage2D", "target", nothing, images_2d, {}, {}},
      {"TexSubImage3D CopyTexSubImage3D", "target", nothing, {GL_TEXTURE_3D}, {}, {}},
      {"CompressedTexImage2D",
       "target",
       nothing,
       with_faces({GL_TEXTURE_2D, GL_PROXY_TEXTURE_2D, GL_PROXY_TEXTURE_CUBE_MAP}),
       {},
       {}},
      {"TexImage1D TexImage2D TexImage3D",
       "internalformat",
       group,
       joined(plain_formats, {1, 2, 3, 4}),
       no_texture_formats,
       {}},
      {"CopyTexImage1D CopyTexImage2D", "internalformat", group, plain_formats, no_texture_formats, {}},
      {"CompressedTexImage2D", "internalformat", nothing, s3tc, {}, {}},
      {"CompressedTexSubImage2D", "format", nothing, s3tc, {}, {}},
      {"BindTexture TexParameterf TexParameterfv TexParameteri TexParameteriv GetTexParameterfv GetTexParameteriv",
       "target",
       nothing,
       {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_RECTANGLE_ARB},
       {},
       {}},
      // [GL1.5 §3.8.4 Table 3.19, §6.1.3, §6.1.4]
      {"GetTexParameterfv GetTexParameteriv",
       "pname",
       group,
       {GL_TEXTURE_MAX_ANISOTROPY_EXT, GL_TEXTURE_LOD_BIAS, GL_DEPTH_TEXTURE_MODE, GL_TEXTURE_COMPARE_MODE,
        GL_TEXTURE_COMPARE_FUNC},
       sizes_of_images,
       {}},
      {"GetTexLevelParameterfv GetTexLevelParameteriv",
       "pname",
       nothing,
       joined(sizes_of_images, {GL_TEXTURE_COMPRESSED, GL_TEXTURE_COMPRESSED_IMAGE_SIZE}),
       {},
       {}},
      {"GetTexLevelParameterfv GetTexLevelParameteriv",
       "target",
       nothing,
       joined(images_2d, {GL_TEXTURE_1D, GL_TEXTURE_3D, GL_PROXY_TEXTURE_1D, GL_PROXY_TEXTURE_2D, GL_PROXY_TEXTURE_3D,
                          GL_PROXY_TEXTURE_CUBE_MAP, GL_PROXY_TEXTURE_RECTANGLE_ARB}),
       {},
       {}},
      {"GetTexImage GetCompressedTexImage",
       "target",
       nothing,
       joined(images_2d, {GL_TEXTURE_1D, GL_TEXTURE_3D}),
       {},
       {}},
      // [GL1.5 §3.8.13]: target and pname go together, and so do pname and value.
      {"TexEnvf TexEnvfv TexEnvi TexEnviv",
       "target",
       group,
       {GL_TEXTURE_FILTER_CONTROL, GL_POINT_SPRITE_ARB},
       {},
       {GL_TEXTURE_ENV, GL_POINT_SPRITE_ARB}},
      {"GetTexEnvfv GetTexEnviv",
       "target",
       group,
       {GL_TEXTURE_FILTER_CONTROL, GL_POINT_SPRITE_ARB},
       {},
       {GL_TEXTURE_FILTER_CONTROL, GL_POINT_SPRITE_ARB}},
      {"TexEnvf TexEnvfv TexEnvi TexEnviv", "pname", nothing, {GL_TEXTURE_LOD_BIAS}, {}, {}},
      {"GetTexEnvfv GetTexEnviv", "pname", group, combiner_parameters, {}, {}},
      {"TexParameterf TexParameteri", "pname", nothing, scalar_texture_parameters, {}, enum_texture_parameters},
      {"TexParameterfv TexParameteriv",
       "pname",
       nothing,
       joined(scalar_texture_parameters, {GL_TEXTURE_BORDER_COLOR}),
       {},
       enum_texture_parameters},
      // [GL1.5 §2.7, §6.1.1]: eight units.
      {"ActiveTexture ClientActiveTexture", "texture", nothing, range(GL_TEXTURE0, GL_TEXTURE7), {}, {}},
      {"MultiTexCoord", "target", nothing, range(GL_TEXTURE0, GL_TEXTURE7), {}, {}},
      // [GL1.5 §6.2]: what gl.xml has no group for.
      {"GetBooleanv GetIntegerv GetInteger64v GetFloatv GetDoublev", "pname", group, more_state, {}, {}},
      // [GL1.5 §4.1.8] [EXT_blend_logic_op]
      {"BlendEquation", "mode", group, {GL_LOGIC_OP}, {}, {}},
      {"BlendFunc", "sfactor", group, {}, {GL_SRC1_ALPHA}, {}},
      {"BlendFunc", "dfactor", group, {}, {GL_SRC1_ALPHA, GL_SRC_ALPHA_SATURATE}, {}},
      {"BlendFuncSeparate", "sfactorRGB", group, {}, {GL_SRC1_ALPHA}, {}},
      {"BlendFuncSeparate", "sfactorAlpha", group, {}, {GL_SRC1_ALPHA}, {}},
      {"BlendFuncSeparate", "dfactorRGB", group, {}, {GL_SRC1_ALPHA, GL_SRC_ALPHA_SATURATE}, {}},
      {"BlendFuncSeparate", "dfactorAlpha", group, {}, {GL_SRC1_ALPHA, GL_SRC_ALPHA_SATURATE}, {}},
      // [GL1.5 §5.1]
      {"Map1d Map1f", "target", nothing, range(GL_MAP1_COLOR_4, GL_MAP1_VERTEX_4), {}, {}},
      {"Map2d Map2f", "target", nothing, range(GL_MAP2_COLOR_4, GL_MAP2_VERTEX_4), {}, {}},
      // [EXT_vertex_array] enables arrays by Enable; further caps of GL 1.4, 1.5 and extensions.
      {"Enable Disable IsEnabled",
       "cap",
       group,
       {GL_FOG_COORD_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_COLOR_SUM, GL_POINT_SPRITE_ARB, GL_STENCIL_TEST_TWO_SIDE_EXT},
       {},
       {}},
  };
}();

inline bool is_multi_tex_coord(std::string_view command) { return command.starts_with("MultiTexCoord"); }

/// The set of a command's parameter; null: gl.xml's group.
inline const EnumSet* find_set(std::string_view command, std::string_view parameter) {
  if (is_multi_tex_coord(command)) command = "MultiTexCoord";
  const auto found = std::find_if(enum_sets.begin(), enum_sets.end(), [&](const EnumSet& set) {
    return set.parameter == parameter && names(set.commands, command);
  });
  return found != enum_sets.end() ? &*found : nullptr;
}

// [GL1.5 §2.11.4, §2.14.1, §3.8.4, §3.8.5, §3.8.13, §3.10]; modes after target and coordinate.
inline const std::vector<ValueSet> value_sets = [] {
  const char* const tex_parameter = "TexParameterf TexParameterfv TexParameteri TexParameteriv";
  const char* const tex_env = "TexEnvf TexEnvfv TexEnvi TexEnviv";
  const char* const tex_gen = "TexGend TexGendv TexGenf TexGenfv TexGeni TexGeniv";
  const char* const fog = "Fogf Fogfv Fogi Fogiv";
  const Enums wraps = {GL_CLAMP, GL_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT,
                       GL_MIRROR_CLAMP_EXT, GL_MIRROR_CLAMP_TO_EDGE_EXT, GL_MIRROR_CLAMP_TO_BORDER_EXT};
  const Enums functions = sets::range(GL_NEVER, GL_ALWAYS), magnifying = {GL_NEAREST, GL_LINEAR};
  const Enums combines = {GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT};
  const Enums sources =
      sets::joined({GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS}, sets::range(GL_TEXTURE0, GL_TEXTURE7));
  const Enums alphas = {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};
  std::vector<ValueSet> rows = {
      {fog, {GL_FOG_MODE}, {GL_LINEAR, GL_EXP, GL_EXP2}},
      {fog, {GL_FOG_COORD_SRC}, {GL_FOG_COORD, GL_FRAGMENT_DEPTH}},
      {"LightModelf LightModelfv LightModeli LightModeliv",
       {GL_LIGHT_MODEL_COLOR_CONTROL},
       {GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR}},
      {tex_parameter, {GL_TEXTURE_2D, GL_TEXTURE_WRAP_S}, wraps},
      {tex_parameter, {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_T}, wraps},
      {tex_parameter, {GL_TEXTURE_3D, GL_TEXTURE_WRAP_R}, wraps},
      {tex_parameter, {GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER}, magnifying},
      {tex_parameter,
       {GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER},
       sets::joined(magnifying, sets::range(GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_LINEAR))},
      {tex_parameter, {GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE}, {GL_LUMINANCE, GL_INTENSITY, GL_ALPHA, GL_RED}},
      {tex_parameter, {GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE}, {GL_NONE, GL_COMPARE_R_TO_TEXTURE}},
      {tex_parameter, {GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC}, functions},
      {tex_env,
       {GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE},
       {GL_MODULATE, GL_DECAL, GL_BLEND, GL_REPLACE, GL_REPLACE_EXT, GL_ADD, GL_COMBINE}},
      {tex_env,
       {GL_TEXTURE_ENV, GL_COMBINE_RGB},
       sets::joined(combines, {GL_DOT3_RGB, GL_DOT3_RGBA, GL_DOT3_RGB_EXT, GL_DOT3_RGBA_EXT})},
      {tex_env, {GL_TEXTURE_ENV, GL_COMBINE_ALPHA}, combines},
  };
  for (const double pname : {GL_SRC0_RGB, GL_SRC1_RGB, GL_SRC2_RGB, GL_SRC0_ALPHA, GL_SRC1_ALPHA, GL_SRC2_ALPHA}) {
    rows.push_back({tex_env, {GL_TEXTURE_ENV, pname}, sources});
  }
  for (const double pname : {GL_OPERAND0_RGB, GL_OPERAND1_RGB, GL_OPERAND2_RGB}) {
    rows.push_back({tex_env, {GL_TEXTURE_ENV, pname}, sets::joined(alphas, {GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR})});
  }
  for (const double pname : {GL_OPERAND0_ALPHA, GL_OPERAND1_ALPHA, GL_OPERAND2_ALPHA}) {
    rows.push_back({tex_env, {GL_TEXTURE_ENV, pname}, alphas});
  }
  for (const double coordinate : {GL_S, GL_T, GL_R, GL_Q}) {
    Enums modes = {GL_OBJECT_LINEAR, GL_EYE_LINEAR};
    if (coordinate != GL_Q) modes = sets::joined(modes, {GL_NORMAL_MAP, GL_REFLECTION_MAP});
    if (coordinate == GL_S || coordinate == GL_T) modes.push_back(GL_SPHERE_MAP);
    rows.push_back({tex_gen, {coordinate, GL_TEXTURE_GEN_MODE}, modes});
  }
  return rows;
}();

}  // namespace gouraud::api
