#include "api/context/query_names.h"

namespace gouraud::api {

void QueryNames::generate(GLsizei count, GLuint* names) {
  GLuint name = 1;
  auto used = counts_.begin();
  for (GLsizei i = 0; i < count; ++i) {
    for (; used != counts_.end() && used->first == name; ++used) ++name;
    counts_.emplace_hint(used, name, nullptr);
    names[i] = name++;
  }
}

SampleCount QueryNames::find(GLuint name) const {
  const auto found = counts_.find(name);
  return found != counts_.end() ? found->second : nullptr;
}

}  // namespace gouraud::api
