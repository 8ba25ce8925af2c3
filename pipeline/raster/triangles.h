// Triangles on their way from a batch to the tiles [GL1.5 §3.5.1]: selected, waiting in the bins, set up in groups.
//
// A tile does no more for a triangle than the triangle turns out to need: those that cover no sample are dropped by the
// selection, and colours get planes only when fragments have passed the depth test.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/raster/primitive.h"
#include "pipeline/raster/record_group.h"
#include "pipeline/raster/setup.h"

namespace gouraud::pipeline {

/// Bytes of a KeptVertex and the varyings behind it. Without varyings it is half a cache line, and lies across none.
inline std::size_t kept_vertex_size(const SetupState& state) {
  return sizeof(KeptVertex) + (static_cast<std::size_t>(state.binding->varyings.count) * sizeof(float) + 31) / 32 * 32;
}
inline float* varyings_of(KeptVertex& vertex) { return reinterpret_cast<float*>(&vertex + 1); }
inline const float* varyings_of(const KeptVertex& vertex) { return reinterpret_cast<const float*>(&vertex + 1); }

/// A triangle that will touch pixels, before its setup. Small ones wait like this in the bins, in a fraction of a record,
/// so that more of them meet in a tile while it is in the cache, and the tile sets them up.
///
/// Where the triangles of a batch share vertices (strips, fans, elements) the batch keeps them once, and a waiting
/// triangle is 32 bytes. Separate triangles each carry their own three behind the struct: gathered from far apart they
/// would cost more than the copy. Where samples are apart, SampleMasks come last.
struct alignas(32) WaitingTriangle {
  const std::byte* shared;             ///< the KeptVertices of its batch; null: its own stand behind the struct
  std::uint64_t mask;                  ///< of a small one, its pixels: (x0 + column, y0 + row) is bit 8 * row + column
  std::array<std::uint16_t, 3> vertex; ///< among the kept ones
  std::int16_t x0, y0, x1, y1;         ///< pixels [x0, x1) x [y0, y1) that it may touch; inside the scissor
  bool scissored;                      ///< the scissor cuts its box
  bool back;                           ///< faces away

  /// At most 8x8 pixels, not cut by the scissor: the mask says it all, and no edges are needed.
  bool small() const { return mask != 0; }
};
static_assert(sizeof(WaitingTriangle) == 32);

/// The mask of a small triangle, for each sample.
using SampleMasks = std::array<std::uint64_t, max_samples>;

/// Bytes of a waiting triangle with what stands behind it.
inline std::size_t waiting_size(const SetupState& state, bool shares) {
  return sizeof(WaitingTriangle) + (shares ? 0 : 3 * kept_vertex_size(state)) + (state.binding->samples_apart ? sizeof(SampleMasks) : 0);
}
inline constexpr std::size_t largest_waiting =
    sizeof(WaitingTriangle) + 3 * (sizeof(KeptVertex) + (max_varyings * sizeof(float) + 31) / 32 * 32) + sizeof(SampleMasks);

/// Vertex i of a triangle; `bytes` is kept_vertex_size.
inline const KeptVertex& vertex_of(const WaitingTriangle& triangle, std::size_t i, std::size_t bytes) {
  const std::byte* const first = triangle.shared != nullptr ? triangle.shared : reinterpret_cast<const std::byte*>(&triangle + 1);
  return *reinterpret_cast<const KeptVertex*>(first + triangle.vertex[i] * bytes);
}

/// Of a small triangle that goes into all samples.
inline SampleMasks masks_of(const WaitingTriangle& triangle, const RasterBinding& binding, std::size_t vertex_bytes) {
  SampleMasks masks;
  if (binding.samples_apart) {
    std::memcpy(&masks, reinterpret_cast<const std::byte*>(&triangle + 1) + (triangle.shared != nullptr ? 0 : 3 * vertex_bytes), sizeof masks);
  } else {
    for (std::size_t k = 0; k < max_samples; ++k) masks[k] = (binding.sample_mask >> k & 1) != 0 ? triangle.mask : 0;
  }
  return masks;
}

/// Whether all triangles of a side take the same from a vertex.
inline bool may_share_vertices(const SetupState& state) { return !state.flat; }
/// The kept vertices of a range of a batch, if there are: as front faces take them, and as back faces do. They are the same
/// ones where lighting has one side.
struct SharedVertices {
  const std::byte* front = nullptr;  ///< null: each triangle keeps its own
  const std::byte* back = nullptr;
  std::uint16_t first = 0;           ///< the batch's vertex that is kept first
};
/// Bytes of so many.
inline std::size_t shared_vertices_size(const SetupState& state, std::size_t count) {
  return count * kept_vertex_size(state) * (state.two_sided ? 2 : 1);
}
/// Keeps vertices [first, first + count) for triangles that share them, in `memory`: shared_vertices_size bytes.
SharedVertices keep_vertices(const SetupState& state, const ProcessedVertices& vertices, std::size_t first, std::size_t count,
                             std::byte* memory);

/// Most triangles that one call of select_triangles takes.
inline constexpr std::size_t selection_batch = 32;

/// Copies the triangles that draw something to `out`, waiting_size bytes each, in order, and returns their number. Left
/// out are those that are culled, without area after snapping, outside the scissor, or (if small) between the samples.
std::size_t select_triangles(const SetupState& state, const ProcessedVertices& vertices,
                             std::span<const AssembledTriangle> triangles, SharedVertices shared, std::byte* out);

/// Triangles of one state between the two steps of their setup.
struct alignas(64) TriangleGroup : RecordGroup {
  TriangleGroup(const SetupState& s, std::byte* memory) : RecordGroup(s, memory), vertex_bytes(kept_vertex_size(s)) {
    blank.binding = s.binding;
    blank.is_polygon = true;
  }

  void add(const WaitingTriangle& added) {
    triangle[count] = &added;
    for (std::size_t i = 0; i < 3; ++i) vertex[i][count] = &vertex_of(added, i, vertex_bytes);
    ++count;
  }

  std::size_t vertex_bytes;
  bool edges_of_all = false;  ///< else only of those that are not small
  bool all_small = false;     ///< goes the road of its plan's small_triangles; its set_up_depths too
  PrimitiveRecord blank;      ///< what each record begins as
  std::array<const WaitingTriangle*, group_capacity> triangle;
  /// From the first step for the second.
  alignas(64) Lanes basis[6];
  alignas(64) Lanes inverse_w[3];
};

/// Begins the record of a triangle. Its planes, edges and box are yet to be written.
inline PrimitiveRecord& begin_record(const TriangleGroup& group, std::size_t i) {
  static_assert(std::is_trivially_copyable_v<PrimitiveRecord>);
  PrimitiveRecord& record = group.record(i);
  std::memcpy(static_cast<void*>(&record), &group.blank, sizeof record);
  record.scissored = group.triangle[i]->scissored;
  record.back = group.triangle[i]->back;
  return record;
}

/// The first step writes the records without colours and varyings.
void set_up_depths(TriangleGroup& group);
/// The second writes the colours and varyings of those triangles whose bit is set.
void set_up_colors(const TriangleGroup& group, std::uint32_t triangles);

/// The whole record of a triangle, with its edges even if it is small: `record` is record_size bytes.
void set_up_triangle(const SetupState& state, const WaitingTriangle& triangle, std::byte* record);

/// The smooth shape of a triangle that select_triangles chose.
SmoothShape smooth_triangle(const SetupState& state, const WaitingTriangle& triangle);

}  // namespace gouraud::pipeline
