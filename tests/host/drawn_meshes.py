# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes drawn for the tests, as (vertices, faces)."""

import numpy as np
import pymeshlab


def mesh_set(vertices, faces=(), **attributes):
    """A MeshSet of one mesh; attributes are those of pymeshlab.Mesh."""
    meshes = pymeshlab.MeshSet(verbose=False)
    vertices = np.asarray(vertices, dtype=np.float64).reshape(-1, 3)
    faces = np.asarray(faces, dtype=np.int32).reshape(-1, 3)
    meshes.add_mesh(pymeshlab.Mesh(vertices, faces, **attributes))
    return meshes


def sheet(cells=12, height=lambda x, y: 0 * x):
    """A square of side 1 in cells x cells x 2 faces, lifted by height(x, y)."""
    x, y = (axis.ravel() for axis in np.meshgrid(*[np.linspace(0, 1, cells + 1)] * 2))
    corner = np.arange((cells + 1) ** 2).reshape(cells + 1, cells + 1)
    a, b, c, d = (part.ravel() for part in _cell_corners(corner))
    faces = np.vstack([np.column_stack([a, b, d]), np.column_stack([a, d, c])])
    return np.column_stack([x, y, height(x, y)]), faces


def _cell_corners(corner):
    return corner[:-1, :-1], corner[:-1, 1:], corner[1:, :-1], corner[1:, 1:]


def bumpy_sheet(cells=12):
    """An open sheet that no two vertices of share a height."""
    return sheet(cells, lambda x, y: 0.2 * np.sin(5 * x + 1) * np.cos(4 * y) + 0.05 * x * x)


def sphere(radius=1.0, subdivisions=4):
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.create_sphere(radius=radius, subdiv=subdivisions)
    mesh = meshes.current_mesh()
    return mesh.vertex_matrix(), mesh.face_matrix()


def tube(radius=1.0, length=4.0, around=96, along=64):
    """An open cylinder about z; nearly square cells, so that no direction is favoured."""
    angles = 2 * np.pi * np.arange(around) / around
    ring = np.column_stack([radius * np.cos(angles), radius * np.sin(angles), 0 * angles])
    steps = np.linspace(0, length, along + 1)
    vertices = np.vstack([ring + (0, 0, z) for z in steps])
    index = np.arange(len(vertices)).reshape(along + 1, around)
    index = np.column_stack([index, index[:, 0]])
    a, b, c, d = (part.ravel() for part in _cell_corners(index))
    return vertices, np.vstack([np.column_stack([a, b, d]), np.column_stack([a, d, c])])


TETRAHEDRON = (
    [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
    [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]],
)
