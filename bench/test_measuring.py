# SPDX-License-Identifier: GPL-3.0-or-later
"""What the peer benchmark measures with: memory, files, shapes, the search for a cell."""

from __future__ import annotations

import math
from pathlib import Path

import memory
import numpy as np
import pytest
from binary_mesh import read_binary, write_binary
from cell_search import nearest_cell
from meshes import read_mesh, shipped
from peers.large import Large, make
from peers.mesh_files import MeshFiles
from shape import shape_of, smallest_angles
from surface import Surface

COW_FACES = 5804

# --- drawn meshes ---------------------------------------------------------------------------------

EQUILATERAL = Surface([(0, 0, 0), (1, 0, 0), (0.5, math.sqrt(0.75), 0)], [(0, 1, 2)])
NEEDLE = Surface([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [(0, 1, 2)])  # without area
APART = Surface(
    [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 9), (1, 0, 9), (0, 1, 9)], [(0, 1, 2), (3, 4, 5)]
)
CROSSING = Surface(
    [(0, 0, 0), (2, 0, 0), (0, 2, 0), (0.5, 0.5, -1), (0.5, 0.5, 1), (1, 0.2, 1)],
    [(0, 1, 2), (3, 4, 5)],
)


# --- memory ---------------------------------------------------------------------------------------

STATUS = "Name:\tpython\nVmHWM:\t    3000 kB\nVmRSS:\t    1000 kB\nThreads:\t1\n"


def test_a_status_line_is_read_in_bytes() -> None:
    assert memory.status_bytes(STATUS, "VmRSS") == 1000 * 1024


@pytest.mark.parametrize("name", ["VmSwap", "HWM", "Name"])
def test_a_line_that_is_not_there_is_unknown(name: str) -> None:
    assert memory.status_bytes(STATUS, name) is None


def test_growth_is_from_the_resident_set_before_to_the_peak_after() -> None:
    assert memory.growth(STATUS, STATUS.replace("3000", "5000")) == 4000 * 1024
    assert memory.growth("", STATUS) is None


def test_memory_that_a_call_frees_again_is_counted() -> None:
    size = 64 * 2**20
    result, seconds, peak = memory.measure(lambda: len(np.ones(size, dtype=np.uint8)))
    if peak is None:
        pytest.skip("this kernel does not forget the peak")
    assert result == size
    assert seconds > 0
    assert 0.98 * size < peak < 1.3 * size  # the kernel counts in steps
    assert memory.measure(lambda: None)[2] < size / 10


# --- files ----------------------------------------------------------------------------------------


def test_a_binary_mesh_comes_back_to_the_bit(tmp_path: Path) -> None:
    vertices, faces = np.array([(1 / 3, 1e-300, -0.0)] * 3), np.array([(0, 1, 2)])
    write_binary(tmp_path / "mesh.bin", vertices, faces)
    read = read_binary(tmp_path / "mesh.bin")
    np.testing.assert_array_equal(read[0], vertices)
    np.testing.assert_array_equal(read[1], faces)


def test_a_binary_mesh_that_ends_early_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "mesh.bin"
    write_binary(path, np.zeros((3, 3)), np.array([(0, 1, 2)]))
    path.write_bytes(path.read_bytes()[:-1])
    with pytest.raises(ValueError, match="ends too early"):
        read_binary(path)


def test_a_scaled_file_has_the_diagonal_and_the_plain_one_the_coordinates(tmp_path: Path) -> None:
    mesh = MeshFiles("cow.obj", shipped("cow.obj"), tmp_path)
    plain, scaled = read_binary(mesh.binary())[0], read_binary(mesh.binary(1000.0))[0]
    np.testing.assert_array_equal(plain, mesh.arrays[0])
    assert np.linalg.norm(np.ptp(scaled, axis=0)) == pytest.approx(1000)
    np.testing.assert_array_equal(read_mesh(mesh.ply())[0], mesh.arrays[0])


def test_a_subdivided_mesh_is_made_once(tmp_path: Path) -> None:
    path = make(Large("cow.obj", 1), shipped("cow.obj"), tmp_path)
    assert len(read_binary(path)[1]) == 4 * COW_FACES
    path.write_bytes(b"kept")
    assert make(Large("cow.obj", 1), shipped("cow.obj"), tmp_path).read_bytes() == b"kept"


# --- shape ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(("surface", "angle"), [(EQUILATERAL, 60), (APART, 45), (NEEDLE, 0)])
def test_the_smallest_angle_of_drawn_faces(surface: Surface, angle: float) -> None:
    assert smallest_angles(surface) == pytest.approx(angle)


def test_pieces_and_faces_that_cut_another_are_counted() -> None:
    apart, crossing = shape_of(APART), shape_of(CROSSING)
    assert (apart.components, apart.self_intersecting) == (2, 0)
    assert (crossing.components, crossing.self_intersecting) == (2, 2)
    assert shape_of(EQUILATERAL).components == 1


# --- the search for a cell ------------------------------------------------------------------------


def test_the_cell_meets_a_target_that_a_cell_leaves() -> None:
    cell = nearest_cell(lambda size: round(1 / size**2), 1160)
    assert round(1 / cell**2) == pytest.approx(1160, abs=1)


def test_the_nearest_count_wins_where_the_counts_jump() -> None:
    counts = {True: 1000, False: 1300}
    cell = nearest_cell(lambda size: counts[size > 0.03], 1100)
    assert cell > 0.03
    assert nearest_cell(lambda size: counts[size > 0.03], 1200.0 + 1) <= 0.03


@pytest.mark.parametrize(("count", "end"), [(10, 1e-4), (10**9, 0.5)])
def test_a_target_out_of_reach_ends_at_the_nearest_end(count: int, end: float) -> None:
    assert nearest_cell(lambda _: count, 1000) > 0
    visited: list[float] = []
    nearest_cell(lambda size: visited.append(size) or count, 1000)
    assert visited[-1] == pytest.approx(end, rel=1e-3)
