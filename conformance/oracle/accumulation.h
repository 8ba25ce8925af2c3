// The accumulation buffer [GL1.5 §4.2.4]: sums in double of the colours as they are stored, clamped to [-1, 1].
#pragma once

#include "conformance/oracle/oracle.h"

namespace gouraud::oracle {

void accumulate_picture(OraclePicture& picture, const pipeline::AccumState& state);

}  // namespace gouraud::oracle
