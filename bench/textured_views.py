# SPDX-License-Identifier: GPL-3.0-or-later
"""What textured meshes look like after our filter and after MeshLab's that knows of textures.

    python bench/textured_views.py MESH... [--plugin FILE] [--fraction 0.2] [--picture FILE]

Six cameras look at the input and at what the filters made of it, without light, so that a pixel
has the colour of the texture. Pixels that both meshes cover are compared by colour; pixels that
only one of them covers are counted apart. The picture shows the last of the fractions, with light.
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain, product
from pathlib import Path

import numpy as np
import pymeshlab
import pyvista
from decimators import DEFAULT_PLUGIN, Decimator, curvdecim, meshlab_textured, save_once
from numpy.typing import NDArray
from palette import BACKGROUND, FAINT_INK, INK
from panels import CELL_PIXELS, Fit, View, fit
from PIL import Image, ImageDraw, ImageFont
from plyfile import PlyData
from surface import Floats
from tables import console, table
from texture import Textured, read_textured
from textures import FRACTIONS, save_with_wedges
from vtkmodules.vtkCommonCore import vtkLogger

Pixels = NDArray[np.uint8]  # (height, width, 3 or 4), the first row is the top

# The sides of a cube that is turned, so that no camera looks along an axis.
DIRECTIONS = ((-1, 2, 2), (2, 2, -1), (2, -1, 2), (1, -2, -2), (-2, -2, 1), (-2, 1, -2))
VIEWS = {
    "bunny10k_textured": View((0.2, 0.2, 1.0)),
    "duck": View((1.0, 0.3, 0.9)),
    "fuze": View((-1.0, -0.8, 0.3), (0.0, 0.0, 1.0)),
    "doorman": View((0.3, 0.1, 1.0)),
    "animal_checker": View((1.0, 0.5, 0.6)),
}  # of the picture, others are seen by the first camera
_HEADINGS = ("mesh", "to", "decimator", "faces", "colour", "silhouette")
_STAND_IN = "dummy.png"  # the name that MeshLab gives to all images that it cannot read
_PERCENT = 100.0
_OVERSAMPLING = 3  # pixels drawn for one of the picture, in each direction
_CELL = (500, 400)  # pixels of the picture, of the shape of CELL_PIXELS
_TEXTS = ((0.03, 20, INK), (0.095, 15, FAINT_INK))  # title and caption: place, pixels, colour
_LEFT = 0.04  # of the cell, where they begin
_INKS = 256  # colours of the picture: a quarter of the bytes
_AMBIENT = 0.3  # share of light from everywhere


@dataclass(frozen=True)
class Difference:
    """Between views of two meshes, the mean of all cameras."""

    colour: float  # mean RGB distance (Euclidean) where both are; black to white is 100 %
    silhouette: float  # % of the pixels where one is at least: those where the other is not


@dataclass(frozen=True)
class Look:
    """A mesh with the images of its pages."""

    textured: Textured
    images: Sequence[Pixels]


@dataclass(frozen=True)
class Seen:
    """What one decimator left of a mesh."""

    mesh: str
    fraction: float
    decimator: str
    look: Look
    difference: Difference

    @property
    def faces(self) -> int:
        """How many are left."""
        return len(self.look.textured.pages)

    def cells(self) -> list[str]:
        """As _HEADINGS has them."""
        figures = (f"{self.difference.colour:.2f}", f"{self.difference.silhouette:.2f}")
        return [self.mesh, f"{self.fraction:.0%}", self.decimator, str(self.faces), *figures]

    def caption(self) -> str:
        """For the picture."""
        colour = f"colour {self.difference.colour:.1f} %"
        return f"{self.faces:,} faces   {colour}   silhouette {self.difference.silhouette:.1f} %"


@dataclass(frozen=True)
class Sitting:
    """A mesh and all that the decimators left of it."""

    name: str
    look: Look
    results: Sequence[Seen]


def decimators(plugin: Path) -> list[Decimator]:
    """Ours and MeshLab's."""
    return [curvdecim(plugin, "CurvDecim Balanced", preset="Balanced"), meshlab_textured()]


def sit(mesh: Path, fractions: Sequence[float], chosen: Sequence[Decimator]) -> Sitting:
    """Each of the decimators on the mesh, to each of the fractions of its faces."""
    with tempfile.TemporaryDirectory() as folder:
        original, result = Path(folder) / "original.ply", Path(folder) / "simplified.ply"
        save_with_wedges(mesh, original)
        look = Look(read_textured(original), images_of(mesh, original))
        judge, seen = Views(look), []
        for fraction, each in product(fractions, chosen):
            save_once(original, round(fraction * len(look.textured.pages)), each, result)
            now = Look(read_textured(result), look.images)
            seen.append(Seen(mesh.name, fraction, each.name, now, judge(now)))
    return Sitting(mesh.stem, look, seen)


class Views:
    """Knows how the input looks to all cameras; call it with a simplified mesh."""

    def __init__(self, original: Look) -> None:
        points = _points(original)
        self._cameras = [fit(View(direction), points) for direction in DIRECTIONS]
        self._original = shoot(original, self._cameras)

    def __call__(self, simplified: Look) -> Difference:
        now = shoot(simplified, self._cameras)
        pairs = zip(self._original, now, strict=True)
        figures = np.mean([_difference(*pair) for pair in pairs], axis=0)
        return Difference(*map(float, figures))


def _difference(a: Pixels, b: Pixels) -> tuple[float, float]:
    """Colour and silhouette of two views (h, w, 4), as Difference has them."""
    is_a, is_b = a[..., 3] > 0, b[..., 3] > 0
    both, either = is_a & is_b, is_a | is_b
    apart = a[both, :3].astype(float) - b[both, :3]
    colour = np.linalg.norm(apart, axis=1).sum() / np.linalg.norm((255, 255, 255))
    alone = np.sum(is_a != is_b) / max(1, either.sum())
    return _PERCENT * colour / max(1, both.sum()), _PERCENT * alone


def shoot(
    look: Look,
    cameras: Sequence[Fit],
    size: tuple[int, int] = CELL_PIXELS,
    light: bool = False,
) -> list[Pixels]:
    """A view (h, w, 4) for each camera; alpha is 0 where nothing is, and 255 elsewhere."""
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)  # a missing display is expected
    plotter = pyvista.Plotter(off_screen=True, window_size=list(size), lighting="light kit")
    plotter.disable_anti_aliasing()
    for page in np.unique(look.textured.pages):
        _add(plotter, look, page, light)
    views = [_shot(plotter, camera) for camera in cameras]
    plotter.close()
    return views


def _add(plotter: pyvista.Plotter, look: Look, page: int, light: bool) -> None:
    """The faces of one page, each with three points of its own."""
    chosen = look.textured.pages == page
    corners = look.textured.surface.corners[chosen]
    faces = np.arange(3 * len(corners)).reshape(-1, 3)
    mesh = pyvista.PolyData.from_regular_faces(corners.reshape(-1, 3), faces)
    mesh.active_texture_coordinates = look.textured.coordinates[chosen].reshape(-1, 2)
    image = look.images[page] if 0 <= page < len(look.images) else drawn_image()
    texture = pyvista.Texture(image)
    texture.interpolate, texture.repeat = True, True
    ambient = _AMBIENT if light else 0.0  # without light it would be added to the texture
    plotter.add_mesh(mesh, texture=texture, color="white", lighting=light, ambient=ambient)


def _shot(plotter: pyvista.Plotter, camera: Fit) -> Pixels:
    _, up, towards = camera.frame
    plotter.camera.focal_point = camera.centre
    plotter.camera.position = camera.centre + (camera.depth + camera.shown_height) * towards
    plotter.camera.up = up
    plotter.camera.parallel_projection = True
    plotter.camera.parallel_scale = camera.shown_height / 2
    plotter.reset_camera_clipping_range()
    plotter.render()  # a screenshot alone shows the camera before
    return plotter.screenshot(return_img=True, transparent_background=True)


def _points(look: Look) -> Floats:
    return look.textured.surface.without_unreferenced().vertices


def images_of(mesh: Path, copy: Path) -> list[Pixels]:
    """One for each page of a mesh; copy: the same as PLY, which lists the names in their order.

    PyMeshLab reads no JPEG, and no image with a blank in its name: those are looked for beside the
    mesh. What is found nowhere, and the image of a mesh that names none, is drawn.
    """
    comments = [each.partition(" ") for each in PlyData.read(copy).comments]
    names = [name for kind, _, name in comments if kind == "TextureFile"]
    loaded, files = _loaded(mesh), _named_by_materials(mesh)
    if len(files) != len(names):
        files = [mesh.parent / name for name in names]
    pages = zip(names, files, strict=True)
    images = [loaded[name] if name in loaded else _read(file) for name, file in pages]
    return images or [drawn_image()]


def _loaded(mesh: Path) -> dict[str, Pixels]:
    """The images that PyMeshLab finds, by name."""
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(str(mesh))
    textures = meshes.current_mesh().textures()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "image.png"
        images = {}
        for name in textures.keys() - {_STAND_IN}:
            textures[name].save(str(path))
            images[name] = _read(path)
    return images


def _named_by_materials(mesh: Path) -> list[Path]:
    """The images of an OBJ, each once, in the order of its pages."""
    if mesh.suffix.lower() != ".obj":
        return []
    libraries = [mesh.parent / name for name in _values(mesh, "mtllib")]
    lines = [_values(path, "map_Kd") for path in libraries if path.is_file()]
    return [mesh.parent / name for name in dict.fromkeys(chain(*lines))]


def _values(path: Path, key: str) -> list[str]:
    """What follows the key, of all lines that begin with it."""
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    parts = [line.strip().partition(" ") for line in lines]
    return [value.strip() for word, _, value in parts if word == key]


def _read(path: Path) -> Pixels:
    """An image file; a drawn image where there is none."""
    if not path.is_file():
        return drawn_image()
    with Image.open(path) as image:
        return np.asarray(image.convert("RGB"))


def drawn_image(side: int = 1024, squares: int = 32) -> Pixels:
    """A checker whose colour tells the place: red grows to the right, green upwards."""
    ticks = (np.arange(side) + 0.5) / side
    u, v = np.meshgrid(ticks, ticks[::-1])
    is_light = (np.floor(squares * u) + np.floor(squares * v)) % 2 == 0
    colours = np.stack([0.15 + 0.85 * u, 0.15 + 0.85 * v, 1 - 0.8 * u], axis=2)
    return (255 * colours * np.where(is_light, 1.0, 0.6)[..., None]).astype(np.uint8)


def draw(path: Path, sittings: Sequence[Sitting], fraction: float) -> None:
    """A row a mesh: the input, and what the decimators left of it at the fraction."""
    rows = [_row(each, fraction) for each in sittings]
    width, height = _CELL
    columns = max(map(len, rows))
    picture = Image.new("RGB", (width * columns, height * len(rows)), BACKGROUND)
    for y, row in enumerate(rows):
        for x, cell in enumerate(row):
            picture.paste(cell, (width * x, height * y))
    picture.quantize(_INKS).save(path, optimize=True)


def _row(sitting: Sitting, fraction: float) -> list[Image.Image]:
    view = VIEWS.get(sitting.name, View(DIRECTIONS[0]))
    camera = fit(view, _points(sitting.look))
    faces = f"{len(sitting.look.textured.pages):,} faces"
    cells = [_cell(sitting.look, camera, (f"{sitting.name}, input", faces))]
    for each in sitting.results:
        if each.fraction == fraction:
            cells.append(_cell(each.look, camera, (each.decimator, each.caption())))
    return cells


def _cell(look: Look, camera: Fit, texts: tuple[str, str]) -> Image.Image:
    large = tuple(_OVERSAMPLING * side for side in _CELL)
    view = Image.fromarray(shoot(look, [camera], large, light=True)[0])
    cell = Image.new("RGB", large, BACKGROUND)
    cell.paste(view, mask=view.getchannel("A"))
    cell = cell.reduce(_OVERSAMPLING)
    pen = ImageDraw.Draw(cell)
    for text, (top, size, ink) in zip(texts, _TEXTS, strict=True):
        place = (_LEFT * _CELL[0], top * _CELL[1])
        pen.text(place, text, fill=ink, font=ImageFont.load_default(size))
    return cell


def main() -> None:
    options = _options()
    fractions = options.fraction or FRACTIONS
    sittings = [sit(mesh, fractions, decimators(options.plugin)) for mesh in options.mesh]
    rows = [seen.cells() for sitting in sittings for seen in sitting.results]
    title = "Views of textured meshes beside those of the input, in %"
    console().print(table(title, _HEADINGS, rows))
    if options.picture:
        draw(options.picture, sittings, fractions[-1])


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mesh", type=Path, nargs="+")
    parser.add_argument("--plugin", type=Path, default=DEFAULT_PLUGIN)
    parser.add_argument("--fraction", type=float, action="append", help="0.2 and 0.05")
    parser.add_argument("--picture", type=Path, metavar="FILE", help="writes a PNG")
    return parser.parse_args()


if __name__ == "__main__":
    main()
