# SPDX-License-Identifier: GPL-3.0-or-later
"""One mesh in the files and the units of length in which the peers want it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from binary_mesh import read_binary, write_binary
from meshes import read_mesh, write_mesh
from surface import Floats, Ints


@dataclass(frozen=True, eq=False)
class MeshFiles:
    """Bare geometry, so that nobody is charged for attributes that another drops.

    name: as in the tables. source: any mesh file, or a binary one. folder: where files go.
    """

    name: str
    source: Path
    folder: Path

    @cached_property
    def arrays(self) -> tuple[Floats, Ints]:
        """Vertices (n, 3) and faces (m, 3)."""
        if self.source.suffix == ".bin":
            vertices, faces = read_binary(self.source)
            return vertices, faces.astype(np.int64)
        return read_mesh(self.source)

    @cached_property
    def face_count(self) -> int:
        return len(self.arrays[1])

    def scale(self, diagonal: float | None) -> float:
        """The factor that makes the bounding box's diagonal so long; 1 for None."""
        if diagonal is None:
            return 1.0
        return diagonal / float(np.linalg.norm(np.ptp(self.arrays[0], axis=0)))

    def binary(self, diagonal: float | None = None) -> Path:
        """The file that programs and libraries read, written on first use."""
        return self._written(".bin", diagonal)

    def ply(self, diagonal: float | None = None) -> Path:
        """The file that MeshLab's filters read, written on first use."""
        return self._written(".ply", diagonal)

    def _written(self, suffix: str, diagonal: float | None) -> Path:
        unit = "" if diagonal is None else f"-{diagonal:g}"
        path = self.folder / f"{self.source.stem}{unit}{suffix}"
        if not path.exists():
            vertices, faces = self.arrays
            write = write_binary if suffix == ".bin" else write_mesh
            write(path, vertices * self.scale(diagonal), faces)
        return path
