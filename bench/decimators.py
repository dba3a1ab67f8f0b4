# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters under comparison, and how one run of them is measured."""

from __future__ import annotations

import statistics
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from meshes import REPOSITORY, read_mesh
from surface import Floats, Ints
from workers import PATIENCE, ask

DEFAULT_PLUGIN = REPOSITORY / "build/plugins/pymeshlab-2025.07/libfilter_curvdecim.so"
_WORKER = Path(__file__).with_name("filter_worker.py")

Parameters = dict[str, Any]

REPRESENTATIVES = ("Quadric", "Mean", "WeightedMean", "Median", "CellCenter")  # of our clustering

# MeshLab's own defaults, all of them: what is not given is taken from the last call.
_MESHLAB_DEFAULTS: Parameters = {
    "targetperc": 0.0,
    "qualitythr": 0.3,
    "preserveboundary": False,
    "boundaryweight": 1.0,
    "preservenormal": False,
    "preservetopology": False,
    "optimalplacement": True,
    "planarquadric": False,
    "planarweight": 0.001,
    "qualityweight": False,
    "autoclean": True,
    "selected": False,
}


@dataclass(frozen=True)
class Decimator:
    """A filter with its parameters, apart from the target.

    cell_parameter: of a clustering that is asked for cells, and not for a number of faces.
    """

    name: str
    filter: str
    plugin: Path | None = None
    parameters: Parameters = field(default_factory=dict)
    cell_parameter: str | None = None


@dataclass(frozen=True)
class Outcome:
    """A simplified mesh: (n, 3) vertices, (m, 3) faces, the median time, the filter's report.

    peak_bytes: how far the process grew during the call; None where it cannot be known.
    """

    vertices: Floats
    faces: Ints
    seconds: float
    report: dict[str, Any]
    peak_bytes: int | None = None


def curvdecim(plugin: Path, name: str = "CurvDecim", **parameters: Any) -> Decimator:
    """Our edge collapse; parameters that are not given have their defaults."""
    return Decimator(name, "meshing_decimation_curvature_edge_collapse", plugin, parameters)


def spheres(plugin: Path, name: str = "Algebraic spheres", **parameters: Any) -> Decimator:
    """Our edge collapse by algebraic spheres; parameters that are not given have their defaults."""
    return Decimator(name, "meshing_decimation_algebraic_sphere", plugin, parameters)


def meshlab(name: str = "MeshLab", **parameters: Any) -> Decimator:
    """MeshLab's own quadric edge collapse with its true defaults, apart from what is given."""
    return Decimator(
        name,
        "meshing_decimation_quadric_edge_collapse",
        parameters=_MESHLAB_DEFAULTS | parameters,
    )


def meshlab_textured(name: str = "MeshLab, with texture") -> Decimator:
    """MeshLab's quadric edge collapse that knows of textures, with its true defaults."""
    return Decimator(
        name,
        "meshing_decimation_quadric_edge_collapse_with_texture",
        parameters={
            "targetperc": 0.0,
            "qualitythr": 0.3,
            "extratcoordw": 1.0,
            "preserveboundary": False,
            "boundaryweight": 1.0,
            "optimalplacement": True,
            "preservenormal": False,
            "planarquadric": False,
            "selected": False,
        },
    )


def meshlab_clustering(name: str = "MeshLab clustering") -> Decimator:
    """MeshLab's clustering; its one parameter, the cell, has to be found for a target."""
    return Decimator(name, "meshing_decimation_clustering", cell_parameter="threshold")


def curvdecim_clustering(
    plugin: Path, name: str = "CurvDecim clustering", by_cell: bool = True, **parameters: Any
) -> Decimator:
    """Our clustering; by_cell: asked for cells, as the other clusterings are."""
    return Decimator(
        name,
        "meshing_decimation_vertex_clustering",
        plugin,
        {"targetfacenum": 0} | parameters,
        "cellsize" if by_cell else None,
    )


def race(
    mesh: Path, target_faces: int, decimators: Sequence[Decimator], repeats: int = 1
) -> list[Outcome]:
    """Every decimator on one mesh, `repeats` times in turn, each run in a fresh process."""
    seconds: list[list[float]] = [[] for _ in decimators]
    outcomes: list[Outcome] = []
    for turn in range(repeats):
        for index, decimator in enumerate(decimators):
            outcome = run_once(mesh, target_faces, decimator)
            seconds[index].append(outcome.seconds)
            if turn == 0:
                outcomes.append(outcome)
    return [
        replace(outcome, seconds=statistics.median(times))
        for outcome, times in zip(outcomes, seconds, strict=True)
    ]


def run_once(
    mesh: Path, target_faces: int, decimator: Decimator, patience: float = PATIENCE
) -> Outcome:
    """One decimator on one mesh, in a fresh process; patience in seconds."""
    parameters = decimator.parameters | {"targetfacenum": target_faces}
    return apply(mesh, decimator, parameters, _what(mesh, target_faces, decimator), patience)


def apply(
    mesh: Path, decimator: Decimator, parameters: Parameters, what: str, patience: float = PATIENCE
) -> Outcome:
    """A filter with exactly these parameters; `what` names the run in a FilterError."""
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "simplified.ply"
        answer = _ask_for(output, mesh, decimator, parameters, what, patience)
        vertices, faces = read_mesh(output)
    return Outcome(vertices, faces, answer["seconds"], answer["report"], answer["peak_bytes"])


def save_once(mesh: Path, target_faces: int, decimator: Decimator, output: Path) -> float:
    """One decimator on one mesh, in a fresh process; the result with all that it carries goes to a
    file. Returns the seconds.
    """
    parameters = decimator.parameters | {"targetfacenum": target_faces}
    what = _what(mesh, target_faces, decimator)
    return _ask_for(output, mesh, decimator, parameters, what, PATIENCE)["seconds"]


def _ask_for(
    output: Path,
    mesh: Path,
    decimator: Decimator,
    parameters: Parameters,
    what: str,
    patience: float,
) -> dict[str, Any]:
    job = _job(mesh, decimator, parameters) | {"output": str(output)}
    return ask([sys.executable, str(_WORKER)], job, what, patience)


def find_cell(
    mesh: Path, target_faces: int, clustering: Decimator, patience: float = PATIENCE
) -> float:
    """The cell of a clustering for the target, as a fraction of the diagonal."""
    job = _job(mesh, clustering, clustering.parameters)
    job |= {"cell_for": target_faces, "cell_parameter": clustering.cell_parameter}
    what = _what(mesh, target_faces, clustering)
    return ask([sys.executable, str(_WORKER)], job, what, patience)["cell"]


def _what(mesh: Path, target_faces: int, decimator: Decimator) -> str:
    return f"{decimator.name} on {mesh.name} to {target_faces} faces"


def _job(mesh: Path, decimator: Decimator, parameters: Parameters) -> dict[str, Any]:
    return {
        "mesh": str(mesh),
        "plugin": str(decimator.plugin.resolve()) if decimator.plugin else None,
        "filter": decimator.filter,
        "parameters": parameters,
    }
