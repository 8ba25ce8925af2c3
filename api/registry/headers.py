"""Writes GL/gl.h, GL/glext.h and the conformance suite's tables of function pointers and of commands."""

import families

PRELUDE = """\
#ifndef __gl_h_
#define __gl_h_

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifndef GLAPI
#if defined(__GNUC__)
#define GLAPI extern __attribute__((visibility("default")))
#else
#define GLAPI extern
#endif
#endif
#ifndef GLAPIENTRY
#define GLAPIENTRY
#endif
#ifndef GLAPIENTRYP
#define GLAPIENTRYP GLAPIENTRY *
#endif
#ifndef APIENTRY
#define APIENTRY GLAPIENTRY
#endif
#ifndef APIENTRYP
#define APIENTRYP APIENTRY *
#endif

typedef unsigned int GLenum;
typedef unsigned char GLboolean;
typedef unsigned int GLbitfield;
typedef void GLvoid;
typedef signed char GLbyte;
typedef unsigned char GLubyte;
typedef short GLshort;
typedef unsigned short GLushort;
typedef int GLint;
typedef unsigned int GLuint;
typedef int GLsizei;
typedef float GLfloat;
typedef float GLclampf;
typedef double GLdouble;
typedef double GLclampd;
typedef ptrdiff_t GLintptr;
typedef ptrdiff_t GLsizeiptr;
typedef int64_t GLint64;
"""

# Types that only extensions use, with the extension that brings them.
EXTENSION_TYPES = {"GL_ARB_vertex_buffer_object": "typedef ptrdiff_t GLintptrARB;\ntypedef ptrdiff_t GLsizeiptrARB;\n"}

POSTLUDE = """\
#ifdef __cplusplus
}
#endif

#include <GL/glext.h>

#endif
"""


def gl_h(registry):
    text = ["/* OpenGL 1.0-1.5 with extensions, written by api/registry/generate.py from gl.xml. */\n", PRELUDE]
    for section in registry.sections:
        text.append(f"\n#ifndef {section.name}\n#define {section.name} 1\n")
        text.append(EXTENSION_TYPES.get(section.name, ""))
        text += [f"#define {name} {_literal(registry.enums[name].value)}\n" for name in section.enums]
        for name in section.commands:
            command = registry.signatures[name]
            text.append(f"GLAPI {_spaced(command.returns)}GLAPIENTRY gl{name}({command.parameters()});\n")
        text.append("#endif\n")
    return "".join(text) + "\n" + POSTLUDE


def glext_h(registry):
    """The PFNGL...PROC types of everything since GL 1.2."""
    text = ["/* Types of pointers to GL functions, written by api/registry/generate.py from gl.xml. */\n"
            "#ifndef __gl_glext_h_\n#define __gl_glext_h_\n\n#include <GL/gl.h>\n\n"
            "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n"]
    for section in registry.sections:
        if section.name not in ("GL_VERSION_1_0", "GL_VERSION_1_1"):
            for name in section.commands:
                command = registry.signatures[name]
                pointer = f"(APIENTRYP PFNGL{name.upper()}PROC)"
                text.append(f"typedef {_spaced(command.returns)}{pointer}({command.parameters()});\n")
    return "".join(text) + "\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n"


def extension_names_h(registry):
    names = [section.name for section in registry.sections
             if section.advertised and not section.name.startswith("GL_VERSION")]
    rows = "".join(f'    "{name}",\n' for name in names)
    return ("// Written by api/registry/generate.py from extensions.txt.\n#pragma once\n\nnamespace gouraud::api {\n\n"
            "/// The value of GL_EXTENSIONS [GL1.5 §6.1.11], whole and one by one.\n"
            f'inline constexpr const char* extension_names = "{" ".join(names)}";\n'
            f"inline constexpr const char* extension_list[] = {{\n{rows}}};\n"
            f"inline constexpr unsigned extension_count = {len(names)};\n\n}}  // namespace gouraud::api\n")


def gl_table_h(registry):
    core = "".join(_member(command.name, command) for command in registry.core)
    extensions = "".join(_member(name, command) for name, command in registry.signatures.items()
                         if name not in {command.name for command in registry.core})
    return f"""\
// The GL as a table of function pointers: what a conformance scene calls, whichever library is behind it.
// Written by api/registry/generate.py from gl.xml.
#pragma once

#include <GL/gl.h>

namespace gouraud {{

/// Members bear the command's name without its prefix: `gl.Begin(GL_TRIANGLES)`.
struct GlTable {{
{core}
  // Of the extensions; null where the library has none.
{extensions}}};

/// Fills `table` from `get_proc_address` ("glBegin" -> function, null if unknown). True if it found all the
/// {len(registry.core)} commands of GL 1.0-1.5; what it did not find is null.
bool load(GlTable& table, void* (*get_proc_address)(const char*));

}}  // namespace gouraud
"""


def gl_table_cpp(registry):
    names = [command.name for command in registry.core]
    names += [name for name in registry.signatures if name not in set(names)]
    rows = "".join(f'    {{"gl{name}", offsetof(GlTable, {name})}},\n' for name in names)
    return f"""\
#include "gl_table.h"

#include <cstddef>
#include <cstring>

namespace gouraud {{
namespace {{

struct Row {{
  const char* name;
  std::size_t offset;
}};

constexpr std::size_t core_commands = {len(registry.core)};
constexpr Row rows[] = {{
{rows}}};

}}  // namespace

bool load(GlTable& table, void* (*get_proc_address)(const char*)) {{
  bool complete = true;
  for (std::size_t i = 0; i < sizeof(rows) / sizeof(rows[0]); ++i) {{
    void* const function = get_proc_address(rows[i].name);
    std::memcpy(reinterpret_cast<char*>(&table) + rows[i].offset, &function, sizeof(function));
    complete = complete && (function != nullptr || i >= core_commands);
  }}
  return complete;
}}

}}  // namespace gouraud
"""


# What a parameter of a command takes, as one letter; the C++ types below these names are not told apart.
_KINDS = {"GLenum": "e", "GLbitfield": "m", "GLboolean": "b", "GLuint": "u", "GLint": "i", "GLsizei": "s", "GLfloat": "f",
          "GLclampf": "f", "GLdouble": "d", "GLclampd": "d", "GLintptr": "n", "GLsizeiptr": "n"}


def kinds(command):
    """The kinds of a command's parameters: "ee" of BlendFunc. What has no letter of its own is a small integer, "i"."""
    return "".join("p" if param.is_pointer else _KINDS.get(param.type, "i") for param in command.params)


GL_COMMANDS_H = """\
// Every command of the GL as a row that can be called with arguments found at run time: what tests go through.
// Written by api/registry/generate.py from gl.xml.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>

#include "gl_table.h"

namespace gouraud {

/// An argument: its number, or its pointer where the parameter is one.
struct CommandArgument {
  double number = 0;
  void* pointer = nullptr;

  CommandArgument() = default;
  CommandArgument(double value) : number(value) {}
  CommandArgument(void* address) : pointer(address) {}

  /// As the parameter's type: the nearest value of it; integers beyond it keep their low bits, as in C.
  template <class T>
  T as() const {
    using Limits = std::numeric_limits<T>;
    if constexpr (std::is_pointer_v<T>) {
      return static_cast<T>(pointer);
    } else if constexpr (std::is_floating_point_v<T>) {
      const bool beyond = std::isfinite(number) && std::abs(number) > static_cast<double>(Limits::max());
      return beyond ? static_cast<T>(std::copysign(Limits::max(), number)) : static_cast<T>(number);
    } else {
      if (!(std::abs(number) < 9.2e18)) return number > 0 ? Limits::max() : Limits::min();
      return static_cast<T>(static_cast<std::int64_t>(number));
    }
  }
};

struct CommandRow {
  const char* name;  // without the prefix gl
  /// A letter a parameter: e enum, m bits, b boolean, u, i and s (size) integers, n offset or size of a buffer, f float,
  /// d double, p pointer.
  const char* parameters;
  /// A word a parameter: its name; gl.xml's group of the enums that it takes, "none" where there is no such.
  const char *names, *groups;
  bool core;                    // of GL 1.0-1.5
  bool legal_inside_begin_end;  // [GL1.5 §2.6.3]
  void (*call)(const GlTable& gl, const CommandArgument* arguments);
};

/// All of them, aliases as well.
std::span<const CommandRow> command_rows();

struct EnumRow {
  const char* name;    // with the prefix GL_
  const char* groups;  // a word each
  std::uint32_t value;
};

/// Every enum of the header; several may have one value.
std::span<const EnumRow> enum_rows();

}  // namespace gouraud
"""


def gl_commands_cpp(registry):
    core = {command.name for command in registry.core}
    primary = {alias: command.name for command in registry.commands.values() for alias in command.aliases}
    rows = "".join(_command_row(name, command, name in core, primary.get(name, name))
                   for name, command in registry.signatures.items())
    enums = "".join(f'    {{"{enum.name}", "{" ".join(sorted(enum.groups))}", 0x{enum.value:04X}}},\n'
                    for enum in registry.enums.values())
    return f"""\
// Written by api/registry/generate.py from gl.xml.
#include "gl_commands.h"

namespace gouraud {{
namespace {{

using Arguments = const CommandArgument*;

const CommandRow rows[] = {{
{rows}}};

const EnumRow enums[] = {{
{enums}}};

}}  // namespace

std::span<const CommandRow> command_rows() {{
  return rows;
}}

std::span<const EnumRow> enum_rows() {{
  return enums;
}}

}}  // namespace gouraud
"""


def _command_row(name, command, core, primary):
    values = ", ".join(f"a[{i}].as<{param.type}>()" for i, param in enumerate(command.params))
    legal = families.legal_inside_begin_end(primary)
    argument = " a" if command.params else ""
    names = " ".join(command.param_names)
    groups = " ".join(param.group or "none" for param in command.params)
    return (f'    {{"{name}", "{kinds(command)}", "{names}", "{groups}", {_boolean(core)}, {_boolean(legal)},\n'
            f"     [](const GlTable& gl, Arguments{argument}) {{ gl.{name}({values}); }}}},\n")


def _boolean(value):
    return "true" if value else "false"


def _member(name, command):
    return f"  {_spaced(command.returns)}(APIENTRYP {name})({command.parameters()}) = nullptr;\n"


def _spaced(returns):
    return returns if returns.endswith("*") else returns + " "


def _literal(value):
    return f"0x{value:04X}" if value > 1 else str(value)
