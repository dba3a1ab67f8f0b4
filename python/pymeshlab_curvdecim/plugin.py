# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the plugin is, and how it gets into the installed PyMeshLab.

The rest of the package takes PyMeshLab from here, so that one that does not fit is one clear error
before any name in it is looked for.
"""

import contextlib
import ctypes
import importlib
import io
import os
from importlib import metadata
from pathlib import Path

PLUGIN_VARIABLE = "CURVDECIM_PLUGIN"
PLUGIN_NAME = "libfilter_curvdecim.so"
PARAMETERS_NAME = "parameters.json"
PYMESHLAB_VERSION = "2025.7"  # the one that the plugin is for, as in pyproject.toml
GRAPHICS_LIBRARIES = ("libGL.", "libOpenGL.")  # PyMeshLab has all the others it needs with it
GRAPHICS_REMEDY = "sudo apt install libgl1 libopengl0"
NEEDS_OPENGL = "meshing_decimation_quadric_edge_collapse"  # a filter in such a plugin of PyMeshLab


class PluginError(ImportError):
    """The plugin is missing, or the installed PyMeshLab cannot load it."""


def import_pymeshlab():
    """PyMeshLab, if it is the version that the plugin was made for and has what it needs."""
    check_pymeshlab()
    said = io.StringIO()
    try:
        with contextlib.redirect_stdout(said):
            module = importlib.import_module("pymeshlab")
            _check_own_plugins(module)
    except (ImportError, OSError) as error:
        if any(library in str(error) for library in GRAPHICS_LIBRARIES):
            raise PluginError(
                f"PyMeshLab lacks a library of the system ({error}): {GRAPHICS_REMEDY}"
            ) from error
        raise
    print(said.getvalue(), end="")
    return module


def _check_own_plugins(module):
    """An OSError where OpenGL is missing.

    PyMeshLab then goes on without those of its own plugins that need it, one of which reads PLY.
    """
    if not hasattr(module.MeshSet, NEEDS_OPENGL):
        ctypes.CDLL("libOpenGL.so.0")


def check_pymeshlab():
    """An error where the installed PyMeshLab is another one than the plugin was made for."""
    installed = _installed_version()
    if installed.split(".")[:2] != PYMESHLAB_VERSION.split("."):
        raise PluginError(
            f"CurvDecim needs PyMeshLab {PYMESHLAB_VERSION}, and {installed} is installed: "
            f"pip install 'pymeshlab=={PYMESHLAB_VERSION}.*'"
        )


def _installed_version():
    try:
        return metadata.version("pymeshlab")
    except metadata.PackageNotFoundError:
        return "none"


pymeshlab = import_pymeshlab()


def plugin_file():
    """The plugin named by CURVDECIM_PLUGIN, else the one installed with this package."""
    named = os.environ.get(PLUGIN_VARIABLE)
    file = Path(named) if named else Path(__file__).with_name(PLUGIN_NAME)
    if file.is_file():
        return file.resolve()
    source = f"{PLUGIN_VARIABLE} names" if named else "the package should contain"
    raise PluginError(
        f"No CurvDecim plugin: {source} {file}, which does not exist. Run 'pip install .' in the "
        f"CurvDecim repository, or set {PLUGIN_VARIABLE} to the path of a {PLUGIN_NAME}."
    )


def parameters_file():
    """The description of the parameters, which lies beside the plugin it belongs to."""
    file = plugin_file().with_name(PARAMETERS_NAME)
    if not file.is_file():
        raise PluginError(f"{file} is missing: build the plugin again, both are made together.")
    return file


def load_plugin():
    """Loads the plugin into PyMeshLab, which refuses one built for another MeshLab."""
    file = plugin_file()
    try:
        pymeshlab.load_plugin(str(file))
    except pymeshlab.PyMeshLabException as error:
        raise PluginError(
            f"PyMeshLab {metadata.version('pymeshlab')} cannot load {file}: {str(error).strip()} "
            "A plugin fits one version of PyMeshLab: run 'pip install .' in the CurvDecim "
            "repository again."
        ) from error
