#!/usr/bin/env python3
"""Runs a demo in a window under Xvfb and compares what the screen shows with the same demo's headless pictures.

Takes the path of a demo whose view turns with the right arrow key. Exit status 0: the window showed the picture, pixel
for pixel; the arrow key and a change of size changed both alike; ESC ended the demo with status 0.
"""
import contextlib
import os
import subprocess
import sys
import tempfile
import time

TIMEOUT_S = 30
POLL_S = 0.05
SCREEN = "1024x768x24"
FIRST_SIZE = (400, 300)
SECOND_SIZE = (320, 352)
TIME_S = "0.5"  # the clock stands still, so that window and headless run show the same frame


class Failure(Exception):
    """One line that says what went wrong."""


def output(*command, **kwargs):
    """The standard output of a command that must succeed."""
    done = subprocess.run(command, capture_output=True, text=True, timeout=TIMEOUT_S, check=False, **kwargs)
    if done.returncode != 0:
        raise Failure(f"{' '.join(command)} ended with status {done.returncode}: {done.stderr.strip()}")
    return done.stdout


def wait_for(what, attempt):
    """Calls attempt() until it returns something true; says what was awaited when time is up."""
    end = time.monotonic() + TIMEOUT_S
    while time.monotonic() < end:
        result = attempt()
        if result:
            return result
        time.sleep(POLL_S)
    raise Failure(f"{what}: not within {TIMEOUT_S} s")


@contextlib.contextmanager
def child(*command, **kwargs):
    """A process that is ended, at the latest, when the block is left."""
    process = subprocess.Popen(command, **kwargs)
    try:
        yield process
    finally:
        if process.poll() is None:
            process.kill()
        process.wait()


@contextlib.contextmanager
def x_server(folder):
    """An Xvfb on a display number of its own choice; gives the environment of its clients.

    -noreset: otherwise the server starts anew, and refuses connections meanwhile, when its only client, such as a search
    for the window that comes before the demo, leaves.
    """
    read_end, write_end = os.pipe()
    with open(os.path.join(folder, "xvfb.log"), "w", encoding="utf-8") as log:
        with child("Xvfb", "-displayfd", str(write_end), "-screen", "0", SCREEN, "-nolisten", "tcp", "-noreset",
                   pass_fds=[write_end], stderr=log):
            os.close(write_end)
            with os.fdopen(read_end) as numbers:
                number = numbers.readline().strip()
            if not number:
                raise Failure("Xvfb did not start")
            environment = {k: v for k, v in os.environ.items() if k not in ("WAYLAND_DISPLAY", "XAUTHORITY")}
            environment["DISPLAY"] = f":{number}"
            yield environment


class Window:
    """The demo's window, seen and driven from outside as a user would."""

    def __init__(self, demo, environment, folder):
        self.demo, self.environment, self.folder = demo, environment, folder
        self.shot = os.path.join(folder, "screen.png")
        self.id = wait_for("a window", self._find)

    def _find(self):
        if self.demo.poll() is not None:
            raise Failure(f"the demo ended by itself with status {self.demo.returncode}")
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--pid", str(self.demo.pid)],
                               capture_output=True, text=True, env=self.environment, timeout=TIMEOUT_S, check=False)
        return found.stdout.split()[-1] if found.stdout.split() else None

    def xdotool(self, *command):
        output("xdotool", *command, env=self.environment)

    def press(self, key):
        self.xdotool("windowfocus", "--sync", self.id)
        self.xdotool("key", key)

    def resize(self, size):
        self.xdotool("windowsize", self.id, str(size[0]), str(size[1]))

    def differing_pixels(self, picture):
        """How many pixels of the screenshot differ from the picture; the reason, as text, where none can be compared."""
        output("import", "-window", self.id, self.shot, env=self.environment)
        done = subprocess.run(["compare", "-metric", "AE", self.shot, picture, "null:"],
                              capture_output=True, text=True, timeout=TIMEOUT_S, check=False)
        text = done.stderr.strip()
        return int(text) if text.isdigit() else text

    def expect(self, what, picture):
        last = None

        def equal():
            nonlocal last
            last = self.differing_pixels(picture)
            return last == 0

        try:
            wait_for(what, equal)
        except Failure as failure:
            raise Failure(f"{failure}; differing pixels at the end: {last}") from None
        print(f"{what}: all pixels equal")


def headless(demo, folder, name, size, keys=()):
    """The picture that the window is expected to show."""
    picture = os.path.join(folder, name)
    more = ["--keys", ",".join(keys)] if keys else []
    output(demo, "--out", picture, "--size", f"{size[0]}x{size[1]}", "--time", TIME_S, *more)
    return picture


def test(demo, folder):
    start = headless(demo, folder, "start.png", FIRST_SIZE)
    turned = headless(demo, folder, "turned.png", FIRST_SIZE, ["right"])
    resized = headless(demo, folder, "resized.png", SECOND_SIZE, ["right"])
    with x_server(folder) as environment:
        with child(demo, "--size", f"{FIRST_SIZE[0]}x{FIRST_SIZE[1]}", "--time", TIME_S, env=environment) as process:
            window = Window(process, environment, folder)
            window.expect("the window shows the headless picture", start)
            if window.differing_pixels(turned) == 0:
                raise Failure("the right arrow key changes nothing, even headless")
            window.press("Right")
            window.expect("the right arrow key turns the view", turned)
            window.resize(SECOND_SIZE)
            window.expect("the picture follows the window's size", resized)
            window.press("Escape")
            wait_for("ESC ends the demo", lambda: process.poll() is not None)
            if process.returncode != 0:
                raise Failure(f"after ESC the demo ended with status {process.returncode}")
            print("ESC ends the demo with status 0")


def main():
    if len(sys.argv) != 2:
        print("usage: window_test.py DEMO", file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory() as folder:
        try:
            test(os.path.abspath(sys.argv[1]), folder)
        except (Failure, OSError, subprocess.TimeoutExpired) as failure:
            print(f"window_test: {failure}", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
