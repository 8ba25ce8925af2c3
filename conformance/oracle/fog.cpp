#include "conformance/oracle/fog.h"

#include <algorithm>
#include <cmath>

namespace gouraud::oracle {
namespace {

using pipeline::FogMode;

/// NaN becomes 0.
double clamped_to_unit(double value) {
  return value > 0 ? std::min(value, 1.0) : 0.0;
}

}  // namespace

double fog_coordinate(const pipeline::DrawState& state, const pipeline::VertexBatch& batch, int index) {
  const auto i = static_cast<std::size_t>(index);
  if (state.raster.fog.from_coordinate) return batch.fog_coordinate[0][i];
  double z = 0;
  for (int k = 0; k < 4; ++k) {
    z += static_cast<double>(state.transform.modelview[k][2]) * batch.position_object[static_cast<std::size_t>(k)][i];
  }
  return std::abs(z);
}

double fog_factor(const pipeline::FogState& fog, double c) {
  switch (fog.mode) {
    case FogMode::none:
      break;
    case FogMode::linear:
      return clamped_to_unit((fog.end - c) / (static_cast<double>(fog.end) - fog.start));
    case FogMode::exp:
      return clamped_to_unit(std::exp(-fog.density * c));
    case FogMode::exp2:
      return clamped_to_unit(std::exp(-(fog.density * c) * (fog.density * c)));
  }
  return 1;
}

Color fogged(const pipeline::FogState& fog, const Color& color, double coordinate) {
  if (fog.mode == FogMode::none) return color;
  const double f = fog_factor(fog, coordinate);
  Color out = color;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    out[k] = f * clamped_to_unit(color[k]) + (1 - f) * fog.color[i];
  }
  return out;
}

}  // namespace gouraud::oracle
