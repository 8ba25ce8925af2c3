#include "conformance/harness/offscreen.h"

#include <cmath>
#include <cstring>
#include <stdexcept>

#include <dlfcn.h>

namespace gouraud::conformance {
namespace {

constexpr int most_errors = 16;  // a driver that reports an error for ever must not hang the suite

template <class Function>
void find(void* library, const char* name, Function& function) {
  void* const symbol = ::dlsym(library, name);
  if (symbol == nullptr) throw std::runtime_error(std::string(name) + " is missing");
  std::memcpy(&function, &symbol, sizeof(function));
}

}  // namespace

OsmesaFunctions load_osmesa(const std::string& library) {
  void* const handle = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) throw std::runtime_error(::dlerror());
  OsmesaFunctions osmesa;
  find(handle, "OSMesaCreateContextExt", osmesa.CreateContextExt);
  find(handle, "OSMesaDestroyContext", osmesa.DestroyContext);
  find(handle, "OSMesaMakeCurrent", osmesa.MakeCurrent);
  find(handle, "OSMesaGetDepthBuffer", osmesa.GetDepthBuffer);
  find(handle, "OSMesaGetProcAddress", osmesa.GetProcAddress);
  return osmesa;
}

OffscreenContext::OffscreenContext(const OsmesaFunctions& osmesa, int width_px, int height_px, int depth_bits)
    : osmesa_(osmesa),
      context_(osmesa.CreateContextExt(GL_RGBA, depth_bits, depth_bits == 24 ? 8 : 0, 16, nullptr)),
      width_px_(width_px),
      height_px_(height_px),
      depth_bits_(depth_bits),
      color_(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px) * 4) {
  if (context_ == nullptr) throw std::runtime_error("OSMesaCreateContextExt gave no context");
  if (!osmesa_.MakeCurrent(context_, color_.data(), GL_UNSIGNED_BYTE, width_px, height_px)) {
    osmesa_.DestroyContext(context_);
    throw std::runtime_error("OSMesaMakeCurrent failed");
  }
  if (!load(gl_, osmesa_.GetProcAddress)) {
    osmesa_.DestroyContext(context_);
    throw std::runtime_error("OSMesaGetProcAddress does not know every command of GL 1.5");
  }
}

OffscreenContext::~OffscreenContext() {
  osmesa_.MakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  osmesa_.DestroyContext(context_);
}

// Of the current context; empty if the library has none.
std::string OffscreenContext::methods_in_use() const {
  void* const address = osmesa_.GetProcAddress("gouraudMethodsInUse");
  if (address == nullptr) return {};
  const char* (*in_use)() = nullptr;
  std::memcpy(&in_use, &address, sizeof in_use);
  return in_use();
}

Picture OffscreenContext::read() {
  gl_.Finish();
  Picture picture;
  picture.width_px = width_px_;
  picture.height_px = height_px_;
  picture.rgba = color_;

  GLint width = 0, height = 0, bytes_per_value = 0;
  void* buffer = nullptr;
  if (!osmesa_.GetDepthBuffer(context_, &width, &height, &bytes_per_value, &buffer)) return picture;
  if (width != width_px_ || height != height_px_ || (bytes_per_value != 2 && bytes_per_value != 4)) {
    throw std::runtime_error("OSMesaGetDepthBuffer describes another buffer");
  }
  const std::string methods = methods_in_use();
  const auto uses = [&](const char* method) { return methods.find(method) != methods.npos; };
  const bool reversed = uses("depth=reversed"), is_wide = reversed || uses("depth=float") || uses("depth=z32");
  const int stored_bits = bytes_per_value == 2 ? 16 : is_wide ? 32 : 24;
  picture.depth_bits = uses("depth=") ? depth_bits_ : stored_bits;
  const auto largest = [](int bits) { return static_cast<double>((std::uint64_t{1} << bits) - 1); };
  const double largest_stored = largest(stored_bits), scale = largest(picture.depth_bits) / largest_stored;
  picture.depth.resize(picture.pixel_count());
  for (std::size_t i = 0; i < picture.depth.size(); ++i) {
    std::uint32_t word = bytes_per_value == 2 ? static_cast<const std::uint16_t*>(buffer)[i] : static_cast<const std::uint32_t*>(buffer)[i];
    if (stored_bits == 24) word &= 0xFFFFFFu;  // stencil is above
    if (scale != 1 || reversed) word = static_cast<std::uint32_t>(std::nearbyint((reversed ? largest_stored - word : word) * scale));
    picture.depth[i] = word;
  }
  return picture;
}

std::uint64_t OffscreenContext::count_read_differences(const Picture& picture) {
  std::vector<std::uint8_t> rgba(picture.rgba.size());
  std::vector<float> depth(picture.depth.size());
  gl_.ReadPixels(0, 0, width_px_, height_px_, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  if (!depth.empty()) gl_.ReadPixels(0, 0, width_px_, height_px_, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());

  const double depth_scale = static_cast<double>((std::uint64_t{1} << picture.depth_bits) - 1);
  std::uint64_t differences = 0;
  for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
    bool differs = std::memcmp(&rgba[4 * i], &picture.rgba[4 * i], 4) != 0;
    // A float holds 24-bit depth closely enough that the nearest integer is the stored one [GL1.5 §4.3.2].
    if (!depth.empty()) differs = differs || std::lround(depth[i] * depth_scale) != static_cast<long>(picture.depth[i]);
    differences += differs ? 1 : 0;
  }
  return differences;
}

std::vector<std::uint32_t> OffscreenContext::take_errors() {
  std::vector<std::uint32_t> errors;
  for (GLenum error = gl_.GetError(); error != GL_NO_ERROR && errors.size() < most_errors; error = gl_.GetError()) {
    errors.push_back(error);
  }
  return errors;
}

}  // namespace gouraud::conformance
