// mujoco: what MuJoCo draws through ours and through llvmpipe, how far the two pictures are apart, and how long one takes.
//
// MuJoCo is the largest client of OSMesa: display lists, shadow maps, reflections, cube maps and four samples a pixel. The
// simulation is Debian's libmujoco, not ours; each driver has a process of its own, for MuJoCo finds its GL by a global name.
#include <dlfcn.h>
#include <mujoco/mujoco.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "conformance/harness/drivers.h"
#include "conformance/harness/options.h"

namespace gouraud::speed {
namespace {

constexpr const char* usage = R"(mujoco [OPTION...]    draws a model with MuJoCo on ours and on llvmpipe, on one core, and compares
  --model FILE     the model (default: Debian's humanoid)
  --pictures N     timed pictures (default 10)
  --samples N      samples a pixel: 0 or 4 (default: the model's)
  --library FILE   the libOSMesa that is ours
)";

constexpr int width_px = 1280, height_px = 960, steps_before = 100;

struct Options {
  std::string model = "/usr/share/mujoco/model/humanoid/humanoid.xml";
  int pictures = 10;
  int samples = -1;
  conformance::Paths paths = conformance::Paths::of_this_build();
};

/// What a driver's process leaves for its parent.
struct Outcome {
  double milliseconds;  ///< of processor time, the median of the pictures
  std::uint8_t rgb[3 * width_px * height_px];
};

double processor_time_ms() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

template <class Function>
Function find(void* library, const char* name) {
  void* const found = dlsym(library, name);
  if (found == nullptr) throw std::runtime_error(std::string("the library has no ") + name);
  return reinterpret_cast<Function>(found);
}

/// A context of MuJoCo's kind is current from now on. `window` is its memory.
void make_current(const std::string& library_file, std::vector<std::uint8_t>& window) {
  constexpr unsigned rgba = 0x1908, unsigned_byte = 0x1401;
  constexpr int side_px = 64;  // MuJoCo draws into a framebuffer object of its own
  void* const library = dlopen(library_file.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (library == nullptr) throw std::runtime_error(dlerror());
  const auto create = find<void* (*)(unsigned, int, int, int, void*)>(library, "OSMesaCreateContextExt");
  const auto make_current = find<unsigned char (*)(void*, void*, unsigned, int, int)>(library, "OSMesaMakeCurrent");
  window.resize(4 * side_px * side_px);
  void* const context = create(rgba, 24, 8, 0, nullptr);
  if (context == nullptr || make_current(context, window.data(), unsigned_byte, side_px, side_px) == 0) {
    throw std::runtime_error(library_file + " gives no context");
  }
}

void draw(const Options& options, const std::string& library, Outcome& outcome) {
  mju_user_error = [](const char* message) {
    std::fprintf(stderr, "mujoco: %s\n", message);
    std::_Exit(1);
  };
  std::vector<std::uint8_t> window;
  make_current(library, window);
  char error[500] = "";
  const std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model(mj_loadXML(options.model.c_str(), nullptr, error, sizeof error), mj_deleteModel);
  if (model == nullptr) throw std::runtime_error(error);
  const std::unique_ptr<mjData, decltype(&mj_deleteData)> data(mj_makeData(model.get()), mj_deleteData);
  model->vis.global.offwidth = width_px;
  model->vis.global.offheight = height_px;
  if (options.samples >= 0) model->vis.quality.offsamples = options.samples;
  for (int i = 0; i < steps_before; ++i) mj_step(model.get(), data.get());

  mjvCamera camera;
  mjvOption look;
  mjvScene scene;
  mjrContext context;
  mjv_defaultCamera(&camera);
  mjv_defaultFreeCamera(model.get(), &camera);
  mjv_defaultOption(&look);
  mjv_defaultScene(&scene);
  mjr_defaultContext(&context);
  mjv_makeScene(model.get(), &scene, 4000);
  mjr_makeContext(model.get(), &context, mjFONTSCALE_150);
  mjr_setBuffer(mjFB_OFFSCREEN, &context);
  mjv_updateScene(model.get(), data.get(), &look, nullptr, &camera, mjCAT_ALL, &scene);
  const mjrRect all{0, 0, width_px, height_px};
  std::vector<double> times;
  for (int i = 0; i < options.pictures + 1; ++i) {
    const double begin = processor_time_ms();
    mjr_render(all, &scene, &context);
    mjr_readPixels(outcome.rgb, nullptr, all, &context);
    if (i > 0) times.push_back(processor_time_ms() - begin);
  }
  std::ranges::sort(times);
  outcome.milliseconds = times[times.size() / 2];
}

/// Draws in a process of its own.
const Outcome& run_driver(const Options& options, const std::string& library) {
  void* const shared = mmap(nullptr, sizeof(Outcome), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) throw std::runtime_error("no memory");
  auto* const outcome = static_cast<Outcome*>(shared);
  const pid_t child = fork();
  if (child == 0) {
    setenv("GOURAUD_THREADS", "1", 1);
    setenv("LP_NUM_THREADS", "0", 1);
    try {
      draw(options, library, *outcome);
      std::_Exit(0);
    } catch (const std::exception& e) {
      std::fprintf(stderr, "mujoco: %s\n", e.what());
    }
    std::_Exit(1);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child || status != 0) throw std::runtime_error("no picture by " + library);
  return *outcome;
}

int run(std::span<char*> arguments) {
  Options options;
  for (conformance::OptionWords words(arguments); words.next();) {
    const std::string_view option = words.option();
    if (option == "--model") {
      options.model = words.value();
    } else if (option == "--pictures") {
      options.pictures = std::max(1, std::stoi(words.value()));
    } else if (option == "--samples") {
      options.samples = std::stoi(words.value());
    } else if (option == "--library") {
      options.paths.our_library = words.value();
    } else if (option == "--help") {
      std::fputs(usage, stdout);
      return 0;
    } else {
      words.refuse(usage);
    }
  }
  const Outcome& ours = run_driver(options, options.paths.our_library);
  const Outcome& mesa = run_driver(options, options.paths.mesa_library);
  constexpr int pixels = width_px * height_px;
  int beyond_one = 0, largest = 0;
  for (int i = 0; i < pixels; ++i) {
    int difference = 0;
    for (int c = 0; c < 3; ++c) difference = std::max(difference, std::abs(ours.rgb[3 * i + c] - mesa.rgb[3 * i + c]));
    beyond_one += difference > 1 ? 1 : 0;
    largest = std::max(largest, difference);
  }
  std::printf("a picture, processor time: ours %.1f ms, llvmpipe %.1f ms, %.2fx\n", ours.milliseconds, mesa.milliseconds,
              mesa.milliseconds / ours.milliseconds);
  std::printf("pixels more than 1/255 apart: %.3f %%, at most %d/255\n", 100.0 * beyond_one / pixels, largest);
  return 0;
}

}  // namespace
}  // namespace gouraud::speed

int main(int argc, char** argv) {
  try {
    return gouraud::speed::run({argv + 1, argv + argc});
  } catch (const std::exception& e) {
    std::fprintf(stderr, "mujoco: %s\n", e.what());
    return 1;
  }
}
