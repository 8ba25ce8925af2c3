"""Writes the names of enums, by the group of the parameter that takes them."""

NOTE = "// Written by api/registry/generate.py from gl.xml.\n"


def used_groups(registry):
    params = [param for command in registry.commands.values() for param in command.params]
    groups = {param.group for param in params if param.type in ("GLenum", "GLbitfield")}
    return ["none"] + sorted((groups | {"InternalFormat", "ErrorCode"}) - {None})


def enum_groups_h(registry):
    rows = "".join(f"  {group},\n" for group in used_groups(registry))
    return f"""{NOTE}\
#pragma once

#include <cstdint>

namespace gouraud::api {{

/// What a parameter accepts, as gl.xml calls it.
enum class EnumGroup : std::uint8_t {{
{rows}}};

}}  // namespace gouraud::api
"""


def enum_table_cpp(registry):
    order = {section.name: i for i, section in enumerate(registry.sections)}
    by_value = {}
    for enum in registry.enums.values():
        by_value.setdefault(enum.value, []).append(enum)

    def rank(enum):
        is_bit = enum.name.endswith(("_BIT", "_BITS"))
        core = enum.source.startswith("GL_VERSION")
        return is_bit, not core, -order[enum.source] if core else order[enum.source], len(enum.name)

    rows = [("none", value, min(enums, key=rank).name) for value, enums in by_value.items()]
    for group in used_groups(registry)[1:]:
        for value, enums in by_value.items():
            members = [enum for enum in enums if group in enum.groups]
            if members:
                rows.append((group, value, min(members, key=rank).name))
    index = {group: i for i, group in enumerate(used_groups(registry))}
    rows.sort(key=lambda row: (index[row[0]], row[1]))
    text = "".join(f'    {{0x{value:04X}, EnumGroup::{group}, "{name}"}},\n' for group, value, name in rows)
    return f"""{NOTE}\
#include "api/registry/enum_names.h"

namespace gouraud::api {{

const EnumName enum_names[] = {{
{text}}};
const std::size_t enum_name_count = sizeof(enum_names) / sizeof(enum_names[0]);

}}  // namespace gouraud::api
"""
