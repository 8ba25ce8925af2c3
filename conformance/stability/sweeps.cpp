#include "conformance/stability/sweeps.h"

namespace gouraud::stability {

std::vector<Sweep> all_sweeps() { return {}; }

}  // namespace gouraud::stability
