// The names of one kind of object that contexts share [GL1.5 §2.9, §3.8.12], EXT_framebuffer_object. Contexts that share objects
// share one of these; each function may be called from any thread.
#pragma once

#include <map>
#include <memory>
#include <mutex>

#include <GL/gl.h>

namespace gouraud::api {

/// `Object` has a member `name`.
template <class Object>
class ObjectNames {
 public:
  using Binding = std::shared_ptr<Object>;

  /// Marks `count` unused names as used, and writes them to `names`.
  void generate(GLsizei count, GLuint* names) {
    const std::lock_guard lock(mutex_);
    GLuint name = 1;
    auto used = objects_.begin();
    for (GLsizei i = 0; i < count; ++i) {
      for (; used != objects_.end() && used->first == name; ++used) ++name;
      objects_.emplace_hint(used, name, nullptr);
      names[i] = name++;
    }
  }

  /// True if the name has been generated, or given to an object.
  bool used(GLuint name) const {
    const std::lock_guard lock(mutex_);
    return objects_.contains(name);
  }

  /// The object of that name; if there is none, one made of `arguments`. `name` is not 0.
  template <class... Arguments>
  Binding find_or_create(GLuint name, Arguments... arguments) {
    const std::lock_guard lock(mutex_);
    const auto found = objects_.find(name);
    if (found != objects_.end() && found->second != nullptr) return found->second;
    auto fresh = std::make_shared<Object>(arguments...);
    fresh->name = name;
    objects_[name] = fresh;
    return fresh;
  }

  /// The object of that name, or null if there is none (yet).
  Binding find(GLuint name) const {
    const std::lock_guard lock(mutex_);
    const auto found = objects_.find(name);
    return found != objects_.end() ? found->second : nullptr;
  }

  /// The name is unused again; its object, if any, lives on in its bindings.
  void remove(GLuint name) {
    const std::lock_guard lock(mutex_);
    objects_.erase(name);
  }

 private:
  mutable std::mutex mutex_;
  std::map<GLuint, Binding> objects_;  // null: generated, but never bound
};

}  // namespace gouraud::api
