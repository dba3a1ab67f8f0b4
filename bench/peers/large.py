# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of millions of faces for time and memory, made by subdivision and kept in build/bench."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import igl
from binary_mesh import write_binary
from meshes import read_mesh


@dataclass(frozen=True)
class Large:
    """A mesh after some steps of Loop subdivision, each of which makes four faces of one."""

    source: str
    steps: int

    @property
    def name(self) -> str:
        return f"{Path(self.source).stem}-loop{self.steps}"


LARGE = (
    Large("horse.ply", 2),  # 1.6 million faces
    Large("igea.ply", 2),  # 4.3 million
    Large("igea.ply", 3),  # 17 million
)


def make(large: Large, source: Path, folder: Path) -> Path:
    """The binary mesh file, made on first use; the same bits every time."""
    path = folder / f"{large.name}.bin"
    if not path.exists():
        vertices, faces = read_mesh(source)
        for _ in range(large.steps):
            vertices, faces = igl.loop(vertices, faces)
        folder.mkdir(parents=True, exist_ok=True)
        unfinished = path.with_suffix(".part")
        write_binary(unfinished, vertices, faces)
        unfinished.rename(path)
    return path
