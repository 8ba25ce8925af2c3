// A whole Begin/End of a display list whose vertices wait as structure of arrays, so that replaying it is copying
// blocks into the immediate batch [GL1.5 §5.4].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "api/context/context.h"

namespace gouraud::api {

/// Values beside the position that a run can hold, in the order of their tags.
inline constexpr std::size_t run_attributes = 4 + max_texture_units;

/// True for the tags of current values: normal to last_value.
constexpr bool is_vertex_value(ListTag tag) { return tag >= ListTag::normal && tag <= ListTag::last_value; }
/// Makes it current.
void set_vertex_value(CurrentGroup& current, ListTag tag, const GLfloat* values);

/// A current value over a run: up to its first change the run takes what is current when it is executed.
struct RunAttribute {
  ListTag tag = ListTag::normal;
  std::uint32_t first = 0;  ///< the first vertex that has the run's own value; the count if none has
  bool varies = false;      ///< its own values lie in the arrays, as many as there are vertices; else `own` holds it
  std::array<GLfloat, 4> own{};
  std::array<GLfloat, 4> last{};  ///< is current behind the run
};

/// The head of an entry's payload. Behind it, a RunAttribute for each value that the run sets, in the order of their tags;
/// then arrays of `distinct` floats: x, y, z, w of the positions, and the components of each attribute that varies. If
/// fewer vertices are distinct than there are vertices, `count` numbers of type std::uint32_t say which ones they are.
struct VertexRun {
  GLenum mode = 0;
  std::uint32_t count = 0;
  std::uint32_t distinct = 0;
  std::uint32_t attribute_count = 0;

  bool is_indexed() const { return distinct < count; }
};

/// Puts a run of `mode` in place of the list's entries from offset `begin` on: a Begin, then only vertices and their
/// values; the End is still to come. False, and nothing is changed, where a run would not pay. Throws std::bad_alloc,
/// and nothing is changed.
bool make_vertex_run(DisplayList& list, std::size_t begin, GLenum mode);

/// Does what the run's commands would do, errors included.
void replay(Context& context, const VertexRun& run);

}  // namespace gouraud::api
