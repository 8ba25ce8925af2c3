// Names of GL enums, for traces and error messages.
#pragma once

#include <GL/gl.h>

#include <cstddef>

#include "enum_groups.h"

namespace gouraud::api {

/// The name of an enum, for example "GL_TRIANGLES". Several names share many values: `group` (gl.xml's word for what a
/// parameter accepts) decides, then GL 1.5 before older versions before extensions. An unknown value gives its
/// hexadecimal digits, in a buffer that the thread's next such call overwrites.
const char* enum_name(GLenum value, EnumGroup group = EnumGroup::none);

/// The name that `group` itself has for a value or bit, or null.
const char* name_in_group(GLenum value, EnumGroup group);

struct EnumName {
  GLenum value;
  EnumGroup group;
  const char* name;
};

// Generated, sorted by (group, value); group none holds the preferred name of every value.
extern const EnumName enum_names[];
extern const std::size_t enum_name_count;

}  // namespace gouraud::api
