# SPDX-License-Identifier: GPL-3.0-or-later
"""The meshes of `same_bits`: those at hand, those that are drawn elsewhere, and some drawn here."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pymeshlab
from guard import bumpy_torus, ridges
from meshes import everything, mesh_files, read_mesh, shared_folder, write_mesh
from numpy.typing import NDArray
from same_bits_cases import PAINTED, SELECTED
from same_bits_worker import prepare

MOST_FACES = 65_000
_QUICK_FACES = 3_100


@dataclass(frozen=True)
class MeshFile:
    """A mesh on the disk."""

    path: Path
    faces: int

    @property
    def name(self) -> str:
        """Of its file."""
        return self.path.name


def at_hand(folder: Path, quick: bool) -> list[MeshFile]:
    """All meshes, the largest first; those that are drawn are written to the folder.

    quick: without the shared folder, and only small ones.
    """
    paths = [*everything(), *_drawn_here(folder / "here")]
    if quick:
        paths = [path for path in paths if path.parent != shared_folder()]
        return _sized(paths, _QUICK_FACES)
    real = shared_folder() / "real"
    if real.is_dir():
        paths += [*mesh_files(real), *_drawn_there(real / "make_cases.py", folder / "there")]
    return _sized(paths, MOST_FACES)


def of_folder(folder: Path) -> list[MeshFile]:
    """The meshes of one folder, the largest first."""
    return _sized(mesh_files(folder), MOST_FACES)


def _sized(paths: Iterable[Path], most: int) -> list[MeshFile]:
    """The largest first: the small ones fill the time that other cores wait."""
    files = [MeshFile(path, len(read_mesh(path)[1])) for path in paths]
    small = [file for file in files if 0 < file.faces <= most]
    return sorted(small, key=lambda file: file.faces, reverse=True)


def _drawn_there(script: Path, folder: Path) -> list[Path]:
    """What the shared folder's own script draws, where it is there."""
    if not script.is_file():
        return []
    subprocess.run([sys.executable, str(script), str(folder)], check=True)
    return mesh_files(folder)


def _drawn_here(folder: Path) -> list[Path]:
    folder.mkdir()
    write_mesh(folder / "waves.ply", *bumpy_torus(160, 60))
    write_mesh(folder / "ridges.ply", *ridges(80))
    write_mesh(folder / "hubs_100.ply", *hubs(100, 8))
    write_mesh(folder / "hubs_250.ply", *hubs(250, 3))
    for state in (SELECTED, PAINTED):
        _write_prepared(folder / f"waves_{state.replace(' ', '_')}.ply", state)
    return mesh_files(folder)


def hubs(blades: int, count: int) -> tuple[NDArray, NDArray]:
    """Closed double cones of many narrow faces, each with two vertices of so many faces."""
    angles = np.arange(blades) * (2 * np.pi / blades)
    rim = np.stack([np.cos(angles), np.sin(angles), 0.1 * np.sin(7 * angles)], axis=1)
    cone = np.concatenate([rim * (1 + 0.1 * np.cos(11 * angles[:, None])), [(0, 0, 2), (0, 0, -1)]])
    i, j = np.arange(blades), (np.arange(blades) + 1) % blades
    top, bottom = np.full(blades, blades), np.full(blades, blades + 1)
    faces = np.concatenate([np.stack([top, i, j], axis=1), np.stack([bottom, j, i], axis=1)])
    vertices = np.concatenate([cone + (3.0 * turn, 0, 0) for turn in range(count)])
    return vertices, np.concatenate([faces + turn * len(cone) for turn in range(count)])


def _write_prepared(path: Path, state: str) -> None:
    """A torus with attributes that are in its file, so that every case has them."""
    vertices, faces = bumpy_torus(56, 24)
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.add_mesh(pymeshlab.Mesh(vertices, faces.astype("int32")))
    prepare(meshes, state)
    meshes.save_current_mesh(
        str(path), save_vertex_color=True, save_vertex_quality=True, save_face_flag=True
    )
