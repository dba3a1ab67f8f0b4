# SPDX-License-Identifier: GPL-3.0-or-later
"""The judge on surfaces whose figures are known in closed form."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from judge import Figures, Judge
from surface import Floats, Ints, Surface

Mesh = tuple[Floats, Ints]


def grid(n: int, height: float = 0.0) -> Mesh:
    """A unit square of n x n cells, two triangles each, at z = height, facing up."""
    ticks = np.linspace(0, 1, n + 1)
    vertices = np.array([(x, y, height) for y, x in product(ticks, ticks)])
    corner = np.array([y * (n + 1) + x for y, x in product(range(n), range(n))])
    right, up = corner + 1, corner + n + 1
    lower, upper = np.stack([corner, right, up + 1], 1), np.stack([corner, up + 1, up], 1)
    return vertices, np.concatenate([lower, upper])


def octasphere(radius: float, levels: int = 5) -> Mesh:
    """An octahedron split `levels` times, its vertices on a sphere about the origin."""
    vertices = np.array(
        [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)], float
    )
    equator = ((0, 2), (2, 1), (1, 3), (3, 0))
    faces = [(a, b, 4) for a, b in equator] + [(b, a, 5) for a, b in equator]
    ball = Surface(vertices, faces)
    for _ in range(levels):
        ball = ball.quartered()
    return radius * ball.vertices / np.linalg.norm(ball.vertices, axis=1)[:, None], ball.faces


def judged(original: Mesh, simplified: Mesh) -> Figures:
    return Judge(*original)(*simplified)


def test_a_mesh_against_itself_has_no_error() -> None:
    figures = judged(octasphere(2.0), octasphere(2.0))
    assert max(figures.rms, figures.mean, figures.max, figures.rms_salient) < 1e-9
    assert figures.ndev < 1e-5
    assert figures.flipped == figures.zero_area == figures.dup_faces == 0
    assert figures.nm_edges == figures.nm_vertices == figures.boundary == 0
    assert figures.euler == 2


@pytest.mark.parametrize("shift", [0.01, 0.2])
def test_a_shifted_plane_is_the_shift_away(shift: float) -> None:
    figures = judged(grid(8), grid(3, shift))
    percent = 100 * shift / np.sqrt(2)
    for figure in (figures.rms, figures.mean, figures.max, figures.rms_salient):
        assert figure == pytest.approx(percent, rel=1e-9)
    assert figures.ndev == pytest.approx(0, abs=1e-5)
    assert (figures.boundary, figures.euler, figures.faces) == (12, 1, 18)


def test_half_a_plane_is_far_in_one_direction_only() -> None:
    """From the whole square to its half x <= 1/2: 0 on the half, x - 1/2 beyond it."""
    vertices, faces = grid(8)
    left = faces[vertices[faces][:, :, 0].max(axis=1) <= 0.5]
    figures = judged((vertices, faces), (vertices, left))
    one_way = 100 * np.sqrt(1 / 24) / np.sqrt(2)
    assert figures.rms_simplified_to_original == pytest.approx(0, abs=1e-9)
    assert figures.rms_original_to_simplified == pytest.approx(one_way, rel=2e-3)
    assert figures.rms == pytest.approx(one_way / np.sqrt(2), rel=2e-3)
    assert figures.mean == pytest.approx(100 / 8 / 2 / np.sqrt(2), rel=2e-3)
    assert figures.max == pytest.approx(50 / np.sqrt(2), rel=1e-9)


def test_a_sphere_of_another_radius_is_the_difference_away() -> None:
    figures = judged(octasphere(1.0), octasphere(1.1))
    percent = 100 * 0.1 / (2 * np.sqrt(3))
    assert figures.rms == pytest.approx(percent, rel=5e-3)
    assert figures.max == pytest.approx(percent, rel=2e-2)
    assert figures.max >= figures.rms >= figures.mean


@pytest.mark.parametrize("scale", [2.0**-30, 1.0, 2.0**30])
@pytest.mark.parametrize("offset", [0.0, 1000.0])
def test_the_unit_and_the_place_do_not_matter(scale: float, offset: float) -> None:
    small, large = octasphere(1.0, 3), octasphere(1.1, 3)
    expected = judged(small, large)
    moved = [(scale * (vertices + offset), faces) for vertices, faces in (small, large)]
    assert judged(*moved).rms == pytest.approx(expected.rms, rel=1e-6)


def test_a_face_turned_over_counts_as_flipped() -> None:
    vertices, faces = grid(4)
    turned = faces.copy()
    turned[[3, 17]] = turned[[3, 17], ::-1]
    assert judged((vertices, faces), (vertices, turned)).flipped == 2


def test_normals_that_tilt_are_measured_in_degrees() -> None:
    vertices, faces = grid(4)
    tilted = vertices.copy()
    tilted[:, 2] = 1e-9 * (vertices[:, 0] - 0.5) + np.tan(np.radians(10)) * (vertices[:, 0] - 0.5)
    assert judged((vertices, faces), (tilted, faces)).ndev == pytest.approx(10, rel=1e-6)


def test_topological_defects_are_counted() -> None:
    vertices, faces = grid(4)
    fin = np.concatenate([vertices, [(0.5, 0.5, 0.5), (0.4, 0.5, 0.5), (0.5, 0.4, 0.5)]])
    tip, left, right, inside = 25, 26, 27, 12  # vertex 12 is the centre of the 5 x 5 grid
    third_face_of_an_edge, touching_at_a_vertex = (6, 7, tip), (inside, left, right)
    extra = [third_face_of_an_edge, touching_at_a_vertex, np.roll(faces[0], 1)]
    figures = judged((vertices, faces), (fin, np.concatenate([faces, extra])))
    assert figures.dup_faces == 1
    assert figures.nm_edges == 2 + 1  # inner edges of the doubled face, and 6-7
    assert figures.nm_vertices == 1


def test_the_salient_part_is_the_most_curved_fifth() -> None:
    """Only a spike moves: the error of the salient fifth exceeds the whole by up to root five."""
    vertices, faces = grid(40)
    distance = np.linalg.norm(vertices[:, :2] - 0.5, axis=1)
    vertices[:, 2] = np.where(distance < 0.1, 0.1 - distance, 0)
    flat = vertices * (1, 1, 0)
    figures = judged((vertices, faces), (flat, faces))
    ratio = figures.rms_salient / figures.rms_original_to_simplified
    assert 1.5 < ratio <= np.sqrt(5) * 1.01


def test_a_named_region_is_judged_alone() -> None:
    vertices, faces = grid(8)
    raised = vertices + np.where(vertices[:, :1] > 0.7, 0.1, 0.0) * (0, 0, 1)
    judge = Judge(vertices, faces, {"left": lambda points: points[:, 0] < 0.5})
    figures = judge(raised, faces)
    assert figures.rms_regions["left"] == pytest.approx(0, abs=1e-9)
    assert figures.rms > 1


def test_unreferenced_vertices_do_not_count() -> None:
    vertices, faces = grid(3)
    stray = np.concatenate([[(100.0, 0.0, 0.0)], vertices])
    figures = judged((stray, faces + 1), (stray, faces + 1))
    assert (figures.max, figures.euler) == (pytest.approx(0, abs=1e-9), 1)


def test_samples_cover_the_surface_by_area() -> None:
    """A face of three quarters of the area gets three quarters of the samples, to one."""
    vertices = [(0, 0, 0), (4, 0, 0), (0, 1, 0), (3, 0, 0)]
    surface = Surface(vertices, [(0, 3, 2), (3, 1, 2)])
    counts = np.bincount(surface.sample(1000, seed=5).faces)
    assert counts == pytest.approx([750, 250], abs=1)


def test_no_faces_is_refused() -> None:
    with pytest.raises(ValueError, match="at least one face"):
        Surface(np.zeros((3, 3)), np.zeros((0, 3), int))
