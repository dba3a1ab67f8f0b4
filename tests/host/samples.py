# SPDX-License-Identifier: GPL-3.0-or-later
"""The meshes that PyMeshLab ships, and more where a directory of them is at hand."""

import os
from functools import cache
from pathlib import Path

import pymeshlab
import pytest
from measures import surface

ROOT = Path(__file__).resolve().parents[2]
SHIPPED = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes"
MORE = Path(os.environ.get("CURVDECIM_MESHES", ROOT.parent / "shared" / "meshes"))

DECIMATE = "meshing_decimation_curvature_edge_collapse"
CLUSTER = "meshing_decimation_vertex_clustering"
REMOVE = "meshing_decimation_vertex_removal"
SPHERES = "meshing_decimation_algebraic_sphere"
STEPWISE = (DECIMATE, SPHERES, REMOVE)
IMPORTANCE = "compute_scalar_by_curvature_importance"
ERROR = "get_simplification_error"


def load(name):
    """A MeshSet of one sample; skips the test when the mesh is not at hand.

    Keep it as long as its mesh: PyMeshLab's current_mesh() is part of it.
    """
    file = next((each / name for each in (SHIPPED, MORE) if (each / name).is_file()), None)
    if file is None:
        pytest.skip(f"{name} is neither in {SHIPPED} nor in {MORE}")
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(str(file))
    return meshes


@cache
def original(name):
    return surface(load(name))


@cache
def decimated(name, fraction, **options):
    """The surface and the report of a decimation of a sample, the default one without options."""
    meshes = load(name)
    report = getattr(meshes, DECIMATE)(targetperc=fraction, **options)
    return surface(meshes), report
