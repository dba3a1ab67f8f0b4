# SPDX-License-Identifier: GPL-3.0-or-later
"""A virtual screen, and the keys and clicks of a user on it."""

import re
import subprocess
import time
from contextlib import contextmanager


def wait_for(condition, seconds, what):
    """The first true answer of condition()."""
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline:
        if answer := condition():
            return answer
        time.sleep(0.2)
    raise AssertionError(f"{what}: not within {seconds} s")


@contextmanager
def running(command, **options):
    process = subprocess.Popen(command, **options)
    try:
        yield process
    finally:
        process.terminate()
        process.wait(timeout=20)


@contextmanager
def screen(size):
    """A new virtual screen of this size, as 1366x768x24."""
    command = ["Xvfb", "-displayfd", "1", "-screen", "0", size]
    with running(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as server:
        yield Screen(":" + server.stdout.readline().strip())


class Screen:
    def __init__(self, display):
        self.environment = {"DISPLAY": display}

    def _run(self, *command):
        answer = subprocess.run(
            command,
            env={"PATH": "/usr/bin:/bin", **self.environment},
            capture_output=True,
            text=True,
        )
        return answer.stdout

    def keys(self, *names):
        self._run("xdotool", "key", "--delay", "60", *names)

    def type(self, text):
        self._run("xdotool", "type", "--delay", "30", text)

    def click(self, x, y):
        self._run("xdotool", "mousemove", str(x), str(y), "click", "1")

    def windows(self, title):
        """Ids of the visible windows whose title begins with the text."""
        return self._windows(f"^{re.escape(title)}")

    def windows_called(self, title):
        """Ids of the visible windows with this title."""
        return self._windows(f"^{re.escape(title)}$")

    def _windows(self, pattern):
        return self._run("xdotool", "search", "--onlyvisible", "--name", pattern).split()

    def geometry(self, window):
        """X, Y, WIDTH and HEIGHT of a window, in pixels."""
        lines = self._run("xdotool", "getwindowgeometry", "--shell", window).split()
        pairs = (line.split("=") for line in lines)
        return {name: int(value) for name, value in pairs}

    def close(self, window):
        self._run("xdotool", "windowclose", window)

    def picture(self, file):
        self._run("import", "-window", "root", str(file))
