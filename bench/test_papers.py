# SPDX-License-Identifier: GPL-3.0-or-later
"""What the scripts under papers/ share: the measure, its pictures, the tables of sources."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import paper_script
import pymeshlab
import pytest
import tables
from decimators import DEFAULT_PLUGIN, meshlab
from error_picture import Shown, as_input, close_up, draw_errors, finely, scale_end, with_errors
from layer_error import ErrorMeter, measure, meter_of, region_rms
from meshes import shipped
from models import Model
from panels import View
from paper_script import Script, Study
from picture import COLOR_MAP
from PIL import Image
from printed import LOST, NO_MESH, NOT_PRINTED, NOTHING, Row, beside, instead
from surface import Surface
from workers import FilterError

SQUARE = np.array([(0, 0, 0), (3, 0, 0), (3, 4, 0), (0, 4, 0)], float)  # of diagonal 5
HALVES = np.array([(0, 1, 2), (0, 2, 3)])
EVERY = (0.0, 1.0)
HEAD = [(EVERY, (0.55, 1.0), (0.76, 1.0))]
NOISE = 0.02  # of the judge's random samples, relative


@pytest.fixture(scope="module")
def cow() -> Model:
    return Model("cow", shipped("cow.obj"), {"head": HEAD})


@pytest.fixture(scope="module")
def small_cow(cow: Model):
    """The cow at 1,160 faces, by MeshLab's filter, and how far it is."""
    return measure(DEFAULT_PLUGIN, cow, 1160, [meshlab()])["MeshLab"]


# --- the measure ----------------------------------------------------------------------------------


def test_distances_are_in_per_cent_of_the_diagonal() -> None:
    error = ErrorMeter(DEFAULT_PLUGIN, SQUARE, HALVES)(SQUARE + (0, 0, 0.1), HALVES)
    for distance in (error.rms, error.mean, error.max, error.rms_of_original, error.rms_salient):
        assert distance == pytest.approx(2)
    assert error.at_original == pytest.approx([2, 2, 2, 2])
    assert error.flipped == error.intersecting == error.parts_gained == error.holes_gained == 0


def test_the_diagonal_may_be_that_of_something_larger() -> None:
    meter = ErrorMeter(DEFAULT_PLUGIN, SQUARE, HALVES, diagonal=10)
    assert meter(SQUARE + (0, 0, 0.1), HALVES).rms == pytest.approx(1)


def test_vertices_of_no_face_do_not_count() -> None:
    more = np.concatenate([SQUARE, [(0, 0, 50)]])
    error = ErrorMeter(DEFAULT_PLUGIN, more, HALVES, diagonal=5)(SQUARE + (0, 0, 0.1), HALVES)
    assert error.at_original == pytest.approx([2, 2, 2, 2])


def test_the_filter_and_the_judge_say_the_same(cow: Model, small_cow) -> None:
    """Both of the whole; `tests/host` compares them on more meshes."""
    judged = cow.judge(small_cow.outcome.vertices, small_cow.outcome.faces)
    error = small_cow.error
    assert error.rms == pytest.approx(judged.rms, rel=NOISE)
    assert error.mean == pytest.approx(judged.mean, rel=NOISE)
    assert error.max == pytest.approx(judged.max, rel=NOISE)
    assert error.rms_of_original == pytest.approx(judged.rms_original_to_simplified, rel=NOISE)
    assert error.rms_salient == pytest.approx(judged.rms_salient, rel=2 * NOISE)
    assert error.normal_deviation == pytest.approx(judged.ndev, rel=NOISE)
    assert error.flipped == pytest.approx(judged.flipped, abs=1)


def test_the_filter_and_the_judge_say_the_same_of_a_region(cow: Model, small_cow) -> None:
    outcome = small_cow.outcome
    judged = cow.judge(outcome.vertices, outcome.faces)
    there = region_rms(DEFAULT_PLUGIN, cow, "head", outcome)
    assert there == pytest.approx(judged.rms_regions["head"], rel=NOISE)
    assert there != pytest.approx(judged.rms, rel=NOISE)


def test_a_part_has_the_faces_whose_middle_is_inside(cow: Model) -> None:
    vertices, faces = cow.part("head")
    middles = vertices[faces].mean(axis=1)
    low, size = cow.vertices.min(axis=0), np.ptp(cow.vertices, axis=0)
    assert (middles[:, 1:] >= low[1:] + (0.55, 0.76) * size[1:]).all()
    assert 100 < len(faces) < len(cow.faces) / 2
    assert len(np.unique(faces)) == len(vertices)


# --- its pictures ---------------------------------------------------------------------------------


def test_colours_are_those_of_the_filter() -> None:
    """Of a ramp on which every colour is."""
    ramp, flat = Surface(SQUARE, HALVES), Surface(SQUARE, HALVES)
    vertices, faces = finely(ramp.vertices, ramp.faces, least=2000)
    ErrorMeter(DEFAULT_PLUGIN, SQUARE, HALVES)  # loads the filter
    layers = pymeshlab.MeshSet(verbose=False)
    layers.add_mesh(pymeshlab.Mesh(flat.vertices, flat.faces.astype("int32")))
    raised = vertices + np.outer(vertices[:, 0], (0, 0, 0.01))
    layers.add_mesh(pymeshlab.Mesh(raised, faces.astype("int32")))
    told = layers.apply_filter("get_simplification_error", savequality=True, relativeto="MeshUnit")
    mesh = layers.mesh(1)
    ours = COLOR_MAP(mesh.vertex_scalar_array() / told["scale_end"])
    assert np.abs(ours[:, :3] - mesh.vertex_color_matrix()[:, :3]).max() < 0.02
    assert np.ptp(ours[:, :3], axis=0).min() > 0.9


def test_finer_faces_are_the_same_surface_also_where_three_share_an_edge() -> None:
    fin = np.concatenate([SQUARE, [(0, 0, 1)]])
    three = np.concatenate([HALVES, [(0, 2, 4)]])
    vertices, faces = finely(fin, three, least=100)
    assert len(faces) == 192
    surface = Surface(vertices, faces)
    directed = surface.areas[:, None] * surface.normals
    assert directed.sum(axis=0) == pytest.approx((2, -1.5, 12))  # none is turned over
    assert surface.areas.sum() == pytest.approx(12 + 2.5)
    assert np.abs(Surface(fin, three).closest(vertices).distance).max() < 1e-12
    assert np.count_nonzero(surface.edge_uses == 3) == 8


def test_the_scale_is_one_for_a_row_and_leaves_out_a_hundredth() -> None:
    def shown(errors) -> Shown:
        return Shown(SQUARE, HALVES, "", "", of_original=np.asarray(errors))

    rows = [as_input(SQUARE, HALVES, ""), shown(np.arange(101.0)), shown([0.0, 1.0])]
    assert scale_end(rows) == pytest.approx(99)


def test_a_row_shows_the_input_and_the_errors_of_the_result(tmp_path: Path) -> None:
    """Half of the result is where the input is, half is off: both ends of the scale are there."""
    ends = np.concatenate([SQUARE, SQUARE[[1, 2]] + (0.01, 0, 1), SQUARE[[1, 2]] + (3, 0, 1)])
    bent = np.concatenate([HALVES, [(4, 6, 7), (4, 7, 5)]])
    flat = np.concatenate([SQUARE, SQUARE[[1, 2]] + (3, 0, 0)])
    both = np.concatenate([HALVES, [(1, 4, 5), (1, 5, 2)]])
    meter = ErrorMeter(DEFAULT_PLUGIN, flat, both)
    row = [as_input(flat, both, "input"), with_errors(meter, ends, bent, "result")]
    draw_errors(tmp_path / "row.png", [(View((0.0, 0.0, 1.0)), row)])
    with Image.open(tmp_path / "row.png") as image:
        left, right = np.split(np.asarray(image.convert("RGB")).astype(int)[100:250], 2, axis=1)
    assert _is_there(right, 0) > 1000 < _is_there(right, 2)
    assert _is_there(left, 0) == _is_there(left, 2) == 0


def _is_there(pixels: np.ndarray, channel: int) -> int:
    """How many pixels have this colour alone."""
    others = np.delete(pixels, channel, axis=2).max(axis=2)
    return int(np.count_nonzero(pixels[:, :, channel] - others > 100))


def test_a_close_up_has_what_is_in_the_region(cow: Model, small_cow) -> None:
    shown = close_up(DEFAULT_PLUGIN, cow, "head", small_cow.outcome, "head")
    assert 0 < len(shown.faces) < len(small_cow.outcome.faces) / 2
    assert len(shown.of_fine) == len(shown.fine[0])
    whole = meter_of(DEFAULT_PLUGIN, cow)(small_cow.outcome.vertices, small_cow.outcome.faces)
    assert shown.of_original.max() <= whole.max * (1 + 1e-9)


# --- tables of sources ----------------------------------------------------------------------------


def test_what_is_not_to_be_had_stands_in_its_row() -> None:
    rows = [
        Row("bones", (LOST, "0.5"), instead("bone"), ("0.1",)),
        Row("heart", (NOT_PRINTED, "0.6")),
    ]
    table = beside("Title", ("max", "mean"), ("max",), rows)
    lines = [
        line.strip("|").split("|") for line in tables.markdown(table).split("\n") if "|" in line
    ]
    headings, _, bones, heart = ([cell.strip() for cell in line] for line in lines)
    assert headings == ["their mesh", "max, printed", "mean, printed", "our mesh", "max, ours"]
    assert bones == ["bones", LOST, "0.5", "bone, in its place", "0.1"]
    assert heart == ["heart", NOT_PRINTED, "0.6", NO_MESH, NOTHING]


# --- scripts --------------------------------------------------------------------------------------


def table(title: str):
    return tables.table(title, ("mesh",), [("cow",)])


def script(holds: bool = True) -> Script:
    study = Study([table("errors")], holds, lambda: [])
    doc = "What it does.\n\nMore."
    return Script("papers/some.py", doc, "Some", lambda _: study, lambda _: [table("times")])


@pytest.fixture
def saved(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where results go; pictures are not drawn."""
    monkeypatch.setattr(paper_script, "_RESULTS", tmp_path)
    monkeypatch.setattr(paper_script, "draw_errors", lambda path, rows: None)
    return tmp_path


def call(monkeypatch: pytest.MonkeyPatch, which: Script, *arguments: str) -> int:
    monkeypatch.setattr(sys, "argv", ["some.py", *arguments])
    return which.main()


@pytest.mark.parametrize("holds", [True, False])
def test_the_exit_code_is_the_verdict(monkeypatch, saved: Path, holds: bool) -> None:
    assert call(monkeypatch, script(holds)) == (0 if holds else 1)
    assert not list(saved.iterdir())


def test_times_are_kept_apart_from_errors(monkeypatch, saved: Path) -> None:
    assert call(monkeypatch, script(), "--save") == 0
    assert call(monkeypatch, script(), "--save", "--times") == 0
    errors, times = (saved / name for name in ("some.md", "some-times.md"))
    assert "## errors" in errors.read_text(encoding="utf-8")
    assert "## times" in times.read_text(encoding="utf-8")
    assert "`python bench/papers/some.py --times --save`" in times.read_text(encoding="utf-8")


def test_a_filter_that_fails_ends_with_its_reason(monkeypatch, capsys) -> None:
    def study(_: Path) -> Study:
        raise FilterError("nobody on cow.obj")

    failing = Script("some.py", "What it does.", "Some", study)
    assert call(monkeypatch, failing) == 1
    assert "nobody on cow.obj" in capsys.readouterr().out
