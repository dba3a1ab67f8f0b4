# SPDX-License-Identifier: GPL-3.0-or-later
"""Vertex clustering in PyMeshLab."""

import numpy as np
import pymeshlab
import pytest
from samples import CLUSTER, load

REPRESENTATIVES = ("Quadric", "Mean", "WeightedMean", "Median", "CellCenter")


def clustered(**parameters):
    """The cow and what the filter returned."""
    meshes = load("cow.obj")
    return meshes, getattr(meshes, CLUSTER)(**parameters)


@pytest.mark.parametrize("representative", REPRESENTATIVES)
def test_moves_no_vertex_further_than_a_cell(representative):
    cow = load("cow.obj")
    original = cow.current_mesh().vertex_matrix()
    meshes, result = clustered(cellsize=pymeshlab.PercentageValue(4), representative=representative)
    size = 0.04 * np.linalg.norm(original.max(axis=0) - original.min(axis=0))
    assert 0 < result["largest_move"] <= result["cell_size"] * (1 + 1e-12)
    assert result["cell_size"] <= size * (1 + 1e-5)
    for vertex in meshes.current_mesh().vertex_matrix():
        assert np.min(np.linalg.norm(original - vertex, axis=1)) <= size * (1 + 1e-5)


def test_reaches_a_number_of_faces():
    meshes, result = clustered(targetfacenum=1000)
    assert abs(result["faces"] - 1000) <= 20
    assert meshes.current_mesh().face_number() == result["faces"]


def test_leaves_what_is_not_selected():
    meshes = load("cow.obj")
    meshes.compute_selection_by_condition_per_face(condselect="(x0+x1+x2) < 0")
    before = meshes.current_mesh()
    outside = before.face_matrix()[~before.face_selection_array()]
    corners = {tuple(np.sort(c, axis=0).ravel()) for c in before.vertex_matrix()[outside]}
    assert corners
    faces = before.face_number()
    getattr(meshes, CLUSTER)(cellsize=pymeshlab.PercentageValue(4), selected=True)
    after = meshes.current_mesh()
    kept = {tuple(np.sort(c, axis=0).ravel()) for c in after.vertex_matrix()[after.face_matrix()]}
    assert corners <= kept
    assert after.face_number() < faces


def test_refuses_a_cell_of_no_size():
    with pytest.raises(pymeshlab.PyMeshLabException, match="cellsize"):
        clustered(cellsize=pymeshlab.PercentageValue(0))
