# SPDX-License-Identifier: GPL-3.0-or-later
"""Four meshes of hard kinds by our edge collapse and by MeshLab's own: a table and a picture.

    python bench/every_mesh_picture.py           # build/every_mesh.png
    python bench/every_mesh_picture.py --save    # docs/images/every_mesh.png

The table is Markdown, as in docs/every-mesh.md. Ours runs twice, with the topology giving way
(the default) and with PreserveTopology.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import hard_meshes
import tables
from decimators import DEFAULT_PLUGIN, Decimator, curvdecim, meshlab
from demo import Case, panels
from meshes import REPOSITORY, write_mesh
from models import Model, Result
from panels import View
from picture import draw
from PIL import Image
from rich.console import Console
from rich.progress import track
from rich.table import Table
from shape import components
from surface import Surface
from workers import FilterError

LEVELS = (0.20, 0.05, 0.01)  # of the faces
GONE = ("parts_removed", "holes_closed", "handles_cut")
HEADINGS = (
    *("mesh", "faces", "RMS %", "maximum %", "non-manifold edges", "pieces"),
    *("gone from ours: parts, holes, handles", "`PreserveTopology`: faces, RMS %"),
)
_SAVED = REPOSITORY / "docs/images/every_mesh.png"
_SCRATCH = REPOSITORY / "build/every_mesh.png"
_INKS = 256  # colours of the picture: a third of the bytes, for no difference that shows


@dataclass(frozen=True)
class Scene:
    """How a mesh is made, how it is seen, and the level at which it is shown."""

    build: Callable[[], hard_meshes.Mesh]
    view: View
    shown: float


SCENES = {
    "plate": Scene(hard_meshes.plate, View((0.1, -0.5, 1.0)), 0.01),
    "balls": Scene(hard_meshes.balls, View((0.2, 0.3, 1.0)), 0.01),
    "gear": Scene(hard_meshes.gear, View((0.3, -0.6, 1.0)), 0.01),
    "tree": Scene(hard_meshes.tree, View((0.3, -1.0, 0.2), (0.0, 0.0, 1.0)), 0.05),
}


@dataclass(frozen=True)
class Trio(Case):
    """A case with our result under PreserveTopology, too."""

    preserved: Result


def main() -> int:
    options = _options()
    console = tables.console()
    with tempfile.TemporaryDirectory() as folder:
        try:
            cases = list(_run(contenders(options.plugin), Path(folder), console))
        except FilterError as failure:
            console.print(f"failed: {failure}", markup=False)
            return 1
    print(tables.markdown(table(cases)).strip())
    _draw(_SAVED if options.save else _SCRATCH, cases)
    return 0


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--plugin", type=Path, default=DEFAULT_PLUGIN, metavar="FILE")
    parser.add_argument("--save", action="store_true", help=f"writes {_SAVED.name} into docs")
    return parser.parse_args()


def contenders(plugin: Path) -> Sequence[Decimator]:
    """Ours, MeshLab's, and ours under PreserveTopology."""
    return curvdecim(plugin), meshlab(), curvdecim(plugin, preservetopology=True)


def _run(contenders: Sequence[Decimator], folder: Path, console: Console) -> Iterator[Trio]:
    for name, scene in track(SCENES.items(), "decimating", console=console, transient=True):
        path = folder / f"{name}.ply"
        write_mesh(path, *scene.build())
        yield from trios(Model(name, path), contenders)


def trios(model: Model, contenders: Sequence[Decimator]) -> Iterator[Trio]:
    """A mesh at every level."""
    for level in LEVELS:
        target = round(level * len(model.faces))
        yield Trio(model, level, target, *model.run(target, contenders))


def table(cases: Iterable[Trio]) -> Table:
    """A row a case; two figures are ours / MeshLab's."""
    return tables.table("Ours / MeshLab's", HEADINGS, [_cells(case) for case in cases])


def _cells(case: Trio) -> list[str]:
    both = [case.ours, case.meshlab]
    gone = [int(case.ours.outcome.report.get(name, 0)) for name in GONE]
    preserved = case.preserved.figures
    return [
        f"{case.model.name} to {case.fraction:.0%}",
        _pair(f"{each.figures.faces:,}" for each in both),
        _pair(f"{each.figures.rms:.4f}" for each in both),
        _pair(f"{each.figures.max:.3f}" for each in both),
        _pair(f"{each.figures.nm_edges:,}" for each in both),
        _pair(f"{_pieces(each):,}" for each in both),
        ", ".join(f"{count:,}" for count in gone),
        f"{preserved.faces:,}, {preserved.rms:.4f}",
    ]


def _pair(both: Iterable[str]) -> str:
    return " / ".join(both)


def _pieces(result: Result) -> int:
    return components(Surface(result.outcome.vertices, result.outcome.faces))


def _draw(path: Path, cases: Iterable[Trio]) -> None:
    scenes = ((SCENES[case.model.name], case) for case in cases)
    rows = [(scene.view, panels(case)) for scene, case in scenes if case.fraction == scene.shown]
    path.parent.mkdir(parents=True, exist_ok=True)
    draw(path, rows)
    Image.open(path).quantize(_INKS).save(path, optimize=True)


if __name__ == "__main__":
    sys.exit(main())
