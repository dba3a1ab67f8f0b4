# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws simplified meshes side by side, coloured by error on one scale, with histograms.

Colours and histograms are the vertex quality that our filter `get_simplification_error` writes.
"""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import matplotlib
import numpy as np
from decimators import Outcome
from layer_error import ErrorMeter, meter_of
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from models import Model
from palette import BACKGROUND, FAINT, FAINT_INK, INK
from panels import CELL_PIXELS, Paint, Panel, View
from picture import COLOR_MAP, draw
from PIL import Image, ImageChops
from surface import Floats, Ints, Surface

_INCHES_A_COLUMN, _DPI = 3.2, 110
_HISTOGRAM_INCHES, _TITLE_INCHES, _FOOT_INCHES = 0.95, 0.62, 0.55
_SIDE_INCHES, _GAP_INCHES = 0.2, 0.4
_MARGIN_PIXELS = 8  # around what a row shows
_TOP_QUANTILE = 0.99  # of the worst result's errors: the end of a row's scale
_BINS, _TICKS = 48, 5
_FINE = 40_000  # faces from which a mesh has points enough to be coloured
_INKS = 256
_DISTANCE = "distance, % of the diagonal"


@dataclass(frozen=True)
class Shown:
    """A mesh in a row, with its errors in % of the diagonal.

    fine: the same surface cut into smaller faces. of_fine: the error at each vertex of it; None for
    the input. of_original: that of the original's vertices, for the histogram; None for the input.
    """

    vertices: Floats
    faces: Ints
    title: str
    caption: str
    fine: tuple[Floats, Ints] | None = None
    of_fine: Floats | None = None
    of_original: Floats | None = None


def as_input(vertices: Floats, faces: Ints, title: str) -> Shown:
    """The mesh that was simplified."""
    return Shown(vertices, faces, title, f"input, {len(faces):,} faces")


def with_errors(meter: ErrorMeter, vertices: Floats, faces: Ints, title: str) -> Shown:
    """A simplification; its colours come from points all over its faces, not from corners alone."""
    error = meter(vertices, faces)
    fine = finely(vertices, faces)
    caption = f"{len(faces):,} faces, RMS {error.rms:#.2g} %, max {error.max:#.2g} %"
    of_fine = meter(*fine).at_simplified
    return Shown(vertices, faces, title, caption, fine, of_fine, error.at_original)


def close_up(plugin: Path, model: Model, region: str, outcome: Outcome, title: str) -> Shown:
    """What a simplification has left in a region of the model, with the errors there."""
    mesh = outcome.vertices, outcome.faces
    there = ErrorMeter(plugin, *model.part(region), model.diagonal)(*mesh)
    part = model.part(region, mesh)
    fine = finely(*part)
    caption = f"{len(part[1]):,} faces here, RMS {there.rms_of_original:#.2g} %"
    of_fine = meter_of(plugin, model)(*fine).at_simplified
    return Shown(*part, title, caption, fine, of_fine, there.at_original)


def finely(vertices: Floats, faces: Ints, least: int = _FINE) -> tuple[Floats, Ints]:
    """The same surface with each face cut into four, until it has at least so many faces."""
    surface = Surface(vertices, faces)
    while len(surface.faces) < least:
        surface = surface.quartered()
    return surface.vertices, surface.faces


def draw_errors(path: Path, rows: Sequence[tuple[View, Sequence[Shown]]]) -> None:
    """A row a model, which has one camera and one scale."""
    pictures = [_pictures(view, shown, scale_end(shown)) for view, shown in rows]
    columns = max(len(shown) for _, shown in rows)
    heights = [_row_inches(each) for each in pictures]
    width = _SIDE_INCHES + columns * _INCHES_A_COLUMN
    with matplotlib.rc_context({"font.family": "DejaVu Sans", "text.color": INK}):
        figure = Figure(figsize=(width, sum(heights)), dpi=_DPI, facecolor=BACKGROUND)
        FigureCanvasAgg(figure)
        parts = np.atleast_1d(figure.subfigures(len(rows), 1, height_ratios=heights))
        for part, (_, shown), drawn in zip(parts, rows, pictures, strict=True):
            _draw_row(part, shown, drawn, columns)
        _save(figure, path)


def scale_end(shown: Sequence[Shown]) -> float:
    """Where the colours of a row end: beyond it is a hundredth of the worst result's errors."""
    of_results = (each.of_original for each in shown if each.of_original is not None)
    return max(float(np.quantile(errors, _TOP_QUANTILE)) for errors in of_results)


def _save(figure: Figure, path: Path) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path)
    with Image.open(path) as image:
        few = image.convert("RGB").quantize(_INKS, Image.Quantize.MAXCOVERAGE, kmeans=2)
    few.save(path, optimize=True)


# --- meshes ---------------------------------------------------------------------------------------


def _pictures(view: View, shown: Sequence[Shown], top: float) -> list[Image.Image]:
    """One a mesh, of one size, without what is empty in all of them."""
    panels = [Panel(each.vertices, each.faces, "", "", _paint(each, top)) for each in shown]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "row.png"
        draw(path, [(view, panels)])
        with Image.open(path) as image:
            row = image.convert("RGB")
    width, height = CELL_PIXELS
    cells = [row.crop((width * n, 0, width * (n + 1), height)) for n in range(len(panels))]
    box = _filled(cells)
    return [cell.crop(box) for cell in cells]


def _paint(shown: Shown, top: float) -> Paint | None:
    return None if shown.of_fine is None else Paint(*shown.fine, shown.of_fine / top)


def _filled(cells: Sequence[Image.Image]) -> tuple[int, int, int, int]:
    """The box that holds all that any cell shows, with a margin."""
    empty = Image.new("RGB", cells[0].size, BACKGROUND)
    boxes = np.array([ImageChops.difference(cell, empty).getbbox() for cell in cells])
    low = np.maximum(boxes[:, :2].min(axis=0) - _MARGIN_PIXELS, 0)
    high = np.minimum(boxes[:, 2:].max(axis=0) + _MARGIN_PIXELS, CELL_PIXELS)
    return (*map(int, low), *map(int, high))


# --- the page -------------------------------------------------------------------------------------


def _picture_inches(pictures: Sequence[Image.Image]) -> float:
    width, height = pictures[0].size
    return (_INCHES_A_COLUMN - _GAP_INCHES) * height / width


def _row_inches(pictures: Sequence[Image.Image]) -> float:
    return _TITLE_INCHES + _picture_inches(pictures) + _HISTOGRAM_INCHES + _FOOT_INCHES


class _Layout:
    """Places in a row, given in inches from its upper left corner."""

    def __init__(self, part, columns: int, pictures: Sequence[Image.Image]) -> None:
        self._part = part
        self._width = _SIDE_INCHES + columns * _INCHES_A_COLUMN
        self._height = _row_inches(pictures)
        self._picture = _picture_inches(pictures)

    def column(self, index: int) -> tuple[Axes, Axes]:
        """For the picture and for what is below it."""
        left = _SIDE_INCHES + index * _INCHES_A_COLUMN
        return (
            self._axes(left, _TITLE_INCHES, self._picture),
            self._axes(left, _TITLE_INCHES + self._picture, _HISTOGRAM_INCHES),
        )

    def _axes(self, left: float, top: float, height: float) -> Axes:
        place = (left, self._height - top - height, _INCHES_A_COLUMN - _GAP_INCHES, height)
        return self._part.add_axes(place / np.array([self._width, self._height] * 2))


def _draw_row(part, shown: Sequence[Shown], pictures: Sequence[Image.Image], columns: int) -> None:
    part.set_facecolor(BACKGROUND)
    layout, top = _Layout(part, columns, pictures), scale_end(shown)
    tallest = max(_shares(each.of_original, top).max() for each in shown if each.fine)
    for column, (each, picture) in enumerate(zip(shown, pictures, strict=True)):
        above, below = layout.column(column)
        _show(above, each, picture)
        if each.of_original is None:
            _draw_legend(part, below, top)
        else:
            _draw_histogram(below, each.of_original, top, tallest)
            below.set_ylabel("% of vertices" if column == 1 else "", fontsize=8.5)


def _show(axes: Axes, shown: Shown, picture: Image.Image) -> None:
    axes.imshow(picture, aspect="auto")
    axes.set_axis_off()
    axes.set_title(shown.title, loc="left", fontsize=12.5, pad=20)
    above = {"xytext": (0, 6), "textcoords": "offset points"}
    axes.annotate(
        shown.caption, (0, 1), xycoords="axes fraction", fontsize=9.5, color=FAINT_INK, **above
    )


def _draw_legend(part, axes: Axes, top: float) -> None:
    """A bar where the others have a histogram."""
    axes.set_axis_off()
    bar = axes.inset_axes((0, 0, 0.9, 0.16))
    legend = part.colorbar(
        ScalarMappable(Normalize(0, top), COLOR_MAP),
        cax=bar,
        orientation="horizontal",
        extend="max",
    )
    legend.set_label(_DISTANCE, fontsize=8.5)
    bar.locator_params(axis="x", nbins=_TICKS)
    bar.tick_params(colors=INK, labelsize=8)


def _shares(errors: Floats, top: float) -> Floats:
    """Per cent of the errors in each bin; the last one has all above."""
    counts = np.histogram(np.minimum(errors, top), _BINS, (0, top))[0]
    return 100 * counts / len(errors)


def _draw_histogram(axes: Axes, errors: Floats, top: float, tallest: float) -> None:
    edges = np.linspace(0, top, _BINS, endpoint=False)
    colors = COLOR_MAP((np.arange(_BINS) + 0.5) / _BINS)
    axes.bar(edges, _shares(errors, top), top / _BINS, align="edge", color=colors)
    axes.set(xlim=(0, top), ylim=(0, 1.05 * tallest), facecolor=BACKGROUND)
    axes.set_xlabel(_DISTANCE, fontsize=8.5)
    axes.locator_params(axis="x", nbins=_TICKS)
    axes.tick_params(colors=INK, labelsize=8)
    axes.spines[["top", "right"]].set_visible(False)
    axes.spines[["bottom", "left"]].set_color(FAINT)
