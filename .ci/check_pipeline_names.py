#!/usr/bin/env python3
"""Checks that pipeline/ knows nothing of GL's interface: no GLenum or other GL type, no GL_ constant, no gl command.

Comments may name them; code and strings may not.
"""
import re
import sys

import sources

GL_NAME = re.compile(r"\b(?:GL_[A-Z0-9]\w*|GL(?:enum|boolean|bitfield|u?byte|u?short|u?int|sizei|float|clampf|double|"
                     r"clampd|void|intptr|sizeiptr|char)|gl[A-Z]\w*)\b")


def main():
    complaints = []
    paths = sources.files("pipeline", sources.CPP)
    for path in paths:
        for number, line in enumerate(sources.without_comments(sources.read(path)).splitlines(), 1):
            complaints += [f"{path}:{number}: {name} belongs to GL's interface, which pipeline/ does not know"
                           for name in GL_NAME.findall(line)]
    return sources.report("check_pipeline_names", complaints, f"{len(paths)} files, none names GL's interface")


if __name__ == "__main__":
    sys.exit(main())
