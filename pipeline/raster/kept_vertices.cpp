// Takes a batch's processed vertices, gives what its triangles need of them until a tile sets them up (setup.h).
#include "pipeline/raster/setup.h"

namespace gouraud::pipeline {
namespace {

/// Gives the places of the vertices one after the other.
class Keeper {
 public:
  Keeper(const SetupState& state, const ProcessedVertices& vertices, bool back, void* memory)
      : vertices_(vertices), back_(back), kept_(new (memory) KeptVertices{&state, kept_stride(state)}),
        next_(reinterpret_cast<std::byte*>(kept_ + 1)) {}

  void keep(std::uint16_t index) {
    const SetupState& state = *kept_->state;
    auto& out = *new (next_) KeptVertex;
    out.window = vertices_.window[index];
    if (state.colors) out.color = color_of_vertex(state, vertices_, index, back_);
    if (state.binding->varyings.count > 0) {
      copy_varyings(state, vertices_, index, index, back_, reinterpret_cast<float*>(&out + 1));
    }
    next_ += kept_->stride;
  }
  const KeptVertices* all() const { return kept_; }

 private:
  const ProcessedVertices& vertices_;
  bool back_;
  KeptVertices* kept_;
  std::byte* next_;
};

}  // namespace

const KeptVertices* keep_vertices(const SetupState& state, const ProcessedVertices& vertices,
                                  std::span<const std::uint16_t> indices, bool back, void* memory) {
  Keeper keeper(state, vertices, back, memory);
  for (const std::uint16_t index : indices) keeper.keep(index);
  return keeper.all();
}

const KeptVertices* keep_vertices(const SetupState& state, const ProcessedVertices& vertices, std::size_t count, bool back,
                                  void* memory) {
  Keeper keeper(state, vertices, back, memory);
  for (std::size_t i = 0; i < count; ++i) keeper.keep(static_cast<std::uint16_t>(i));
  return keeper.all();
}

}  // namespace gouraud::pipeline
