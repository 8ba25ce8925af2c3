#include "api/context/display_list.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

namespace gouraud::api {

std::byte* DisplayList::append(ListTag tag, std::size_t bytes) {
  const std::size_t offset = bytes_.size();
  if (bytes > max_payload_bytes || std::uint64_t{bytes} + offset + 16 > bytes_.max_size()) throw std::bad_alloc();
  const std::size_t payload = (bytes + 7) / 8 * 8;
  const ListEntry entry{tag, static_cast<std::uint32_t>(payload)};
  bytes_.resize(offset + sizeof(entry) + payload);
  std::memcpy(&bytes_[offset], &entry, sizeof(entry));
  return bytes_.data() + offset + sizeof(entry);
}

void DisplayList::make_room(std::size_t bytes) {
  const std::size_t needed = bytes_.size() + sizeof(ListEntry) + bytes + 8;
  if (needed > bytes_.capacity()) bytes_.reserve(std::max(needed, 2 * bytes_.capacity()));
}

void DisplayList::rewrite(std::size_t offset, const void* payload, std::size_t bytes) {
  std::memcpy(bytes_.data() + offset + sizeof(ListEntry), payload, bytes);
}

std::byte* DisplayList::allocate(std::size_t bytes) {
  client_memory_.push_back(std::make_unique_for_overwrite<std::byte[]>(bytes));
  return client_memory_.back().get();
}

const void* DisplayList::keep(const void* client_memory, std::size_t bytes) {
  return std::memcpy(allocate(bytes), client_memory, bytes);
}

std::shared_ptr<const DisplayList> DisplayLists::find(GLuint name) const {
  const std::lock_guard lock(mutex_);
  const auto found = contents_.find(name);
  return found != contents_.end() ? found->second : nullptr;
}

bool DisplayLists::is_list(GLuint name) const {
  const std::lock_guard lock(mutex_);
  return used_.contains(name);
}

GLuint DisplayLists::generate(GLuint count) {
  const std::lock_guard lock(mutex_);
  const GLuint first = used_.find_unused(count);
  if (first != 0) used_.insert(first, first + (count - 1));
  return first;
}

void DisplayLists::store(GLuint name, DisplayList list) {
  auto shared = std::make_shared<const DisplayList>(std::move(list));
  const std::lock_guard lock(mutex_);
  auto& entry = contents_[name];
  try {
    used_.insert(name, name);
  } catch (...) {
    contents_.erase(name);  // it was unused: a used name needs no memory
    throw;
  }
  entry.swap(shared);
}

void DisplayLists::erase(GLuint first, GLuint last) {
  const std::lock_guard lock(mutex_);
  used_.erase(first, last);
  if (last - first < contents_.size()) {
    for (GLuint name = first; name - first <= last - first; ++name) contents_.erase(name);
  } else {
    std::erase_if(contents_, [=](const auto& entry) { return entry.first >= first && entry.first <= last; });
  }
}

}  // namespace gouraud::api
