// Images of commands in display lists: taken from client memory or from a pixel buffer when the command is compiled
// [GL1.5 §5.4], and kept without the gaps that the pixel store may ask for.
#pragma once

#include "api/context/context.h"
#include "records.h"

namespace gouraud::api {

/// How a list holds a command's memory.
struct KeptImage {
  const void* memory = nullptr;  ///< null: the command will find no image
  PixelStore store{};            ///< how it lies there
  bool compiled = true;          ///< false: an error was recorded, and the command is not put into the list
};

/// Whether a command of this opcode reads memory through the pixel store or the pixel unpack buffer.
bool reads_pixels(records::Opcode opcode);

/// Copies what the command reads into the list. Throws std::bad_alloc. Arguments that the command will refuse when it is
/// executed give no memory.
KeptImage keep_image(Context& context, DisplayList& list, records::Opcode opcode, const void* record);

}  // namespace gouraud::api
