# SPDX-License-Identifier: GPL-3.0-or-later
"""The meshes of the picture are what its page says, and its table has all rows."""

from __future__ import annotations

from pathlib import Path

import hard_meshes
import numpy as np
import pytest
import tables
from decimators import meshlab
from every_mesh_picture import HEADINGS, LEVELS, SCENES, table, trios
from judge import topology
from meshes import REPOSITORY, write_mesh
from models import Model
from shape import components
from surface import Surface

PAGE = REPOSITORY / "docs/every-mesh.md"


def volume(surface: Surface) -> float:
    """Positive where the faces look out."""
    a, b, c = surface.corners.swapaxes(0, 1)
    return float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6


@pytest.mark.parametrize(
    ("mesh", "parts", "tunnels"),
    [
        (hard_meshes.plate(1, 2), 1, 1),
        (hard_meshes.plate(3, 2), 1, 9),
        (hard_meshes.balls(12, 1), 12, 0),
        (hard_meshes.gear(6, 5), 1, 1),
        (hard_meshes.tree(0), 1, 0),
    ],
    ids=["cell", "plate", "balls", "gear", "trunk"],
)
def test_a_closed_mesh_is_a_manifold_with_its_parts_and_tunnels(
    mesh: hard_meshes.Mesh, parts: int, tunnels: int
) -> None:
    surface = Surface(*mesh)
    found = topology(surface)
    sound = ("zero_area", "nm_edges", "nm_vertices", "boundary", "dup_faces")
    assert {name: found[name] for name in sound} == dict.fromkeys(sound, 0)
    assert components(surface) == parts
    assert found["euler"] == 2 * parts - 2 * tunnels
    assert volume(surface) > 0


def test_the_volumes_are_those_of_the_solids() -> None:
    """Of a square plate with one round hole of radius 0.12; its outline is a polygon."""
    sides = 4 * 32
    hole = sides / 2 * np.sin(2 * np.pi / sides) * 0.12**2
    assert volume(Surface(*hard_meshes.plate(1, 32))) == pytest.approx(0.5 * (1 - hole), rel=1e-3)


def test_a_leaf_is_four_faces_and_touches_no_other() -> None:
    surface = Surface(*hard_meshes.tree(50))
    found = topology(surface)
    assert components(surface) == 51
    assert (found["nm_edges"], found["nm_vertices"], found["boundary"]) == (0, 0, 4 * 50)
    assert len(surface.faces) == 4 * 50 + len(hard_meshes.tree(0)[1])


def test_the_table_has_a_row_a_level_and_says_what_went(tmp_path: Path) -> None:
    """MeshLab's filter stands in for ours; it tells nothing, so that what went is made up."""
    write_mesh(tmp_path / "balls.ply", *hard_meshes.balls(6, 2))
    cases = list(trios(Model("balls", tmp_path / "balls.ply"), [meshlab()] * 3))
    cases[0].ours.outcome.report.update(parts_removed=3, holes_closed=2, handles_cut=1)
    lines = tables.markdown(table(cases)).strip().splitlines()
    rows = [[cell.strip() for cell in line.strip("| ").split("|")] for line in lines]
    assert rows[0] == list(HEADINGS)
    assert [row[:2] for row in rows[2:]] == [
        ["balls to 20%", "384 / 384"],
        ["balls to 5%", "96 / 96"],
        ["balls to 1%", "18 / 18"],
    ]
    assert [row[6] for row in rows[2:]] == ["3, 2, 1", "0, 0, 0", "0, 0, 0"]


def test_the_page_has_every_row_and_the_picture() -> None:
    text = PAGE.read_text(encoding="utf-8")
    rows = [line.strip("| ").split("|")[0].strip() for line in text.splitlines() if " / " in line]
    expected = [f"{name} to {level:.0%}" for name in SCENES for level in LEVELS]
    assert [row for row in rows if " to " in row] == expected
    assert all(scene.shown in LEVELS for scene in SCENES.values())
    assert (PAGE.parent / "images/every_mesh.png").is_file()
