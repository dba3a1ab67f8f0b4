# SPDX-License-Identifier: GPL-3.0-or-later
"""Decimates PyMeshLab's cow and bunny with our filter and with MeshLab's own, and shows both.

    python bench/demo.py --plugin build/plugins/pymeshlab-2025.07/libfilter_curvdecim.so

Prints a table, and leaves the simplified meshes and demo.png in the output folder. What was
measured is kept there, and shown again as long as the plugin is the same; --again measures anew.
"""

from __future__ import annotations

import argparse
import shutil
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import datetime
from importlib import metadata
from itertools import product
from pathlib import Path
from typing import Any

import tables
from decimators import DEFAULT_PLUGIN, curvdecim, meshlab
from kept import kept
from meshes import REPOSITORY, shipped, write_mesh
from models import Model, Result
from panels import Panel, View
from rich.console import Console
from rich.table import Table
from sketch import draw
from workers import FilterError

VIEWS = {"cow": View((1.0, 0.25, 0.45)), "bunny": View((0.1, 0.15, 1.0))}
FRACTIONS = (0.20, 0.05)
PICTURE = "demo.png"


@dataclass(frozen=True)
class Case:
    """A model at a fraction of its faces, by our filter and by MeshLab's."""

    model: Model
    fraction: float
    target: int
    ours: Result
    meshlab: Result


def main() -> int:
    options = _options()
    console = tables.console()
    if not options.plugin.is_file():
        console.print(f"{options.plugin}: no such plugin; build it first or give --plugin")
        return 1
    memory = options.out / "kept"
    if options.again or not (options.out / PICTURE).is_file():
        shutil.rmtree(memory, ignore_errors=True)
    try:
        shown = kept(memory, _question(options), lambda: _measure(options, console))
    except FilterError as failure:
        console.print(f"[red]failed[/red]: {failure}")
        return 1
    print(shown["text"])
    return 1 if shown["missed"] else 0


def _question(options: argparse.Namespace) -> list[bytes]:
    """What the figures depend on."""
    others = f"{metadata.version('pymeshlab')} {options.repeats} {options.out}"
    return [options.plugin.read_bytes(), Path(__file__).read_bytes(), others.encode()]


def _measure(options: argparse.Namespace, console: Console) -> dict[str, Any]:
    """The text to show, and whether a target was missed."""
    options.out.mkdir(parents=True, exist_ok=True)
    cases = list(_run(options.plugin, options.repeats, console))
    _save(cases, options.out)
    draw(options.out / PICTURE, _picture(cases))
    missed = _missed(cases)
    with console.capture() as text:
        console.print(_table(cases, options.repeats))
        console.print(*missed, sep="\n", end="\n" if missed else "")
        console.print(f"meshes and picture: {options.out}")
        console.print(f"measured at {datetime.now():%Y-%m-%d %H:%M}; --again measures anew")
    return {"text": text.get(), "missed": bool(missed)}


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--plugin", type=Path, default=DEFAULT_PLUGIN)
    parser.add_argument("--out", type=Path, default=REPOSITORY / "build/demo")
    parser.add_argument("--again", action="store_true", help="measure what was measured before")
    parser.add_argument("--repeats", type=int, default=5, help="runs for the median time")
    return parser.parse_args()


def _run(plugin: Path, repeats: int, console: Console) -> Iterator[Case]:
    models = [Model(name, shipped(f"{name}.obj")) for name in VIEWS]
    for model, fraction in product(models, FRACTIONS):
        console.print(f"{model.name} to {fraction:.0%}, {repeats} times each ...", style="dim")
        target = round(fraction * len(model.faces))
        ours, other = model.run(target, [curvdecim(plugin), meshlab()], repeats)
        yield Case(model, fraction, target, ours, other)


def _table(cases: list[Case], repeats: int) -> Table:
    table = Table(
        title="Two-sided distances in % of the bounding-box diagonal",
        caption=f"time: median of {repeats} runs in turn, each in a fresh process, filter only",
    )
    table.add_column("mesh")
    table.add_column("filter")
    for heading in ("faces", "time ms", "RMS %", "maximum %"):
        table.add_column(heading, justify="right")
    for case in cases:
        name, size = f"{case.model.name} to {case.fraction:.0%}", len(case.model.faces)
        table.add_row(name, "CurvDecim", *_cells(case.ours))
        table.add_row(f"{size:,} faces", "MeshLab", *_cells(case.meshlab))
        table.add_row("", "ratio", *_ratios(case), style="bold", end_section=True)
    return table


def _cells(result: Result) -> tuple[str, ...]:
    time, figures = f"{result.milliseconds:.1f}", result.figures
    return f"{figures.faces:,}", time, f"{figures.rms:.4f}", f"{figures.max:.3f}"


def _ratios(case: Case) -> tuple[str, ...]:
    ours, other = case.ours, case.meshlab
    time = ours.milliseconds / other.milliseconds
    rms, largest = ours.figures.rms / other.figures.rms, ours.figures.max / other.figures.max
    return "", *(f"{ratio:.2f}" for ratio in (time, rms, largest))


def _save(cases: list[Case], folder: Path) -> None:
    for case in cases:
        stem = f"{case.model.name}-{round(100 * case.fraction)}"
        for name, result in (("curvdecim", case.ours), ("meshlab", case.meshlab)):
            outcome = result.outcome
            write_mesh(folder / f"{stem}-{name}.ply", outcome.vertices, outcome.faces)


def _picture(cases: list[Case]) -> list[tuple[View, list[Panel]]]:
    coarsest = [case for case in cases if case.fraction == FRACTIONS[-1]]
    return [(VIEWS[case.model.name], panels(case)) for case in coarsest]


def panels(case: Case) -> list[Panel]:
    """The mesh, ours and MeshLab's."""
    model = case.model
    title, caption = f"{model.name.capitalize()}, original", f"{len(model.faces):,} faces"
    shown = [Panel(model.vertices, model.faces, title, caption)]
    for title, result in (("CurvDecim", case.ours), ("MeshLab quadric", case.meshlab)):
        figures, outcome = result.figures, result.outcome
        caption = f"{figures.faces:,} faces   RMS {figures.rms:.4f} %   max {figures.max:.2f} %"
        shown.append(Panel(outcome.vertices, outcome.faces, title, caption))
    return shown


def _missed(cases: list[Case]) -> list[str]:
    """Where our filter missed a target: closed meshes lose two faces at a time."""
    missed = [c for c in cases if not c.target - 1 <= c.ours.figures.faces <= c.target]
    return [
        f"[red]failed[/red]: {case.model.name} to {case.target} faces ended at "
        f"{case.ours.figures.faces}: {case.ours.outcome.report.get('stopped_by')}"
        for case in missed
    ]


if __name__ == "__main__":
    sys.exit(main())
