// Takes pixel transfer's parameters and the ten maps, gives what they do to groups of colours, indices and depths
// [GL1.5 §3.6.3, §3.6.5]. Leaves out the imaging subset.
#include "api/commands/pixel_transfer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "api/commands/client_pixels.h"
#include "api/commands/state_rows.h"

namespace gouraud::api {
namespace {

// Absurd floats become the nearest integer; NaN becomes 0.
GLint rounded(float value) { return to_integer(static_cast<double>(value), ValueKind::integer); }

bool set_component(PixelTransferGroup& transfer, GLenum pname, float value) {
  switch (pname) {
    case GL_RED_SCALE: transfer.scale[0] = value; return true;
    case GL_GREEN_SCALE: transfer.scale[1] = value; return true;
    case GL_BLUE_SCALE: transfer.scale[2] = value; return true;
    case GL_ALPHA_SCALE: transfer.scale[3] = value; return true;
    case GL_RED_BIAS: transfer.bias[0] = value; return true;
    case GL_GREEN_BIAS: transfer.bias[1] = value; return true;
    case GL_BLUE_BIAS: transfer.bias[2] = value; return true;
    case GL_ALPHA_BIAS: transfer.bias[3] = value; return true;
    case GL_DEPTH_SCALE: transfer.depth_scale = value; return true;
    case GL_DEPTH_BIAS: transfer.depth_bias = value; return true;
    default: return false;
  }
}

bool set_other(PixelTransferGroup& transfer, GLenum pname, bool truth, GLint integer) {
  switch (pname) {
    case GL_MAP_COLOR: transfer.map_color = truth; return true;
    case GL_MAP_STENCIL: transfer.map_stencil = truth; return true;
    case GL_INDEX_SHIFT: transfer.index_shift = integer; return true;
    case GL_INDEX_OFFSET: transfer.index_offset = integer; return true;
    default: return false;
  }
}

std::size_t place_of(GLenum map) {
  static_assert(GL_PIXEL_MAP_A_TO_A - GL_PIXEL_MAP_I_TO_I == map_a_to_a);
  return map - GL_PIXEL_MAP_I_TO_I;  // beyond the maps for other names
}

bool is_addressed_by_index(std::size_t map) { return map <= map_i_to_a; }
bool holds_indices(std::size_t map) { return map == map_i_to_i || map == map_s_to_s; }

template <class T>
double to_entry(std::size_t map, T value) {
  const auto number = static_cast<double>(value);
  if (map == map_s_to_s && std::is_floating_point_v<T>) {
    return std::isnan(number) ? 0.0 : std::nearbyint(std::clamp(number, -2147483648.0, 4294967295.0));
  }
  if (holds_indices(map) || std::is_floating_point_v<T>) return number;
  return static_cast<double>(static_cast<float>(number / static_cast<double>(std::numeric_limits<T>::max())));  // [GL1.5 Table 2.9]
}

template <class T>
T from_entry(std::size_t map, double entry) {
  if constexpr (std::is_floating_point_v<T>) return static_cast<T>(entry);
  else {
    constexpr auto most = static_cast<double>(std::numeric_limits<T>::max());
    const double scaled = holds_indices(map) ? entry : entry * most;  // [GL1.5 Table 4.6]
    return std::isnan(scaled) ? T{0} : static_cast<T>(std::nearbyint(std::clamp(scaled, 0.0, most)));
  }
}

template <class T>
void set_map(Context& context, const char* command, GLenum name, GLsizei size, const T* values) {
  const std::size_t map = place_of(name);
  if (map >= pixel_map_count) return context.record_error(GL_INVALID_ENUM, command, "map is unknown");
  if (size < 1 || size > max_pixel_map_table) {
    return context.record_error(GL_INVALID_VALUE, command, "the map's size is outside its range");
  }
  if (is_addressed_by_index(map) && !std::has_single_bit(static_cast<unsigned>(size))) {
    return context.record_error(GL_INVALID_VALUE, command, "the size of a map of indices must be a power of two");
  }
  const std::byte* at = nullptr;
  if (!check_unpack_array(context, command, static_cast<std::size_t>(size), sizeof(T), values, at) || at == nullptr) return;
  PixelMap& kept = context.state.pixel_maps[map];
  kept = {};
  kept.size = size;
  for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
    T value;
    std::memcpy(&value, at + i * sizeof(T), sizeof(T));
    kept.entry[i] = to_entry(map, value);
  }
}

template <class T>
void get_map(Context& context, const char* command, GLenum name, T* values) {
  const std::size_t map = place_of(name);
  if (map >= pixel_map_count) return context.record_error(GL_INVALID_ENUM, command, "map is unknown");
  const PixelMap& kept = context.state.pixel_maps[map];
  const auto size = static_cast<std::size_t>(kept.size);
  std::byte* at = nullptr;
  if (!check_pack_array(context, command, size, sizeof(T), values, at) || at == nullptr) return;
  for (std::size_t i = 0; i < size; ++i) {
    const T value = from_entry<T>(map, kept.entry[i]);
    std::memcpy(at + i * sizeof(T), &value, sizeof(T));
  }
}

// A shift by 32 bits or more leaves nothing; it is zero-filled [GL1.5 §3.6.5].
std::uint32_t arithmetic(const PixelTransferGroup& transfer, std::uint32_t index) {
  const std::int64_t shift = transfer.index_shift;
  if (shift >= 32 || shift <= -32) {
    index = 0;
  } else {
    index = shift >= 0 ? index << shift : index >> -shift;
  }
  return index + static_cast<std::uint32_t>(transfer.index_offset);
}

double looked_up(const PixelMap& map, std::uint32_t index) {
  return map.entry[index & static_cast<std::uint32_t>(map.size - 1)];
}

float looked_up(const PixelMap& map, float component) {
  const float clamped = component > 0.0f ? (component < 1.0f ? component : 1.0f) : 0.0f;  // NaN gives 0
  return static_cast<float>(map.entry[static_cast<std::size_t>(clamped * static_cast<float>(map.size - 1) + 0.5f)]);
}

template <PixelMapName map>
void read_size(const Context& c, StateValue& v) {
  set(v, c.state.pixel_maps[map].size);
}

template <int component>
void read_scale(const Context& c, StateValue& v) {
  set(v, c.state.pixel.transfer.scale[component]);
}
template <int component>
void read_bias(const Context& c, StateValue& v) {
  set(v, c.state.pixel.transfer.bias[component]);
}
template <auto parameter>
void read_transfer(const Context& c, StateValue& v) {
  set(v, c.state.pixel.transfer.*parameter);
}

using enum ValueKind;

constexpr StateRow rows[] = {
    {GL_MAP_COLOR, boolean, 1, read_transfer<&PixelTransferGroup::map_color>},
    {GL_MAP_STENCIL, boolean, 1, read_transfer<&PixelTransferGroup::map_stencil>},
    {GL_INDEX_SHIFT, integer, 1, read_transfer<&PixelTransferGroup::index_shift>},
    {GL_INDEX_OFFSET, integer, 1, read_transfer<&PixelTransferGroup::index_offset>},
    {GL_RED_SCALE, real, 1, read_scale<0>},
    {GL_GREEN_SCALE, real, 1, read_scale<1>},
    {GL_BLUE_SCALE, real, 1, read_scale<2>},
    {GL_ALPHA_SCALE, real, 1, read_scale<3>},
    {GL_RED_BIAS, real, 1, read_bias<0>},
    {GL_GREEN_BIAS, real, 1, read_bias<1>},
    {GL_BLUE_BIAS, real, 1, read_bias<2>},
    {GL_ALPHA_BIAS, real, 1, read_bias<3>},
    {GL_DEPTH_SCALE, real, 1, read_transfer<&PixelTransferGroup::depth_scale>},
    {GL_DEPTH_BIAS, real, 1, read_transfer<&PixelTransferGroup::depth_bias>},
    {GL_ZOOM_X, real, 1, [](const Context& c, StateValue& v) { set(v, c.state.pixel.zoom_x); }},
    {GL_ZOOM_Y, real, 1, [](const Context& c, StateValue& v) { set(v, c.state.pixel.zoom_y); }},
    {GL_MAX_PIXEL_MAP_TABLE, integer, 1, [](const Context&, StateValue& v) { set(v, max_pixel_map_table); }},
    {GL_PIXEL_MAP_I_TO_I_SIZE, integer, 1, read_size<map_i_to_i>},
    {GL_PIXEL_MAP_S_TO_S_SIZE, integer, 1, read_size<map_s_to_s>},
    {GL_PIXEL_MAP_I_TO_R_SIZE, integer, 1, read_size<map_i_to_r>},
    {GL_PIXEL_MAP_I_TO_G_SIZE, integer, 1, read_size<map_i_to_g>},
    {GL_PIXEL_MAP_I_TO_B_SIZE, integer, 1, read_size<map_i_to_b>},
    {GL_PIXEL_MAP_I_TO_A_SIZE, integer, 1, read_size<map_i_to_a>},
    {GL_PIXEL_MAP_R_TO_R_SIZE, integer, 1, read_size<map_r_to_r>},
    {GL_PIXEL_MAP_G_TO_G_SIZE, integer, 1, read_size<map_g_to_g>},
    {GL_PIXEL_MAP_B_TO_B_SIZE, integer, 1, read_size<map_b_to_b>},
    {GL_PIXEL_MAP_A_TO_A_SIZE, integer, 1, read_size<map_a_to_a>},
};

}  // namespace

void PixelTransferf(Context& context, GLenum pname, GLfloat param) {
  PixelTransferGroup& transfer = context.state.pixel.transfer;
  if (set_component(transfer, pname, param) || set_other(transfer, pname, param != 0.0f, rounded(param))) return;
  context.record_error(GL_INVALID_ENUM, "glPixelTransfer", "pname is no pixel transfer parameter");
}

void PixelTransferi(Context& context, GLenum pname, GLint param) {
  PixelTransferGroup& transfer = context.state.pixel.transfer;
  if (set_other(transfer, pname, param != 0, param) || set_component(transfer, pname, static_cast<float>(param))) return;
  context.record_error(GL_INVALID_ENUM, "glPixelTransfer", "pname is no pixel transfer parameter");
}

void PixelMapfv(Context& context, GLenum map, GLsizei mapsize, const GLfloat* values) {
  set_map(context, "glPixelMapfv", map, mapsize, values);
}
void PixelMapuiv(Context& context, GLenum map, GLsizei mapsize, const GLuint* values) {
  set_map(context, "glPixelMapuiv", map, mapsize, values);
}
void PixelMapusv(Context& context, GLenum map, GLsizei mapsize, const GLushort* values) {
  set_map(context, "glPixelMapusv", map, mapsize, values);
}
void GetPixelMapfv(Context& context, GLenum map, GLfloat* values) { get_map(context, "glGetPixelMapfv", map, values); }
void GetPixelMapuiv(Context& context, GLenum map, GLuint* values) { get_map(context, "glGetPixelMapuiv", map, values); }
void GetPixelMapusv(Context& context, GLenum map, GLushort* values) {
  get_map(context, "glGetPixelMapusv", map, values);
}

bool transfers_color(const PixelTransferGroup& transfer) {
  return transfer.map_color || transfer.scale != glm::vec4(1.0f) || transfer.bias != glm::vec4(0.0f);
}

bool transfers_depth(const PixelTransferGroup& transfer) {
  return transfer.depth_scale != 1.0f || transfer.depth_bias != 0.0f;
}

bool transfers_stencil(const PixelTransferGroup& transfer) {
  return transfer.map_stencil || transfer.index_shift != 0 || transfer.index_offset != 0;
}

void transfer_color(const State& state, float* rgba, std::size_t pixels) {
  const PixelTransferGroup& transfer = state.pixel.transfer;
  for (std::size_t i = 0; i < pixels; ++i) {
    for (int c = 0; c < 4; ++c) {
      float& component = rgba[i * 4 + static_cast<std::size_t>(c)];
      component = component * transfer.scale[c] + transfer.bias[c];
      if (transfer.map_color) component = looked_up(state.pixel_maps[map_r_to_r + static_cast<std::size_t>(c)], component);
    }
  }
}

void transfer_index_to_color(const State& state, const std::uint32_t* indices, std::size_t pixels, float* rgba) {
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::uint32_t index = arithmetic(state.pixel.transfer, indices[i]);
    for (std::size_t c = 0; c < 4; ++c) {
      *rgba++ = static_cast<float>(looked_up(state.pixel_maps[map_i_to_r + c], index));
    }
  }
}

void transfer_stencil(const State& state, std::uint32_t* indices, std::size_t pixels) {
  const PixelTransferGroup& transfer = state.pixel.transfer;
  for (std::size_t i = 0; i < pixels; ++i) {
    indices[i] = arithmetic(transfer, indices[i]);
    if (!transfer.map_stencil) continue;
    indices[i] = static_cast<std::uint32_t>(static_cast<std::int64_t>(looked_up(state.pixel_maps[map_s_to_s], indices[i])));
  }
}

void transfer_depth(const State& state, double* depths, std::size_t pixels) {
  const auto scale = static_cast<double>(state.pixel.transfer.depth_scale);
  const auto bias = static_cast<double>(state.pixel.transfer.depth_bias);
  for (std::size_t i = 0; i < pixels; ++i) depths[i] = depths[i] * scale + bias;
}

std::span<const StateRow> pixel_rows() {
  return rows;
}

}  // namespace gouraud::api
