# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes that are hard to simplify for another reason than their curvature.

Many holes, many parts of very different sizes, long thin faces, many loose leaves. Each is drawn
here from a few numbers, the same every time.
"""

from __future__ import annotations

import sys

import numpy as np
from meshes import REPOSITORY
from surface import Floats, Ints

sys.path.insert(0, str(REPOSITORY / "sample_meshes"))
from generate import lattice, on_sphere, together, welded

Mesh = tuple[Floats, Ints]

_TURN = 2 * np.pi


def plate(cells: int = 12, steps: int = 8) -> Mesh:
    """A closed plate with cells x cells round holes through it, the radii growing along x.

    steps: edges along a side of a cell, of which the plate has one around every hole.
    """
    parts = []
    for x in range(cells):
        radius = 0.12 + 0.28 * x / max(cells - 1, 1)
        vertices, faces = _holed_cell(radius, steps)
        parts += [(vertices + (x, y, 0), faces) for y in range(cells)]
    return welded(*together(*parts, _walls(cells, steps)))


_THICKNESS = 0.5  # of the plate; its cells have sides of 1


def _holed_cell(radius: float, steps: int) -> Mesh:
    """Both sides of a cell around the origin and the wall of its hole; its outer rim is open."""
    square = _square(steps)
    circle = radius * square / np.linalg.norm(square, axis=1)[:, None]
    shares = np.linspace(0, 1, 4)  # from the rim to the hole
    outlines = [(1 - share) * square + share * circle for share in shares]
    heights = np.linspace(0.5, -0.5, 4) * _THICKNESS
    rings = [(outline, heights[0]) for outline in outlines]
    rings += [(circle, height) for height in heights[1:-1]]
    rings += [(outline, heights[-1]) for outline in outlines[::-1]]
    return _sleeve(rings)


def _walls(cells: int, steps: int) -> Mesh:
    """What closes the plate around."""
    around = (_square(cells * steps) + 0.5) * cells - 0.5
    return _sleeve([(around, height) for height in np.linspace(-0.5, 0.5, 4) * _THICKNESS])


def _square(steps: int) -> Floats:
    """(4 steps, 2): the outline of the unit square about the origin, anticlockwise."""
    tick = np.arange(steps) / steps - 0.5
    half = np.full(steps, 0.5)
    sides = [(tick, -half), (half, tick), (-tick, half), (-half, -tick)]
    return np.concatenate([np.stack(side, axis=1) for side in sides])


def _sleeve(rings: list[tuple[Floats, float]], over: bool = False) -> Mesh:
    """Outlines (n, 2) at their heights, each joined to the next; `over`: the last to the first."""
    faces = lattice(len(rings[0][0]), len(rings) - (not over), around=True, over=over)[1]
    return np.concatenate([np.insert(outline, 2, z, axis=1) for outline, z in rings]), faces


def balls(count: int = 200, level: int = 2) -> Mesh:
    """Balls that do not touch, with equally many faces and radii of 0.02 to 1.

    level: how often each face of an icosahedron is split into four.
    """
    random = np.random.default_rng(1)
    radii = np.sort(0.02 * 50 ** random.random(count) ** 2)[::-1]
    centres: list[Floats] = []
    for index, radius in enumerate(radii):
        centres.append(_free_place(random, np.array(centres).reshape(-1, 3), radii[:index], radius))
    vertices, faces = on_sphere(level)
    return together(*((r * vertices + c, faces) for r, c in zip(radii, centres, strict=True)))


def _free_place(random: np.random.Generator, centres: Floats, radii: Floats, own: float) -> Floats:
    while True:
        place = random.uniform((-5, -3.6, -2), (5, 3.6, 2))
        if (np.linalg.norm(centres - place, axis=1) > radii + own + 0.02).all():
            return place


def gear(teeth: int = 48, steps: int = 40) -> Mesh:
    """A gear wheel with a hub and a bore: all its faces reach from edge to edge of the part.

    steps: edges along the outline of a tooth.
    """
    turn = _TURN * np.arange(teeth * steps) / (teeth * steps)
    circle = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    wave = np.cos(teeth * turn)
    teeth_radius = 1 + 0.045 * np.clip(2.2 * wave, -1, 1)  # flat tops and grounds, steep flanks
    outline = teeth_radius[:, None] * circle
    half = [(0.25, 0.3), (0.42, 0.3), (0.42, 0.1), (0.8, 0.1), (0.8, 0.17)]  # radius, height
    upper = [(radius * circle, height) for radius, height in half]
    rings = [*upper, (outline, 0.17), (outline, -0.17)]
    return _sleeve([(ring, -z) for ring, z in upper] + rings[::-1], over=True)


def tree(leaves: int = 3000) -> Mesh:
    """A trunk and loose leaves of four faces each around it."""
    random = np.random.default_rng(2)
    vertices, faces = _leaf()
    sizes = 0.07 + 0.17 * random.random(leaves) ** 2
    turns = np.linalg.qr(random.normal(size=(leaves, 3, 3)))[0]
    placed = np.einsum("l,lij,vj->lvi", sizes, turns, vertices)
    placed += _crown(random, leaves)[:, None]
    every = np.arange(leaves)[:, None, None] * len(vertices) + faces
    return together((placed.reshape(-1, 3), every.reshape(-1, 3)), _trunk())


def _leaf() -> Mesh:
    """A pointed leaf, folded along its middle."""
    vertices = [(0, 0, 0), (0.4, 0.25, 0.08), (0.4, 0, 0), (0.4, -0.25, 0.08), (1, 0, 0)]
    return np.array(vertices, float), np.array([(0, 2, 1), (0, 3, 2), (4, 1, 2), (4, 2, 3)])


def _crown(random: np.random.Generator, count: int) -> Floats:
    """(count, 3): places in a hull around the trunk's top, most of them outside."""
    directions = random.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    return directions * random.uniform(0.4, 1, (count, 1)) ** (1 / 3) + (0, 0, 2)


def _trunk() -> Mesh:
    """A closed tapered rod."""
    turn = _TURN * np.arange(32) / 32
    circle = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    sides = [((0.2 - 0.04 * height) * circle, height) for height in np.linspace(0, 2, 17)]
    vertices, faces = _sleeve([(0 * circle, 0.0), *sides, (0 * circle, 2.0)])
    vertices, faces = welded(vertices, faces)
    return vertices, faces[(faces != np.roll(faces, 1, axis=1)).all(axis=1)]  # one fan at an end
