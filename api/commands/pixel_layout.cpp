#include "api/commands/pixel_layout.h"

#include <optional>

namespace gouraud::api {
namespace {

struct FormatRow {
  GLenum format;
  PixelKind kind;
  std::uint8_t count;
  std::array<std::uint8_t, 4> channel;
};

constexpr FormatRow format_rows[] = {
    {GL_COLOR_INDEX, PixelKind::color_index, 1, {}},
    {GL_STENCIL_INDEX, PixelKind::stencil_index, 1, {}},
    {GL_DEPTH_COMPONENT, PixelKind::depth, 1, {}},
    {GL_DEPTH_STENCIL_EXT, PixelKind::depth_stencil, 2, {}},
    {GL_RED, PixelKind::color, 1, {0}},
    {GL_GREEN, PixelKind::color, 1, {1}},
    {GL_BLUE, PixelKind::color, 1, {2}},
    {GL_ALPHA, PixelKind::color, 1, {3}},
    {GL_RG, PixelKind::color, 2, {0, 1}},
    {GL_RGB, PixelKind::color, 3, {0, 1, 2}},
    {GL_RGBA, PixelKind::color, 4, {0, 1, 2, 3}},
    {GL_BGR, PixelKind::color, 3, {2, 1, 0}},
    {GL_BGRA, PixelKind::color, 4, {2, 1, 0, 3}},
    {GL_ABGR_EXT, PixelKind::color, 4, {3, 2, 1, 0}},
    {GL_LUMINANCE, PixelKind::color, 1, {channel_luminance}},
    {GL_LUMINANCE_ALPHA, PixelKind::color, 2, {channel_luminance, 3}},
};

struct TypeRow {
  GLenum type;
  ElementType element;
  std::uint8_t bytes;
  std::uint8_t fields;              ///< of a packed word
  std::array<PackedField, 4> field;  ///< first component first
};

constexpr TypeRow type_rows[] = {
    {GL_BITMAP, ElementType::bits, 1, 0, {}},
    {GL_UNSIGNED_BYTE, ElementType::unsigned_byte, 1, 0, {}},
    {GL_BYTE, ElementType::signed_byte, 1, 0, {}},
    {GL_UNSIGNED_SHORT, ElementType::unsigned_short, 2, 0, {}},
    {GL_SHORT, ElementType::signed_short, 2, 0, {}},
    {GL_UNSIGNED_INT, ElementType::unsigned_int, 4, 0, {}},
    {GL_INT, ElementType::signed_int, 4, 0, {}},
    {GL_FLOAT, ElementType::floating, 4, 0, {}},
    {GL_UNSIGNED_BYTE_3_3_2, ElementType::packed_byte, 1, 3, {{{5, 3}, {2, 3}, {0, 2}}}},
    {GL_UNSIGNED_BYTE_2_3_3_REV, ElementType::packed_byte, 1, 3, {{{0, 3}, {3, 3}, {6, 2}}}},
    {GL_UNSIGNED_SHORT_5_6_5, ElementType::packed_short, 2, 3, {{{11, 5}, {5, 6}, {0, 5}}}},
    {GL_UNSIGNED_SHORT_5_6_5_REV, ElementType::packed_short, 2, 3, {{{0, 5}, {5, 6}, {11, 5}}}},
    {GL_UNSIGNED_SHORT_4_4_4_4, ElementType::packed_short, 2, 4, {{{12, 4}, {8, 4}, {4, 4}, {0, 4}}}},
    {GL_UNSIGNED_SHORT_4_4_4_4_REV, ElementType::packed_short, 2, 4, {{{0, 4}, {4, 4}, {8, 4}, {12, 4}}}},
    {GL_UNSIGNED_SHORT_5_5_5_1, ElementType::packed_short, 2, 4, {{{11, 5}, {6, 5}, {1, 5}, {0, 1}}}},
    {GL_UNSIGNED_SHORT_1_5_5_5_REV, ElementType::packed_short, 2, 4, {{{0, 5}, {5, 5}, {10, 5}, {15, 1}}}},
    {GL_UNSIGNED_INT_8_8_8_8, ElementType::packed_int, 4, 4, {{{24, 8}, {16, 8}, {8, 8}, {0, 8}}}},
    {GL_UNSIGNED_INT_8_8_8_8_REV, ElementType::packed_int, 4, 4, {{{0, 8}, {8, 8}, {16, 8}, {24, 8}}}},
    {GL_UNSIGNED_INT_10_10_10_2, ElementType::packed_int, 4, 4, {{{22, 10}, {12, 10}, {2, 10}, {0, 2}}}},
    {GL_UNSIGNED_INT_2_10_10_10_REV, ElementType::packed_int, 4, 4, {{{0, 10}, {10, 10}, {20, 10}, {30, 2}}}},
    {GL_UNSIGNED_INT_24_8_EXT, ElementType::depth24_stencil8, 4, 0, {}},
    {GL_FLOAT_32_UNSIGNED_INT_24_8_REV, ElementType::depth32f_stencil8, 4, 0, {}},
};

template <class Row, std::size_t count>
const Row* find(const Row (&rows)[count], GLenum Row::*key, GLenum name) {
  for (const Row& row : rows) {
    if (row.*key == name) return &row;
  }
  return nullptr;
}

bool holds_depth_and_stencil(ElementType element) {
  return element == ElementType::depth24_stencil8 || element == ElementType::depth32f_stencil8;
}

struct Refusal {
  GLenum error;
  const char* message;
};

std::optional<Refusal> refusal(const FormatRow* format, const TypeRow* type) {
  if (format == nullptr) return Refusal{GL_INVALID_ENUM, "format is not a pixel format"};
  if (type == nullptr) return Refusal{GL_INVALID_ENUM, "type is not a pixel type"};
  const bool is_index = format->kind == PixelKind::color_index || format->kind == PixelKind::stencil_index;
  if (type->element == ElementType::bits && !is_index) return Refusal{GL_INVALID_ENUM, "GL_BITMAP goes with indices alone"};
  const bool both = holds_depth_and_stencil(type->element);
  if (format->kind == PixelKind::depth_stencil && !both) {
    return Refusal{GL_INVALID_ENUM, "type does not hold depth and stencil"};
  }
  if (format->kind != PixelKind::depth_stencil && both) {
    return Refusal{GL_INVALID_OPERATION, "type holds depth and stencil, format does not"};
  }
  // [GL1.5 Table 3.8]: RGB alone for three components, not BGR.
  const bool matches = type->fields == format->count && format->kind == PixelKind::color && format->format != GL_BGR;
  if (type->fields != 0 && !matches) return Refusal{GL_INVALID_OPERATION, "the packed type does not match format"};
  return std::nullopt;
}

PixelLayout layout_of(const FormatRow& format, const TypeRow& type) {
  PixelLayout layout;
  layout.kind = format.kind;
  layout.element = type.element;
  layout.element_count = format.count;
  layout.element_bytes = type.bytes;
  layout.channel = format.channel;
  layout.field = type.field;
  layout.pixel_bytes = static_cast<std::uint8_t>(type.bytes * format.count);
  if (type.fields != 0 || type.element == ElementType::depth24_stencil8) layout.pixel_bytes = type.bytes;
  if (type.element == ElementType::bits) layout.pixel_bytes = 0;
  return layout;
}

}  // namespace

bool find_pixel_layout(Context& context, const char* command, GLenum format, GLenum type, PixelLayout& layout) {
  if (has_pixel_layout(format, type, layout)) return true;
  const auto refused = refusal(find(format_rows, &FormatRow::format, format), find(type_rows, &TypeRow::type, type));
  context.record_error(refused->error, command, refused->message);
  return false;
}

bool has_pixel_layout(GLenum format, GLenum type, PixelLayout& layout) {
  const FormatRow* const format_row = find(format_rows, &FormatRow::format, format);
  const TypeRow* const type_row = find(type_rows, &TypeRow::type, type);
  if (refusal(format_row, type_row)) return false;
  layout = layout_of(*format_row, *type_row);
  return true;
}

}  // namespace gouraud::api
