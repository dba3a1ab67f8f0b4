# SPDX-License-Identifier: GPL-3.0-or-later
"""Views of textured meshes whose differences are known, and the images that are found for them."""

from __future__ import annotations

from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from decimators import DEFAULT_PLUGIN
from panels import View, fit
from PIL import Image
from surface import Floats, Surface
from test_judge import Mesh, grid, octasphere
from texture import Textured
from textured_views import (
    DIRECTIONS,
    Difference,
    Look,
    Pixels,
    Views,
    decimators,
    draw,
    drawn_image,
    shoot,
    sit,
)

RED, GREEN, BLUE, WHITE = (255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 255)
FRONT = View((0.0, 0.0, 1.0))


def plain(*colour: int) -> Pixels:
    return np.full((4, 4, 3), colour, dtype=np.uint8)


def look(mesh: Mesh, place: Floats, *images: Pixels, pages: Floats | int = 0) -> Look:
    """Each vertex drawn at its place (n, 2)."""
    vertices, faces = mesh
    all_pages = np.broadcast_to(np.asarray(pages, dtype=np.int64), len(faces))
    return Look(Textured(Surface(vertices, faces), place[faces], all_pages), images)


def ball(*images: Pixels, radius: float = 1.0, shift: float = 0.0) -> Look:
    """A sphere with an image laid over it from the front."""
    unit, _ = octasphere(1.0)
    place = 0.5 + 0.4 * unit[:, :2] + (shift, 0.0)
    return look(octasphere(radius), place, *(images or [drawn_image(256, 8)]))


def sheet(*images: Pixels, pages: Floats | int = 0, n: int = 2) -> Look:
    """The unit square, each point drawn where it lies."""
    vertices, faces = grid(n)
    return look((vertices, faces), vertices[:, :2], *images, pages=pages)


def from_the_front(shown: Look) -> Pixels:
    """Cut to the object."""
    (view,) = shoot(shown, [fit(FRONT, shown.textured.surface.vertices)])
    is_there = view[..., 3] > 0
    rows, columns = is_there.any(axis=1), is_there.any(axis=0)
    return view[rows][:, columns]


def colour_at(view: Pixels, x: float, y: float) -> tuple[int, ...]:
    """x to the right and y upwards, 0 to 1."""
    height, width = view.shape[:2]
    return tuple(view[int((1 - y) * height), int(x * width), :3].tolist())


def difference(original: Look, simplified: Look) -> Difference:
    return Views(original)(simplified)


def test_a_mesh_against_itself_has_no_difference() -> None:
    assert difference(ball(), ball()) == Difference(0.0, 0.0)


def test_a_shifted_texture_is_another_colour_in_the_same_silhouette() -> None:
    figures = difference(ball(), ball(shift=0.1))
    assert figures.colour > 5
    assert figures.silhouette == 0


def test_a_smaller_mesh_leaves_a_silhouette() -> None:
    figures = difference(ball(plain(*RED)), ball(plain(*RED), radius=0.9))
    assert figures.silhouette == pytest.approx(100 * (1 - 0.9**2), abs=0.3)
    assert figures.colour == 0
    larger = difference(ball(plain(*RED), radius=0.9), ball(plain(*RED)))
    assert larger.silhouette == pytest.approx(100 * (1 - 0.9**2), abs=0.3)


@pytest.mark.parametrize(
    ("colour", "percent"), [(WHITE, 100), (BLUE, 100 / np.sqrt(3)), ((51, 51, 51), 20)]
)
def test_black_to_white_is_all_of_the_range(colour: tuple[int, ...], percent: float) -> None:
    figures = difference(ball(plain(0, 0, 0)), ball(plain(*colour)))
    assert figures.colour == pytest.approx(percent, abs=1e-9)


def test_the_difference_is_the_mean_of_all_cameras() -> None:
    """Three of the six see the lower of two sheets that hide each other."""
    vertices, faces = grid(1)
    mesh = np.concatenate([vertices, vertices - (0, 0, 1e-3)]), np.concatenate([faces, faces + 4])
    place = np.tile(vertices[:, :2], (2, 1))
    black = look(mesh, place, plain(0, 0, 0))
    half = look(mesh, place, plain(0, 0, 0), plain(*WHITE), pages=np.array([0, 0, 1, 1]))
    assert difference(black, half).colour == pytest.approx(50, abs=1)


def test_no_two_cameras_see_the_same() -> None:
    shown = ball()
    cameras = [fit(View(each), shown.textured.surface.vertices) for each in DIRECTIONS]
    for a, b in combinations(shoot(shown, cameras), 2):
        assert np.any(a != b)
    assert len(cameras) == 6


def test_a_pixel_has_the_colour_of_the_texture() -> None:
    view = from_the_front(ball(plain(200, 100, 50)))
    assert set(map(tuple, view[view[..., 3] > 0].tolist())) == {(200, 100, 50, 255)}


def test_an_image_stands_upright() -> None:
    image = np.array([[RED, GREEN], [BLUE, WHITE]], dtype=np.uint8).repeat(8, 0).repeat(8, 1)
    view = from_the_front(sheet(image))
    assert (colour_at(view, 0.2, 0.8), colour_at(view, 0.8, 0.8)) == (RED, GREEN)
    assert (colour_at(view, 0.2, 0.2), colour_at(view, 0.8, 0.2)) == (BLUE, WHITE)


def test_an_image_goes_on_beside_itself() -> None:
    inside, beside = ball(), ball(shift=1.0)
    assert difference(inside, beside).colour < 0.1


def test_every_page_has_its_image() -> None:
    view = from_the_front(sheet(plain(*RED), plain(*GREEN), pages=np.array([0, 1]), n=1))
    assert colour_at(view, 0.75, 0.25) == RED, "the lower triangle"
    assert colour_at(view, 0.25, 0.75) == GREEN, "the upper triangle"


def test_a_face_of_no_page_is_drawn_all_the_same() -> None:
    view = from_the_front(sheet(plain(*RED), pages=np.array([0, -1]), n=1))
    assert colour_at(view, 0.75, 0.25) == RED
    expected = colour_at(drawn_image(), 0.265, 0.765)  # not where two squares meet
    assert colour_at(view, 0.265, 0.765) == pytest.approx(expected, abs=1)


def write_sheet(folder: Path, materials: str = "", n: int = 1) -> Path:
    """The unit square as OBJ; the lower triangles have material 0 and the upper ones 1."""
    vertices, faces = grid(n)
    lines = ["mtllib sheet.mtl"] if materials else []
    lines += [f"v {x} {y} 0\nvt {x} {y}" for x, y, _ in vertices]
    for index, face in enumerate(faces + 1):
        lines += [f"usemtl m{2 * index // len(faces)}"] if materials else []
        lines += ["f " + " ".join(f"{v}/{v}" for v in face)]
    (folder / "sheet.obj").write_text("\n".join(lines) + "\n")
    (folder / "sheet.mtl").write_text(materials)
    return folder / "sheet.obj"


def materials(folder: Path, *names: str) -> str:
    """Two materials, the first of them red and the second green."""
    for name, colour in zip(names, (RED, GREEN), strict=True):
        Image.fromarray(plain(*colour)).save(folder / name, quality=100)
    return "".join(f"newmtl m{i}\nKd 1 1 1\nmap_Kd {name}\n" for i, name in enumerate(names))


@pytest.mark.parametrize(
    "names",
    [("a.png", "b.jpg"), ("b.png", "a.png"), ("b.jpg", "a.jpg"), ("the b.png", "a.png")],
    ids=["png and jpg", "not in the order of names", "jpg", "with a blank"],
)
def test_the_images_of_a_file_are_found(tmp_path: Path, names: tuple[str, str]) -> None:
    assert_red_and_green(write_sheet(tmp_path, materials(tmp_path, *names)))


@pytest.mark.parametrize("names", [("b.png", "a.png"), ("b.jpg", "a.jpg")], ids=["png", "jpg"])
def test_pages_are_in_the_order_of_materials(tmp_path: Path, names: tuple[str, str]) -> None:
    first, _, second = materials(tmp_path, *names).partition("newmtl m1")
    assert_red_and_green(write_sheet(tmp_path, f"newmtl m1{second}{first}"))


def assert_red_and_green(mesh: Path) -> None:
    view = from_the_front(sit(mesh, [], []).look)
    assert colour_at(view, 0.75, 0.25) == pytest.approx(RED, abs=2), "the lower triangle"
    assert colour_at(view, 0.25, 0.75) == pytest.approx(GREEN, abs=2), "the upper triangle"


def test_a_file_without_images_gets_a_drawn_one(tmp_path: Path) -> None:
    (image,) = sit(write_sheet(tmp_path), [], []).look.images
    assert np.array_equal(image, drawn_image())


def test_an_image_that_is_missing_is_drawn(tmp_path: Path) -> None:
    text = materials(tmp_path, "a.png", "b.png")
    (tmp_path / "b.png").unlink()
    first, second = sit(write_sheet(tmp_path, text), [], []).look.images
    assert np.array_equal(first, plain(*RED))
    assert np.array_equal(second, drawn_image())


def test_a_flat_sheet_looks_the_same_and_the_picture_has_a_cell_for_each(tmp_path: Path) -> None:
    sitting = sit(write_sheet(tmp_path, n=12), [0.5, 0.1], decimators(DEFAULT_PLUGIN))
    assert [(each.fraction, each.decimator) for each in sitting.results] == [
        (0.5, "CurvDecim Balanced"),
        (0.5, "MeshLab, with texture"),
        (0.1, "CurvDecim Balanced"),
        (0.1, "MeshLab, with texture"),
    ]
    ours = sitting.results[2]
    assert ours.faces <= 29
    assert ours.difference.colour < 0.2
    assert ours.difference.silhouette < 0.2
    draw(tmp_path / "picture.png", [sitting, sitting], 0.1)
    with Image.open(tmp_path / "picture.png") as picture:
        assert picture.size == (3 * 500, 2 * 400)
        cells = np.asarray(picture.convert("RGB")).reshape(2, 400, 3, 500, 3)
    assert np.array_equal(cells[0], cells[1])
    assert all(np.ptp(cells[0, 100:, column]) > 100 for column in range(3)), "none is empty"
