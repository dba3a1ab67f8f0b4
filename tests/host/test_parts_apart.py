# SPDX-License-Identifier: GPL-3.0-or-later
"""PreventIntersections, judged by MeshLab's own filter for faces that cross."""

import numpy as np
import pymeshlab
import pytest
from drawn_meshes import mesh_set, sphere
from samples import DECIMATE, ERROR, SPHERES

COARSE = 0.05
TURN = 0.3  # radians between the shells, whose faces would be parallel otherwise


def joined(*parts):
    """A MeshSet of one mesh with these parts."""
    before = np.cumsum([0, *(len(vertices) for vertices, _ in parts)])
    faces = [corners + first for first, (_, corners) in zip(before, parts, strict=False)]
    return mesh_set(np.vstack([vertices for vertices, _ in parts]), np.vstack(faces))


def turned(vertices):
    cos, sin = np.cos(TURN), np.sin(TURN)
    return vertices @ np.array([[cos, sin, 0], [-sin, cos, 0], [0, 0, 1]])


def shells(wall=0.02):
    """A hollow ball, the wall as part of its radius."""
    vertices, faces = sphere()
    return joined((vertices, faces), (turned(vertices) * (1 - wall), faces[:, ::-1]))


def balls_in_each_other():
    vertices, faces = sphere()
    return joined((vertices, faces), (turned(vertices) + (0.9, 0.1, 0), faces))


def crossing_faces(meshes):
    meshes.compute_selection_by_self_intersections_per_face()
    count = meshes.current_mesh().selected_face_number()
    meshes.set_selection_none()
    return count


@pytest.mark.parametrize(
    ("name", "options"),
    [
        (DECIMATE, {"preset": "Fast"}),
        (DECIMATE, {}),
        (DECIMATE, {"preset": "Best"}),
        (SPHERES, {"refinesweeps": 2}),
    ],
)
def test_shells_stay_apart(name, options):
    meshes = shells()
    faces = meshes.current_mesh().face_number()
    report = meshes.apply_filter(name, targetperc=COARSE, preventintersections=True, **options)
    assert report["faces"] == COARSE * faces
    assert report["crossing"] == crossing_faces(meshes) == 0
    assert report["rejected_crossing"] > 0

    free = shells()
    assert "crossing" not in free.apply_filter(name, targetperc=COARSE, **options)
    assert crossing_faces(free) > 0


def test_shells_stay_apart_within_a_bound_that_is_wider_than_their_wall():
    bound = 0.05
    meshes = shells()
    report = meshes.apply_filter(
        DECIMATE,
        targetfacenum=0,
        maxerror=pymeshlab.PureValue(bound),
        preventintersections=True,
    )
    assert crossing_faces(meshes) == 0
    assert 0 < report["max_error"] <= bound


def test_what_crosses_before_may_go_on_to_and_is_counted():
    meshes = balls_in_each_other()
    before = crossing_faces(meshes)
    meshes.add_mesh(meshes.current_mesh())
    report = meshes.apply_filter(DECIMATE, targetperc=0.3, preventintersections=True)
    assert 0 < report["crossing"] == crossing_faces(meshes) <= before
    error = meshes.apply_filter(ERROR, originalmesh=0, simplifiedmesh=1, samplenum=1000)
    assert error["intersecting"] == report["crossing"]
