# SPDX-License-Identifier: GPL-3.0-or-later
"""The core is built in layers: a header includes its own folder and what lies below it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

CORE = Path(__file__).resolve().parents[1] / "vcg_ext"
PUBLIC_DATA = (
    "params.h",
    "error_params.h",
    "report.h",
    "error_report.h",
    "errors.h",
    "field.h",
    "vertex_map.h",
)
LAYERS = (
    "public headers",
    "decimate_by_collapse.h",
    "host_mesh",
    "run",
    "refine measure",
    "passes",
    "attributes",
    "collapse removal clustering",
    "metric",
    "guard",
    "curvature",
    "queue",
    "mesh",
    "geometry",
    "parallel",
    "public data",
)
"""From the top to the bottom. Folders in one layer know nothing of each other."""


def folder_of(header: str) -> str:
    """The folder of a header of the core, or what a header beside the folders is."""
    folder, _, name = header.rpartition("/")
    if folder:
        return folder
    if name in PUBLIC_DATA:
        return "public data"
    return name if name in LAYERS else "public headers"


def layer_of(folder: str) -> int:
    """0 at the top."""
    for depth, layer in enumerate(LAYERS):
        if folder == layer or folder in layer.split():
            return depth
    raise LookupError(f"vcg_ext/{folder} is in no layer")


def includes_up(header: str, text: str) -> list[str]:
    """What a header includes that is neither in its own folder nor below it."""
    here = folder_of(header)
    included = re.findall(r'#include "vcg_ext/([^"]+)"', text)
    return [
        f"vcg_ext/{header} includes vcg_ext/{other}"
        for other in included
        if folder_of(other) != here and layer_of(folder_of(other)) <= layer_of(here)
    ]


def test_no_header_includes_upwards() -> None:
    headers = [path.relative_to(CORE).as_posix() for path in sorted(CORE.rglob("*.h"))]
    wrong = [line for name in headers for line in includes_up(name, (CORE / name).read_text())]
    assert wrong == []
    assert len(headers) > len(LAYERS)


@pytest.mark.parametrize(
    ("header", "other"),
    [
        ("mesh/working_mesh.h", "metric/metric.h"),
        ("collapse/collapse_plan.h", "removal/removal_plan.h"),
        ("params.h", "geometry/vector3.h"),
        ("run/run.h", "edge_collapse.h"),
    ],
)
def test_an_include_upwards_or_aside_is_found(header: str, other: str) -> None:
    assert includes_up(header, f'#include "vcg_ext/{other}"\n') != []


def test_an_include_downwards_or_at_home_is_fine() -> None:
    text = '#include "vcg_ext/guard/limits.h"\n#include "vcg_ext/params.h"\n'
    assert includes_up("guard/face_guard.h", text) == []
