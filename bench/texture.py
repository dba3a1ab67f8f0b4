# SPDX-License-Identifier: GPL-3.0-or-later
"""Judge of the texture of a simplified mesh against that of its original.

The coordinates of samples of the simplified mesh are looked up in the original's atlas: there they
should show what lies where the sample lies. Distances are a percentage of the original's
bounding-box diagonal.

    python bench/texture.py original.obj simplified.ply ...
"""

from __future__ import annotations

import sys
import tempfile
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
import pymeshlab
from numpy.typing import NDArray
from plyfile import PlyData
from surface import Floats, Ints, Samples, Surface

SAMPLES = 100_000
FAR = 0.02  # of the atlas
TEXEL = 1 / 1024  # of the atlas: what sticks out of a chart by less shows nothing
_SEED = 0
_PERCENT = 100.0


@dataclass(frozen=True)
class Textured:
    """A surface whose corners have texture coordinates.

    coordinates: (m, 3, 2), of the corners of faces. pages: (m,), indices of images.
    """

    surface: Surface
    coordinates: Floats
    pages: Ints

    def at(self, faces: Ints, barycentric: Floats) -> Floats:
        """(k, 2): the coordinates at points of faces."""
        return np.einsum("ki,kij->kj", barycentric, self.coordinates[faces])

    @cached_property
    def atlas_areas(self) -> Floats:
        """(m,): signed, above zero where a face is drawn counter-clockwise."""
        a, b, c = self.coordinates.swapaxes(0, 1)
        return _cross(b - a, c - a) / 2


@dataclass(frozen=True)
class TextureFigures:
    """What the judge says. Distances in % of the original's diagonal, shares of the area in %."""

    drift_rms: float  # between a sample and where its coordinates lie on the original; of faces
    drift_max: float  # that are drawn with an area: others show one colour of a palette
    far: float  # share whose coordinates are more than FAR from those of the nearest point
    bleed: float  # share whose coordinates are more than a TEXEL outside of all charts
    turned: int  # faces drawn the other way round in the atlas than the original there
    cracks: int  # edges of one face, vertices of equal position made one, beyond the original's


def read_textured(path: str | Path) -> Textured:
    """A file with texture coordinates by wedge or by vertex, as PyMeshLab reads it."""
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(str(path))
    if not meshes.current_mesh().has_wedge_tex_coord():
        if not meshes.current_mesh().has_vertex_tex_coord():
            raise ValueError(f"{path} has no texture coordinates")
        meshes.compute_texcoord_transfer_vertex_to_wedge()
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "copy.ply"
        meshes.save_current_mesh(str(copy), save_textures=False, save_wedge_texcoord=True)
        ply = PlyData.read(copy)
    vertex, face = ply["vertex"], ply["face"]
    names = {each.name for each in face.properties}
    pages = face["texnumber"] if "texnumber" in names else np.zeros(len(face.data))
    return Textured(
        Surface(
            np.column_stack([vertex[axis] for axis in "xyz"]), np.vstack(face["vertex_indices"])
        ),
        np.vstack(face["texcoord"]).reshape(-1, 3, 2).astype(np.float64),
        np.asarray(pages, dtype=np.int64),
    )


class TextureJudge:
    """Knows the original; call it with a simplified mesh."""

    def __init__(self, original: Textured, samples: int = SAMPLES) -> None:
        self.original = original
        self._samples = samples
        self._atlas = Atlas(original)
        points = original.surface.without_unreferenced().vertices
        self._diagonal = float(np.linalg.norm(np.ptp(points, axis=0)))
        self._border = _border_edges(original.surface)

    def __call__(self, simplified: Textured) -> TextureFigures:
        samples = simplified.surface.sample(self._samples, _SEED)
        there = simplified.at(samples.faces, samples.barycentric)
        pages = simplified.pages[samples.faces]
        drift, outside = self._atlas.look_up(samples.points, pages, there)
        known = np.isfinite(drift) & (simplified.atlas_areas[samples.faces] != 0)
        in_percent = _PERCENT * drift[known] / self._diagonal
        return TextureFigures(
            drift_rms=float(np.sqrt((in_percent**2).sum() / max(1, known.sum()))),
            drift_max=float(in_percent.max(initial=0.0)),
            far=_PERCENT * float(np.mean(self._is_far(samples, pages, there))),
            bleed=_PERCENT * float(np.mean(outside > TEXEL)),
            turned=self._turned(simplified),
            cracks=max(0, _border_edges(simplified.surface) - self._border),
        )

    def _is_far(self, samples: Samples, pages: Ints, there: Floats) -> NDArray[np.bool_]:
        hits = self.original.surface.closest(samples.points)
        expected = self.original.at(hits.face, self.original.surface.barycentric(hits))
        is_elsewhere = pages != self.original.pages[hits.face]
        return is_elsewhere | (np.linalg.norm(there - expected, axis=1) > FAR)

    def _turned(self, simplified: Textured) -> int:
        centers = simplified.surface.corners.mean(axis=1)
        nearest = self.original.surface.closest(centers).face
        return int(np.sum(simplified.atlas_areas * self.original.atlas_areas[nearest] < 0))


class Atlas:
    """The faces of a textured surface in the plane of their coordinates, page by page."""

    _cells_a_side = 256

    def __init__(self, textured: Textured) -> None:
        self._textured = textured
        drawn = _without_doubles_in_palette(textured)
        corners = textured.coordinates[drawn]
        self._low = corners.min(axis=(0, 1)) - TEXEL
        self._step = (corners.max(axis=(0, 1)) + TEXEL - self._low) / self._cells_a_side
        first, last = (
            self._cell(each) for each in (corners.min(1) - TEXEL, corners.max(1) + TEXEL)
        )
        width, height = (last - first + 1).T
        faces = np.repeat(np.arange(len(drawn)), width * height)
        place = np.arange(len(faces)) - np.repeat(
            np.cumsum(width * height) - width * height, width * height
        )
        x = first[faces, 0] + place % width[faces]
        y = first[faces, 1] + place // width[faces]
        keys = self._key(textured.pages[drawn[faces]], x, y)
        order = np.argsort(keys, kind="stable")
        self._keys, self._faces = keys[order], drawn[faces[order]]

    def look_up(self, points: Floats, pages: Ints, coordinates: Floats) -> tuple[Floats, Floats]:
        """For each of k samples: how far its point is from where its coordinates lie on the
        surface, the nearest place of several, and how far they are outside of all faces; inf: no
        face is near.
        """
        x, y = self._cell(coordinates).T
        keys = self._key(pages, x, y)
        begin, end = (np.searchsorted(self._keys, keys, side) for side in ("left", "right"))
        sample = np.repeat(np.arange(len(keys)), end - begin)
        place = np.arange(len(sample)) - np.repeat(
            np.cumsum(end - begin) - (end - begin), end - begin
        )
        face = self._faces[begin[sample] + place]
        weights, outside = _nearest_in_plane(self._textured.coordinates[face], coordinates[sample])
        there = np.einsum("ki,kij->kj", weights, self._textured.surface.corners[face])
        distance = np.linalg.norm(there - points[sample], axis=1)
        least = np.full(len(keys), np.inf)
        np.minimum.at(least, sample, outside)
        drift = np.full(len(keys), np.inf)
        is_there = outside <= np.maximum(least[sample], _ROUNDING)
        np.minimum.at(drift, sample[is_there], distance[is_there])
        return drift, least

    def _cell(self, coordinates: Floats) -> Ints:
        cell = np.floor((coordinates - self._low) / self._step).astype(np.int64)
        return np.clip(cell, 0, self._cells_a_side - 1)

    def _key(self, page: Ints, x: Ints, y: Ints) -> Ints:
        return (page * self._cells_a_side + x) * self._cells_a_side + y


_ROUNDING = 1e-6  # of the atlas: formats have seven digits


def _without_doubles_in_palette(textured: Textured) -> Ints:
    """Indices of faces: all that are drawn with an area, and of the others one for each place."""
    is_flat = textured.atlas_areas == 0
    flat = np.flatnonzero(is_flat)
    places = np.column_stack([textured.pages[flat], textured.coordinates[flat].reshape(-1, 6)])
    first = np.unique(places, axis=0, return_index=True)[1]
    return np.sort(np.concatenate([np.flatnonzero(~is_flat), flat[first]]))


def _cross(a: Floats, b: Floats) -> Floats:
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def _nearest_in_plane(triangles: Floats, points: Floats) -> tuple[Floats, Floats]:
    """Barycentric weights (k, 3) of the points (k, 2) of triangles (k, 3, 2) that are nearest to
    points (k, 2), and how far these are.
    """
    a, b, c = triangles.swapaxes(0, 1)
    whole = _cross(b - a, c - a)
    parts = np.stack(
        [
            _cross(b - points, c - points),
            _cross(c - points, a - points),
            _cross(a - points, b - points),
        ],
        axis=1,
    )
    solid = whole != 0
    weights = np.divide(parts, whole[:, None], out=np.full_like(parts, -1.0), where=solid[:, None])
    is_inside = (weights >= 0).all(axis=1)
    distance = np.where(is_inside, 0.0, np.inf)
    for i, j in ((0, 1), (1, 2), (2, 0)):
        start, edge = triangles[:, i], triangles[:, j] - triangles[:, i]
        length2 = (edge**2).sum(axis=1)
        along = ((points - start) * edge).sum(axis=1)
        t = np.clip(np.divide(along, length2, out=np.zeros_like(along), where=length2 > 0), 0, 1)
        there = np.linalg.norm(start + t[:, None] * edge - points, axis=1)
        nearer = ~is_inside & (there < distance)
        distance[nearer] = there[nearer]
        weights[nearer] = 0.0
        weights[nearer, i], weights[nearer, j] = 1 - t[nearer], t[nearer]
    return weights, distance


def _border_edges(surface: Surface) -> int:
    welded = surface.welded()
    return 0 if welded is None else int((welded.edge_uses == 1).sum())


def main() -> None:
    judge = TextureJudge(read_textured(sys.argv[1]))
    for path in sys.argv[2:]:
        print(path, asdict(judge(read_textured(path))))


if __name__ == "__main__":
    main()
