#include "api/snapshot/varying_snapshot.h"

#include "api/snapshot/enums.h"

namespace gouraud::api {
namespace {

pipeline::TextureCoordinateSource source_of(const TextureGenerationUnit& unit, const glm::mat4& matrix) {
  pipeline::TextureCoordinateSource result;
  for (std::size_t c = 0; c < 4; ++c) {
    const TextureGeneration& coordinate = unit.coordinate[c];
    if (!coordinate.enabled) continue;
    result.mode[c] = texgen_mode(coordinate.mode);
    if (coordinate.mode == GL_OBJECT_LINEAR) result.plane[c] = coordinate.object_plane;
    if (coordinate.mode == GL_EYE_LINEAR) result.plane[c] = coordinate.eye_plane;
  }
  result.transformed = matrix != glm::mat4(1.0f);
  if (result.transformed) result.matrix = matrix;
  return result;
}

}  // namespace

pipeline::ClipPlaneState clip_plane_state(const TransformGroup& group) {
  pipeline::ClipPlaneState result;
  for (const UserClipPlane& plane : group.clip_planes) {
    if (plane.enabled) result.plane_eye[result.count++] = glm::vec4(plane.plane_eye);
  }
  return result;
}

pipeline::FogState fog_state(const FogGroup& group, std::uint8_t color_write_mask) {
  pipeline::FogState result;
  if (!group.enabled || (color_write_mask & 7) == 0) return result;
  result.mode = fog_mode(group.mode);
  result.from_coordinate = group.coordinate_source == GL_FOG_COORD;
  result.color = glm::vec3(group.color.x, group.color.y, group.color.z);
  if (result.mode == pipeline::FogMode::linear) {
    result.start = group.start;
    result.end = group.end;
  } else {
    result.density = group.density;
  }
  return result;
}

bool color_sum_state(const State& state, std::uint8_t color_write_mask) {
  return state.fog.color_sum_enabled && !state.lighting.enabled && (color_write_mask & 7) != 0;
}

std::uint8_t units_of(const pipeline::TexturingState& texturing) {
  std::uint8_t units = 0;
  for (std::size_t i = 0; i < texturing.count; ++i) units = static_cast<std::uint8_t>(units | 1u << texturing.unit[i].unit);
  return units;
}

pipeline::TextureCoordinatesState texture_coordinates_state(const State& state, std::uint8_t units) {
  pipeline::TextureCoordinatesState result;
  result.units = units;
  for (std::size_t unit = 0; unit < max_texture_units; ++unit) {
    if ((units >> unit & 1) == 0) continue;
    result.unit[unit] = source_of(state.texture_generation.unit[unit], state.matrices.texture[unit].top());
  }
  return result;
}

bool generates_from_normals(const pipeline::TextureCoordinatesState& state) {
  for (const pipeline::TextureCoordinateSource& source : state.unit) {
    for (const pipeline::TexgenMode mode : source.mode) {
      if (mode == pipeline::TexgenMode::sphere_map || mode == pipeline::TexgenMode::normal_map ||
          mode == pipeline::TexgenMode::reflection_map) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace gouraud::api
