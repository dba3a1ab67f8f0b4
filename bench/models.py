# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh under test: where it is, how it is judged, what the filters make of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import igl
import numpy as np
from decimators import Decimator, Outcome, race
from judge import Figures, Judge, Region
from meshes import read_mesh, write_mesh
from numpy.typing import NDArray
from surface import Floats, Ints, Surface

Box = Sequence[tuple[float, float]]
"""Three ranges, one an axis, as fractions 0..1 of the bounding box."""


@dataclass(frozen=True)
class Result:
    """What one filter made of a model, and what the judge says of it."""

    outcome: Outcome
    figures: Figures

    @property
    def milliseconds(self) -> float:
        return self.outcome.seconds * 1000


@dataclass(frozen=True, eq=False)
class Model:
    """A mesh file with named regions, each a union of boxes."""

    name: str
    path: Path
    regions: Mapping[str, Sequence[Box]] = field(default_factory=dict)

    @cached_property
    def _arrays(self) -> tuple[Floats, Ints]:
        return read_mesh(self.path)

    @property
    def vertices(self) -> Floats:
        """(n, 3)."""
        return self._arrays[0]

    @property
    def faces(self) -> Ints:
        """(m, 3)."""
        return self._arrays[1]

    @cached_property
    def diagonal(self) -> float:
        """Of the bounding box, in the mesh's unit."""
        return float(np.linalg.norm(np.ptp(self.vertices, axis=0)))

    @cached_property
    def judge(self) -> Judge:
        """Judges any simplification of this model."""
        regions = {name: self._inside(boxes) for name, boxes in self.regions.items()}
        return Judge(self.vertices, self.faces, regions)

    def _inside(self, boxes: Sequence[Box]) -> Region:
        low, size = self.vertices.min(axis=0), np.ptp(self.vertices, axis=0)

        def inside(points: Floats) -> NDArray[np.bool_]:
            hits = []
            for first, last in (np.array(box).T for box in boxes):
                least = np.where(first > 0, low + first * size, -np.inf)
                largest = np.where(last < 1, low + last * size, np.inf)
                hits.append(np.all((least <= points) & (points <= largest), axis=1))
            return np.any(hits, axis=0)

        return inside

    def part(self, region: str, mesh: tuple[Floats, Ints] | None = None) -> tuple[Floats, Ints]:
        """The faces whose middle is in the region, and their vertices alone.

        mesh: another one in the same coordinates, as a simplification; None: the model itself.
        """
        vertices, faces = mesh or self._arrays
        inside = self._inside(self.regions[region])(vertices[faces].mean(axis=1))
        part = Surface(vertices, faces[inside]).without_unreferenced()
        return part.vertices, part.faces

    def run(self, target: int, contenders: Sequence[Decimator], repeats: int = 1) -> list[Result]:
        """Every contender to `target` faces; times are medians of `repeats` turns."""
        outcomes = race(self.path, target, contenders, repeats)
        return [Result(each, self.judge(each.vertices, each.faces)) for each in outcomes]

    def case_name(self, target: int) -> str:
        """Of the model at so many faces, in tables."""
        return f"{self.name}, {len(self.faces):,} to {target:,}"

    def smoothly_subdivided(self, folder: Path) -> Model:
        """The same model after one step of Loop subdivision, four faces for one."""
        path = folder / f"{self.path.stem}-loop.ply"
        write_mesh(path, *igl.loop(self.vertices, self.faces))
        return Model(self.name, path, self.regions)
