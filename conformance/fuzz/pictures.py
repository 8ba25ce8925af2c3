#!/usr/bin/env python3
"""Random pictures through ours, llvmpipe and softpipe. A picture is a case where ours differs from both in the same pixels
by more than rounding can, and they agree with each other. Prints each case with its seed and the fewest features that it
needs.

    pictures.py FUZZ_PICTURES OUR_LIBRARY MESA_LIBRARY FIRST_SEED COUNT [--png FOLDER]
"""
import os
import subprocess
import sys
import tempfile

SIDE = 64
PIXELS = SIDE * SIDE
# Rounding of 8 bits adds up over units, blending and accumulation; a depth of Mesa's is far off on steep triangles.
COLOR_OFF, COLOR_AGREES = 6, 3
DEPTH_OFF, DEPTH_AGREES = 1 << 23, 1 << 20
FEW_PIXELS = 24  # edges of tests, of texels and of lines
SETTINGS = {"GALLIUM_OVERRIDE_CPU_CAPS": "sse4.1", "GALLIVM_PERF": "no_aos_sampling", "LP_NUM_THREADS": "0"}


class Picture:
    def __init__(self, title, rgba=None, depth=None, stencil=None):
        self.title, self.rgba, self.depth, self.stencil = title, rgba, depth, stencil

    def is_like(self, other):
        return self.rgba == other.rgba and self.depth == other.depth and self.stencil == other.stencil


def start(fuzz, library, seed, count, features, driver, cache):
    environment = {name: value for name, value in os.environ.items() if name != "LD_LIBRARY_PATH" and not name.startswith("GOURAUD_")}
    if driver:
        environment.update(SETTINGS, GALLIUM_DRIVER=driver, MESA_SHADER_CACHE_DIR=cache)
    arguments = [fuzz, library, str(seed), str(count)] + ([f"{features:x}"] if features is not None else [])
    return subprocess.Popen(arguments, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env=environment)


def read(process):
    while line := process.stdout.readline().decode().rstrip("\n"):
        if line.endswith(" crashed"):
            yield Picture(line)
        else:
            rgba, depth, stencil = (process.stdout.read(size * PIXELS) for size in (4, 4, 1))
            yield Picture(line, rgba, memoryview(depth).cast("I"), stencil)
    if process.wait() != 0:
        sys.exit(f"{process.args}: ended with {process.returncode}")


def color_distance(a, b, i):
    return max(abs(a.rgba[4 * i + c] - b.rgba[4 * i + c]) for c in range(4))


def pixels_off(ours, mesas):
    """Pixels in which ours is alone."""
    if not ours.rgba:
        return PIXELS if all(picture.rgba for picture in mesas) else 0
    if not all(picture.rgba for picture in mesas) or any(ours.is_like(picture) for picture in mesas):
        return 0
    first, second = mesas
    found = 0
    for i in range(PIXELS):
        color = slice(4 * i, 4 * i + 4)
        if ours.rgba[color] != first.rgba[color] and color_distance(ours, first, i) > COLOR_OFF and color_distance(ours, second, i) > COLOR_OFF:
            found += color_distance(first, second, i) <= COLOR_AGREES
        elif ours.stencil[i] != first.stencil[i] and first.stencil[i] == second.stencil[i]:
            found += 1
        elif abs(ours.depth[i] - first.depth[i]) > DEPTH_OFF and abs(first.depth[i] - second.depth[i]) < DEPTH_AGREES:
            found += 1
    return found


class Fuzz:
    def __init__(self, fuzz, ours, mesa, cache):
        self.drivers = [(fuzz, ours, None), (fuzz, mesa, "llvmpipe"), (fuzz, mesa, "softpipe")]
        self.cache = cache

    def pictures(self, seed, count, features=None):
        """Three pictures of each seed: ours, llvmpipe's, softpipe's."""
        processes = [start(fuzz, library, seed, count, features, driver, self.cache) for fuzz, library, driver in self.drivers]
        return zip(*map(read, processes))

    def is_off(self, seed, features):
        ours, *mesas = next(self.pictures(seed, 1, features))
        return pixels_off(ours, mesas) > FEW_PIXELS

    def minimal(self, seed, features):
        """Drops features as long as the difference stays."""
        for bit in [1 << i for i in range(64) if features >> i & 1]:
            if self.is_off(seed, features & ~bit):
                features &= ~bit
        return features


def write_png(folder, seed, pictures):
    from PIL import Image
    sheet = Image.new("RGB", (4 * SIDE, SIDE))
    off = bytes(min(255, 8 * abs(a - b)) for a, b in zip(pictures[0].rgba, pictures[1].rgba))
    for i, rgba in enumerate([*(picture.rgba for picture in pictures), off]):
        sheet.paste(Image.frombytes("RGBA", (SIDE, SIDE), rgba).convert("RGB").transpose(Image.FLIP_TOP_BOTTOM), (SIDE * i, 0))
    sheet.resize((16 * SIDE, 4 * SIDE), Image.NEAREST).save(f"{folder}/{seed}.png")


def main():
    fuzz, ours, mesa, seed, count = sys.argv[1:6]
    folder = sys.argv[7] if sys.argv[6:7] == ["--png"] else None
    cases = 0
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as cache:
        judge = Fuzz(fuzz, ours, mesa, cache)
        for ours, *mesas in judge.pictures(int(seed), int(count)):
            if (off := pixels_off(ours, mesas)) <= FEW_PIXELS:
                continue
            cases += 1
            seed, features = int(ours.title.split()[0]), int(ours.title.split()[1], 16)
            fewest = judge.minimal(seed, features)
            least, *others = next(judge.pictures(seed, 1, fewest))
            print(f"{off} pixels of {ours.title}\n  needs {least.title}: {pixels_off(least, others)} pixels", flush=True)
            if folder and all(picture.rgba for picture in [least, *others]):
                write_png(folder, seed, [least, *others])
    print(f"{count} pictures, {cases} differ")
    return 1 if cases else 0


if __name__ == "__main__":
    sys.exit(main())
