// Takes rows of client memory, gives colours, indices and depths. A row is converted in pieces: elements to floats, one
// loop a type; then elements to R, G, B, A, one loop a format.
#include "api/commands/unpack_rows.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "api/commands/pixel_transfer.h"

namespace gouraud::api {
namespace {

using pipeline::ByteOrder;

static_assert(std::endian::native == std::endian::little, "bytes of packed words are counted from the low end");

template <class T>
T swapped(T value) {
  if constexpr (sizeof(T) == 1) return value;
  else if constexpr (sizeof(T) == 2) return std::bit_cast<T>(__builtin_bswap16(std::bit_cast<std::uint16_t>(value)));
  else return std::bit_cast<T>(__builtin_bswap32(std::bit_cast<std::uint32_t>(value)));
}

// Element i, wherever it lies.
template <class T, bool swap>
T element(const std::byte* at, std::size_t i) {
  T value;
  std::memcpy(&value, at + i * sizeof(T), sizeof(T));
  return swap ? swapped(value) : value;
}

// [GL1.5 Table 2.9]. `Real` is float or double; 32-bit integers take the way over double.
template <class Real, class T>
Real normalized(T value) {
  using Wide = std::conditional_t<sizeof(T) == 4, double, Real>;
  if constexpr (std::is_floating_point_v<T>) return static_cast<Real>(value);
  else if constexpr (std::is_signed_v<T>) {
    constexpr Wide range = static_cast<Wide>(std::make_unsigned_t<T>(~std::make_unsigned_t<T>{0}));
    return static_cast<Real>((Wide{2} * static_cast<Wide>(value) + Wide{1}) / range);
  } else {
    return static_cast<Real>(static_cast<Wide>(value) / static_cast<Wide>(T(~T{0})));
  }
}

/// Calls visit with a value of the type that elements are of, and with whether they are swapped.
template <class Visit>
void for_element_type(const ClientImage& image, Visit visit) {
  const auto with_order = [&](auto type) {
    image.swap_bytes ? visit(type, std::true_type{}) : visit(type, std::false_type{});
  };
  switch (image.layout.element) {
    case ElementType::unsigned_byte: return visit(std::uint8_t{}, std::false_type{});
    case ElementType::signed_byte: return visit(std::int8_t{}, std::false_type{});
    case ElementType::unsigned_short: return with_order(std::uint16_t{});
    case ElementType::signed_short: return with_order(std::int16_t{});
    case ElementType::unsigned_int: return with_order(std::uint32_t{});
    case ElementType::signed_int: return with_order(std::int32_t{});
    case ElementType::floating: return with_order(float{});
    default: return;
  }
}

std::uint32_t packed_word(const ClientImage& image, const std::byte* at, std::size_t i) {
  switch (image.layout.element) {
    case ElementType::packed_byte: return element<std::uint8_t, false>(at, i);
    case ElementType::packed_short:
      return image.swap_bytes ? element<std::uint16_t, true>(at, i) : element<std::uint16_t, false>(at, i);
    default:
      return image.swap_bytes ? element<std::uint32_t, true>(at, i) : element<std::uint32_t, false>(at, i);
  }
}

void packed_to_floats(const ClientImage& image, const std::byte* at, std::size_t pixels, float* out) {
  const PixelLayout& layout = image.layout;
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::uint32_t word = packed_word(image, at, i);
    for (std::size_t c = 0; c < layout.element_count; ++c) {
      const std::uint32_t most = (1u << layout.field[c].bits) - 1;
      *out++ = static_cast<float>(word >> layout.field[c].shift & most) / static_cast<float>(most);
    }
  }
}

void elements_to_floats(const ClientImage& image, const std::byte* at, std::size_t pixels, float* out) {
  if (image.layout.packed()) return packed_to_floats(image, at, pixels, out);
  const std::size_t count = pixels * image.layout.element_count;
  for_element_type(image, [&]<class T, bool swap>(T, std::bool_constant<swap>) {
    for (std::size_t i = 0; i < count; ++i) out[i] = normalized<float>(element<T, swap>(at, i));
  });
}

// Conversion to RGB, final expansion to RGBA [GL1.5 §3.6.4].
void expand(const PixelLayout& layout, const float* elements, std::size_t pixels, float* rgba) {
  for (std::size_t i = 0; i < pixels; ++i, rgba += 4) {
    rgba[0] = rgba[1] = rgba[2] = 0.0f;
    rgba[3] = 1.0f;
    for (std::size_t c = 0; c < layout.element_count; ++c) {
      const float value = *elements++;
      if (layout.channel[c] == channel_luminance) {
        rgba[0] = rgba[1] = rgba[2] = value;
      } else {
        rgba[layout.channel[c]] = value;
      }
    }
  }
}

const std::byte* first_of(const ClientImage& image, const PixelRun& run) {
  return image.row(run.y, run.z) + static_cast<std::size_t>(run.first) * image.layout.pixel_bytes;
}

// Infinity and NaN as well.
std::uint32_t to_index(float value) {
  if (!(std::abs(value) < 2147483648.0f)) return 0;
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::nearbyint(value)));
}

template <class T>
std::uint32_t to_index(T value) { return static_cast<std::uint32_t>(value); }

}  // namespace

void unpack_color(const ClientImage& image, const PixelRun& run, float* rgba) {
  constexpr std::size_t piece = 64;
  float elements[piece * 4];
  const std::byte* at = first_of(image, run);
  for (auto left = static_cast<std::size_t>(run.count); left > 0;) {
    const std::size_t pixels = std::min(left, piece);
    elements_to_floats(image, at, pixels, elements);
    expand(image.layout, elements, pixels, rgba);
    at += pixels * image.layout.pixel_bytes;
    rgba += pixels * 4;
    left -= pixels;
  }
}

void unpack_bits(const ClientImage& image, const PixelRun& run, std::uint8_t* bits) {
  const std::byte* const row = image.row(run.y, run.z);
  for (GLsizei i = 0; i < run.count; ++i) {
    const std::size_t bit = image.first_bit + static_cast<std::size_t>(run.first) + static_cast<std::size_t>(i);
    const std::size_t place = image.lsb_first ? bit % 8 : 7 - bit % 8;
    bits[i] = static_cast<std::uint8_t>(std::to_integer<unsigned>(row[bit / 8]) >> place & 1u);
  }
}

void unpack_indices(const ClientImage& image, const PixelRun& run, std::uint32_t* indices) {
  const auto count = static_cast<std::size_t>(run.count);
  if (image.layout.element == ElementType::bits) {
    for (std::size_t i = 0; i < count; ++i) {
      std::uint8_t bit;
      unpack_bits(image, {run.y, run.z, run.first + static_cast<GLsizei>(i), 1}, &bit);
      indices[i] = bit;
    }
    return;
  }
  const std::byte* const at = first_of(image, run);
  if (image.layout.kind == PixelKind::depth_stencil) {
    const std::size_t words = image.layout.pixel_bytes / 4u;
    for (std::size_t i = 0; i < count; ++i) {
      const std::byte* const word = at + (i * words + words - 1) * 4;
      indices[i] = (image.swap_bytes ? element<std::uint32_t, true>(word, 0) : element<std::uint32_t, false>(word, 0)) & 0xFFu;
    }
    return;
  }
  for_element_type(image, [&]<class T, bool swap>(T, std::bool_constant<swap>) {
    for (std::size_t i = 0; i < count; ++i) indices[i] = to_index(element<T, swap>(at, i));
  });
}

void unpack_depth(const ClientImage& image, const PixelRun& run, double* depths) {
  const auto count = static_cast<std::size_t>(run.count);
  const std::byte* const at = first_of(image, run);
  if (image.layout.element == ElementType::depth24_stencil8) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto word = image.swap_bytes ? element<std::uint32_t, true>(at, i) : element<std::uint32_t, false>(at, i);
      depths[i] = (word >> 8) / 16777215.0;
    }
  } else if (image.layout.element == ElementType::depth32f_stencil8) {
    for (std::size_t i = 0; i < count; ++i) {
      depths[i] = static_cast<double>(image.swap_bytes ? element<float, true>(at, 2 * i) : element<float, false>(at, 2 * i));
    }
  } else {
    for_element_type(image, [&]<class T, bool swap>(T, std::bool_constant<swap>) {
      for (std::size_t i = 0; i < count; ++i) depths[i] = normalized<double>(element<T, swap>(at, i));
    });
  }
}

void transferred_color(const Context& context, const ClientImage& image, const PixelRun& run, float* rgba) {
  const auto count = static_cast<std::size_t>(run.count);
  if (image.layout.kind == PixelKind::color) {
    unpack_color(image, run, rgba);
    if (transfers_color(context.state.pixel.transfer)) transfer_color(context.state, rgba, count);
    return;
  }
  constexpr std::size_t piece = 256;
  std::uint32_t indices[piece];
  for (std::size_t done = 0; done < count; done += piece) {
    const std::size_t pixels = std::min(piece, count - done);
    unpack_indices(image, {run.y, run.z, run.first + static_cast<GLsizei>(done), static_cast<GLsizei>(pixels)}, indices);
    transfer_index_to_color(context.state, indices, pixels, rgba + done * 4);
  }
}

void transferred_stencil(const Context& context, const ClientImage& image, const PixelRun& run, std::uint32_t* indices) {
  unpack_indices(image, run, indices);
  if (transfers_stencil(context.state.pixel.transfer)) {
    transfer_stencil(context.state, indices, static_cast<std::size_t>(run.count));
  }
}

void transferred_depth(const Context& context, const ClientImage& image, const PixelRun& run, double* depths) {
  unpack_depth(image, run, depths);
  if (transfers_depth(context.state.pixel.transfer)) {
    transfer_depth(context.state, depths, static_cast<std::size_t>(run.count));
  }
}

std::optional<ByteOrder> byte_order(const Context& context, const ClientImage& image) {
  const PixelLayout& layout = image.layout;
  const bool bytes = layout.element == ElementType::unsigned_byte;
  const bool words = layout.element == ElementType::packed_int && layout.field[0].bits == 8;
  if (layout.kind != PixelKind::color || !(bytes || words)) return std::nullopt;
  if (transfers_color(context.state.pixel.transfer)) return std::nullopt;

  ByteOrder order{{ByteOrder::zero, ByteOrder::zero, ByteOrder::zero, ByteOrder::full}};
  for (std::size_t c = 0; c < layout.element_count; ++c) {
    int place = bytes ? static_cast<int>(c) : layout.field[c].shift / 8;
    if (words && image.swap_bytes) place = 3 - place;
    const auto source = static_cast<std::int8_t>(place);
    if (layout.channel[c] == channel_luminance) {
      order.source[0] = order.source[1] = order.source[2] = source;
    } else {
      order.source[layout.channel[c]] = source;
    }
  }
  return order;
}

void unpack_bytes(const ClientImage& image, const ByteOrder& order, const PixelRun& run, std::byte* rgba) {
  const pipeline::ByteArrangement how(order, image.layout.pixel_bytes, 4);
  pipeline::arrange_bytes(how, first_of(image, run), static_cast<std::size_t>(run.count), rgba);
}

}  // namespace gouraud::api
