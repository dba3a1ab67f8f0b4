# SPDX-License-Identifier: GPL-3.0-or-later
"""The same input and parameters give the same bits, whatever happened before."""

import numpy as np
import pytest
from drawn_meshes import bumpy_sheet, mesh_set
from samples import DECIMATE, load

FRACTION = 0.1


def cow(scale=1.0, **options):
    """Vertices and faces of the decimated cow."""
    meshes = load("cow.obj")
    mesh = meshes.current_mesh()
    meshes = mesh_set(mesh.vertex_matrix() * scale, mesh.face_matrix())
    meshes.apply_filter(DECIMATE, **{"targetperc": FRACTION, **options})
    return meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix()


def assert_same_bits(one, other):
    assert np.array_equal(one[0], other[0])
    assert np.array_equal(one[1], other[1])


def test_second_call_equals_the_first_after_other_calls():
    first = cow()
    others = {"metric": "CurvatureAdditive", "placement": "HalfEdge", "preset": "Custom"}
    decimated = cow(**others, preservenormal=False, featureangle=180.0, alpha=3.0)
    assert not np.array_equal(first[0], decimated[0])
    mesh_set(*bumpy_sheet()).apply_filter(DECIMATE, targetfacenum=20, boundaryweight=9.0)
    assert_same_bits(first, cow())


@pytest.mark.parametrize("threads", [1, 2, 3])
def test_threads_do_not_change_the_result(threads):
    assert_same_bits(cow(), cow(threads=threads))


@pytest.mark.parametrize("exponent", [-60, -7, 1, 60])
def test_scaling_by_a_power_of_two_scales_the_bits(exponent):
    vertices, faces = cow()
    assert_same_bits((vertices * 2.0**exponent, faces), cow(scale=2.0**exponent))
