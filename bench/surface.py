# SPDX-License-Identifier: GPL-3.0-or-later
"""A triangle surface as arrays: areas, normals, curvature, samples, closest points."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import igl
import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

_CORNER_PAIRS = ((0, 1), (1, 2), (2, 0))


@dataclass(frozen=True)
class Samples:
    """Points drawn on a surface, uniformly by area.

    points: (m, 3), in the surface's unit. normals: (m, 3), unit. faces: (m,) indices.
    barycentric: (m, 3), rows sum to 1.
    """

    points: Floats
    normals: Floats
    faces: Ints
    barycentric: Floats


@dataclass(frozen=True)
class Hits:
    """Closest points on a surface: distance (m,) in its unit, face (m,) index, point (m, 3)."""

    distance: Floats
    face: Ints
    point: Floats


class Surface:
    """Vertices (n, 3) in any one unit of length and faces (m, 3) of vertex indices."""

    def __init__(self, vertices: ArrayLike, faces: ArrayLike) -> None:
        self.vertices = np.ascontiguousarray(vertices, dtype=np.float64).reshape(-1, 3)
        self.faces = np.ascontiguousarray(faces, dtype=np.int64).reshape(-1, 3)
        if len(self.faces) == 0:
            raise ValueError("a surface needs at least one face; this mesh has none")

    def without_unreferenced(self) -> Surface:
        """The same faces over the vertices they use, in ascending order of index."""
        used, renumbered = np.unique(self.faces, return_inverse=True)
        return Surface(self.vertices[used], renumbered.reshape(-1, 3))

    def welded(self) -> Surface | None:
        """Vertices of equal position made one, without faces that lose a corner; None: all do."""
        points, index = np.unique(self.vertices, axis=0, return_inverse=True)
        faces = index.reshape(-1)[self.faces]
        whole = (faces != np.roll(faces, 1, axis=1)).all(axis=1)
        return Surface(points, faces[whole]) if whole.any() else None

    def moved(self, shift: Floats, scale: float) -> Surface:
        """Shifted by `shift` (3,), then multiplied by `scale`."""
        return Surface((self.vertices + shift) * scale, self.faces)

    def quartered(self) -> Surface:
        """Every face cut into four at the middles of its edges; any surface will do."""
        edges = np.sort(self.directed_edges, axis=1)
        ends, index = np.unique(edges, axis=0, return_inverse=True)
        a, b, c = self.faces.T
        ab, bc, ca = len(self.vertices) + index.reshape(3, -1)
        quarters = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = np.concatenate([np.stack(each, axis=1) for each in quarters])
        return Surface(np.concatenate([self.vertices, self.vertices[ends].mean(axis=1)]), faces)

    @cached_property
    def corners(self) -> Floats:
        """(m, 3, 3): the three points of every face."""
        return self.vertices[self.faces]

    @cached_property
    def _crosses(self) -> Floats:
        a, b, c = self.corners.swapaxes(0, 1)
        return np.cross(b - a, c - a)

    @cached_property
    def areas(self) -> Floats:
        """(m,), unit squared."""
        return np.linalg.norm(self._crosses, axis=1) / 2

    @cached_property
    def normals(self) -> Floats:
        """(m, 3): unit, or zero where the area is zero."""
        length = 2 * self.areas[:, None]
        return np.divide(self._crosses, length, out=np.zeros_like(self._crosses), where=length > 0)

    @cached_property
    def edge_uses(self) -> Ints:
        """(e,): how many faces use each undirected edge."""
        ends = np.sort(self.directed_edges, axis=1)
        return np.unique(ends, axis=0, return_counts=True)[1]

    @property
    def directed_edges(self) -> Ints:
        """(3m, 2): the edges of every face in its own direction."""
        return np.concatenate([self.faces[:, pair] for pair in _CORNER_PAIRS])

    @cached_property
    def _solid_faces(self) -> Ints:
        return np.flatnonzero(self.areas > 0)

    @cached_property
    def _tree(self) -> tuple[igl.AABB, Ints]:
        solid = np.ascontiguousarray(self.faces[self._solid_faces])
        tree = igl.AABB()
        tree.init(self.vertices, solid)
        return tree, solid

    def closest(self, points: Floats) -> Hits:
        """The exact closest point of every point (m, 3); zero-area faces are never hit."""
        tree, solid = self._tree
        squared, face, point = tree.squared_distance(
            self.vertices, solid, np.ascontiguousarray(points, dtype=np.float64)
        )
        return Hits(np.sqrt(np.maximum(squared, 0)), self._solid_faces[face], point)

    def sample(self, count: int, seed: int) -> Samples:
        """`count` points, one in each of `count` equal shares of the area; fixed by the seed."""
        generator = np.random.default_rng(seed)
        area_up_to = np.cumsum(self.areas)
        share = (np.arange(count) + generator.random(count)) / count
        faces = np.searchsorted(area_up_to, share * area_up_to[-1], side="left")
        faces = np.minimum(faces, len(self.faces) - 1)
        weights = _uniform_barycentric(generator, count)
        points = (weights[:, :, None] * self.corners[faces]).sum(axis=1)
        return Samples(points, self.normals[faces], faces, weights)

    def smoothed_curvature(self) -> Floats:
        """(n,): |angle defect| / barycentric area, averaged over each vertex and its ring.

        An edge's far end counts once for each face that crosses the edge in that direction, so a
        boundary edge counts one way only. Zero where no face has an area. Unit: 1 / length^2.
        """
        third = np.repeat(self.areas / 3, 3)
        area = np.bincount(self.faces.ravel(), third, len(self.vertices))
        defect = np.nan_to_num(np.abs(igl.gaussian_curvature(self.vertices, self.faces)))
        curvature = np.divide(defect, area, out=np.zeros_like(area), where=area > 0)
        start, end = self.directed_edges.T
        ring_sum = np.bincount(start, curvature[end], len(curvature))
        ring_size = np.bincount(start, minlength=len(curvature))
        return (curvature + ring_sum) / (1 + ring_size)

    def mean_curvature(self) -> Floats:
        """(n,): signed, by the cotangent Laplacian and Voronoi areas; positive where convex.

        Zero where no face has an area. Unit: 1 / length.
        """
        area = igl.massmatrix(self.vertices, self.faces, igl.MASSMATRIX_TYPE_VORONOI).diagonal()
        laplacian = np.nan_to_num(igl.cotmatrix(self.vertices, self.faces) @ self.vertices)
        along = np.einsum("ij,ij->i", laplacian, self._vertex_normals())
        return np.divide(-along, 2 * area, out=np.zeros_like(area), where=area > 0)

    def _vertex_normals(self) -> Floats:
        sums = np.zeros_like(self.vertices)
        np.add.at(sums, self.faces.ravel(), np.repeat(self._crosses, 3, axis=0))
        length = np.linalg.norm(sums, axis=1, keepdims=True)
        return np.divide(sums, length, out=np.zeros_like(sums), where=length > 0)

    def at_closest(self, of_vertex: Floats, points: Floats) -> Floats:
        """(m,): what the vertices' values (n,) are at the closest point of every point (m, 3)."""
        hits = self.closest(points)
        weights = self.barycentric(hits)
        return np.einsum("ij,ij->i", weights, of_vertex[self.faces[hits.face]])

    def barycentric(self, hits: Hits) -> Floats:
        """(m, 3): the weights of the corners of the faces that were hit."""
        corners = self.corners[hits.face].swapaxes(0, 1)
        return igl.barycentric_coordinates(hits.point, *map(np.ascontiguousarray, corners))


def _uniform_barycentric(generator: np.random.Generator, count: int) -> Floats:
    """(count, 3): uniform over a triangle, by the square-root map of the unit square."""
    root = np.sqrt(generator.random(count))
    along = generator.random(count)
    return np.stack([1 - root, root * (1 - along), root * along], axis=1)
