#include "pipeline/draw/tiles.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include "pipeline/framebuffer/accumulation.h"
#include "pipeline/framebuffer/clear.h"
#include "pipeline/raster/bitmaps.h"
#include "pipeline/raster/lines.h"
#include "pipeline/raster/sample_positions.h"
#include "pipeline/raster/smooth.h"

namespace gouraud::pipeline {
namespace {

/// The more waits, the more each tile has to do while it is in the cache. 200,000 small triangles (24 MiB) all over a
/// 1080p target take 70 ms with 8 MiB, 60 with 16, 57 with 32.
constexpr std::size_t arena_limit_per_thread = std::size_t{32} << 20;
constexpr std::size_t arena_limit_most = std::size_t{64} << 20;
constexpr std::size_t entry_limit = std::size_t{1} << 19;
/// Fewer bin entries than this are not worth waking a thread for.
constexpr std::size_t entries_worth_waking = 64;

/// What a tile's entries refer to lies scattered over the arena: it is fetched this many primitives ahead of its use, and
/// its state's binding and the vertices that triangles share this many. (To fetch depths as well has stopped to pay since runs are long.)
constexpr std::int32_t prefetch_distance = 64, prefetch_near_distance = 32;

/// A triangle that touches more tiles than this is set up once, before it is binned.
constexpr std::int32_t few_tiles = 4;

/// The first run of a state in a tile holds one primitive, and each further one twice as many, up to this: a draw of one
/// triangle takes no more memory than that. Long runs are for the tile: what lies on one page comes with few misses. (Runs
/// of eight lines cost 100,000 lines of 25 pixels 47 ms, runs of 32 cost 43.)
constexpr std::size_t longest_run_bytes = 4096;
static_assert(largest_waiting <= 0xFFFF && longest_run_bytes / sizeof(WaitingTriangle) <= 0xFF);

constexpr std::size_t largest_record =
    sizeof(ColoredPrimitive) + sizeof(VaryingRecord) + (max_varyings * sizeof(VaryingPlane) + 63) / 64 * 64;

/// The tile's pixels, for drawing: carries out the clears that wait there.
TileTarget tile_target(const Framebuffer& target, std::int32_t tile_x, std::int32_t tile_y, std::int32_t sample) {
  const auto pixels = [=](const TiledBuffer& plane) { return plane.empty() ? nullptr : plane.tile(tile_x, tile_y); };
  return {pixels(target.color), pixels(target.depth), pixels(target.stencil), sample};
}

/// The edge at the sample that lies farthest in, and not `fine` any more (EdgeFunction).
EdgeFunction moved_in(EdgeFunction edge) {
  const std::int64_t reach = sample_reach * (std::abs(std::int64_t{edge.a}) + std::abs(std::int64_t{edge.b}));
  edge.c = (edge.c + reach) >> subpixel_bits;
  return edge;
}

/// True if the edge has the whole tile on its outer side.
bool tile_is_outside(const EdgeFunction& edge, std::int32_t x, std::int32_t y) {
  const std::int64_t most = (edge.a > 0 ? std::int64_t{edge.a} * (tile_size - 1) : 0) +
                            (edge.b > 0 ? std::int64_t{edge.b} * (tile_size - 1) : 0);
  return edge.c + std::int64_t{edge.a} * x + std::int64_t{edge.b} * y + most < 0;
}

}  // namespace

/// In a large page where the kernel has one: triangles of a tile lie on many pages.
std::unique_ptr<Arena::Chunk> Arena::new_chunk() {
  std::unique_ptr<Chunk> chunk(new Chunk);
#if defined(__linux__)
  ::madvise(chunk.get(), sizeof(Chunk), MADV_HUGEPAGE);
#endif
  return chunk;
}

void* Arena::allocate(std::size_t bytes) {
  const std::size_t size = rounded(bytes);
  if (used_ + size > chunk_size) {
    if (!chunks_.empty()) ++full_chunks_;
    if (full_chunks_ >= chunks_.size()) chunks_.push_back(new_chunk());
    used_ = 0;
  }
  void* memory = chunks_[full_chunks_]->bytes + used_;
  used_ += size;
  return memory;
}

void Arena::reset() {
  full_chunks_ = 0;
  used_ = chunks_.empty() ? chunk_size : 0;
}

TileBins::TileBins(int thread_count)
    : arena_limit_(std::min(arena_limit_per_thread * static_cast<std::size_t>(thread_count), arena_limit_most)),
      workers_(thread_count) {}

void TileBins::set_target(Framebuffer* target) {
  target_ = target;
  sample_ = first_bin_ = 0;
  samples_.clear();
  if (target == nullptr) return;
  const auto bins = static_cast<std::size_t>(target->tile_count() * (samples_meet() ? 1 : target->samples));
  if (bins_.size() < bins) bins_.resize(bins);
  if (target->samples == 1) return;
  for (int sample = 0; sample < target->samples; ++sample) samples_.push_back(target->sample(sample));
}

const SetupState* TileBins::intern(SetupState setup, const RasterBinding& binding) {
  if (bindings_.empty() || !(bindings_.back() == binding)) bindings_.push_back(binding);
  setup.binding = &bindings_.back();
  if (setups_.empty() || !(setups_.back() == setup)) setups_.push_back(setup);
  return &setups_.back();
}

const TileBins::InternedTextures& TileBins::intern(const TexturingState& texturing, float output_scale) {
  if (texturings_.empty() || !(texturings_.back().state == texturing) || texturings_.back().units.output_scale != output_scale) {
    InternedTextures& made = texturings_.emplace_back();
    prepare_texture_units(texturing, output_scale, made.units);
    made.state = texturing;  // now that it cannot fail any more
  }
  return texturings_.back();
}

void TileBins::add_to_bin(std::int32_t bin_index, const Entry& entry) {
  std::vector<Entry>& bin = bins_[static_cast<std::size_t>(bin_index)];
  if (bin.empty()) touched_.push_back(bin_index);
  bin.push_back(entry);
  ++entry_count_;
}

void TileBins::add_to_run(std::int32_t tile, EntryKind kind, const SetupState& state, const void* from, std::size_t bytes) {
  const auto copy_to = [&](std::byte* to) {
    constexpr std::size_t part = sizeof(WaitingTriangle);
    static_assert(sizeof(KeptVertex) % part == 0 && sizeof(WaitingLine) % part == 0);
    for (std::size_t at = 0; at < bytes; at += part) std::memcpy(to + at, static_cast<const std::byte*>(from) + at, part);
  };
  std::vector<Entry>& bin = bins_[static_cast<std::size_t>(first_bin_ + tile)];
  std::uint8_t capacity = 1;
  if (!bin.empty() && bin.back().kind == kind && bin.back().state == &state && bin.back().bytes == bytes && bin.back().sample == sample_) {
    Entry& run = bin.back();
    if (run.count < run.capacity) {
      copy_to(static_cast<std::byte*>(const_cast<void*>(run.what)) + static_cast<std::size_t>(run.count) * bytes);
      ++run.count;
      ++entry_count_;
      return;
    }
    capacity = static_cast<std::uint8_t>(std::clamp<std::size_t>(longest_run_bytes / bytes, 1, 2 * std::size_t{run.capacity}));
  }
  auto* memory = static_cast<std::byte*>(arena_.allocate(capacity * bytes));
  for (std::size_t line = 0; line < capacity * bytes; line += 64) __builtin_prefetch(memory + line, 1);
  copy_to(memory);
  add(tile, {.what = memory, .kind = kind, .capacity = capacity, .bytes = static_cast<std::uint16_t>(bytes), .state = &state});
}

void TileBins::add_triangle(const SetupState& state, const WaitingTriangle& triangle, std::size_t bytes) {
  const std::int32_t first_x = triangle.x0 / tile_size, last_x = (triangle.x1 - 1) / tile_size;
  const std::int32_t first_y = triangle.y0 / tile_size, last_y = (triangle.y1 - 1) / tile_size;
  if ((last_x - first_x + 1) * (last_y - first_y + 1) > few_tiles) {
    auto* record = static_cast<std::byte*>(arena_.allocate(record_size(state)));
    set_up_triangle(state, triangle, record);
    return add_polygon(*reinterpret_cast<PrimitiveRecord*>(record));
  }
  for (std::int32_t y = first_y; y <= last_y; ++y) {
    for (std::int32_t x = first_x; x <= last_x; ++x) {
      add_to_run(y * target_->tiles_x + x, EntryKind::triangles, state, &triangle, bytes);
    }
  }
}

void TileBins::add_triangles(const SetupState& state, const std::byte* waiting, std::size_t count, bool share) {
  const std::size_t bytes = waiting_size(state, share);
  for (std::size_t i = 0; i < count; ++i) add_triangle(state, *reinterpret_cast<const WaitingTriangle*>(waiting + i * bytes), bytes);
}

void TileBins::add_polygon(const PrimitiveRecord& record) {
  const std::int32_t first_x = record.x0 / tile_size, last_x = (record.x1 - 1) / tile_size;
  const std::int32_t first_y = record.y0 / tile_size, last_y = (record.y1 - 1) / tile_size;
  const Entry entry{.what = &record, .kind = EntryKind::polygon};
  for (std::int32_t y = first_y; y <= last_y; ++y) {
    for (std::int32_t x = first_x; x <= last_x; ++x) {
      const auto outside = [&](const EdgeFunction& edge) {
        return tile_is_outside(record.binding->samples_apart ? moved_in(edge) : edge, x * tile_size, y * tile_size);
      };
      const bool misses = record.is_rectangle ? std::ranges::any_of(record.rectangle.all(), outside) : std::ranges::any_of(record.edges, outside);
      if (!misses) add(y * target_->tiles_x + x, entry);
    }
  }
}

void TileBins::add_line(const WaitingLine& line) {
  const std::int32_t first_x = line.x0 / tile_size, last_x = (line.x1 - 1) / tile_size;
  const std::int32_t first_y = line.y0 / tile_size, last_y = (line.y1 - 1) / tile_size;
  if ((last_x - first_x + 1) * (last_y - first_y + 1) > few_tiles) {
    void* record = arena_.allocate(record_size(*line.state));
    setup_waiting_line(line, record);
    return add_polygon(*static_cast<PrimitiveRecord*>(record));
  }
  for (std::int32_t y = first_y; y <= last_y; ++y) {
    for (std::int32_t x = first_x; x <= last_x; ++x) {
      add_to_run(y * target_->tiles_x + x, EntryKind::lines, *line.state, &line, sizeof line);
    }
  }
}

void TileBins::add_point(const SetupState& state, const WaitingPoint& point) {
  const std::int32_t tile = point.y / tile_size * target_->tiles_x + point.x / tile_size;
  std::vector<Entry>& bin = bins_[static_cast<std::size_t>(first_bin_ + tile)];
  if (!bin.empty() && bin.back().kind == EntryKind::points && bin.back().sample == sample_) {
    PointChunk& chunk = *static_cast<PointChunk*>(const_cast<void*>(bin.back().what));
    if (chunk.state == &state && chunk.count < PointChunk::capacity) {
      chunk.point[static_cast<std::size_t>(chunk.count++)] = point;
      return;
    }
  }
  auto* chunk = new (arena_.allocate(sizeof(PointChunk))) PointChunk;
  chunk->state = &state;
  chunk->point[0] = point;
  chunk->count = 1;
  add(tile, {.what = chunk, .kind = EntryKind::points});
}

/// The points one after the other: a later one may hide or blend with an earlier one of its pixel.
void TileBins::run_points(const PointChunk& chunk, std::int32_t x, std::int32_t y, const TileTarget& pixels) {
  alignas(64) std::array<std::byte, sizeof(ColoredPrimitive)> memory;
  const auto& record = *reinterpret_cast<const PrimitiveRecord*>(memory.data());
  FragmentBlock block;
  block.primitive = &record;
  for (const WaitingPoint& point : std::span(chunk.point).first(static_cast<std::size_t>(chunk.count))) {
    setup_waiting_point(*chunk.state, point, memory.data());
    const std::int32_t column = point.x - x, row = point.y - y;
    block.x = x + column / block_size * block_size;
    block.y = y + row / block_size * block_size;
    block.first_pixel = (row / block_size * blocks_per_tile_row + column / block_size) * pixels_per_block;
    block.coverage = std::uint64_t{1} << (row % block_size * block_size + column % block_size);
    run_passes(record.binding->passes, block, pixels);
  }
}

template <class Box>
void TileBins::add_box(const Box& box, const Entry& entry) {
  for (std::int32_t y = box.y0 / tile_size; y <= (box.y1 - 1) / tile_size; ++y) {
    for (std::int32_t x = box.x0 / tile_size; x <= (box.x1 - 1) / tile_size; ++x) add(y * target_->tiles_x + x, entry);
  }
}

void TileBins::add_smooth(const PrimitiveRecord& record) { add_box(record, {.what = &record, .kind = EntryKind::smooth}); }
void TileBins::add_smooth(const SmoothPolygon& polygon) { add_box(polygon, {.what = &polygon, .kind = EntryKind::smooth_polygon}); }

void TileBins::flush_block_list(const PrimitiveRecord& record, std::int32_t tile) {
  if (block_list_.empty()) return;
  const std::size_t bytes = block_list_.size() * sizeof(BlockMask);
  auto* blocks = static_cast<BlockMask*>(arena_.allocate(bytes));
  std::memcpy(blocks, block_list_.data(), bytes);
  add(tile, {.what = &record, .kind = EntryKind::blocks, .count = static_cast<std::int32_t>(block_list_.size()), .blocks = blocks});
  block_list_.clear();
}

void TileBins::add_pixels(const PrimitiveRecord& record, std::span<const PixelPosition> pixels, const PixelRect& scissor) {
  std::int32_t tile = -1;
  for (const PixelPosition& pixel : pixels) {
    if (pixel.x < scissor.x0 || pixel.x >= scissor.x1 || pixel.y < scissor.y0 || pixel.y >= scissor.y1) continue;
    const std::int32_t pixel_tile = pixel.y / tile_size * target_->tiles_x + pixel.x / tile_size;
    if (pixel_tile != tile) {
      flush_block_list(record, tile);
      tile = pixel_tile;
    }
    const std::int32_t block = pixel.y % tile_size / block_size * blocks_per_tile_row + pixel.x % tile_size / block_size;
    if (block_list_.empty() || block_list_.back().block != block) block_list_.push_back({0, block});
    block_list_.back().coverage |= std::uint64_t{1} << (pixel.y % block_size * block_size + pixel.x % block_size);
  }
  flush_block_list(record, tile);
}

void TileBins::add_bitmap(const PrimitiveRecord& record, const Bitmap& bitmap) {
  const PixelRect clip{record.x0, record.y0, record.x1, record.y1}, box = bitmap_box(bitmap, clip);
  if (box.empty()) return;
  for (std::int32_t y = box.y0 / tile_size; y <= (box.y1 - 1) / tile_size; ++y) {
    for (std::int32_t x = box.x0 / tile_size; x <= (box.x1 - 1) / tile_size; ++x) {
      find_bitmap_blocks(bitmap, clip, x * tile_size, y * tile_size, block_list_);
      flush_block_list(record, y * target_->tiles_x + x);
    }
  }
}

void TileBins::add_to_tiles(const PixelRect& box, const Entry& entry) {
  if (box.empty()) return;
  for (int sample = 0; sample < (samples_meet() ? 1 : target_->samples); ++sample) {
    const std::int32_t first = sample * target_->tile_count();
    for (std::int32_t y = box.y0 / tile_size; y <= (box.y1 - 1) / tile_size; ++y) {
      for (std::int32_t x = box.x0 / tile_size; x <= (box.x1 - 1) / tile_size; ++x) {
        add_to_bin(first + y * target_->tiles_x + x, entry);
      }
    }
  }
}

void TileBins::add_clear(const ClearState& state) {
  add_to_tiles(state.scissor, {.what = &clears_.emplace_back(state), .kind = EntryKind::clear});
}

void TileBins::add_accum(const AccumState& state) {
  add_to_tiles(state.scissor, {.what = &accums_.emplace_back(state), .kind = EntryKind::accum});
}

bool TileBins::full() const {
  return arena_.used() > arena_limit_ || entry_count_ > entry_limit;
}

/// Fetches what the entries of a bin refer to, some way ahead of the one that is run.
class TileBins::LookAhead {
 public:
  explicit LookAhead(std::span<const Entry> bin) : bin_(bin) { fetch(); }

  /// Entry `i` has been run: they are in order.
  void pass(std::size_t i) {
    ahead_ -= bin_[i].count;
    near_ahead_ -= bin_[i].count;
    fetch();
  }

 private:
  void fetch() {
    for (; fetched_ < bin_.size() && ahead_ < prefetch_distance; ahead_ += bin_[fetched_++].count) {
      if (has_new_state(fetched_)) prefetch(bin_[fetched_].state, sizeof(SetupState));
      prefetch(bin_[fetched_]);
    }
    for (; near_fetched_ < bin_.size() && near_ahead_ < prefetch_near_distance; near_ahead_ += bin_[near_fetched_++].count) {
      if (has_new_state(near_fetched_)) prefetch(bin_[near_fetched_].state->binding, sizeof(RasterBinding));
      if (bin_[near_fetched_].kind == EntryKind::triangles) prefetch_vertices(bin_[near_fetched_]);
    }
  }

  bool has_new_state(std::size_t i) const { return bin_[i].state != nullptr && (i == 0 || bin_[i].state != bin_[i - 1].state); }
  static void prefetch(const void* what, std::size_t size) {
    for (std::size_t line = 0; line < size; line += 64) __builtin_prefetch(static_cast<const std::byte*>(what) + line);
  }

  static void prefetch(const Entry& entry) {
    const std::size_t size = entry.bytes > 0 ? static_cast<std::size_t>(entry.count) * entry.bytes : sizeof(ColoredPrimitive);
    prefetch(entry.what, size);
  }

  static void prefetch_vertices(const Entry& entry) {
    const std::size_t vertex_bytes = kept_vertex_size(*entry.state);
    const auto* triangles = static_cast<const std::byte*>(entry.what);
    for (std::size_t i = 0; i < static_cast<std::size_t>(entry.count); ++i) {
      const auto& triangle = *reinterpret_cast<const WaitingTriangle*>(triangles + i * entry.bytes);
      if (triangle.shared == nullptr) return;  // none of the run shares any
      for (std::size_t k = 0; k < 3; ++k) __builtin_prefetch(&vertex_of(triangle, k, vertex_bytes));
    }
  }

  std::span<const Entry> bin_;
  std::size_t fetched_ = 0, near_fetched_ = 0;  ///< the first entry that is not
  std::int32_t ahead_ = 0, near_ahead_ = 0;     ///< primitives before it that have not been run
};

/// Makes it the head of `block`.
void place_block(const TriangleGroup& group, const SeenBlock& found, FragmentBlock& block) {
  block.coverage = found.coverage;
  block.x = found.x;
  block.y = found.y;
  block.first_pixel = found.first_pixel;
  block.primitive = &group.record(static_cast<std::size_t>(found.primitive));
}

/// Leaves what they leave of the blocks; returns their number.
std::size_t run_early_passes(const TriangleGroup& group, std::span<SeenBlock> blocks, const TileTarget& pixels) {
  const FragmentPasses& passes = group.state->binding->passes;
  FragmentBlock block;
  std::size_t count = 0;
  for (const SeenBlock& found : blocks) {
    place_block(group, found, block);
    run_passes(passes, 0, passes.early, block, pixels);
    blocks[count] = found;
    blocks[count].coverage = block.coverage;
    count += block.coverage != 0 ? 1 : 0;
  }
  return count;
}

/// A group goes through depth setup, coverage and the early passes before any of it is coloured, and what is hidden never
/// is. Among themselves the blocks keep their order in both halves.
void TileBins::run_group(TriangleGroup& group, std::int32_t x, std::int32_t y, const TileTarget& pixels, GroupRasterizer rasterize) {
  if (group.count == 0) return;
  std::array<SeenBlock, most_seen_blocks> seen;
  std::size_t count = 0;
  if (group.all_small) {
    count = group.state->binding->passes.small_triangles.one(group, x, y, pixels, seen.data());
  } else {
    set_up_depths(group);
    count = rasterize(group, x, y, seen.data());
    const GroupDepthTest test = group.state->binding->passes.group_depth;
    count = test != nullptr ? test(group, seen.data(), count, pixels) : run_early_passes(group, std::span(seen).first(count), pixels);
  }
  std::uint32_t seen_triangles = 0;
  for (const SeenBlock& found : std::span(seen).first(count)) seen_triangles |= 1u << found.primitive;
  if (seen_triangles != 0) set_up_colors(group, seen_triangles);
  const FragmentPasses& passes = group.state->binding->passes;
  FragmentBlock block;
  for (const SeenBlock& found : std::span(seen).first(count)) {
    place_block(group, found, block);
    run_passes(passes, passes.early, passes.count, block, pixels);
  }
  group.count = 0;
}

template <class RunGroup>
std::size_t TileBins::run_triangles(std::span<const Entry> entries, const RunGroup& run_group) {
  const SetupState& state = *entries[0].state;
  alignas(64) std::array<std::byte, group_capacity * largest_record> records;
  TriangleGroup group(state, records.data());
  const bool has_road = state.binding->passes.small_triangles.one != nullptr;
  std::size_t done = 0, ahead = 0;
  for (; done < entries.size() && entries[done].kind == EntryKind::triangles && entries[done].state == &state &&
         entries[done].sample == entries[0].sample; ++done) {
    if (ahead >= static_cast<std::size_t>(prefetch_near_distance)) break;  // let what comes next be fetched
    const Entry& run = entries[done];
    const auto* first = static_cast<const std::byte*>(run.what);
    for (std::size_t i = 0; i < static_cast<std::size_t>(run.count); ++i) {
      const auto& triangle = *reinterpret_cast<const WaitingTriangle*>(first + i * run.bytes);
      const bool small = has_road && triangle.small();
      if (small != group.all_small) run_group(group);
      group.all_small = small;
      group.add(triangle);
      if (group.count == group_capacity) run_group(group);
    }
    ahead += static_cast<std::size_t>(run.count);
  }
  run_group(group);
  return done;
}

void TileBins::run_lines(const Entry& entry, std::int32_t x, std::int32_t y, const TileTarget& pixels, PolygonRasterizer rasterize) {
  const std::span lines(static_cast<const WaitingLine*>(entry.what), static_cast<std::size_t>(entry.count));
  const bool thin = entry.state->lines.width_px == 1.0f;
  const std::size_t bytes = record_size(*entry.state);
  alignas(64) std::array<std::byte, group_capacity * sizeof(ColoredPrimitive)> records;
  for (std::size_t first = 0; first < lines.size(); first += group_capacity) {
    const std::size_t count = std::min(group_capacity, lines.size() - first);
    setup_waiting_lines(lines.subspan(first, count), records.data());
    for (std::size_t i = 0; i < count; ++i) {
      const auto& record = *reinterpret_cast<const PrimitiveRecord*>(records.data() + i * bytes);
      thin ? rasterize_thin_line(record, x, y, pixels) : rasterize(record, x, y, pixels);
    }
  }
}

void TileBins::run_blocks(const Entry& entry, std::int32_t x, std::int32_t y, const TileTarget& pixels) {
  FragmentBlock block;
  block.primitive = static_cast<const PrimitiveRecord*>(entry.what);
  for (const BlockMask& mask : std::span(entry.blocks, static_cast<std::size_t>(entry.count))) {
    block.coverage = mask.coverage;
    block.x = x + mask.block % blocks_per_tile_row * block_size;
    block.y = y + mask.block / blocks_per_tile_row * block_size;
    block.first_pixel = mask.block * pixels_per_block;
    run_passes(block.primitive->binding->passes, block, pixels);
  }
}

/// The samples that an entry is for, when it is for all: those of its binding.
std::uint32_t TileBins::samples_of(const Entry& entry) {
  switch (entry.kind) {
    case EntryKind::triangles:
    case EntryKind::lines: return entry.state->binding->sample_mask;
    case EntryKind::points: return static_cast<const PointChunk*>(entry.what)->state->binding->sample_mask;
    case EntryKind::smooth_polygon: return static_cast<const SmoothPolygon*>(entry.what)->part[0]->binding->sample_mask;
    case EntryKind::polygon:
    case EntryKind::smooth:
    case EntryKind::blocks: return static_cast<const PrimitiveRecord*>(entry.what)->binding->sample_mask;
    case EntryKind::clear:
    case EntryKind::accum: break;
  }
  return ~0u;
}

/// An entry that stands for itself, to one sample.
void TileBins::run_entry(const Entry& entry, std::int32_t x, std::int32_t y, const TileTarget& pixels, const Rasterizers& rasterize) {
  switch (entry.kind) {
    case EntryKind::polygon: return rasterize.polygon(*static_cast<const PrimitiveRecord*>(entry.what), x, y, pixels);
    case EntryKind::lines: return run_lines(entry, x, y, pixels, rasterize.polygon);
    case EntryKind::points: return run_points(*static_cast<const PointChunk*>(entry.what), x, y, pixels);
    case EntryKind::smooth: {
      const auto& record = *static_cast<const PrimitiveRecord*>(entry.what);
      return record.shape->rasterize(record, x, y, pixels);
    }
    case EntryKind::smooth_polygon: return rasterize_smooth(*static_cast<const SmoothPolygon*>(entry.what), x, y, pixels);
    case EntryKind::blocks: return run_blocks(entry, x, y, pixels);
    case EntryKind::triangles:
    case EntryKind::clear:
    case EntryKind::accum: break;
  }
}

void TileBins::run_bin(std::int32_t bin_index, const Rasterizers& rasterize) {
  std::vector<Entry>& bin = bins_[static_cast<std::size_t>(bin_index)];
  const std::int32_t tiles = target_->tile_count(), tile = bin_index % tiles;
  const std::int32_t first_sample = bin_index / tiles, samples = samples_meet() ? target_->samples : 1;
  const auto target_of = [&](std::int32_t k) -> const Framebuffer& {
    return samples_.empty() ? *target_ : samples_[static_cast<std::size_t>(first_sample + k)];
  };
  const std::int32_t tile_x = tile % target_->tiles_x, tile_y = tile / target_->tiles_x;
  const std::int32_t x = tile_x * tile_size, y = tile_y * tile_size;
  LookAhead look_ahead(bin);
  SampleTargets all_pixels;  // of the bin's samples
  bool touched = false;      // they are valid: no clear since, no accumulation
  for (std::size_t i = 0; i < bin.size();) {
    const Entry& entry = bin[i];
    std::size_t done = 1;
    const bool draws = entry.kind != EntryKind::clear && entry.kind != EntryKind::accum;
    for (std::int32_t k = 0; draws && !touched && k < samples; ++k) {
      all_pixels[static_cast<std::size_t>(k)] = tile_target(target_of(k), tile_x, tile_y, first_sample + k);
    }
    touched = draws;
    const bool into_all = entry.sample == all_samples;
    const std::uint32_t wanted = into_all ? samples_of(entry) : 1u << (draws ? entry.sample - first_sample : 0);
    if (entry.kind == EntryKind::accum) {
      for (std::int32_t k = 0; k < samples; ++k) accumulate_tile(target_of(k), tile, *static_cast<const AccumState*>(entry.what));
    } else if (entry.kind == EntryKind::clear) {
      for (std::int32_t k = 0; k < samples; ++k) clear_tile(target_of(k), tile, *static_cast<const ClearState*>(entry.what));
    } else if (entry.kind == EntryKind::triangles) {
      const std::span entries = std::span(bin).subspan(i);
      if (into_all) {
        const SampleTargets targets = place_samples(all_pixels, *entry.state->binding);
        done = run_triangles(entries, [&](TriangleGroup& group) { run_group(group, x, y, targets, rasterize); });
      } else {
        const TileTarget& pixels = all_pixels[static_cast<std::size_t>(entry.sample - first_sample)];
        done = run_triangles(entries, [&](TriangleGroup& group) { run_group(group, x, y, pixels, rasterize.group); });
      }
    } else if (into_all && entry.kind == EntryKind::polygon) {
      run_polygon(*static_cast<const PrimitiveRecord*>(entry.what), x, y, all_pixels, rasterize.sample_blocks);
    } else {
      for (std::int32_t k = 0; k < samples; ++k) {
        if ((wanted >> k & 1) != 0) run_entry(entry, x, y, all_pixels[static_cast<std::size_t>(k)], rasterize);
      }
    }
    for (const std::size_t end = i + done; i < end; ++i) look_ahead.pass(i);
  }
  bin.clear();
}

void TileBins::run() {
  if (touched_.empty()) return;
  const Rasterizers rasterize{polygon_rasterizer(), group_rasterizer(), sample_block_finder(), sample_mask_cutter()};
  workers_.run(static_cast<std::int32_t>(touched_.size()), entry_count_ >= entries_worth_waking,
               [&](std::int32_t i) { run_bin(touched_[static_cast<std::size_t>(i)], rasterize); });
  touched_.clear();
  entry_count_ = 0;
  bindings_.clear();
  texturings_.clear();
  setups_.clear();
  clears_.clear();
  accums_.clear();
  arena_.reset();
  ++generation_;
}

}  // namespace gouraud::pipeline
