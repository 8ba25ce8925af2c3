"""What the checks in this folder share: the project's root, its source files, and C++ without its comments."""
import os
import re

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
ROOMS = ("api", "pipeline", "demos", "conformance")
CPP = (".h", ".cpp")

_COMMENT_OR_STRING = re.compile(
    r'R"(?P<delimiter>[^(\s]*)\(.*?\)(?P=delimiter)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|//[^\n]*|/\*.*?\*/',
    re.DOTALL)


def files(folder, endings):
    """Paths, relative to the root, of the files below a folder whose names end so; sorted."""
    found = []
    for where, folders, names in os.walk(os.path.join(ROOT, folder)):
        folders[:] = [f for f in folders if f != "__pycache__"]
        found += [os.path.relpath(os.path.join(where, name), ROOT) for name in names if name.endswith(endings)]
    return sorted(found)


def read(path):
    """The text of a file given by its path from the root."""
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def without_comments(text):
    """C++ with each comment blanked out, line for line; strings stay."""
    def blank(match):
        token = match.group()
        return re.sub(r"[^\n]", " ", token) if token.startswith(("//", "/*")) else token
    return _COMMENT_OR_STRING.sub(blank, text)


def report(check, complaints, summary):
    """Prints the complaints, or the summary where there are none; gives the exit status."""
    for complaint in complaints:
        print(complaint)
    print(f"{check}: {len(complaints)} complaint(s)" if complaints else f"{check}: {summary}")
    return 1 if complaints else 0
