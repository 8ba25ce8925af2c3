"""Writes the recording structs of display lists: one for each command that a list can hold [GL1.5 §5.4]."""

import families
import handlers as handlers_module

NOTE = "// Written by api/registry/generate.py.\n"

# How much client memory a pointer leads to, where gl.xml only says that it must be computed.
LENGTHS = {
    "Bitmap": "bitmap", "PolygonStipple": "polygon_stipple", "CallLists": "list_names",
    "DrawPixels": "image", "TexImage1D": "image", "TexImage2D": "image", "TexImage3D": "image",
    "TexSubImage1D": "image", "TexSubImage2D": "image", "TexSubImage3D": "image",
    "Map1f": "map_points", "Map1d": "map_points", "Map2f": "map_points", "Map2d": "map_points",
    "DrawElements": "indices", "DrawRangeElements": "indices",
}

# The commands whose records vertex_value() understands: canonical command -> what it gives.
VERTEX_VALUES = {"Vertex4f": "position", "Normal3f": "normal", "Color4f": "color", "SecondaryColor3f": "secondary_color",
                 "FogCoordf": "fog_coordinate", "TexCoord4f": "texture_coordinates", "MultiTexCoord4f": "texture_coordinates"}

RECORDS_H = """\
#pragma once

#include <GL/gl.h>

#include <cstddef>
#include <cstdint>

namespace gouraud::api {{

class Context;

namespace records {{

enum class Opcode : std::uint16_t {{
{opcodes}}};
constexpr std::size_t opcode_count = {count};

{structs}
/// How to find the extent of client memory that a record points to.
enum class Length : std::uint8_t {{
  elements,         // as many as the GLsizei at count_offset says
  image,            // a pixel rectangle: format, type and size of the record, through the pixel store
  bitmap,           // likewise, of one bit a pixel
  polygon_stipple,  // likewise, 32x32
  list_names,       // n names of the record's type
  map_points,       // control points of the record's target, strides and orders
  indices,          // count indices of the record's type, unless a buffer object holds them
}};

/// A pointer in a record that still leads to the application's memory.
struct ClientMemory {{
  Opcode opcode;
  Length length;
  std::uint16_t pointer_offset;  // bytes from the record's start
  std::uint16_t count_offset;    // of Length::elements
  std::uint16_t element_bytes;   // 0: the record's type says
}};

// Sorted by opcode.
extern const ClientMemory client_memory[];
extern const std::size_t client_memory_count;

struct RecordInfo {{
  const char* command;
  std::size_t bytes;
}};

extern const RecordInfo record_infos[opcode_count];

/// A vertex, or a current value that the next vertices take, in the canonical form of its family.
struct VertexValue {{
  enum class Kind : std::uint8_t {{ none, position, normal, color, secondary_color, fog_coordinate, texture_coordinates }};
  Kind kind = Kind::none;
  GLfloat components[4] = {{}};
  GLenum texture = GL_TEXTURE0;  // of texture_coordinates: as given, it may name no unit
}};

/// What a record of glVertex, glNormal, glColor, glSecondaryColor, glFogCoord, glTexCoord or glMultiTexCoord of any type
/// gives; none for other commands.
VertexValue vertex_value(Opcode opcode, const void* record);

/// Carries out one record, errors included, just as if the command were called now.
void execute(Context& context, Opcode opcode, const void* record);

}}  // namespace records

/// The display-list compiler's part: puts a copy of `record` into the open list, client memory included. True if the
/// command shall also be executed now (GL_COMPILE_AND_EXECUTE, or what §5.4 never puts into a list: proxy textures).
/// Where memory runs out, glEndList says so [GL1.5 §5.4].
bool append_record(Context& context, records::Opcode opcode, const void* record, std::size_t bytes) noexcept;

}}  // namespace gouraud::api
"""


def recorded(registry):
    return [command for command in registry.commands.values() if families.recordable(command.name)]


def _inline_values(command, param):
    """How many values of a pointer's target the record itself holds; None if it keeps the pointer."""
    if families.parameter_family_of(command.name):
        return 4
    return int(param.length) if param.length and param.length.isdigit() else None


def append_lines(command):
    lines = [f"records::{command.name} record{{}};"]
    for param in command.params:
        if not param.is_pointer or _inline_values(command, param) is None:
            lines.append(f"record.{param.name} = {param.name};")
        else:
            family = families.parameter_family_of(command.name)
            values = f"{handlers_module.shape_function(family)}(pname).values" if family else param.length
            lines.append(f"std::copy_n({param.name}, {values}, record.{param.name});")
    opcode = f"records::Opcode::{command.name}"
    return lines + [f"if (!append_record(*context, {opcode}, &record, sizeof(record))) return;"]


def records_h(registry):
    commands = recorded(registry)
    opcodes = "".join(f"  {command.name},\n" for command in commands)
    structs = "".join(_struct(command) for command in commands)
    return NOTE + RECORDS_H.format(opcodes=opcodes, count=len(commands), structs=structs)


def _struct(command):
    fields = []
    for param in command.params:
        count = _inline_values(command, param) if param.is_pointer else None
        fields.append(f"  {param.declare()};\n" if count is None else f"  {param.element} {param.name}[{count}];\n")
    return f"struct {command.name} {{\n{''.join(fields)}}};\n"


def records_cpp(registry):
    commands = recorded(registry)
    infos = "".join(f'    {{"gl{command.name}", sizeof({command.name})}},\n' for command in commands)
    memory = "".join(_memory_row(command, param) for command in commands for param in command.params
                     if param.is_pointer and _inline_values(command, param) is None)
    cases = "".join(_execute_case(command) for command in commands)
    values = "".join(_vertex_value_case(command) for command in commands)
    return f"""{NOTE}\
#include "records.h"

#include "checked.h"

namespace gouraud::api::records {{

const RecordInfo record_infos[opcode_count] = {{
{infos}}};

const ClientMemory client_memory[] = {{
{memory}}};
const std::size_t client_memory_count = sizeof(client_memory) / sizeof(client_memory[0]);

VertexValue vertex_value(Opcode opcode, const void* record) {{
  switch (opcode) {{
{values}    default:
      return {{}};
  }}
}}

void execute(Context& context, Opcode opcode, const void* record) {{
  switch (opcode) {{
{cases}  }}
}}

}}  // namespace gouraud::api::records
"""


def _memory_row(command, param):
    pointer = f"offsetof({command.name}, {param.name})"
    if param.length in command.param_names:
        size = "1" if param.element == "void" else f"sizeof({param.type.removesuffix('*').strip()})"
        return (f"    {{Opcode::{command.name}, Length::elements, {pointer}, "
                f"offsetof({command.name}, {param.length}), {size}}},\n")
    size = "0" if param.element == "void" else f"sizeof({param.element})"
    return f"    {{Opcode::{command.name}, Length::{LENGTHS[command.name]}, {pointer}, 0, {size}}},\n"


def _execute_case(command):
    if not command.params:
        return f"    case Opcode::{command.name}:\n      return checked::{command.name}(context);\n"
    arguments = ", ".join(["context"] + [f"r.{name}" for name in command.param_names])
    return (f"    case Opcode::{command.name}: {{\n      const auto& r = *static_cast<const {command.name}*>(record);\n"
            f"      return checked::{command.name}({arguments});\n    }}\n")


def _vertex_value_case(command):
    family = families.family_of(command.name)
    if family is None or family.canonical not in VERTEX_VALUES:
        return ""
    values = ", ".join(handlers_module.family_values(command, family, prefix="r."))
    texture = f", r.{command.params[0].name}" if family.leading else ""
    return (f"    case Opcode::{command.name}: {{\n      const auto& r = *static_cast<const {command.name}*>(record);\n"
            f"      return {{VertexValue::Kind::{VERTEX_VALUES[family.canonical]}, {{{values}}}{texture}}};\n    }}\n")
