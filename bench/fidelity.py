# SPDX-License-Identifier: GPL-3.0-or-later
"""How near the vertices of a simplification and its original are, and how alike they are curved."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from surface import Floats, Ints, Surface

_PERCENT = 100.0
_SAMPLES, _SEED = 200_000, 0  # points at which curvatures are compared


@dataclass(frozen=True)
class Fidelity:
    """What the judge says."""

    of_simplified: Floats  # (k,): of the simplification's vertices, % of the diagonal
    of_original: Floats  # (n,): of the original's vertices, % of the diagonal
    curvature: float  # mean |difference of mean curvatures|, times the diagonal


class FidelityJudge:
    """Knows the original; call it with a simplified mesh in the same coordinates."""

    def __init__(self, vertices: Floats, faces: Ints) -> None:
        low, high = vertices.min(axis=0), vertices.max(axis=0)
        self._shift, self._scale = -(low + high) / 2, 1 / float(np.linalg.norm(high - low))
        self._original = self._normalised(vertices, faces)
        self._points = self._original.sample(_SAMPLES, _SEED).points
        self._curvature = self._curvature_of(self._original)

    def __call__(self, vertices: Floats, faces: Ints) -> Fidelity:
        mesh = self._normalised(vertices, faces)
        return Fidelity(
            of_simplified=self._original.closest(mesh.vertices).distance * _PERCENT,
            of_original=mesh.closest(self._original.vertices).distance * _PERCENT,
            curvature=float(np.abs(self._curvature_of(mesh) - self._curvature).mean()),
        )

    def _normalised(self, vertices: Floats, faces: Ints) -> Surface:
        return Surface(vertices, faces).without_unreferenced().moved(self._shift, self._scale)

    def _curvature_of(self, surface: Surface) -> Floats:
        return surface.at_closest(surface.mean_curvature(), self._points)


def share_below(errors: Floats, limit: float) -> float:
    """0 to 1."""
    return float(np.mean(errors < limit))
