# SPDX-License-Identifier: GPL-3.0-or-later
"""Ciolczyk and Janczykowski's slides on vertex clustering, their table next to what ours gives.

    python bench/papers/vertex_clustering.py [--plugin FILE] [--save] [--times]

The slides compare four representatives by the time that their Python takes on five meshes, and show
what each makes of one. They print no error, and neither their cell nor the mesh that they show;
here the cell is 4 % of the diagonal. Errors are those of our filter get_simplification_error, in %
of the diagonal. With --times the table of times instead: the filter alone, the least of five runs,
each in a fresh process.

What differs from the slides: their meshes are not available. The cube and the sphere are made with
as many vertices as theirs, or nearly; the horse of 2,831 vertices is ../shared/meshes' horse after
our edge collapse; the stanford-bunny stands for their bunny and igea for the armadillo. Without
../shared/meshes, PyMeshLab's bunny stands for all three. Of their icosahedron they print nothing.

The last table compares the representatives by error at equal face count, and ends the run with 1
where Quadric's RMS is not the lowest. Other programs' clusterings are in peers.md.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "sample_meshes"))

import numpy as np
import tables
from decimators import (
    REPRESENTATIVES,
    Outcome,
    apply,
    curvdecim,
    curvdecim_clustering,
    run_once,
)
from error_picture import as_input, with_errors
from generate import cube, lattice
from layer_error import LayerError, Measured, measure, meter_of
from meshes import shared_folder, shipped, write_mesh
from models import Model
from panels import View
from paper_script import PictureRows, Script, Study
from printed import NOT_PRINTED, Row, beside, instead
from surface import Floats, Ints

SEED = ("CellCenter", "Mean", "Median", "Quadric")
CELL = 4.0  # per cent of the diagonal
RUNS = 5
FRACTIONS = (0.2, 0.05)
HORSE_FACES = 5658  # of 2,831 vertices
# Seconds by the slides, in the order of SEED.
SLIDES = {
    "cube": (2116, (0.150, 0.175, 0.183, 0.715)),
    "sphere": (242, (0.024, 0.029, 0.030, 0.134)),
    "bunny": (35947, (3.144, 3.439, 3.568, 13.872)),
    "horse": (2831, (0.251, 0.287, 0.311, 1.231)),
    "armadillo": (172974, (16.334, 18.611, 19.711, 77.557)),
}


@dataclass(frozen=True)
class Case:
    """A model at a number of faces: what each representative makes of it."""

    model: Model
    target: int
    runs: dict[str, Measured]

    def error(self, representative: str) -> LayerError:
        return self.runs[representative].error

    def quadric_is_best(self) -> bool:
        """By RMS."""
        return min(self.runs, key=lambda name: self.error(name).rms) == "Quadric"


# --- the slides' meshes ---------------------------------------------------------------------------


def sphere(rings: int, sectors: int) -> tuple[Floats, Ints]:
    """Of rings * sectors vertices and two poles."""
    parameters, sides = lattice(sectors, rings - 1, around=True)
    around = 2 * np.pi * parameters[:, 0]
    height = np.cos(np.pi * (1 + parameters[:, 1] * (rings - 1)) / (rings + 1))
    radius = np.sqrt(1 - height**2)
    vertices = np.stack([radius * np.cos(around), radius * np.sin(around), height], axis=1)
    first = np.arange(sectors)
    next_, last, poles = np.roll(first, -1), first + (rings - 1) * sectors, rings * sectors
    top = np.stack([first, next_, np.full(sectors, poles)], axis=1)
    bottom = np.stack([np.roll(last, -1), last, np.full(sectors, poles + 1)], axis=1)
    faces = np.concatenate([sides[:, ::-1], top, bottom])
    return np.concatenate([vertices, [(0, 0, 1), (0, 0, -1)]]), faces


def slides_meshes(plugin: Path, folder: Path) -> dict[str, Path]:
    """By the slides' name."""
    files = {name: folder / f"{name}.ply" for name in ("cube", "sphere", "horse")}
    write_mesh(files["cube"], *cube(19))
    write_mesh(files["sphere"], *sphere(15, 16))
    shared = shared_folder()
    scanned = shared / "horse.ply" if shared.is_dir() else shipped("bunny.obj")
    smaller = run_once(scanned, HORSE_FACES, curvdecim(plugin))
    write_mesh(files["horse"], smaller.vertices, smaller.faces)
    bunny, large = shared / "stanford-bunny.obj", shared / "igea.ply"
    files["bunny"] = bunny if bunny.is_file() else shipped("bunny.obj")
    files["armadillo"] = large if large.is_file() else shipped("bunny.obj")
    return files


# --- runs -----------------------------------------------------------------------------------------


def clustered(plugin: Path, mesh: Path, representative: str) -> Outcome:
    """By the cell of this comparison."""
    clustering = curvdecim_clustering(plugin, representative=representative)
    parameters = clustering.parameters | {"cellsize": {"percentage": CELL}}
    return apply(mesh, clustering, parameters, f"{representative} on {mesh.name}")


def cases(plugin: Path) -> list[Case]:
    """Every real mesh at hand, at every fraction."""
    files = [shipped(name) for name in ("cow.obj", "bone.ply", "bunny.obj")]
    names = ("fandisk.obj", "rocker-arm.obj", "stanford-bunny.obj", "horse.ply", "igea.ply")
    files += [path for path in (shared_folder() / name for name in names) if path.is_file()]
    contenders = [
        curvdecim_clustering(plugin, each, by_cell=False, representative=each)
        for each in REPRESENTATIVES
    ]
    done = []
    for model in (Model(path.stem, path) for path in files):
        for fraction in FRACTIONS:
            target = round(fraction * len(model.faces))
            done.append(Case(model, target, measure(plugin, model, target, contenders)))
    return done


# --- tables ---------------------------------------------------------------------------------------


def slides_table(plugin: Path, files: dict[str, Path]) -> tables.Table:
    """The errors that the slides do not print, on their meshes or what stands in for them."""
    rows = [_slides_row(plugin, name, path) for name, path in files.items()]
    rows.append(Row("icosahedron", (NOT_PRINTED, NOT_PRINTED), "left out"))
    title = f"The slides' meshes, cell {CELL:g} % of the diagonal: {' / '.join(SEED)}"
    return beside(title, ("vertices", "errors"), ("vertices", "faces left", "RMS", "max"), rows)


def _slides_row(plugin: Path, name: str, path: Path) -> Row:
    model = Model(path.stem, path)
    meter = meter_of(plugin, model)
    outcomes = [clustered(plugin, path, each) for each in SEED]
    errors = [meter(each.vertices, each.faces) for each in outcomes]
    ours = (
        f"{len(model.vertices):,}",
        " / ".join(f"{len(each.faces):,}" for each in outcomes),
        " / ".join(f"{error.rms:.3f}" for error in errors),
        " / ".join(f"{error.max:.2f}" for error in errors),
    )
    return Row(name, (f"{SLIDES[name][0]:,}", NOT_PRINTED), instead(path.stem), ours)


def error_table(done: Sequence[Case], what: str) -> tables.Table:
    """what: the field of LayerError."""
    names = {"rms": "RMS", "max": "maximum", "mean": "mean distance"}
    title = f"Two-sided {names[what]} at equal face count, % of the diagonal"
    table = tables.table(title, ("mesh", *REPRESENTATIVES))
    for case in done:
        errors = (getattr(case.error(each), what) for each in REPRESENTATIVES)
        table.add_row(case.model.case_name(case.target), *(f"{error:.4f}" for error in errors))
    return table


def time_table(plugin: Path, files: dict[str, Path]) -> tables.Table:
    """The slides' table: their seconds, our milliseconds, and how many times less that is."""
    headings = ["mesh", "vertices, theirs", "ours"]
    headings += [f"{name}, {what}" for name in SEED for what in ("s", "ms", "times less")]
    table = tables.table("Time by the slides, and ours", headings)
    for name, (vertices, theirs) in SLIDES.items():
        ours = f"{len(Model(name, files[name]).vertices):,}"
        row = [f"{name} ({files[name].stem})", f"{vertices:,}", ours]
        for representative, slide in zip(SEED, theirs, strict=True):
            runs = (clustered(plugin, files[name], representative) for _ in range(RUNS))
            least = min(run.seconds for run in runs)
            row += [f"{slide:.3f}", f"{1000 * least:.2f}", f"{slide / least:,.0f}"]
        table.add_row(*row)
    return table


# --- the picture ----------------------------------------------------------------------------------

TITLES = {
    "CellCenter": "cell centre",
    "Mean": "mean",
    "Median": "median",
    "Quadric": "quadric, our default",
}


def picture(plugin: Path) -> PictureRows:
    """The slides' page of four representatives, on a mesh of ours."""
    model = Model("bunny", shipped("bunny.obj"))
    meter, row = meter_of(plugin, model), [as_input(model.vertices, model.faces, model.name)]
    for representative, title in TITLES.items():
        outcome = clustered(plugin, model.path, representative)
        row.append(with_errors(meter, outcome.vertices, outcome.faces, title))
    return [(View((0.1, 0.15, 1.0)), row)]


# --- the script -----------------------------------------------------------------------------------


def study(plugin: Path) -> Study:
    with tempfile.TemporaryDirectory() as folder:
        on_slides = slides_table(plugin, slides_meshes(plugin, Path(folder)))
    done = cases(plugin)
    shown = [on_slides, *(error_table(done, what) for what in ("rms", "max", "mean"))]
    return Study(shown, all(case.quadric_is_best() for case in done), lambda: picture(plugin))


def times(plugin: Path) -> list[tables.Table]:
    with tempfile.TemporaryDirectory() as folder:
        return [time_table(plugin, slides_meshes(plugin, Path(folder)))]


if __name__ == "__main__":
    sys.exit(Script(__file__, __doc__, "Ciolczyk and Janczykowski, slides", study, times).main())
