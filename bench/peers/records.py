# SPDX-License-Identifier: GPL-3.0-or-later
"""What was measured, as plain data that a JSON file keeps."""

from __future__ import annotations

import json
import statistics
from collections.abc import Iterable
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

Key = tuple[str, float, str]
"""Mesh, fraction and policy."""


@dataclass(frozen=True)
class Record:
    """One policy on one mesh at one target.

    seconds, peak_bytes: one entry a run. figures: of the judge and of the shape, by name; empty
    where no error was judged. failure: why there is no result; else empty.
    """

    mesh: str
    fraction: float
    target: int  # faces
    faces_before: int
    policy: str
    peer: str
    faces: int = 0
    seconds: list[float] = field(default_factory=list)
    peak_bytes: list[int | None] = field(default_factory=list)
    cell: float | None = None  # of a clustering, as a fraction of the diagonal
    figures: dict[str, Any] = field(default_factory=dict)
    failure: str = ""

    @property
    def key(self) -> Key:
        return self.mesh, self.fraction, self.policy

    @property
    def time(self) -> float:
        """Median, seconds."""
        return statistics.median(self.seconds)

    @property
    def peak(self) -> float | None:
        """Median growth of the process, bytes; None where it is not known."""
        known = [peak for peak in self.peak_bytes if peak is not None]
        return statistics.median(known) if known else None

    @property
    def peak_per_face(self) -> float | None:
        """Bytes a face of the input."""
        return None if self.peak is None else self.peak / self.faces_before

    def figure(self, name: str) -> float | None:
        """A figure by name, 'time' and 'peak' included; None where it was not taken."""
        if self.failure:
            return None
        if name == "time":
            return self.time
        return self.peak if name == "peak" else self.figures.get(name)


@dataclass(frozen=True)
class Results:
    """All of a file. originals: the figures of the meshes before, by name."""

    date: str
    machine: dict[str, str]
    versions: dict[str, str]
    absent: dict[str, str]
    originals: dict[str, dict[str, Any]]
    records: list[Record]

    def save(self, path: Path) -> None:
        """Writes it as JSON."""
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(asdict(self), indent=1) + "\n", encoding="utf-8")


def load(path: Path) -> Results:
    """Reads what `Results.save` wrote."""
    plain = json.loads(path.read_text(encoding="utf-8"))
    return Results(**plain | {"records": [Record(**each) for each in plain["records"]]})


def by_case(records: Iterable[Record]) -> dict[tuple[str, float], dict[str, Record]]:
    """Mesh and fraction to policy to record, in the order in which they were measured."""
    cases: dict[tuple[str, float], dict[str, Record]] = {}
    for record in records:
        cases.setdefault((record.mesh, record.fraction), {})[record.policy] = record
    return cases
