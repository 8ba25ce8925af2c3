// Takes a pixel and the outcomes of stencil and depth test, gives its stencil value [GL1.5 §4.1.5].
#pragma once

#include "conformance/oracle/oracle.h"

namespace gouraud::oracle {

/// Whether the reference, compared with the stored value, passes; both under the mask.
bool passes_stencil(const pipeline::StencilFace& face, const OraclePixel& pixel);

/// Carries out the operation for these outcomes. `depth_passes` is of no importance where the stencil test failed.
void update_stencil(const pipeline::StencilFace& face, bool stencil_passes, bool depth_passes, OraclePixel& pixel);

}  // namespace gouraud::oracle
