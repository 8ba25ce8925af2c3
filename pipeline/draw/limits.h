// Sizes that the pipeline's data headers share.
#pragma once

namespace gouraud::pipeline {

inline constexpr int max_lights = 8;
inline constexpr int max_clip_planes = 8;
inline constexpr int max_texture_units = 8;
inline constexpr int max_samples = 4;
/// Levels of a mipmap: the largest is 2^(max_texture_levels - 1) texels a side.
inline constexpr int max_texture_levels = 15;
inline constexpr int max_texture_size = 1 << (max_texture_levels - 1);
inline constexpr int max_texture_3d_size = 2048;

}  // namespace gouraud::pipeline
