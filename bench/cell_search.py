# SPDX-License-Identifier: GPL-3.0-or-later
"""The cell size at which a clustering leaves the wanted number of faces."""

from __future__ import annotations

import math
from collections.abc import Callable

LEAST_CELL, LARGEST_CELL = 1e-4, 0.5  # of the bounding box's diagonal
_HALVINGS = 16  # of the range's logarithm: then cells differ by less than 1.3e-4 of their size


def nearest_cell(
    count_faces: Callable[[float], int],
    target: int,
    least: float = LEAST_CELL,
    largest: float = LARGEST_CELL,
) -> float:
    """The cell size, of those a bisection visits, whose face count is nearest to the target.

    count_faces: how many faces a cell size leaves; fewer the larger it is, apart from small waves.
    The counts of a grid jump, so the target is met nearly and not exactly.
    """
    best_cell, best_miss = least, math.inf
    for _ in range(_HALVINGS):
        cell = math.sqrt(least * largest)
        faces = count_faces(cell)
        if abs(faces - target) < best_miss:
            best_cell, best_miss = cell, abs(faces - target)
        if faces == target:
            break
        least, largest = (cell, largest) if faces > target else (least, cell)
    return best_cell
