# SPDX-License-Identifier: GPL-3.0-or-later
"""What is measured on, and which peers are there in which version."""

from __future__ import annotations

import os
import platform
import re
import subprocess
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path

from decimators import DEFAULT_PLUGIN
from meshes import REPOSITORY
from workers import FilterError, ask

from peers.adapters import BUILD, LIBRARY_PYTHON, LIBRARY_WORKER, PROGRAMS
from peers.policies import CORE, OURS

_PROGRAM_OF = {
    "CGAL": "cgal",
    "OpenMesh": "openmesh",
    "meshoptimizer": "meshoptimizer",
    CORE: "curvdecim",
}
_LIBRARIES = ("VTK", "libigl", "fast-simplification", "MeshLib", "Open3D", "Blender")
_SETUP_HINT = "not set up; scripts/bench sets it up"
_BLENDER_HINT = "large, so not set up; build/peers/venv/bin/pip install bpy adds it"


@dataclass(frozen=True)
class Peers:
    """versions: of the peers that are there. absent: why the others are not."""

    versions: dict[str, str]
    absent: dict[str, str]


def look(plugin: Path = DEFAULT_PLUGIN) -> Peers:
    """Asks every peer for its version."""
    versions = {"MeshLab": f"PyMeshLab {metadata.version('pymeshlab')}"}
    absent = {}
    if plugin.is_file():
        versions[OURS] = our_version()
    else:
        absent[OURS] = f"no plugin {plugin.name}; scripts/setup demo builds it"
    reasons = _reasons_of_setup(BUILD / "absent.txt")
    for peer, version in (_program_versions() | _library_versions()).items():
        if version is None:
            absent[peer] = reasons.get(peer, _BLENDER_HINT if peer == "Blender" else _SETUP_HINT)
        else:
            versions[peer] = version
    if CORE in versions:
        versions[CORE] = our_version()
    return Peers(versions, absent)


def our_version() -> str:
    """The commit, or the version in CMakeLists.txt outside a checkout."""
    command = ["git", "-C", str(REPOSITORY), "describe", "--always", "--dirty"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        return done.stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        text = (REPOSITORY / "CMakeLists.txt").read_text(encoding="utf-8")
        found = re.search(r"VERSION (\d[\d.]*) LANGUAGES", text)
        return found.group(1) if found else "unknown"


def describe() -> dict[str, str]:
    """The processor, its cores, the memory and the system."""
    gib = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    return {
        "processor": processor(Path("/proc/cpuinfo")),
        "cores": str(len(os.sched_getaffinity(0))),
        "memory": f"{gib:.0f} GiB",
        "system": platform.freedesktop_os_release().get("PRETTY_NAME", platform.system()),
    }


def processor(cpuinfo: Path) -> str:
    """The model's name."""
    text = cpuinfo.read_text(encoding="utf-8") if cpuinfo.exists() else ""
    found = re.search(r"^model name\s*:\s*(.+)$", text, re.MULTILINE)
    return found.group(1).strip() if found else platform.machine()


def _reasons_of_setup(path: Path) -> dict[str, str]:
    if not path.exists():
        return {}
    lines = path.read_text(encoding="utf-8").splitlines()
    names = {name.lower(): name for name in (*_PROGRAM_OF, *_LIBRARIES)}
    pairs = (line.partition(": ") for line in lines)
    return {names.get(name.lower(), name): reason for name, _, reason in pairs}


def _program_versions() -> dict[str, str | None]:
    found: dict[str, str | None] = {}
    for peer, program in _PROGRAM_OF.items():
        try:
            command = [str(PROGRAMS / program), "--version"]
            done = subprocess.run(command, capture_output=True, text=True, check=True)
            found[peer] = done.stdout.strip()
        except (OSError, subprocess.CalledProcessError):
            found[peer] = None
    return found


def _library_versions() -> dict[str, str | None]:
    try:
        command = [str(LIBRARY_PYTHON), str(LIBRARY_WORKER), "--versions"]
        answer = ask(command, None, "the peers' libraries")
        return {name: answer[name]["version"] for name in _LIBRARIES}
    except FilterError:
        return dict.fromkeys(_LIBRARIES)
