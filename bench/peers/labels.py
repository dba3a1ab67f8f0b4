# SPDX-License-Identifier: GPL-3.0-or-later
"""Places labels beside their points so that none covers another label or a point."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

Pixel = tuple[float, float]

_DIRECTIONS = 16  # in which a label may lie from its point
_FIRST_GAP, _GAP_STEP, _GAPS = 13.0, 9.0, 40  # pixels from the point to the label
_POINT_RADIUS = 12.0  # pixels that a label keeps away from every other point


@dataclass(frozen=True)
class Box:
    """A rectangle in pixels."""

    left: float
    bottom: float
    right: float
    top: float

    @property
    def centre(self) -> Pixel:
        return (self.left + self.right) / 2, (self.bottom + self.top) / 2

    def nearest(self, point: Pixel) -> Pixel:
        """The place in the box that is nearest to the point."""
        x = min(max(point[0], self.left), self.right)
        return x, min(max(point[1], self.bottom), self.top)

    def overlaps(self, other: Box) -> bool:
        across = self.left < other.right and other.left < self.right
        return across and self.bottom < other.top and other.bottom < self.top

    def contains(self, other: Box) -> bool:
        across = self.left <= other.left and other.right <= self.right
        return across and self.bottom <= other.bottom and other.top <= self.top


def place(anchors: Sequence[Pixel], sizes: Sequence[tuple[float, float]], frame: Box) -> list[Box]:
    """A box a label, in order, so the first ones lie best.

    anchors: the points. sizes: width and height of the labels. A label for which no place is free
    lies at its last candidate, which is far off; nothing is ever left out.
    """
    taken = [_around(anchor) for anchor in anchors]
    placed: list[Box] = []
    for anchor, size in zip(anchors, sizes, strict=True):
        box = _free(anchor, size, frame, [*taken, *placed])
        placed.append(box)
    return placed


def _around(point: Pixel) -> Box:
    x, y = point
    return Box(x - _POINT_RADIUS, y - _POINT_RADIUS, x + _POINT_RADIUS, y + _POINT_RADIUS)


def _free(anchor: Pixel, size: tuple[float, float], frame: Box, taken: Sequence[Box]) -> Box:
    candidate = None
    for candidate in _candidates(anchor, size):
        if frame.contains(candidate) and not any(candidate.overlaps(box) for box in taken):
            return candidate
    assert candidate is not None
    return candidate


def _candidates(anchor: Pixel, size: tuple[float, float]) -> Iterator[Box]:
    """Nearest first; in one distance from the right, turning."""
    width, height = size
    for step in range(_GAPS):
        gap = _FIRST_GAP + step * _GAP_STEP
        for turn in range(_DIRECTIONS):
            angle = 2 * math.pi * turn / _DIRECTIONS
            x = anchor[0] + math.cos(angle) * (gap + width / 2)
            y = anchor[1] + math.sin(angle) * (gap + height / 2)
            yield Box(x - width / 2, y - height / 2, x + width / 2, y + height / 2)
