#include "pipeline/draw/tiles.h"

#include <algorithm>
#include <cstring>

#include "pipeline/framebuffer/clear.h"

namespace gouraud::pipeline {
namespace {

/// More waiting records give each tile more to do while it is in the cache, until they fall out of the last-level cache
/// themselves: measured best between 8 and 16 MiB a core with 200,000 small triangles all over a 1080p target.
constexpr std::size_t arena_limit_per_thread = std::size_t{8} << 20;
constexpr std::size_t arena_limit_most = std::size_t{32} << 20;
constexpr std::size_t entry_limit = std::size_t{1} << 19;
/// Fewer bin entries than this are not worth waking a thread for.
constexpr std::size_t entries_worth_waking = 64;

/// Records of a tile lie scattered over the arena: they are fetched this many entries ahead of their use.
constexpr std::size_t prefetch_distance = 5;

void prefetch_record(const void* record) {
  const auto* bytes = static_cast<const std::byte*>(record);
  for (std::size_t line = 0; line < sizeof(ColoredPrimitive); line += 64) __builtin_prefetch(bytes + line);
}

/// Fetches the depths that a small polygon is about to be tested against; large ones stream through memory anyway.
void prefetch_depth(const PrimitiveRecord& record, std::int32_t tile_x, std::int32_t tile_y, const Framebuffer& target,
                    const std::byte* depth) {
  constexpr std::int32_t small = 2 * block_size;
  if (record.x1 - record.x0 > small || record.y1 - record.y0 > small) return;
  const std::int32_t x0 = std::max(record.x0 - tile_x, 0) / block_size, x1 = (std::min(record.x1 - tile_x, tile_size) - 1) / block_size;
  const std::int32_t y0 = std::max(record.y0 - tile_y, 0), y1 = std::min(record.y1 - tile_y, tile_size);
  for (std::int32_t x = x0; x <= x1; ++x) {
    for (std::int32_t y = y0 & ~1; y < y1; y += 2) {
      const std::int32_t pixel = (y / block_size * blocks_per_tile_row + x) * pixels_per_block + y % block_size * block_size;
      __builtin_prefetch(depth + pixel * target.depth.bytes_per_pixel(), 1);
    }
  }
}

/// True if the edge has the whole tile on its outer side.
bool tile_is_outside(const EdgeFunction& edge, std::int32_t x, std::int32_t y) {
  const std::int64_t most = (edge.a > 0 ? std::int64_t{edge.a} * (tile_size - 1) : 0) +
                            (edge.b > 0 ? std::int64_t{edge.b} * (tile_size - 1) : 0);
  return edge.c + std::int64_t{edge.a} * x + std::int64_t{edge.b} * y + most < 0;
}

}  // namespace

void* Arena::allocate(std::size_t bytes) {
  const std::size_t size = rounded(bytes);
  if (used_ + size > chunk_size) {
    if (!chunks_.empty()) ++full_chunks_;
    if (full_chunks_ >= chunks_.size()) chunks_.emplace_back(new Chunk);
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
  bins_.clear();
  if (target_ != nullptr) bins_.resize(static_cast<std::size_t>(target_->tile_count()));
}

const RasterBinding* TileBins::intern(const RasterBinding& binding) {
  if (bindings_.empty() || !(bindings_.back() == binding)) bindings_.push_back(binding);
  return &bindings_.back();
}

void TileBins::add(std::int32_t tile, const Entry& entry) {
  std::vector<Entry>& bin = bins_[static_cast<std::size_t>(tile)];
  if (bin.empty()) touched_.push_back(tile);
  bin.push_back(entry);
  ++entry_count_;
}

void TileBins::add_polygon(const PrimitiveRecord& record) {
  const std::int32_t first_x = record.x0 / tile_size, last_x = (record.x1 - 1) / tile_size;
  const std::int32_t first_y = record.y0 / tile_size, last_y = (record.y1 - 1) / tile_size;
  const Entry entry{&record, nullptr, 0, EntryKind::polygon};
  if (first_x == last_x && first_y == last_y) return add(first_y * target_->tiles_x + first_x, entry);
  for (std::int32_t y = first_y; y <= last_y; ++y) {
    for (std::int32_t x = first_x; x <= last_x; ++x) {
      const auto outside = [&](const EdgeFunction& edge) { return tile_is_outside(edge, x * tile_size, y * tile_size); };
      if (std::none_of(record.edges.begin(), record.edges.end(), outside)) add(y * target_->tiles_x + x, entry);
    }
  }
}

void TileBins::flush_block_list(const PrimitiveRecord& record, std::int32_t tile) {
  if (block_list_.empty()) return;
  const std::size_t bytes = block_list_.size() * sizeof(BlockMask);
  auto* blocks = static_cast<BlockMask*>(arena_.allocate(bytes));
  std::memcpy(blocks, block_list_.data(), bytes);
  add(tile, {&record, blocks, static_cast<std::int32_t>(block_list_.size()), EntryKind::blocks});
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

void TileBins::add_clear(const ClearState& state) {
  const ClearState& kept = clears_.emplace_back(state);
  const PixelRect& box = state.scissor;
  if (box.empty()) return;
  for (std::int32_t y = box.y0 / tile_size; y <= (box.y1 - 1) / tile_size; ++y) {
    for (std::int32_t x = box.x0 / tile_size; x <= (box.x1 - 1) / tile_size; ++x) {
      add(y * target_->tiles_x + x, {&kept, nullptr, 0, EntryKind::clear});
    }
  }
}

bool TileBins::full() const {
  return arena_.used() > arena_limit_ || entry_count_ > entry_limit;
}

void TileBins::run_tile(std::int32_t tile, PolygonRasterizer rasterize) {
  std::vector<Entry>& bin = bins_[static_cast<std::size_t>(tile)];
  const TileTarget pixels{target_->color.empty() ? nullptr : target_->color.tile(tile),
                          target_->depth.empty() ? nullptr : target_->depth.tile(tile)};
  const std::int32_t x = tile % target_->tiles_x * tile_size, y = tile / target_->tiles_x * tile_size;
  for (std::size_t i = 0; i < bin.size(); ++i) {
    const Entry& entry = bin[i];
    prefetch_record(bin[std::min(i + prefetch_distance, bin.size() - 1)].what);
    if (const Entry& soon = bin[std::min(i + 2, bin.size() - 1)]; soon.kind == EntryKind::polygon && pixels.depth != nullptr) {
      prefetch_depth(*static_cast<const PrimitiveRecord*>(soon.what), x, y, *target_, pixels.depth);
    }
    switch (entry.kind) {
      case EntryKind::clear: clear_tile(*target_, tile, *static_cast<const ClearState*>(entry.what)); break;
      case EntryKind::polygon: rasterize(*static_cast<const PrimitiveRecord*>(entry.what), x, y, pixels); break;
      case EntryKind::blocks: {
        FragmentBlock block;
        block.primitive = static_cast<const PrimitiveRecord*>(entry.what);
        for (const BlockMask& mask : std::span(entry.blocks, static_cast<std::size_t>(entry.block_count))) {
          block.coverage = mask.coverage;
          block.x = x + mask.block % blocks_per_tile_row * block_size;
          block.y = y + mask.block / blocks_per_tile_row * block_size;
          block.first_pixel = mask.block * pixels_per_block;
          run_passes(block.primitive->binding->passes, block, pixels);
        }
        break;
      }
    }
  }
  bin.clear();
}

void TileBins::run() {
  if (touched_.empty()) return;
  const PolygonRasterizer rasterize = polygon_rasterizer();
  workers_.run(static_cast<std::int32_t>(touched_.size()), entry_count_ >= entries_worth_waking,
               [&](std::int32_t i) { run_tile(touched_[static_cast<std::size_t>(i)], rasterize); });
  touched_.clear();
  entry_count_ = 0;
  bindings_.clear();
  clears_.clear();
  arena_.reset();
}

}  // namespace gouraud::pipeline
