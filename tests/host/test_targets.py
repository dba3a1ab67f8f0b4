# SPDX-License-Identifier: GPL-3.0-or-later
"""When the decimation stops, and what it reports."""

import math

import numpy as np
import pytest
from drawn_meshes import bumpy_sheet, mesh_set, sphere
from samples import DECIMATE

REPORTED = {
    "faces_before",
    "faces",
    "vertices_before",
    "vertices",
    "stopped_by",
    "cost_last",
    "seconds",
}
REJECTED = {
    "rejected_" + reason
    for reason in (
        "link_condition",
        "normal_flip",
        "triangle_shape",
        "error_bound",
        "hub_at_rest",
        "texture_flip",
        "crossing",
    )
}


def decimated_sphere(**options):
    meshes = mesh_set(*sphere())
    report = getattr(meshes, DECIMATE)(**options)
    mesh = meshes.current_mesh()
    return mesh.face_number(), mesh.vertex_number(), report


def test_default_target_is_half_the_faces():
    faces, _, report = decimated_sphere()
    assert (report["faces_before"], faces) == (5120, 2560)


def test_target_of_faces():
    faces, _, _ = decimated_sphere(targetfacenum=700)
    assert faces == 700


def test_target_of_vertices():
    _, vertices, _ = decimated_sphere(targetvertnum=300, targetfacenum=0)
    assert vertices == 300


def test_fraction_wins_over_count():
    faces, _, _ = decimated_sphere(targetperc=0.25, targetfacenum=100)
    assert faces == 1280


def test_report_is_complete_and_true():
    faces, vertices, report = decimated_sphere(targetfacenum=700)
    assert set(report) >= REPORTED | REJECTED
    assert (report["faces_before"], report["vertices_before"]) == (5120, 2562)
    assert (report["faces"], report["vertices"]) == (faces, vertices)
    assert report["stopped_by"] == "target"
    assert report["cost_last"] > 0
    assert report["seconds"] > 0
    assert all(report[name] >= 0 for name in REJECTED)


def test_floor_is_reported_when_the_target_cannot_be_reached():
    faces, _, report = decimated_sphere(targetfacenum=1)
    assert report["stopped_by"] == "nothing left to collapse"
    assert 4 <= report["faces"] == faces < 100
    assert sum(report[name] for name in REJECTED) > 0


@pytest.mark.parametrize("options", [{"targetfacenum": 5000}, {"targetperc": 1.0}])
def test_target_above_the_count_changes_nothing(options):
    vertices, faces = bumpy_sheet()
    meshes = mesh_set(vertices, faces)
    report = getattr(meshes, DECIMATE)(**options)
    mesh = meshes.current_mesh()
    assert np.array_equal(mesh.vertex_matrix(), vertices)
    assert np.array_equal(mesh.face_matrix(), faces)
    assert report["faces"] == report["faces_before"] == len(faces)
    assert report["stopped_by"] == "target"
    assert math.isclose(report["cost_last"], 0)
