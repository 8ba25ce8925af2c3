// Vertices that several indices name: takes the elements that a draw names, puts each into the immediate batch once, and
// lists its place there for every index [GL1.5 §2.8]. So it is transformed and lit once, as long as the batch lasts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "api/context/context.h"

namespace gouraud::api {

/// A stream of elements of one primitive. `append` puts elements behind the batch's last vertex, for which there is
/// room, and counts them in batch.count. Between begin_indexed_primitive and end_primitive.
class SharedVertices {
 public:
  using Append = std::function<void(std::span<const GLuint> elements)>;
  SharedVertices(Context& context, Append append);

  /// Appends indices to the primitive. False if nothing of it is drawn. Throws std::bad_alloc.
  bool add(std::span<const GLuint> elements);
  /// What is left goes into the batch.
  void finish() { append_fresh(); }

 private:
  void add_one(GLuint element);
  void append_fresh();
  void start_next_batch();
  bool is_full() const;

  Context& context_;
  Append append_;
  std::int32_t multiple_;
  std::int32_t until_cut_ = 0;               // so many indices more before the primitive may be cut
  bool any_ = false;
  GLuint first_ = 0;                         // the very first
  std::array<GLuint, 2> last_{};             // the last but one, and the last
  std::size_t fresh_count_ = 0;
  std::array<GLuint, pipeline::batch_capacity> fresh_;  // elements that the batch does not have yet
};

}  // namespace gouraud::api
