#include "conformance/chart/scenes.h"

namespace gouraud::chart {

const std::vector<ChartScene>& chart_scenes() {
  static const std::vector<ChartScene> scenes = [] {
    std::vector<ChartScene> all = surface_scenes();
    for (const auto list : {detail_scenes, blended_scenes}) {
      for (const ChartScene& scene : list()) all.push_back(scene);
    }
    return all;
  }();
  return scenes;
}

std::vector<Probe> chart_probes() {
  std::vector<Probe> probes;
  for (const ChartScene& scene : chart_scenes()) probes.push_back(scene.probe);
  return probes;
}

}  // namespace gouraud::chart
