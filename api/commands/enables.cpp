#include "api/commands/enables.h"

#include "api/commands/lighting.h"
#include "api/commands/texture_targets.h"
#include "api/commands/vertex_arrays.h"

namespace gouraud::api {
namespace {

void set_enabled(Context& context, GLenum cap, bool enabled, const char* command) {
  // choice: the arrays as well, as EXT_vertex_array had it and Mesa has it still.
  if (VertexArray* const array = find_array(context.state.vertex_arrays, cap)) {
    array->enabled = enabled;
    return;
  }
  const Capability capability = find_capability(context.state, cap);
  if (capability.flag == nullptr) return context.record_error(GL_INVALID_ENUM, command, "cap is unknown");
  if (*capability.flag == enabled) return;
  if (cap == GL_COLOR_MATERIAL) sync_color_material(context.state);
  *capability.flag = enabled;
  context.change(capability.dirty);
}

}  // namespace

Capability find_capability(AttributeGroups& groups, GLenum cap) {
  if (cap - GL_LIGHT0 < static_cast<GLenum>(max_lights))
    return {&groups.lighting.lights[cap - GL_LIGHT0].enabled, dirty_lighting};
  if (cap - GL_CLIP_PLANE0 < static_cast<GLenum>(max_clip_planes))
    return {&groups.transform.clip_planes[cap - GL_CLIP_PLANE0].enabled, dirty_transform};
  if (cap - GL_TEXTURE_GEN_S < 4) {
    TextureGenerationUnit& unit = groups.texture_generation.unit[static_cast<std::size_t>(groups.texture.active_unit)];
    return {&unit.coordinate[cap - GL_TEXTURE_GEN_S].enabled, dirty_texture_coordinates};
  }
  if (cap - GL_MAP1_COLOR_4 < map_kinds) return {&groups.eval.map1_enabled[cap - GL_MAP1_COLOR_4], 0};
  if (cap - GL_MAP2_COLOR_4 < map_kinds) return {&groups.eval.map2_enabled[cap - GL_MAP2_COLOR_4], 0};
  if (const auto target = texture_target(cap)) {
    TextureUnit& unit = groups.texture.units[static_cast<std::size_t>(groups.texture.active_unit)];
    return {&unit.enabled[index_of(*target)], dirty_textures};
  }
  switch (cap) {
    case GL_ALPHA_TEST:
      return {&groups.color_buffer.alpha_test_enabled, dirty_raster};
    case GL_AUTO_NORMAL:
      return {&groups.eval.auto_normal_enabled, 0};
    case GL_BLEND:
      return {&groups.color_buffer.blend.enabled, dirty_raster};
    case GL_COLOR_LOGIC_OP:
      return {&groups.color_buffer.logic_op_enabled, dirty_raster};
    case GL_COLOR_MATERIAL:
      return {&groups.lighting.color_material_enabled, dirty_lighting};
    case GL_COLOR_SUM:
      return {&groups.fog.color_sum_enabled, dirty_lighting};
    case GL_CULL_FACE:
      return {&groups.polygon.cull_enabled, dirty_assembly};
    case GL_DEPTH_TEST:
      return {&groups.depth.test_enabled, dirty_raster};
    case GL_DITHER:
      return {&groups.color_buffer.dither_enabled, 0};
    case GL_FOG:
      return {&groups.fog.enabled, dirty_raster};
    case GL_INDEX_LOGIC_OP:
      return {&groups.color_buffer.index_logic_op_enabled, 0};
    case GL_LINE_SMOOTH:
      return {&groups.line.smooth_enabled, dirty_assembly};
    case GL_LINE_STIPPLE:
      return {&groups.line.stipple_enabled, dirty_assembly};
    case GL_POINT_SMOOTH:
      return {&groups.point.smooth_enabled, dirty_assembly};
    case GL_POINT_SPRITE_ARB:
      return {&groups.point.sprite_enabled, dirty_assembly | dirty_textures};
    case GL_POLYGON_OFFSET_FILL:
      return {&groups.polygon.offset_fill_enabled, dirty_assembly};
    case GL_POLYGON_OFFSET_LINE:
      return {&groups.polygon.offset_line_enabled, dirty_assembly};
    case GL_POLYGON_OFFSET_POINT:
      return {&groups.polygon.offset_point_enabled, dirty_assembly};
    case GL_POLYGON_SMOOTH:
      return {&groups.polygon.smooth_enabled, dirty_assembly};
    case GL_POLYGON_STIPPLE:
      return {&groups.polygon.stipple_enabled, dirty_raster};
    case GL_LIGHTING:
      return {&groups.lighting.enabled, dirty_lighting};
    case GL_MULTISAMPLE:
      return {&groups.multisample.enabled, dirty_raster};
    case GL_NORMALIZE:
      return {&groups.transform.normalize_enabled, dirty_transform};
    case GL_RESCALE_NORMAL:
      return {&groups.transform.rescale_normal_enabled, dirty_transform};
    case GL_SAMPLE_ALPHA_TO_COVERAGE:
      return {&groups.multisample.alpha_to_coverage_enabled, dirty_raster};
    case GL_SAMPLE_ALPHA_TO_ONE:
      return {&groups.multisample.alpha_to_one_enabled, dirty_raster};
    case GL_SAMPLE_COVERAGE:
      return {&groups.multisample.coverage_enabled, dirty_raster};
    case GL_SCISSOR_TEST:
      return {&groups.scissor.enabled, dirty_raster};
    case GL_TEXTURE_CUBE_MAP_SEAMLESS:
      return {&groups.texture.seamless_enabled, dirty_textures};
    case GL_STENCIL_TEST:
      return {&groups.stencil.test_enabled, dirty_raster};
    case GL_STENCIL_TEST_TWO_SIDE_EXT:
      return {&groups.stencil.two_side_enabled, dirty_raster};
    default:
      return {};
  }
}

void Enable(Context& context, GLenum cap) {
  set_enabled(context, cap, true, "glEnable");
}

void Disable(Context& context, GLenum cap) {
  set_enabled(context, cap, false, "glDisable");
}

GLboolean IsEnabled(Context& context, GLenum cap) {
  if (const VertexArray* const array = find_array(context.state.vertex_arrays, cap)) return array->enabled;
  const Capability capability = find_capability(context.state, cap);
  if (capability.flag == nullptr) {
    context.record_error(GL_INVALID_ENUM, "glIsEnabled", "cap is unknown");
    return GL_FALSE;
  }
  return *capability.flag ? GL_TRUE : GL_FALSE;
}

}  // namespace gouraud::api
