// Rows of [GL1.5 Tables 6.28 to 6.32]: implementation-dependent values, and what the target is made of.
#include "api/commands/state_rows.h"

#include <algorithm>

#include "extension_names.h"

namespace gouraud::api {
namespace {

using enum ValueKind;

template <auto... constants>
void read_constant(const Context&, StateValue& v) {
  set(v, constants...);
}

void read_point_range(const Context&, StateValue& v) {
  set(v, min_point_size, max_point_size);
}
void read_line_range(const Context&, StateValue& v) {
  set(v, min_line_width, max_line_width);
}

// 8 bits to a byte, four components a pixel.
template <int channel>
void read_color_bits(const Context& c, StateValue& v) {
  const pipeline::Framebuffer* const target = c.target();  // its bits, whatever the draw buffer is
  const bool exists = target != nullptr && (target->color_channels >> channel & 1) != 0;
  const int bits = exists ? pipeline::bytes_per_pixel(target->color_format) * 2 : 0;
  const bool is_window = c.framebuffers.draw->is_window();
  set(v, is_window ? std::min<int>(bits, c.config().most_color_bits[channel]) : bits);
}

void read_depth_bits(const Context& c, StateValue& v) {
  const TargetInfo target = c.target_info();
  set(v, target.has_depth ? pipeline::depth_bits(target.format.depth) : 0);
}

void read_stencil_bits(const Context& c, StateValue& v) {
  set(v, c.target_info().stencil_mask != 0 ? 8 : 0);
}

void read_accum_bits(const Context& c, StateValue& v) {
  set(v, c.target_info().accumulates ? 32 : 0);
}

constexpr StateRow rows[] = {
    {GL_NUM_EXTENSIONS, integer, 1, read_constant<extension_count>},
    {GL_MAX_LIGHTS, integer, 1, read_constant<max_lights>},
    {GL_MAX_SHININESS_NV, integer, 1, read_constant<128>},
    {GL_MAX_SPOT_EXPONENT_NV, integer, 1, read_constant<128>},
    {GL_MAX_CLIP_PLANES, integer, 1, read_constant<max_clip_planes>},
    {GL_MAX_MODELVIEW_STACK_DEPTH, integer, 1, read_constant<max_modelview_stack_depth>},
    {GL_MAX_PROJECTION_STACK_DEPTH, integer, 1, read_constant<max_projection_stack_depth>},
    {GL_MAX_TEXTURE_STACK_DEPTH, integer, 1, read_constant<max_texture_stack_depth>},
    {GL_MAX_ATTRIB_STACK_DEPTH, integer, 1, read_constant<max_attrib_stack_depth>},
    {GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, integer, 1, read_constant<max_client_attrib_stack_depth>},
    {GL_MAX_ELEMENTS_VERTICES, integer, 1, read_constant<max_elements_vertices>},
    {GL_MAX_ELEMENTS_INDICES, integer, 1, read_constant<max_elements_indices>},
    {GL_MAX_NAME_STACK_DEPTH, integer, 1, read_constant<max_name_stack_depth>},
    {GL_MAX_LIST_NESTING, integer, 1, read_constant<max_list_nesting>},
    {GL_MAX_VIEWPORT_DIMS, integer, 2, read_constant<max_target_size_px, max_target_size_px>},
    {GL_SUBPIXEL_BITS, integer, 1, read_constant<subpixel_bits>},
    {GL_ALIASED_POINT_SIZE_RANGE, real, 2, read_point_range},
    {GL_SMOOTH_POINT_SIZE_RANGE, real, 2, read_point_range},
    {GL_SMOOTH_POINT_SIZE_GRANULARITY, real, 1, [](const Context&, StateValue& v) { set(v, point_size_granularity); }},
    {GL_ALIASED_LINE_WIDTH_RANGE, real, 2, read_line_range},
    {GL_SMOOTH_LINE_WIDTH_RANGE, real, 2, read_line_range},
    {GL_SMOOTH_LINE_WIDTH_GRANULARITY, real, 1, [](const Context&, StateValue& v) { set(v, line_width_granularity); }},

    {GL_MAX_RENDERBUFFER_SIZE, integer, 1, read_constant<max_renderbuffer_size>},
    {GL_MAX_COLOR_ATTACHMENTS, integer, 1, read_constant<max_color_attachments>},
    {GL_MAX_SAMPLES, integer, 1, read_constant<max_samples>},

    {GL_DRAW_FRAMEBUFFER_BINDING, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.framebuffers.draw->name); }},
    {GL_READ_FRAMEBUFFER_BINDING, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.framebuffers.read->name); }},
    {GL_RENDERBUFFER_BINDING, integer, 1,
     [](const Context& c, StateValue& v) {
       const auto& bound = c.framebuffers.renderbuffer;
       set(v, bound != nullptr ? bound->name : 0);
     }},

    {GL_RGBA_MODE, boolean, 1, read_constant<true>},
    {GL_INDEX_MODE, boolean, 1, read_constant<false>},
    {GL_DOUBLEBUFFER, boolean, 1, read_constant<false>},
    {GL_DRAW_BUFFER, integer, 1, [](const Context& c, StateValue& v) { set(v, c.framebuffers.draw->draw_buffer); }},
    {GL_READ_BUFFER, integer, 1, [](const Context& c, StateValue& v) { set(v, c.framebuffers.read->read_buffer); }},
    {GL_STEREO, boolean, 1, read_constant<false>},
    {GL_AUX_BUFFERS, integer, 1, read_constant<0>},
    {GL_SAMPLE_BUFFERS, integer, 1,
     [](const Context& c, StateValue& v) { set(v, samples_of(*c.framebuffers.draw) > 0 ? 1 : 0); }},
    {GL_SAMPLES, integer, 1, [](const Context& c, StateValue& v) { set(v, samples_of(*c.framebuffers.draw)); }},
    {GL_RED_BITS, integer, 1, read_color_bits<0>},
    {GL_GREEN_BITS, integer, 1, read_color_bits<1>},
    {GL_BLUE_BITS, integer, 1, read_color_bits<2>},
    {GL_ALPHA_BITS, integer, 1, read_color_bits<3>},
    {GL_INDEX_BITS, integer, 1, read_constant<0>},
    {GL_DEPTH_BITS, integer, 1, read_depth_bits},
    {GL_STENCIL_BITS, integer, 1, read_stencil_bits},
    {GL_ACCUM_RED_BITS, integer, 1, read_accum_bits},
    {GL_ACCUM_GREEN_BITS, integer, 1, read_accum_bits},
    {GL_ACCUM_BLUE_BITS, integer, 1, read_accum_bits},
    {GL_ACCUM_ALPHA_BITS, integer, 1, read_accum_bits},
};

}  // namespace

std::span<const StateRow> implementation_rows() {
  return rows;
}

}  // namespace gouraud::api
