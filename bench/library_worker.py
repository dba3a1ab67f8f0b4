# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs one simplifier of a Python library in a process of its own, in the peers' environment.

Reads a job as JSON from standard input:

    {"mesh": path, "policy": name, "target": faces, "cell": number or null, "output": path or null}

and writes {"seconds": ..., "peak_bytes": ...} as the last line of standard output. The clock covers
the library's call alone: its own mesh is built before, its result is read after. A clustering has
no target but a cell, a fraction of the bounding box's diagonal. With "output" null it only looks
for the cell, and writes {"cell": ...}. With the argument --versions it says which libraries are
there: {library: {"version": text or null, "reason": text or null}}.
"""

from __future__ import annotations

import importlib
import json
import sys
from collections.abc import Callable
from dataclasses import dataclass
from importlib import metadata

import memory
import numpy as np
from binary_mesh import read_binary, write_binary
from cell_search import nearest_cell
from numpy.typing import NDArray

Arrays = tuple[NDArray, NDArray]
"""Vertices (n, 3) and faces (m, 3)."""

LIBRARIES = {
    "Blender": "bpy",
    "fast-simplification": "fast_simplification",
    "libigl": "igl",
    "MeshLib": "meshlib.mrmeshpy",
    "Open3D": "open3d",
    "VTK": "vtk",
}


PACKAGES = {"Blender": "bpy"}
"""The names of those that another name is installed by."""


@dataclass(frozen=True)
class Call:
    """A prepared call, and how its result becomes arrays."""

    run: Callable[[], object]
    read: Callable[[object], Arrays]


@dataclass(frozen=True)
class Task:
    """What to simplify: the mesh, and the face count or the length of a cell to get there."""

    vertices: NDArray
    faces: NDArray
    target: int
    cell: float  # a length; 0 where there is a target

    @property
    def reduction(self) -> float:
        """The fraction of faces to take away."""
        return 1 - self.target / len(self.faces)


def fast_simplification(task: Task) -> Call:
    """Its defaults, with a count instead of a fraction."""
    import fast_simplification as library

    def run() -> Arrays:
        return library.simplify(task.vertices, task.faces, target_count=task.target)[:2]

    return Call(run, lambda result: result)


def libigl(function: str) -> Callable[[Task], Call]:
    """libigl's qslim (quadrics) or decimate (edge length, midpoint)."""

    def prepare(task: Task) -> Call:
        import igl

        vertices, faces = np.asfortranarray(task.vertices), np.asfortranarray(task.faces)
        simplify = getattr(igl, function)
        return Call(lambda: simplify(vertices, faces, task.target), lambda result: result[:2])

    return prepare


def meshlib(parts: int, accurate: bool) -> Callable[[Task], Call]:
    """parts: decimated at a time. accurate: without its bound on shapes, hardly stabilized."""

    def prepare(task: Task) -> Call:
        from meshlib import mrmeshnumpy, mrmeshpy

        mesh = mrmeshnumpy.meshFromFacesVerts(task.faces.astype(np.int32), task.vertices)
        settings = mrmeshpy.DecimateSettings()
        settings.strategy = mrmeshpy.DecimateStrategy.MinimizeError
        settings.maxDeletedFaces = len(task.faces) - task.target
        settings.subdivideParts = parts
        settings.packMesh = True
        if accurate:
            settings.stabilizer = 1e-6
            settings.maxTriangleAspectRatio = float(np.finfo(np.float32).max)

        def read(_: object) -> Arrays:
            faces = mrmeshnumpy.getNumpyFaces(mesh.topology)
            return mrmeshnumpy.getNumpyVerts(mesh), faces

        return Call(lambda: mrmeshpy.decimateMesh(mesh, settings), read)

    return prepare


def blender(task: Task) -> Call:
    """The modifier that collapses edges; it takes a ratio."""
    import bpy

    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata(task.vertices.tolist(), [], task.faces.tolist())
    thing = bpy.data.objects.new("thing", mesh)
    bpy.context.scene.collection.objects.link(thing)
    modifier = thing.modifiers.new("decimate", "DECIMATE")
    modifier.ratio = task.target / len(task.faces)

    def run() -> object:
        return thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()

    return Call(run, _blender_arrays)


def _blender_arrays(mesh: object) -> Arrays:
    mesh.calc_loop_triangles()
    points = np.empty(3 * len(mesh.vertices))
    corners = np.empty(3 * len(mesh.loop_triangles), dtype=np.int64)
    mesh.vertices.foreach_get("co", points)
    mesh.loop_triangles.foreach_get("vertices", corners)
    return points.reshape(-1, 3), corners.reshape(-1, 3)


def open3d_quadric(task: Task) -> Call:
    """Open3D's Garland-Heckbert; its costs depend on the unit of length."""
    mesh = _open3d_mesh(task)
    return Call(lambda: mesh.simplify_quadric_decimation(task.target), _open3d_arrays)


def open3d_clustering(contraction: str) -> Callable[[Task], Call]:
    """contraction: 'Average' or 'Quadric'."""

    def prepare(task: Task) -> Call:
        import open3d

        kind = getattr(open3d.geometry.SimplificationContraction, contraction)
        mesh = _open3d_mesh(task)
        return Call(lambda: mesh.simplify_vertex_clustering(task.cell, kind), _open3d_arrays)

    return prepare


def _open3d_mesh(task: Task) -> object:
    import open3d

    points = open3d.utility.Vector3dVector(task.vertices)
    return open3d.geometry.TriangleMesh(points, open3d.utility.Vector3iVector(task.faces))


def _open3d_arrays(mesh: object) -> Arrays:
    return np.asarray(mesh.vertices), np.asarray(mesh.triangles)


def vtk_quadric(volume: bool) -> Callable[[Task], Call]:
    """volume: keeps the volume, a constraint on the new point."""

    def prepare(task: Task) -> Call:
        import vtk

        filter_ = vtk.vtkQuadricDecimation()
        filter_.SetTargetReduction(task.reduction)
        filter_.SetVolumePreservation(volume)
        return _vtk_call(filter_, task)

    return prepare


def vtk_decimate_pro(topology: bool) -> Callable[[Task], Call]:
    """topology: it may not split the mesh, and may then stop above the target."""

    def prepare(task: Task) -> Call:
        import vtk

        filter_ = vtk.vtkDecimatePro()
        filter_.SetTargetReduction(task.reduction)
        filter_.SetPreserveTopology(topology)
        return _vtk_call(filter_, task)

    return prepare


def vtk_clustering(task: Task) -> Call:
    """Cubic cells from the least corner of the bounding box."""
    import vtk

    filter_ = vtk.vtkQuadricClustering()
    filter_.AutoAdjustNumberOfDivisionsOff()
    filter_.SetDivisionOrigin(*task.vertices.min(axis=0))
    filter_.SetDivisionSpacing(*[task.cell] * 3)
    return _vtk_call(filter_, task)


def _vtk_call(filter_: object, task: Task) -> Call:
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

    points, cells, mesh = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
    points.SetData(numpy_to_vtk(task.vertices, deep=True))
    corners = numpy_to_vtkIdTypeArray(task.faces.astype(np.int64).ravel(), deep=True)
    cells.SetData(3, corners)
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    filter_.SetInputData(mesh)

    def read(_: object) -> Arrays:
        result = filter_.GetOutput()
        faces = vtk_to_numpy(result.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        return vtk_to_numpy(result.GetPoints().GetData()), faces

    return Call(filter_.Update, read)


POLICIES: dict[str, Callable[[Task], Call]] = {
    "blender": blender,
    "fast-simplification": fast_simplification,
    "igl.qslim": libigl("qslim"),
    "igl.decimate": libigl("decimate"),
    "meshlib": meshlib(parts=1, accurate=False),
    "meshlib.16": meshlib(parts=16, accurate=False),
    "meshlib.accurate": meshlib(parts=1, accurate=True),
    "meshlib.accurate-16": meshlib(parts=16, accurate=True),
    "open3d.quadric": open3d_quadric,
    "open3d.clustering-average": open3d_clustering("Average"),
    "open3d.clustering-quadric": open3d_clustering("Quadric"),
    "vtk.quadric": vtk_quadric(volume=False),
    "vtk.quadric-volume": vtk_quadric(volume=True),
    "vtk.decimate-pro": vtk_decimate_pro(topology=False),
    "vtk.decimate-pro-topology": vtk_decimate_pro(topology=True),
    "vtk.clustering": vtk_clustering,
}


def run(job: dict) -> dict:
    """Simplifies and saves, or looks for the cell; returns what is written."""
    vertices, faces = read_binary(job["mesh"])
    prepare = POLICIES[job["policy"]]
    diagonal = float(np.linalg.norm(np.ptp(vertices, axis=0)))

    def call_with(cell: float | None) -> Call:
        return prepare(Task(vertices, faces, job["target"], diagonal * (cell or 0)))

    def count_faces(cell: float) -> int:
        call = call_with(cell)
        return len(call.read(call.run())[1])

    if job["output"] is None:
        return {"cell": nearest_cell(count_faces, job["target"])}
    call = call_with(job["cell"])
    result, seconds, peak_bytes = memory.measure(call.run)
    write_binary(job["output"], *call.read(result))
    return {"seconds": seconds, "peak_bytes": peak_bytes}


def versions() -> dict[str, dict[str, str | None]]:
    """Of every library: its version, or none and why it cannot be used."""
    found = {}
    for name, module in LIBRARIES.items():
        try:
            importlib.import_module(module)
            package = PACKAGES.get(name, name.lower())
            found[name] = {"version": metadata.version(package), "reason": None}
        except Exception as error:  # a broken library may raise anything; the others go on
            found[name] = {"version": None, "reason": f"{type(error).__name__}: {error}"}
    return found


if __name__ == "__main__":
    answer = versions() if sys.argv[1:] == ["--versions"] else run(json.load(sys.stdin))
    print(json.dumps(answer))
