# SPDX-License-Identifier: GPL-3.0-or-later
"""Our edge collapse beside MeshLab's own on meshes of every kind, and where ours falls short.

    python bench/every_mesh.py FOLDER part.stl            # all mesh files, to 50, 20, 10, 5 and 1 %
    python bench/every_mesh.py FOLDER --only 'gear*' --levels 20 5 --preset Best --json new.json
    python bench/every_mesh.py FOLDER --against old.json  # with what changed since

CAD parts, assemblies, many pieces, dirt: beside the distances it counts the defects of the mesh and
of both results, as they are and with vertices of equal position merged. MeshLab's results are kept
in build/every_mesh, so that a second call runs only ours. A level is a share of the faces as they
are read; levels of fewer than four faces are left out. Ends with 1 when a run of ours fails.
"""

from __future__ import annotations

import argparse
import json
import shutil
import sys
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from fnmatch import fnmatch
from pathlib import Path
from typing import Any

import tables
from compare import setting
from decimators import DEFAULT_PLUGIN
from every_mesh_rows import (
    HEADINGS,
    WIDTHS,
    Row,
    changes,
    from_json,
    of_answer,
    row_table,
    summary,
    to_json,
)
from meshes import REPOSITORY, mesh_files
from workers import PATIENCE, FilterError, ask

LEVELS = (50.0, 20.0, 10.0, 5.0, 1.0)  # % of the faces
_SAMPLES = 50_000  # a direction: the RMS repeats within about 0.5 %
_FILTER_PATIENCE = 300.0  # seconds; then a filter counts as hung
_KEPT = REPOSITORY / "build/every_mesh"
_SAVED = REPOSITORY / "bench/results/every_mesh.md"
_WORKER = Path(__file__).with_name("every_mesh_worker.py")


def main() -> int:
    options = _options()
    before = from_json(_read(options.against)["rows"]) if options.against else []
    files = named(files_of(options.meshes), options.only)
    with tempfile.TemporaryDirectory() as folder:
        plugin = Path(shutil.copy2(options.plugin, folder))  # the next build may overwrite it
        rows, failures = _judge(files, _job(options, plugin), options.jobs)
    if options.json:
        _write(options.json, options, rows, failures)
    _show(options, rows, before, failures)
    return 1 if failures or any(row.ours.failure for row in rows) else 0


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("meshes", nargs="+", type=Path, metavar="FOLDER_OR_FILE")
    parser.add_argument("--levels", nargs="+", type=float, default=LEVELS, help="%% of the faces")
    parser.add_argument("--preset", help="of our filter; its default otherwise")
    parser.add_argument(
        "--set", nargs="+", action="extend", type=setting, default=[], metavar="NAME=VALUE"
    )
    parser.add_argument("--samples", type=int, default=_SAMPLES, help="a direction")
    parser.add_argument("--only", default="*", metavar="NAME", help="meshes by name, as 'gear*'")
    parser.add_argument("--plugin", type=Path, default=DEFAULT_PLUGIN, metavar="FILE")
    parser.add_argument("--jobs", type=int, default=2, help="meshes at a time")
    parser.add_argument("--patience", type=float, default=_FILTER_PATIENCE, help="s of a filter")
    parser.add_argument("--json", type=Path, metavar="FILE", help="writes all figures")
    parser.add_argument("--against", type=Path, metavar="OLD.json", help="shows what changed")
    parser.add_argument("--save", action="store_true", help=f"writes {_SAVED.name}")
    return parser.parse_args()


def files_of(paths: Iterable[Path]) -> list[Path]:
    """The files themselves, and the mesh files of the folders."""
    return [file for path in paths for file in (mesh_files(path) if path.is_dir() else [path])]


def named(files: Sequence[Path], only: str) -> dict[str, Path]:
    """Files by name, with that of the folder where two have one name; only: a pattern."""
    names = [file.name for file in files]
    unique = {
        file.name if names.count(file.name) == 1 else f"{file.parent.name}/{file.name}": file
        for file in files
    }
    return {name: file for name, file in unique.items() if fnmatch(file.name, only)}


def _job(options: argparse.Namespace, plugin: Path) -> dict[str, Any]:
    """What the worker is to do, apart from the mesh."""
    preset = {"preset": options.preset} if options.preset else {}
    return {
        "levels": list(options.levels),
        "plugin": str(plugin),
        "parameters": preset | dict(options.set),
        "samples": options.samples,
        "patience": options.patience,
        "kept": str(_KEPT),
    }


def _judge(
    files: dict[str, Path], job: dict[str, Any], jobs: int
) -> tuple[list[Row], dict[str, str]]:
    """The rows of all meshes in their order, printed as they come; why some meshes have none."""
    _print(HEADINGS)
    rows: dict[str, list[Row]] = {}
    failures: dict[str, str] = {}
    with ThreadPoolExecutor(jobs) as pool:
        asked = {pool.submit(_ask, name, file, job): name for name, file in files.items()}
        for answer in as_completed(asked):
            name = asked[answer]
            try:
                rows[name] = answer.result()
            except FilterError as failure:
                failures[name] = str(failure)
                print(f"{name} failed: {failure}", flush=True)
            for row in rows.get(name, []):
                _print(row.cells())
    return [row for name in files for row in rows.get(name, [])], failures


def _ask(name: str, file: Path, job: dict[str, Any]) -> list[Row]:
    """The rows of one mesh, from a process of its own."""
    patience = PATIENCE + 2 * len(job["levels"]) * job["patience"]
    job = job | {"mesh": str(file)}
    return of_answer(name, ask([sys.executable, str(_WORKER)], job, name, patience))


def _print(cells: Sequence[str]) -> None:
    aligned = (f"{cell:>{width}}" for cell, width in zip(cells[1:], WIDTHS[1:], strict=True))
    print(f"{cells[0]:<{WIDTHS[0]}}", *aligned, flush=True)


def _show(
    options: argparse.Namespace, rows: list[Row], before: list[Row], failures: dict[str, str]
) -> None:
    shown = [*summary(rows), *([changes(before, rows)] if before else [])]
    console = tables.console()
    for table in shown:
        console.print(table)
    failed = list(_lines(failures))
    for line in failed:
        console.print(line, markup=False)
    if options.save:
        notes = [__doc__, *failed]
        tables.save_markdown(_SAVED, "Every mesh", notes, [row_table(rows), *shown])


def _lines(failures: dict[str, str]) -> Iterator[str]:
    return (f"failed: {name}: {failure}" for name, failure in failures.items())


def _read(file: Path) -> dict[str, Any]:
    return json.loads(file.read_text(encoding="utf-8"))


def _write(
    file: Path, options: argparse.Namespace, rows: list[Row], failures: dict[str, str]
) -> None:
    asked = {name: str(value) for name, value in vars(options).items()}
    figures = {"options": asked, "failures": failures, "rows": to_json(rows)}
    file.write_text(json.dumps(figures, indent=1), encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
