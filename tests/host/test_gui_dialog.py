# SPDX-License-Identifier: GPL-3.0-or-later
"""The dialogs in the packaged MeshLab 2020.09, opened and applied as a user would.

Pictures of them are kept as artifacts. MeshLab prints its log to standard output as well, which
tells what happened.
"""

import contextlib
import time

import pytest
from desktop import running, screen, wait_for
from samples import load

DECIMATION = "Simplification: Curvature-Enhanced Edge Collapse"
SPHERES = "Simplification: Algebraic Sphere Edge Collapse"
REMOVAL = "Simplification: Vertex Removal (Schroeder)"
CLUSTERING = "Simplification: Vertex Clustering with Representatives"
IMPORTANCE = "Curvature Importance"
START_SECONDS = 60
DIALOG_SECONDS = 10
ATTEMPTS = 3
REDRAW_SECONDS = 1
FULL_HD_HEIGHT = 1080
# Share of the dialog's width, and pixels from its bottom.
BUTTONS = {"Apply": (0.75, 22), "Close": (0.25, 22), "Help": (0.75, 55)}


class Session:
    """MeshLab with the cow on a virtual screen."""

    def __init__(self, display, log):
        self.display = display
        self.log = log

    def logged(self, text):
        return text in self.log.read_text(errors="replace")

    def open_filter(self, name):
        """Through the search field, as Ctrl+F does; returns the dialog's window."""
        for _ in range(ATTEMPTS - 1):  # a window that has just opened may swallow keys
            self._search(name)
            with contextlib.suppress(AssertionError):
                return self._dialog(name)
            self.display.keys("Escape")
        self._search(name)
        return self._dialog(name)

    def _search(self, name):
        self.display.click(200, 400)
        self.display.keys("ctrl+f")
        self.display.type(name)
        self.display.keys("Down", "Return")

    def _dialog(self, name):
        return wait_for(lambda: self.display.windows(name), DIALOG_SECONDS, f"dialog '{name}'")[0]

    def press(self, button, dialog):
        """By place: the buttons stand in the corners of the dialog's foot."""
        box = self.display.geometry(dialog)
        share, from_bottom = BUTTONS[button]
        x = box["X"] + int(share * box["WIDTH"])
        self.display.click(x, box["Y"] + box["HEIGHT"] - from_bottom)

    def help(self, dialog, picture):
        """Shows the help texts beside the parameters, keeps a picture, and hides them again."""
        without = self.display.signature()
        self.press("Help", dialog)
        wait_for(lambda: self.display.signature() != without, DIALOG_SECONDS, "help texts")
        time.sleep(REDRAW_SECONDS)
        self.display.picture(picture)
        self.press("Help", dialog)

    def apply(self, name, dialog, picture):
        """Applies the filter, closes its dialog, and keeps a picture of the result."""
        self.press("Apply", dialog)
        wait_for(lambda: self.logged(f"Applied filter {name}"), DIALOG_SECONDS, f"end of '{name}'")
        self.press("Close", dialog)
        wait_for(lambda: not self.display.windows(name), DIALOG_SECONDS, "end of the dialog")
        time.sleep(REDRAW_SECONDS)
        self.display.picture(picture)


@pytest.fixture
def session(meshlab, tmp_path):
    load("cow.obj").save_current_mesh(str(tmp_path / "cow.ply"))
    log = tmp_path / "meshlab.log"
    with screen() as display, log.open("w") as output:
        environment = meshlab.environment(QT_QPA_PLATFORM="xcb", **display.environment)
        command = [meshlab.bin / "meshlab", tmp_path / "cow.ply"]
        with running(command, env=environment, stdout=output, stderr=output):
            started = Session(display, log)
            wait_for(lambda: started.logged("All files opened"), START_SECONDS, "MeshLab")
            wait_for(lambda: display.windows("MeshLab 2020.09"), START_SECONDS, "its window")
            yield started


def test_decimation_dialog(session, artifacts):
    dialog = session.open_filter(DECIMATION)
    time.sleep(REDRAW_SECONDS)
    session.display.picture(artifacts / "gui_dialog.png")
    session.help(dialog, artifacts / "gui_dialog_help.png")
    session.apply(DECIMATION, dialog, artifacts / "gui_dialog_applied.png")
    assert session.logged("faces: 2902")
    assert session.logged("stopped_by: target")


@pytest.mark.parametrize("name", [DECIMATION, SPHERES, REMOVAL, CLUSTERING])
def test_dialog_fits_a_full_hd_screen(session, name):
    """Otherwise its buttons are out of reach, with and without help."""
    dialog = session.open_filter(name)
    time.sleep(REDRAW_SECONDS)
    assert session.display.geometry(dialog)["HEIGHT"] <= FULL_HD_HEIGHT
    session.press("Help", dialog)
    time.sleep(REDRAW_SECONDS)
    assert session.display.geometry(dialog)["HEIGHT"] <= FULL_HD_HEIGHT


@pytest.mark.parametrize(
    ("name", "picture", "result"),
    [
        (SPHERES, "gui_spheres", "cost_last: "),
        (REMOVAL, "gui_removal", "rejected_loop_split: "),
        (CLUSTERING, "gui_clustering", "cell_size: "),
        (IMPORTANCE, "gui_importance", "median: "),
    ],
)
def test_dialog_of_another_filter(session, artifacts, name, picture, result):
    dialog = session.open_filter(name)
    time.sleep(REDRAW_SECONDS)
    session.display.picture(artifacts / f"{picture}.png")
    session.apply(name, dialog, artifacts / f"{picture}_applied.png")
    assert session.logged(result)
