# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws meshes side by side into one PNG, off screen, without a display."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pyvista
from palette import BACKGROUND, FAINT_INK, INK
from surface import Floats, Ints
from vtkmodules.vtkCommonCore import vtkLogger

_CELL_PIXELS = (900, 720)
_SIDE_MARGIN, _FOOT_MARGIN, _HEAD_MARGIN = 0.06, 0.05, 0.17  # of the cell; the head has the text
_EDGES = "#2b2420"
_COLORS = ("#d8cfc0", "#e0a458", "#8fb3c9")  # by column
COLOR_MAP = "turbo"
_DENSE = 20_000  # faces from which edges are drawn thinner, so that the shape stays visible


@dataclass(frozen=True)
class Panel:
    """One mesh: (n, 3) vertices, (m, 3) faces, a title and a line below it."""

    vertices: Floats
    faces: Ints
    title: str
    caption: str
    values: Floats | None = None  # (n,), 0 to 1: colours the vertices, instead of drawing edges


@dataclass(frozen=True)
class View:
    """Where to look from, and which way is up, in the mesh's own axes."""

    direction: tuple[float, float, float]
    up: tuple[float, float, float] = (0.0, 1.0, 0.0)


def draw(path: Path, rows: Sequence[tuple[View, Sequence[Panel]]]) -> None:
    """Every row with one camera, fitted to its first panel."""
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)  # a missing display is expected
    columns = max(len(panels) for _, panels in rows)
    plotter = pyvista.Plotter(
        off_screen=True,
        shape=(len(rows), columns),
        border=False,
        window_size=[_CELL_PIXELS[0] * columns, _CELL_PIXELS[1] * len(rows)],
        lighting="light kit",
    )
    plotter.set_background(BACKGROUND)
    for row, (view, panels) in enumerate(rows):
        for column, panel in enumerate(panels):
            plotter.subplot(row, column)
            _add(plotter, panel, _COLORS[column % len(_COLORS)])
            _aim(plotter, view, panels[0].vertices)
    plotter.enable_anti_aliasing("ssaa")
    image = plotter.screenshot(str(path), return_img=True)
    plotter.close()
    if np.ptp(image) == 0:
        raise RuntimeError(f"{path}: the picture is blank; software OpenGL (libegl1) is needed")


def _add(plotter: pyvista.Plotter, panel: Panel, color: str) -> None:
    mesh = pyvista.PolyData.from_regular_faces(panel.vertices, panel.faces)
    look = _edges(color, len(panel.faces) > _DENSE) if panel.values is None else _map(panel.values)
    plotter.add_mesh(mesh, smooth_shading=False, ambient=0.12, specular=0.1, **look)
    for line, top, size, ink in (
        (panel.title, 0.925, 16, INK),
        (panel.caption, 0.875, 12, FAINT_INK),
    ):
        plotter.add_text(
            line, position=(0.04, top), font_size=size, color=ink, font="arial", viewport=True
        )


def _edges(color: str, dense: bool) -> dict[str, Any]:
    return {
        "color": color,
        "show_edges": True,
        "edge_color": _EDGES,
        "edge_opacity": 0.25 if dense else 0.85,
        "line_width": 0.5 if dense else 1.5,
    }


def _map(values: Floats) -> dict[str, Any]:
    return {"scalars": values, "cmap": COLOR_MAP, "clim": (0.0, 1.0), "show_scalar_bar": False}


def _aim(plotter: pyvista.Plotter, view: View, vertices: Floats) -> None:
    """Fits the vertices (n, 3) into the cell between its margins."""
    towards = _unit(np.asarray(view.direction, dtype=float))
    right = _unit(np.cross(view.up, towards))
    frame = np.stack([right, np.cross(towards, right), towards])
    low, high = (vertices @ frame.T).min(axis=0), (vertices @ frame.T).max(axis=0)
    free_width, free_height = 1 - 2 * _SIDE_MARGIN, 1 - _FOOT_MARGIN - _HEAD_MARGIN
    aspect = _CELL_PIXELS[0] / _CELL_PIXELS[1]
    width, height, depth = high - low
    shown_height = max(height / free_height, width / free_width / aspect)
    raised = (_HEAD_MARGIN - _FOOT_MARGIN) / 2 * shown_height
    centre = ((low + high) / 2 + (0, raised, 0)) @ frame
    plotter.camera.focal_point = centre
    plotter.camera.position = centre + (depth + shown_height) * towards
    plotter.camera.up = view.up
    plotter.camera.parallel_projection = True
    plotter.camera.parallel_scale = shown_height / 2
    plotter.reset_camera_clipping_range()


def _unit(vector: Floats) -> Floats:
    return vector / np.linalg.norm(vector)
