#include "api/commands/list_images.h"

#include <cstring>
#include <new>
#include <optional>

#include "api/commands/client_pixels.h"

namespace gouraud::api {
namespace {

using records::Opcode;

/// What a command says about its image.
struct ImageArguments {
  ImageSize size;
  GLenum format = 0, type = 0;
  const void* pixels = nullptr;
};

template <class Record>
const Record& as(const void* record) {
  return *static_cast<const Record*>(record);
}

std::optional<ImageArguments> image_of(Opcode opcode, const void* record) {
  switch (opcode) {
    case Opcode::DrawPixels: {
      const auto& r = as<records::DrawPixels>(record);
      return ImageArguments{{r.width, r.height}, r.format, r.type, r.pixels};
    }
    case Opcode::Bitmap: {
      const auto& r = as<records::Bitmap>(record);
      return ImageArguments{{r.width, r.height}, GL_COLOR_INDEX, GL_BITMAP, r.bitmap};
    }
    case Opcode::PolygonStipple:
      return ImageArguments{{32, 32}, GL_COLOR_INDEX, GL_BITMAP, as<records::PolygonStipple>(record).mask};
    case Opcode::TexImage1D: {
      const auto& r = as<records::TexImage1D>(record);
      return ImageArguments{{r.width}, r.format, r.type, r.pixels};
    }
    case Opcode::TexImage2D: {
      const auto& r = as<records::TexImage2D>(record);
      return ImageArguments{{r.width, r.height}, r.format, r.type, r.pixels};
    }
    case Opcode::TexImage3D: {
      const auto& r = as<records::TexImage3D>(record);
      return ImageArguments{{r.width, r.height, r.depth, true}, r.format, r.type, r.pixels};
    }
    case Opcode::TexSubImage1D: {
      const auto& r = as<records::TexSubImage1D>(record);
      return ImageArguments{{r.width}, r.format, r.type, r.pixels};
    }
    case Opcode::TexSubImage2D: {
      const auto& r = as<records::TexSubImage2D>(record);
      return ImageArguments{{r.width, r.height}, r.format, r.type, r.pixels};
    }
    case Opcode::TexSubImage3D: {
      const auto& r = as<records::TexSubImage3D>(record);
      return ImageArguments{{r.width, r.height, r.depth, true}, r.format, r.type, r.pixels};
    }
    default: return std::nullopt;
  }
}

/// Values side by side, without a pixel store.
struct ArrayArguments {
  GLsizei bytes = 0, element_bytes = 1;
  const void* values = nullptr;
};

std::optional<ArrayArguments> array_of(Opcode opcode, const void* record) {
  const auto map = [](const auto& r, GLsizei element_bytes) {
    return ArrayArguments{r.mapsize >= 1 && r.mapsize <= max_pixel_map_table ? r.mapsize * element_bytes : 0, element_bytes, r.values};
  };
  const auto compressed = [](const auto& r) { return ArrayArguments{r.imageSize > 0 ? r.imageSize : 0, 1, r.data}; };
  switch (opcode) {
    case Opcode::CompressedTexImage1D: return compressed(as<records::CompressedTexImage1D>(record));
    case Opcode::CompressedTexImage2D: return compressed(as<records::CompressedTexImage2D>(record));
    case Opcode::CompressedTexImage3D: return compressed(as<records::CompressedTexImage3D>(record));
    case Opcode::CompressedTexSubImage1D: return compressed(as<records::CompressedTexSubImage1D>(record));
    case Opcode::CompressedTexSubImage2D: return compressed(as<records::CompressedTexSubImage2D>(record));
    case Opcode::CompressedTexSubImage3D: return compressed(as<records::CompressedTexSubImage3D>(record));
    case Opcode::PixelMapfv: return map(as<records::PixelMapfv>(record), 4);
    case Opcode::PixelMapuiv: return map(as<records::PixelMapuiv>(record), 4);
    case Opcode::PixelMapusv: return map(as<records::PixelMapusv>(record), 2);
    default: return std::nullopt;
  }
}

std::size_t product(std::size_t a, std::size_t b) {
  std::size_t result;
  if (__builtin_mul_overflow(a, b, &result)) throw std::bad_alloc();
  return result;
}

/// Rows one after the other, from whole bytes on.
KeptImage copy_rows(DisplayList& list, const ClientImage& image) {
  const ImageSize& size = image.size;
  const std::size_t row_bytes = image.row_bytes();
  const std::size_t rows = product(static_cast<std::size_t>(size.height), static_cast<std::size_t>(size.depth));
  std::byte* out = list.allocate(product(row_bytes, rows));
  KeptImage kept;
  kept.memory = out;
  kept.store.swap_bytes = image.swap_bytes;
  kept.store.lsb_first = image.lsb_first;
  kept.store.alignment = 1;
  kept.store.skip_pixels = image.first_bit;
  if (image.first_bit != 0) kept.store.row_length_px = size.width + image.first_bit;
  for (GLsizei z = 0; z < size.depth; ++z) {
    for (GLsizei y = 0; y < size.height; ++y, out += row_bytes) std::memcpy(out, image.row(y, z), row_bytes);
  }
  return kept;
}

KeptImage keep(Context& context, DisplayList& list, const ImageArguments& arguments) {
  const ImageSize& size = arguments.size;
  PixelLayout layout;
  if (!has_pixel_layout(arguments.format, arguments.type, layout) || size.width <= 0 || size.height <= 0 || size.depth <= 0) {
    return {};
  }
  ClientImage image;
  if (!locate_unpack(context, "glNewList", size, layout, arguments.pixels, image)) return {nullptr, {}, false};
  return image.null() ? KeptImage{} : copy_rows(list, image);
}

KeptImage keep(Context& context, DisplayList& list, const ArrayArguments& arguments) {
  const std::byte* values = nullptr;
  const auto bytes = static_cast<std::size_t>(arguments.bytes), element = static_cast<std::size_t>(arguments.element_bytes);
  if (!check_unpack_array(context, "glNewList", bytes / element, element, arguments.values, values)) return {nullptr, {}, false};
  if (values == nullptr || bytes == 0) return {};
  return {list.keep(values, bytes), {}, true};
}

}  // namespace

bool reads_pixels(Opcode opcode) {
  switch (opcode) {
    case Opcode::DrawPixels:
    case Opcode::Bitmap:
    case Opcode::PolygonStipple:
    case Opcode::TexImage1D:
    case Opcode::TexImage2D:
    case Opcode::TexImage3D:
    case Opcode::TexSubImage1D:
    case Opcode::TexSubImage2D:
    case Opcode::TexSubImage3D:
    case Opcode::CompressedTexImage1D:
    case Opcode::CompressedTexImage2D:
    case Opcode::CompressedTexImage3D:
    case Opcode::CompressedTexSubImage1D:
    case Opcode::CompressedTexSubImage2D:
    case Opcode::CompressedTexSubImage3D:
    case Opcode::PixelMapfv:
    case Opcode::PixelMapuiv:
    case Opcode::PixelMapusv: return true;
    default: return false;
  }
}

KeptImage keep_image(Context& context, DisplayList& list, Opcode opcode, const void* record) {
  if (const auto image = image_of(opcode, record)) return keep(context, list, *image);
  if (const auto array = array_of(opcode, record)) return keep(context, list, *array);
  return {};
}

}  // namespace gouraud::api
