# SPDX-License-Identifier: GPL-3.0-or-later
"""Judge of a simplified mesh against its original.

Distances are a percentage of the original's bounding-box diagonal. Both surfaces are sampled
uniformly by area, with fixed seeds; closest points are exact. The maximum also looks at every
vertex.

    python bench/judge.py original.ply simplified.ply ...
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass

import igl
import numpy as np
from numpy.typing import ArrayLike, NDArray
from surface import Floats, Hits, Samples, Surface

LEAST_SAMPLES = 200_000  # a direction: the RMS then repeats within about 0.2 %
SAMPLES_PER_VERTEX = 10
SALIENT_SHARE = 0.2  # of the original's area, where its curvature is largest
_PERCENT = 100.0
_ORIGINAL_SEED, _SIMPLIFIED_SEED = 0, 1

Region = Callable[[Floats], NDArray[np.bool_]]
"""Tells which of the points (m, 3), in the original's own unit, belong to it."""


@dataclass(frozen=True)
class Figures:
    """What the judge says. Distances in % of the original's diagonal, angles in degrees."""

    faces: int
    rms: float  # two-sided: root of the mean of both directions' squares
    rms_original_to_simplified: float
    rms_simplified_to_original: float
    mean: float  # mean of both directions
    max: float  # of samples and vertices, both directions
    rms_salient: float  # original to simplified, from the salient part
    rms_regions: dict[str, float]  # original to simplified, from each named region
    ndev: float  # mean angle between the normals at closest points, both directions
    flipped: int  # faces turned more than 90 degrees against the original
    zero_area: int
    nm_edges: int  # edges of more than two faces
    nm_vertices: int  # vertices whose faces do not form one fan
    boundary: int  # edges of one face
    dup_faces: int  # faces beyond the first on the same three vertices
    euler: int


class Judge:
    """Knows the original; call it with a simplified mesh.

    samples: a direction; None: so many that the RMS repeats within about 0.2 %.
    """

    def __init__(
        self,
        vertices: ArrayLike,
        faces: ArrayLike,
        regions: Mapping[str, Region] | None = None,
        samples: int | None = None,
    ) -> None:
        raw = Surface(vertices, faces).without_unreferenced()
        low, high = raw.vertices.min(axis=0), raw.vertices.max(axis=0)
        self.diagonal = float(np.linalg.norm(high - low))
        self._shift = -(low + high) / 2
        self._original = self._normalised(raw)
        self._count = samples or max(LEAST_SAMPLES, SAMPLES_PER_VERTEX * len(raw.vertices))
        self._samples = self._original.sample(self._count, _ORIGINAL_SEED)
        self._salient = _most_curved(self._original, self._samples)
        points = self._samples.points * self.diagonal - self._shift
        self._regions = {name: region(points) for name, region in (regions or {}).items()}

    def __call__(self, vertices: ArrayLike, faces: ArrayLike) -> Figures:
        """Figures of a mesh in the same coordinates as the original."""
        mesh = self._normalised(Surface(vertices, faces))
        samples = mesh.sample(self._count, _SIMPLIFIED_SEED)
        forth, back = mesh.closest(self._samples.points), self._original.closest(samples.points)
        rms_forth, rms_back = _rms(forth.distance), _rms(back.distance)
        return Figures(
            faces=len(mesh.faces),
            rms=float(np.hypot(rms_forth, rms_back) / np.sqrt(2)),
            rms_original_to_simplified=rms_forth,
            rms_simplified_to_original=rms_back,
            mean=float(forth.distance.mean() + back.distance.mean()) / 2 * _PERCENT,
            max=self._largest(mesh, forth, back),
            rms_salient=_rms(forth.distance[self._salient]),
            rms_regions={name: _rms(forth.distance[at]) for name, at in self._regions.items()},
            ndev=self._normal_deviation(mesh, samples, forth, back),
            flipped=self._count_flipped(mesh),
            **topology(mesh),
        )

    def flipped(self, vertices: ArrayLike, faces: ArrayLike) -> int:
        """The figure of this name alone; for the original itself, as where its faces coincide."""
        return self._count_flipped(self._normalised(Surface(vertices, faces)))

    def _normalised(self, surface: Surface) -> Surface:
        return surface.moved(self._shift, 1 / self.diagonal)

    def _largest(self, mesh: Surface, forth: Hits, back: Hits) -> float:
        vertices_forth = mesh.closest(self._original.vertices)
        vertices_back = self._original.closest(mesh.without_unreferenced().vertices)
        everything = (forth, back, vertices_forth, vertices_back)
        return max(float(hits.distance.max()) for hits in everything) * _PERCENT

    def _normal_deviation(self, mesh: Surface, samples: Samples, forth: Hits, back: Hits) -> float:
        there = _degrees_between(self._samples.normals, mesh.normals[forth.face])
        here = _degrees_between(samples.normals, self._original.normals[back.face])
        return float(there.mean() + here.mean()) / 2

    def _count_flipped(self, mesh: Surface) -> int:
        nearest = self._original.closest(mesh.corners.mean(axis=1)).face
        turned = _degrees_between(mesh.normals, self._original.normals[nearest])
        return int(np.count_nonzero((turned > 90) & (mesh.areas > 0)))


def _most_curved(surface: Surface, samples: Samples) -> NDArray[np.bool_]:
    """Which samples lie in the fifth of the area with the largest curvature."""
    at_corners = surface.smoothed_curvature()[surface.faces[samples.faces]]
    curvature = (samples.barycentric * at_corners).sum(axis=1)
    return curvature >= np.quantile(curvature, 1 - SALIENT_SHARE)


def topology(mesh: Surface) -> dict[str, int]:
    """The figures that one mesh has by itself."""
    uses = mesh.edge_uses
    compact = mesh.without_unreferenced()
    distinct = np.unique(np.sort(mesh.faces, axis=1), axis=0)
    return {
        "zero_area": int(np.count_nonzero(mesh.areas <= 0)),
        "nm_edges": int(np.count_nonzero(uses > 2)),
        "nm_vertices": int(np.count_nonzero(~igl.is_vertex_manifold(compact.faces))),
        "boundary": int(np.count_nonzero(uses == 1)),
        "dup_faces": len(mesh.faces) - len(distinct),
        "euler": len(compact.vertices) - len(uses) + len(mesh.faces),
    }


def _rms(distance: Floats) -> float:
    return float(np.sqrt(np.mean(np.square(distance)))) * _PERCENT


def _degrees_between(a: Floats, b: Floats) -> Floats:
    return np.degrees(np.arccos(np.clip(np.einsum("ij,ij->i", a, b), -1, 1)))


def main(paths: list[str]) -> int:
    """Prints the figures of every further mesh against the first."""
    from meshes import read_mesh

    if len(paths) < 2:
        print("usage: judge.py original simplified ...", file=sys.stderr)
        return 2
    judge = Judge(*read_mesh(paths[0]))
    for path in paths[1:]:
        figures = asdict(judge(*read_mesh(path)))
        print(path, *(f"{name}={value}" for name, value in figures.items()))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
