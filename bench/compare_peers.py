# SPDX-License-Identifier: GPL-3.0-or-later
"""CurvDecim beside the other decimators, policy by policy; scripts/bench sets them up.

    scripts/bench                   # everything; hours
    scripts/bench --mesh cow.obj --policy 'CGAL*' --policy 'CurvDecim*' --repeats 1 --fraction 0.2
    scripts/bench --save --resume   # writes bench/results, and goes on after a stop
    scripts/bench --large --save    # time and memory on millions of faces
    scripts/bench --plot-only       # draws bench/results/peers.json again

A peer that is not there is listed as absent, and the others go on.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from datetime import date
from functools import lru_cache
from pathlib import Path

import tables
from decimators import DEFAULT_PLUGIN
from judge import Judge
from meshes import REPOSITORY, everything
from peers.large import LARGE, make
from peers.machine import Peers, describe, look
from peers.mesh_files import MeshFiles
from peers.plot import draw_summary
from peers.policies import Policy, every_policy, matching
from peers.records import Key, Results, load
from peers.report import NOTES, every_table
from peers.runs import Case, figures_of, measure, steps
from rich.console import Console
from rich.progress import Progress
from surface import Surface

_MESHES = (
    *("cow.obj", "bone.ply", "bunny.obj", "fandisk.obj"),
    *("rocker-arm.obj", "horse.ply", "stanford-bunny.obj", "igea.ply"),
)
_FRACTIONS = (0.20, 0.05)
_RESULTS = REPOSITORY / "bench/results"
_PICTURE = REPOSITORY / "docs/images/peers.png"
_CACHE = REPOSITORY / "build/bench"


def main() -> int:
    options = _options()
    console = tables.console()
    stored = options.results / f"{_stem(options)}.json"
    if options.plot_only:
        draw_summary(load(stored).records, options.picture)
        return 0
    peers = look(options.plugin)
    chosen = matching(every_policy(options.plugin), options.policy)
    present = [policy for policy in chosen if policy.peer in peers.versions]
    if not present:
        console.print("no policy to run", _absent(peers, chosen))
        return 1
    results = _start(options, peers, chosen, stored)
    with tempfile.TemporaryDirectory() as folder:
        _run(options, present, results, _files(options, Path(folder), console), console)
    _show(results, options, console)
    return 1 if any(record.failure for record in results.records) else 0


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    add = parser.add_argument
    add("--mesh", action="append", default=[], help="a file, or the name of one at hand")
    add("--policy", action="append", default=[], help="a shell pattern of policy names")
    add("--fraction", type=float, action="append", help="of the faces to keep")
    add("--repeats", type=int, default=5, help="runs of each policy, in turn")
    add("--timeout", type=float, default=1800.0, help="seconds for one run")
    add("--plugin", type=Path, default=DEFAULT_PLUGIN)
    add("--large", action="store_true", help="meshes of millions of faces, without errors")
    add("--save", action="store_true", help="write bench/results and the picture")
    add("--resume", action="store_true", help="keep what is saved, run what is missing")
    add("--plot-only", action="store_true", help="draw the saved figures again, run nothing")
    add("--results", type=Path, default=_RESULTS, help="the folder that is meant by saved")
    add("--picture", type=Path, default=_PICTURE)
    options = parser.parse_args()
    if options.repeats < 1:
        parser.error("--repeats: at least 1")
    return options


def _stem(options: argparse.Namespace) -> str:
    return "peers-large" if options.large else "peers"


def _absent(peers: Peers, policies: Sequence[Policy]) -> dict[str, str]:
    wanted = {policy.peer for policy in policies}
    return {peer: reason for peer, reason in peers.absent.items() if peer in wanted}


def _start(
    options: argparse.Namespace, peers: Peers, chosen: Sequence[Policy], stored: Path
) -> Results:
    """What is saved, with --resume on the same machine; else nothing but the surroundings."""
    versions = {policy.peer: peers.versions.get(policy.peer, "") for policy in chosen}
    here = Results(
        date=date.today().isoformat(),
        machine=describe(),
        versions={peer: version for peer, version in versions.items() if version},
        absent=_absent(peers, chosen),
        originals={},
        records=[],
    )
    if not (options.resume and stored.exists()):
        return here
    saved = load(stored)
    if saved.machine != here.machine:
        raise SystemExit(f"{stored}: measured on another machine; run without --resume")
    here.versions.update({p: v for p, v in saved.versions.items() if p not in here.versions})
    here.originals.update(saved.originals)
    here.records.extend(record for record in saved.records if not record.failure)
    return here


def _files(options: argparse.Namespace, folder: Path, console: Console) -> list[MeshFiles]:
    at_hand = {path.name: path for path in everything()}
    if options.large:
        return _large_files(options.mesh, at_hand, console)
    found = []
    for name in options.mesh or _MESHES:
        path = at_hand.get(name, Path(name))
        if path.is_file():
            found.append(MeshFiles(path.name, path, folder))
        else:
            console.print(f"left out, not at hand: {name}", markup=False)
    return found


def _large_files(
    names: Sequence[str], at_hand: Mapping[str, Path], console: Console
) -> list[MeshFiles]:
    found = []
    for large in LARGE:
        if names and large.name not in names:
            continue
        if large.source not in at_hand:
            console.print(f"left out, {large.source} is not at hand: {large.name}", markup=False)
            continue
        console.print(f"{large.name}: made once, kept in {_CACHE}", markup=False)
        path = make(large, at_hand[large.source], _CACHE)
        found.append(MeshFiles(large.name, path, _CACHE))
    return found


def _run(
    options: argparse.Namespace,
    policies: Sequence[Policy],
    results: Results,
    files: Sequence[MeshFiles],
    console: Console,
) -> None:
    """Adds the records of every mesh and target, and saves after each."""
    done = {record.key for record in results.records}
    judges = lru_cache(maxsize=1)(lambda mesh: Judge(*mesh.arrays))  # one for both targets
    with Progress(console=console, transient=True) as progress:
        task = progress.add_task("", total=None)
        for mesh, fraction, rest in _todo(options, policies, files, done):
            progress.reset(task, total=steps(rest, options.repeats))

            def advance(step: str, where: str = f"{mesh.name} to {fraction:.0%}") -> None:
                progress.update(task, advance=1, description=f"{where}: {step}")

            judge = None if options.large else judges(mesh)
            case = Case(mesh, fraction, judge, options.timeout)
            results.records.extend(measure(case, rest, options.repeats, advance))
            if not options.large:
                results.originals[mesh.name] = figures_of(Surface(*mesh.arrays))
            if options.save:
                results.save(options.results / f"{_stem(options)}.json")


def _todo(
    options: argparse.Namespace,
    policies: Sequence[Policy],
    files: Sequence[MeshFiles],
    done: set[Key],
) -> Iterator[tuple[MeshFiles, float, list[Policy]]]:
    for mesh in files:
        for fraction in options.fraction or _FRACTIONS:
            rest = [p for p in policies if (mesh.name, fraction, p.name) not in done]
            if options.large:
                rest = [policy for policy in rest if policy.largest_faces >= mesh.face_count]
            if rest:
                yield mesh, fraction, rest


def _show(results: Results, options: argparse.Namespace, console: Console) -> None:
    shown = every_table(results)
    for each in shown:
        console.print(each)
    if not options.save:
        return
    notes = [__doc__, _surroundings(results), *NOTES]
    heading = "Peers on large meshes" if options.large else "Peers"
    tables.save_markdown(options.results / f"{_stem(options)}.md", heading, notes, shown)
    if not options.large:
        draw_summary(results.records, options.picture)


def _surroundings(results: Results) -> str:
    machine = ", ".join(f"{name} {value}" for name, value in results.machine.items())
    versions = ", ".join(f"{peer} {version}" for peer, version in results.versions.items())
    return f"Measured on {results.date}: {machine}. Versions: {versions}."


if __name__ == "__main__":
    sys.exit(main())
