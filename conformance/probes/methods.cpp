#include "conformance/probes/methods.h"

#include <cstring>
#include <sstream>
#include <stdexcept>

#include "conformance/harness/offscreen.h"

namespace gouraud::probes {

std::vector<Method> methods_of_table(const std::string& table) {
  std::vector<Method> methods{{}};
  std::istringstream lines(table);
  std::string last_step;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    Method method;
    std::string name;
    std::getline(fields, method.step, '\t');
    std::getline(fields, name, '\t');
    std::getline(fields, method.what, '\t');
    std::getline(fields, method.source, '\t');
    const bool is_default = method.step != last_step;
    last_step = method.step;
    if (is_default) continue;
    method.setting = method.step + "=" + name;
    if (method.step == "epsilon") {
      // Means something to one kind of coverage only.
      method.setting = "coverage=barycentric," + method.setting;
      method.step = "coverage";
    }
    method.antialiases = method.step == "antialiasing";
    methods.push_back(method);
  }
  return methods;
}

std::vector<Method> all_methods(const std::string& library) {
  void* const address = conformance::load_osmesa(library).GetProcAddress("gouraudMethodTable");
  if (address == nullptr) throw std::runtime_error(library + " has no table of methods");
  const char* (*table)() = nullptr;
  std::memcpy(&table, &address, sizeof(table));
  return methods_of_table(table());
}

}  // namespace gouraud::probes
