# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws simplified meshes side by side, coloured by error on one scale, with histograms."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import matplotlib
import matplotlib.image
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from palette import BACKGROUND, FAINT, INK
from panels import Panel, View
from picture import COLOR_MAP, draw
from surface import Floats, Ints

_INCHES_A_COLUMN, _INCHES_A_ROW, _DPI = 5.2, 5.6, 110
_HISTOGRAM_SHARE = 0.3  # of a row's height
_TOP_QUANTILE = 0.99  # of the worse result's errors: the end of a row's scale
_BINS = 48


@dataclass(frozen=True)
class Shown:
    """A result: (n, 3) vertices, (m, 3) faces, and errors in % of the diagonal.

    of_simplified: (n,), colours it. of_original: of the original's vertices, for the histogram.
    """

    vertices: Floats
    faces: Ints
    of_simplified: Floats
    of_original: Floats
    title: str
    caption: str


def draw_errors(path: Path, rows: Sequence[tuple[View, Sequence[Shown]]]) -> None:
    """A row a model, which has one camera and one scale."""
    columns = max(len(shown) for _, shown in rows)
    path.parent.mkdir(parents=True, exist_ok=True)
    with matplotlib.rc_context({"font.family": "DejaVu Sans", "text.color": INK}):
        figure = Figure(
            figsize=(_INCHES_A_COLUMN * columns, _INCHES_A_ROW * len(rows)),
            dpi=_DPI,
            facecolor=BACKGROUND,
            layout="constrained",
        )
        FigureCanvasAgg(figure)
        for part, (view, shown) in zip(_parts(figure, len(rows)), rows, strict=True):
            _draw_row(part, view, shown)
        figure.savefig(path)


def _parts(figure: Figure, count: int) -> list:
    return list(np.atleast_1d(figure.subfigures(count, 1)))


def _draw_row(figure, view: View, shown: Sequence[Shown]) -> None:
    figure.set_facecolor(BACKGROUND)
    top = max(float(np.quantile(each.of_original, _TOP_QUANTILE)) for each in shown)
    heights = (1 - _HISTOGRAM_SHARE, _HISTOGRAM_SHARE)
    axes = figure.subplots(2, len(shown), squeeze=False, height_ratios=heights, sharey="row")
    for column, picture in zip(axes[0], _pictures(view, shown, top), strict=True):
        column.imshow(picture)
        column.set_axis_off()
    for column, each in zip(axes[1], shown, strict=True):
        _draw_histogram(column, each.of_original, top)
    scale = ScalarMappable(Normalize(0, top), COLOR_MAP)
    bar = figure.colorbar(scale, ax=axes[0].tolist(), shrink=0.7, extend="max")
    bar.set_label("error of a vertex, % of the diagonal", color=INK)


def _pictures(view: View, shown: Sequence[Shown], top: float) -> list[Floats]:
    panels = [
        Panel(each.vertices, each.faces, each.title, each.caption, each.of_simplified / top)
        for each in shown
    ]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "row.png"
        draw(path, [(view, panels)])
        return np.array_split(matplotlib.image.imread(path), len(panels), axis=1)


def _draw_histogram(axes: Axes, errors: Floats, top: float) -> None:
    """The last bin has all above."""
    counts, edges = np.histogram(np.minimum(errors, top), _BINS, (0, top))
    colors = matplotlib.colormaps[COLOR_MAP]((edges[:-1] + edges[1:]) / (2 * top))
    axes.bar(edges[:-1], 100 * counts / len(errors), top / _BINS, align="edge", color=colors)
    axes.set_facecolor(BACKGROUND)
    axes.set_xlim(0, top)
    axes.set_xlabel("distance of the original's vertices, % of the diagonal")
    axes.set_ylabel("% of them")
    axes.tick_params(colors=INK)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for side in ("bottom", "left"):
        axes.spines[side].set_color(FAINT)
