// Rows of [GL1.5 Tables 6.13, 6.14, 6.19 to 6.21, 6.27]: rasterization, per-fragment tests, framebuffer control, pixel
// store, hints.
#include <algorithm>

#include "api/commands/state_rows.h"

namespace gouraud::api {
namespace {

using enum ValueKind;

template <GLenum HintGroup::*hint>
void read_hint(const Context& c, StateValue& v) {
  set(v, c.state.hint.*hint);
}

template <auto store, auto parameter>
void read_store(const Context& c, StateValue& v) {
  set(v, (c.state.*store).*parameter);
}

template <auto parameter>
void read_blend(const Context& c, StateValue& v) {
  set(v, c.state.color_buffer.blend.*parameter);
}

const StencilSide& active(const StencilGroup& stencil) {
  return stencil.active_face == GL_FRONT ? stencil.front : stencil.two_side_back;
}
const StencilSide& separate_back(const StencilGroup& stencil) {
  return stencil.separate_back;
}
template <auto side, auto parameter>
void read_stencil(const Context& c, StateValue& v) {
  set(v, side(c.state.stencil).*parameter);
}
template <auto side>
void read_stencil_reference(const Context& c, StateValue& v) {
  set(v, std::clamp(side(c.state.stencil).reference, 0, static_cast<GLint>(c.target_info().stencil_mask)));
}

constexpr StateRow rows[] = {
    // Rasterization [GL1.5 Tables 6.13 and 6.14]
    {GL_POINT_SIZE, real, 1, [](const Context& c, StateValue& v) { set(v, c.state.point.size_px); }},
    {GL_POINT_SIZE_MIN, real, 1, [](const Context& c, StateValue& v) { set(v, c.state.point.smallest_px); }},
    {GL_POINT_SIZE_MAX, real, 1, [](const Context& c, StateValue& v) { set(v, c.state.point.largest_px); }},
    {GL_POINT_FADE_THRESHOLD_SIZE, real, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.point.fade_threshold_px); }},
    {GL_POINT_DISTANCE_ATTENUATION, real, 3,
     [](const Context& c, StateValue& v) { set(v, c.state.point.distance_attenuation); }},
    {GL_LINE_STIPPLE_PATTERN, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.line.stipple_pattern); }},
    {GL_LINE_STIPPLE_REPEAT, integer, 1, [](const Context& c, StateValue& v) { set(v, c.state.line.stipple_factor); }},
    {GL_POLYGON_OFFSET_FACTOR, real, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.polygon.offset_factor); }},
    {GL_POLYGON_OFFSET_UNITS, real, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.polygon.offset_units); }},
    {GL_POLYGON_OFFSET_BIAS_EXT, real, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.polygon.offset_bias); }},
    {GL_LINE_WIDTH, real, 1, [](const Context& c, StateValue& v) { set(v, c.state.line.width_px); }},
    {GL_CULL_FACE_MODE, integer, 1, [](const Context& c, StateValue& v) { set(v, c.state.polygon.cull_face); }},
    {GL_FRONT_FACE, integer, 1, [](const Context& c, StateValue& v) { set(v, c.state.polygon.front_face); }},
    {GL_POLYGON_MODE, integer, 2,
     [](const Context& c, StateValue& v) { set(v, c.state.polygon.front_mode, c.state.polygon.back_mode); }},
    {GL_SAMPLE_COVERAGE_VALUE, real, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.multisample.coverage_value); }},
    {GL_SAMPLE_COVERAGE_INVERT, boolean, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.multisample.coverage_inverted); }},

    // Pixel operations and framebuffer control [GL1.5 Tables 6.19 and 6.20]
    {GL_SCISSOR_BOX, integer, 4,
     [](const Context& c, StateValue& v) {
       const ScissorGroup& scissor = c.state.scissor;
       set(v, scissor.x, scissor.y, scissor.width_px, scissor.height_px);
     }},
    {GL_ALPHA_TEST_FUNC, integer, 1, [](const Context& c, StateValue& v) { set(v, c.state.color_buffer.alpha_func); }},
    {GL_ALPHA_TEST_REF, normalized, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.color_buffer.alpha_reference); }},
    {GL_BLEND_SRC, integer, 1, read_blend<&Blending::source_rgb>},
    {GL_BLEND_DST, integer, 1, read_blend<&Blending::destination_rgb>},
    {GL_BLEND_SRC_RGB, integer, 1, read_blend<&Blending::source_rgb>},
    {GL_BLEND_DST_RGB, integer, 1, read_blend<&Blending::destination_rgb>},
    {GL_BLEND_SRC_ALPHA, integer, 1, read_blend<&Blending::source_alpha>},
    {GL_BLEND_DST_ALPHA, integer, 1, read_blend<&Blending::destination_alpha>},
    {GL_BLEND_EQUATION, integer, 1, read_blend<&Blending::equation_rgb>},  // and of R, G, B alone
    {GL_BLEND_EQUATION_ALPHA_EXT, integer, 1, read_blend<&Blending::equation_alpha>},
    {GL_BLEND_COLOR, normalized, 4, read_blend<&Blending::constant>},
    {GL_LOGIC_OP_MODE, integer, 1, [](const Context& c, StateValue& v) { set(v, c.state.color_buffer.logic_op); }},
    {GL_DEPTH_FUNC, integer, 1, [](const Context& c, StateValue& v) { set(v, c.state.depth.func); }},
    {GL_DEPTH_WRITEMASK, boolean, 1, [](const Context& c, StateValue& v) { set(v, c.state.depth.write_enabled); }},
    {GL_DEPTH_CLEAR_VALUE, normalized, 1, [](const Context& c, StateValue& v) { set(v, c.state.depth.clear_value); }},
    {GL_STENCIL_FUNC, integer, 1, read_stencil<active, &StencilSide::func>},
    {GL_STENCIL_REF, integer, 1, read_stencil_reference<active>},
    {GL_STENCIL_VALUE_MASK, integer, 1, read_stencil<active, &StencilSide::compare_mask>},
    {GL_STENCIL_FAIL, integer, 1, read_stencil<active, &StencilSide::fail>},
    {GL_STENCIL_PASS_DEPTH_FAIL, integer, 1, read_stencil<active, &StencilSide::depth_fail>},
    {GL_STENCIL_PASS_DEPTH_PASS, integer, 1, read_stencil<active, &StencilSide::depth_pass>},
    {GL_STENCIL_WRITEMASK, integer, 1, read_stencil<active, &StencilSide::write_mask>},
    {GL_STENCIL_BACK_FUNC_ATI, integer, 1, read_stencil<separate_back, &StencilSide::func>},
    {GL_STENCIL_BACK_FAIL_ATI, integer, 1, read_stencil<separate_back, &StencilSide::fail>},
    {GL_STENCIL_BACK_PASS_DEPTH_FAIL_ATI, integer, 1, read_stencil<separate_back, &StencilSide::depth_fail>},
    {GL_STENCIL_BACK_PASS_DEPTH_PASS_ATI, integer, 1, read_stencil<separate_back, &StencilSide::depth_pass>},
    {GL_ACTIVE_STENCIL_FACE_EXT, integer, 1, [](const Context& c, StateValue& v) { set(v, c.state.stencil.active_face); }},
    {GL_ACCUM_CLEAR_VALUE, normalized, 4, [](const Context& c, StateValue& v) { set(v, c.state.accum.clear_value); }},
    {GL_STENCIL_CLEAR_VALUE, integer, 1, [](const Context& c, StateValue& v) { set(v, c.state.stencil.clear_value); }},
    {GL_COLOR_WRITEMASK, boolean, 4,
     [](const Context& c, StateValue& v) {
       const auto& enabled = c.state.color_buffer.write_enabled;
       set(v, enabled[0], enabled[1], enabled[2], enabled[3]);
     }},
    {GL_COLOR_CLEAR_VALUE, normalized, 4,
     [](const Context& c, StateValue& v) { set(v, c.state.color_buffer.clear_color); }},
    {GL_INDEX_WRITEMASK, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.color_buffer.index_write_mask); }},
    {GL_INDEX_CLEAR_VALUE, real, 1, [](const Context& c, StateValue& v) { set(v, c.state.color_buffer.clear_index); }},

    // Pixel store [GL1.5 Table 6.21]
    {GL_PACK_SWAP_BYTES, boolean, 1, read_store<&State::pack, &PixelStore::swap_bytes>},
    {GL_PACK_LSB_FIRST, boolean, 1, read_store<&State::pack, &PixelStore::lsb_first>},
    {GL_PACK_ROW_LENGTH, integer, 1, read_store<&State::pack, &PixelStore::row_length_px>},
    {GL_PACK_SKIP_ROWS, integer, 1, read_store<&State::pack, &PixelStore::skip_rows>},
    {GL_PACK_SKIP_PIXELS, integer, 1, read_store<&State::pack, &PixelStore::skip_pixels>},
    {GL_PACK_ALIGNMENT, integer, 1, read_store<&State::pack, &PixelStore::alignment>},
    {GL_PACK_IMAGE_HEIGHT, integer, 1, read_store<&State::pack, &PixelStore::image_height_px>},
    {GL_PACK_SKIP_IMAGES, integer, 1, read_store<&State::pack, &PixelStore::skip_images>},
    {GL_UNPACK_SWAP_BYTES, boolean, 1, read_store<&State::unpack, &PixelStore::swap_bytes>},
    {GL_UNPACK_LSB_FIRST, boolean, 1, read_store<&State::unpack, &PixelStore::lsb_first>},
    {GL_UNPACK_ROW_LENGTH, integer, 1, read_store<&State::unpack, &PixelStore::row_length_px>},
    {GL_UNPACK_SKIP_ROWS, integer, 1, read_store<&State::unpack, &PixelStore::skip_rows>},
    {GL_UNPACK_SKIP_PIXELS, integer, 1, read_store<&State::unpack, &PixelStore::skip_pixels>},
    {GL_UNPACK_ALIGNMENT, integer, 1, read_store<&State::unpack, &PixelStore::alignment>},
    {GL_UNPACK_IMAGE_HEIGHT, integer, 1, read_store<&State::unpack, &PixelStore::image_height_px>},
    {GL_UNPACK_SKIP_IMAGES, integer, 1, read_store<&State::unpack, &PixelStore::skip_images>},

    // Hints [GL1.5 Table 6.27]
    {GL_PERSPECTIVE_CORRECTION_HINT, integer, 1, read_hint<&HintGroup::perspective_correction>},
    {GL_POINT_SMOOTH_HINT, integer, 1, read_hint<&HintGroup::point_smooth>},
    {GL_LINE_SMOOTH_HINT, integer, 1, read_hint<&HintGroup::line_smooth>},
    {GL_POLYGON_SMOOTH_HINT, integer, 1, read_hint<&HintGroup::polygon_smooth>},
    {GL_FOG_HINT, integer, 1, read_hint<&HintGroup::fog>},
    {GL_GENERATE_MIPMAP_HINT, integer, 1, read_hint<&HintGroup::generate_mipmap>},
    {GL_TEXTURE_COMPRESSION_HINT, integer, 1, read_hint<&HintGroup::texture_compression>},
};

}  // namespace

std::span<const StateRow> fragment_state_rows() {
  return rows;
}

}  // namespace gouraud::api
