// Rows of texturing [GL1.5 Tables 6.15, 6.18, 6.28 to 6.30]: bindings of the active unit, and limits.
#include <algorithm>

#include "api/commands/state_rows.h"
#include "api/commands/texel_formats.h"
#include "api/commands/texture_targets.h"

namespace gouraud::api {
namespace {

using enum ValueKind;

template <TextureTarget target>
void read_binding(const Context& c, StateValue& v) {
  set(v, name_of(active_unit(c).binding[index_of(target)]));
}

template <auto constant>
void read_constant(const Context&, StateValue& v) {
  set(v, constant);
}

template <const float& constant>
void read_real_constant(const Context&, StateValue& v) {
  set(v, constant);
}

void read_compressed_formats(const Context&, StateValue& v) {
  std::copy(compressed_formats().begin(), compressed_formats().end(), v.components.begin());
}

constexpr StateRow rows[] = {
    {GL_TEXTURE_BINDING_1D, integer, 1, read_binding<TextureTarget::one_d>},
    {GL_TEXTURE_BINDING_2D, integer, 1, read_binding<TextureTarget::two_d>},
    {GL_TEXTURE_BINDING_3D, integer, 1, read_binding<TextureTarget::three_d>},
    {GL_TEXTURE_BINDING_CUBE_MAP, integer, 1, read_binding<TextureTarget::cube_map>},
    {GL_TEXTURE_BINDING_RECTANGLE_ARB, integer, 1, read_binding<TextureTarget::rectangle>},
    {GL_MAX_TEXTURE_UNITS, integer, 1, read_constant<max_texture_units>},
    {GL_MAX_TEXTURE_SIZE, integer, 1, read_constant<max_texture_size>},
    {GL_MAX_3D_TEXTURE_SIZE, integer, 1, read_constant<max_texture_3d_size>},
    {GL_MAX_CUBE_MAP_TEXTURE_SIZE, integer, 1, read_constant<max_texture_size>},
    {GL_MAX_RECTANGLE_TEXTURE_SIZE_ARB, integer, 1, read_constant<max_texture_size>},
    {GL_NUM_COMPRESSED_TEXTURE_FORMATS, integer, 1, read_constant<compressed_format_count>},
    {GL_COMPRESSED_TEXTURE_FORMATS, integer, compressed_format_count, read_compressed_formats},
    {GL_MAX_TEXTURE_LOD_BIAS, real, 1, read_real_constant<max_texture_lod_bias>},
    {GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, real, 1, read_real_constant<max_texture_anisotropy>},
};

}  // namespace

std::span<const StateRow> texture_rows() {
  return rows;
}

}  // namespace gouraud::api
