# SPDX-License-Identifier: GPL-3.0-or-later
"""The judge of textures on squares whose figures are known."""

from __future__ import annotations

import numpy as np
import pytest
from decimators import DEFAULT_PLUGIN
from surface import Floats, Surface
from test_judge import grid
from texture import Textured, TextureJudge, read_textured
from textures import compare, decimators

DIAGONAL = np.sqrt(2.0)


def square(n: int = 4, **changes: object) -> Textured:
    """The unit square, each point drawn where it lies, on page 0."""
    vertices, faces = grid(n)
    values = {
        "surface": Surface(vertices, faces),
        "coordinates": vertices[faces][:, :, :2].copy(),
        "pages": np.zeros(len(faces), dtype=np.int64),
    }
    return Textured(**(values | changes))


def drawn(n: int, place: Floats) -> Textured:
    """Each point drawn at place(x, y)."""
    vertices, faces = grid(n)
    return square(n, coordinates=np.stack(place(*vertices[:, :2].T), axis=1)[faces])


def test_a_surface_is_drawn_as_itself():
    figures = TextureJudge(square())(square(3))
    assert figures.drift_rms < 1e-12
    assert (figures.far, figures.bleed, figures.turned, figures.cracks) == (0, 0, 0, 0)


def test_drift_is_how_far_the_image_has_moved():
    half = drawn(4, lambda x, y: (0.25 + x / 2, 0.25 + y / 2))
    shifted = drawn(4, lambda x, y: (0.3 + x / 2, 0.25 + y / 2))  # a tenth of the square
    figures = TextureJudge(drawn(4, lambda x, y: (x, y)))(half)
    assert figures.far > 90
    figures = TextureJudge(half)(shifted)
    assert figures.drift_rms == pytest.approx(100 * 0.1 / DIAGONAL, rel=0.06)
    assert figures.far == 100
    assert figures.bleed == pytest.approx(10, abs=0.5)


def test_coordinates_beside_all_charts_bleed():
    figures = TextureJudge(square())(drawn(1, lambda x, y: (1.25 * x, y)))
    assert figures.bleed == pytest.approx(20, abs=0.5)


def test_another_page_is_another_chart():
    judge = TextureJudge(square())
    assert judge(square(pages=np.ones(32, dtype=np.int64))).bleed == 100


def test_of_charts_on_top_of_each_other_the_nearest_counts():
    vertices, faces = grid(2)
    two = Surface(
        np.concatenate([vertices, vertices + (3, 0, 0)]), np.concatenate([faces, faces + 9])
    )
    coordinates = np.tile(vertices[faces][:, :, :2], (2, 1, 1))
    both = Textured(two, coordinates, np.zeros(16, dtype=np.int64))
    figures = TextureJudge(both)(both)
    assert figures.drift_max < 1e-9
    assert figures.bleed == 0


def test_faces_that_are_turned_over_in_the_atlas_are_counted():
    turned = drawn(2, lambda x, y: (1 - x, y))
    assert TextureJudge(square())(turned).turned == 8
    assert TextureJudge(turned)(turned).turned == 0, "mirrored on purpose"


def test_faces_of_one_colour_do_not_drift():
    palette = drawn(8, lambda x, y: (0 * x + 0.5, 0 * y + 0.5))
    figures = TextureJudge(palette)(drawn(2, lambda x, y: (0 * x + 0.5, 0 * y + 0.5)))
    assert (figures.drift_rms, figures.far, figures.bleed) == (0, 0, 0)


def test_cracks_are_edges_that_have_come_apart():
    vertices, faces = grid(2)
    apart = vertices[faces].reshape(-1, 3)
    sewn = square(2, surface=Surface(apart, np.arange(24).reshape(-1, 3)))
    assert TextureJudge(square(2))(sewn).cracks == 0
    moved = apart.copy()
    moved[:3] += (0, 0, 0.1)
    torn = square(2, surface=Surface(moved, np.arange(24).reshape(-1, 3)))
    assert TextureJudge(square(2))(torn).cracks > 0


def test_files_are_read_by_wedge_and_page(tmp_path):
    (tmp_path / "two.mtl").write_text("newmtl a\nmap_Kd a.png\nnewmtl b\nmap_Kd b.png\n")
    (tmp_path / "two.obj").write_text(
        "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
        "vt 0 0\nvt 1 0\nvt 1 1\nvt 0.25 0.5\n"
        "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 3/3 4/4\n"
    )
    textured = read_textured(tmp_path / "two.obj")
    assert textured.coordinates.tolist() == [
        [[0, 0], [1, 0], [1, 1]],
        [[0, 0], [1, 1], [0.25, 0.5]],
    ]
    assert len(set(textured.pages.tolist())) == 2


def test_a_file_without_coordinates_is_refused(tmp_path):
    (tmp_path / "bare.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n")
    with pytest.raises(ValueError, match=r"bare.obj has no texture"):
        read_textured(tmp_path / "bare.obj")


def test_ours_keep_a_flat_texture_in_its_place_and_every_decimator_has_a_row(tmp_path):
    vertices, faces = grid(20)
    lines = [f"v {x} {y} 0\nvt {x} {y}" for x, y, _ in vertices]
    lines += ["f " + " ".join(f"{v}/{v}" for v in face) for face in faces + 1]
    (tmp_path / "flat.obj").write_text("\n".join(lines) + "\n")
    all_of_them = decimators(DEFAULT_PLUGIN)
    rows = list(compare(tmp_path / "flat.obj", [0.1], all_of_them))
    assert [row.decimator for row in rows] == [each.name for each in all_of_them]
    for row in rows[:-1]:  # the last is MeshLab's
        texture = row.texture
        assert texture.drift_rms < 1e-3
        assert (texture.far, texture.bleed, texture.turned, texture.cracks) == (0, 0, 0, 0)
