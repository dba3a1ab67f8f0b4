# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of the bench around the judge; MeshLab's own filter serves as the filter under test."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import picture
import pytest
import sketch
import tables
from decimators import Decimator, meshlab, race
from meshes import read_mesh, shipped, write_mesh
from models import Model
from panels import Panel, View
from workers import FilterError

COW = shipped("cow.obj")


def test_a_race_gives_one_outcome_a_decimator_at_the_target() -> None:
    outcomes = race(COW, 1160, [meshlab(), meshlab()], repeats=2)
    assert [len(outcome.faces) for outcome in outcomes] == [1160, 1160]
    assert all(0 < outcome.seconds < 60 for outcome in outcomes)
    np.testing.assert_array_equal(outcomes[0].vertices, outcomes[1].vertices)


def test_a_failing_filter_is_named_with_its_mesh_and_its_reason() -> None:
    with pytest.raises(FilterError, match=r"(?s)Nobody on cow\.obj to 100 faces.*no_such_filter"):
        race(COW, 100, [Decimator("Nobody", "no_such_filter")])


def test_the_worker_measures_the_filter_and_saves_its_mesh(tmp_path: Path) -> None:
    job = {
        "mesh": str(COW),
        "plugin": None,
        "filter": "meshing_invert_face_orientation",
        "parameters": {},
        "output": str(tmp_path / "out.ply"),
    }
    worker = Path(__file__).with_name("filter_worker.py")
    done = subprocess.run(
        [sys.executable, worker], input=json.dumps(job), capture_output=True, text=True, check=True
    )
    assert json.loads(done.stdout.splitlines()[-1])["seconds"] > 0
    before, after = read_mesh(COW)[1], read_mesh(tmp_path / "out.ply")[1]
    assert np.array_equal(np.sort(before, axis=1), np.sort(after, axis=1))
    assert not np.array_equal(before, after)


def test_ply_keeps_doubles_to_the_bit(tmp_path: Path) -> None:
    vertices = np.array([(1 / 3, np.pi, 1e-300), (1.0, 0.0, 0.0), (0.0, 1e300, 0.0)])
    write_mesh(tmp_path / "mesh.ply", vertices, np.array([(0, 1, 2)]))
    np.testing.assert_array_equal(read_mesh(tmp_path / "mesh.ply")[0], vertices)


def test_a_region_is_the_union_of_its_boxes(tmp_path: Path) -> None:
    """A square at z = 0 whose two outer thirds are raised: the regions see one third each."""
    x = np.repeat(np.linspace(3, 9, 4), 2)
    y = np.tile([0.0, 6.0], 4)
    vertices = np.stack([x, y, 0 * x], axis=1)
    faces = np.array([f for i in (0, 2, 4) for f in ((i, i + 2, i + 3), (i, i + 3, i + 1))])
    path = tmp_path / "strip.ply"
    write_mesh(path, vertices, faces)
    every = (0.0, 1.0)
    outer = [((0.0, 0.3), every, every), ((0.7, 1.0), every, every)]
    model = Model("strip", path, {"outer": outer, "middle": [((0.4, 0.6), every, every)]})
    raised = np.concatenate([vertices[faces[:2]], vertices[faces[4:]]]).reshape(-1, 3) + (0, 0, 0.1)
    middle = vertices[faces[2:4]].reshape(-1, 3)
    regions = model.judge(
        np.concatenate([raised, middle]), np.arange(18).reshape(-1, 3)
    ).rms_regions
    assert regions["outer"] == pytest.approx(100 * 0.1 / model.diagonal, rel=1e-6)
    assert regions["middle"] == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize(
    ("ours", "other", "expected"),
    [(1.0, 2.0, 0.5), (1e-12, 1e-11, 1.0), (1e-12, 1.0, 0.0), (1.0, 1e-12, math.inf)],
)
def test_ratios_of_nothing(ours: float, other: float, expected: float) -> None:
    assert tables.ratio(ours, other, least=1e-9) == expected


def test_markdown_has_every_cell(tmp_path: Path) -> None:
    table = tables.table("Title", ("mesh", "RMS"), [("cow", "0.1"), ("bunny", "0.2")])
    tables.save_markdown(tmp_path / "deep/table.md", "Heading", ["A note."], [table])
    text = (tmp_path / "deep/table.md").read_text(encoding="utf-8")
    lines = [line.replace(" ", "") for line in text.splitlines()]
    assert {"#Heading", "Anote.", "##Title", "|mesh|RMS|", "|cow|0.1|", "|bunny|0.2|"} <= set(lines)


@pytest.mark.parametrize("artist", [picture, sketch], ids=lambda module: module.__name__)
def test_the_picture_shows_each_panel(tmp_path: Path, artist: ModuleType) -> None:
    """A mesh in the left panel only: ink on the left, background on the right."""
    from matplotlib.image import imread

    vertices, faces = read_mesh(COW)
    elsewhere = vertices + (0, 0, 100)
    panels = [Panel(vertices, faces, "", ""), Panel(elsewhere, faces, "", "")]
    artist.draw(tmp_path / "two.png", [(View((1.0, 0.0, 0.0)), panels)])
    image = imread(tmp_path / "two.png")
    left, right = np.split(image, 2, axis=1)
    assert np.ptp(left) > 0.3
    assert np.ptp(right, axis=(0, 1)).max() == 0
