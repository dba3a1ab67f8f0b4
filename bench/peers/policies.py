# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of everything that is measured: a row is a peer with its settings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path

from decimators import (
    REPRESENTATIVES,
    curvdecim,
    curvdecim_clustering,
    meshlab,
    meshlab_clustering,
    spheres,
)

from peers.adapters import Adapter, HostFilter, Library, Program

OURS, CORE = "CurvDecim", "CurvDecim core"  # in PyMeshLab, and without a host
FAST, BALANCED, BEST = f"{OURS} Fast", f"{OURS} Balanced", f"{OURS} Best"
SPHERES = f"{OURS} Spheres"
CORE_FAST = f"{CORE} Fast"
BASELINE = "MeshLab quadric"
MESHOPTIMIZER_UPDATE = "meshoptimizer simplifyWithUpdate"

_UNIT = 1000.0  # the diagonal for peers whose result depends on the unit of length
_ANY_SIZE = 10**9
# Millions of faces that a policy can do in minutes and in a few gigabytes.
_MILLION, _FEW_MILLIONS = 2_000_000, 5_000_000


@dataclass(frozen=True)
class Policy:
    """A peer with its settings.

    peer: whose version it is. diagonal: the mesh is scaled to it; None: as it is.
    largest_faces: of the meshes of --large that it is run on.
    """

    name: str
    peer: str
    adapter: Adapter
    diagonal: float | None = None
    largest_faces: int = 0


def every_policy(plugin: Path) -> list[Policy]:
    """plugin: ours, for PyMeshLab."""
    return [
        *_ours(plugin),
        *_meshlab(),
        *_cgal(),
        Policy("OpenMesh quadric", "OpenMesh", Program("openmesh", "quadric")),
        *_meshoptimizer(),
        *_vtk(),
        Policy("libigl qslim", "libigl", Library("igl.qslim"), largest_faces=_MILLION),
        Policy("libigl decimate", "libigl", Library("igl.decimate")),
        *_fast_simplification(),
        *_meshlib(),
        *_open3d(),
        Policy("Blender decimate", "Blender", Library("blender"), largest_faces=_FEW_MILLIONS),
    ]


def matching(policies: Sequence[Policy], patterns: Sequence[str]) -> list[Policy]:
    """Those whose name fits one of the shell patterns, case apart; all without a pattern."""
    if not patterns:
        return list(policies)
    low = [pattern.lower() for pattern in patterns]
    return [p for p in policies if any(fnmatchcase(p.name.lower(), pattern) for pattern in low)]


def _ours(plugin: Path) -> list[Policy]:
    def policy(name: str, **parameters: str) -> Policy:
        filter_ = HostFilter(curvdecim(plugin, name, **parameters))
        return Policy(name, OURS, filter_, largest_faces=_ANY_SIZE)

    presets = {FAST: "Fast", BALANCED: "Balanced", BEST: "Best"}
    return [
        *(policy(name, preset=preset) for name, preset in presets.items()),
        *(
            policy(f"{name}, plain quadric", preset=preset, metric="Quadric")
            for name, preset in presets.items()
        ),
        *(
            Policy(f"{CORE} {preset}", CORE, Program("curvdecim", preset), largest_faces=_ANY_SIZE)
            for preset in presets.values()
        ),
        Policy(SPHERES, OURS, HostFilter(spheres(plugin, SPHERES)), largest_faces=_ANY_SIZE),
        *_our_clustering(plugin),
    ]


def _our_clustering(plugin: Path) -> list[Policy]:
    """By cells in the host; the core looks for the target itself, as simplifySloppy does."""
    name = f"{OURS} clustering"
    filters = (
        curvdecim_clustering(plugin, f"{name} {each}", representative=each)
        for each in REPRESENTATIVES
    )
    core = Program("curvdecim", "Clustering")
    return [
        *(Policy(filter_.name, OURS, HostFilter(filter_)) for filter_ in filters),
        Policy(f"{CORE} clustering", CORE, core, largest_faces=_ANY_SIZE),
    ]


def _meshlab() -> list[Policy]:
    def policy(name: str, diagonal: float | None = None, **parameters: bool) -> Policy:
        return Policy(name, "MeshLab", HostFilter(meshlab(name, **parameters)), diagonal)

    safe = {"preserveboundary": True, "preservenormal": True, "preservetopology": True}
    return [
        Policy(BASELINE, "MeshLab", HostFilter(meshlab()), largest_faces=_FEW_MILLIONS),
        policy(f"{BASELINE}, diagonal {_UNIT:g}", _UNIT),
        policy(f"{BASELINE}, planar", planarquadric=True),
        policy(f"{BASELINE}, all preserved", **safe),
        Policy("MeshLab clustering", "MeshLab", HostFilter(meshlab_clustering())),
    ]


def _cgal() -> list[Policy]:
    garland_heckbert = ("plane", "probabilistic-plane", "triangle", "probabilistic-triangle")
    return [
        Policy(
            "CGAL Lindstrom-Turk",
            "CGAL",
            Program("cgal", "lindstrom-turk"),
            largest_faces=_MILLION,
        ),
        *(
            Policy(f"CGAL Garland-Heckbert {name.replace('-', ' ')}", "CGAL", Program("cgal", name))
            for name in garland_heckbert
        ),
    ]


def _meshoptimizer() -> list[Policy]:
    def policy(function: str, calls: str, largest_faces: int = 0) -> Policy:
        adapter = Program("meshoptimizer", calls)
        name = f"meshoptimizer {function}"
        return Policy(name, "meshoptimizer", adapter, largest_faces=largest_faces)

    options = ("LockBorder", "Prune", "Regularize", "Permissive")
    return [
        policy("simplify", "simplify", _ANY_SIZE),
        policy("simplifyWithUpdate", "update", _ANY_SIZE),
        *(policy(f"simplifyWithUpdate {each}", f"update+{each}") for each in options),
        policy("simplifySloppy", "sloppy", _ANY_SIZE),
    ]


def _vtk() -> list[Policy]:
    def policy(name: str, call: str, largest_faces: int = 0, clusters: bool = False) -> Policy:
        adapter = Library(f"vtk.{call}", clusters)
        return Policy(f"VTK {name}", "VTK", adapter, largest_faces=largest_faces)

    return [
        policy("QuadricDecimation", "quadric", _FEW_MILLIONS),
        policy("QuadricDecimation, volume preserved", "quadric-volume"),
        policy("DecimatePro", "decimate-pro", _MILLION),
        policy("DecimatePro, topology preserved", "decimate-pro-topology"),
        policy("QuadricClustering", "clustering", clusters=True),
    ]


def _fast_simplification() -> list[Policy]:
    name, adapter = "fast-simplification", Library("fast-simplification")
    return [
        Policy(name, name, adapter),
        Policy(f"{name}, diagonal {_UNIT:g}", name, adapter, _UNIT, largest_faces=_ANY_SIZE),
    ]


def _meshlib() -> list[Policy]:
    def policy(settings: str, call: str, largest_faces: int = 0) -> Policy:
        return Policy(f"MeshLib{settings}", "MeshLib", Library(call), largest_faces=largest_faces)

    return [
        policy("", "meshlib", _FEW_MILLIONS),
        policy(", 16 parts", "meshlib.16", _ANY_SIZE),
        policy(", accurate", "meshlib.accurate"),
        policy(", accurate, 16 parts", "meshlib.accurate-16"),
    ]


def _open3d() -> list[Policy]:
    quadric = Library("open3d.quadric")
    average = Library("open3d.clustering-average", clusters=True)
    clustering = Library("open3d.clustering-quadric", clusters=True)
    unit = f"diagonal {_UNIT:g}"
    return [
        Policy("Open3D quadric", "Open3D", quadric),
        Policy(f"Open3D quadric, {unit}", "Open3D", quadric, _UNIT, _MILLION),
        Policy("Open3D clustering average", "Open3D", average),
        Policy("Open3D clustering quadric", "Open3D", clustering),
        Policy(f"Open3D clustering quadric, {unit}", "Open3D", clustering, _UNIT),
    ]
