# SPDX-License-Identifier: GPL-3.0-or-later
"""With a selection only the selected faces change; the rest stays to the bit."""

import numpy as np
import pytest
from measures import surface, topology
from samples import DECIMATE, STEPWISE, load

CONDITION = "x0 + x1 + x2 > 0"


def corners(mesh, selected):
    """Corner coordinates of the faces of that selection state, each face from its least corner."""
    faces = mesh.face_matrix()[mesh.face_selection_array() == selected]
    rows = mesh.vertex_matrix()[faces]
    first = np.array([min(range(3), key=lambda k: tuple(row[k])) for row in rows])
    rolled = [np.roll(row, -k, axis=0).ravel() for row, k in zip(rows, first, strict=True)]
    return {tuple(row) for row in rolled}


@pytest.fixture
def half_cow():
    meshes = load("cow.obj")
    meshes.compute_selection_by_condition_per_face(condselect=CONDITION)
    return meshes


@pytest.mark.parametrize("name", STEPWISE)
@pytest.mark.parametrize("options", [{}, {"selected": True}])
def test_unselected_faces_stay_to_the_bit(half_cow, name, options):
    mesh = half_cow.current_mesh()
    kept, before = corners(mesh, selected=False), topology(surface(half_cow))
    half_cow.apply_filter(name, targetperc=0.5, **options)
    after = corners(mesh, selected=False) | corners(mesh, selected=True)
    assert kept <= after
    assert topology(surface(half_cow)) == before


@pytest.mark.parametrize("name", STEPWISE)
def test_target_counts_selected_faces(half_cow, name):
    mesh = half_cow.current_mesh()
    total, selected = mesh.face_number(), mesh.selected_face_number()
    half_cow.apply_filter(name, targetfacenum=selected // 2)
    assert mesh.selected_face_number() in (selected // 2, selected // 2 - 1)
    assert mesh.face_number() == total - selected + mesh.selected_face_number()


def test_selection_can_be_ignored(half_cow):
    mesh = half_cow.current_mesh()
    kept = corners(mesh, selected=False)
    half_cow.apply_filter(DECIMATE, targetperc=0.5, selected=False)
    assert mesh.face_number() == 2902
    assert not kept <= corners(mesh, selected=False) | corners(mesh, selected=True)
