# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the meshes are, and how they are read."""

from __future__ import annotations

import os
from pathlib import Path

import pymeshlab
from surface import Floats, Ints

REPOSITORY = Path(__file__).resolve().parents[1]
_FORMATS = (".obj", ".ply", ".off", ".stl", ".glb")


def read_mesh(path: str | Path) -> tuple[Floats, Ints]:
    """Vertices (n, 3) and triangles (m, 3) of a file, as PyMeshLab reads it."""
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(str(path))
    mesh = meshes.current_mesh()
    return mesh.vertex_matrix(), mesh.face_matrix().astype("int64")


def write_mesh(path: str | Path, vertices: Floats, faces: Ints) -> None:
    """Saves vertices (n, 3) and faces (m, 3); PLY keeps doubles to the bit."""
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.add_mesh(pymeshlab.Mesh(vertices, faces.astype("int32")))
    meshes.save_current_mesh(str(path))


def shipped(name: str) -> Path:
    """A sample mesh that comes with PyMeshLab, as 'cow.obj'."""
    path = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes" / name
    if not path.is_file():
        raise FileNotFoundError(f"PyMeshLab's sample mesh {path} is missing; reinstall pymeshlab")
    return path


def shared_folder() -> Path:
    """A folder of further meshes: $CURVDECIM_MESHES, or ../shared/meshes; it may be absent."""
    return Path(os.environ.get("CURVDECIM_MESHES", REPOSITORY.parent / "shared" / "meshes"))


def everything() -> list[Path]:
    """Every mesh file of PyMeshLab's samples, of our own and of the shared folder, once a name."""
    folders = (shipped("cow.obj").parent, REPOSITORY / "sample_meshes", shared_folder())
    files = [path for folder in folders if folder.is_dir() for path in mesh_files(folder)]
    return list({path.name: path for path in files}.values())


def mesh_files(folder: Path) -> list[Path]:
    """The mesh files of a folder, by name, without those of its own folders."""
    return sorted(path for path in folder.iterdir() if path.suffix.lower() in _FORMATS)
