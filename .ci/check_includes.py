#!/usr/bin/env python3
"""Checks who includes whom: ARCHITECTURE, "The rooms".

A room (folder) may include its own headers, the rooms listed for it, and system headers. Includes are written from the
project's root ("pipeline/draw/draw_state.h"); only headers generated at build time, which api and conformance may
include, bear no folder.
"""
import os
import re
import sys

import sources

INCLUDE = re.compile(r'^\s*#\s*include\s*(?P<quote>["<])(?P<path>[^">]+)[">]', re.MULTILINE)

# The public interface: what an application sees.
PUBLIC = {"GL/gl.h", "GL/osmesa.h", "GL/gouraud.h", "api/gouraud.h"}

# Headers that say what data passes between stages and how it is read; none of them is a stage.
STAGE_DATA = {
    "pipeline/draw/draw_state.h",
    "pipeline/draw/methods.h",
    "pipeline/draw/method_state.h",
    "pipeline/draw/sample_counter.h",
    "pipeline/draw/limits.h",
    "pipeline/draw/byte_count.h",
    "pipeline/draw/texture_state.h",
    "pipeline/raster/varyings.h",
    "pipeline/geometry/vertex_batch.h",
    "pipeline/geometry/processed_vertices.h",
    "pipeline/raster/fragment_block.h",
    "pipeline/raster/primitive.h",
    "pipeline/raster/interpolation-inl.h",
    "pipeline/raster/pixel_image.h",
    "pipeline/raster/method_shape.h",
    "pipeline/texture/image.h",
    "pipeline/framebuffer/framebuffer.h",
}
STAGES = ("geometry", "raster", "texture", "fragment", "framebuffer")

# What conformance, and of it the oracle most of all, sees of the pipeline: the interface of an observer.
# Textures are part of what is drawn.
OBSERVED = ["pipeline/draw/draw_state.h", "pipeline/draw/draw_observer.h", "pipeline/texture/image.h"]

# What a unit test of api/ uses beside its room: the whole of api/, since it drives a context.
API_TESTS = {"api"}

# Room -> the folders and headers that it may include beside its own. The longest matching room counts.
RULES = {
    "demos": PUBLIC | {"GL/glext.h", "demos/shell/circle.h", "demos/shell/font.h", "demos/shell/images.h", "demos/shell/shadow_map.h",
                       "demos/shell/shell.h", "demos/shell/solids.h"},
    "demos/shell": PUBLIC | {"GL/glext.h"},
    "conformance": PUBLIC,
    "api": {"GL/gl.h", "GL/osmesa.h", "api"},
    "api/state": {"GL/gl.h", "pipeline/draw/draw_state.h",  # for the limits that both must agree on
                  "pipeline/simd/float_mode.h",             # matrices have the same bits however the program rounds
                  "pipeline/texture/image.h"},              # texture objects hold images
    "api/context": {"GL/gl.h", "api", "pipeline/draw", "pipeline/geometry/vertex_batch.h", "pipeline/framebuffer",
                    "pipeline/texture/attachable.h"},  # images that framebuffers draw into
    "api/commands": {"GL/gl.h", "api/state", "api/context", "api/registry", "api/snapshot",
                     "pipeline/framebuffer",       # ReadPixels takes rows out of the target
                     "pipeline/texture",           # TexImage puts texels into images
                     "pipeline/draw/pixel_draws.h", "pipeline/raster/pixel_image.h",  # Bitmap, DrawPixels, CopyPixels
                     "pipeline/geometry/vertex_batch.h",  # evaluators ask what a vertex demands
                     "pipeline/simd/dispatch.h"},  # GL_RENDERER names the instruction set
    "api/snapshot": {"GL/gl.h", "api/state", "api/context", "pipeline/draw",
                     "pipeline/texture/completeness.h"} | STAGE_DATA,  # which textures there are to sample
    "api/osmesa": {"GL/gl.h", "GL/osmesa.h", "GL/gouraud.h", "api", "pipeline/draw", "pipeline/framebuffer"},
    "pipeline/draw": {"pipeline"},
    "pipeline/simd": set(),
    **{f"pipeline/{stage}": STAGE_DATA | {"pipeline/simd"} for stage in STAGES},
}


def includes(path):
    """(line number, quote, included path) of every include in a file."""
    text = sources.without_comments(sources.read(path))
    return [(text.count("\n", 0, m.start("path")) + 1, m["quote"], m["path"]) for m in INCLUDE.finditer(text)]


def closure(headers):
    """The headers and all project headers that they include, directly or not."""
    found, waiting = set(), list(headers)
    while waiting:
        header = waiting.pop()
        if header in found or not os.path.exists(os.path.join(sources.ROOT, header)):
            continue
        found.add(header)
        waiting += [included for _, quote, included in includes(header) if quote == '"']
    return found


def room_of(path):
    """The longest room of RULES that holds the file."""
    return max((room for room in RULES if path.startswith(room + "/")), key=len, default=None)


def is_allowed(room, path, included, allowed):
    """Whether a file of a room may include a project header. A room's own folder is always open to it."""
    home = os.path.dirname(path)
    folder = os.path.dirname(included)
    if not folder:
        generated = not os.path.exists(os.path.join(sources.ROOT, home, included))
        return generated and room.startswith(("api", "conformance"))
    own = room if room != "demos" else home
    return (folder == own or folder.startswith(own + "/")
            or any(included == a or included.startswith(a + "/") for a in allowed))


def main():
    complaints, count = [], 0
    rules = dict(RULES)
    rules["conformance"] = rules["conformance"] | closure(OBSERVED)
    for top in sources.ROOMS:
        for path in sources.files(top, sources.CPP):
            room = room_of(path)
            if room is None:
                complaints.append(f"{path}: lies in no room that .ci/check_includes.py knows")
                continue
            for number, quote, included in includes(path):
                count += 1
                if quote == "<" and not included.startswith("GL/"):
                    continue
                tests = API_TESTS if top == "api" and path.endswith("_test.cpp") else set()
                if not is_allowed(room, path, included, rules[room] | tests):
                    complaints.append(f"{path}:{number}: {room} may not include {included}")
    return sources.report("check_includes", complaints, f"{count} includes, all in order")


if __name__ == "__main__":
    sys.exit(main())
