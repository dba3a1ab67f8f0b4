# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters under comparison, and how one run of them is measured."""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from meshes import REPOSITORY, read_mesh
from surface import Floats, Ints

DEFAULT_PLUGIN = REPOSITORY / "build/plugins/pymeshlab-2025.07/libfilter_curvdecim.so"
_WORKER = Path(__file__).with_name("filter_worker.py")
_SECONDS_PATIENCE = 1800  # then a filter counts as hung

Parameters = dict[str, Any]

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


class FilterError(RuntimeError):
    """A filter ended with an error; the message says which, on what, and its last words."""


@dataclass(frozen=True)
class Decimator:
    """A filter with its parameters, apart from the target."""

    name: str
    filter: str
    plugin: Path | None = None
    parameters: Parameters = field(default_factory=dict)


@dataclass(frozen=True)
class Outcome:
    """A simplified mesh: (n, 3) vertices, (m, 3) faces, the median time, the filter's report."""

    vertices: Floats
    faces: Ints
    seconds: float
    report: dict[str, Any]


def curvdecim(plugin: Path, name: str = "CurvDecim", **parameters: Any) -> Decimator:
    """Our edge collapse; parameters that are not given have their defaults."""
    return Decimator(name, "meshing_decimation_curvature_edge_collapse", plugin, parameters)


def meshlab() -> Decimator:
    """MeshLab's own quadric edge collapse with its true defaults."""
    return Decimator(
        "MeshLab", "meshing_decimation_quadric_edge_collapse", parameters=_MESHLAB_DEFAULTS
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
        Outcome(outcome.vertices, outcome.faces, statistics.median(times), outcome.report)
        for outcome, times in zip(outcomes, seconds, strict=True)
    ]


def run_once(mesh: Path, target_faces: int, decimator: Decimator) -> Outcome:
    """One decimator on one mesh, in a fresh process."""
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "simplified.ply"
        answer = _ask_worker(mesh, target_faces, decimator, output)
        return Outcome(*read_mesh(output), answer["seconds"], answer["report"])


def _ask_worker(mesh: Path, target_faces: int, decimator: Decimator, output: Path) -> dict:
    job = {
        "mesh": str(mesh),
        "plugin": str(decimator.plugin.resolve()) if decimator.plugin else None,
        "filter": decimator.filter,
        "parameters": decimator.parameters | {"targetfacenum": target_faces},
        "output": str(output),
    }
    what = f"{decimator.name} on {mesh.name} to {target_faces} faces"
    try:
        done = subprocess.run(
            [sys.executable, str(_WORKER)],
            input=json.dumps(job),
            capture_output=True,
            text=True,
            timeout=_SECONDS_PATIENCE,
            check=False,
        )
    except subprocess.TimeoutExpired as late:
        raise FilterError(f"{what}: no end after {_SECONDS_PATIENCE} s") from late
    if done.returncode != 0:
        raise FilterError(f"{what}: exit code {done.returncode}\n{done.stderr.strip()[-2000:]}")
    return json.loads(done.stdout.splitlines()[-1])
