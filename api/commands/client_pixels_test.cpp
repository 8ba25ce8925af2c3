// Every format with every type, in sizes 0 to 5 under many pixel store parameters: what unpack_rows reads is checked
// against a decoder that takes one element at a time, what pack_rows writes against what was read. Memory is exactly as
// large as the specification's equations say, so that the address sanitizer sees any step beyond.
#include "api/commands/client_pixels.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "api/commands/pack_rows.h"
#include "api/commands/test_screen.h"
#include "api/commands/unpack_rows.h"

namespace gouraud::api {
namespace {

using Bytes = std::vector<std::byte>;

constexpr GLenum formats[] = {GL_COLOR_INDEX, GL_STENCIL_INDEX, GL_DEPTH_COMPONENT, GL_DEPTH_STENCIL_EXT, GL_RED, GL_GREEN,
                              GL_BLUE, GL_ALPHA, GL_RGB, GL_RGBA, GL_BGR, GL_BGRA, GL_ABGR_EXT, GL_LUMINANCE,
                              GL_LUMINANCE_ALPHA};
constexpr GLenum types[] = {GL_BITMAP, GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT, GL_UNSIGNED_INT, GL_INT,
                            GL_FLOAT, GL_UNSIGNED_BYTE_3_3_2, GL_UNSIGNED_BYTE_2_3_3_REV, GL_UNSIGNED_SHORT_5_6_5,
                            GL_UNSIGNED_SHORT_5_6_5_REV, GL_UNSIGNED_SHORT_4_4_4_4, GL_UNSIGNED_SHORT_4_4_4_4_REV,
                            GL_UNSIGNED_SHORT_5_5_5_1, GL_UNSIGNED_SHORT_1_5_5_5_REV, GL_UNSIGNED_INT_8_8_8_8,
                            GL_UNSIGNED_INT_8_8_8_8_REV, GL_UNSIGNED_INT_10_10_10_2, GL_UNSIGNED_INT_2_10_10_10_REV,
                            GL_UNSIGNED_INT_24_8_EXT, GL_FLOAT_32_UNSIGNED_INT_24_8_REV};

/// As the specification says it, a step at a time [GL1.5 §3.6.4 eqs 3.10 to 3.12].
struct Reference {
  std::size_t element, group, row, image, first, bit, end;

  Reference(const PixelStore& store, const ImageSize& size, GLenum type, const PixelLayout& layout) {
    const auto number = [](GLint value) { return static_cast<std::size_t>(value); };
    const std::size_t l = number(store.row_length_px > 0 ? store.row_length_px : size.width), a = number(store.alignment);
    element = layout.element_bytes;
    group = layout.pixel_bytes;
    bit = 0;
    if (type == GL_BITMAP) {
      row = a * ((l + 8 * a - 1) / (8 * a));
      bit = number(store.skip_pixels) % 8;
    } else {
      const std::size_t bytes = l * group;
      row = element >= a ? bytes : a * ((bytes + a - 1) / a);
    }
    image = row * number(size.volume && store.image_height_px > 0 ? store.image_height_px : size.height);
    first = number(store.skip_rows) * row + (type == GL_BITMAP ? number(store.skip_pixels) / 8 : number(store.skip_pixels) * group);
    if (size.volume) first += number(store.skip_images) * image;
    end = 0;
    if (size.width == 0 || size.height == 0 || size.depth == 0) return;
    end = first + number(size.depth - 1) * image + number(size.height - 1) * row +
          (type == GL_BITMAP ? (bit + number(size.width) + 7) / 8 : number(size.width) * group);
  }
};

std::vector<PixelStore> stores() {
  std::vector<PixelStore> all{{}};
  for (const GLint alignment : {1, 2, 8}) all.push_back({.alignment = alignment});
  all.push_back({.swap_bytes = true});
  all.push_back({.lsb_first = true});
  all.push_back({.row_length_px = 7, .skip_pixels = 2, .alignment = 1});
  all.push_back({.row_length_px = 11, .skip_rows = 3, .skip_pixels = 5});
  all.push_back({.lsb_first = true, .row_length_px = 19, .skip_rows = 1, .skip_pixels = 13, .alignment = 2});
  all.push_back({.swap_bytes = true, .skip_rows = 2, .alignment = 8, .image_height_px = 6, .skip_images = 2});
  all.push_back({.row_length_px = 3, .alignment = 1});  // rows overlap where they are wider
  return all;
}

class ClientImages : public ::testing::Test {
 protected:
  template <class Visit>
  void for_every_image(Visit visit) {
    for (const PixelStore& store : stores()) {
      screen_.context.state.unpack = screen_.context.state.pack = store;
      for (const GLenum format : formats) {
        for (const GLenum type : types) {
          PixelLayout layout;
          const bool exists = find_pixel_layout(screen_.context, "test", format, type, layout);
          if (screen_.context.take_error(); !exists) continue;
          for (int size = 0; size < 6 * 6 * 3; ++size) {
            visit(store, ImageSize{size % 6, size / 6 % 6, size / 36, size / 36 != 1}, format, type, layout);
          }
        }
      }
    }
  }

  Screen screen_;
};

std::uint64_t word_at(const Bytes& memory, std::size_t place, std::size_t bytes, bool swap) {
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    const std::size_t from = swap ? bytes - 1 - i : i;
    word |= std::to_integer<std::uint64_t>(memory[place + from]) << (8 * i);
  }
  return word;
}

/// Element `c` of the group at `place`: a component in [-1, 1], or an index as it is.
double decoded(const Bytes& memory, std::size_t place, std::size_t c, GLenum type, const PixelLayout& layout, bool swap) {
  if (layout.packed()) {
    const std::uint64_t most = (1u << layout.field[c].bits) - 1;
    const std::uint64_t word = word_at(memory, place, layout.element_bytes, swap);
    return static_cast<double>(word >> layout.field[c].shift & most) / static_cast<double>(most);
  }
  const std::uint64_t word = word_at(memory, place + c * layout.element_bytes, layout.element_bytes, swap);
  const bool index = layout.kind == PixelKind::color_index || layout.kind == PixelKind::stencil_index;
  if (type == GL_FLOAT || (type == GL_FLOAT_32_UNSIGNED_INT_24_8_REV && c == 0)) {
    const auto bits = static_cast<std::uint32_t>(word);
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return static_cast<double>(value);
  }
  if (type == GL_UNSIGNED_INT_24_8_EXT) return static_cast<double>(word >> 8) / 16777215.0;
  const double range = std::ldexp(1.0, 8 * layout.element_bytes) - 1.0;
  if (type == GL_BYTE || type == GL_SHORT || type == GL_INT) {
    const double value = static_cast<double>(word) - (word >> (8 * layout.element_bytes - 1) ? range + 1.0 : 0.0);
    return index ? value : (2.0 * value + 1.0) / range;
  }
  return index ? static_cast<double>(word) : static_cast<double>(word) / range;
}

/// Random bytes, or floats in [0, 1] (in indices: up to 250) where the type is one.
Bytes random_memory(std::size_t bytes, GLenum type, const PixelLayout& layout, bool swap, std::size_t first) {
  static std::mt19937 random(5);
  Bytes memory(bytes);
  for (std::byte& byte : memory) byte = static_cast<std::byte>(random() & 0xFFu);
  const bool index = layout.kind == PixelKind::color_index || layout.kind == PixelKind::stencil_index;
  if (type != GL_FLOAT && type != GL_FLOAT_32_UNSIGNED_INT_24_8_REV) return memory;
  for (std::size_t place = first % layout.element_bytes; place + 4 <= bytes; place += layout.element_bytes) {
    const float value = static_cast<float>(random() % 1001) * (index ? 0.25f : 0.001f);
    std::memcpy(&memory[place], &value, sizeof value);
    if (swap) std::reverse(memory.begin() + static_cast<std::ptrdiff_t>(place), memory.begin() + static_cast<std::ptrdiff_t>(place) + 4);
  }
  return memory;
}

void expect_decoded(const ClientImage& image, const Reference& where, const Bytes& memory, GLenum type, GLsizei y, GLsizei z) {
  const auto width = static_cast<std::size_t>(image.size.width);
  const PixelLayout& layout = image.layout;
  const std::size_t row = where.first + static_cast<std::size_t>(z) * where.image + static_cast<std::size_t>(y) * where.row;
  std::vector<float> rgba(width * 4);
  std::vector<std::uint32_t> indices(width);
  std::vector<double> depths(width);
  const PixelRun run = whole_row(image, y, z);
  const bool stencil = layout.kind == PixelKind::depth_stencil;
  if (layout.kind == PixelKind::color) unpack_color(image, run, rgba.data());
  if (layout.kind == PixelKind::depth || stencil) unpack_depth(image, run, depths.data());
  if (layout.kind == PixelKind::color_index || layout.kind == PixelKind::stencil_index || stencil) {
    unpack_indices(image, run, indices.data());
  }
  for (std::size_t i = 0; i < width; ++i) {
    const std::size_t place = row + i * where.group;
    if (type == GL_BITMAP) {
      const std::size_t bit = where.bit + i;
      const std::size_t shift = image.lsb_first ? bit % 8 : 7 - bit % 8;
      ASSERT_EQ(indices[i], std::to_integer<unsigned>(memory[row + bit / 8]) >> shift & 1u);
    } else if (layout.kind == PixelKind::color) {
      double expected[4] = {0, 0, 0, 1};
      for (std::size_t c = 0; c < layout.element_count; ++c) {
        const double value = decoded(memory, place, c, type, layout, image.swap_bytes);
        if (layout.channel[c] == channel_luminance) {
          expected[0] = expected[1] = expected[2] = value;
        } else {
          expected[layout.channel[c]] = value;
        }
      }
      for (std::size_t c = 0; c < 4; ++c) ASSERT_NEAR(rgba[i * 4 + c], expected[c], 1e-7) << c;
    } else if (layout.kind == PixelKind::depth || stencil) {
      ASSERT_NEAR(depths[i], decoded(memory, place, 0, type, layout, image.swap_bytes), 1e-15);
    } else {
      const double index = std::nearbyint(decoded(memory, place, 0, type, layout, image.swap_bytes));
      ASSERT_EQ(indices[i], static_cast<std::uint32_t>(static_cast<std::int64_t>(index)));
    }
    if (stencil) {
      const std::size_t word = place + where.group - 4;
      ASSERT_EQ(indices[i], word_at(memory, word, 4, image.swap_bytes) & 0xFFu);
    }
  }
}

TEST_F(ClientImages, GiveWhatTheSpecificationsEquationsGive) {
  for_every_image([&](const PixelStore& store, const ImageSize& size, GLenum format, GLenum type, const PixelLayout& layout) {
    const Reference where(store, size, type, layout);
    const Bytes memory = random_memory(where.end, type, layout, store.swap_bytes, where.first);
    ClientImage image;
    ASSERT_TRUE(check_unpack(screen_.context, "test", size, format, type, memory.data(), image));
    if (where.end == 0) return;
    ASSERT_EQ(image.row(0), memory.data() + where.first);
    for (GLsizei z = 0; z < size.depth; ++z) {
      for (GLsizei y = 0; y < size.height; ++y) expect_decoded(image, where, memory, type, y, z);
    }
    ASSERT_FALSE(::testing::Test::HasFatalFailure()) << std::hex << format << " " << type;
  });
}

/// Which bytes of memory hold pixels.
std::vector<bool> pixel_bytes(const Reference& where, const ImageSize& size, GLenum type) {
  std::vector<bool> inside(where.end);
  const auto number = [](GLint value) { return static_cast<std::size_t>(value); };
  const std::size_t length = type == GL_BITMAP ? (where.bit + number(size.width) + 7) / 8 : number(size.width) * where.group;
  for (std::size_t z = 0; z < number(size.depth); ++z) {
    for (std::size_t y = 0; y < number(size.height); ++y) {
      for (std::size_t i = 0; i < length; ++i) inside[where.first + z * where.image + y * where.row + i] = true;
    }
  }
  return inside;
}

void copy_row(const ClientImage& from, const ClientImage& to, GLsizei y, GLsizei z) {
  const auto width = static_cast<std::size_t>(from.size.width);
  const PixelRun run = whole_row(from, y, z);
  std::vector<float> rgba(width * 4);
  std::vector<std::uint32_t> indices(width);
  std::vector<double> depths(width);
  switch (from.layout.kind) {
    case PixelKind::color:
      unpack_color(from, run, rgba.data());
      return pack_color(to, run, rgba.data());
    case PixelKind::depth:
      unpack_depth(from, run, depths.data());
      return pack_depth(to, run, depths.data());
    case PixelKind::depth_stencil:
      unpack_depth(from, run, depths.data());
      unpack_indices(from, run, indices.data());
      return pack_depth_stencil(to, run, depths.data(), indices.data());
    default:
      unpack_indices(from, run, indices.data());
      return pack_indices(to, run, indices.data());
  }
}

/// Whether packing what was unpacked gives the same bytes: not luminance, which is a sum; not signed components, which
/// are clamped; not 32-bit components, which are floats in between; not cut-off depth bytes, nor a stencil's filler bits.
bool survives(GLenum format, GLenum type, const PixelLayout& layout) {
  if (type == GL_BITMAP || layout.channel[0] == channel_luminance) return false;
  const bool index = layout.kind == PixelKind::color_index || layout.kind == PixelKind::stencil_index;
  if (index) return type != GL_FLOAT;
  if (type == GL_BYTE || type == GL_SHORT || type == GL_INT) return false;
  if (layout.kind == PixelKind::color) return type != GL_UNSIGNED_INT;
  return !(format == GL_DEPTH_COMPONENT && type == GL_UNSIGNED_BYTE) && type != GL_FLOAT_32_UNSIGNED_INT_24_8_REV;
}

TEST_F(ClientImages, ComeBackAndLeaveTheRestOfMemoryAlone) {
  for_every_image([&](const PixelStore& store, const ImageSize& size, GLenum format, GLenum type, const PixelLayout& layout) {
    const Reference where(store, size, type, layout);
    const Bytes memory = random_memory(where.end, type, layout, store.swap_bytes, where.first);
    Bytes packed(where.end, std::byte{0xEE});
    ClientImage from, to;
    ASSERT_TRUE(check_unpack(screen_.context, "test", size, format, type, memory.data(), from));
    ASSERT_TRUE(check_pack(screen_.context, "test", size, format, type, packed.data(), to));
    if (where.end == 0) return;
    for (GLsizei z = 0; z < size.depth; ++z) {
      for (GLsizei y = 0; y < size.height; ++y) copy_row(from, to, y, z);
    }
    const std::vector<bool> inside = pixel_bytes(where, size, type);
    for (std::size_t i = 0; i < where.end; ++i) {
      if (inside[i] && !survives(format, type, layout)) continue;
      ASSERT_EQ(packed[i], inside[i] ? memory[i] : std::byte{0xEE}) << std::hex << format << " " << type;
    }
  });
}

TEST_F(ClientImages, TakenAsBytesAreTheFloatsToNearest) {
  for_every_image([&](const PixelStore& store, const ImageSize& size, GLenum format, GLenum type, const PixelLayout& layout) {
    const Reference where(store, size, type, layout);
    const Bytes memory = random_memory(where.end, type, layout, store.swap_bytes, where.first);
    ClientImage image;
    ASSERT_TRUE(check_unpack(screen_.context, "test", size, format, type, memory.data(), image));
    const auto order = byte_order(screen_.context, image);
    if (!order || where.end == 0) return;
    const auto count = static_cast<std::size_t>(size.width) * 4;
    std::vector<float> rgba(count);
    std::vector<std::byte> bytes(count);
    unpack_color(image, whole_row(image, 0), rgba.data());
    unpack_bytes(image, *order, whole_row(image, 0), bytes.data());
    for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(std::to_integer<int>(bytes[i]), std::nearbyint(rgba[i] * 255.0f)) << format << " " << type;
  });
}

TEST_F(ClientImages, OfAbsurdSizesHaveDefinedAddresses) {
  constexpr GLint huge = std::numeric_limits<GLint>::max();
  screen_.context.state.unpack = {.row_length_px = huge, .skip_rows = huge, .skip_pixels = huge, .alignment = 8,
                                  .image_height_px = huge, .skip_images = huge};
  ClientImage image;
  EXPECT_TRUE(check_unpack(screen_.context, "test", {huge, huge, huge, true}, GL_RGBA, GL_FLOAT, &image, image));
  image.row(huge - 1, huge - 1);
}

TEST_F(ClientImages, OfABufferMustLieWithinIt) {
  GLuint name = 0;
  glGenBuffers(1, &name);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER_ARB, name);
  glBufferData(GL_PIXEL_UNPACK_BUFFER_ARB, 40, nullptr, GL_STATIC_DRAW);
  const auto check = [&](GLsizei width, GLsizei height, std::uintptr_t offset, GLenum type = GL_UNSIGNED_BYTE) {
    ClientImage image;
    const bool found = check_unpack(screen_.context, "test", {width, height}, GL_RGB, type,
                                    reinterpret_cast<const void*>(offset), image);
    EXPECT_EQ(screen_.context.take_error(), static_cast<GLenum>(found ? GL_NO_ERROR : GL_INVALID_OPERATION));
    return found;
  };
  EXPECT_TRUE(check(3, 3, 0));    // 12 + 12 + 9 bytes
  EXPECT_TRUE(check(3, 3, 7));    // exactly to the end
  EXPECT_FALSE(check(3, 3, 8));
  EXPECT_TRUE(check(0, 3, 8));
  EXPECT_FALSE(check(3, 3, ~std::uintptr_t{0}));
  EXPECT_FALSE(check(std::numeric_limits<GLint>::max(), std::numeric_limits<GLint>::max(), 0));
  EXPECT_TRUE(check(1, 1, 4, GL_FLOAT));
  EXPECT_FALSE(check(1, 1, 5, GL_FLOAT));
  screen_.context.state.unpack.skip_rows = std::numeric_limits<GLint>::max();
  screen_.context.state.unpack.row_length_px = std::numeric_limits<GLint>::max();
  EXPECT_FALSE(check(1, 1, 0));
  screen_.context.state.unpack = {};
  glMapBuffer(GL_PIXEL_UNPACK_BUFFER_ARB, GL_READ_ONLY);
  EXPECT_FALSE(check(1, 1, 0));
  glUnmapBuffer(GL_PIXEL_UNPACK_BUFFER_ARB);
  EXPECT_TRUE(check(1, 1, 0));
  glDeleteBuffers(1, &name);
  GLint bound = -1;
  glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING_ARB, &bound);
  EXPECT_EQ(bound, 0);
}

}  // namespace
}  // namespace gouraud::api
