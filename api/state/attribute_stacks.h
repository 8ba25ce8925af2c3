// What PushAttrib and PushClientAttrib have put aside [GL1.5 §6.1.14].
#pragma once

#include <vector>

#include "api/state/state.h"

namespace gouraud::api {

/// Groups whose bit is not in `mask` are saved as well, and not restored.
struct SavedAttributes {
  GLbitfield mask = 0;
  AttributeGroups groups;
  /// With TEXTURE_BIT, of each object bound: by unit and target.
  std::vector<TextureParameters> texture_parameters;
};

struct SavedClientAttributes {
  GLbitfield mask = 0;
  ClientAttributeGroups groups;
};

struct AttributeStacks {
  std::vector<SavedAttributes> server;        ///< at most max_attrib_stack_depth
  std::vector<SavedClientAttributes> client;  ///< at most max_client_attrib_stack_depth
};

}  // namespace gouraud::api
