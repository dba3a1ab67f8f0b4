# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws meshes side by side into one PNG, off screen, without a display."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pyvista
from matplotlib.colors import LinearSegmentedColormap
from palette import BACKGROUND, COLUMNS, DENSE, EDGES, FAINT_INK, INK
from panels import CELL_PIXELS, Paint, Panel, View, fit
from surface import Floats
from vtkmodules.vtkCommonCore import vtkLogger

# That of the filter get_simplification_error, which is MeshLab's: red for none, blue for much.
COLOR_MAP = LinearSegmentedColormap.from_list("error", ("red", "yellow", "lime", "cyan", "blue"))
_MATTE = {"smooth_shading": False, "ambient": 0.12, "specular": 0.1}
_PAINTED_EDGES = {"color": EDGES, "opacity": 0.35, "line_width": 1.0}
_CROWDED = 6_000  # faces from which edges would hide the paint


def draw(path: Path, rows: Sequence[tuple[View, Sequence[Panel]]]) -> None:
    """Every row with one camera, fitted to its first panel."""
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)  # a missing display is expected
    columns = max(len(panels) for _, panels in rows)
    plotter = pyvista.Plotter(
        off_screen=True,
        shape=(len(rows), columns),
        border=False,
        window_size=[CELL_PIXELS[0] * columns, CELL_PIXELS[1] * len(rows)],
        lighting="light kit",
    )
    plotter.set_background(BACKGROUND)
    for row, (view, panels) in enumerate(rows):
        for column, panel in enumerate(panels):
            plotter.subplot(row, column)
            _add(plotter, panel, COLUMNS[column % len(COLUMNS)])
            _aim(plotter, view, panels[0].vertices)
    plotter.enable_anti_aliasing("ssaa")
    image = plotter.screenshot(str(path), return_img=True)
    plotter.close()
    if np.ptp(image) == 0:
        raise RuntimeError(f"{path}: the picture is blank; software OpenGL (libegl1) is needed")


def _add(plotter: pyvista.Plotter, panel: Panel, color: str) -> None:
    mesh = pyvista.PolyData.from_regular_faces(panel.vertices, panel.faces)
    if panel.paint:
        _add_paint(plotter, panel.paint)
        if len(panel.faces) < _CROWDED:
            plotter.add_mesh(mesh, style="wireframe", **_PAINTED_EDGES)
    else:
        plotter.add_mesh(mesh, **_MATTE, **_edges(color, len(panel.faces) > DENSE))
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
        "edge_color": EDGES,
        "edge_opacity": 0.25 if dense else 0.85,
        "line_width": 0.5 if dense else 1.5,
    }


def _add_paint(plotter: pyvista.Plotter, paint: Paint) -> None:
    mesh = pyvista.PolyData.from_regular_faces(paint.vertices, paint.faces)
    scale = {"cmap": COLOR_MAP, "clim": (0.0, 1.0), "show_scalar_bar": False}
    plotter.add_mesh(mesh, scalars=paint.values, **_MATTE, **scale)


def _aim(plotter: pyvista.Plotter, view: View, vertices: Floats) -> None:
    """Fits the vertices (n, 3) into the cell between its margins."""
    fitted = fit(view, vertices)
    towards = fitted.frame[2]
    plotter.camera.focal_point = fitted.centre
    plotter.camera.position = fitted.centre + (fitted.depth + fitted.shown_height) * towards
    plotter.camera.up = view.up
    plotter.camera.parallel_projection = True
    plotter.camera.parallel_scale = fitted.shown_height / 2
    plotter.reset_camera_clipping_range()
