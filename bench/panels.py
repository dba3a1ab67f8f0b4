# SPDX-License-Identifier: GPL-3.0-or-later
"""What a picture of meshes shows, and how each fits into its cell."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from surface import Floats, Ints

CELL_PIXELS = (900, 720)
_SIDE_MARGIN, _FOOT_MARGIN, _HEAD_MARGIN = 0.06, 0.05, 0.17  # of the cell; the head has the text


@dataclass(frozen=True)
class Paint:
    """Colours on the surface of a mesh, at points of their own: its faces cut into smaller ones."""

    vertices: Floats
    faces: Ints
    values: Floats  # (n,), 0 to 1, at the vertices


@dataclass(frozen=True)
class Panel:
    """One mesh: (n, 3) vertices, (m, 3) faces, a title and a line below it."""

    vertices: Floats
    faces: Ints
    title: str
    caption: str
    paint: Paint | None = None  # instead of the colour of its place in the row


@dataclass(frozen=True)
class View:
    """Where to look from, and which way is up, in the mesh's own axes."""

    direction: tuple[float, float, float]
    up: tuple[float, float, float] = (0.0, 1.0, 0.0)


@dataclass(frozen=True)
class Fit:
    """A parallel projection: rows of `frame` point right, up and to the viewer."""

    frame: Floats  # (3, 3)
    centre: Floats  # (3,), what the middle of the cell shows
    shown_height: float  # of the cell, in the mesh's unit
    depth: float  # of the mesh


def fit(view: View, vertices: Floats) -> Fit:
    """Shows the vertices (n, 3) between the margins of a cell."""
    towards = _unit(np.asarray(view.direction, dtype=float))
    right = _unit(np.cross(view.up, towards))
    frame = np.stack([right, np.cross(towards, right), towards])
    low, high = (vertices @ frame.T).min(axis=0), (vertices @ frame.T).max(axis=0)
    free_width, free_height = 1 - 2 * _SIDE_MARGIN, 1 - _FOOT_MARGIN - _HEAD_MARGIN
    aspect = CELL_PIXELS[0] / CELL_PIXELS[1]
    width, height, depth = high - low
    shown_height = max(height / free_height, width / free_width / aspect)
    raised = (_HEAD_MARGIN - _FOOT_MARGIN) / 2 * shown_height
    centre = ((low + high) / 2 + (0, raised, 0)) @ frame
    return Fit(frame, centre, shown_height, depth)


def _unit(vector: Floats) -> Floats:
    return vector / np.linalg.norm(vector)
