# SPDX-License-Identifier: GPL-3.0-or-later
"""Applies one filter in a process of its own; `decimators` starts it.

PyMeshLab takes the last call's parameters as the next call's defaults, so only a fresh process
measures what its parameters say. Reads a job as JSON from standard input:

    {"mesh": path, "plugin": path or null, "filter": name, "parameters": {...}, "output": path}

and writes {"seconds": ..., "peak_bytes": ..., "report": {...}} as the last line of standard output.
Time and memory are those of the filter alone, without reading and writing files; peak_bytes is null
where it cannot be known. A parameter {"percentage": p} is p per cent of the mesh's diagonal. A
job with "cell_for": faces is not applied: the worker looks for the percentage of "cell_parameter"
that leaves so many faces, and writes it as {"cell": ...}, a fraction.
"""

from __future__ import annotations

import json
import sys
from typing import Any

import memory
import pymeshlab
from cell_search import nearest_cell


def run(job: dict) -> dict:
    """Loads, applies, saves; returns the seconds, the memory and what the filter returned."""
    if job["plugin"]:
        pymeshlab.load_plugin(job["plugin"])
    if "cell_for" in job:
        return {"cell": nearest_cell(lambda cell: _faces_left(job, cell), job["cell_for"])}
    meshes = _load(job)
    parameters = values(job["parameters"])
    report, seconds, peak_bytes = memory.measure(
        lambda: meshes.apply_filter(job["filter"], **parameters)
    )
    meshes.save_current_mesh(job["output"], save_textures=False)  # PyMeshLab cannot save all
    return {"seconds": seconds, "peak_bytes": peak_bytes, "report": report or {}}


def _load(job: dict) -> pymeshlab.MeshSet:
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(job["mesh"])
    return meshes


def values(parameters: dict) -> dict[str, Any]:
    """The parameters of a job as PyMeshLab wants them."""
    return {
        name: pymeshlab.PercentageValue(value["percentage"]) if isinstance(value, dict) else value
        for name, value in parameters.items()
    }


def _faces_left(job: dict, cell: float) -> int:
    meshes = _load(job)
    cell_of = {job["cell_parameter"]: {"percentage": 100 * cell}}
    meshes.apply_filter(job["filter"], **values(job["parameters"] | cell_of))
    return meshes.current_mesh().face_number()


if __name__ == "__main__":
    print(json.dumps(run(json.load(sys.stdin)), default=str))
