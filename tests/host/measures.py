# SPDX-License-Identifier: GPL-3.0-or-later
"""Facts about triangle meshes from their arrays alone, independent of the code under test."""

from typing import NamedTuple

import igl
import numpy as np

NEGLIGIBLE_SIZE = 1e-6  # of the diagonal: a smaller face has no reliable normal
THIN = 0.25  # of a face's size: a part of this thickness has its other side as near as its own
MANY = 0.05  # of the faces: more than thin parts can explain
FOLDED = -0.9  # cosine of the angle between the normals of two faces, about 155 degrees
SAMPLES = 20_000


class Surface(NamedTuple):
    """Vertices (n, 3) and faces (m, 3) without unreferenced vertices."""

    vertices: np.ndarray
    faces: np.ndarray

    @property
    def diagonal(self):
        return float(np.linalg.norm(np.ptp(self.vertices, axis=0)))


class Topology(NamedTuple):
    """What a decimation of a manifold mesh must not change."""

    euler: int
    components: int
    boundary_loops: int
    oriented_manifold: bool


def surface(meshes):
    """The referenced part of the current mesh of a MeshSet."""
    mesh = meshes.current_mesh()
    used, faces = np.unique(mesh.face_matrix(), return_inverse=True)
    return Surface(mesh.vertex_matrix()[used], faces.reshape(-1, 3).astype(np.int64))


def half_edges(faces):
    return np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])


def edges_with_counts(faces):
    """Undirected edges and how many faces have each."""
    return np.unique(np.sort(half_edges(faces), axis=1), axis=0, return_counts=True)


def is_oriented_manifold(faces):
    """No edge is used twice in one direction, and the faces at a vertex are one fan."""
    once = len(np.unique(half_edges(faces), axis=0)) == 3 * len(faces)
    return bool(once and igl.is_vertex_manifold(faces).all())


def topology(shape):
    edges, _ = edges_with_counts(shape.faces)
    return Topology(
        euler=len(shape.vertices) - len(edges) + len(shape.faces),
        components=igl.facet_components(shape.faces)[0],
        boundary_loops=len(igl.boundary_loop_all(shape.faces)),
        oriented_manifold=is_oriented_manifold(shape.faces),
    )


def non_manifold_edges(shape):
    _, counts = edges_with_counts(shape.faces)
    return int((counts > 2).sum())


def double_area_normals(shape):
    """Face normals, as long as twice the face's area."""
    a, b, c = (shape.vertices[shape.faces[:, k]] for k in range(3))
    return np.cross(b - a, c - a)


def flipped_faces(original, simplified):
    """Faces that oppose the original where it is nearest to their centre.

    On a thin part that may be its other side; a face is not flipped when an agreeing part of the
    original is as near, but for a fraction of the face's own size.
    """
    normals = double_area_normals(simplified)
    original_normals = double_area_normals(original)
    centres = simplified.vertices[simplified.faces].mean(axis=1)
    distances, nearest, _ = igl.point_mesh_squared_distance(centres, *original)
    opposed = np.einsum("ij,ij->i", normals, original_normals[nearest]) <= 0
    sizes = np.sqrt(np.linalg.norm(normals, axis=1))
    suspects = np.flatnonzero(opposed & (sizes > NEGLIGIBLE_SIZE * original.diagonal))
    if len(suspects) > MANY * len(sizes):
        return len(suspects)
    return sum(
        _distance_to_agreeing(original, centres[face], original_normals @ normals[face])
        > np.sqrt(distances[face]) + THIN * sizes[face]
        for face in suspects
    )


def _distance_to_agreeing(original, point, cosines):
    faces = original.faces[cosines > 0]
    if not len(faces):
        return np.inf
    return np.sqrt(igl.point_mesh_squared_distance(point[None], original.vertices, faces)[0][0])


def folded_edges(shape):
    """Edges whose two faces lie almost on each other."""
    normals = double_area_normals(shape)
    normals /= np.maximum(np.linalg.norm(normals, axis=1), np.finfo(float).tiny)[:, None]
    neighbours, _ = igl.triangle_triangle_adjacency(shape.faces)
    cosines = np.einsum("ij,ikj->ik", normals, normals[neighbours])
    return int(((neighbours >= 0) & (cosines < FOLDED)).sum()) // 2


def sampled_points(shape, count=SAMPLES):
    """Area-uniform points, the same on every call."""
    random = np.random.default_rng(0)
    areas = np.linalg.norm(double_area_normals(shape), axis=1)
    faces = random.choice(len(areas), count, p=areas / areas.sum())
    corners = random.dirichlet((1, 1, 1), count)
    return np.einsum("ij,ijk->ik", corners, shape.vertices[shape.faces[faces]])


def largest_distance(one, other):
    """Two-sided, from samples all over both surfaces and from their vertices; a length."""
    points = [np.vstack([sampled_points(each), each.vertices]) for each in (one, other)]
    there, _, _ = igl.point_mesh_squared_distance(points[0], *other)
    back, _, _ = igl.point_mesh_squared_distance(points[1], *one)
    return float(np.sqrt(max(there.max(), back.max())))


def rms_distance(one, other):
    """Two-sided, as a fraction of the first surface's diagonal."""
    there, _, _ = igl.point_mesh_squared_distance(sampled_points(one), *other)
    back, _, _ = igl.point_mesh_squared_distance(sampled_points(other), *one)
    return float(np.sqrt((there.mean() + back.mean()) / 2)) / one.diagonal
