# SPDX-License-Identifier: GPL-3.0-or-later
"""Michaud, Mellado and Paulin 2017: the comparison of their poster, next to what our filter gives.

    python bench/papers/michaud.py [--plugin FILE] [--save]

The poster simplifies by interpolated algebraic spheres. Its claim: more vertices with a low error
than by plain quadrics; it shows the bunny at 12,000 faces and fandisk, coloured by error, with
histograms.

What differs from the poster: its human and fertility are not available; the horse and rocker-arm
stand in where ../shared/meshes has them, as it has fandisk. The poster gives no numbers, nor the
number of faces of its fandisk. Plain quadrics are Garland and Heckbert's, accumulated, planes by
area, with our guards.
A vertex error is the distance from a vertex to the other surface, in % of the diagonal. Those of
the original's vertices tell how near the result comes to it; those of the simplification's tell
where its own vertices lie. A surface that is as far inside as outside, which is nearest, has its
vertices off the original; the poster's has them on it. Curvature is the mean one, times the
diagonal, at 200,000 points of the original and the nearest ones of the result. Times are medians of
three runs on one thread, of the filter as PyMeshLab calls it.

Ends with 1 when the default does not have a lower RMS error than plain quadrics on every model and
than the preset Balanced on the smooth ones, no smaller shares of the original's vertices below 0.1
and 0.05 %, and a lower curvature error on the smooth models.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import tables
from decimators import Decimator, curvdecim, spheres
from error_picture import Shown, draw_errors
from fidelity import Fidelity, FidelityJudge, share_below
from meshes import REPOSITORY, shared_folder, shipped
from models import Model, Result
from panels import View
from paper_options import paper_options
from workers import FilterError

LIMITS = (0.1, 0.05)  # % of the diagonal
REPEATS = 3
PLAIN, BALANCED, OURS, POSTER = "Quadrics", "Balanced", "Spheres", "Poster mode"

# Garland and Heckbert's algorithm.
PLAIN_SETTINGS = {
    "preset": "Custom",
    "metric": "Quadric",
    "quadrics": "Accumulated",
    "scheduler": "Lazy",
}
POSTER_SETTINGS = {"energy": "Poster", "placement": "OnSphereAlongEdge"}


@dataclass(frozen=True)
class Subject:
    """A model of the comparison; smooth: it has no sharp edges."""

    model: Model
    target: int
    view: View
    smooth: bool = True


@dataclass(frozen=True)
class Run:
    """A result with what both judges say of it."""

    result: Result
    fidelity: Fidelity


@dataclass(frozen=True)
class Case:
    """All runs on a model, by name."""

    subject: Subject
    runs: dict[str, Run]

    @property
    def name(self) -> str:
        return self.subject.model.case_name(self.subject.target)

    def rms(self, run: str) -> float:
        return self.runs[run].result.figures.rms

    def holds(self) -> bool:
        """The verdict, as this file's head states it."""
        ours, plain = self.runs[OURS].fidelity, self.runs[PLAIN].fidelity
        near = all(
            share_below(ours.of_original, limit) >= share_below(plain.of_original, limit)
            for limit in LIMITS
        )
        if not self.subject.smooth:
            return near and self.rms(OURS) <= self.rms(PLAIN)
        return (
            near
            and ours.curvature < plain.curvature
            and self.rms(OURS) <= min(self.rms(PLAIN), self.rms(BALANCED))
        )


def subjects() -> list[Subject]:
    """The poster's models, or what stands in for them, as far as they are at hand."""
    found = [Subject(Model("bunny", shipped("bunny.obj")), 12_000, View((0.1, 0.15, 1.0)))]
    for file, target, view, smooth in (
        ("fandisk.obj", 1_294, View((0.6, 0.5, 1.0)), False),
        ("horse.ply", 9_696, View((1.0, 0.25, 0.3), (0.0, 0.0, 1.0)), True),
        ("rocker-arm.obj", 4_000, View((0.3, 1.0, 0.5), (0.0, 0.0, 1.0)), True),
    ):
        path = shared_folder() / file
        if path.is_file():
            found.append(Subject(Model(path.stem, path), target, view, smooth))
    return found


def contenders(plugin: Path) -> list[Decimator]:
    return [
        curvdecim(plugin, PLAIN, threads=1, **PLAIN_SETTINGS),
        curvdecim(plugin, BALANCED, threads=1),
        spheres(plugin, OURS, threads=1),
        spheres(plugin, POSTER, threads=1, **POSTER_SETTINGS),
    ]


def run_case(plugin: Path, subject: Subject) -> Case:
    model, runs = subject.model, contenders(plugin)
    judge = FidelityJudge(model.vertices, model.faces)
    results = model.run(subject.target, runs, REPEATS)
    return Case(
        subject,
        {
            run.name: Run(result, judge(result.outcome.vertices, result.outcome.faces))
            for run, result in zip(runs, results, strict=True)
        },
    )


def share_table(title: str, done: Sequence[Case], direction: str) -> tables.Table:
    """direction: the field of Fidelity."""
    runs = (PLAIN, BALANCED, OURS, POSTER)
    headings = ("model", *(f"{run}, below {limit} %" for limit in LIMITS for run in runs))
    table = tables.table(title, headings)
    for case in done:
        errors = [getattr(case.runs[run].fidelity, direction) for run in runs]
        shares = [share_below(each, limit) for limit in LIMITS for each in errors]
        table.add_row(case.name, *(f"{100 * share:.2f}" for share in shares))
    return table


def error_table(done: Sequence[Case]) -> tables.Table:
    headings = ("model", "run", "RMS", "/ quadrics", "/ Balanced", "maximum", "curvature", "time")
    table = tables.table(
        "RMS and maximum in % of the diagonal, curvature error, time as a ratio to Balanced",
        headings,
    )
    for case in done:
        for name, run in case.runs.items():
            figures, time = run.result.figures, run.result.milliseconds
            ratio = time / case.runs[BALANCED].result.milliseconds
            over_plain, over_balanced = (case.rms(name) / case.rms(x) for x in (PLAIN, BALANCED))
            ratios = f"{over_plain:.3f}", f"{over_balanced:.3f}"
            table.add_row(
                case.name,
                name,
                f"{figures.rms:.5f}",
                *ratios,
                f"{figures.max:.3f}",
                f"{run.fidelity.curvature:.3f}",
                f"{ratio:.2f}",
            )
    return table


def shown_tables(done: Sequence[Case]) -> list[tables.Table]:
    original, simplified = "original's", "simplification's"
    title = "% of the {} vertices with a low error"
    return [
        share_table(title.format(original), done, "of_original"),
        share_table(title.format(simplified), done, "of_simplified"),
        error_table(done),
    ]


def draw(done: Sequence[Case], path: Path) -> None:
    """As the poster: both results side by side, coloured by error, with the histograms."""
    rows = []
    for case in done:
        shown = [
            Shown(
                run.result.outcome.vertices,
                run.result.outcome.faces,
                run.fidelity.of_simplified,
                run.fidelity.of_original,
                f"{case.subject.model.name}, {len(run.result.outcome.faces):,} faces: {name}",
                f"RMS {run.result.figures.rms:.4f} % of the diagonal",
            )
            for name, run in case.runs.items()
            if name in (OURS, PLAIN)
        ]
        rows.append((case.subject.view, shown[::-1]))
    draw_errors(path, rows)


def main() -> int:
    """Prints every table; the exit code is the verdict."""
    options = paper_options(__doc__)
    console = tables.console()
    try:
        done = [run_case(options.plugin, subject) for subject in subjects()]
    except FilterError as failure:
        console.print(f"failed: {failure}", markup=False)
        return 1
    shown = shown_tables(done)
    for each in shown:
        console.print(each)
    if options.save:
        path = REPOSITORY / "bench/results/michaud.md"
        tables.save_markdown(path, "Michaud, Mellado and Paulin 2017", [__doc__], shown)
        draw(done, REPOSITORY / "docs/images/michaud.png")
    return 0 if all(case.holds() for case in done) else 1


if __name__ == "__main__":
    sys.exit(main())
