#include "conformance/harness/render_scene.h"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <string>

#include "conformance/harness/channel.h"
#include "conformance/harness/child_process.h"
#include "conformance/harness/coverage_watch.h"

namespace gouraud::conformance {

Picture render_scene(const OsmesaFunctions& osmesa, const Scene& scene, CoverageWanted coverage) {
  Picture picture;
  {
    OffscreenContext context(osmesa, scene.width_px, scene.height_px, scene.depth_bits);
    scene.draw(context.gl());
    picture = context.read();
    picture.gl_errors = context.take_errors();
    picture.read_differences = context.count_read_differences(picture);
  }
  if (coverage == CoverageWanted::yes) {
    OffscreenContext context(osmesa, scene.width_px, scene.height_px, scene.depth_bits);
    CoverageWatch watch(context);
    scene.draw(watch.gl());
    picture.covered = watch.covered(picture);
  }
  return picture;
}

const Scene& scene_of_name(std::string_view name) {
  const std::vector<Scene>& scenes = all_scenes();
  const auto found = std::ranges::find(scenes, name, &Scene::name);
  if (found == scenes.end()) throw std::runtime_error("no scene is called " + std::string(name));
  return *found;
}

int serve_scenes(const std::vector<std::string>& names, const std::function<Picture(const Scene&)>& render) {
  Writer out(child_output_fd);
  for (const std::string& name : names) {
    out.text(name);
    try {
      const Picture picture = render(scene_of_name(name));
      out.value(true);
      out.picture(picture);
    } catch (const ChannelClosed&) {
      throw;
    } catch (const std::exception& error) {
      out.value(false);
      out.text(error.what());
    }
  }
  return 0;
}

}  // namespace gouraud::conformance
