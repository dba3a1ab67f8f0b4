# SPDX-License-Identifier: GPL-3.0-or-later
"""Every value of every choice runs, and every combination of the four that shape the cost."""

import itertools

import numpy as np
import pymeshlab
import pytest
from drawn_meshes import bumpy_sheet, mesh_set
from measures import flipped_faces, rms_distance, surface, topology
from pymeshlab_curvdecim.description import read_filters
from samples import DECIMATE, load

CHOICES = {
    each.python_name: each.values for each in read_filters()[DECIMATE].parameters if each.values
}
COMBINED = ("metric", "quadrics", "placement", "planeweight")
CELLS = 16
TARGET = 150


@pytest.mark.parametrize(
    "options",
    [{name: value} for name, values in CHOICES.items() for value in values],
    ids=lambda options: "-".join(*options.items()),
)
def test_single_choice(options):
    assert_good_result(**options)


@pytest.mark.parametrize(
    "values", list(itertools.product(*(CHOICES[name] for name in COMBINED))), ids="-".join
)
def test_combination(values):
    assert_good_result(preset="Custom", **dict(zip(COMBINED, values, strict=True)))


def assert_good_result(**options):
    meshes = mesh_set(*bumpy_sheet(CELLS))
    original = surface(meshes)
    meshes.apply_filter(DECIMATE, targetfacenum=TARGET, **options)
    result = surface(meshes)
    assert len(result.faces) in (TARGET, TARGET - 1)
    assert topology(result) == topology(original)
    assert flipped_faces(original, result) == 0
    assert rms_distance(original, result) < 0.01


@pytest.mark.parametrize("name", CHOICES)
def test_index_means_the_same_as_the_name(name):
    last = len(CHOICES[name]) - 1
    by_index, by_name = (mesh_set(*bumpy_sheet()) for _ in range(2))
    by_index.apply_filter(DECIMATE, **{name: last})
    by_name.apply_filter(DECIMATE, **{name: CHOICES[name][last]})
    assert np.array_equal(
        by_index.current_mesh().vertex_matrix(), by_name.current_mesh().vertex_matrix()
    )


def test_half_edge_keeps_original_vertices():
    vertices, faces = bumpy_sheet()
    meshes = mesh_set(vertices, faces)
    meshes.apply_filter(DECIMATE, targetperc=0.3, placement="HalfEdge", preset="Custom")
    kept = {tuple(row) for row in meshes.current_mesh().vertex_matrix()}
    assert kept < {tuple(row) for row in vertices}


def test_unknown_choice_is_refused():
    with pytest.raises(pymeshlab.InvalidEnumException, match="NoSuchMetric"):
        mesh_set(*bumpy_sheet()).apply_filter(DECIMATE, metric="NoSuchMetric")


# Each option must do something: a mesh and settings for which it changes the result.
EFFECTIVE = {
    "preserveboundary": (False, {}),
    "boundaryweight": (100.0, {}),
    "preservenormal": (False, {"targetperc": 0.02}),
    "normalangle": (30.0, {}),
    "preservetopology": (True, {"targetperc": 0.001}),
    "featureangle": (5.0, {}),
    "alpha": (5.0, {}),
    "curvaturefloor": (0.9, {}),
    "lambda_": (1.0, {"metric": "CurvatureAdditive"}),
    "curvaturekind": ("Gaussian", {}),
    "alphaunits": ("ModelUnits", {}),
    "curvatureterm": ("Literal", {"metric": "CurvatureAdditive"}),
    "metric": ("Quadric", {}),
    "quadrics": ("Accumulated", {"preset": "Custom"}),
    "planeweight": ("Unit", {"preset": "Custom"}),
    "placement": ("Line", {"preset": "Custom"}),
    "preset": ("Fast", {}),
}


@pytest.mark.parametrize("name", EFFECTIVE)
def test_option_has_an_effect(name):
    value, setting = EFFECTIVE[name]
    results = []
    for options in ({}, {name: value}):
        meshes = load("bunny10k_textured.obj")
        meshes.apply_filter(DECIMATE, **{"targetperc": 0.1, **setting, **options})
        results.append(meshes.current_mesh().vertex_matrix())
    assert not np.array_equal(*results)


def test_quality_protects():
    vertices, faces = bumpy_sheet(CELLS)
    important = vertices[:, 0] < 0.5
    meshes = mesh_set(vertices, faces, v_scalar_array=np.where(important, 1000.0, 1.0))
    meshes.apply_filter(DECIMATE, targetperc=0.3, qualityweight=True)
    left = (meshes.current_mesh().vertex_matrix()[:, 0] < 0.5).sum()
    assert left > 0.7 * meshes.current_mesh().vertex_number()
