// The methods that are charted: those of the library's own table, gouraudMethodTable(). A method that is added there
// appears in the chart and in the sweeps of its step.
#pragma once

#include <string>
#include <vector>

namespace gouraud::probes {

struct Method {
  std::string setting;  ///< "coverage=scanline", for GOURAUD_METHODS; empty: the default
  std::string step;     ///< "coverage"
  std::string what, source;
  bool antialiases = false;  ///< pictures are to be judged by area coverage
};

/// The default, and one method for each row that is not its step's default. Throws std::runtime_error if the library has
/// no table.
std::vector<Method> all_methods(const std::string& library);

/// The rows of a table as gouraudMethodTable() gives it.
std::vector<Method> methods_of_table(const std::string& table);

}  // namespace gouraud::probes
