# SPDX-License-Identifier: GPL-3.0-or-later
"""CurvDecim's filters for PyMeshLab.

Importing this package loads the plugin into PyMeshLab. Each filter is then a method of
``pymeshlab.MeshSet`` and a function here that takes the mesh set first:

    import pymeshlab, pymeshlab_curvdecim

    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh("bunny.ply")
    meshes.meshing_decimation_curvature_edge_collapse(targetperc=0.2)
"""

from .filter_functions import load
from .filter_script import filter_script
from .plugin import PluginError

__all__ = ["PluginError", "filter_script", "load"]

globals().update(load())
