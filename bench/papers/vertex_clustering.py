# SPDX-License-Identifier: GPL-3.0-or-later
"""Ciolczyk and Janczykowski's slides on vertex clustering, their table next to what ours gives.

    python bench/papers/vertex_clustering.py [--plugin FILE] [--save]

The slides compare four representatives by the time that their Python takes on five meshes, and show
what each makes of one; their cell is not said, here it is 4 % of the diagonal. Time is that of the
filter alone, the least of five runs, each in a fresh process.

What differs from the slides: their meshes are not available. The cube and the sphere are made with
as many vertices as theirs, or nearly; the horse of 2,831 vertices is ../shared/meshes' horse after
our edge collapse; the stanford-bunny stands for their bunny and igea for the armadillo. Without
../shared/meshes, PyMeshLab's bunny stands for all three.

The second table compares the representatives by error at equal face count, and ends the run with 1
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
from decimators import REPRESENTATIVES, apply, curvdecim, curvdecim_clustering, run_once
from generate import cube, lattice
from judge import Figures
from meshes import REPOSITORY, shared_folder, shipped, write_mesh
from models import Model
from paper_options import paper_options
from surface import Floats, Ints
from workers import FilterError

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
    """A model at a number of faces: figures by representative."""

    model: Model
    target: int
    figures: dict[str, Figures]

    def quadric_is_best(self) -> bool:
        """By RMS."""
        return min(self.figures, key=lambda name: self.figures[name].rms) == "Quadric"


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


# --- tables ---------------------------------------------------------------------------------------


def seconds(plugin: Path, mesh: Path, representative: str) -> float:
    """Of the fastest of some runs."""
    clustering = curvdecim_clustering(plugin, representative=representative)
    parameters = clustering.parameters | {"cellsize": {"percentage": CELL}}
    what = f"{representative} on {mesh.name}"
    return min(apply(mesh, clustering, parameters, what).seconds for _ in range(RUNS))


def time_table(plugin: Path, files: dict[str, Path]) -> tables.Table:
    """The slides' table: their seconds, our milliseconds, and how many times less that is."""
    headings = ["mesh", "vertices, theirs", "ours"]
    headings += [f"{name}, {what}" for name in SEED for what in ("s", "ms", "times less")]
    table = tables.table("Time by the slides, and ours", headings)
    for name, (vertices, theirs) in SLIDES.items():
        row = [
            f"{name} ({files[name].stem})",
            f"{vertices:,}",
            f"{len(Model(name, files[name]).vertices):,}",
        ]
        for representative, slide in zip(SEED, theirs, strict=True):
            ours = seconds(plugin, files[name], representative)
            row += [f"{slide:.3f}", f"{1000 * ours:.2f}", f"{slide / ours:,.0f}"]
        table.add_row(*row)
    return table


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
            results = model.run(target, contenders)
            figures = [result.figures for result in results]
            done.append(Case(model, target, dict(zip(REPRESENTATIVES, figures, strict=True))))
    return done


def error_table(done: Sequence[Case]) -> tables.Table:
    """RMS of every representative."""
    table = tables.table(
        "Two-sided RMS at equal face count, % of the diagonal", ("mesh", *REPRESENTATIVES)
    )
    for case in done:
        name = case.model.case_name(case.target)
        table.add_row(name, *(f"{case.figures[each].rms:.4f}" for each in REPRESENTATIVES))
    return table


def main() -> int:
    """Prints both tables; the exit code is the verdict."""
    options = paper_options(__doc__)
    console = tables.console()
    try:
        with tempfile.TemporaryDirectory() as folder:
            times = time_table(options.plugin, slides_meshes(options.plugin, Path(folder)))
        done = cases(options.plugin)
    except FilterError as failure:
        console.print(f"failed: {failure}", markup=False)
        return 1
    shown = [times, error_table(done)]
    for each in shown:
        console.print(each)
    if options.save:
        path = REPOSITORY / "bench/results/vertex_clustering.md"
        tables.save_markdown(path, "Ciolczyk and Janczykowski, slides", [__doc__], shown)
    return 0 if all(case.quadric_is_best() for case in done) else 1


if __name__ == "__main__":
    sys.exit(main())
