# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of the summary: time against error of every policy, as ratios to MeshLab's."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import matplotlib
from matplotlib.axes import Axes
from matplotlib.backend_bases import RendererBase
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter
from palette import BACKGROUND, FAINT, INK

from peers.labels import Box, place
from peers.policies import BASELINE, CORE, OURS
from peers.records import Record
from peers.summary import means

_INCHES, _DPI = (10.5, 7.5), 160
_OURS_COLOR = "#d2600a"
_COLORS = {
    "MeshLab": INK,
    "CGAL": "#1f5a8c",
    "OpenMesh": "#7a4d9e",
    "meshoptimizer": "#1d7f5f",
    "VTK": "#9c2f4c",
    "libigl": "#6a6d12",
    "fast-simplification": "#0f7f8c",
    "MeshLib": "#b0479a",
    "Open3D": "#5f5f5f",
    "Blender": "#b8860b",
}
_LABEL_POINTS, _OURS_POINTS = 7.5, 9.0
_MARKER, _OUR_MARKER = 34.0, 95.0  # points squared
_ROOM = 1.35  # times the data's range that the axes show beyond it, for the labels
_CLEARANCE = 2.0  # pixels around a label
_HALO = 2.5  # points of background around the letters, where a line runs below


@dataclass(frozen=True)
class Point:
    """A policy: its geometric means over all cases, as ratios to MeshLab's."""

    policy: str
    peer: str
    time: float
    rms: float


def points(records: Sequence[Record]) -> list[Point]:
    """Of every policy with a time and an error; ours last, so that it is drawn on top.

    The core without a host has the errors of ours and is left out.
    """
    peer_of = {record.policy: record.peer for record in records}
    found = [
        Point(each.policy, peer_of[each.policy], time, rms)
        for each in means(records)
        if peer_of[each.policy] != CORE
        and (time := each.means["time"]) is not None
        and (rms := each.means["rms"]) is not None
    ]
    return sorted(found, key=lambda point: point.peer == OURS)


def draw_summary(records: Sequence[Record], path: Path) -> None:
    """Writes the PNG; does nothing when there is nothing to compare with MeshLab."""
    shown = points(records)
    if not shown:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    with matplotlib.rc_context({"font.family": "DejaVu Sans", "text.color": INK}):
        figure = Figure(figsize=_INCHES, dpi=_DPI, facecolor=BACKGROUND, layout="constrained")
        canvas = FigureCanvasAgg(figure)
        axes = figure.add_subplot(facecolor=BACKGROUND)
        _set_axes(axes, shown)
        for point in shown:
            _draw_point(axes, point)
        canvas.draw()  # the labels need the axes' final place
        _draw_labels(axes, shown, canvas.get_renderer())
        figure.savefig(path)


def _set_axes(axes: Axes, shown: Sequence[Point]) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    for set_limits, values in (
        (axes.set_xlim, [point.time for point in shown]),
        (axes.set_ylim, [point.rms for point in shown]),
    ):
        set_limits(min(values) / _ROOM, max(values) * _ROOM)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axis.set_minor_formatter(NullFormatter())
    axes.axhline(1, color=FAINT, linewidth=0.8, linestyle=(0, (4, 4)), zorder=0)
    axes.axvline(1, color=FAINT, linewidth=0.8, linestyle=(0, (4, 4)), zorder=0)
    axes.grid(color=FAINT, alpha=0.25, linewidth=0.6)
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_xlabel(f"time of the call, {BASELINE} = 1   (faster to the left)")
    axes.set_ylabel(f"two-sided RMS distance, {BASELINE} = 1   (closer to the bottom)")
    axes.set_title(
        "Decimators side by side: geometric means over all meshes and targets", loc="left"
    )


def _draw_point(axes: Axes, point: Point) -> None:
    ours = point.peer == OURS
    axes.scatter(
        [point.time],
        [point.rms],
        s=_OUR_MARKER if ours else _MARKER,
        color=_color(point),
        edgecolor=BACKGROUND,
        linewidth=0.8,
        marker="D" if ours else "o",
        zorder=4 if ours else 3,
    )


def _color(point: Point) -> str:
    return _OURS_COLOR if point.peer == OURS else _COLORS.get(point.peer, INK)


def _draw_labels(axes: Axes, shown: Sequence[Point], renderer: RendererBase) -> None:
    """Ours first: they get the best places."""
    order = sorted(shown, key=lambda point: point.peer != OURS)
    anchors = [tuple(axes.transData.transform((point.time, point.rms))) for point in order]
    sizes = [_size(axes, point, renderer) for point in order]
    bounds = axes.bbox
    frame = Box(bounds.x0, bounds.y0, bounds.x1, bounds.y1)
    to_data = axes.transData.inverted()
    for point, anchor, box in zip(order, anchors, place(anchors, sizes, frame), strict=True):
        x, y = to_data.transform(box.centre)
        label = axes.text(x, y, point.policy, ha="center", va="center", zorder=5, **_font(point))
        label.set_path_effects([withStroke(linewidth=_HALO, foreground=BACKGROUND)])
        label.set_in_layout(False)
        start = to_data.transform(box.nearest(anchor))
        axes.plot(
            [start[0], point.time],
            [start[1], point.rms],
            color=_color(point),
            linewidth=0.6,
            alpha=0.55,
            zorder=2,
        )


def _font(point: Point) -> dict[str, object]:
    if point.peer == OURS:
        return {"fontsize": _OURS_POINTS, "fontweight": "bold", "color": _OURS_COLOR}
    return {"fontsize": _LABEL_POINTS, "color": _color(point)}


def _size(axes: Axes, point: Point, renderer: RendererBase) -> tuple[float, float]:
    """Width and height of the label in pixels."""
    probe = axes.text(0.5, 0.5, point.policy, transform=axes.transAxes, **_font(point))
    extent = probe.get_window_extent(renderer)
    probe.remove()
    return extent.width + 2 * _CLEARANCE, extent.height + 2 * _CLEARANCE
