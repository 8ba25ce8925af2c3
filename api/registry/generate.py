#!/usr/bin/env python3
"""Writes what is mechanical about the GL from the Khronos gl.xml; see CMakeLists.txt for who uses what."""

import argparse
from pathlib import Path

import entries
import enum_tables
import handlers as handlers_module
import headers
import records
import registry as registry_module
import support

SOURCE_PARTS = 3  # entry_*.cpp and watched_*.cpp each, so that they compile side by side


def write_if_changed(path, text):
    """Leaves a file that is already right untouched, so that nothing is compiled again."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def generated_files(registry, handlers):
    files = {
        "include/GL/gl.h": headers.gl_h(registry),
        "include/GL/glext.h": headers.glext_h(registry),
        "table/gl_table.h": headers.gl_table_h(registry),
        "table/gl_table.cpp": headers.gl_table_cpp(registry),
        "table/gl_commands.h": headers.GL_COMMANDS_H,
        "table/gl_commands.cpp": headers.gl_commands_cpp(registry),
        "entries/enum_groups.h": enum_tables.enum_groups_h(registry),
        "entries/enum_table.cpp": enum_tables.enum_table_cpp(registry),
        "entries/extension_names.h": headers.extension_names_h(registry),
        "entries/parameter_shapes.h": entries.parameter_shapes_h(),
        "entries/checked.h": entries.checked_h(registry, handlers),
        "entries/watched.h": entries.watched_h(registry),
        "entries/proc_table.cpp": entries.proc_table_cpp(registry),
        "entries/records.h": records.records_h(registry),
        "entries/records.cpp": records.records_cpp(registry),
        "support.md": support.markdown(registry, handlers),
    }
    commands = list(registry.commands.values())
    for part in range(SOURCE_PARTS):
        files[f"entries/entry_{part}.cpp"] = entries.entry_cpp(registry, commands[part::SOURCE_PARTS])
        files[f"entries/watched_{part}.cpp"] = entries.watched_cpp(commands[part::SOURCE_PARTS], handlers)
    return files


def main():
    here = Path(__file__).resolve().parent
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--xml", required=True, type=Path, help="the Khronos gl.xml")
    parser.add_argument("--out", type=Path, help="folder to write into")
    parser.add_argument("--readme", type=Path, help="file whose support table to bring up to date")
    parser.add_argument("--extensions", type=Path, default=here / "extensions.txt")
    parser.add_argument("--commands", type=Path, default=here.parent / "commands", help="folder of handlers' headers")
    arguments = parser.parse_args()

    extensions = registry_module.read_extension_list(arguments.extensions)
    registry = registry_module.read_registry(arguments.xml, extensions)
    handlers = handlers_module.find_handlers(arguments.commands, registry.commands)
    if arguments.out:
        for name, text in generated_files(registry, handlers).items():
            write_if_changed(arguments.out / name, text)
        (arguments.out / "stamp").touch()
    if arguments.readme:
        support.update(arguments.readme, support.markdown(registry, handlers))


if __name__ == "__main__":
    main()
