#include "api/context/buffer_names.h"

namespace gouraud::api {

void BufferNames::generate(GLsizei count, GLuint* names) {
  const std::lock_guard lock(mutex_);
  GLuint name = 1;
  auto used = objects_.begin();
  for (GLsizei i = 0; i < count; ++i) {
    for (; used != objects_.end() && used->first == name; ++used) ++name;
    objects_.emplace_hint(used, name, nullptr);
    names[i] = name++;
  }
}

BufferBinding BufferNames::find_or_create(GLuint name) {
  const std::lock_guard lock(mutex_);
  const auto found = objects_.find(name);
  if (found != objects_.end() && found->second != nullptr) return found->second;
  auto fresh = std::make_shared<BufferObject>();
  fresh->name = name;
  objects_[name] = fresh;
  return fresh;
}

BufferBinding BufferNames::find(GLuint name) const {
  const std::lock_guard lock(mutex_);
  const auto found = objects_.find(name);
  return found != objects_.end() ? found->second : nullptr;
}

void BufferNames::remove(GLuint name) {
  const std::lock_guard lock(mutex_);
  objects_.erase(name);
}

}  // namespace gouraud::api
