# SPDX-License-Identifier: GPL-3.0-or-later
"""How each kind of peer is run: a program, a Python library, or a filter in PyMeshLab.

Every run is a fresh process, and its clock covers the decimation alone.
"""

from __future__ import annotations

import tempfile
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Protocol

from binary_mesh import read_binary
from decimators import Decimator, Outcome, apply, find_cell, run_once
from meshes import REPOSITORY
from workers import ask

from peers.mesh_files import MeshFiles

BUILD = REPOSITORY / "build/peers"
PROGRAMS = BUILD / "programs"
LIBRARY_PYTHON = BUILD / "venv/bin/python"
LIBRARY_WORKER = REPOSITORY / "bench/library_worker.py"


@dataclass(frozen=True)
class Goal:
    """One mesh, one face count; `what` names the run in errors, `patience` is in seconds.

    diagonal: the mesh is scaled to it for the run, and back afterwards; None: as it is.
    cell: of a clustering, as a fraction of the diagonal.
    """

    mesh: MeshFiles
    target: int
    what: str
    patience: float
    diagonal: float | None = None
    cell: float | None = None

    def unscaled(self, outcome: Outcome) -> Outcome:
        """The outcome in the mesh's own unit."""
        return replace(outcome, vertices=outcome.vertices / self.mesh.scale(self.diagonal))


class Adapter(Protocol):
    """What runs a peer. Both methods raise FilterError."""

    @property
    def clusters(self) -> bool:
        """Whether it takes a cell instead of a target."""

    def find_cell(self, goal: Goal) -> float:
        """The cell that leaves the number of faces nearest to the target."""

    def run(self, goal: Goal) -> Outcome:
        """The simplified mesh in the mesh's own unit, with the time and the memory of the call."""


@dataclass(frozen=True)
class Program:
    """One of the C++ programs beside this file, with a policy that it knows."""

    program: str
    policy: str
    clusters: bool = False

    def find_cell(self, goal: Goal) -> float:
        """No program needs one."""
        raise NotImplementedError(f"{goal.what}: {self.program} takes a number of faces")

    def run(self, goal: Goal) -> Outcome:
        """Runs the program."""
        mesh = str(goal.mesh.binary(goal.diagonal))
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder) / "simplified.bin"
            command = [PROGRAMS / self.program, self.policy, goal.target, mesh, output]
            answer = ask([str(word) for word in command], None, goal.what, goal.patience)
            return _outcome(goal, answer, output)


@dataclass(frozen=True)
class Library:
    """A policy of library_worker.py."""

    policy: str
    clusters: bool = False

    def find_cell(self, goal: Goal) -> float:
        """Asks the worker to look for it."""
        return self._ask(goal, None)["cell"]

    def run(self, goal: Goal) -> Outcome:
        """Runs the worker in the peers' environment."""
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder) / "simplified.bin"
            return _outcome(goal, self._ask(goal, output), output)

    def _ask(self, goal: Goal, output: Path | None) -> dict[str, Any]:
        job = {
            "mesh": str(goal.mesh.binary(goal.diagonal)),
            "policy": self.policy,
            "target": goal.target,
            "cell": goal.cell,
            "output": str(output) if output else None,
        }
        command = [str(LIBRARY_PYTHON), str(LIBRARY_WORKER)]
        return ask(command, job, goal.what, goal.patience)


@dataclass(frozen=True)
class HostFilter:
    """A filter in PyMeshLab: ours, or one of MeshLab's."""

    decimator: Decimator

    @property
    def clusters(self) -> bool:
        """Whether it takes a cell instead of a target."""
        return self.decimator.cell_parameter is not None

    def find_cell(self, goal: Goal) -> float:
        """Asks the worker to look for it."""
        mesh = goal.mesh.ply(goal.diagonal)
        return find_cell(mesh, goal.target, self.decimator, goal.patience)

    def run(self, goal: Goal) -> Outcome:
        """Applies the filter."""
        mesh = goal.mesh.ply(goal.diagonal)
        cell_parameter = self.decimator.cell_parameter
        if cell_parameter is not None:
            assert goal.cell is not None
            cell = {cell_parameter: {"percentage": 100 * goal.cell}}
            parameters = self.decimator.parameters | cell
            outcome = apply(mesh, self.decimator, parameters, goal.what, goal.patience)
        else:
            outcome = run_once(mesh, goal.target, self.decimator, goal.patience)
        return goal.unscaled(outcome)


def _outcome(goal: Goal, answer: dict[str, Any], output: Path) -> Outcome:
    vertices, faces = read_binary(output)
    outcome = Outcome(vertices, faces.astype("int64"), answer["seconds"], {}, answer["peak_bytes"])
    return goal.unscaled(outcome)
