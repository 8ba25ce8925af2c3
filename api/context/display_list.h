// Display lists as they are kept [GL1.5 §5.4]: their contents, the names of a group of contexts, the list being made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <unordered_map>
#include <vector>

#include <GL/gl.h>

#include "api/context/name_ranges.h"
#include "api/state/limits.h"
#include "api/state/pixel_store.h"

namespace gouraud::api {

/// What an entry of a list holds. Below first_own: a command's record, the number is its records::Opcode.
enum class ListTag : std::uint16_t {
  first_own = 0xFF00,
  position = first_own,  ///< of a vertex; four floats, as those that follow
  normal,
  color,
  secondary_color,
  fog_coordinate,
  texture_coordinates,  ///< of unit 0; unit k's tag is k more
  last_value = texture_coordinates + max_texture_units - 1,
  vertices,          ///< a whole Begin/End that holds only the above: a VertexRun (commands/vertex_run.h)
  draw,              ///< a draw from vertex arrays is made of the entries in so many bytes (std::uint64_t) that follow
  with_pixel_store,  ///< the PixelStore for the command that follows
};

constexpr ListTag texture_coordinates_tag(GLuint unit) {
  return static_cast<ListTag>(static_cast<GLuint>(ListTag::texture_coordinates) + unit);
}

/// Stands before each entry's payload. Both are multiples of 8 bytes long and aligned so.
struct ListEntry {
  ListTag tag;
  std::uint32_t payload_bytes;
};
static_assert(sizeof(ListEntry) == 8);

/// Entries one after another, and the client memory that they point to.
class DisplayList {
 public:
  static constexpr std::size_t max_payload_bytes = 0xFFFFFFF8;

  /// Appends an entry whose payload is to be written; at least `bytes` of it, zero behind them. Throws std::bad_alloc,
  /// and nothing is changed.
  std::byte* append(ListTag tag, std::size_t bytes);
  /// A copy that lives as long as the list. Throws std::bad_alloc.
  const void* keep(const void* client_memory, std::size_t bytes);
  /// Writes over the payload of the entry at this offset.
  void rewrite(std::size_t offset, const void* payload, std::size_t bytes);
  /// Memory that lives as long as the list, to be written. Throws std::bad_alloc.
  std::byte* allocate(std::size_t bytes);
  /// Drops the entries from this offset on.
  void truncate(std::size_t offset) { bytes_.resize(offset); }
  void shrink_to_fit() { bytes_.shrink_to_fit(); }
  /// So that the next entry of so many bytes, wherever the list is truncated to, cannot throw. Throws std::bad_alloc.
  void make_room(std::size_t bytes);
  std::size_t size() const { return bytes_.size(); }
  std::span<const std::byte> entries() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
  std::vector<std::unique_ptr<std::byte[]>> client_memory_;
};

/// The lists of one or more contexts; contexts of several threads may use it at once. A list that is being executed
/// stays alive when its name is deleted or given to another.
class DisplayLists {
 public:
  /// The list's contents; null if the name is unused or its list empty.
  std::shared_ptr<const DisplayList> find(GLuint name) const;
  bool is_list(GLuint name) const;
  /// Makes `count` (> 0) empty lists side by side; the first one's name, or 0 if there is no room. Throws
  /// std::bad_alloc, and nothing is changed.
  GLuint generate(GLuint count);
  /// Gives the name a list in place of what it had. Throws std::bad_alloc, and nothing is changed.
  void store(GLuint name, DisplayList list);
  /// Deletes the lists first..last.
  void erase(GLuint first, GLuint last);

 private:
  mutable std::mutex mutex_;
  NameRanges used_;
  std::unordered_map<GLuint, std::shared_ptr<const DisplayList>> contents_;  // of those that are not empty
};

/// The list between NewList and EndList.
struct ListCompiler {
  GLuint name = 0;  ///< 0: none is open
  GLenum mode = 0;  ///< GL_COMPILE, GL_COMPILE_AND_EXECUTE; 0 if none is open
  bool out_of_memory = false;
  DisplayList list;
  /// Offset of the Begin since which only vertices and their values came, or none.
  static constexpr std::size_t none = ~std::size_t{0};
  std::size_t run_begin = none;
  GLenum run_mode = 0;  ///< of that Begin

  bool open() const { return name != 0; }
};

}  // namespace gouraud::api
