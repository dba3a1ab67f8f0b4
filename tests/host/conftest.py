# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds what was built, and loads the plugin into PyMeshLab once for all tests.

CURVDECIM_BUILD      build directory, default build/ of the repository
CURVDECIM_PLUGIN     the plugin for PyMeshLab, default the one in the build directory
CURVDECIM_MESHES     directory of more meshes, default ../shared/meshes
CURVDECIM_ARTIFACTS  where pictures are kept, default build/artifacts
"""

import os
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("CURVDECIM_BUILD", ROOT / "build"))
PLUGINS = BUILD / "plugins"

os.environ.setdefault(
    "CURVDECIM_PLUGIN", str(PLUGINS / "pymeshlab-2025.07" / "libfilter_curvdecim.so")
)
sys.path.insert(0, str(ROOT / "python"))

import meshlab_2020  # noqa: E402
import pymeshlab_curvdecim  # noqa: E402, F401  (importing it loads the plugin)


@pytest.fixture(scope="session")
def meshlab(tmp_path_factory):
    """The packaged MeshLab 2020.09 with our plugin; skips where another version is packaged."""
    if reason := meshlab_2020.why_absent():
        pytest.skip(reason)
    plugin = PLUGINS / "meshlab-2020.09" / meshlab_2020.PLUGIN_NAME
    assert plugin.is_file(), f"build the host meshlab-2020.09 first: {plugin} is missing"
    return meshlab_2020.Tree(tmp_path_factory.mktemp("meshlab"), plugin)


@pytest.fixture(scope="session")
def artifacts():
    directory = Path(os.environ.get("CURVDECIM_ARTIFACTS", ROOT / "build" / "artifacts"))
    directory.mkdir(parents=True, exist_ok=True)
    return directory
