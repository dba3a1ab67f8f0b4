# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature Importance on surfaces whose curvature is known."""

import numpy as np
import pytest
from drawn_meshes import mesh_set, sheet, sphere, tube
from samples import IMPORTANCE

RADII = pytest.mark.parametrize("radius", [0.5, 1.0, 30.0])
TYPICAL = 0.03  # discretisation error allowed for the median vertex, relative


def importance(shape, **options):
    meshes = mesh_set(*shape)
    meshes.apply_filter(IMPORTANCE, alphaunits="ModelUnits", **{"output": "Curvature", **options})
    return meshes


def quality(shape, **options):
    meshes = importance(shape, **options)
    return meshes.current_mesh().vertex_scalar_array()


def inner_quality(shape, **options):
    """Quality away from both ends of a tube."""
    heights = shape[0][:, 2]
    inner = np.abs(heights / heights.max() - 0.5) < 0.4
    return quality(shape, **options)[inner]


@RADII
def test_absolute_curvature_of_a_sphere(radius):
    values = quality(sphere(radius), curvaturekind="Absolute")
    assert np.median(values) == pytest.approx(2 / radius, rel=TYPICAL)


@RADII
def test_gaussian_curvature_of_a_sphere(radius):
    values = quality(sphere(radius), curvaturekind="Gaussian")
    assert np.median(values) == pytest.approx(1 / radius**2, rel=TYPICAL)


@RADII
def test_curvature_of_a_cylinder(radius):
    shape = tube(radius, length=4 * radius)
    absolute = inner_quality(shape, curvaturekind="Absolute")
    gaussian = inner_quality(shape, curvaturekind="Gaussian")
    assert np.median(absolute) == pytest.approx(1 / radius, rel=TYPICAL)
    assert np.abs(gaussian).max() < 1e-6 / radius**2


@pytest.mark.parametrize("kind", ["Absolute", "Gaussian"])
def test_plane_has_none(kind):
    """Away from its corners, where the formula sees the turn of the boundary."""
    inner = np.abs(sheet()[0][:, :2] - 0.5).max(axis=1) < 0.49
    assert np.abs(quality(sheet(), curvaturekind=kind)[inner]).max() < 1e-5


@pytest.mark.parametrize("alpha", [0.1, 2.0])
def test_factor_is_the_papers(alpha):
    options = {"curvaturekind": "Gaussian", "alpha": alpha}
    curvature = quality(sphere(), **options)
    factor = quality(sphere(), output="Factor", **options)
    assert factor == pytest.approx(1 - np.exp(-alpha * curvature), rel=1e-9)


def test_scale_free_factor_does_not_know_the_scale():
    small, large = (mesh_set(*tube(radius, length=4 * radius)) for radius in (1.0, 1024.0))
    for meshes in (small, large):
        meshes.apply_filter(IMPORTANCE, output="Factor", alphaunits="ScaleFree")
    values = small.current_mesh().vertex_scalar_array()
    assert np.array_equal(values, large.current_mesh().vertex_scalar_array())
    assert 0 < values.min() <= values.max() <= 1


def test_geometry_stays_and_colour_shows_the_quality():
    bent = tube(along=32)
    bent[0][:, 0] += bent[0][:, 2] ** 2 / 8
    meshes = importance(bent, curvaturekind="Absolute")
    mesh = meshes.current_mesh()
    assert np.array_equal(mesh.vertex_matrix(), bent[0])
    assert np.array_equal(mesh.face_matrix(), bent[1])
    assert len(np.unique(mesh.vertex_color_matrix(), axis=0)) > 10
