# SPDX-License-Identifier: GPL-3.0-or-later
"""The measures see what they are for: each on a mesh with and without the flaw."""

import numpy as np
import pytest
from drawn_meshes import TETRAHEDRON, mesh_set, sheet, sphere, tube
from measures import (
    Surface,
    Topology,
    flipped_faces,
    folded_edges,
    non_manifold_edges,
    rms_distance,
    surface,
    topology,
)


def drawn(shape):
    return surface(mesh_set(*shape))


@pytest.mark.parametrize(
    ("shape", "expected"),
    [
        (sheet(), Topology(euler=1, components=1, boundary_loops=1, oriented_manifold=True)),
        (sphere(), Topology(euler=2, components=1, boundary_loops=0, oriented_manifold=True)),
        (tube(), Topology(euler=0, components=1, boundary_loops=2, oriented_manifold=True)),
    ],
    ids=["sheet", "sphere", "tube"],
)
def test_topology(shape, expected):
    assert topology(drawn(shape)) == expected


def test_reversed_face_is_no_oriented_manifold():
    vertices, faces = sphere()
    faces[5] = faces[5, ::-1]
    assert not topology(drawn((vertices, faces))).oriented_manifold


def test_fin_is_not_manifold():
    vertices, faces = (np.array(part) for part in TETRAHEDRON)
    fin = drawn((np.vstack([vertices, [[2, 2, 2]]]), np.vstack([faces, [[0, 1, 4]]])))
    assert (non_manifold_edges(drawn(TETRAHEDRON)), non_manifold_edges(fin)) == (0, 1)
    assert not topology(fin).oriented_manifold


def test_inverted_cap_is_flipped_and_folded():
    """One vertex of a sphere pulled sideways past its neighbours folds faces over others."""
    smooth = drawn(sphere())
    assert (flipped_faces(smooth, smooth), folded_edges(smooth)) == (0, 0)
    vertices = smooth.vertices.copy()
    centre = smooth.faces[100, 0]
    vertices[centre] += 3 * (vertices[smooth.faces[100, 1]] - vertices[centre])
    folded = Surface(vertices, smooth.faces)
    assert flipped_faces(smooth, folded) > 0
    assert folded_edges(folded) > 0


def test_distance_of_offset_spheres():
    small, large = drawn(sphere(1.0)), drawn(sphere(1.1))
    assert rms_distance(small, large) * small.diagonal == pytest.approx(0.1, rel=0.01)
    assert rms_distance(small, small) == pytest.approx(0, abs=1e-9)
