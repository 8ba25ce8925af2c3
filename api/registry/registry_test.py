#!/usr/bin/env python3
"""The sets of commands against the specification's figures, and the header against C and C++ compilers."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import entries
import families
import generate
import handlers
import headers
import records
import registry as registry_module
import support

HERE = Path(__file__).resolve().parent
XML = os.environ.get("GOURAUD_GL_XML", "/usr/share/khronos-api/gl.xml")
EXTENSIONS = registry_module.read_extension_list(HERE / "extensions.txt")
REGISTRY = registry_module.read_registry(XML, EXTENSIONS)
CORE = [command.name for command in REGISTRY.core]


class Figures(unittest.TestCase):
    """The figures of GL 1.0-1.5."""

    def test_commands(self):
        self.assertEqual(len(CORE), 452)
        versions = [len(section.commands) for section in REGISTRY.sections if section.name.startswith("GL_VERSION")]
        self.assertEqual(versions, [306, 30, 4, 46, 47, 19])

    def test_typed_variants(self):
        variants = [name for name in CORE if families.family_of(name)]
        self.assertEqual(len(variants), 220)
        self.assertEqual(len({families.family_of(name).name for name in variants}), 14)

    def test_legal_inside_begin_end(self):
        inside = {name for name in CORE if families.legal_inside_begin_end(name)}
        self.assertEqual(len(inside), 179)
        self.assertFalse(inside & {"Begin", "End", "VertexPointer", "GetError", "ColorMask", "EvalMesh1", "Fogf"})

    def test_recordable(self):
        recorded = {name for name in CORE if families.recordable(name)}
        self.assertEqual(len(recorded), 373)
        self.assertFalse(recorded & {"GetFloatv", "IsEnabled", "NewList", "EndList", "Flush", "PixelStorei"})
        self.assertTrue(all(REGISTRY.commands[name].returns == "void" for name in recorded))

    def test_every_command_has_a_section(self):
        self.assertTrue(all(support.section_of(name) is not None for name in CORE))


class Variants(unittest.TestCase):
    def setUp(self):
        self.found = handlers.find_handlers(HERE / "testing/api/commands", REGISTRY.commands)

    def test_each_gives_all_arguments_of_its_canonical_command(self):
        for name in CORE:
            family = families.family_of(name)
            if family and name not in self.found:
                call = handlers.statements(REGISTRY.commands[name], self.found)[0]
                given = len(re.fullmatch(r"api::\w+\(context, (.*)\);", call).group(1).split(", "))
                self.assertEqual(given, len(REGISTRY.commands[family.canonical].params), name)

    def test_without_a_canonical_handler_a_family_is_unwritten(self):
        del self.found["Color4f"]
        self.assertIsNone(handlers.statements(REGISTRY.commands["Color3ub"], self.found))

    def test_a_handler_of_its_own_comes_first(self):
        self.found["Vertex3f"] = "x.h"
        call = handlers.statements(REGISTRY.commands["Vertex3f"], self.found)
        self.assertEqual(call, ["api::Vertex3f(context, x, y, z);"])

    def test_parameters_exist(self):
        for family in families.PARAMETER_FAMILIES:
            for name in [*family.colors.split(), *family.vectors, *family.scalars.split(), *family.enums.split()]:
                self.assertIn("GL_" + name, REGISTRY.enums)


class Handlers(unittest.TestCase):
    def test_comments_and_other_functions_are_no_handlers(self):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "a.h").write_text(
                "// void Clear(Context& context);\n/* void Flush(Context& c); */\nvoid helper(Context& context);\n"
                "void DepthFunc(\n    Context& context, GLenum func);\ninline GLenum GetError(api::Context& c) {}\n"
                "void Enable(State& state, GLenum cap);\n")
            self.assertEqual(handlers.find_handlers(folder, REGISTRY.commands), {"DepthFunc": "a.h", "GetError": "a.h"})


class Aliases(unittest.TestCase):
    def test_suffixed_names_of_core_commands_are_aliases(self):
        self.assertIn("ActiveTextureARB", REGISTRY.commands["ActiveTexture"].aliases)
        self.assertNotIn("ActiveTextureARB", REGISTRY.commands)

    def test_an_extension_is_one_line(self):
        registry = registry_module.read_registry(XML, {"GL_EXT_framebuffer_object": registry_module.Listed(True)})
        self.assertIn("GenFramebuffersEXT", registry.commands)
        self.assertIn("GL_FRAMEBUFFER_EXT", headers.gl_h(registry))
        self.assertIn("GL_EXT_framebuffer_object", headers.extension_names_h(registry))
        both = registry_module.read_registry(
            XML, dict.fromkeys(("GL_ARB_framebuffer_object", "GL_EXT_framebuffer_object"), registry_module.Listed(False)))
        self.assertIn("GenFramebuffersEXT", both.commands["GenFramebuffers"].aliases)


class OtherNames(unittest.TestCase):
    def test_brings_what_the_other_brings(self):
        listed = {"GL_ARB_texture_rectangle": registry_module.Listed(True),
                  "GL_EXT_texture_rectangle": registry_module.Listed(True, "GL_ARB_texture_rectangle")}
        self.assertIn("GL_EXT_texture_rectangle", headers.extension_names_h(registry_module.read_registry(XML, listed)))
        with self.assertRaises(SystemExit):
            registry_module.read_registry(XML, {"GL_EXT_texture_rectangle": listed["GL_EXT_texture_rectangle"]})


class Advertised(unittest.TestCase):
    """Issue: every ARB or EXT extension whose commands became core up to GL 1.5 is advertised, its names callable. That
    what the registry declares is exported and found by OSMesaGetProcAddress, library_test.py and entries_test.cpp say."""

    SUFFIX = re.compile("(ARB|EXT)$")

    def extensions_in_core(self):
        """(name, commands) of the extensions of the ARB and of several vendors that the core has taken commands from."""
        root = registry_module.ElementTree.parse(XML).getroot()
        nodes = {node.find("proto/name").text[2:]: node for node in root.find("commands")}

        def is_core(name):
            alias = nodes[name].find("alias")
            return self.SUFFIX.sub("", name) in CORE or (alias is not None and alias.get("name")[2:] in CORE)

        for extension in root.find("extensions"):
            if "gl" in extension.get("supported").split("|") and re.match("GL_(ARB|EXT)_", extension.get("name")):
                commands = [node.get("name")[2:] for block in extension.findall("require")
                            if block.get("api") in (None, "gl") for node in block.findall("command")]
                if any(map(is_core, commands)):
                    yield extension.get("name"), commands

    def test_and_declared_is_every_extension_that_commands_came_from(self):
        found = dict(self.extensions_in_core())
        self.assertEqual(len(found), 23)
        del found["GL_ARB_imaging"]  # optional in every version [GL1.5 §3.6.2]; two of its commands no longer are
        for name, commands in found.items():
            self.assertTrue(EXTENSIONS[name].advertised, name)
            self.assertEqual(set(commands) - set(REGISTRY.signatures), set(), name)

    def test_what_is_advertised_is_written(self):
        written = handlers.find_handlers(HERE.parent / "commands", REGISTRY.commands)
        primary = {alias: command.name for command in REGISTRY.commands.values() for alias in command.aliases}
        for section in REGISTRY.sections:
            for name in section.commands if section.advertised else ():
                command = REGISTRY.commands[primary.get(name, name)]
                self.assertIsNotNone(handlers.statements(command, written), f"{section.name}: {name}")

    def test_is_what_the_versions_are_made_of(self):
        """The extensions without commands as well: those that the specifications of GL 1.1 to 1.5 name as the origins of
        what each version added [GL1.5 App. G, App. H]."""
        origins = {
            "1.1": "EXT_vertex_array EXT_polygon_offset EXT_blend_logic_op EXT_texture EXT_copy_texture EXT_subtexture "
                   "EXT_texture_object",
            "1.2": "EXT_texture3D EXT_bgra EXT_packed_pixels EXT_rescale_normal EXT_separate_specular_color "
                   "SGIS_texture_edge_clamp SGIS_texture_lod EXT_draw_range_elements",
            "1.3": "ARB_texture_compression ARB_texture_cube_map ARB_multisample ARB_multitexture ARB_texture_env_add "
                   "ARB_texture_env_combine ARB_texture_env_dot3 ARB_texture_border_clamp ARB_transpose_matrix",
            "1.4": "SGIS_generate_mipmap NV_blend_square EXT_blend_color EXT_blend_minmax EXT_blend_subtract "
                   "ARB_depth_texture ARB_shadow EXT_fog_coord EXT_multi_draw_arrays ARB_point_parameters "
                   "EXT_secondary_color EXT_blend_func_separate EXT_stencil_wrap ARB_texture_env_crossbar "
                   "EXT_texture_lod_bias ARB_texture_mirrored_repeat ARB_window_pos",
            "1.5": "ARB_vertex_buffer_object ARB_occlusion_query EXT_shadow_funcs",
        }
        for name in " ".join(origins.values()).split():
            self.assertTrue(EXTENSIONS["GL_" + name].advertised, name)


class Header(unittest.TestCase):
    def compile(self, compiler, language, *options):
        with tempfile.TemporaryDirectory() as folder:
            generate.write_if_changed(Path(folder, "GL/gl.h"), headers.gl_h(REGISTRY))
            generate.write_if_changed(Path(folder, "GL/glext.h"), headers.glext_h(REGISTRY))
            for first, second in (("GL/gl.h", "GL/glext.h"), ("GL/glext.h", "GL/gl.h")):
                Path(folder, "program").write_text(
                    f"#include <{first}>\n#include <{second}>\nint main(void) {{\n"
                    "PFNGLBINDBUFFERARBPROC bind = &glBindBuffer;\nbind(GL_ARRAY_BUFFER_ARB, 0);\n"
                    "glBegin(GL_TRIANGLES);\n"
                    "return GL_FOG_COORD_SRC == GL_FOG_COORDINATE_SOURCE; }\n")
                command = [compiler, *options, "-pedantic-errors", "-Wall", "-Wextra", "-Werror", "-I", folder,
                           "-fsyntax-only", "-x", language, str(Path(folder, "program"))]
                result = subprocess.run(command, capture_output=True, text=True)
                self.assertEqual(result.returncode, 0, result.stderr)

    def test_c89(self):
        self.compile(shutil.which("cc") or "gcc", "c", "-std=c89")

    def test_cpp(self):
        self.compile(os.environ.get("CXX") or "c++", "c++", "-std=c++98")
        self.compile(os.environ.get("CXX") or "c++", "c++", "-std=c++20")

    def test_values(self):
        text = headers.gl_h(REGISTRY)
        for line in ("#define GL_TRIANGLES 0x0004", "#define GL_LIGHT0 0x4000", "#define GL_BGRA 0x80E1",
                     "#define GL_ALL_ATTRIB_BITS 0xFFFFFFFF", "#define GL_FALSE 0",
                     "#define GL_TABLE_TOO_LARGE 0x8031"):
            self.assertIn(line + "\n", text)


class SupportTable(unittest.TestCase):
    def test_readme_region(self):
        with tempfile.TemporaryDirectory() as folder:
            readme = Path(folder, "README.md")
            readme.write_text(f"before\n{support.BEGIN}\nold\n{support.END}\nafter\n")
            for table in ("new\n", "newer\n"):
                support.update(readme, table)
                self.assertEqual(readme.read_text(), f"before\n{support.BEGIN}\n{table}{support.END}\nafter\n")

    def test_counts(self):
        table = support.markdown(REGISTRY, {"Clear": "a.h", "Vertex4f": "a.h"})
        self.assertIn("| | all | 452 | 25 | 427 |", table)


class Records(unittest.TestCase):
    def test_every_kept_pointer_has_a_length(self):
        rows = records.records_cpp(REGISTRY)
        self.assertEqual(rows.count("Length::elements"), 15)
        self.assertIn("{Opcode::PixelMapusv, Length::elements", rows)

    def test_recording_begins_with_a_handler_of_new_list(self):
        commands = [REGISTRY.commands["Clear"]]
        self.assertNotIn("append_record", entries.watched_cpp(commands, {"Clear": "a.h"}))
        self.assertIn("append_record", entries.watched_cpp(commands, {"Clear": "a.h", "NewList": "a.h"}))


if __name__ == "__main__":
    sys.exit(unittest.main())
