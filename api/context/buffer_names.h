// The names of buffer objects [GL1.5 §2.9]. Contexts that share objects share one of these; each function may be called
// from any thread.
#pragma once

#include <map>
#include <mutex>

#include <GL/gl.h>

#include "api/state/buffer_object.h"

namespace gouraud::api {

class BufferNames {
 public:
  /// Marks `count` unused names as used, and writes them to `names`.
  void generate(GLsizei count, GLuint* names);
  /// The object of that name, made if there is none. `name` is not 0.
  BufferBinding find_or_create(GLuint name);
  /// The object of that name, or null if there is none (yet).
  BufferBinding find(GLuint name) const;
  /// The name is unused again; its object, if any, lives on in its bindings.
  void remove(GLuint name);

 private:
  mutable std::mutex mutex_;
  std::map<GLuint, BufferBinding> objects_;  // null: generated, but never bound
};

}  // namespace gouraud::api
