# SPDX-License-Identifier: GPL-3.0-or-later
"""What `same_bits` asks of every filter: a table of parameters, and which of it is slow."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any

EDGES = "meshing_decimation_curvature_edge_collapse"
SPHERES = "meshing_decimation_algebraic_sphere"
REMOVAL = "meshing_decimation_vertex_removal"
CLUSTERS = "meshing_decimation_vertex_clustering"
IMPORTANCE = "compute_scalar_by_curvature_importance"

ERROR = "get_simplification_error"

THREADED = frozenset({EDGES, SPHERES, REMOVAL, CLUSTERS, ERROR})
"""The filters that have a parameter Threads."""

PLAIN, SELECTED, PAINTED, COARSE = "plain", "half selected", "painted", "coarse"
"""The states of a mesh that its worker knows."""

READ_LAYER, COARSE_LAYER = 0, 4
"""What the worker calls the mesh that it has read, and the last one of its states."""

_SLOW_FILTERS = {SPHERES, REMOVAL}
_SLOW_VALUES = {"Eager", "Current", "CurvatureAdditive"}
MOST_FACES_OF_SLOW = 10_000
"""Of a mesh that slow cases are run on."""


@dataclass(frozen=True)
class Case:
    """One filter with its parameters, on a mesh in one of the states."""

    filter: str
    parameters: dict[str, Any]
    state: str = PLAIN

    @property
    def name(self) -> str:
        """Of the parameters and the state, in tables."""
        words = [f"{name}={_shown(value)}" for name, value in self.parameters.items()]
        return " ".join([*words, *([f"({self.state})"] if self.state != PLAIN else [])])

    @property
    def slow(self) -> bool:
        """Whether it is for small meshes only."""
        names = {value for value in self.parameters.values() if isinstance(value, str)}
        return self.filter in _SLOW_FILTERS or bool(names & _SLOW_VALUES)


def _shown(value: Any) -> str:
    return f"{value['percentage']}%" if isinstance(value, dict) else str(value)


def _cases(name: str, state: str = PLAIN, **options: Any) -> Iterator[Case]:
    """Every combination of the options; a tuple is several values."""
    choices = [value if isinstance(value, tuple) else (value,) for value in options.values()]
    for values in itertools.product(*choices):
        yield Case(name, dict(zip(options, values, strict=True)), state)


def _percent(value: float) -> dict[str, float]:
    """A length in per cent of the diagonal, as a worker reads it."""
    return {"percentage": value}


_SWITCH = (False, True)
_PRESETS = ("Fast", "Balanced", "Best")
_METRICS = ("Quadric", "CurvatureWeighted", "CurvatureAdditive")
_UNITS = ("ScaleFree", "ModelUnits")
_KINDS = ("Gaussian", "Absolute")
_OF = ("Input", "Current")
_QUADRICS = ("Memoryless", "Accumulated")
_WEIGHTS = ("Area", "Unit")
_PLACEMENTS = ("Optimal", "Line", "EndpointOrMidpoint", "HalfEdge")
_SCHEDULERS = ("Rounds", "Lazy", "Eager", "FewRounds")
_BORDERS_OF = ("Nothing", "FaceColor", "FaceQuality", "FaceAttributes")
_REPRESENTATIVES = ("Quadric", "Mean", "WeightedMean", "Median", "CellCenter")

_edges = partial(_cases, EDGES, targetperc=0.2)
_custom = partial(_cases, EDGES, targetperc=0.2, preset="Custom")
_spheres = partial(_cases, SPHERES, targetperc=0.2)
_removal = partial(_cases, REMOVAL, targetperc=0.2)
_clusters = partial(_cases, CLUSTERS)
_importance = partial(_cases, IMPORTANCE)
_error = partial(_cases, ERROR, COARSE, originalmesh=READ_LAYER, simplifiedmesh=COARSE_LAYER)


def _with_attributes(asked: partial, **options: Any) -> Iterator[Case]:
    """The same where faces are selected, and where vertices have qualities and colours."""
    yield from asked(SELECTED, **options)
    yield from asked(SELECTED, selected=_SWITCH, **options)
    yield from asked(PAINTED, qualityweight=_SWITCH, **options)


def _stepwise(asked: partial) -> Iterator[Case]:
    """What all filters have that go face by face towards a target."""
    yield from asked(targetperc=(0.05, 0.8))
    yield from asked(targetperc=0.0, targetfacenum=300)
    yield from asked(targetvertnum=200)
    yield from asked(targetperc=0.0, targetfacenum=0, maxerror=_percent(0.5))
    yield from asked(maxerror=_percent(0.1))
    yield from asked(preserveboundary=False)
    yield from asked(boundaryweight=(0.0, 10.0))
    yield from asked(preservenormal=False, targetperc=(0.2, 0.05))
    yield from asked(normalangle=30.0)
    yield from asked(featureangle=(5.0, 180.0))
    yield from asked(joinborders=False)
    yield from asked(keepmap=True)
    yield from asked(keepbordersof=_BORDERS_OF)
    yield from asked(normalangle=0.0)  # refused
    yield from asked(selected=True)  # refused: no face is selected


CASES = (
    *_cases(EDGES),
    *_stepwise(_edges),
    *_edges(preset=_PRESETS, targetperc=(0.2, 0.05)),
    *_edges(preset=_PRESETS, metric=_METRICS),
    *_custom(scheduler=_SCHEDULERS, metric=_METRICS),
    *_custom(
        scheduler=_SCHEDULERS, quadrics=_QUADRICS, planeweight=_WEIGHTS, placement=_PLACEMENTS
    ),
    *_custom(refinesweeps=(1, 2), placement=("Optimal", "HalfEdge")),
    *_edges(alphaunits=_UNITS, curvaturekind=_KINDS, curvatureof=_OF),
    *_edges(alpha=(0.0, 3.0)),
    *_edges(curvaturefloor=(0.0, 1.0)),
    *_edges(metric="CurvatureAdditive", curvatureterm=("Melax", "Literal"), lambda_=(0.001, 0.1)),
    *_edges(preservetopology=False, preset=_PRESETS, targetperc=0.05),
    *_edges(joinborders=_SWITCH, preservetopology=_SWITCH),
    *_edges(attributeweight=(0.0, 1.0)),
    *_edges(maxerror=_percent(0.5), maxerroronesided=True, targetfacenum=0, targetperc=0.0),
    *_edges(preventintersections=True, preset=_PRESETS),
    *_edges(preventintersections=True, targetfacenum=0, targetperc=0.0, maxerror=_percent(0.5)),
    *_edges(pairdistance=_percent(0.5), preset=("Balanced", "Best")),
    *_custom(pairdistance=_percent(0.5), scheduler=("Lazy", "Eager")),
    *_edges(pairdistance=_percent(0.5), maxerror=_percent(0.5)),  # refused
    *_edges(targetperc=0.0, targetfacenum=0, maxerror=_percent(0.5), preset=("Fast", "Best")),
    *_custom(targetperc=0.0, targetfacenum=0, maxerror=_percent(0.5), scheduler=_SCHEDULERS),
    *_custom(targetperc=0.0, targetfacenum=0, maxerror=_percent(0.5), placement=_PLACEMENTS[1:]),
    *_with_attributes(_edges, preset=_PRESETS),
    *_with_attributes(_custom, placement=_PLACEMENTS, scheduler=("Rounds", "Lazy")),
    *_stepwise(_spheres),
    *_spheres(energy=("Squared", "Poster"), placement=("Free3D", "OnSphereAlongEdge")),
    *_spheres(refinesweeps=2),
    *_spheres(kernelscale=3.0),
    *_spheres(adaptivekernel=False),
    *_spheres(preservetopology=False, targetperc=0.05),
    *_spheres(attributeweight=1.0),
    *_spheres(preventintersections=True, refinesweeps=(0, 2)),
    *_spheres(maxerror=_percent(0.5), maxerroronesided=_SWITCH, refinesweeps=2),
    *_with_attributes(_spheres, placement=("Free3D", "OnSphereAlongEdge")),
    *_stepwise(_removal),
    *_removal(criterion=("Heap", "Passes"), preservefeatures=_SWITCH),
    *_removal(criterion=("Heap", "Passes"), distancebound=_percent(0.5)),
    *_removal(showclasses=True, targetperc=(0.2, 1.0), preservefeatures=_SWITCH),
    *_removal(aspectratiomin=0.1),
    *_with_attributes(_removal, criterion=("Heap", "Passes")),
    *_clusters(representative=_REPRESENTATIVES),
    *_clusters(representative=_REPRESENTATIVES, targetperc=0.2),
    *_clusters(representative="WeightedMean", meanweight=("Area", "Curvature")),
    *_clusters(keepmap=True),
    *_clusters(PAINTED, representative="WeightedMean", meanweight=("Area", "Curvature", "Quality")),
    *_clusters(cellsize=(_percent(0.0), _percent(3.0))),  # 0: refused
    *_clusters(targetfacenum=300, manifoldedges=_SWITCH),
    *_clusters(maxerror=_percent(0.5), cellsize=(_percent(0.0), _percent(3.0))),
    *_clusters(cellsize=_percent(3.0), manifoldedges=True),
    *_clusters(boundaryweight=(0.0, 10.0)),
    *_clusters(selected=True),  # refused: no face is selected
    *_with_attributes(_clusters, representative=_REPRESENTATIVES),
    *_with_attributes(_clusters, targetperc=0.2),
    *_importance(
        output=("Curvature", "Factor"), alphaunits=_UNITS, curvaturekind=_KINDS, curvatureof=_OF
    ),
    *_importance(output="Factor", alpha=(0.0, 3.0), curvaturefloor=(0.0, 1.0)),
    *_error(relativeto=("MeshUnit", "Diagonal", "Tolerance"), tolerance=_percent(0.5)),
    *_error(samplenum=5000),
    *_error(simplifiedmesh=READ_LAYER),  # refused
    *_error(savequality=True),
)


def cases_for(faces: int) -> list[Case]:
    """All cases for a mesh of so many faces, without the slow ones where that is many."""
    return [case for case in CASES if faces <= MOST_FACES_OF_SLOW or not case.slow]
