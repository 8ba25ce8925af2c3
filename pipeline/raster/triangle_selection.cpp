// Takes assembled triangles, several at a time, one a lane; gives those that draw something as they wait in the bins
// [GL1.5 §3.5.1]. Facing and culling use the area of the snapped triangle. Window y comes from the top (y_raster), is
// snapped there, and turned over. All arithmetic on snapped positions is exact.
//
// The pixels of small triangles are found here: a mesh's triangles are alike, so a walk over the pixels of the largest
// box tests a pixel of every lane's triangle at a time, without a branch. Setup then needs no edges of them.
#include <cmath>
#include <cstring>
#include <new>

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/sample_positions.h"
#include "pipeline/raster/triangles.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/raster/triangle_selection.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/raster/triangle_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

// As many triangles at a time as there are lanes of 32 bits: only areas take doubles.
using SelectionTag = hn::CappedTag<std::int32_t, 16>;
using SelectionFloats = hn::Rebind<float, SelectionTag>;
using Ints = hn::Vec<SelectionTag>;
using IntMask = hn::Mask<SelectionTag>;
using Corner = SnappedCorner<Ints>;
constexpr std::size_t most_selection_lanes = 16;

HWY_INLINE Ints set_ints(std::int32_t value) { return hn::Set(SelectionTag(), value); }
HWY_INLINE std::uint64_t lanes_of(IntMask mask) {
  std::uint64_t bits = 0;
  hn::StoreMaskBits(SelectionTag(), mask, reinterpret_cast<std::uint8_t*>(&bits));
  return bits;
}
HWY_INLINE IntMask mask_of_lanes(std::uint64_t bits) {
  return hn::LoadMaskBits(SelectionTag(), reinterpret_cast<const std::uint8_t*>(&bits));
}

/// Positions in 1/256 pixel, y up.
struct SnappedTriangles {
  Corner corner[3];
};

/// A half-open box of pixels a lane.
struct Boxes {
  Ints x0, y0, x1, y1;
};

/// How far from its centre a pixel can be touched, in 1/256 pixel: nowhere else; of smooth triangles everywhere (snapping moved
/// them by half a step); where samples lie apart at these.
HWY_INLINE std::int32_t reach_of(const SetupState& state) {
  if (state.polygons.smooth) return subpixels / 2 + 1;
  return state.binding->samples_apart ? sample_reach : 0;
}

/// The pixels that a triangle's box touches.
HWY_INLINE Boxes boxes_of(const SnappedTriangles& p, std::int32_t pixel_reach) {
  const auto& [a, b, c] = p.corner;
  const Ints reach = set_ints(pixel_reach);
  const auto first = [&](Ints low) HWY_ATTR { return hn::ShiftRight<subpixel_bits>(hn::Add(hn::Sub(low, reach), set_ints(subpixels - 1))); };
  const auto end = [&](Ints high) HWY_ATTR { return hn::Add(hn::ShiftRight<subpixel_bits>(hn::Add(high, reach)), set_ints(1)); };
  return {first(least(a.x, b.x, c.x)), first(least(a.y, b.y, c.y)), end(most(a.x, b.x, c.x)), end(most(a.y, b.y, c.y))};
}

/// The signs of the areas: twice the area is an integer below 2^53.
struct Facing {
  std::uint64_t counter_clockwise, some;  ///< positive, and not zero
};
HWY_INLINE Facing facing_of(const SnappedTriangles& p) {
  const D d;
  const I half;
  const SelectionTag i;
  const auto& [a, b, c] = p.corner;
  alignas(64) std::int32_t first_x[most_selection_lanes], first_y[most_selection_lanes];
  alignas(64) std::int32_t second_x[most_selection_lanes], second_y[most_selection_lanes];
  hn::Store(hn::Sub(b.x, a.x), i, first_x);
  hn::Store(hn::Sub(b.y, a.y), i, first_y);
  hn::Store(hn::Sub(c.x, a.x), i, second_x);
  hn::Store(hn::Sub(c.y, a.y), i, second_y);
  Facing facing{};
  for (std::size_t lane = 0; lane < hn::Lanes(i); lane += hn::Lanes(d)) {
    const auto part = [&](const std::int32_t* values) HWY_ATTR { return hn::PromoteTo(d, hn::Load(half, values + lane)); };
    const V area = hn::Sub(hn::Mul(part(first_x), part(second_y)), hn::Mul(part(second_x), part(first_y)));
    facing.counter_clockwise |= bits_of(hn::Gt(area, hn::Zero(d))) << lane;
    facing.some |= bits_of(hn::Ne(area, hn::Zero(d))) << lane;
  }
  return facing;
}

/// An edge function at the pixels of a box: see EdgeFunction, and set_up_edges in triangle_setup.cpp for the tie rule.
struct BoxEdge {
  Ints value, a, b;
};
/// A place in the pixel, in 1/256 pixel from its centre.
struct SamplePlace {
  std::int32_t x, y;
};
HWY_INLINE SamplePlace sample_place(std::size_t sample) {
  const auto from_center = [&](std::size_t axis) { return static_cast<std::int32_t>((sample_positions[sample][axis] - 0.5f) * subpixels); };
  return {from_center(0), from_center(1)};
}
/// Lanes that are not `small` get an edge that is nowhere. Of the others every number is below 2^24.
HWY_INLINE BoxEdge box_edge(const Corner& from, const Corner& to, const Boxes& box, SamplePlace sample, IntMask small) {
  const SelectionTag i;
  const Ints zero = hn::Zero(i);
  const Ints a = hn::IfThenElseZero(small, hn::Sub(from.y, to.y)), b = hn::IfThenElseZero(small, hn::Sub(to.x, from.x));
  const auto from_sample = [&](Ints position, Ints first_pixel, std::int32_t place) HWY_ATTR {
    return hn::IfThenElseZero(small, hn::Sub(position, hn::Add(hn::ShiftLeft<subpixel_bits>(first_pixel), set_ints(place))));
  };
  const Ints x = from_sample(from.x, box.x0, sample.x), y = from_sample(from.y, box.y0, sample.y);
  const auto owns = hn::Or(hn::Gt(a, zero), hn::And(hn::Eq(a, zero), hn::Gt(b, zero)));
  const Ints c = hn::Sub(hn::Neg(hn::Add(hn::Mul(a, x), hn::Mul(b, y))), hn::IfThenZeroElse(owns, set_ints(1)));
  return {hn::ShiftRight<subpixel_bits>(c), a, b};
}

/// The pixels that the small triangles cover at the sample's place, 8 a row from the box's corner: rows 0 to 3 and 4 to 7.
struct Masks {
  Ints low, high;
};
HWY_INLINE Masks cover(const SnappedTriangles& p, const Boxes& box, SamplePlace sample, IntMask small, IntMask counter_clockwise) {
  const SelectionTag i;
  // Positive inside, if the triangle is taken counter-clockwise.
  const Corner &a = p.corner[0], &b = p.corner[1], &c = p.corner[2];
  const Corner second{hn::IfThenElse(counter_clockwise, b.x, c.x), hn::IfThenElse(counter_clockwise, b.y, c.y)};
  const Corner third{hn::IfThenElse(counter_clockwise, c.x, b.x), hn::IfThenElse(counter_clockwise, c.y, b.y)};
  const BoxEdge edges[3] = {box_edge(a, second, box, sample, small), box_edge(second, third, box, sample, small), box_edge(third, a, box, sample, small)};
  const std::int32_t columns = hn::GetLane(hn::MaxOfLanes(i, hn::IfThenElseZero(small, hn::Sub(box.x1, box.x0))));
  const std::int32_t rows = hn::GetLane(hn::MaxOfLanes(i, hn::IfThenElseZero(small, hn::Sub(box.y1, box.y0))));

  // From the last pixel to the first, so that each bit found shifts the others into place.
  const Ints last_column = set_ints(columns - 1), last_row = set_ints(rows - 1);
  const auto start = [&](const BoxEdge& e) HWY_ATTR {
    return hn::Add(e.value, hn::Add(hn::Mul(e.a, last_column), hn::Mul(e.b, last_row)));
  };
  Ints start0 = start(edges[0]), start1 = start(edges[1]), start2 = start(edges[2]);
  const Ints row_bits = set_ints((1 << columns) - 1);
  Masks masks{hn::Zero(i), hn::Zero(i)};
  for (std::int32_t row = rows - 1; row >= 0; --row) {
    Ints v0 = start0, v1 = start1, v2 = start2, outside = hn::Zero(i);
    for (std::int32_t column = 0; column < columns; ++column) {
      const Ints minus_one_outside = hn::ShiftRight<31>(hn::Or(hn::Or(v0, v1), v2));
      outside = hn::Sub(hn::Add(outside, outside), minus_one_outside);
      v0 = hn::Sub(v0, edges[0].a);
      v1 = hn::Sub(v1, edges[1].a);
      v2 = hn::Sub(v2, edges[2].a);
    }
    Ints& half = row < 4 ? masks.low : masks.high;
    half = hn::Or(hn::ShiftLeft<8>(half), hn::AndNot(outside, row_bits));
    start0 = hn::Sub(start0, edges[0].b);
    start1 = hn::Sub(start1, edges[1].b);
    start2 = hn::Sub(start2, edges[2].b);
  }
  return masks;
}

/// What the selection finds out.
struct alignas(64) Selection {
  std::int32_t x0[most_selection_lanes], y0[most_selection_lanes], x1[most_selection_lanes], y1[most_selection_lanes];
  struct MaskHalves {
    std::uint32_t low[most_selection_lanes], high[most_selection_lanes];
    std::uint64_t of(std::size_t lane) const { return low[lane] | static_cast<std::uint64_t>(high[lane]) << 32; }
  };
  MaskHalves pixels;                 ///< that have some sample
  MaskHalves sample[max_samples];    ///< where samples are apart
  std::uint64_t alive, front, scissored, small;
};

HWY_INLINE void select(const SetupState& state, const SnappedTriangles& p, Selection& out) {
  const SelectionTag i;
  const Boxes box = boxes_of(p, reach_of(state));
  const PixelRect& scissor = state.scissor;
  const Boxes cut{hn::Max(box.x0, set_ints(scissor.x0)), hn::Max(box.y0, set_ints(scissor.y0)),
                  hn::Min(box.x1, set_ints(scissor.x1)), hn::Min(box.y1, set_ints(scissor.y1))};
  hn::Store(cut.x0, i, out.x0);
  hn::Store(cut.y0, i, out.y0);
  hn::Store(cut.x1, i, out.x1);
  hn::Store(cut.y1, i, out.y1);
  const auto scissored = hn::Or(hn::Or(hn::Ne(box.x0, cut.x0), hn::Ne(box.y0, cut.y0)),
                                hn::Or(hn::Ne(box.x1, cut.x1), hn::Ne(box.y1, cut.y1)));
  out.scissored = lanes_of(scissored);

  // Decide facing, cull, reject what no sample can hit.
  const Facing facing = facing_of(p);
  out.front = state.front_face == FrontFace::ccw ? facing.counter_clockwise : ~facing.counter_clockwise;
  const auto some_box = hn::And(hn::Lt(cut.x0, cut.x1), hn::Lt(cut.y0, cut.y1));
  out.alive = lanes_of(some_box) & facing.some;
  if (is_culled(state.cull, true)) out.alive &= ~out.front;
  if (is_culled(state.cull, false)) out.alive &= out.front;

  // Find the pixels of small ones, reject those between the samples.
  const Ints most_pixels = set_ints(block_size + 1);
  const auto fits = hn::And(hn::Lt(hn::Sub(box.x1, box.x0), most_pixels), hn::Lt(hn::Sub(box.y1, box.y0), most_pixels));
  out.small = !state.polygons.smooth ? out.alive & lanes_of(fits) & ~out.scissored : 0;
  if (out.small == 0) return;
  const IntMask small = mask_of_lanes(out.small), counter_clockwise = mask_of_lanes(facing.counter_clockwise);
  const auto keep = [&](const Masks& masks, Selection::MaskHalves& halves) HWY_ATTR {
    const hn::RebindToUnsigned<SelectionTag> u;
    hn::Store(hn::BitCast(u, masks.low), u, halves.low);
    hn::Store(hn::BitCast(u, masks.high), u, halves.high);
  };
  Masks all{hn::Zero(i), hn::Zero(i)};
  if (state.binding->samples_apart) {
    for (std::size_t k = 0; k < max_samples; ++k) {
      Masks masks{hn::Zero(i), hn::Zero(i)};
      if ((state.binding->sample_mask >> k & 1) != 0) masks = cover(p, box, sample_place(k), small, counter_clockwise);
      keep(masks, out.sample[k]);
      all = {hn::Or(all.low, masks.low), hn::Or(all.high, masks.high)};
    }
  } else {
    all = cover(p, box, {0, 0}, small, counter_clockwise);
  }
  keep(all, out.pixels);
  out.alive &= ~(out.small & lanes_of(hn::Eq(hn::Or(all.low, all.high), hn::Zero(i))));
}

HWY_INLINE void keep_own_vertices(const SetupState& state, const ProcessedVertices& vertices, const AssembledTriangle& triangle,
                                  WaitingTriangle& out) {
  const std::size_t bytes = kept_vertex_size(state);
  auto* next = reinterpret_cast<std::byte*>(&out + 1);
  for (std::uint16_t i = 0; i < 3; ++i, next += bytes) {
    out.vertex[i] = i;
    auto& kept = *new (next) KeptVertex;
    const std::uint16_t vertex = triangle.vertex[i], shading = state.flat ? triangle.provoking : vertex;
    kept.window = vertices.window[vertex];
    if (state.colors) kept.color = color_of_vertex(state, vertices, shading, out.back);
    if (state.binding->varyings.count > 0) copy_varyings(state, vertices, vertex, shading, out.back, varyings_of(kept));
  }
}

/// Selects among at most as many triangles as there are lanes.
HWY_INLINE std::size_t select_group(const SetupState& state, const ProcessedVertices& vertices, const AssembledTriangle* triangles,
                                    std::size_t count, const SharedVertices& shared, std::byte* out) {
  SnappedTriangles p;
  for (std::size_t i = 0; i < 3; ++i) {
    const Quads<SelectionFloats> window = load_quads(SelectionFloats(), [&](std::size_t lane) HWY_ATTR {
      return &vertices.window[triangles[HWY_MIN(lane, count - 1)].vertex[i]].x;
    });
    p.corner[i] = snap_corner(window.x, window.y, state.target_height_px);
  }
  Selection selection;
  select(state, p, selection);

  std::size_t selected = 0;
  const std::size_t bytes = waiting_size(state, shared.front != nullptr);
  for (std::uint64_t left = selection.alive & ((std::uint64_t{1} << count) - 1); left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(__builtin_ctzll(left));
    const auto has = [lane](std::uint64_t lanes) { return (lanes >> lane & 1) != 0; };
    auto& waiting = *new (out + selected++ * bytes) WaitingTriangle;
    waiting.mask = has(selection.small) ? selection.pixels.of(lane) : 0;
    waiting.x0 = static_cast<std::int16_t>(selection.x0[lane]);
    waiting.y0 = static_cast<std::int16_t>(selection.y0[lane]);
    waiting.x1 = static_cast<std::int16_t>(selection.x1[lane]);
    waiting.y1 = static_cast<std::int16_t>(selection.y1[lane]);
    waiting.scissored = has(selection.scissored);
    waiting.back = !has(selection.front);
    waiting.shared = waiting.back ? shared.back : shared.front;
    if (shared.front == nullptr) {
      keep_own_vertices(state, vertices, triangles[lane], waiting);
    } else {
      for (std::size_t i = 0; i < 3; ++i) waiting.vertex[i] = static_cast<std::uint16_t>(triangles[lane].vertex[i] - shared.first);
    }
    if (state.binding->samples_apart && waiting.small()) {
      auto* const masks = reinterpret_cast<std::uint64_t*>(reinterpret_cast<std::byte*>(&waiting) + bytes) - max_samples;
      for (std::size_t k = 0; k < max_samples; ++k) masks[k] = selection.sample[k].of(lane);
    }
  }
  return selected;
}

std::size_t select_all(const SetupState& state, const ProcessedVertices& vertices, const AssembledTriangle* triangles,
                       std::size_t count, SharedVertices shared, std::byte* out) {
  const std::size_t lanes = hn::Lanes(SelectionTag()), bytes = waiting_size(state, shared.front != nullptr);
  std::size_t selected = 0;
  for (std::size_t i = 0; i < count; i += lanes) {
    selected += select_group(state, vertices, triangles + i, HWY_MIN(lanes, count - i), shared, out + selected * bytes);
  }
  return selected;
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {

bool is_culled(CullMode cull, bool front) {
  return cull == CullMode::front_and_back || cull == (front ? CullMode::front : CullMode::back);
}

double front_area(const SetupState& state, const ProcessedVertices& vertices, const AssembledTriangle& triangle) {
  std::array<double, 3> x, y;
  for (std::size_t i = 0; i < 3; ++i) {
    const WindowVertex& vertex = vertices.window[triangle.vertex[i]];
    x[i] = vertex.x;
    y[i] = static_cast<double>(state.target_height_px) - vertex.y_raster;
  }
  const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  return state.front_face == FrontFace::ccw ? area : -area;
}

bool faces_front(const SetupState& state, const ProcessedVertices& vertices, const AssembledTriangle& triangle) {
  return front_area(state, vertices, triangle) > 0.0;
}

SharedVertices keep_vertices(const SetupState& state, const ProcessedVertices& vertices, std::size_t first, std::size_t count,
                             std::byte* memory) {
  const std::size_t bytes = kept_vertex_size(state);
  std::byte* next = memory;
  const auto keep_side = [&](bool back) {
    const std::byte* const begin = next;
    for (std::size_t i = first; i < first + count; ++i, next += bytes) {
      const auto index = static_cast<std::uint16_t>(i);
      auto& kept = *new (next) KeptVertex;
      kept.window = vertices.window[i];
      if (state.colors) kept.color = color_of_vertex(state, vertices, index, back);
      if (state.binding->varyings.count > 0) copy_varyings(state, vertices, index, index, back, varyings_of(kept));
    }
    return begin;
  };
  const std::byte* const front = keep_side(false);
  return {front, state.two_sided ? keep_side(true) : front, static_cast<std::uint16_t>(first)};
}

std::size_t select_triangles(const SetupState& state, const ProcessedVertices& vertices,
                             std::span<const AssembledTriangle> triangles, SharedVertices shared, std::byte* out) {
  return GOURAUD_SIMD_PICK(select_all)(state, vertices, triangles.data(), triangles.size(), shared, out);
}

}  // namespace gouraud::pipeline
#endif
