#!/usr/bin/env python3
"""Random GL calls through two libraries: both must raise the same errors, leave the same state and give the same feedback
and selection hits. Where they part, it prints the calls before and stops.

    fuzz.py FUZZ OUR_LIBRARY MESA_LIBRARY FIRST_SEED CALLS
"""
import os
import re
import subprocess
import sys

RELATIVE, ABSOLUTE = 2e-4, 2e-4
INTEGERS = [["state", f"0x{group:x}"] for group in (0x2, 0x41, 0x10404, 0x10405)]
LINE_TOKENS = {0x702, 0x707}
LARGEST_INTEGER, LARGEST_DEPTH = 2.147e9, 4.29497e9

# Lines in which Mesa is known to differ, and why ours is right.
KNOWN = [
    # Only colours, normals and depths map 1 to the largest integer; matrices are rounded [GL1.5 §6.1.2].
    r"state 0x2 0x(ba[678]|84e[345]):",
    # Masks are all ones at first [GL1.5 Tables 6.19, 6.20]; Mesa cuts them to the bits of the buffer, or to -1.
    r"state 0x[123] 0x(b93|b98|c21):",
    # Raster colours are clamped [GL1.5 §2.13]; not by Mesa.
    r"state 0x[1-4] 0x(b04|845f):",
    # As integers planes, positions and factors are rounded, not cut off [GL1.5 §6.1.2].
    r"state 0x1200[0-3] 0x250[12]:|state 0x2[0-7] 0x120[0-9]:",
    # Maps of indices are not scaled [GL1.5 §6.1.2].
    r"state 0x41 0xc7[01]:",
    # InterleavedArrays disables these, too [GL1.5 §2.8].
    r"state 0x5 0x84(57|5e):",
    # PopAttrib restores the LOD bias and every hint, too [GL1.5 §6.1.14].
    r"state 0x32 0x0:|state 0x[1-4] 0x8192:",
    # The transposed texture matrix is the active unit's; Mesa's is that of unit 0. There is no current index in RGBA mode.
    r"state 0x[1-4] 0x(84e5|b01):",
    # The internal format of no image is 1 [GL1.5 Table 6.17].
    r"state 0x20de[01] 0x1003:",
]


def transcript(fuzz, library, seed, calls):
    environment = {name: value for name, value in os.environ.items() if name != "LD_LIBRARY_PATH"}
    environment.update(GALLIUM_DRIVER="softpipe", LP_NUM_THREADS="0")
    run = subprocess.run([fuzz, library, str(seed), str(calls)], capture_output=True, text=True, env=environment)
    lines = run.stdout.splitlines()
    if run.returncode != 0:
        lines.append(f"ended with {run.returncode}: {run.stderr.strip()}")
    return [line for line in lines if not any(re.search(known, line) for known in KNOWN)]


def equal(ours, theirs):
    if ours == theirs:
        return True
    # Where a call is wrong in two ways, either error is right.
    error = re.compile(r" -> error 0x\w+$")
    if error.search(ours) and error.search(theirs) and error.sub("", ours) == error.sub("", theirs):
        return True
    a, b = ours.split(), theirs.split()
    if len(a) != len(b):
        return False
    for x, y in zip(a, b):
        if x == y:
            continue
        try:
            x, y = float(x), float(y)
        except ValueError:
            return False
        if a[0] == "hits" and (abs(x - y) < 1e5 or abs(abs(x - y) - LARGEST_DEPTH) < 1e5):  # at 0 and 1 Mesa's overflow
            continue
        if {x, y} == LINE_TOKENS:  # ours says where the stipple begins anew [GL1.5 §5.3]; Mesa only if there is one
            continue
        if abs(x) >= LARGEST_INTEGER and a[0] == "state":  # too large for an integer; Mesa's wrap around
            continue
        if abs(x - y) <= 1 and a[:2] in INTEGERS:  # as integers: rounded or cut off
            continue
        if not abs(x - y) <= ABSOLUTE + RELATIVE * max(abs(x), abs(y)):
            return False
    return True


def contexts(lines):
    """Lists of steps, one a context: a line that a call left, or the state that changed as {variable: line}."""
    found = []
    for line in lines:
        if line.startswith("context"):
            found.append([])
        if line.startswith("  state"):
            if not isinstance(found[-1][-1], dict):
                found[-1].append({})
            found[-1][-1][line.split(":")[0]] = line
        else:
            found[-1].append(line)
    return found


def difference(ours, theirs):
    """What two steps differ in, or None."""
    if isinstance(ours, dict) and isinstance(theirs, dict):
        for name in sorted({*ours, *theirs}):
            x, y = ours.get(name, "(unchanged)"), theirs.get(name, "(unchanged)")
            if not equal(x, y):
                return f"ours: {x}\nMesa: {y}"
        return None
    return None if isinstance(ours, str) and isinstance(theirs, str) and equal(ours, theirs) else f"ours: {ours}\nMesa: {theirs}"


def compare(ours, theirs, context=40):
    """The end of a context's steps up to where both part, or None. Where Mesa crashed there is nothing to compare."""
    for i in range(max(len(ours), len(theirs))):
        x, y = (steps[i] if i < len(steps) else "(end)" for steps in (ours, theirs))
        if y == "crashed" or "crashed" in theirs[i:i + 3]:
            return None
        if found := difference(x, y):
            before = [step for step in ours[:i] if isinstance(step, str)][-context:]
            return "\n".join([ours[0], *before, found])
    return None


def main():
    fuzz, ours, mesa, seed, calls = sys.argv[1:6]
    a, b = (contexts(transcript(fuzz, library, seed, calls)) for library in (ours, mesa))
    found = [text for text in map(compare, a, b) if text]
    print(*found, f"{len(a)} contexts, {len(found)} differ", sep="\n\n")
    return 1 if found or len(a) != len(b) else 0


if __name__ == "__main__":
    sys.exit(main())
