#!/usr/bin/env python3
"""Writes what is mechanical about the GL from the Khronos gl.xml; see CMakeLists.txt for who uses what."""

import argparse
from pathlib import Path

import headers
import registry as registry_module


def write_if_changed(path, text):
    """Leaves a file that is already right untouched, so that nothing is compiled again."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def generated_files(registry):
    return {
        "include/GL/gl.h": headers.gl_h(registry),
        "include/GL/glext.h": headers.glext_h(registry),
        "include/gl_table.h": headers.gl_table_h(registry),
        "gl_table.cpp": headers.gl_table_cpp(registry),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--xml", required=True, type=Path, help="the Khronos gl.xml")
    parser.add_argument("--out", required=True, type=Path, help="folder to write into")
    parser.add_argument("--extensions", type=Path, default=Path(__file__).with_name("extensions.txt"))
    arguments = parser.parse_args()

    extensions = registry_module.read_extension_list(arguments.extensions)
    registry = registry_module.read_registry(arguments.xml, extensions)
    for name, text in generated_files(registry).items():
        write_if_changed(arguments.out / name, text)
    (arguments.out / "stamp").touch()


if __name__ == "__main__":
    main()
