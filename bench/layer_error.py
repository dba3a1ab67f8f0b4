# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a simplification is from its original, by our filter `get_simplification_error`.

What the sources' tables print beside their own figures is measured here. `judge` has the same
definitions in Python; a test in `tests/host` holds the two together.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pymeshlab
from decimators import Decimator, Outcome, race
from models import Model
from surface import Floats, Ints

_FILTER = "get_simplification_error"
# All of them: what is not given is taken from the last call.
_PARAMETERS = {
    "originalmesh": 0,
    "simplifiedmesh": 1,
    "relativeto": "MeshUnit",
    "tolerance": pymeshlab.PureValue(0.0),
    "savequality": True,
    "samplenum": 0,
    "threads": 0,
}


@dataclass(frozen=True)
class LayerError:
    """What the filter says. Distances in % of the diagonal, angles in degrees."""

    rms: float  # two-sided, as are the mean and the maximum
    mean: float
    max: float
    rms_of_original: float  # from the original to the simplification only
    rms_salient: float  # the same, from the most curved fifth of the original
    normal_deviation: float
    flipped: int  # faces turned by more than 90 degrees against the original
    intersecting: int  # faces that cross another one
    parts_gained: int  # below 0: lost
    holes_gained: int
    at_original: Floats = field(repr=False)  # (n,): at the original's vertices, those of faces only
    at_simplified: Floats = field(repr=False)  # (k,): at the simplification's vertices


@dataclass(frozen=True)
class Measured:
    """What one filter made of a model, and how far that is from it."""

    outcome: Outcome
    error: LayerError


class ErrorMeter:
    """Knows the original; call it with a simplified mesh in the same coordinates.

    diagonal: what distances are told in per cent of; None: that of the original's bounding box.
    """

    def __init__(
        self, plugin: Path, vertices: Floats, faces: Ints, diagonal: float | None = None
    ) -> None:
        _load(plugin)
        self._vertices, self._faces = vertices, faces
        self._diagonal = diagonal

    def __call__(self, vertices: Floats, faces: Ints) -> LayerError:
        layers = pymeshlab.MeshSet(verbose=False)
        for each in ((self._vertices, self._faces), (vertices, faces)):
            layers.add_mesh(_mesh(*each))
        told = layers.apply_filter(_FILTER, **_PARAMETERS)
        unit = (self._diagonal or told["diagonal"]) / 100
        original, simplified = (layers.mesh(n).vertex_scalar_array() / unit for n in (0, 1))
        return _error(told, unit, original[np.unique(self._faces)], simplified)


def meter_of(plugin: Path, model: Model) -> ErrorMeter:
    """Measures any simplification of the model."""
    return ErrorMeter(plugin, model.vertices, model.faces)


def measure(
    plugin: Path, model: Model, target: int, contenders: Sequence[Decimator], repeats: int = 1
) -> dict[str, Measured]:
    """Every contender to `target` faces, by its name; times are medians of `repeats` turns."""
    meter = meter_of(plugin, model)
    outcomes = race(model.path, target, contenders, repeats)
    return {
        each.name: Measured(outcome, meter(outcome.vertices, outcome.faces))
        for each, outcome in zip(contenders, outcomes, strict=True)
    }


def region_rms(plugin: Path, model: Model, region: str, outcome: Outcome) -> float:
    """RMS distance from a region of the model to its simplification, % of the model's diagonal."""
    meter = ErrorMeter(plugin, *model.part(region), model.diagonal)
    return meter(outcome.vertices, outcome.faces).rms_of_original


def _load(plugin: Path) -> None:
    """Once a process: PyMeshLab refuses a second time."""
    if _FILTER not in pymeshlab.filter_list():
        pymeshlab.load_plugin(str(plugin.resolve()))


def _mesh(vertices: Floats, faces: Ints) -> pymeshlab.Mesh:
    return pymeshlab.Mesh(vertices, faces.astype("int32"))


def _error(told: dict[str, Any], unit: float, original: Floats, simplified: Floats) -> LayerError:
    return LayerError(
        rms=told["rms"] / unit,
        mean=told["mean"] / unit,
        max=told["max"] / unit,
        rms_of_original=told["rms_original_to_simplified"] / unit,
        rms_salient=told["rms_salient"] / unit,
        normal_deviation=told["normal_deviation_deg"],
        flipped=int(told["flipped"]),
        intersecting=int(told["intersecting"]),
        parts_gained=int(told["parts_gained"]),
        holes_gained=int(told["holes_gained"]),
        at_original=original,
        at_simplified=simplified,
    )
