# SPDX-License-Identifier: GPL-3.0-or-later
"""Schroeder, Zarge and Lorensen 1992: our vertex removal beside VTK's, and the slides' series.

    python bench/papers/schroeder.py [--plugin FILE] [--save]

VTK's DecimatePro is the same algorithm by its first author. Both go to the same number of faces,
VTK with its defaults, by which it may split the mesh to get there. Distances are two-sided, % of
the diagonal. The clocks cover the call alone: VTK's update, and our filter in PyMeshLab with what
the host does around it; each is the median of three runs in fresh processes. One thread: removal
is sequential.

The series is that of the CS3621 slides on vertex decimation, 9,248 faces to 7,184, 5,120, 992 and
592. Their mesh is not available; PyMeshLab's bunny, brought to 9,248 faces by edge collapse,
stands in for it. With --save the picture of it goes to docs/images.

Meshes: PyMeshLab's cow, bone and bunny; five more where ../shared/meshes has them.

Ends with 1 when, with the criterion Heap, an RMS or a maximum is above VTK's, when a boundary edge
or a component is there that the original has not, or when a target is missed.
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
from judge import Figures
from meshes import REPOSITORY, shared_folder, shipped, write_mesh
from models import Model
from panels import Panel, View
from paper_options import paper_options
from picture import draw
from shape import Shape, shape_of
from surface import Surface
from workers import FilterError, ask

SHIPPED = ("cow.obj", "bone.ply", "bunny.obj")
SHARED = ("fandisk.obj", "rocker-arm.obj", "horse.ply", "stanford-bunny.obj", "igea.ply")
FRACTIONS = (0.2, 0.05)
REPEATS = 3
VTK, HEAP, PASSES = "DecimatePro", "Heap", "Passes"
SERIES = (9248, 7184, 5120, 992, 592)
SLIDES = {9248: (4632, 13872), 7184: (3602, 10776), 5120: (2570, 7680), 992: (506, 1488)}
SLIDES |= {592: (306, 888)}  # vertices and edges, as printed
PICTURE = REPOSITORY / "docs/images/schroeder.png"
WORKER = REPOSITORY / "bench/library_worker.py"
BUNNY_VIEW = View((0.2, 0.15, 1.0))


@dataclass(frozen=True)
class Run:
    """What one program made of a model."""

    outcome: Outcome
    figures: Figures
    shape: Shape


@dataclass(frozen=True)
class Case:
    """A model at a number of faces: its original's boundary edges and components, runs by name."""

    model: Model
    faces: int
    boundary: int
    components: int
    runs: dict[str, Run]

    @property
    def name(self) -> str:
        return self.model.case_name(self.faces)

    def ratios(self, run: str) -> tuple[float, float, float]:
        """RMS, maximum and time over those of VTK."""
        one, base = self.runs[run], self.runs[VTK]
        return (
            one.figures.rms / base.figures.rms,
            one.figures.max / base.figures.max,
            one.outcome.seconds / base.outcome.seconds,
        )


def removal(plugin: Path, criterion: str) -> Decimator:
    """Our filter with its defaults but for the criterion."""
    return Decimator(
        criterion, "meshing_decimation_vertex_removal", plugin, {"criterion": criterion}
    )


def decimate_pro(model: Model, target: int) -> Outcome:
    """VTK's defaults, in a process of its own for every run."""
    with tempfile.TemporaryDirectory() as folder:
        mesh, output = Path(folder) / "mesh.bin", Path(folder) / "simplified.bin"
        write_binary(mesh, model.vertices, model.faces)
        job = {
            "mesh": str(mesh),
            "policy": "vtk.decimate-pro",
            "target": target,
            "cell": None,
            "output": str(output),
        }
        command = [sys.executable, str(WORKER)]
        what = f"{VTK} on {model.name} to {target} faces"
        seconds = [ask(command, job, what)["seconds"] for _ in range(REPEATS)]
        vertices, faces = read_binary(output)
    return Outcome(vertices, faces.astype("int64"), statistics.median(seconds), {})


def run_case(plugin: Path, model: Model, target: int) -> Case:
    vtk = decimate_pro(model, target)
    ours = [removal(plugin, criterion) for criterion in (HEAP, PASSES)]
    outcomes = [vtk, *race(model.path, len(vtk.faces), ours, REPEATS)]
    runs = {
        name: Run(
            outcome,
            model.judge(outcome.vertices, outcome.faces),
            shape_of(Surface(outcome.vertices, outcome.faces)),
        )
        for name, outcome in zip((VTK, HEAP, PASSES), outcomes, strict=True)
    }
    original = model.judge(model.vertices, model.faces)
    components = shape_of(Surface(model.vertices, model.faces)).components
    return Case(model, len(vtk.faces), original.boundary, components, runs)


def models() -> list[Model]:
    """Those that are there."""
    files = [shipped(name) for name in SHIPPED]
    files += [path for name in SHARED if (path := shared_folder() / name).is_file()]
    return [Model(path.stem, path) for path in files]


def error_table(done: Sequence[Case]) -> tables.Table:
    """RMS and maximum of each program."""
    headings = ["mesh"]
    headings += [f"{figure} {run}" for figure in ("RMS", "max") for run in (VTK, HEAP, PASSES)]
    table = tables.table("Two-sided distance, % of the diagonal", headings)
    for case in done:
        figures = [case.runs[run].figures for run in (VTK, HEAP, PASSES)]
        table.add_row(
            case.name, *(f"{f.rms:.4f}" for f in figures), *(f"{f.max:.3f}" for f in figures)
        )
    return table


def defect_table(done: Sequence[Case]) -> tables.Table:
    """What is there that should not be, as VTK / Heap / Passes, beside the original's."""
    headings = ("mesh", "boundary edges", "of the original", "components", "of the original")
    headings += ("flipped", "self-intersecting", "milliseconds")
    table = tables.table(f"Defects and time: {VTK} / {HEAP} / {PASSES}", headings)
    for case in done:
        runs = [case.runs[run] for run in (VTK, HEAP, PASSES)]

        def three(values: Sequence[float]) -> str:
            return " / ".join(f"{value:,.0f}" for value in values)

        table.add_row(
            case.name,
            three([run.figures.boundary for run in runs]),
            str(case.boundary),
            three([run.shape.components for run in runs]),
            str(case.components),
            three([run.figures.flipped for run in runs]),
            three([run.shape.self_intersecting for run in runs]),
            three([1000 * run.outcome.seconds for run in runs]),
        )
    return table


def summary_table(done: Sequence[Case]) -> tables.Table:
    """Ratios to VTK."""
    table = tables.table(
        f"Ratios to {VTK}: geometric mean (worst)", ("criterion", "RMS", "maximum", "time")
    )
    for run in (HEAP, PASSES):
        ratios = np.array([case.ratios(run) for case in done])
        means, worst = np.exp(np.log(ratios).mean(axis=0)), ratios.max(axis=0)
        table.add_row(run, *(f"{m:.2f} ({w:.2f})" for m, w in zip(means, worst, strict=True)))
    return table


# --- the slides' series --------------------------------------------------------------------------


def series(plugin: Path, folder: Path) -> tuple[tables.Table, list[Panel]]:
    """Every number of faces from the first: a table, and panels to draw."""
    bunny = Model("bunny", shipped("bunny.obj"))
    [first] = race(bunny.path, SERIES[0], [curvdecim(plugin)])
    path = folder / "bunny.ply"
    write_mesh(path, first.vertices, first.faces)
    model = Model("bunny", path)
    headings = ("faces of the slides", "V", "E", "our faces", "V", "E", "RMS, %", f"{VTK} RMS, %")
    table = tables.table("The slides' series, from the mesh of 9,248 faces", headings)
    panels = [Panel(model.vertices, model.faces, f"{len(model.faces):,} faces", "input")]
    _add_counts(table, SERIES[0], model.vertices, model.faces, "", "")
    for target in SERIES[1:]:
        [ours] = race(path, target, [removal(plugin, HEAP)])
        vtk = decimate_pro(model, target)
        rms, base = (model.judge(each.vertices, each.faces).rms for each in (ours, vtk))
        _add_counts(table, target, ours.vertices, ours.faces, f"{rms:.4f}", f"{base:.4f}")
        panels.append(_panel(ours, "Vertex removal", rms))
    panels.append(_panel(vtk, VTK, base))
    return table, panels


def _panel(outcome: Outcome, who: str, rms: float) -> Panel:
    title = f"{len(outcome.faces):,} faces"
    return Panel(outcome.vertices, outcome.faces, title, f"{who}, RMS {rms:.3f} %")


def _add_counts(
    table: tables.Table, target: int, vertices: np.ndarray, faces: np.ndarray, *errors: str
) -> None:
    edges = len(np.unique(np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)), axis=0))
    counts = (*SLIDES[target], len(faces), len(vertices), edges)
    table.add_row(f"{target:,}", *(f"{count:,}" for count in counts), *errors)


def holds(done: Sequence[Case]) -> bool:
    """The claim, as this file's head states it."""
    return all(
        max(case.ratios(HEAP)[:2]) < 1
        and len(run.outcome.faces) in (case.faces, case.faces - 1)
        and run.figures.boundary <= case.boundary
        and run.shape.components == case.components
        for case in done
        for run in [case.runs[HEAP]]
    )


def main() -> int:
    """Prints every table; the exit code is the verdict."""
    options = paper_options(__doc__)
    console = tables.console()
    try:
        done = [
            run_case(options.plugin, model, round(fraction * len(model.faces)))
            for model in models()
            for fraction in FRACTIONS
        ]
        with tempfile.TemporaryDirectory() as folder:
            counts, panels = series(options.plugin, Path(folder))
    except FilterError as failure:
        console.print(f"failed: {failure}", markup=False)
        return 1
    shown = [summary_table(done), error_table(done), defect_table(done), counts]
    for each in shown:
        console.print(each)
    if options.save:
        path = REPOSITORY / "bench/results/schroeder.md"
        tables.save_markdown(path, "Schroeder, Zarge and Lorensen 1992", [__doc__], shown)
        PICTURE.parent.mkdir(parents=True, exist_ok=True)
        draw(PICTURE, [(BUNNY_VIEW, panels[:3]), (BUNNY_VIEW, panels[3:])])
    return 0 if holds(done) else 1


if __name__ == "__main__":
    sys.exit(main())
