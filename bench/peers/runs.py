# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures all policies on one mesh at one target: in turn, then judges when the clocks rest."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

from decimators import Outcome
from judge import Judge, topology
from shape import shape_of
from surface import Surface
from workers import FilterError

from peers.adapters import Goal
from peers.mesh_files import MeshFiles
from peers.policies import Policy
from peers.records import Record


@dataclass(frozen=True)
class Case:
    """One mesh at one target; judge: None where no error is judged. patience in seconds."""

    mesh: MeshFiles
    fraction: float
    judge: Judge | None
    patience: float

    @property
    def target(self) -> int:
        """Faces."""
        return round(self.fraction * self.mesh.face_count)


@dataclass
class _Contender:
    """A policy at work on a case."""

    policy: Policy
    goal: Goal
    seconds: list[float] = field(default_factory=list)
    peak_bytes: list[int | None] = field(default_factory=list)
    outcome: Outcome | None = None
    failure: str = ""

    def take_turn(self) -> None:
        """One more run; a failure ends them."""
        if self.failure:
            return
        try:
            outcome = self.policy.adapter.run(self.goal)
        except FilterError as failure:
            self.failure = str(failure)
            return
        self.seconds.append(outcome.seconds)
        self.peak_bytes.append(outcome.peak_bytes)
        self.outcome = self.outcome or outcome


def measure(
    case: Case, policies: Sequence[Policy], repeats: int, advance: Callable[[str], None]
) -> list[Record]:
    """A record a policy; `advance` hears of every step of `steps` what is done next."""
    contenders = []
    for policy in policies:
        advance(f"{policy.name}: set up")
        contenders.append(_contender(case, policy))
    for _ in range(repeats):
        for contender in contenders:
            advance(contender.policy.name)
            contender.take_turn()
    records = []
    for contender in contenders:
        advance(f"{contender.policy.name}: judged")
        records.append(_record(case, contender))
    return records


def steps(policies: Sequence[Policy], repeats: int) -> int:
    """How often `measure` advances."""
    return len(policies) * (repeats + 2)


def figures_of(surface: Surface) -> dict[str, Any]:
    """What a mesh is like by itself."""
    return topology(surface) | asdict(shape_of(surface))


def _contender(case: Case, policy: Policy) -> _Contender:
    what = f"{policy.name} on {case.mesh.name} to {case.target} faces"
    goal = Goal(case.mesh, case.target, what, case.patience, policy.diagonal)
    if not policy.adapter.clusters:
        return _Contender(policy, goal)
    try:
        cell = policy.adapter.find_cell(goal)
    except FilterError as failure:
        return _Contender(policy, goal, failure=str(failure))
    return _Contender(
        policy, Goal(case.mesh, case.target, what, case.patience, policy.diagonal, cell)
    )


def _record(case: Case, contender: _Contender) -> Record:
    faces, figures, failure = 0, {}, contender.failure
    if contender.outcome is not None and not failure:
        faces = len(contender.outcome.faces)
        failure = "" if faces else "no face is left"
        if faces and case.judge:
            figures = _judged(case.judge, contender.outcome)
    return Record(
        mesh=case.mesh.name,
        fraction=case.fraction,
        target=case.target,
        faces_before=case.mesh.face_count,
        policy=contender.policy.name,
        peer=contender.policy.peer,
        faces=faces,
        seconds=contender.seconds,
        peak_bytes=contender.peak_bytes,
        cell=contender.goal.cell,
        figures=figures,
        failure=failure,
    )


def _judged(judge: Judge, outcome: Outcome) -> dict[str, Any]:
    figures = asdict(judge(outcome.vertices, outcome.faces))
    del figures["rms_regions"]
    return figures | asdict(shape_of(Surface(outcome.vertices, outcome.faces)))
