# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh file that every peer reads and writes: sizes, then plain arrays, all little-endian.

int64 vertices, int64 faces, float64 x y z of every vertex, int32 corners of every face.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

_SIZES = 2  # vertices, faces


def read_binary(path: str | Path) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    """Vertices (n, 3) and faces (m, 3)."""
    with open(path, "rb") as file:
        vertices, faces = (int(size) for size in np.fromfile(file, "<i8", _SIZES))
        points = np.fromfile(file, "<f8", 3 * vertices)
        corners = np.fromfile(file, "<i4", 3 * faces)
    if len(points) != 3 * vertices or len(corners) != 3 * faces:
        raise ValueError(f"{path}: the file ends too early")
    return points.reshape(-1, 3), corners.reshape(-1, 3)


def write_binary(path: str | Path, vertices: NDArray, faces: NDArray) -> None:
    """Saves vertices (n, 3) and faces (m, 3)."""
    with open(path, "wb") as file:
        np.array([len(vertices), len(faces)], "<i8").tofile(file)
        np.ascontiguousarray(vertices, "<f8").tofile(file)
        np.ascontiguousarray(faces, "<i4").tofile(file)
