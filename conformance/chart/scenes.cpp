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

}  // namespace gouraud::chart

std::vector<gouraud::probes::Probe> gouraud::probes::chart_probes() {
  std::vector<Probe> all;
  for (const chart::ChartScene& scene : chart::chart_scenes()) all.push_back(scene.probe);
  return all;
}
