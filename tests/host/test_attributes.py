# SPDX-License-Identifier: GPL-3.0-or-later
"""Attributes survive: those affine in position stay affine in position."""

import numpy as np
import pytest
from drawn_meshes import bumpy_sheet, mesh_set
from samples import STEPWISE

RED, BLUE = (1.0, 0.0, 0.0, 1.0), (0.0, 0.0, 1.0, 1.0)
COLOUR_STEP = 1 / 255  # PyMeshLab stores 8 bits a channel
ALLOWED = 0.01  # of an attribute's range
CELLS = 24


def affine(points, columns):
    """Columns of affine functions of position with values in about 0.1 ... 0.9."""
    gradients = np.array([[0.5, 0.2, -0.1], [-0.3, 0.4, 0.3], [0.2, 0.3, 0.5], [0.4, -0.3, 0.2]])
    offsets = np.array([0.15, 0.45, 0.2, 0.45])
    return points @ gradients[:columns].T + offsets[:columns]


@pytest.fixture(params=STEPWISE)
def decimated_sheet(request):
    """The sheet with these attributes, by each filter."""

    def decimated(**attributes):
        meshes = mesh_set(*bumpy_sheet(CELLS), **attributes)
        meshes.apply_filter(request.param, targetperc=0.25)
        return meshes

    return decimated


def assert_affine(values, points, step=0.0):
    expected = affine(points, values.shape[1])
    allowed = ALLOWED * np.ptp(expected, axis=0) + step
    assert (np.abs(values - expected) <= allowed).all()


@pytest.fixture
def vertices():
    return bumpy_sheet(CELLS)[0]


@pytest.fixture
def left_faces():
    """Which faces lie in the left half."""
    vertices, faces = bumpy_sheet(CELLS)
    return vertices[faces].mean(axis=1)[:, 0] < 0.5


def test_vertex_colour(decimated_sheet, vertices):
    meshes = decimated_sheet(v_color_matrix=affine(vertices, 4))
    mesh = meshes.current_mesh()
    assert_affine(mesh.vertex_color_matrix(), mesh.vertex_matrix(), COLOUR_STEP)


def test_vertex_quality(decimated_sheet, vertices):
    meshes = decimated_sheet(v_scalar_array=affine(vertices, 1)[:, 0])
    mesh = meshes.current_mesh()
    assert_affine(mesh.vertex_scalar_array()[:, None], mesh.vertex_matrix())


def test_vertex_texture_coordinates(decimated_sheet, vertices):
    meshes = decimated_sheet(v_tex_coords_matrix=affine(vertices, 2))
    mesh = meshes.current_mesh()
    assert_affine(mesh.vertex_tex_coord_matrix(), mesh.vertex_matrix())


def test_wedge_texture_coordinates(decimated_sheet, vertices):
    corners = bumpy_sheet(CELLS)[1].ravel()
    meshes = decimated_sheet(w_tex_coords_matrix=affine(vertices[corners], 2))
    mesh = meshes.current_mesh()
    points = mesh.vertex_matrix()[mesh.face_matrix().ravel()]
    assert_affine(mesh.wedge_tex_coord_matrix(), points)


def test_face_colour(decimated_sheet, left_faces):
    meshes = decimated_sheet(f_color_matrix=np.where(left_faces[:, None], RED, BLUE))
    mesh = meshes.current_mesh()
    centres = mesh.vertex_matrix()[mesh.face_matrix()].mean(axis=1)[:, 0]
    colours = mesh.face_color_matrix()
    assert (colours[centres < 0.4] == RED).all()
    assert (colours[centres > 0.6] == BLUE).all()


def test_face_quality(decimated_sheet, left_faces):
    meshes = decimated_sheet(f_scalar_array=np.where(left_faces, 7.0, -2.0))
    mesh = meshes.current_mesh()
    centres = mesh.vertex_matrix()[mesh.face_matrix()].mean(axis=1)[:, 0]
    assert (mesh.face_scalar_array()[centres < 0.4] == 7).all()
    assert (mesh.face_scalar_array()[centres > 0.6] == -2).all()


def test_normals_belong_to_the_result(decimated_sheet):
    meshes = decimated_sheet()
    mesh = meshes.current_mesh()
    a, b, c = (mesh.vertex_matrix()[mesh.face_matrix()[:, k]] for k in range(3))
    expected = np.cross(b - a, c - a)
    expected /= np.linalg.norm(expected, axis=1)[:, None]
    assert np.allclose(mesh.face_normal_matrix(), expected)
    assert (directions_agree(mesh.vertex_normal_matrix(), summed(expected, mesh)) > 0.9).all()


def summed(values, mesh):
    """The sum of the values of the faces around each vertex."""
    around = np.zeros((mesh.vertex_number(), values.shape[1]))
    np.add.at(around, mesh.face_matrix(), values[:, None])
    return around


def directions_agree(one, other):
    """Cosines of the angles between rows."""
    lengths = np.linalg.norm(one, axis=1) * np.linalg.norm(other, axis=1)
    return np.einsum("ij,ij->i", one, other) / lengths


def test_bounding_box_belongs_to_the_result(decimated_sheet):
    meshes = decimated_sheet()
    mesh = meshes.current_mesh()
    assert np.array_equal(mesh.bounding_box().min(), mesh.vertex_matrix().min(axis=0))
    assert np.array_equal(mesh.bounding_box().max(), mesh.vertex_matrix().max(axis=0))
