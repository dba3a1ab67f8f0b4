# SPDX-License-Identifier: GPL-3.0-or-later
"""Schroeder, Zarge and Lorensen 1992: our vertex removal beside VTK's, and the slides' series.

    python bench/papers/schroeder.py [--plugin FILE] [--save] [--times]

The series is that of the CS3621 slides on vertex decimation, 9,248 faces to 7,184, 5,120, 992 and
592. They print vertices, edges and faces, and no error. Their mesh is not available; PyMeshLab's
bunny, brought to 9,248 faces by edge collapse, stands in for it.

VTK's DecimatePro is the same algorithm by its first author. Both go to the same number of faces,
VTK with its defaults, by which it may split the mesh to get there. Distances and defects are those
of our filter get_simplification_error, two-sided, % of the diagonal. With --times the clocks cover
the call alone: VTK's update, and our filter in PyMeshLab with what the host does around it; each is
the median of three runs in fresh processes. One thread: removal is sequential.

Meshes: PyMeshLab's cow, bone and bunny; five more where ../shared/meshes has them.

Ends with 1 when, with the criterion Heap, an RMS, a mean or a maximum is above VTK's, when a hole
or a part is there that the original has not, or when a target is missed.
"""

from __future__ import annotations

import statistics
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import numpy as np
import tables
from binary_mesh import read_binary, write_binary
from decimators import Decimator, Outcome, curvdecim, race
from error_picture import as_input, with_errors
from layer_error import LayerError, Measured, measure, meter_of
from meshes import REPOSITORY, shared_folder, shipped, write_mesh
from models import Model
from panels import View
from paper_script import PictureRows, Script, Study
from printed import Row, beside, instead
from surface import Ints
from workers import ask

SHIPPED = ("cow.obj", "bone.ply", "bunny.obj")
SHARED = ("fandisk.obj", "rocker-arm.obj", "horse.ply", "stanford-bunny.obj", "igea.ply")
FRACTIONS = (0.2, 0.05)
REPEATS = 3
VTK, HEAP, PASSES = "DecimatePro", "Heap", "Passes"
RATIOS = (f"{HEAP} / {VTK}", f"{PASSES} / {VTK}")
SERIES = (9248, 7184, 5120, 992, 592)
SLIDES = {9248: (4632, 13872), 7184: (3602, 10776), 5120: (2570, 7680), 992: (506, 1488)}
SLIDES |= {592: (306, 888)}  # vertices and edges, as printed
WORKER = REPOSITORY / "bench/library_worker.py"
BUNNY_VIEW = View((0.2, 0.15, 1.0))


@dataclass(frozen=True)
class Case:
    """A model at a number of faces: what each program made of it."""

    model: Model
    faces: int
    runs: dict[str, Measured]

    @property
    def name(self) -> str:
        return self.model.case_name(self.faces)

    def errors(self) -> list[LayerError]:
        """Of VTK, Heap and Passes."""
        return [self.runs[run].error for run in (VTK, HEAP, PASSES)]

    def ratios(self, run: str) -> tuple[float, float, float]:
        """RMS, mean and maximum over those of VTK."""
        one, base = self.runs[run].error, self.runs[VTK].error
        return one.rms / base.rms, one.mean / base.mean, one.max / base.max


# --- runs -----------------------------------------------------------------------------------------


def removal(plugin: Path, criterion: str) -> Decimator:
    """Our filter with its defaults but for the criterion."""
    return Decimator(
        criterion, "meshing_decimation_vertex_removal", plugin, {"criterion": criterion}
    )


def decimate_pro(model: Model, target: int, repeats: int = 1) -> Outcome:
    """VTK's defaults, in a process of its own for every run."""
    with tempfile.TemporaryDirectory() as folder:
        mesh, output = Path(folder) / "mesh.bin", Path(folder) / "simplified.bin"
        write_binary(mesh, model.vertices, model.faces)
        job = {"mesh": str(mesh), "output": str(output), "target": target}
        job |= {"policy": "vtk.decimate-pro", "cell": None}
        command = [sys.executable, str(WORKER)]
        what = f"{VTK} on {model.name} to {target} faces"
        seconds = [ask(command, job, what)["seconds"] for _ in range(repeats)]
        vertices, faces = read_binary(output)
    return Outcome(vertices, faces.astype("int64"), statistics.median(seconds), {})


def run_case(plugin: Path, model: Model, target: int) -> Case:
    vtk = decimate_pro(model, target)
    ours = [removal(plugin, criterion) for criterion in (HEAP, PASSES)]
    runs = measure(plugin, model, len(vtk.faces), ours)
    runs[VTK] = Measured(vtk, meter_of(plugin, model)(vtk.vertices, vtk.faces))
    return Case(model, len(vtk.faces), runs)


def models() -> list[Model]:
    """Those that are there."""
    files = [shipped(name) for name in SHIPPED]
    files += [path for name in SHARED if (path := shared_folder() / name).is_file()]
    return [Model(path.stem, path) for path in files]


# --- tables of all meshes -------------------------------------------------------------------------


def error_table(done: Sequence[Case]) -> tables.Table:
    """RMS, mean and maximum of each program."""
    headings = ["mesh"]
    names = ("RMS", "mean", "max")
    headings += [f"{figure} {run}" for figure in names for run in (VTK, HEAP, PASSES)]
    table = tables.table("Two-sided distance, % of the diagonal", headings)
    for case in done:
        errors = case.errors()
        cells = [f"{error.rms:.4f}" for error in errors]
        cells += [f"{error.mean:.4f}" for error in errors]
        cells += [f"{error.max:.3f}" for error in errors]
        table.add_row(case.name, *cells)
    return table


def defect_table(done: Sequence[Case]) -> tables.Table:
    """What is there that should not be."""
    headings = ("mesh", "holes gained", "parts gained", "flipped", "self-intersecting")
    table = tables.table(f"Defects: {VTK} / {HEAP} / {PASSES}", headings)
    for case in done:
        kinds = ("holes_gained", "parts_gained", "flipped", "intersecting")
        table.add_row(case.name, *(_three(case, kind) for kind in kinds))
    return table


def _three(case: Case, kind: str) -> str:
    return " / ".join(f"{getattr(error, kind):,}" for error in case.errors())


def summary_table(done: Sequence[Case]) -> tables.Table:
    """Ratios to VTK."""
    headings = ("criterion", "RMS", "mean", "maximum")
    table = tables.table(f"Ratios to {VTK}: geometric mean (worst)", headings)
    for run in (HEAP, PASSES):
        ratios = np.array([case.ratios(run) for case in done])
        means, worst = np.exp(np.log(ratios).mean(axis=0)), ratios.max(axis=0)
        table.add_row(run, *(f"{m:.2f} ({w:.2f})" for m, w in zip(means, worst, strict=True)))
    return table


# --- the slides' series --------------------------------------------------------------------------


@dataclass(frozen=True)
class Series:
    """The mesh that stands in for the slides', and what each program makes of it, by the target."""

    model: Model
    removed: dict[int, Measured]
    vtk: dict[int, Measured]

    def table(self) -> tables.Table:
        """Counts as printed beside ours, with the errors that the slides leave out."""
        printed, ours = ("F", "V", "E"), ("F", "V", "E", "RMS", "max", f"{VTK} RMS", "max")
        rows = [self._row(target) for target in SERIES]
        title = "The slides' series; distances in % of the diagonal"
        return beside(title, printed, ours, rows)

    def _row(self, target: int) -> Row:
        printed = tuple(f"{count:,}" for count in (target, *SLIDES[target]))
        name = instead(f"bunny, {SERIES[0]:,} faces")
        if target == SERIES[0]:
            return Row("input", printed, name, _counts(self.model.vertices, self.model.faces))
        outcome = self.removed[target].outcome
        both = (self.removed[target].error, self.vtk[target].error)
        errors = (cell for each in both for cell in (f"{each.rms:.4f}", f"{each.max:.3f}"))
        return Row("the same", printed, name, (*_counts(outcome.vertices, outcome.faces), *errors))


def _counts(vertices: np.ndarray, faces: Ints) -> tuple[str, ...]:
    edges = len(np.unique(np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)), axis=0))
    return tuple(f"{count:,}" for count in (len(faces), len(vertices), edges))


def run_series(plugin: Path, folder: Path) -> Series:
    """Every number of faces from the first; the stand-in goes into the folder."""
    [first] = race(shipped("bunny.obj"), SERIES[0], [curvdecim(plugin)])
    path = folder / "bunny.ply"
    write_mesh(path, first.vertices, first.faces)
    model = Model("bunny", path)
    meter = meter_of(plugin, model)
    removed, vtk = {}, {}
    for target in SERIES[1:]:
        removed[target] = measure(plugin, model, target, [removal(plugin, HEAP)])[HEAP]
        other = decimate_pro(model, target)
        vtk[target] = Measured(other, meter(other.vertices, other.faces))
    return Series(model, removed, vtk)


def picture(plugin: Path, series: Series) -> PictureRows:
    """The last two steps of the series, and the last one of VTK."""
    model = series.model
    meter, row = meter_of(plugin, model), [as_input(model.vertices, model.faces, model.name)]
    *_, before, last = SERIES
    for run, title in (
        (series.removed[before], "vertex removal"),
        (series.removed[last], "vertex removal"),
        (series.vtk[last], VTK),
    ):
        row.append(with_errors(meter, run.outcome.vertices, run.outcome.faces, title))
    return [(BUNNY_VIEW, row)]


# --- the script -----------------------------------------------------------------------------------


def holds(done: Sequence[Case]) -> bool:
    """The claim, as this file's head states it."""
    return all(
        max(case.ratios(HEAP)) < 1
        and len(run.outcome.faces) in (case.faces, case.faces - 1)
        and max(run.error.holes_gained, run.error.parts_gained) <= 0
        for case in done
        for run in [case.runs[HEAP]]
    )


def study(plugin: Path) -> Study:
    subjects = [(model, fraction) for model in models() for fraction in FRACTIONS]
    done = [run_case(plugin, model, round(part * len(model.faces))) for model, part in subjects]
    with tempfile.TemporaryDirectory() as folder:
        series = run_series(plugin, Path(folder))
    shown = [series.table(), summary_table(done), error_table(done), defect_table(done)]
    return Study(shown, holds(done), lambda: picture(plugin, series))


def times(plugin: Path) -> list[tables.Table]:
    """Milliseconds, and what they are over VTK's."""
    ours = [removal(plugin, criterion) for criterion in (HEAP, PASSES)]
    table = tables.table("Milliseconds, and over VTK's", ("mesh", VTK, HEAP, PASSES, *RATIOS))
    for model in models():
        for fraction in FRACTIONS:
            vtk = decimate_pro(model, round(fraction * len(model.faces)), REPEATS)
            outcomes = [vtk, *race(model.path, len(vtk.faces), ours, REPEATS)]
            cells = [f"{1000 * each.seconds:,.0f}" for each in outcomes]
            cells += [f"{each.seconds / vtk.seconds:.2f}" for each in outcomes[1:]]
            table.add_row(model.case_name(len(vtk.faces)), *cells)
    return [table]


if __name__ == "__main__":
    heading = "Schroeder, Zarge and Lorensen 1992"
    sys.exit(Script(__file__, __doc__, heading, study, times).main())
