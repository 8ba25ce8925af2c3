// The textured units of a draw, ready for kernels: what the raster binding refers to. Made once a change of state.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/draw/limits.h"
#include "pipeline/draw/texture_state.h"
#include "pipeline/raster/fragment_block.h"
#include "pipeline/texture/image.h"

namespace gouraud::pipeline {

/// One level of one face. An axis' texels lie `stride` texels apart (rows), or by the layout of tiles.
struct PreparedLevel {
  const std::byte* texels = nullptr;
  std::array<std::int32_t, 3> size{1, 1, 1};  ///< without border
  std::array<std::int32_t, 3> border{};       ///< width along each axis
  std::array<std::int32_t, 3> stride{1, 0, 0};  ///< of rows; of tiles, [1] is the number of tiles in a row of them, [2] the pixels of a slice
  bool tiled = false;
  const Image* image = nullptr;
};

/// The filtered texels of a block: R, G, B, A of each lane, as [GL1.5 Table 3.21] has them.
struct TexelBlock {
  alignas(64) std::array<std::array<float, 64>, 4> channel;
};

/// What is read along one axis: parts of a texel's offset from the level's start, which add up over the axes; and the
/// second texel's share. Negative offsets: the border colour.
struct AxisTexels {
  alignas(64) std::array<std::int32_t, 64> first, second;
  alignas(64) std::array<float, 64> weight;
};

struct PreparedUnit;

/// Reads one level: its kernel's input.
struct LevelRead {
  const PreparedUnit* unit = nullptr;
  const std::byte* texels = nullptr;
  std::array<AxisTexels, 3>* axis = nullptr;
  const float* compared = nullptr;  ///< r of each lane, clamped, if the sampler compares
  std::uint64_t lanes = 0;          ///< to be read
  bool keeps_others = false;        ///< lanes that are not read keep what `out` holds
  bool reaches_border = false;      ///< offsets may be negative
};
using LevelKernel = void (*)(const LevelRead& read, TexelBlock& out);

/// Samples all covered lanes of a block.
using SampleFunction = void (*)(const FragmentBlock& block, const PreparedUnit& unit, TexelBlock& out);

/// Asks memory for the texels of all covered lanes: SampleFunction will read them.
using FetchFunction = void (*)(const FragmentBlock& block, const PreparedUnit& unit);

/// What an environment function reads beside the block's colours, which it replaces.
struct EnvironmentInput {
  const PreparedUnit* unit = nullptr;
  const TexelBlock* texels = nullptr;        ///< of this unit
  const TexelBlock* all_texels = nullptr;    ///< of the units in order (crossbar)
  const TexelBlock* primary = nullptr;       ///< the colours before the first unit, if one of the units reads them
  float scale = 1.0f;                        ///< of the result: the target's, for the last unit of a plan that ends here
};
using EnvironmentFunction = void (*)(FragmentBlock& block, const EnvironmentInput& input);

struct PreparedUnit {
  TextureUnitState state{};
  std::int32_t dimensions = 2;   ///< coordinates of a level: 1 to 3 (a cube map's face has 2)
  std::int32_t level_count = 1;
  std::vector<PreparedLevel> levels;  ///< level_count of each face in turn
  TexelFormat format = TexelFormat::none;
  bool srgb = false;
  /// What the environment sees; a depth texture's by its mode.
  BaseFormat base_format = BaseFormat::rgba;
  bool widened = false;  ///< four channels of a base format of fewer
  std::array<float, 4> border{};  ///< the border colour as this base format has it
  std::array<LevelKernel, 2> kernel{};  ///< nearest, linear
  SampleFunction sample = nullptr;
  FetchFunction fetch = nullptr;  ///< null: not worth it
  EnvironmentFunction environment = nullptr;

  const PreparedLevel& level(std::int32_t face, std::int32_t index) const {
    return levels[static_cast<std::size_t>(face * level_count + index)];
  }
};

struct TextureUnits;
/// All units at once, to FragmentBlock::words; false if it cannot, and nothing has changed.
using FixedUnitsFunction = bool (*)(FragmentBlock& block, const TextureUnits& units);

struct TextureUnits {
  std::int32_t count = 0;
  FixedUnitsFunction fixed = nullptr;  ///< null: the units go one by one
  void (*pack)(FragmentBlock& block) = nullptr;  ///< colours behind the last unit to words
  float output_scale = 1.0f;
  bool fetches = false;        ///< one of several units has something to fetch
  bool keeps_primary = false;  ///< a combiner reads the primary colour
  std::array<PreparedUnit, max_texture_units> unit;
};

/// What the environment sees of a unit's texture; of a depth texture by its mode.
BaseFormat texture_base_format(const TextureUnitState& unit);

/// `output_scale`: what the colours are multiplied by behind the last unit. Throws std::bad_alloc.
void prepare_texture_units(const TexturingState& state, float output_scale, TextureUnits& out);

}  // namespace gouraud::pipeline
