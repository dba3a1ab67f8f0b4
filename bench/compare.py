# SPDX-License-Identifier: GPL-3.0-or-later
"""Our edge collapse against MeshLab's own, on every mesh that is at hand.

    python bench/compare.py                       # PyMeshLab's samples, ../shared/meshes, ours
    python bench/compare.py cow.obj --fraction 0.1 --set metric=Quadric

Ends with 1 when, on some mesh, our RMS is above MeshLab's, our time above a quarter of its time,
the target is missed, or the result is less manifold than the input.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import tables
from decimators import DEFAULT_PLUGIN, Decimator, curvdecim, meshlab
from judge import Figures, topology
from meshes import REPOSITORY, everything
from models import Model, Result
from rich.progress import track
from surface import Surface
from workers import FilterError

_FRACTIONS = (0.20, 0.05)
_LEAST_FACES = 100  # smaller meshes say nothing at 5 %
_TIME_SHARE = 0.25  # of MeshLab's time that ours may take
NO_DISTANCE = 1e-9  # % of the diagonal: rounding; below it an error counts as zero
_RMS_NOISE = 1.001  # sampling repeats the RMS of equal meshes to about this factor

_HEADINGS = (
    "mesh",
    "to",
    "faces",
    "ms",
    "time",
    "RMS %",
    "RMS",
    "max",
    "salient",
    "ndev",
    "flipped",
    "nm edges",
    "boundary",
    "Euler",
    "worse in",
)


@dataclass(frozen=True)
class Duel:
    """One mesh at one target, by our filter and by MeshLab's."""

    mesh: str
    fraction: float
    target: int  # faces
    original: dict[str, int]  # its topology
    our_result: Result
    other_result: Result

    @property
    def ours(self) -> Figures:
        """What the judge says of ours."""
        return self.our_result.figures

    @property
    def other(self) -> Figures:
        """What the judge says of MeshLab's."""
        return self.other_result.figures

    @property
    def ratios(self) -> dict[str, float]:
        """Ours over MeshLab's; below 1 ours is better."""
        figures = {
            name: tables.ratio(getattr(self.ours, name), getattr(self.other, name), NO_DISTANCE)
            for name in ("rms", "max", "rms_salient", "ndev")
        }
        time = self.our_result.milliseconds / self.other_result.milliseconds
        return {"time": time, **figures}

    @property
    def worse_in(self) -> list[str]:
        """What ours was to be better in, and is not."""
        worse = []
        if self.ratios["rms"] > _RMS_NOISE:
            worse.append("RMS")
        if self.ratios["time"] > _TIME_SHARE:
            worse.append("time")
        if self.ours.faces > self.target:
            worse.append("target")
        return worse + self._lost

    @property
    def _lost(self) -> list[str]:
        manifold = self.original["nm_edges"] == 0 and self.original["nm_vertices"] == 0
        lost = []
        if self.ours.nm_edges > self.original["nm_edges"]:
            lost.append("manifold edges")
        if self.ours.nm_vertices > self.original["nm_vertices"]:
            lost.append("manifold vertices")
        if manifold and self.ours.euler != self.original["euler"]:
            lost.append("Euler")
        if self.original["boundary"] == 0 < self.ours.boundary:
            lost.append("closedness")
        return lost

    def row(self) -> list[str]:
        """Cells in the order of the headings."""
        ours, other, ratios = self.ours, self.other, self.ratios
        counts = [
            f"{self.original[name]}>{getattr(ours, name)}/{getattr(other, name)}"
            for name in ("nm_edges", "boundary", "euler")
        ]
        return [
            self.mesh,
            f"{self.fraction:.0%}",
            f"{ours.faces}/{other.faces}",
            f"{self.our_result.milliseconds:.0f}",
            f"{ratios['time']:.3f}",
            f"{ours.rms:.4f}",
            *(f"{ratios[name]:.3f}" for name in ("rms", "max", "rms_salient", "ndev")),
            f"{ours.flipped}/{other.flipped}",
            *counts,
            ", ".join(self.worse_in),
        ]


def main() -> int:
    options = _options()
    console = tables.console()
    ours = curvdecim(options.plugin, **dict(options.set))
    fractions = options.fraction or _FRACTIONS
    duels, failures = [], []
    for path in track(options.meshes or everything(), "comparing", console=console, transient=True):
        try:
            duels += _compare(path, fractions, ours, options.repeats)
        except FilterError as failure:
            failures.append(f"{path.name}: {failure}")
    shown = [_duel_table(duels), _summary_table(duels)]
    for each in shown:
        console.print(each)
    for failure in failures:
        console.print(f"failed: {failure}", markup=False)
    if options.save:
        tables.save_markdown(
            REPOSITORY / "bench/results/compare.md", "Comparison", [__doc__], shown
        )
    return 1 if failures or any(duel.worse_in for duel in duels) else 0


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("meshes", nargs="*", type=Path)
    parser.add_argument("--plugin", type=Path, default=DEFAULT_PLUGIN)
    parser.add_argument("--fraction", type=float, action="append", help="of the faces to keep")
    parser.add_argument("--repeats", type=int, default=3, help="runs for the median time")
    parser.add_argument("--set", type=setting, action="append", default=[], metavar="NAME=VALUE")
    parser.add_argument("--save", action="store_true", help="write bench/results/compare.md")
    return parser.parse_args()


def setting(text: str) -> tuple[str, Any]:
    """'alpha=0.5' as a name and a JSON value, or a plain text where it is not JSON."""
    name, _, value = text.partition("=")
    try:
        return name, json.loads(value)
    except json.JSONDecodeError:
        return name, value


def _compare(
    path: Path, fractions: tuple[float, ...], ours: Decimator, repeats: int
) -> Iterator[Duel]:
    model = Model(path.name, path)
    if len(model.faces) < _LEAST_FACES:
        return
    original = topology(Surface(model.vertices, model.faces))
    for fraction in fractions:
        target = round(fraction * len(model.faces))
        results = model.run(target, [ours, meshlab()], repeats)
        yield Duel(path.name, fraction, target, original, *results)


def _duel_table(duels: list[Duel]) -> tables.Table:
    title = "Ours over MeshLab's: below 1 ours is better; counts are original>ours/MeshLab's"
    return tables.table(title, _HEADINGS, (duel.row() for duel in duels))


def _summary_table(duels: list[Duel]) -> tables.Table:
    rows = []
    for name in duels[0].ratios if duels else ():
        values = np.array([duel.ratios[name] for duel in duels])
        finite = values[(values > 0) & np.isfinite(values)]
        mean = np.exp(np.log(finite).mean())
        rows.append((name, f"{mean:.3f}", f"{values.min():.3f}", f"{values.max():.3f}"))
    return tables.table(
        "All cases; means leave out those without error",
        ("ratio", "geometric mean", "least", "largest"),
        rows,
    )


if __name__ == "__main__":
    sys.exit(main())
