// Waiting lines to records, several at a time, one a lane: the same numbers as setup_waiting_line() gives [GL1.5 §3.4.1].
#include <limits>
#include <new>
#include <span>

#include "pipeline/raster/record_group.h"
#include "pipeline/raster/setup.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/raster/line_groups.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/raster/plane_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// The record without depth and colours.
HWY_INLINE void begin_record(const RecordGroup& group, std::size_t i, const WaitingLine& line) {
  std::byte* const memory = group.records + i * group.record_bytes;
  auto& record = group.state->colors ? (new (memory) ColoredPrimitive)->record : *new (memory) PrimitiveRecord;
  record.binding = group.state->binding;
  record.edges = {line.edges[0], line.edges[1], {}};
  record.x0 = line.x0;
  record.y0 = line.y0;
  record.x1 = line.x1;
  record.y1 = line.y1;
  record.scissored = true;
  record.back = line.back;
}

/// A line is extrapolated beyond its ends: depths have the whole range, colours are clamped (see line_setup.cpp).
HWY_INLINE void widen_ranges(const RecordGroup& group, std::size_t i) {
  const PlaneTargets& targets = group.state->targets;
  DepthPlane& depth = group.record(i).depth;
  depth.minimum = 0;
  depth.maximum = static_cast<float>(targets.depth_scale);
  if (!group.state->colors) return;
  ColorRecord& color = group.color(i);
  color.clamp = color.variation != ColorVariation::constant;
  if (color.variation == ColorVariation::affine) {
    color.minimum.fill(0.0f);
    color.maximum.fill(targets.color_scale);
  }
}

HWY_INLINE void set_up_lanes(const RecordGroup& group, std::size_t first, const WaitingLine* lines) {
  const D d;
  const SetupState& state = *group.state;
  const std::size_t count = HWY_MIN(hn::Lanes(d), group.count - first);
  for (std::size_t i = first; i < first + count; ++i) begin_record(group, i, lines[i]);

  // What varies along a line varies by t = (p - p0) . d / |d|^2 [GL1.5 §3.4.1 eq 3.3].
  const Quad a = widened(load_vertices(group, first, 0, &KeptVertex::window)), b = widened(load_vertices(group, first, 1, &KeptVertex::window));
  const V height = set(state.target_height_px), y0 = hn::Sub(height, a.y);
  const V dx = hn::Sub(b.x, a.x), dy = hn::Sub(hn::Sub(height, b.y), y0);
  const V squared = hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy));
  const V scale = hn::IfThenElseZero(hn::Gt(squared, hn::Zero(d)), hn::Div(set(1), squared));
  const Basis basis{a.x, y0, hn::Mul(dx, scale), hn::Mul(dy, scale), hn::Zero(d), hn::Zero(d)};

  set_up_depth(basis, {a.z, b.z, b.z}, group, first, count);
  std::uint64_t finite = ~std::uint64_t{0};
  if (state.colors) {
    const std::uint64_t lanes = (std::uint64_t{1} << count) - 1;
    finite = set_up_colors(basis, weigh(basis, {a.w, b.w, b.w}), group, first, lanes);
  }
  for (std::size_t lane = 0; lane < count; ++lane) {
    const std::size_t i = first + lane;
    const bool usual = (finite >> lane & 1) != 0;
    usual ? widen_ranges(group, i) : setup_waiting_line(lines[i], &group.record(i));
  }
}

void set_up_lines(const WaitingLine* lines, std::size_t count, std::byte* records) {
  RecordGroup group(*lines[0].state, records);
  for (group.count = 0; group.count < count; ++group.count) {
    const auto& ends = lines[group.count].vertex;
    group.vertex[0][group.count] = &ends[0];
    group.vertex[1][group.count] = group.vertex[2][group.count] = &ends[1];
  }
  group.repeat_last();
  for (std::size_t i = 0; i < count; i += hn::Lanes(D())) set_up_lanes(group, i, lines);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {

void setup_waiting_lines(std::span<const WaitingLine> lines, std::byte* records) {
  GOURAUD_SIMD_PICK(set_up_lines)(lines.data(), lines.size(), records);
}

}  // namespace gouraud::pipeline
#endif
