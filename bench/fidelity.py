# SPDX-License-Identifier: GPL-3.0-or-later
"""How alike a simplification and its original are curved, and how many errors are low."""

from __future__ import annotations

import numpy as np
from surface import Floats, Ints, Surface

_SAMPLES, _SEED = 200_000, 0  # points at which curvatures are compared


class CurvatureJudge:
    """Knows the original; call it with a simplified mesh in the same coordinates.

    It gives the mean |difference of mean curvatures|, times the diagonal.
    """

    def __init__(self, vertices: Floats, faces: Ints) -> None:
        low, high = vertices.min(axis=0), vertices.max(axis=0)
        self._shift, self._scale = -(low + high) / 2, 1 / float(np.linalg.norm(high - low))
        original = self._normalised(vertices, faces)
        self._points = original.sample(_SAMPLES, _SEED).points
        self._curvature = self._curvature_of(original)

    def __call__(self, vertices: Floats, faces: Ints) -> float:
        there = self._curvature_of(self._normalised(vertices, faces))
        return float(np.abs(there - self._curvature).mean())

    def _normalised(self, vertices: Floats, faces: Ints) -> Surface:
        return Surface(vertices, faces).without_unreferenced().moved(self._shift, self._scale)

    def _curvature_of(self, surface: Surface) -> Floats:
        return surface.at_closest(surface.mean_curvature(), self._points)


def share_below(errors: Floats, limit: float) -> float:
    """0 to 1."""
    return float(np.mean(errors < limit))
