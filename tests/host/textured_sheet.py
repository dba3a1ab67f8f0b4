# SPDX-License-Identifier: GPL-3.0-or-later
"""A sheet with images and colours, for the tests of file formats."""

import io
from functools import cache
from typing import NamedTuple

import numpy as np
from drawn_meshes import bumpy_sheet
from PIL import Image

CELLS = 24
BANDS = 3  # of the sheet along x, all of one width
SEAMS = (1 / 3, 2 / 3)  # where bands meet
IMAGES = ("left_page.png", "deep_folder/middle_page.png", "right.png")  # of the bands
WIDTHS = LEFT, MIDDLE, RIGHT = (4, 5, 6)  # of the images, in pixels; they tell which is which
COLOURS = np.array([[0.8, 0.2, 0.2, 1], [0.2, 0.8, 0.4, 1], [0.2, 0.4, 0.8, 1]])  # of the bands
MATRIX = np.array([[0, -2, 0, 5], [2, 0, 0, -3], [0, 0, 2, 7], [0, 0, 0, 1.0]])  # of the layer


class Sheet(NamedTuple):
    """A mesh in one piece. Each band has an image, a material and a colour of its own.

    bands: the band of each face. coordinates: (m, 3, 2), where the corners of the faces lie in the
    image of their band. colours: (n, 4), of the vertices.
    """

    vertices: np.ndarray
    faces: np.ndarray
    bands: np.ndarray
    coordinates: np.ndarray
    colours: np.ndarray


@cache
def textured_sheet():
    """The sheet. Within a band, its coordinates and colours are affine in position."""
    vertices, faces = bumpy_sheet(CELLS)
    bands = np.floor(BANDS * vertices[faces].mean(axis=1)[:, 0]).astype(int)
    x, y = vertices[faces][:, :, 0], vertices[faces][:, :, 1]
    u = 0.1 + 0.8 * (BANDS * x - bands[:, None])
    v = 0.1 + 0.2 * bands[:, None] + 0.4 * y
    red, green = 0.2 + 0.6 * vertices[:, :2].T
    colours = np.column_stack([red, green, np.full_like(red, 0.3), np.ones_like(red)])
    return Sheet(vertices, faces, bands, np.stack([u, v], axis=2), colours)


def piece(band):
    """A band of the sheet as a mesh of its own: vertices, their coordinates, and faces."""
    sheet = textured_sheet()
    corners = sheet.faces[sheet.bands == band].ravel()
    used, first, faces = np.unique(corners, return_index=True, return_inverse=True)
    coordinates = sheet.coordinates[sheet.bands == band].reshape(-1, 2)
    return sheet.vertices[used], coordinates[first], faces.reshape(-1, 3)


def draw_images(folder, names):
    """Writes the images of the first bands as PNG files of these names."""
    for band, name in enumerate(names):
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(image_bytes(band))


def image_bytes(band):
    """The image of a band, as PNG."""
    stream = io.BytesIO()
    Image.new("RGB", (WIDTHS[band], 4), (90 * band, 100, 200)).save(stream, "PNG")
    return stream.getvalue()
