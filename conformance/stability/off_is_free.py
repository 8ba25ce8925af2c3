#!/usr/bin/env python3
"""Off is free: counts the instructions of drawing fixed scenes with and without each feature's parameters set while the
feature is off, and complains where they differ by more than 0.2 %. Features called on_... are on: there they must differ.

    off_is_free.py VALGRIND OFF_IS_FREE LIBRARY
"""
import glob
import os
import re
import subprocess
import sys
import tempfile

MOST_DIFFERENCE = 0.002


def dumps(folder):
    """{(scene, feature): {"set" or "unset": instructions}} of callgrind's dumps."""
    found = {}
    for path in glob.glob(os.path.join(folder, "dump.*")):
        with open(path, encoding="utf-8", errors="replace") as file:
            text = file.read()
        trigger = re.search(r"^desc: Trigger: Client Request: (\S+) (\S+) (set|unset)$", text, re.MULTILINE)
        if trigger:
            scene, feature, when = trigger.groups()
            instructions = re.search(r"^(?:summary|totals): (\d+)", text, re.MULTILINE)
            found.setdefault((scene, feature), {})[when] = int(instructions[1])
    return found


def main():
    valgrind, program, library = sys.argv[1:4]
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([valgrind, "--quiet", "--tool=callgrind",
                        f"--callgrind-out-file={folder}/dump", program, library],
                       check=True, env={**os.environ, "GOURAUD_THREADS": "1"})
        found = dumps(folder)
    complaints = 0
    for (scene, feature), count in sorted(found.items()):
        difference = count["set"] / count["unset"] - 1
        free = abs(difference) <= MOST_DIFFERENCE
        right = free != feature.startswith("on_")
        complaints += not right
        print(f"{'ok' if right else 'WRONG':5}  {scene:5} {feature:32} {count['unset']:10} {count['set']:10} {difference:+.3%}")
    if not found:
        print("off_is_free: valgrind left no dumps")
    return 1 if complaints or not found else 0


if __name__ == "__main__":
    sys.exit(main())
