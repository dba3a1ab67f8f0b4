# SPDX-License-Identifier: GPL-3.0-or-later
"""Michaud, Mellado and Paulin 2017: the comparison of their poster, next to what our filter gives.

    python bench/papers/michaud.py [--plugin FILE] [--save] [--times]

The poster simplifies by interpolated algebraic spheres. Its claim: more vertices with a low error
than by plain quadrics. It shows its human at 8,000 faces and its bunny at 12,000, coloured by
error, with histograms, and fertility at 2,000 faces and fandisk without. It prints no figure.

What differs from the poster: its human and fertility are not available; the horse and rocker-arm go
to as many faces in their place, where ../shared/meshes has them, as it has fandisk, whose number of
faces the poster does not say. Plain quadrics are Garland and Heckbert's, accumulated, planes by
area, with our guards.
Errors are those of our filter get_simplification_error, in % of the diagonal; the error of a vertex
is the quality that it writes, the distance to the other surface. Those of the original's vertices
tell how near the result comes to it; those of the simplification's tell where its own vertices lie.
A surface that is as far inside as outside, which is nearest, has its vertices off the original; the
poster's has them on it. Curvature is the mean one, times the diagonal, at 200,000 points of the
original and the nearest ones of the result. Times are medians of three runs on one thread.

Ends with 1 when the default does not have a lower RMS error than plain quadrics on every model, no
smaller share of the original's vertices below 0.05 %, and a lower curvature error on the smooth
models.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import tables
from decimators import Decimator, curvdecim, race, spheres
from error_picture import Shown, as_input, with_errors
from fidelity import CurvatureJudge, share_below
from layer_error import LayerError, Measured, measure, meter_of
from meshes import shared_folder, shipped
from models import Model
from panels import View
from paper_script import PictureRows, Script, Study
from printed import Row, beside, instead

LIMITS = (0.1, 0.05)  # % of the diagonal
REPEATS = 3  # of the timed runs
PLAIN, BALANCED, OURS, POSTER = "Quadrics", "Balanced", "Spheres", "Poster mode"
HISTOGRAM = "a histogram"

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
    """A model of the comparison.

    poster: as the poster names it and its faces. same: it is that mesh, as far as the poster says.
    smooth: it has no sharp edges.
    """

    poster: str
    printed: str
    model: Model
    target: int
    view: View
    same: bool = False
    smooth: bool = True


@dataclass(frozen=True)
class Case:
    """All runs on a model, by name, and the curvature errors of their results."""

    subject: Subject
    runs: dict[str, Measured]
    curvature: dict[str, float]

    @property
    def name(self) -> str:
        return self.subject.model.case_name(self.subject.target)

    def error(self, run: str) -> LayerError:
        return self.runs[run].error

    def share(self, run: str) -> float:
        """Of the original's vertices, with an error below the lower limit."""
        return share_below(self.error(run).at_original, LIMITS[1])

    def holds(self) -> bool:
        """The verdict, as this file's head states it."""
        near = self.share(OURS) >= self.share(PLAIN)
        lower = self.error(OURS).rms < self.error(PLAIN).rms
        alike = self.curvature[OURS] < self.curvature[PLAIN] or not self.subject.smooth
        return near and lower and alike


def subjects() -> list[Subject]:
    """The poster's models, or what stands in for them, as far as they are at hand."""
    bunny_view, z = View((0.1, 0.15, 1.0)), (0.0, 0.0, 1.0)
    bunny = Model("bunny", shipped("bunny.obj"))
    found = [Subject("bunny, to 12,000", HISTOGRAM, bunny, 12_000, bunny_view, same=True)]
    for poster, printed, file, target, view, same in (
        ("human, to 8,000", HISTOGRAM, "horse.ply", 8_000, View((1.0, 0.25, 0.3), z), False),
        ("fertility, to 2,000", "views", "rocker-arm.obj", 2_000, View((0.3, 1.0, 0.5), z), False),
        ("fandisk", "views", "fandisk.obj", 1_294, View((0.6, 0.5, 1.0)), True),
    ):
        path = shared_folder() / file
        if path.is_file():
            model = Model(path.stem, path)
            found.append(Subject(poster, printed, model, target, view, same, file != "fandisk.obj"))
    return found


def contenders(plugin: Path) -> list[Decimator]:
    return [
        curvdecim(plugin, PLAIN, threads=1, **PLAIN_SETTINGS),
        curvdecim(plugin, BALANCED, threads=1),
        spheres(plugin, OURS, threads=1),
        spheres(plugin, POSTER, threads=1, **POSTER_SETTINGS),
    ]


def run_case(plugin: Path, subject: Subject) -> Case:
    model = subject.model
    runs = measure(plugin, model, subject.target, contenders(plugin))
    judge = CurvatureJudge(model.vertices, model.faces)
    outcomes = {name: run.outcome for name, run in runs.items()}
    curvature = {name: judge(each.vertices, each.faces) for name, each in outcomes.items()}
    return Case(subject, runs, curvature)


# --- tables ---------------------------------------------------------------------------------------


def poster_table(done: Sequence[Case]) -> tables.Table:
    """What the poster shows, and the figures that it leaves out."""
    runs = (PLAIN, POSTER, OURS)
    figures = (f"below {LIMITS[1]} %", "RMS", "max")
    rows = []
    for case in done:
        shares = [f"{100 * case.share(run):.2f}" for run in runs]
        rms = [f"{case.error(run).rms:.4f}" for run in runs]
        largest = [f"{case.error(run).max:.3f}" for run in runs]
        name = case.name if case.subject.same else instead(case.name)
        printed = (case.subject.printed, "no figures")
        row = [" / ".join(each) for each in (shares, rms, largest)]
        rows.append(Row(case.subject.poster, printed, name, row))
    title = f"The poster's models: {' / '.join(runs)}; vertices of the original in %, distances in"
    return beside(f"{title} % of the diagonal", ("shown", "errors"), figures, rows)


def share_table(title: str, done: Sequence[Case], direction: str) -> tables.Table:
    """direction: the field of LayerError."""
    runs = (PLAIN, BALANCED, OURS, POSTER)
    headings = ("model", *(f"{run}, below {limit} %" for limit in LIMITS for run in runs))
    table = tables.table(title, headings)
    for case in done:
        errors = [getattr(case.error(run), direction) for run in runs]
        shares = [share_below(each, limit) for limit in LIMITS for each in errors]
        table.add_row(case.name, *(f"{100 * share:.2f}" for share in shares))
    return table


def error_table(done: Sequence[Case]) -> tables.Table:
    headings = ("model", "run", "RMS", "/ quadrics", "/ Balanced", "mean", "maximum")
    headings += ("most curved fifth", "normals, degrees", "curvature")
    table = tables.table("Distances in % of the diagonal, errors of normals, curvature", headings)
    for case in done:
        for run in case.runs:
            table.add_row(case.name, run, *_error_cells(case, run))
    return table


def _error_cells(case: Case, run: str) -> list[str]:
    error = case.error(run)
    ratios = [error.rms / case.error(base).rms for base in (PLAIN, BALANCED)]
    return [
        f"{error.rms:.5f}",
        *(f"{ratio:.3f}" for ratio in ratios),
        f"{error.mean:.5f}",
        f"{error.max:.3f}",
        f"{error.rms_salient:.5f}",
        f"{error.normal_deviation:.2f}",
        f"{case.curvature[run]:.3f}",
    ]


def shown_tables(done: Sequence[Case]) -> list[tables.Table]:
    title = "% of the {} vertices with a low error"
    return [
        poster_table(done),
        share_table(title.format("original's"), done, "at_original"),
        share_table(title.format("simplification's"), done, "at_simplified"),
        error_table(done),
    ]


def times(plugin: Path) -> list[tables.Table]:
    """Ratios to Balanced."""
    runs = contenders(plugin)
    table = tables.table("Time over that of Balanced", ("model", *(run.name for run in runs)))
    for subject in subjects():
        model = subject.model
        outcomes = race(model.path, subject.target, runs, REPEATS)
        seconds = {run.name: each.seconds for run, each in zip(runs, outcomes, strict=True)}
        ratios = (each / seconds[BALANCED] for each in seconds.values())
        table.add_row(model.case_name(subject.target), *(f"{ratio:.2f}" for ratio in ratios))
    return [table]


# --- the picture ----------------------------------------------------------------------------------


def picture(plugin: Path, done: Sequence[Case]) -> PictureRows:
    """The poster's two pictures with histograms: results side by side, coloured by error."""
    shown = [case for case in done if case.subject.printed == HISTOGRAM]
    return [(case.subject.view, _row(plugin, case)) for case in shown]


def _row(plugin: Path, case: Case) -> list[Shown]:
    model = case.subject.model
    meter, row = meter_of(plugin, model), [as_input(model.vertices, model.faces, model.name)]
    titles = {POSTER: "the poster's metric, as printed", PLAIN: "quadrics", OURS: "our default"}
    for run, title in titles.items():
        outcome = case.runs[run].outcome
        row.append(with_errors(meter, outcome.vertices, outcome.faces, title))
    return row


def study(plugin: Path) -> Study:
    done = [run_case(plugin, subject) for subject in subjects()]
    holds = all(case.holds() for case in done)
    return Study(shown_tables(done), holds, lambda: picture(plugin, done))


if __name__ == "__main__":
    sys.exit(Script(__file__, __doc__, "Michaud, Mellado and Paulin 2017", study, times).main())
