# SPDX-License-Identifier: GPL-3.0-or-later
"""Proves that a change of the code changed no result: our plugin against that of another commit.

    python bench/same_bits.py --base v0.1.0         # against a commit, which is built once
    python bench/same_bits.py --base-plugin FILE    # against a plugin that is built already
    python bench/same_bits.py --base v0.1.0 --quick  # on small meshes without the shared folder
    python bench/same_bits.py --base v0.1.0 --only 'cow*' --filter '*clustering'

Every filter runs with every preset and every choice on every mesh at hand, in processes of their
own, the base on one thread, ours on one and on three. Every bit of the resulting mesh, what the
filter returned, apart from the seconds, and the message of a refusal have to be the same.
Ends with 1 when any differs.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from fnmatch import fnmatch
from functools import partial
from importlib import metadata
from pathlib import Path
from typing import Any

import pymeshlab
import tables
from commits import IncomparableError, full_name, meshlab_sources, unpack
from decimators import DEFAULT_PLUGIN
from kept import kept
from meshes import REPOSITORY
from rich.console import Console
from rich.markup import escape
from rich.progress import track
from same_bits_cases import THREADED, Case, cases_for
from same_bits_meshes import MeshFile, at_hand, of_folder
from workers import FilterError, ask

RENAMED: dict[str, dict[str, str]] = {
    "meshing_decimation_vertex_clustering": {"max_error": "largest_move"},
}
"""Filter to what it returned: the name in the base to the name now."""

_THREADS = (1, 3)  # the base runs on the first
_LISTED = 30  # differing cases that are shown in full
_LISTED_OF_A_KIND = 2
_DIGITS = 12  # of a hash that is shown
_BUILD = REPOSITORY / "build/same_bits"
_HOST = "pymeshlab-2025.07"
_WORKER = Path(__file__).with_name("same_bits_worker.py")

Result = dict[str, Any]
"""What the worker says of one case."""


@dataclass(frozen=True)
class Verdict:
    """One case on one mesh: what differs between the base and ours."""

    mesh: str
    case: Case
    threads: int | None  # None: the filter has no such parameter
    refused: bool
    differences: dict[str, str]  # what differs to its value in the base and now

    @property
    def kind(self) -> tuple[str, str]:
        """The filter and what differs, of which there may be many cases."""
        return self.case.filter, ", ".join(self.differences)

    @property
    def thread_count(self) -> str:
        """In tables."""
        return str(self.threads or "")


Groups = dict[tuple[str, str], list[Verdict]]


def main() -> int:
    options = _options()
    console = tables.console()
    try:
        base = options.base_plugin or _built(full_name(options.base))
    except IncomparableError as reason:
        sys.exit(f"same bits: {reason}")
    with tempfile.TemporaryDirectory() as folder:
        now = Path(shutil.copy2(options.plugin, folder))  # the next build may overwrite it
        meshes = _meshes(options, Path(folder))
        names = ", ".join(mesh.name for mesh in meshes)
        console.print(f"{len(meshes)} meshes: {names}", markup=False)
        verdicts, failures = _judge(meshes, partial(_compare, base, now, options.filter), console)
    return _show(console, options, verdicts, failures)


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    base = parser.add_mutually_exclusive_group(required=True)
    base.add_argument("--base", metavar="COMMIT", help="whose plugin is built and compared with")
    base.add_argument("--base-plugin", type=_plugin, metavar="FILE", help="to compare with")
    parser.add_argument("--plugin", type=_plugin, default=str(DEFAULT_PLUGIN), metavar="FILE")
    parser.add_argument("--meshes", type=Path, metavar="DIR", help="only those of this folder")
    parser.add_argument("--only", default="*", metavar="NAME", help="meshes by name, as 'cow*'")
    parser.add_argument("--filter", default="*", metavar="NAME", help="filters by name")
    parser.add_argument("--quick", action="store_true", help="small meshes, about a minute")
    parser.add_argument("--save", type=Path, metavar="FILE.md", help="writes the tables")
    return parser.parse_args()


def _plugin(text: str) -> Path:
    path = Path(text).resolve()
    if not path.is_file():
        raise argparse.ArgumentTypeError(f"no file {text}")
    return path


def _built(commit: str) -> Path:
    """The plugin of a commit, built unless it is there."""
    source, build = _BUILD / commit / "source", _BUILD / commit / "build"
    unpack(commit, source)
    build.mkdir(exist_ok=True)
    log = build / "log.txt"
    with log.open("w", encoding="utf-8") as lines:
        for command in _build_commands(source, build):
            if subprocess.run(command, stdout=lines, stderr=subprocess.STDOUT).returncode != 0:
                where = log.relative_to(REPOSITORY)
                raise IncomparableError(f"commit {commit[:10]} cannot be built, see {where}")
    return build / "plugins" / _HOST / DEFAULT_PLUGIN.name


def _build_commands(source: Path, build: Path) -> Iterator[list[str]]:
    yield [
        *("cmake", "-S", str(source), "-B", str(build), "-G", "Ninja"),
        *("-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF"),
        *(f"-DCURVDECIM_HOSTS={_HOST}", f"-DCURVDECIM_REQUIRED_HOSTS={_HOST}"),
        f"-DMESHLAB_SOURCE_DIR={meshlab_sources()}",
        f"-DCURVDECIM_PYMESHLAB_DIR={Path(pymeshlab.__file__).parent}",
    ]
    yield ["cmake", "--build", str(build), "--target", f"plugin-{_HOST}"]


def _meshes(options: argparse.Namespace, folder: Path) -> list[MeshFile]:
    found = of_folder(options.meshes) if options.meshes else at_hand(folder, options.quick)
    return [mesh for mesh in found if fnmatch(mesh.name, options.only)]


def _judge(
    meshes: Sequence[MeshFile], compare: Callable[[MeshFile], list[Verdict]], console: Console
) -> tuple[list[Verdict], list[str]]:
    """The verdicts on all meshes, and why there is none on some."""
    verdicts, failures = [], []
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        answers = [pool.submit(compare, mesh) for mesh in meshes]
        for answer in track(answers, "comparing", console=console, transient=True):
            try:
                verdicts += answer.result()
            except FilterError as failure:
                failures.append(str(failure))
    return verdicts, failures


def _compare(base: Path, now: Path, filters: str, mesh: MeshFile) -> list[Verdict]:
    """The verdicts of all cases on one mesh."""
    cases = [case for case in cases_for(mesh.faces) if fnmatch(case.filter, filters)]
    runs = [(at, threads) for at, case in enumerate(cases) for threads in _threads(case)]
    before = _results_of_base(base, mesh, [_asked(case, _threads(case)[0]) for case in cases])
    after = _results(now, mesh, [_asked(cases[at], threads) for at, threads in runs])
    return [
        Verdict(
            mesh.name,
            cases[at],
            threads,
            bool(result["error"]),
            differences(before[at], result, RENAMED.get(cases[at].filter, {})),
        )
        for (at, threads), result in zip(runs, after, strict=True)
    ]


def _threads(case: Case) -> tuple[int | None, ...]:
    return _THREADS if case.filter in THREADED else (None,)


def _asked(case: Case, threads: int | None) -> dict[str, Any]:
    """A case as the worker reads it."""
    parameters = case.parameters | ({} if threads is None else {"threads": threads})
    return {"filter": case.filter, "state": case.state, "parameters": parameters}


def _results(plugin: Path, mesh: MeshFile, cases: list[dict[str, Any]]) -> list[Result]:
    job = {"plugin": str(plugin), "mesh": str(mesh.path), "cases": cases}
    what = f"{plugin} on {mesh.name}"
    return ask([sys.executable, str(_WORKER)], job, what)["results"]


def _results_of_base(plugin: Path, mesh: MeshFile, cases: list[dict[str, Any]]) -> list[Result]:
    """The same, kept for the next call: the base does not change."""
    asked = [metadata.version("pymeshlab"), *cases]
    parts = [path.read_bytes() for path in (plugin, mesh.path, _WORKER)]
    key = [*parts, json.dumps(asked).encode()]
    return kept(_BUILD / "results", key, lambda: _results(plugin, mesh, cases))


def differences(before: Result, now: Result, renamed: Mapping[str, str]) -> dict[str, str]:
    """What is not the same in two results of one case; renamed: of the report's names."""
    report = {renamed.get(name, name): value for name, value in before["report"].items()}
    once = before["arrays"] | report | {"error": before["error"]}
    ours = now["arrays"] | now["report"] | {"error": now["error"]}
    return {
        name: f"{_short(once.get(name))} > {_short(ours.get(name))}"
        for name in dict.fromkeys([*once, *ours])
        if once.get(name) != ours.get(name)
    }


def _short(value: str | None) -> str:
    """A value with the first digits of its hashes."""
    return (
        "none" if value is None else re.sub(rf"([0-9a-f]{{{_DIGITS}}})[0-9a-f]{{52}}", r"\1", value)
    )


def _show(
    console: Console, options: argparse.Namespace, verdicts: list[Verdict], failures: list[str]
) -> int:
    different = _grouped([each for each in verdicts if each.differences], lambda each: each.kind)
    shown = [_counts(verdicts), *([_kinds(different), _first(different)] if different else [])]
    for table in shown:
        console.print(table)
    for failure in failures:
        console.print(f"failed: {failure}", markup=False)
    if options.save:
        tables.save_markdown(options.save, "Same bits", [__doc__, *failures], shown)
    return 1 if different or failures or not verdicts else 0


def _grouped(verdicts: Sequence[Verdict], key: Callable[[Verdict], tuple[str, str]]) -> Groups:
    groups: Groups = {}
    for each in verdicts:
        groups.setdefault(key(each), []).append(each)
    return groups


def _counts(verdicts: Sequence[Verdict]) -> tables.Table:
    groups = _grouped(verdicts, lambda each: (each.case.filter, each.thread_count))
    groups["all", ""] = list(verdicts)
    rows = [(*names, *map(str, _counted(group))) for names, group in groups.items()]
    headings = ("filter", "threads", "cases", "same", "different", "refused")
    return tables.table("The base against ours: results of a case on a mesh", headings, rows)


def _counted(group: Sequence[Verdict]) -> tuple[int, int, int, int]:
    different = sum(bool(each.differences) for each in group)
    return len(group), len(group) - different, different, sum(each.refused for each in group)


def _kinds(different: Groups) -> tables.Table:
    rows = [
        (name, escape(what), str(len(group)), str(len({each.mesh for each in group})))
        for (name, what), group in different.items()
    ]
    return tables.table("What differs", ("filter", "differs in", "cases", "meshes"), rows)


def _first(different: Groups) -> tables.Table:
    firsts = [each for group in different.values() for each in group[:_LISTED_OF_A_KIND]]
    rows = [
        (each.mesh, each.case.filter, each.case.name, each.thread_count, _in_lines(each))
        for each in firsts[:_LISTED]
    ]
    headings = ("mesh", "filter", "case", "threads", "differs in")
    return tables.table("The first of each kind: base > ours", headings, rows)


def _in_lines(verdict: Verdict) -> str:
    return escape("\n".join(f"{name}: {values}" for name, values in verdict.differences.items()))


if __name__ == "__main__":
    sys.exit(main())
