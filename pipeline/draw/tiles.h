// Tile bins: primitives and clears wait here, per 64x64 tile and in the order of submission, until they are rasterized.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "pipeline/draw/draw_state.h"
#include "pipeline/draw/worker_pool.h"
#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/pixel_image.h"
#include "pipeline/raster/polygons.h"
#include "pipeline/raster/primitive.h"
#include "pipeline/raster/sample_blocks.h"
#include "pipeline/raster/setup.h"
#include "pipeline/raster/triangles.h"
#include "pipeline/texture/texture_units.h"

namespace gouraud::pipeline {

/// Memory that is taken in order and given back all at once.
class Arena {
 public:
  /// `bytes` of memory, aligned to 64 bytes; throws std::bad_alloc. `bytes` is at most chunk_size.
  void* allocate(std::size_t bytes);
  /// Gives back the last `bytes` taken by the last allocate().
  void take_back(std::size_t bytes) { used_ -= rounded(bytes); }
  void reset();
  std::size_t used() const { return full_chunks_ * chunk_size + used_; }

 private:
  static constexpr std::size_t chunk_size = std::size_t{1} << 21;  ///< one large page
  static constexpr std::size_t rounded(std::size_t bytes) { return (bytes + 63) / 64 * 64; }
  struct alignas(chunk_size) Chunk {
    std::byte bytes[chunk_size];
  };
  static std::unique_ptr<Chunk> new_chunk();

  std::vector<std::unique_ptr<Chunk>> chunks_;
  std::size_t full_chunks_ = 0;
  std::size_t used_ = chunk_size;  ///< of the chunk in use; none at first
};

class TileBins {
 public:
  explicit TileBins(int thread_count);

  /// What is pending must have been run. Cheap: bins keep their memory for the next target.
  void set_target(Framebuffer* target);
  Framebuffer* target() const { return target_; }

  /// The shared copies of what a draw's primitives refer to, good until the next run(). Equal consecutive ones share.
  /// `setup.binding` is replaced by the copy of `binding`.
  const SetupState* intern(SetupState setup, const RasterBinding& binding);

  /// The same for the textures of a draw, which a binding points to.
  struct InternedTextures {
    TexturingState state;
    TextureUnits units;  ///< made of it
  };
  const InternedTextures& intern(const TexturingState& texturing, float output_scale);

  /// Memory until the next run(), 64-byte aligned, for triangles and records; take_back() returns the end of the last.
  void* allocate(std::size_t bytes) { return arena_.allocate(bytes); }
  void take_back(std::size_t bytes) { arena_.take_back(bytes); }

  /// Which sample of each pixel the next primitives are for. Clears are for all. What is drawn goes into all at once, if its
  /// binding has a sample_mask.
  static constexpr std::int32_t all_samples = -1;
  void select_sample(std::int32_t sample) {
    sample_ = sample;
    first_bin_ = samples_meet() ? 0 : sample * target_->tile_count();
  }
  std::int32_t selected_sample() const { return sample_; }
  /// `count` triangles as select_triangles() wrote them, waiting_size bytes each: they are copied, and what they share
  /// has to be in memory of allocate().
  void add_triangles(const SetupState& state, const std::byte* waiting, std::size_t count, bool share);
  /// Every pixel inside the record's edges and box.
  void add_polygon(const PrimitiveRecord& record);
  /// Copied too.
  void add_line(const WaitingLine& line);
  void add_point(const SetupState& state, const WaitingPoint& point);
  /// Every pixel of the record's box that its shape touches, as the shape's rasterizer sees it.
  void add_smooth(const PrimitiveRecord& record);
  /// Every pixel that the triangles of a smooth polygon touch.
  void add_smooth(const SmoothPolygon& polygon);
  /// Fragments at these pixels, each once; those outside `scissor` are left out.
  void add_pixels(const PrimitiveRecord& record, std::span<const PixelPosition> pixels, const PixelRect& scissor);
  void add_clear(const ClearState& state);
  void add_accum(const AccumState& state);
  /// Fragments at the bits that are set, each once, inside the record's box.
  void add_bitmap(const PrimitiveRecord& record, const Bitmap& bitmap);

  bool pending() const { return !touched_.empty(); }
  /// True when so much waits that it should be rasterized now.
  bool full() const;
  /// Counts runs: what allocate() gave is good as long as this stays the same.
  std::uint64_t generation() const { return generation_; }
  /// Rasterizes all that waits.
  void run();

 private:
  /// Small triangles and lines wait for their setup by the tile, in runs of one state: one behind the other in memory,
  /// so that a tile reads them as they come. A polygon has been set up because many tiles share it.
  enum class EntryKind : std::uint8_t { triangles, lines, polygon, smooth, smooth_polygon, points, blocks, clear, accum };
  struct Entry {
    /// WaitingTriangles, WaitingLines, a PointChunk, a ClearState, an AccumState, or the others' PrimitiveRecord.
    const void* what = nullptr;
    EntryKind kind = EntryKind::polygon;
    std::uint8_t capacity = 1;   ///< of a run
    std::uint16_t bytes = 0;     ///< of each primitive of a run
    std::int16_t sample = 0;     ///< or all_samples
    std::int32_t count = 1;      ///< triangles or lines of a run, blocks of a list
    const SetupState* state = nullptr;  ///< of a run
    const BlockMask* blocks = nullptr;
  };
  template <class Box>
  void add_box(const Box& box, const Entry& entry);
  void add_to_tiles(const PixelRect& box, const Entry& entry);
  void add_triangle(const SetupState& state, const WaitingTriangle& triangle, std::size_t bytes);
  void add_to_run(std::int32_t tile, EntryKind kind, const SetupState& state, const void* from, std::size_t bytes);
  /// A bin holds what all samples of its tile wait for, in order; else (antialiasing.h has many) each sample has bins of its own.
  bool samples_meet() const { return target_->samples <= max_samples; }
  static void run_points(const PointChunk& chunk, std::int32_t x, std::int32_t y, const TileTarget& pixels);
  void add(std::int32_t tile, Entry entry) {
    entry.sample = static_cast<std::int16_t>(sample_);
    add_to_bin(first_bin_ + tile, entry);
  }
  void add_to_bin(std::int32_t bin_index, const Entry& entry);
  void flush_block_list(const PrimitiveRecord& record, std::int32_t tile);
  struct Rasterizers {
    PolygonRasterizer polygon;
    GroupRasterizer group;
    SampleBlockFinder sample_blocks;
    SampleMaskCutter cut_masks;
  };
  static void run_polygon(const PrimitiveRecord& polygon, std::int32_t x, std::int32_t y, const SampleTargets& pixels,
                          SampleBlockFinder find);
  static void run_group(TriangleGroup& group, std::int32_t x, std::int32_t y, const SampleTargets& targets, const Rasterizers& rasterize);
  static std::uint32_t samples_of(const Entry& entry);
  static void run_entry(const Entry& entry, std::int32_t x, std::int32_t y, const TileTarget& pixels, const Rasterizers& rasterize);
  static std::size_t find_seen(const TriangleGroup& group, std::int32_t x, std::int32_t y, const SampleTargets& targets,
                               const Rasterizers& rasterize, SampleBlock* seen);
  void run_bin(std::int32_t bin_index, const Rasterizers& rasterize);
  static void run_group(TriangleGroup& group, std::int32_t x, std::int32_t y, const TileTarget& pixels, GroupRasterizer rasterize);
  /// The first entry and triangles of equal state right after it: `run` takes each group. Returns the number of entries done.
  template <class RunGroup>
  static std::size_t run_triangles(std::span<const Entry> entries, const RunGroup& run);
  static void run_lines(const Entry& entry, std::int32_t x, std::int32_t y, const TileTarget& pixels, PolygonRasterizer rasterize);
  static void run_blocks(const Entry& entry, std::int32_t x, std::int32_t y, const TileTarget& pixels);
  class LookAhead;

  Framebuffer* target_ = nullptr;
  std::vector<Framebuffer> samples_;  ///< the target's; empty if it has one sample
  std::int32_t sample_ = 0;           ///< that is selected
  std::int32_t first_bin_ = 0;        ///< its first bin
  Arena arena_;
  std::deque<RasterBinding> bindings_;
  std::deque<InternedTextures> texturings_;
  std::deque<SetupState> setups_;
  std::deque<ClearState> clears_;
  std::deque<AccumState> accums_;
  std::vector<std::vector<Entry>> bins_;  ///< one for each tile, or (see samples_meet) for each tile of each sample, sample after sample
  std::vector<std::int32_t> touched_;  ///< bins with entries
  std::size_t entry_count_ = 0;
  std::uint64_t generation_ = 0;
  std::vector<BlockMask> block_list_;  ///< of the pixels being added
  std::size_t arena_limit_;
  WorkerPool workers_;
};

}  // namespace gouraud::pipeline
