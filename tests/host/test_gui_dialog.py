# SPDX-License-Identifier: GPL-3.0-or-later
"""The dialogs of every filter in each desktop MeshLab, opened and applied as a user would, on a
small laptop's screen.

Pictures of them are kept as artifacts. MeshLab prints its log to standard output as well, which
tells what happened.
"""

import contextlib
import json
import time

import meshlab_desktop
import pytest
from conftest import BUILD, PLUGINS
from desktop import running, screen, wait_for
from samples import load

DECIMATION = "Simplification: Curvature-Enhanced Edge Collapse"
SPHERES = "Simplification: Algebraic Sphere Edge Collapse"
REMOVAL = "Simplification: Vertex Removal (Schroeder)"
CLUSTERING = "Simplification: Vertex Clustering with Representatives"
IMPORTANCE = "Curvature Importance"
FILTERS = (DECIMATION, SPHERES, REMOVAL, CLUSTERING, IMPORTANCE)
START_SECONDS = 60
DIALOG_SECONDS = 8
ENTRIES = 3
ROUNDS = 3
REDRAW_SECONDS = 1
LAPTOP = "1366x768x24"
# Width and height that a dialog may have, in pixels. That of 2020.09 shows every parameter.
LARGEST = {"2020.09": (720, 720), "2022.02": (560, 620), "2025.07": (560, 620)}
# Share of the dialog's width, and pixels from its bottom.
BUTTONS = {"Apply": (0.75, 22), "Close": (0.25, 22), "Help": (0.75, 55)}


class Session:
    """MeshLab with the cow on a virtual screen."""

    def __init__(self, version, artifacts, display, log):
        self.version = version
        self.artifacts = artifacts
        self.display = display
        self.log = log

    def logged(self, text):
        return text in self.log.read_text(errors="replace")

    def is_open(self):
        """A list of plugins that lack libraries may stand in the way; Return closes it."""
        self.display.keys("Return")
        return self.logged("All files opened")

    def open_filter(self, name):
        """Through the search field, as Ctrl+F does; returns the dialog's window.

        It is the first or a later entry that is found. A window that has just opened may
        swallow keys, so that every entry is tried again.
        """
        for entry in list(range(1, ENTRIES + 1)) * ROUNDS:
            self._search(name, entry)
            with contextlib.suppress(AssertionError):
                return self._dialog(name)
            self.display.keys("Escape")
        self.picture("no_dialog")
        raise AssertionError(f"no dialog '{name}'")

    def _search(self, name, entry):
        self.display.click(200, 400)
        self.display.keys("ctrl+f")
        time.sleep(REDRAW_SECONDS)
        self.display.type(name)
        self.display.keys(*["Down"] * entry, "Return")

    def _dialog(self, name):
        called = wait_for(lambda: self.display.windows_called(name), DIALOG_SECONDS, name)
        time.sleep(REDRAW_SECONDS)
        return called[0]

    def press(self, button, dialog):
        """By place: the buttons stand in the corners of the dialog's foot."""
        box = self.display.geometry(dialog)
        share, from_bottom = BUTTONS[button]
        x = box["X"] + int(share * box["WIDTH"])
        self.display.click(x, box["Y"] + box["HEIGHT"] - from_bottom)

    def picture(self, name):
        self.display.picture(self.artifacts / f"gui_{self.version}_{name}.png")

    def apply(self, name, dialog):
        """Applies the filter and closes its dialog."""
        self.press("Apply", dialog)
        ends = f"Applied filter {name}", f"Applied filter: {name}"
        wait_for(lambda: any(map(self.logged, ends)), DIALOG_SECONDS, f"end of '{name}'")
        self.press("Close", dialog)
        self.wait_until_closed(name)
        time.sleep(REDRAW_SECONDS)

    def wait_until_closed(self, name):
        wait_for(lambda: not self.display.windows_called(name), DIALOG_SECONDS, f"end of '{name}'")


@pytest.fixture(params=LARGEST)
def session(request, tmp_path, artifacts):
    version, trees = request.param, BUILD / "desktop"
    if reason := meshlab_desktop.why_absent(version, trees):
        pytest.skip(reason)
    plugin = PLUGINS / f"meshlab-{version}" / "libfilter_curvdecim.so"
    program = meshlab_desktop.program(version, trees, plugin, tmp_path / "meshlab")
    mesh, log = tmp_path / "cow.ply", tmp_path / "meshlab.log"
    load("cow.obj").save_current_mesh(str(mesh))
    with screen(LAPTOP) as display, log.open("w") as output:
        environment = program.environment(QT_QPA_PLATFORM="xcb", **display.environment)
        with running(program.command(mesh), env=environment, stdout=output, stderr=output):
            started = Session(version, artifacts, display, log)
            wait_for(started.is_open, START_SECONDS, "MeshLab")
            wait_for(lambda: display.windows("MeshLab 20"), START_SECONDS, "its window")
            yield started


def dialogs(version):
    """The menu names, as the plugin for this version has them."""
    described = json.loads((PLUGINS / "pymeshlab-2025.07" / "parameters.json").read_text())
    if version != "2020.09":
        return [each["menu_name"] for each in described["filters"]]
    return [flat["menu_name"] for each in described["filters"] for flat in each["flat_dialogs"]]


def test_every_dialog_fits_a_small_screen(session):
    """Otherwise its buttons are out of reach, with and without help."""
    too_large = {}
    for number, name in enumerate(dialogs(session.version)):
        dialog = session.open_filter(name)
        session.picture(f"dialog_{number}")
        box = session.display.geometry(dialog)
        width, height = LARGEST[session.version]
        if box["WIDTH"] > width or box["HEIGHT"] > height or box["Y"] < 0:
            too_large[name] = box["WIDTH"], box["HEIGHT"], box["Y"]
        session.press("Help", dialog)
        time.sleep(REDRAW_SECONDS)
        session.picture(f"dialog_{number}_help")
        session.display.close(dialog)
        session.wait_until_closed(name)
    assert not too_large


def test_every_filter_applies(session):
    results = {
        DECIMATION: "5,804 faces became 2,902 in ",
        SPHERES: "2,902 faces became 1,450 in ",
        REMOVAL: "1,450 faces became ",
        CLUSTERING: "cell_size: ",
        IMPORTANCE: "median: ",
    }
    for number, (name, result) in enumerate(results.items()):
        dialog = session.open_filter(name)
        session.apply(name, dialog)
        session.picture(f"applied_{number}")
        assert session.logged(result), name
