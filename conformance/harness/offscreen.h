// A GL context behind the OSMesa ABI, whichever library is behind that: made, made current, read back.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "conformance/harness/picture.h"
#include "gl_table.h"

namespace gouraud::conformance {

/// The functions of the OSMesa ABI that the suite calls.
struct OsmesaFunctions {
  void* (*CreateContextExt)(GLenum format, GLint depth_bits, GLint stencil_bits, GLint accum_bits, void* share);
  void (*DestroyContext)(void* context);
  GLboolean (*MakeCurrent)(void* context, void* buffer, GLenum type, GLsizei width_px, GLsizei height_px);
  GLboolean (*GetDepthBuffer)(void* context, GLint* width_px, GLint* height_px, GLint* bytes_per_value, void** buffer);
  void* (*GetProcAddress)(const char* name);
};

/// Opens a libOSMesa with dlopen, apart from all other symbols of the process; throws std::runtime_error.
OsmesaFunctions load_osmesa(const std::string& library);

/// A current RGBA8 context and the memory it renders to. Throws std::runtime_error if the library refuses.
class OffscreenContext {
 public:
  /// `depth_bits` 0, 16 or 24; with 24 there are 8 bits of stencil as well (with 16 Mesa would give 24). There is
  /// an accumulation buffer.
  OffscreenContext(const OsmesaFunctions& osmesa, int width_px, int height_px, int depth_bits);
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  const GlTable& gl() const { return gl_; }

  /// Finishes, and copies colour and stored depth (size, rgba, depth, depth_bits) from the memory that OSMesa hands out:
  /// no GL state that a scene may have left behind changes that. Where a method of ours stores depths otherwise, they are
  /// in the units of the depth_bits that were asked for.
  Picture read();

  /// Pixels in which glReadPixels disagrees with `picture`, just read. The GL's pixel state must be initial.
  std::uint64_t count_read_differences(const Picture& picture);

  /// All errors since the last call.
  std::vector<std::uint32_t> take_errors();

 private:
  const OsmesaFunctions& osmesa_;
  void* context_;
  std::string methods_in_use() const;

  int width_px_, height_px_, depth_bits_;
  std::vector<std::uint8_t> color_;
  GlTable gl_;
};

}  // namespace gouraud::conformance
