# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the sample meshes of this folder; the same bytes every time, on every machine.

    python sample_meshes/generate.py [FOLDER]

Coordinates are written with eight decimals, so that the last bit of a sine does not matter.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

_TURN = 2 * np.pi


@dataclass(frozen=True)
class Mesh:
    """Vertices (n, 3), faces (m, 3) anticlockwise from outside, and what else a file may carry.

    colors: (n, 3), 0..255. texture: (n, 2), 0..1, per vertex.
    """

    vertices: Floats
    faces: Ints
    colors: Ints | None = None
    texture: Floats | None = None


# --- building blocks ---------------------------------------------------------------------------


def lattice(
    columns: int, rows: int, around: bool = False, over: bool = False
) -> tuple[Floats, Ints]:
    """Parameters (n, 2) in 0..1 and faces (m, 3) of columns x rows cells.

    `around` joins the last column to the first, `over` the last row to the first.
    """
    across, down = columns + (not around), rows + (not over)
    j, i = np.divmod(np.arange(across * down), across)
    parameters = np.stack([i / columns, j / rows], axis=1)
    y, x = np.divmod(np.arange(columns * rows), columns)
    right, up = (x + 1) % across, (y + 1) % down
    a, b, c, d = y * across + x, y * across + right, up * across + right, up * across + x
    return parameters, np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def on_sphere(level: int) -> tuple[Floats, Ints]:
    """An icosahedron whose triangles are split into four `level` times, on the unit sphere."""
    g = (1 + np.sqrt(5)) / 2
    ring = [(-1, g), (1, g), (-1, -g), (1, -g)]
    corners = [(x, y, 0) for x, y in ring] + [(0, x, y) for x, y in ring]
    corners += [(y, 0, x) for x, y in ring]
    vertices = np.array(corners, dtype=float)
    faces = np.array(_ICOSAHEDRON)
    for _ in range(level):
        vertices, faces = split_in_four(vertices, faces)
    return vertices / np.linalg.norm(vertices, axis=1)[:, None], faces


_ICOSAHEDRON = [
    *[(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11)],
    *[(1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8)],
    *[(3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9)],
    *[(4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)],
]


def split_in_four(vertices: Floats, faces: Ints) -> tuple[Floats, Ints]:
    """New vertices in the middle of every edge."""
    a, b, c = faces.T
    edges = np.sort(np.stack([np.stack([b, c]), np.stack([c, a]), np.stack([a, b])]), axis=1)
    ends, index = np.unique(np.moveaxis(edges, 1, 2).reshape(-1, 2), axis=0, return_inverse=True)
    bc, ca, ab = len(vertices) + index.reshape(3, -1)
    quarters = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    grown = np.concatenate([vertices, vertices[ends].mean(axis=1)])
    return grown, np.concatenate([np.stack(each, axis=1) for each in quarters])


def welded(vertices: Floats, faces: Ints) -> tuple[Floats, Ints]:
    """Vertices that agree to eight decimals become one."""
    _, first, merged = np.unique(
        vertices.round(8) + 0.0, axis=0, return_index=True, return_inverse=True
    )
    return vertices[first], merged.ravel()[faces]


def together(*parts: tuple[Floats, Ints]) -> tuple[Floats, Ints]:
    """The union of parts, not joined."""
    starts = np.cumsum([0, *(len(vertices) for vertices, _ in parts[:-1])])
    faces = [part[1] + start for part, start in zip(parts, starts, strict=True)]
    return np.concatenate([part[0] for part in parts]), np.concatenate(faces)


def square_side(cells: int, origin: tuple, along: tuple, up: tuple) -> tuple[Floats, Ints]:
    """A square of cells x cells from `origin`, spanned by `along` and `up`."""
    parameters, faces = lattice(cells, cells)
    return np.array(origin) + parameters @ np.array([along, up], dtype=float), faces


def cube(cells: int) -> tuple[Floats, Ints]:
    """The unit cube, each side of cells x cells squares."""
    x, y, z, o = (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, 0)
    spans = [(o, y, x), (z, x, y), (o, x, z), (y, z, x), (o, z, y), (x, y, z)]
    return welded(*together(*(square_side(cells, *span) for span in spans)))


# --- the meshes --------------------------------------------------------------------------------


def plane_grid() -> Mesh:
    return Mesh(*square_side(16, (0, 0, 0), (1, 0, 0), (0, 1, 0)))


def icosphere() -> Mesh:
    return Mesh(*on_sphere(3))


def cylinder_open() -> Mesh:
    (u, v), faces = _columns(lattice(48, 16, around=True))
    return Mesh(np.stack([np.cos(_TURN * u), np.sin(_TURN * u), 3 * v], axis=1), faces)


def cylinder_capped() -> Mesh:
    side = cylinder_open()
    (u, v), cap = _columns(lattice(48, 4, around=True))
    radius = 1 - 0.75 * v
    top = np.stack([radius * np.cos(_TURN * u), radius * np.sin(_TURN * u), 3 + 0 * u], axis=1)
    hub = np.array([(0.0, 0.0, 3.0)])
    rim = 4 * 48 + np.arange(48)
    fan = np.stack([rim, np.roll(rim, -1), np.full(48, len(top))], axis=1)
    lid = np.concatenate([top, hub]), np.concatenate([cap, fan])
    floor = lid[0] * (1, 1, 0), lid[1][:, ::-1]
    return Mesh(*welded(*together((side.vertices, side.faces), lid, floor)))


def cube_dense() -> Mesh:
    return Mesh(*cube(8))


def torus() -> Mesh:
    (u, v), faces = _columns(lattice(64, 24, around=True, over=True))
    radius = 1 + 0.35 * np.cos(_TURN * v)
    x, y = radius * np.cos(_TURN * u), radius * np.sin(_TURN * u)
    return Mesh(np.stack([x, y, 0.35 * np.sin(_TURN * v)], axis=1), faces)


def saddle() -> Mesh:
    (u, v), faces = _columns(lattice(24, 24))
    x, y = 2 * u - 1, 2 * v - 1
    return Mesh(np.stack([x, y, 0.5 * (x * x - y * y)], axis=1), faces)


def bumpy_sphere() -> Mesh:
    directions, faces = on_sphere(4)
    x, y, z = directions.T
    share = np.clip((z - 0.1) / 0.3, 0, 1) ** 2  # of the bumps: none below z = 0.1
    bumps = np.sin(23 * x) * np.sin(19 * y) + 0.5 * np.sin(41 * x + 37 * y)
    return Mesh(directions * (1 + 0.02 * share * bumps)[:, None], faces)


def two_spheres() -> Mesh:
    vertices, faces = on_sphere(3)
    small, few = on_sphere(1)
    return Mesh(*together((vertices, faces), (0.02 * small + (1.5, 0, 0), few)))


def fan() -> Mesh:
    spokes = 512
    turn = _TURN * np.arange(spokes) / spokes
    rim = np.stack([np.cos(turn), np.sin(turn), 0.1 * np.cos(5 * turn)], axis=1)
    index = np.arange(spokes)
    faces = np.stack([index, np.roll(index, -1), np.full(spokes, spokes)], axis=1)
    return Mesh(np.concatenate([rim, [(0.0, 0.0, 0.3)]]), faces)


def colored_patch() -> Mesh:
    (u, v), faces = _columns(lattice(20, 20))
    height = 0.1 * np.sin(_TURN * u) * np.sin(_TURN * v)
    colors = np.stack([255 * u, 255 * v, 128 + 0 * u], axis=1).round().astype(np.int64)
    return Mesh(np.stack([u, v, height], axis=1), faces, colors=colors)


def textured_patch() -> Mesh:
    (u, v), faces = _columns(lattice(20, 20))
    height = 0.1 * np.cos(_TURN * u) * np.cos(_TURN * v)
    texture = np.stack([u, v], axis=1)
    return Mesh(np.stack([2 * u, v, height], axis=1), faces, texture=texture)


def nonmanifold_edge() -> Mesh:
    pages = []
    for third in range(3):
        turn = _TURN * third / 3
        pages.append(square_side(10, (0, 0, 0), (np.cos(turn), np.sin(turn), 0), (0, 0, 1)))
    return Mesh(*welded(*together(*pages)))


def nonmanifold_vertex() -> Mesh:
    vertices, faces = on_sphere(2)
    first = vertices - vertices[0]
    return Mesh(*welded(*together((first, faces), (-first, faces[:, ::-1]))))


def moebius() -> Mesh:
    (u, v), faces = _columns(lattice(60, 6))
    turn, across = _TURN * u, (v - 0.5) * 0.6
    radius = 1 + across * np.cos(turn / 2)
    x, y = radius * np.cos(turn), radius * np.sin(turn)
    return Mesh(*welded(np.stack([x, y, across * np.sin(turn / 2)], axis=1), faces))


def unwelded_cube() -> Mesh:
    cube = cube_dense()
    return Mesh(
        cube.vertices[cube.faces].reshape(-1, 3), np.arange(3 * len(cube.faces)).reshape(-1, 3)
    )


def dirty_sphere() -> Mesh:
    vertices, faces = on_sphere(2)
    unused, same_place = (0.0, 0.0, 2.0), vertices[faces[5, 0]]
    twice = faces[:3]
    no_area = (faces[5, 0], faces[5, 1], len(vertices) + 1)
    grown = np.concatenate([vertices, [unused, same_place]])
    return Mesh(grown, np.concatenate([faces, twice, [no_area]]))


def _columns(parts: tuple[Floats, Ints]) -> tuple[Floats, Ints]:
    return parts[0].T, parts[1]


MESHES: dict[str, Callable[[], Mesh]] = {
    "plane_grid.ply": plane_grid,
    "icosphere.ply": icosphere,
    "cylinder_open.ply": cylinder_open,
    "cylinder_capped.ply": cylinder_capped,
    "cube_dense.ply": cube_dense,
    "torus.ply": torus,
    "saddle.ply": saddle,
    "bumpy_sphere.ply": bumpy_sphere,
    "two_spheres.ply": two_spheres,
    "fan.ply": fan,
    "colored_patch.ply": colored_patch,
    "textured_patch.obj": textured_patch,
    "nonmanifold_edge.ply": nonmanifold_edge,
    "nonmanifold_vertex.ply": nonmanifold_vertex,
    "moebius.ply": moebius,
    "unwelded_cube.ply": unwelded_cube,
    "dirty_sphere.ply": dirty_sphere,
}


# --- files -------------------------------------------------------------------------------------


def as_ply(mesh: Mesh) -> str:
    header = ["ply", "format ascii 1.0", f"element vertex {len(mesh.vertices)}"]
    header += [f"property double {axis}" for axis in "xyz"]
    if mesh.colors is not None:
        header += [f"property uchar {name}" for name in ("red", "green", "blue")]
    header += [f"element face {len(mesh.faces)}", "property list uchar int vertex_indices"]
    rows = [_decimals(point) for point in mesh.vertices]
    if mesh.colors is not None:
        rows = [f"{row} {r} {g} {b}" for row, (r, g, b) in zip(rows, mesh.colors, strict=True)]
    rows += [f"3 {a} {b} {c}" for a, b, c in mesh.faces]
    return "\n".join([*header, "end_header", *rows, ""])


def as_obj(mesh: Mesh) -> str:
    rows = [f"v {_decimals(point)}" for point in mesh.vertices]
    if mesh.texture is None:
        rows += [f"f {a} {b} {c}" for a, b, c in mesh.faces + 1]
    else:
        rows += [f"vt {_decimals(point)}" for point in mesh.texture]
        rows += [f"f {a}/{a} {b}/{b} {c}/{c}" for a, b, c in mesh.faces + 1]
    return "\n".join([*rows, ""])


def _decimals(point: Floats) -> str:
    """Eight decimals, without trailing zeros and without a negative zero."""
    return " ".join(f"{number:.8f}".rstrip("0").rstrip(".") for number in point.round(8) + 0.0)


def write(folder: Path) -> None:
    """Every mesh into `folder`."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, build in MESHES.items():
        text = as_obj(build()) if name.endswith(".obj") else as_ply(build())
        (folder / name).write_text(text, encoding="ascii", newline="\n")


if __name__ == "__main__":
    write(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent)
