// The names of occlusion queries, and what each has counted [GL1.5 §4.1.7]. Contexts do not share them.
#pragma once

#include <map>
#include <memory>

#include <GL/gl.h>

#include "pipeline/draw/sample_counter.h"

namespace gouraud::api {

/// Null: the name is generated, but no query has begun with it.
using SampleCount = std::shared_ptr<pipeline::SampleCounter>;

class QueryNames {
 public:
  /// Marks `count` unused names as used, and writes them to `names`.
  void generate(GLsizei count, GLuint* names);
  /// A new count for this name, which need not have been generated. `name` is not 0.
  const SampleCount& begin(GLuint name) { return counts_[name] = std::make_shared<pipeline::SampleCounter>(); }
  /// What the query of that name counts, or null if there is none (yet).
  SampleCount find(GLuint name) const;
  /// The name is unused again.
  void remove(GLuint name) { counts_.erase(name); }

 private:
  std::map<GLuint, SampleCount> counts_;
};

}  // namespace gouraud::api
