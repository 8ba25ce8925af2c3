"""Looks at the built libOSMesa.so.8 from outside: its name and links, what it exports and needs, whether programs find
their functions in it, and whether its header is C89.

    library_test.py LIBRARY FOLDER_OF_GL/OSMESA.H FOLDER_OF_GL/GL.H
"""

import ctypes
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

LIBRARY, OSMESA_INCLUDE, GL_INCLUDE = (Path(argument) for argument in sys.argv[1:4])
RUN_TIME = {"libc.so.6", "libm.so.6", "libstdc++.so.6", "libgcc_s.so.1", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"}
SANITIZERS = {"libasan.so.8", "libubsan.so.1", "libtsan.so.2"}


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def declared(header, pattern):
    return set(re.findall(pattern, header.read_text()))


def exported():
    lines = output("nm", "-D", "--defined-only", str(LIBRARY)).splitlines()
    return {line.split()[-1].split("@")[0] for line in lines}


def dynamic(tag):
    return re.findall(rf"\({tag}\).*\[(.+)\]", output("readelf", "-dW", str(LIBRARY)))


def sanitized():
    return bool(re.search(r"__(asan|tsan|ubsan)_", output("nm", "-D", "--undefined-only", str(LIBRARY))))


class Exports(unittest.TestCase):
    def test_are_gl_and_osmesa_names_and_our_own_alone(self):
        ours = declared(OSMESA_INCLUDE / "GL/gouraud.h", r"GLAPIENTRY (gouraud\w+)\(")
        strangers = {name for name in exported() if not re.match(r"gl[A-Z]|OSMesa[A-Z]", name)} - ours
        self.assertEqual(strangers, set())

    def test_are_every_command_of_the_header(self):
        commands = declared(GL_INCLUDE / "GL/gl.h", r"\b(gl[A-Z]\w+)\s*\(")
        self.assertGreaterEqual(len(commands), 452)
        self.assertEqual(commands - exported(), set())

    def test_are_the_thirteen_functions_of_osmesa(self):
        functions = declared(OSMESA_INCLUDE / "GL/osmesa.h", r"GLAPIENTRY (OSMesa\w+)\(")
        self.assertEqual(len(functions), 13)
        self.assertEqual({name for name in exported() if name.startswith("OSMesa")}, functions)


class TheLibrary(unittest.TestCase):
    def test_is_named_libosmesa_8(self):
        self.assertEqual(dynamic("SONAME"), ["libOSMesa.so.8"])

    def test_has_the_names_that_programs_open(self):
        for name in ("libOSMesa.so", "libOSMesa.so.6", "libOSMesa.so.8"):
            self.assertTrue(os.path.samefile(LIBRARY.parent / name, LIBRARY), name)

    def test_needs_the_run_time_alone(self):
        self.assertEqual(set(dynamic("NEEDED")) - RUN_TIME - SANITIZERS, set())

    def test_headers_are_c89(self):
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder) / "use.c"
            source.write_text("#include <GL/osmesa.h>\n#include <GL/gouraud.h>\nOSMesaContext c;\nint version = OSMESA_MAJOR_VERSION;\n")
            output("cc", "-std=c89", "-pedantic", "-Wall", "-Wextra", "-Werror", "-fsyntax-only",
                   f"-I{OSMESA_INCLUDE}", f"-I{GL_INCLUDE}", str(source))


@unittest.skipIf(sanitized(), "a sanitized library cannot be opened by Python")
class Programs(unittest.TestCase):
    def open(self, name):
        return ctypes.CDLL(str(LIBRARY.parent / name), mode=os.RTLD_NOW | os.RTLD_LOCAL)

    def test_draw_as_glfw_does(self):
        """GLFW resolves the OSMesa functions with dlsym and the gl functions with OSMesaGetProcAddress."""
        library = self.open("libOSMesa.so.6")
        create, destroy = library.OSMesaCreateContextExt, library.OSMesaDestroyContext
        create.restype = ctypes.c_void_p
        destroy.argtypes = [ctypes.c_void_p]
        library.OSMesaMakeCurrent.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint, ctypes.c_int, ctypes.c_int]
        library.OSMesaGetProcAddress.restype = ctypes.c_void_p

        def gl(name, *types):
            return ctypes.CFUNCTYPE(None, *types)(library.OSMesaGetProcAddress(name))

        context = create(0x1908, 24, 8, 0, None)
        pixels = (ctypes.c_ubyte * (8 * 4 * 4))()
        self.assertEqual(library.OSMesaMakeCurrent(context, pixels, 0x1401, 8, 4), 1)
        gl(b"glClearColor", *[ctypes.c_float] * 4)(1.0, 0.0, 1.0, 1.0)
        gl(b"glClear", ctypes.c_uint)(0x4000)
        gl(b"glFinish")()
        self.assertEqual(bytes(pixels[:4]), b"\xff\x00\xff\xff")
        destroy(context)

    def test_find_every_command_as_pyopengl_does(self):
        """PyOpenGL resolves everything with dlsym from libOSMesa.so."""
        library = self.open("libOSMesa.so")
        library.OSMesaGetProcAddress.restype = ctypes.c_void_p
        for name in exported():
            address = ctypes.cast(getattr(library, name), ctypes.c_void_p).value
            self.assertEqual(library.OSMesaGetProcAddress(name.encode()), address, name)

    def test_get_our_functions_though_another_gl_is_loaded(self):
        """Another library that exports gl names, in the global scope, must not be asked for them."""
        with tempfile.TemporaryDirectory() as folder:
            source, impostor = Path(folder) / "gl.c", Path(folder) / "libimpostor.so"
            source.write_text("void glBegin(unsigned mode) { (void)mode; __builtin_trap(); }\n")
            output("cc", "-shared", "-fPIC", "-o", str(impostor), str(source))
            program = ("import ctypes, os, sys\n"
                       "stranger = ctypes.CDLL(sys.argv[1], mode=os.RTLD_NOW | os.RTLD_GLOBAL)\n"
                       "ours = ctypes.CDLL(sys.argv[2], mode=os.RTLD_NOW | os.RTLD_LOCAL)\n"
                       "ours.OSMesaGetProcAddress.restype = ctypes.c_void_p\n"
                       "found = ours.OSMesaGetProcAddress(b'glBegin')\n"
                       "sys.exit(found != ctypes.cast(ours.glBegin, ctypes.c_void_p).value)\n")
            output(sys.executable, "-c", program, str(impostor), str(LIBRARY))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
