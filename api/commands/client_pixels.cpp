// Takes pixel store parameters and a pointer, gives addresses [GL1.5 §3.6.4 eqs 3.10 to 3.12].
#include "api/commands/client_pixels.h"

#include <limits>

namespace gouraud::api {
namespace {

/// A number of bytes that knows when it has outgrown 64 bits.
struct Extent {
  std::uint64_t bytes = 0;
  bool overflown = false;

  Extent& add(std::uint64_t count, std::uint64_t size) {
    std::uint64_t product;
    overflown |= __builtin_mul_overflow(count, size, &product);
    overflown |= __builtin_add_overflow(bytes, product, &bytes);
    return *this;
  }
};

std::uint64_t not_negative(GLsizei value) { return static_cast<std::uint64_t>(value > 0 ? value : 0); }

// Rows, images and the first pixel, all relative to the pointer.
struct Places {
  std::uint64_t row_stride = 0, image_stride = 0, first = 0;
  std::uint64_t bit = 0;  ///< of the first byte
  Extent end;             ///< behind the last byte read
};

Places places_of(const PixelStore& store, const ImageSize& size, const PixelLayout& layout) {
  const std::uint64_t alignment = not_negative(store.alignment), skip_pixels = not_negative(store.skip_pixels);
  const std::uint64_t row_px = not_negative(store.row_length_px > 0 ? store.row_length_px : size.width);
  const bool bits = layout.element == ElementType::bits;
  Places places;
  places.row_stride = bits ? (row_px + 7) / 8 : row_px * layout.pixel_bytes;
  if (bits || layout.element_bytes < alignment) {
    places.row_stride = (places.row_stride + alignment - 1) / alignment * alignment;
  }
  const std::uint64_t image_rows =
      not_negative(size.volume && store.image_height_px > 0 ? store.image_height_px : size.height);
  Extent image_stride, first;
  image_stride.add(image_rows, places.row_stride);
  const std::uint64_t first_pixel = bits ? skip_pixels / 8 : skip_pixels * layout.pixel_bytes;
  first.add(size.volume ? not_negative(store.skip_images) : 0, image_stride.bytes)
      .add(not_negative(store.skip_rows), places.row_stride)
      .add(1, first_pixel);
  places.image_stride = image_stride.bytes;
  places.first = first.bytes;
  places.bit = bits ? skip_pixels % 8 : 0;
  if (size.width <= 0 || size.height <= 0 || size.depth <= 0) return places;

  const std::uint64_t width = not_negative(size.width);
  places.end = first;
  places.end.overflown |= image_stride.overflown;
  places.end.add(not_negative(size.depth) - 1, image_stride.bytes)
      .add(not_negative(size.height) - 1, places.row_stride)
      .add(1, bits ? (places.bit + width + 7) / 8 : width * layout.pixel_bytes);
  return places;
}

/// The bound buffer's bytes from `offset` on. False, and an error is recorded, if `end` bytes from there are not its.
bool map_range(Context& context, const char* command, const BufferObject& buffer, const Extent& end,
               std::size_t element_bytes, std::uintptr_t& address) {
  const std::uint64_t offset = address;
  const char* const problem = buffer.mapped                    ? "the pixel buffer is mapped"
                              : offset % element_bytes != 0    ? "the offset is no multiple of the type's size"
                              : end.overflown                  ? "the image is not within the pixel buffer"
                              : end.bytes == 0                 ? nullptr
                              : offset > buffer.size_bytes     ? "the offset is not within the pixel buffer"
                              : end.bytes > buffer.size_bytes - offset ? "the image is not within the pixel buffer"
                                                                       : nullptr;
  if (problem != nullptr) {
    context.record_error(GL_INVALID_OPERATION, command, problem);
    return false;
  }
  address = reinterpret_cast<std::uintptr_t>(buffer.bytes.get()) + address;
  return true;
}

bool locate(Context& context, const char* command, const ImageSize& size, const PixelLayout& layout,
            const PixelStore& store, const BufferBinding& buffer, const void* pointer, ClientImage& image) {
  const Places places = places_of(store, size, layout);
  image.layout = layout;
  image.size = size;
  image.swap_bytes = store.swap_bytes;
  image.lsb_first = store.lsb_first;
  image.row_stride = static_cast<std::uintptr_t>(places.row_stride);
  image.image_stride = static_cast<std::uintptr_t>(places.image_stride);
  image.first_bit = static_cast<std::uint8_t>(places.bit);
  image.address = reinterpret_cast<std::uintptr_t>(pointer);
  image.in_buffer = buffer != nullptr;
  if (image.in_buffer && !map_range(context, command, *buffer, places.end, layout.element_bytes, image.address)) {
    return false;
  }
  if (!image.null()) image.address += static_cast<std::uintptr_t>(places.first);
  return true;
}

bool check_size(Context& context, const char* command, const ImageSize& size) {
  if (size.width >= 0 && size.height >= 0 && size.depth >= 0) return true;
  context.record_error(GL_INVALID_VALUE, command, "a size is negative");
  return false;
}

bool check_array(Context& context, const char* command, std::size_t count, std::size_t element_bytes,
                 const BufferBinding& buffer, std::uintptr_t& address) {
  if (buffer == nullptr) return true;
  Extent end;
  end.add(count, element_bytes);
  return map_range(context, command, *buffer, end, element_bytes, address);
}

}  // namespace

std::size_t ClientImage::row_bytes() const {
  const auto width = static_cast<std::size_t>(size.width);
  return layout.element == ElementType::bits ? (first_bit + width + 7) / 8 : width * layout.pixel_bytes;
}

bool locate_unpack(Context& context, const char* command, const ImageSize& size, const PixelLayout& layout,
                   const void* pointer, ClientImage& image) {
  return locate(context, command, size, layout, context.state.unpack, context.state.unpack_buffer, pointer, image);
}

bool locate_pack(Context& context, const char* command, const ImageSize& size, const PixelLayout& layout, void* pointer,
                 ClientImage& image) {
  return locate(context, command, size, layout, context.state.pack, context.state.pack_buffer, pointer, image);
}

bool check_unpack(Context& context, const char* command, const ImageSize& size, GLenum format, GLenum type,
                  const void* pointer, ClientImage& image) {
  PixelLayout layout;
  return find_pixel_layout(context, command, format, type, layout) && check_size(context, command, size) &&
         locate_unpack(context, command, size, layout, pointer, image);
}

bool check_pack(Context& context, const char* command, const ImageSize& size, GLenum format, GLenum type, void* pointer,
                ClientImage& image) {
  PixelLayout layout;
  return find_pixel_layout(context, command, format, type, layout) && check_size(context, command, size) &&
         locate_pack(context, command, size, layout, pointer, image);
}

bool check_unpack_array(Context& context, const char* command, std::size_t count, std::size_t element_bytes,
                        const void* pointer, const std::byte*& address) {
  auto at = reinterpret_cast<std::uintptr_t>(pointer);
  if (!check_array(context, command, count, element_bytes, context.state.unpack_buffer, at)) return false;
  address = reinterpret_cast<const std::byte*>(at);
  return true;
}

bool check_pack_array(Context& context, const char* command, std::size_t count, std::size_t element_bytes, void* pointer,
                      std::byte*& address) {
  auto at = reinterpret_cast<std::uintptr_t>(pointer);
  if (!check_array(context, command, count, element_bytes, context.state.pack_buffer, at)) return false;
  address = reinterpret_cast<std::byte*>(at);
  return true;
}

}  // namespace gouraud::api
