// Takes colours, indices and depths, gives rows of client memory in any format and type.
#include "api/commands/pack_rows.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace gouraud::api {
namespace {

template <class T>
T swapped(T value) {
  if constexpr (sizeof(T) == 1) return value;
  else if constexpr (sizeof(T) == 2) return std::bit_cast<T>(__builtin_bswap16(std::bit_cast<std::uint16_t>(value)));
  else return std::bit_cast<T>(__builtin_bswap32(std::bit_cast<std::uint32_t>(value)));
}

template <class T>
void store(const ClientImage& image, std::byte* at, std::size_t i, T value) {
  if (image.swap_bytes) value = swapped(value);
  std::memcpy(at + i * sizeof(T), &value, sizeof(T));
}

template <class Real>
Real clamped(Real value) { return value > 0 ? (value < 1 ? value : Real{1}) : Real{0}; }  // NaN gives 0

/// A colour component as an integer of [0, most], to nearest.
std::uint32_t to_integer_range(float component, std::uint32_t most) {
  const double scaled = static_cast<double>(clamped(component)) * most;
  return static_cast<std::uint32_t>(std::nearbyint(scaled));
}
std::uint32_t to_integer_range(std::uint8_t component, std::uint32_t most) {
  return static_cast<std::uint32_t>((std::uint64_t{component} * most * 2 + 255) / 510);
}

template <class T, class Source>
T to_element(Source component) {
  if constexpr (!std::is_floating_point_v<T>) {
    return static_cast<T>(to_integer_range(component, static_cast<std::uint32_t>(std::numeric_limits<T>::max())));
  } else if constexpr (std::is_floating_point_v<Source>) {
    return component;
  } else {
    return static_cast<float>(component) * (1.0f / 255.0f);
  }
}

float luminance_of(const float* rgba) { return std::min((rgba[0] + rgba[1]) + rgba[2], 1.0f); }
std::uint8_t luminance_of(const std::uint8_t* rgba) {
  return static_cast<std::uint8_t>(std::min(rgba[0] + rgba[1] + rgba[2], 255));
}

template <class Source>
Source component_of(const Source* rgba, std::uint8_t channel) {
  return channel == channel_luminance ? luminance_of(rgba) : rgba[channel];
}

template <class T, class Source>
void pack_elements(const ClientImage& image, std::byte* at, std::size_t pixels, const Source* rgba) {
  const PixelLayout& layout = image.layout;
  std::size_t place = 0;
  for (std::size_t i = 0; i < pixels; ++i, rgba += 4) {
    for (std::size_t c = 0; c < layout.element_count; ++c) {
      store(image, at, place++, to_element<T>(component_of(rgba, layout.channel[c])));
    }
  }
}

template <class T, class Source>
void pack_words(const ClientImage& image, std::byte* at, std::size_t pixels, const Source* rgba) {
  const PixelLayout& layout = image.layout;
  for (std::size_t i = 0; i < pixels; ++i, rgba += 4) {
    std::uint32_t word = 0;
    for (std::size_t c = 0; c < layout.element_count; ++c) {
      word |= to_integer_range(rgba[layout.channel[c]], (1u << layout.field[c].bits) - 1) << layout.field[c].shift;
    }
    store(image, at, i, static_cast<T>(word));
  }
}

std::byte* first_of(const ClientImage& image, const PixelRun& run) {
  return image.row(run.y, run.z) + static_cast<std::size_t>(run.first) * image.layout.pixel_bytes;
}

template <class Source>
void pack(const ClientImage& image, const PixelRun& run, const Source* rgba) {
  std::byte* const at = first_of(image, run);
  const auto pixels = static_cast<std::size_t>(run.count);
  switch (image.layout.element) {
    case ElementType::unsigned_byte: return pack_elements<std::uint8_t>(image, at, pixels, rgba);
    case ElementType::signed_byte: return pack_elements<std::int8_t>(image, at, pixels, rgba);
    case ElementType::unsigned_short: return pack_elements<std::uint16_t>(image, at, pixels, rgba);
    case ElementType::signed_short: return pack_elements<std::int16_t>(image, at, pixels, rgba);
    case ElementType::unsigned_int: return pack_elements<std::uint32_t>(image, at, pixels, rgba);
    case ElementType::signed_int: return pack_elements<std::int32_t>(image, at, pixels, rgba);
    case ElementType::floating: return pack_elements<float>(image, at, pixels, rgba);
    case ElementType::packed_byte: return pack_words<std::uint8_t>(image, at, pixels, rgba);
    case ElementType::packed_short: return pack_words<std::uint16_t>(image, at, pixels, rgba);
    case ElementType::packed_int: return pack_words<std::uint32_t>(image, at, pixels, rgba);
    default: return;
  }
}

// Sets or clears bits, the others of their bytes stay.
void pack_bits(const ClientImage& image, const PixelRun& run, const std::uint32_t* indices) {
  std::byte* const row = image.row(run.y, run.z);
  for (std::size_t i = 0; i < static_cast<std::size_t>(run.count); ++i) {
    const std::size_t bit = image.first_bit + static_cast<std::size_t>(run.first) + i;
    const std::byte mask{static_cast<std::uint8_t>(1u << (image.lsb_first ? bit % 8 : 7 - bit % 8))};
    std::byte& byte = row[bit / 8];
    byte = (indices[i] & 1u) != 0 ? byte | mask : byte & ~mask;
  }
}

template <class T>
T depth_element(double depth) {
  if constexpr (std::is_floating_point_v<T>) return static_cast<T>(depth);
  else if constexpr (sizeof(T) == 1) return static_cast<T>(static_cast<float>(clamped(depth)) * std::numeric_limits<T>::max());
  else return static_cast<T>(std::nearbyint(clamped(depth) * std::numeric_limits<T>::max()));
}

/// Calls visit with a value of the type that elements are of.
template <class Visit>
void for_plain_type(ElementType type, Visit visit) {
  switch (type) {
    case ElementType::unsigned_byte: return visit(std::uint8_t{});
    case ElementType::signed_byte: return visit(std::int8_t{});
    case ElementType::unsigned_short: return visit(std::uint16_t{});
    case ElementType::signed_short: return visit(std::int16_t{});
    case ElementType::unsigned_int: return visit(std::uint32_t{});
    case ElementType::signed_int: return visit(std::int32_t{});
    case ElementType::floating: return visit(float{});
    default: return;
  }
}

}  // namespace

void pack_color(const ClientImage& image, const PixelRun& run, const float* rgba) { pack(image, run, rgba); }
void pack_color(const ClientImage& image, const PixelRun& run, const std::uint8_t* rgba) { pack(image, run, rgba); }

void pack_indices(const ClientImage& image, const PixelRun& run, const std::uint32_t* indices) {
  if (image.layout.element == ElementType::bits) return pack_bits(image, run, indices);
  std::byte* const at = first_of(image, run);
  for_plain_type(image.layout.element, [&]<class T>(T) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(run.count); ++i) store(image, at, i, static_cast<T>(indices[i]));
  });
}

void pack_depth(const ClientImage& image, const PixelRun& run, const double* depths) {
  std::byte* const at = first_of(image, run);
  for_plain_type(image.layout.element, [&]<class T>(T) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(run.count); ++i) store(image, at, i, depth_element<T>(depths[i]));
  });
}

void pack_fixed_depth(const ClientImage& image, const PixelRun& run, const std::uint32_t* depths) {
  std::byte* const at = first_of(image, run);
  for (std::size_t i = 0; i < static_cast<std::size_t>(run.count); ++i) store(image, at, i, depths[i]);
}

void pack_depth_stencil(const ClientImage& image, const PixelRun& run, const double* depths, const std::uint32_t* stencils) {
  std::byte* const at = first_of(image, run);
  for (std::size_t i = 0; i < static_cast<std::size_t>(run.count); ++i) {
    const std::uint32_t stencil = stencils[i] & 0xFFu;
    if (image.layout.element == ElementType::depth24_stencil8) {
      store(image, at, i, static_cast<std::uint32_t>(std::nearbyint(clamped(depths[i]) * 16777215.0)) << 8 | stencil);
    } else {
      store(image, at, 2 * i, static_cast<float>(depths[i]));
      store(image, at, 2 * i + 1, stencil);
    }
  }
}

}  // namespace gouraud::api
