// State -> pipeline::DrawState: the one bridge, the only place where a GLenum becomes a pipeline type. Takes the state
// and the target's format, gives a canonical DrawState (pipeline/draw/draw_state.h says what canonical means).
#pragma once

#include <cstdint>

#include "api/state/state.h"
#include "pipeline/draw/draw_state.h"
#include "pipeline/draw/plan.h"

namespace gouraud::api {

/// Parts of the DrawState that commands may have touched since it was last taken.
enum DirtyBits : std::uint32_t {
  dirty_transform = 1u << 0,  ///< modelview, projection, normal scaling, clip planes
  dirty_viewport = 1u << 1,
  dirty_lighting = 1u << 2,  ///< lights, light model, ColorMaterial, shade model, colour sum
  dirty_material = 1u << 3,  ///< material parameters alone: these may change inside Begin/End
  dirty_assembly = 1u << 4,  ///< points, lines, polygons
  dirty_raster = 1u << 5,  ///< scissor, depth, masks, fog
  dirty_textures = 1u << 6,  ///< texture units, objects, images
  dirty_texture_coordinates = 1u << 7,  ///< texgen, texture matrices
  dirty_all = (1u << 8) - 1,
};

/// What the snapshot needs to know of the target; zero and none without one.
struct TargetInfo {
  std::int32_t width_px = 0, height_px = 0;
  pipeline::TargetFormat format{};
  std::uint32_t stencil_mask = 0;  ///< 2^stencil bits - 1
  std::uint8_t color_channels = 0xF;  ///< those that may be written: none if the draw buffer is GL_NONE
  int samples = 0;  ///< of each pixel; 0 without multisampling
  bool has_depth = true;  ///< false: format.depth, if any, is that of a plane of which only the stencil is used
  bool accumulates = false;        ///< has an accumulation buffer
};

/// Brings the parts of `draw_state` that `dirty` names up to date, and those that depend on them; gives all these parts.
/// Material parameters are left alone: see canonical_material (lighting_snapshot.h).
std::uint32_t update_draw_state(const State& state, const TargetInfo& target, std::uint32_t dirty,
                                pipeline::DrawState& draw_state);

/// The same for dirty_transform alone: no other part depends on it.
void update_matrices(const State& state, pipeline::DrawState& draw_state);

/// Those of the parts that differ.
std::uint32_t differing_parts(const pipeline::DrawState& a, const pipeline::DrawState& b, std::uint32_t parts);
void copy_parts(const pipeline::DrawState& from, std::uint32_t parts, pipeline::DrawState& to);

/// The state under which a raster position is a vertex of which everything is wanted [GL1.5 §2.13]; materials included.
pipeline::DrawState raster_position_state(const State& state, const TargetInfo& target);

/// The pixels that may be written: scissor box, if enabled, and target, intersected [GL1.5 §4.1.2].
pipeline::PixelRect writable_rect(const State& state, const TargetInfo& target);

/// What glAccum does under this state. `value` may be any float: NaN counts as 0, and what is too large as the largest.
pipeline::AccumState accum_state(const State& state, const TargetInfo& target, GLenum op, GLfloat value);

/// What glClear of the buffers in `mask` does under this state [GL1.5 §4.2.3].
pipeline::ClearState clear_state(const State& state, const TargetInfo& target, GLbitfield mask);

}  // namespace gouraud::api
