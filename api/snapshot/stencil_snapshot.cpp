#include "api/snapshot/stencil_snapshot.h"

#include <algorithm>

#include "api/snapshot/enums.h"

namespace gouraud::api {
namespace {

using pipeline::CompareFunc, pipeline::StencilFace, pipeline::StencilOp;

/// A comparison without a bit to compare is one of equal values.
CompareFunc func_of_equal_values(CompareFunc func) {
  const bool passes = func == CompareFunc::equal || func == CompareFunc::lequal || func == CompareFunc::gequal ||
                      func == CompareFunc::always;
  return passes ? CompareFunc::always : CompareFunc::never;
}

StencilFace stencil_face(const StencilSide& side, std::uint32_t stencil_mask, const pipeline::DepthState& depth) {
  StencilFace face;
  const auto compare_mask = static_cast<std::uint8_t>(side.compare_mask & stencil_mask);
  const auto write_mask = static_cast<std::uint8_t>(side.write_mask & stencil_mask);
  face.func = compare_mask != 0 ? compare_func(side.func) : func_of_equal_values(compare_func(side.func));

  // Operations, where their outcome can happen.
  const bool depth_can_fail = depth.test_enabled && depth.func != CompareFunc::always;
  const bool depth_can_pass = !(depth.test_enabled && depth.func == CompareFunc::never);
  const bool can_pass = face.func != CompareFunc::never;
  if (write_mask != 0) {
    if (face.func != CompareFunc::always) face.fail = stencil_op(side.fail);
    if (can_pass && depth_can_fail) face.depth_fail = stencil_op(side.depth_fail);
    if (can_pass && depth_can_pass) face.depth_pass = stencil_op(side.depth_pass);
  }

  // Masks and reference, where somebody reads them.
  const bool compares = can_pass && face.func != CompareFunc::always;
  const bool replaces = face.fail == StencilOp::replace || face.depth_fail == StencilOp::replace ||
                        face.depth_pass == StencilOp::replace;
  if (compares) face.compare_mask = compare_mask;
  if (face.writes()) face.write_mask = write_mask;
  const int read = (compares ? compare_mask : 0) | (replaces ? write_mask : 0);
  face.reference = static_cast<std::uint8_t>(std::clamp(side.reference, 0, static_cast<GLint>(stencil_mask)) & read);
  return face;
}

}  // namespace

pipeline::StencilState stencil_state(const StencilGroup& group, std::uint32_t stencil_mask,
                                     const pipeline::DepthState& depth, bool back_faces_drawn) {
  if (!group.test_enabled || stencil_mask == 0) return {};
  pipeline::StencilState result;
  result.front = stencil_face(group.front, stencil_mask, depth);
  result.back = back_faces_drawn ? stencil_face(group.back(), stencil_mask, depth) : result.front;
  result.enabled = result.front != StencilFace() || result.back != StencilFace();
  return result;
}

}  // namespace gouraud::api
