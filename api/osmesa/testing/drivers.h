// The OSMesa functions of two libraries behind pointers, ours and Mesa's, so that one test body runs on both: what we
// expect of ourselves is what programs are used to.
#pragma once

#include <dlfcn.h>

#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include "gl_table.h"

// What Mesa and LLVM never free, and what they race for, is not ours to report.
extern "C" __attribute__((weak, used, visibility("default"))) const char* __lsan_default_suppressions() {
  return "leak:libOSMesa.so.8";
}
extern "C" __attribute__((weak, used, visibility("default"))) const char* __tsan_default_suppressions() {
  return "called_from_lib:libOSMesa.so.8\ncalled_from_lib:libLLVM\nrace:libOSMesa.so.8\nrace:libLLVM\nmutex:libgcc_s";
}

namespace gouraud::api::testing {

struct Driver {
  bool is_ours = false;
  GlTable gl;
  decltype(&OSMesaCreateContext) CreateContext = nullptr;
  decltype(&OSMesaCreateContextExt) CreateContextExt = nullptr;
  decltype(&OSMesaCreateContextAttribs) CreateContextAttribs = nullptr;
  decltype(&OSMesaDestroyContext) DestroyContext = nullptr;
  decltype(&OSMesaMakeCurrent) MakeCurrent = nullptr;
  decltype(&OSMesaGetCurrentContext) GetCurrentContext = nullptr;
  decltype(&OSMesaPixelStore) PixelStore = nullptr;
  decltype(&OSMesaGetIntegerv) GetIntegerv = nullptr;
  decltype(&OSMesaGetDepthBuffer) GetDepthBuffer = nullptr;
  decltype(&OSMesaGetColorBuffer) GetColorBuffer = nullptr;
  decltype(&OSMesaGetProcAddress) GetProcAddress = nullptr;
  decltype(&OSMesaColorClamp) ColorClamp = nullptr;
  decltype(&OSMesaPostprocess) Postprocess = nullptr;

  /// `get` is OSMesaGetProcAddress.
  Driver(bool ours, void* (*get)(const char*)) : is_ours(ours) {
    const auto find = [get](auto& function, const char* wanted) {
      function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(get(wanted));
      if (function == nullptr) throw std::runtime_error(std::string("no function ") + wanted);
    };
    find(CreateContext, "OSMesaCreateContext");
    find(CreateContextExt, "OSMesaCreateContextExt");
    find(CreateContextAttribs, "OSMesaCreateContextAttribs");
    find(DestroyContext, "OSMesaDestroyContext");
    find(MakeCurrent, "OSMesaMakeCurrent");
    find(GetCurrentContext, "OSMesaGetCurrentContext");
    find(PixelStore, "OSMesaPixelStore");
    find(GetIntegerv, "OSMesaGetIntegerv");
    find(GetDepthBuffer, "OSMesaGetDepthBuffer");
    find(GetColorBuffer, "OSMesaGetColorBuffer");
    find(GetProcAddress, "OSMesaGetProcAddress");
    find(ColorClamp, "OSMesaColorClamp");
    find(Postprocess, "OSMesaPostprocess");
    load(gl, get);
  }
};

inline const Driver& ours() {
  static const Driver driver(true,
                             [](const char* name) { return reinterpret_cast<void*>(OSMesaGetProcAddress(name)); });
  return driver;
}

/// Debian's libosmesa6, without threads and with the same arithmetic on every machine (MESA-RULES 1).
inline const Driver& mesa() {
  static const Driver driver = [] {
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 1);
    setenv("LP_NUM_THREADS", "0", 1);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    void* const library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) throw std::runtime_error(dlerror());
    return Driver(false, reinterpret_cast<void* (*)(const char*)>(dlsym(library, "OSMesaGetProcAddress")));
  }();
  return driver;
}

using Choice = const Driver& (*)();

/// A test that runs once on ours and once on Mesa.
class BothDrivers : public ::testing::TestWithParam<Choice> {
 protected:
  void TearDown() override { driver.MakeCurrent(nullptr, nullptr, 0, 0, 0); }
  const Driver& driver = GetParam()();
  const GlTable& gl = driver.gl;
};

struct Destroy {
  const Driver* driver = nullptr;
  void operator()(OSMesaContext context) const { driver->DestroyContext(context); }
};
using OwnedContext = std::unique_ptr<osmesa_context, Destroy>;

inline OwnedContext make_context(const Driver& driver, GLenum format = OSMESA_RGBA, int depth_bits = 24,
                                 int stencil_bits = 8) {
  return {driver.CreateContextExt(format, depth_bits, stencil_bits, 0, nullptr), {&driver}};
}

inline std::string driver_name(const ::testing::TestParamInfo<Choice>& info) {
  return info.param == &ours ? "gouraud" : "mesa";
}

#define GOURAUD_ON_BOTH_DRIVERS(Suite) INSTANTIATE_TEST_SUITE_P(On, Suite, ::testing::Values(&ours, &mesa), driver_name)

}  // namespace gouraud::api::testing
