// The scene lists, one a file, in the order of the specification's sections.
#pragma once

#include "conformance/scenes/scene.h"

namespace gouraud::conformance {

SceneList begin_end_scenes();        // §2.6.1
SceneList large_begin_end_scenes();  // §2.6.1, tens of thousands of vertices
SceneList edge_flag_scenes();        // §2.6.2
SceneList vertex_scenes();           // §2.7
SceneList vertex_array_scenes();     // §2.8
SceneList buffer_object_scenes();    // §2.9
SceneList rectangle_scenes();        // §2.10
SceneList viewport_scenes();         // §2.11.1
SceneList matrix_scenes();           // §2.11.2
SceneList normal_scenes();           // §2.11.3
SceneList clipping_scenes();         // §2.12
SceneList clip_plane_scenes();       // §2.12, the user's planes
SceneList bad_input_scenes();        // §2.12, NaN and infinity
SceneList lighting_scenes();         // §2.14.1, eq 2.1 term by term
SceneList spot_light_scenes();       // §2.14.1, attenuation and spot lights
SceneList light_parameter_scenes();  // §2.14.2
SceneList color_material_scenes();   // §2.14.3
SceneList shading_scenes();          // §2.14.6, §2.14.7
SceneList point_scenes();            // §3.3
SceneList point_size_scenes();       // §3.3
SceneList point_sprite_scenes();       // §3.3
SceneList line_scenes();             // §3.4
SceneList line_width_scenes();       // §3.4.2
SceneList line_stipple_scenes();     // §3.4.2
SceneList polygon_scenes();          // §3.5.1
SceneList polygon_stipple_scenes();  // §3.5.2
SceneList polygon_mode_scenes();     // §3.5.4
SceneList polygon_offset_scenes();   // §3.5.5
SceneList smooth_scenes();           // §3.11, §3.3.1, §3.4.2, §3.5.3
SceneList texture_sampling_scenes();     // §3.8.6 to 3.8.10, 3.8.14
SceneList texture_level_scenes();        // §3.8.6, §3.8.8
SceneList texture_environment_scenes();  // §3.8.13
SceneList texture_image_scenes();    // §3.8.1
SceneList color_sum_scenes();        // §3.9
SceneList secondary_color_scenes();  // §3.9, without lighting
SceneList fog_scenes();              // §3.10
SceneList pixel_scenes();            // §3.6.4, §3.6.5, §3.7, §4.3.3
SceneList scissor_scenes();          // §4.1.2
SceneList alpha_test_scenes();       // §4.1.4
SceneList stencil_scenes();          // §4.1.5
SceneList depth_scenes();            // §4.1.6
SceneList blending_scenes();         // §4.1.8
SceneList logic_op_scenes();         // §4.1.10
SceneList mask_and_clear_scenes();   // §4.2.2, §4.2.3
SceneList evaluator_scenes();        // §5.1
SceneList buffer_scenes();           // §4.2.1, §4.2.3, §4.2.4
SceneList framebuffer_object_scenes();  // §4.2.1, §2.11.1
SceneList multisampling_scenes();       // §3.2.1, §3.3.3, §3.4.4, §3.5.6, §4.1.3
SceneList display_list_scenes();     // §5.4

}  // namespace gouraud::conformance
