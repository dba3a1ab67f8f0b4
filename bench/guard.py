# SPDX-License-Identifier: GPL-3.0-or-later
"""Guards the speed: the core as it is here against the core before its last change.

    python bench/guard.py                 # against the last commit whose core differs from ours
    python bench/guard.py --base v0.1.0   # against any commit

Both are built into one small driver each, with their own compiler flags, and decimate the same
meshes in turn on this machine. Ends with 1 when a preset takes more than a quarter longer, in the
geometric mean over the meshes and by the least of the runs, and does so again when measured once
more. Where there is nothing to compare with, it says so and ends with 0.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import tables
from binary_mesh import write_binary
from commits import IncomparableError, full_name, git, meshlab_sources, unpack
from meshes import REPOSITORY, read_mesh, shipped
from numpy.typing import NDArray

PRESETS = ("Fast", "Balanced", "Best")
SLOWER = 1.25  # times the time before: more fails
_KEPT = 0.1  # of the faces
_BUILD = REPOSITORY / "build/guard"
_CORE = ("vcg_ext", "cmake")  # what a driver is built from, and with which flags
_MOST_SECONDS = 60.0  # for one run; it takes well under one

Times = dict[tuple[str, str], float]
"""Mesh and preset to the least seconds."""


def main() -> int:
    options = _options()
    console = tables.console()
    try:
        base = _base(options.base)
        drivers = _drivers(base)
    except IncomparableError as reason:
        console.print(f"speed guard skipped: {reason}", markup=False)
        return 0
    with tempfile.TemporaryDirectory() as folder:
        meshes = _write_meshes(Path(folder))
        before, now = _race(drivers, meshes, options.runs, ({}, {}))
        if slower(before, now):  # noise only ever adds time: more runs take it away
            before, now = _race(drivers, meshes, 2 * options.runs, (before, now))
    console.print(_table(base, before, now))
    found = slower(before, now)
    for preset, ratio in found.items():
        console.print(f"speed guard: {preset} takes {ratio:.2f} times as long as before")
    return 1 if found else 0


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--base", help="a commit; else the last one with another core")
    parser.add_argument("--runs", type=int, default=5, help="of each, in turn; the least counts")
    options = parser.parse_args()
    if options.runs < 1:
        parser.error("--runs: at least 1")
    return options


def slower(before: Mapping[tuple[str, str], float], now: Mapping[tuple[str, str], float]) -> dict:
    """The presets that became slower than allowed, with the geometric mean of now / before."""
    found = {preset: mean_ratio(before, now, preset) for preset in PRESETS}
    return {preset: ratio for preset, ratio in found.items() if ratio > SLOWER}


def mean_ratio(
    before: Mapping[tuple[str, str], float], now: Mapping[tuple[str, str], float], preset: str
) -> float:
    """Geometric mean over the meshes of now / before."""
    logs = [math.log(now[key] / before[key]) for key in before if key[1] == preset]
    return math.exp(sum(logs) / len(logs))


def _base(wanted: str | None) -> str:
    """The commit to compare with, in full."""
    if wanted is not None:
        return full_name(wanted)
    if git("status", "--porcelain", "--", *_CORE):
        return full_name("HEAD")
    changed = git("log", "-1", "--format=%H", "--", *_CORE)
    return full_name(f"{changed}^1")


def _drivers(base: str) -> tuple[Path, Path]:
    """The drivers of the base and of this tree, built at the same time."""
    here, there = _BUILD / "here", _BUILD / base
    source = there / "source"
    unpack(base, source, _CORE)
    builds = [_start_build(source, there / "build"), _start_build(REPOSITORY, here / "build")]
    failed = [build.wait() != 0 for build in builds]
    if failed[1]:
        log = (here / "build/log.txt").read_text(encoding="utf-8", errors="replace")
        sys.exit(f"speed guard: the driver cannot be built with the core as it is here\n{log}")
    if failed[0]:
        log = (there / "build/log.txt").relative_to(REPOSITORY)
        raise IncomparableError(f"commit {base[:10]} cannot be built by this driver, see {log}")
    return there / "build/driver", here / "build/driver"


def _start_build(source: Path, build: Path) -> subprocess.Popen:
    build.mkdir(parents=True, exist_ok=True)
    configure = ["cmake", "-S", str(REPOSITORY / "bench/guard"), "-B", str(build), "-G", "Ninja"]
    configure += [f"-DCURVDECIM_SOURCE_DIR={source}", f"-DMESHLAB_SOURCE_DIR={meshlab_sources()}"]
    log = (build / "log.txt").open("w", encoding="utf-8")
    script = '"$@" && exec cmake --build "$0"'  # $0: the build folder, the rest: configure
    return subprocess.Popen(
        ["sh", "-c", script, str(build), *configure], stdout=log, stderr=subprocess.STDOUT
    )


def _write_meshes(folder: Path) -> dict[Path, int]:
    """Mesh files and the faces to keep of each."""
    meshes = {"torus": bumpy_torus(), "ridges": ridges(), "bunny": read_mesh(shipped("bunny.obj"))}
    written = {}
    for name, (vertices, faces) in meshes.items():
        write_binary(folder / f"{name}.bin", vertices, faces)
        written[folder / f"{name}.bin"] = round(_KEPT * len(faces))
    return written


def bumpy_torus(around: int = 320, across: int = 120) -> tuple[NDArray, NDArray]:
    """A closed surface of genus 1 with waves of two wavelengths."""
    u, v = _angles(around), _angles(across)
    u, v = np.meshgrid(u, v, indexing="ij")
    tube = 0.4 + 0.05 * np.sin(5 * u) * np.cos(3 * v) + 0.01 * np.sin(23 * u + 17 * v)
    radius = 1 + tube * np.cos(v)
    points = np.stack([radius * np.cos(u), radius * np.sin(u), tube * np.sin(v)], axis=-1)
    return points.reshape(-1, 3), _grid_faces(around, across, closed=True)


def ridges(across: int = 200) -> tuple[NDArray, NDArray]:
    """A square with a boundary and sharp, straight ridges along both axes."""
    side = np.linspace(0, 1, across)
    x, y = np.meshgrid(side, side, indexing="ij")
    height = 0.05 * np.abs(np.sin(9 * x)) + 0.05 * np.abs(np.sin(7 * y))
    return np.stack([x, y, height], axis=-1).reshape(-1, 3), _grid_faces(across, across, False)


def _angles(count: int) -> NDArray:
    return np.arange(count) * (2 * np.pi / count)


def _grid_faces(rows: int, columns: int, closed: bool) -> NDArray:
    """(m, 3): two triangles a cell of a grid; closed: its last row and column meet the first."""
    last = 0 if closed else 1
    i, j = np.meshgrid(np.arange(rows - last), np.arange(columns - last), indexing="ij")
    a = i * columns + j
    b = (i + 1) % rows * columns + j
    c = (i + 1) % rows * columns + (j + 1) % columns
    d = i * columns + (j + 1) % columns
    return np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)


def _race(
    drivers: tuple[Path, Path], meshes: dict[Path, int], runs: int, least: tuple[Times, Times]
) -> tuple[Times, Times]:
    """The least times of both drivers so far, after so many more runs of each in turn."""
    before, now = dict(least[0]), dict(least[1])
    for _ in range(runs):
        for mesh, target in meshes.items():
            for preset in PRESETS:
                key = mesh.stem, preset
                for driver, times in zip(drivers, (before, now), strict=True):
                    seconds = _seconds(driver, mesh, preset, target)
                    times[key] = min(seconds, times.get(key, math.inf))
    return before, now


def _seconds(driver: Path, mesh: Path, preset: str, target: int) -> float:
    command = [str(driver), preset, str(target), str(mesh), os.devnull]
    done = subprocess.run(
        command, capture_output=True, text=True, check=True, timeout=_MOST_SECONDS
    )
    return float(json.loads(done.stdout)["seconds"])


def _table(base: str, before: Times, now: Times) -> tables.Table:
    rows = [
        (
            f"{mesh} {preset}",
            f"{1000 * before[mesh, preset]:.1f}",
            f"{1000 * now[mesh, preset]:.1f}",
            f"{now[mesh, preset] / before[mesh, preset]:.3f}",
        )
        for mesh, preset in before
    ]
    rows += [
        (f"geometric mean {preset}", "", "", f"{mean_ratio(before, now, preset):.3f}")
        for preset in PRESETS
    ]
    title = f"Speed: now over {base[:10]}, at most {SLOWER}"
    return tables.table(title, ("mesh and preset", "ms before", "ms now", "ratio"), rows)


if __name__ == "__main__":
    sys.exit(main())
