#include "pipeline/draw/varying_layout.h"

#include "pipeline/draw/phong_shading.h"
#include "pipeline/geometry/texture_coordinates.h"

namespace gouraud::pipeline {

int coordinate_dimensions(const TextureUnitState& unit) {
  if (unit.sampler.compares) return 3;
  switch (unit.target) {
    case TextureTarget::one_d: return 1;
    case TextureTarget::two_d:
    case TextureTarget::rectangle: return 2;
    case TextureTarget::three_d:
    case TextureTarget::cube_map: break;
  }
  return 3;
}

VaryingLayout make_varying_layout(const DrawState& state, const Plan& plan, const VertexBatch& batch) {
  VaryingLayout layout;
  const auto append = [&](int count) {
    const std::int8_t first = layout.count;
    layout.count = static_cast<std::int8_t>(first + count);
    return first;
  };
  for (std::size_t unit = 0; plan.reports && unit < max_texture_units; ++unit) {
    if ((state.report.texture_units >> unit & 1) != 0) layout.texture_coordinates[unit] = {append(4), 3, true};
  }
  if (plan.reports) return layout;
  for (std::size_t i = 0; plan.textured && i < state.texturing.count; ++i) {
    const TextureUnitState& unit = state.texturing.unit[i];
    TextureCoordinateLayout& coordinates = layout.texture_coordinates[unit.unit];
    coordinates.dimensions = static_cast<std::int8_t>(coordinate_dimensions(unit));
    coordinates.has_q = !q_is_one(state.texture_coordinates.unit[unit.unit], batch, unit.unit);
    coordinates.first = append(coordinates.dimensions + (coordinates.has_q ? 1 : 0));
  }
  if (plan.phong) layout.lighting = append(lighting_varyings(state.lighting));
  if (plan.fog) layout.fog_coordinate = append(1);
  if (plan.secondary_color == SecondaryColor::interpolated) layout.secondary_color = append(3);
  return layout;
}

}  // namespace gouraud::pipeline
