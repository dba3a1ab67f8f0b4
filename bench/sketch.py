# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws meshes side by side into one PNG, face by face from the back to the front.

For the demo, which needs Pillow for that and nothing else; `picture` draws finer, with VTK.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from palette import BACKGROUND, COLUMNS, DENSE, EDGES, FAINT_INK, INK
from panels import CELL_PIXELS, Fit, Panel, View, fit
from PIL import Image, ImageColor, ImageDraw, ImageFont
from surface import Floats, Ints

_OVERSAMPLING = 3  # pixels drawn for one of the picture, in each direction
_LIGHT = np.array([0.3, 0.5, 0.8]) / np.linalg.norm([0.3, 0.5, 0.8])  # right, up, to the viewer
_AMBIENT = 0.35  # share of light from everywhere
_TEXTS = ((0.04, 34, INK), (0.10, 25, FAINT_INK))  # title and caption: place, pixels, colour
_LEFT = 0.04  # of the cell, where they begin


def draw(path: Path, rows: Sequence[tuple[View, Sequence[Panel]]]) -> None:
    """Every row with one camera, fitted to its first panel."""
    columns = max(len(panels) for _, panels in rows)
    width, height = CELL_PIXELS
    image = Image.new("RGB", (width * columns, height * len(rows)), BACKGROUND)
    for row, (view, panels) in enumerate(rows):
        camera = fit(view, panels[0].vertices)
        for column, panel in enumerate(panels):
            cell = _cell(panel, camera, COLUMNS[column % len(COLUMNS)])
            image.paste(cell, (width * column, height * row))
    image.save(path)


def _cell(panel: Panel, camera: Fit, color: str) -> Image.Image:
    large = Image.new("RGB", tuple(_OVERSAMPLING * side for side in CELL_PIXELS), BACKGROUND)
    _draw_faces(ImageDraw.Draw(large), panel.faces, _project(panel.vertices, camera), color)
    cell = large.reduce(_OVERSAMPLING)
    pen = ImageDraw.Draw(cell)
    for text, (top, size, ink) in zip((panel.title, panel.caption), _TEXTS, strict=True):
        place = (_LEFT * CELL_PIXELS[0], top * CELL_PIXELS[1])
        pen.text(place, text, fill=ink, font=ImageFont.load_default(size))
    return cell


def _project(vertices: Floats, camera: Fit) -> Floats:
    """Right, up and to the viewer (n, 3), in drawn pixels from the middle of the cell."""
    pixels = _OVERSAMPLING * CELL_PIXELS[1] / camera.shown_height
    return (vertices - camera.centre) @ camera.frame.T * pixels


def _draw_faces(pen: ImageDraw.ImageDraw, faces: Ints, points: Floats, color: str) -> None:
    corners = points[faces]
    order = np.argsort(corners[:, :, 2].sum(axis=1))
    fills = _shade(corners, color)
    edge, share = np.array(ImageColor.getrgb(EDGES)), 0.25 if len(faces) > DENSE else 0.85
    outlines = (fills + share * (edge - fills)).astype(int)
    middle = _OVERSAMPLING * np.array(CELL_PIXELS) / 2
    on_paper = (middle + corners[:, :, :2] * (1, -1)).reshape(-1, 6)
    for face in order:
        fill, outline = tuple(fills[face].astype(int)), tuple(outlines[face])
        pen.polygon(on_paper[face].tolist(), fill=fill, outline=outline)


def _shade(corners: Floats, color: str) -> Floats:
    """A colour for each face, (m, 3); both sides of a face look the same."""
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    normals /= np.where(lengths > 0, lengths, 1)
    normals *= np.where(normals[:, 2:] < 0, -1, 1)
    bright = _AMBIENT + (1 - _AMBIENT) * np.clip(normals @ _LIGHT, 0, 1)
    return bright[:, None] * np.array(ImageColor.getrgb(color))
