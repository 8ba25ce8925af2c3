#include "conformance/scenes/scene_lists.h"

namespace gouraud::conformance {

const std::vector<Scene>& all_scenes() {
  static const std::vector<Scene> scenes = [] {
    std::vector<Scene> all;
    for (const auto list :
         {begin_end_scenes,       large_begin_end_scenes, edge_flag_scenes, vertex_scenes,    vertex_array_scenes, buffer_object_scenes,
          rectangle_scenes, viewport_scenes, matrix_scenes,
          normal_scenes,          clipping_scenes, clip_plane_scenes,        bad_input_scenes, lighting_scenes, spot_light_scenes,
          light_parameter_scenes, color_material_scenes,  shading_scenes,   point_scenes, point_size_scenes, point_sprite_scenes, line_scenes, line_width_scenes, line_stipple_scenes,
          polygon_scenes,         polygon_stipple_scenes, polygon_mode_scenes, polygon_offset_scenes, smooth_scenes, texture_sampling_scenes, texture_level_scenes, texture_environment_scenes,
          texture_image_scenes, color_sum_scenes, secondary_color_scenes, fog_scenes, pixel_scenes, scissor_scenes,  alpha_test_scenes,
          stencil_scenes, depth_scenes,           blending_scenes,        logic_op_scenes,  mask_and_clear_scenes, buffer_scenes, framebuffer_object_scenes, multisampling_scenes, evaluator_scenes, display_list_scenes}) {
      for (const Scene& scene : list()) all.push_back(scene);
    }
    return all;
  }();
  return scenes;
}

}  // namespace gouraud::conformance
