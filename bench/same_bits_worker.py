# SPDX-License-Identifier: GPL-3.0-or-later
"""Applies many filters of one plugin to one mesh and writes what came out; `same_bits` starts it.

Two plugins of one name cannot live in one process. Reads a job as JSON from standard input:

    {"mesh": path, "plugin": path, "cases": [{"filter": name, "state": name, "parameters": {...}}]}

and writes {"results": [...]}, one a case, as the last line of standard output. A result has

    arrays   per array of the mesh its size and the SHA-256 of its bits
    report   what the filter returned, each value as Python spells it, without the seconds
    error    the message of a filter that refused, otherwise an empty text

Standard error has a line at the beginning of each case: after a crash the last one is the culprit.
"""

from __future__ import annotations

import hashlib
import json
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pymeshlab
from filter_worker import values

_ALWAYS = (
    "vertex_matrix",
    "face_matrix",
    "vertex_color_matrix",
    "vertex_scalar_array",
    "vertex_normal_matrix",
    "face_normal_matrix",
    "vertex_selection_array",
    "face_selection_array",
)
_WHERE_THERE = {
    "has_vertex_tex_coord": "vertex_tex_coord_matrix",
    "has_wedge_tex_coord": "wedge_tex_coord_matrix",
    "has_face_color": "face_color_matrix",
    "has_face_scalar": "face_scalar_array",
}
_REFUSALS = (pymeshlab.PyMeshLabException, pymeshlab.InvalidEnumException)
_NO_RESULT = "seconds"  # of a report: it may differ


def run(job: dict) -> dict:
    """The results of all cases, each on a mesh as it was read."""
    pymeshlab.load_plugin(job["plugin"])
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(job["mesh"])
    mesh = meshes.current_mesh_id()
    prepared = {state: _prepared(meshes, mesh, state) for state in STATES}
    return {"results": [_result(meshes, prepared[case["state"]], case) for case in job["cases"]]}


def _prepared(meshes: pymeshlab.MeshSet, mesh: int, state: str) -> int:
    """A copy of a mesh in one of the states."""
    _copy(meshes, mesh)
    prepare(meshes, state)
    return meshes.current_mesh_id()


def _copy(meshes: pymeshlab.MeshSet, mesh: int) -> None:
    """Makes a copy of a mesh the current one."""
    meshes.set_current_mesh(mesh)
    meshes.apply_filter("generate_copy_of_current_mesh")


def _result(meshes: pymeshlab.MeshSet, mesh: int, case: dict) -> dict:
    print(json.dumps(case), file=sys.stderr, flush=True)
    known = {each.id() for each in meshes}
    _copy(meshes, mesh)
    report, error = {}, ""
    try:
        report = meshes.apply_filter(case["filter"], **values(case["parameters"])) or {}
    except _REFUSALS as refusal:
        error = str(refusal)
    result = {"arrays": _arrays(meshes), "report": _spelled(report), "error": error}
    _delete_others(meshes, known)
    return result


def _delete_others(meshes: pymeshlab.MeshSet, known: set[int]) -> None:
    """The copy, and what a filter has added to it."""
    for made in [each.id() for each in meshes if each.id() not in known]:
        meshes.set_current_mesh(made)
        meshes.delete_current_mesh()


def _spelled(report: dict) -> dict[str, str]:
    return {name: repr(value) for name, value in report.items() if name != _NO_RESULT}


def _arrays(meshes: pymeshlab.MeshSet) -> dict[str, str]:
    mesh = meshes.current_mesh()
    arrays = {name: digest(getattr(mesh, name)()) for name in _names(mesh)}
    if mesh.has_wedge_tex_coord():  # PyMeshLab has no array of which texture a face has
        arrays["saved_mesh"] = _saved(meshes)
    return arrays


def _names(mesh: pymeshlab.Mesh) -> Iterator[str]:
    yield from _ALWAYS
    yield from (name for is_there, name in _WHERE_THERE.items() if getattr(mesh, is_there)())


def digest(array: np.ndarray) -> str:
    """The size of an array and the SHA-256 of its bits: -0.0 is not 0.0, NaN is NaN."""
    size = "x".join(map(str, array.shape))
    return f"{size} {hashlib.sha256(array.tobytes()).hexdigest()}"


def _saved(meshes: pymeshlab.MeshSet) -> str:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "mesh.ply"
        meshes.save_current_mesh(str(path), save_wedge_texcoord=True, save_textures=False)
        return digest(np.fromfile(path, np.uint8))


def prepare(meshes: pymeshlab.MeshSet, state: str) -> None:
    """Brings the current mesh into one of the states that a case asks for."""
    _PREPARATIONS[state](meshes)


def _select_half(meshes: pymeshlab.MeshSet) -> None:
    """Selects the faces whose centre is on the lower side of the median along x."""
    mesh = meshes.current_mesh()
    sums = mesh.vertex_matrix()[mesh.face_matrix(), 0].sum(axis=1)
    condition = f"x0 + x1 + x2 < {np.median(sums):.17g}"
    meshes.apply_filter("compute_selection_by_condition_per_face", condselect=condition)


def _paint(meshes: pymeshlab.MeshSet) -> None:
    """Quality and colour of the vertices from their places: quality 1 to 10 along x."""
    box = meshes.current_mesh().bounding_box()
    low, size = box.min(), box.diagonal() or 1.0
    x, y, z = (
        f"(({axis} - {least:.17g}) / {size:.17g})" for axis, least in zip("xyz", low, strict=True)
    )
    meshes.apply_filter("compute_scalar_by_function_per_vertex", q=f"1 + 9 * {x}", normalize=False)
    meshes.apply_filter(
        "compute_color_by_function_per_vertex", x=f"255 * {x}", y=f"255 * {y}", z=f"255 * {z}"
    )


def _coarsen(meshes: pymeshlab.MeshSet) -> None:
    """By MeshLab's own filter, so that two of our plugins get the same mesh."""
    meshes.apply_filter("meshing_decimation_clustering")


_PREPARATIONS = {
    "plain": lambda meshes: None,
    "half selected": _select_half,
    "painted": _paint,
    "coarse": _coarsen,
}
STATES = tuple(_PREPARATIONS)


if __name__ == "__main__":
    print(json.dumps(run(json.load(sys.stdin))))
