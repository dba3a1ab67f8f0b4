# SPDX-License-Identifier: GPL-3.0-or-later
"""PairDistance joins parts that are closer, and says so."""

import itertools

import igl
import numpy as np
import pymeshlab
import pytest
from drawn_meshes import mesh_set, sheet, sphere
from measures import surface, topology
from samples import DECIMATE

GAP = 0.2
SIDE = 3  # balls along every edge of a cube


def balls():
    """Balls of radius 1 in a cube, GAP apart."""
    vertices, faces = sphere(subdivisions=2)
    places = (2 + GAP) * np.array(list(itertools.product(range(SIDE), repeat=3)))
    moved = [vertices + place for place in places]
    numbered = [faces + i * len(vertices) for i in range(len(places))]
    return mesh_set(np.vstack(moved), np.vstack(numbered))


def two_sheets():
    """Waved sheets, GAP / 100 above each other."""
    vertices, faces = sheet(16, lambda x, y: 0.1 * np.sin(7 * x) * np.cos(6 * y))
    above = vertices + (0, 0, GAP / 100)
    return mesh_set(np.vstack([vertices, above]), np.vstack([faces, faces + len(vertices)]))


def parts(meshes):
    """Parts that share no vertex."""
    return len(np.unique(igl.vertex_components(surface(meshes).faces)))


def decimated(meshes, **options):
    return getattr(meshes, DECIMATE)(**options)


def test_small_parts_join_where_none_may_vanish():
    target = 2 * SIDE**3
    alone, joined = balls(), balls()
    report = decimated(alone, targetfacenum=target, preservetopology=True)
    assert report["stopped_by"] == "nothing left to collapse"
    assert "pairs_contracted" not in report
    assert parts(alone) == SIDE**3
    report = decimated(joined, targetfacenum=target, pairdistance=pymeshlab.PureValue(3 * GAP))
    assert report["stopped_by"] == "target"
    assert report["pairs_contracted"] >= SIDE**3 - 1
    assert joined.current_mesh().face_number() <= target
    assert parts(joined) == 1


@pytest.mark.parametrize(("factor", "expected"), [(1.5, 1), (0.9, 2)])
def test_sheets_join_if_they_are_closer(factor, expected):
    meshes = two_sheets()
    distance = pymeshlab.PureValue(factor * GAP / 100)
    report = decimated(meshes, targetfacenum=300, pairdistance=distance)
    assert parts(meshes) == expected
    assert (report["pairs_contracted"] > 0) == (expected == 1)


def test_distance_may_be_given_in_per_cent_of_the_diagonal():
    diagonal = balls().current_mesh().bounding_box().diagonal()
    results = []
    for distance in (0.04 * diagonal, 4):
        meshes = balls()
        value = pymeshlab.PercentageValue(4) if distance == 4 else pymeshlab.PureValue(distance)
        decimated(meshes, targetfacenum=60, pairdistance=value)
        results.append(meshes.current_mesh().vertex_matrix())
    assert np.array_equal(*results)


def test_none_is_the_default():
    results = []
    for options in ({}, {"pairdistance": pymeshlab.PureValue(0)}):
        meshes = balls()
        decimated(meshes, targetperc=0.3, **options)
        results.append(surface(meshes))
    assert np.array_equal(results[0].vertices, results[1].vertices)
    assert topology(results[0]) == topology(surface(balls()))
