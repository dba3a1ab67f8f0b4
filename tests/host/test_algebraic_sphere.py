# SPDX-License-Identifier: GPL-3.0-or-later
"""Edge collapse by algebraic spheres in PyMeshLab."""

import itertools

import numpy as np
import pymeshlab
import pytest
from drawn_meshes import bumpy_sheet, mesh_set
from measures import flipped_faces, rms_distance, surface, topology
from pymeshlab_curvdecim.description import read_filters
from samples import SPHERES, load

CHOICES = {
    each.python_name: each.values for each in read_filters()[SPHERES].parameters if each.values
}
CELLS, TARGET = 16, 150


@pytest.mark.parametrize("values", list(itertools.product(*CHOICES.values())), ids="-".join)
def test_combination(values):
    meshes = mesh_set(*bumpy_sheet(CELLS))
    original = surface(meshes)
    report = getattr(meshes, SPHERES)(
        targetfacenum=TARGET, **dict(zip(CHOICES, values, strict=True))
    )
    result = surface(meshes)
    assert report["faces"] == len(result.faces)
    assert len(result.faces) in (TARGET, TARGET - 1)
    assert topology(result) == topology(original)
    assert flipped_faces(original, result) == 0
    assert rms_distance(original, result) < 0.03


# Each option must do something: a value and settings for which it changes the result.
EFFECTIVE = {
    "kernelscale": (5.0, {}),
    "adaptivekernel": (False, {}),
    "energy": ("Poster", {}),
    "placement": ("OnSphereAlongEdge", {}),
    "refinesweeps": (1, {}),
    "featureangle": (5.0, {}),
    "boundaryweight": (100.0, {}),
    "maxerror": (pymeshlab.PercentageValue(0.5), {"targetfacenum": 0}),
    "targetvertnum": (1000, {"targetperc": 0.0}),
}


@pytest.mark.parametrize("name", EFFECTIVE)
def test_option_has_an_effect(name):
    value, setting = EFFECTIVE[name]
    results = []
    for options in ({}, {name: value}):
        meshes = load("cow.obj")
        meshes.apply_filter(SPHERES, **{"targetperc": 0.4, **setting, **options})
        results.append(meshes.current_mesh().vertex_matrix())
    assert not np.array_equal(*results)


def test_promised_error_is_kept():
    meshes = load("cow.obj")
    original = surface(meshes)
    report = getattr(meshes, SPHERES)(targetfacenum=0, maxerror=pymeshlab.PercentageValue(0.5))
    assert report["stopped_by"] == "error bound"
    assert report["max_error"] <= 0.005 * original.diagonal * (1 + 1e-5)
    assert rms_distance(original, surface(meshes)) <= report["max_error"]
