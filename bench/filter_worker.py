# SPDX-License-Identifier: GPL-3.0-or-later
"""Applies one filter in a process of its own; `decimators` starts it.

PyMeshLab takes the last call's parameters as the next call's defaults, so only a fresh process
measures what its parameters say. Reads a job as JSON from standard input:

    {"mesh": path, "plugin": path or null, "filter": name, "parameters": {...}, "output": path}

and writes {"seconds": ..., "report": {...}} as the last line of standard output. The time is that
of the filter alone, without reading and writing files.
"""

from __future__ import annotations

import json
import sys
import time

import pymeshlab


def run(job: dict) -> dict:
    """Loads, applies, saves; returns the seconds of the filter and what it returned."""
    if job["plugin"]:
        pymeshlab.load_plugin(job["plugin"])
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(job["mesh"])
    begin = time.perf_counter()
    report = meshes.apply_filter(job["filter"], **job["parameters"])
    seconds = time.perf_counter() - begin
    meshes.save_current_mesh(job["output"])
    return {"seconds": seconds, "report": report or {}}


if __name__ == "__main__":
    print(json.dumps(run(json.load(sys.stdin)), default=str))
