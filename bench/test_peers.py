# SPDX-License-Identifier: GPL-3.0-or-later
"""The peer benchmark: its pure parts always, each peer's adapter where the peer is set up."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import compare_peers
import library_worker
import memory
import numpy as np
import pytest
import tables
from binary_mesh import read_binary, write_binary
from cell_search import nearest_cell
from decimators import DEFAULT_PLUGIN
from matplotlib.image import imread
from meshes import read_mesh, shipped
from peers.adapters import Goal, Library, Program
from peers.labels import Box, place
from peers.large import Large, make
from peers.machine import look
from peers.mesh_files import MeshFiles
from peers.plot import draw_summary, points
from peers.policies import (
    BALANCED,
    BASELINE,
    BEST,
    CORE,
    CORE_FAST,
    FAST,
    MESHOPTIMIZER_UPDATE,
    OURS,
    matching,
)
from peers.policies import every_policy as policies_of
from peers.records import Record, Results, load
from peers.report import every_table
from peers.summary import best_peer, failed_baselines, geometric_mean, means, standings
from shape import shape_of, smallest_angles
from surface import Surface
from workers import FilterError

POLICIES = policies_of(DEFAULT_PLUGIN)
COW_FACES, TARGET = 5804, 1160

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
THREE_ON_AN_EDGE = (
    np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1)], dtype=float),
    np.array([(0, 1, 2), (1, 0, 3), (0, 1, 4)]),
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


# --- the table of policies ------------------------------------------------------------------------


def test_every_policy_has_a_name_of_its_own() -> None:
    names = [policy.name for policy in POLICIES]
    assert len(set(names)) == len(names)


@pytest.mark.parametrize("name", [FAST, CORE_FAST, BALANCED, BEST, BASELINE, MESHOPTIMIZER_UPDATE])
def test_what_the_summary_speaks_of_is_in_the_table(name: str) -> None:
    assert name in {policy.name for policy in POLICIES}


def test_every_peer_is_there_and_every_library_policy_is_known_to_the_worker() -> None:
    assert {policy.peer for policy in POLICIES} == {
        *(OURS, CORE, "MeshLab", "CGAL", "OpenMesh", "meshoptimizer"),
        *("VTK", "libigl", "fast-simplification", "Open3D"),
    }
    used = {p.adapter.policy for p in POLICIES if isinstance(p.adapter, Library)}
    assert used == set(library_worker.POLICIES)


def test_peers_that_depend_on_the_unit_are_there_in_both() -> None:
    for peer in ("MeshLab", "Open3D", "fast-simplification"):
        diagonals = {policy.diagonal for policy in POLICIES if policy.peer == peer}
        assert diagonals == {None, 1000.0}


@pytest.mark.parametrize(
    ("patterns", "peers"),
    [(["cgal*"], {"CGAL"}), (["CGAL*", "OpenMesh*"], {"CGAL", "OpenMesh"}), (["cow"], set())],
)
def test_patterns_choose_policies(patterns: list[str], peers: set[str]) -> None:
    assert {policy.peer for policy in matching(POLICIES, patterns)} == peers


# --- statistics -----------------------------------------------------------------------------------


def record(policy: str, rms: float, seconds: float = 1.0, **changes: object) -> Record:
    """A run to 1,160 faces; its peer is the first word of the policy."""
    figures = dict.fromkeys(("rms", "mean", "max", "rms_salient", "ndev"), rms)
    figures |= dict.fromkeys(("angle_mean", "angle_low"), 10.0)
    counts = ("nm_edges", "nm_vertices", "flipped", "zero_area", "dup_faces")
    figures |= dict.fromkeys((*counts, "self_intersecting", "boundary", "components"), 0)
    plain = Record(
        mesh="cow.obj",
        fraction=0.2,
        target=TARGET,
        faces_before=COW_FACES,
        policy=policy,
        peer=policy.split()[0],
        faces=TARGET,
        seconds=[seconds],
        peak_bytes=[58040],
        figures=figures,
    )
    return replace(plain, **changes)


CASE = [
    record(BEST, 0.08, 4.0),
    record(BALANCED, 0.09, 2.0),
    record(FAST, 0.10, 0.5),
    record(BASELINE, 0.20, 8.0),
    record("CGAL Lindstrom-Turk", 0.10, 16.0),
    record(MESHOPTIMIZER_UPDATE, 0.21, 1.0),
]


def results(records: list[Record]) -> Results:
    machine = {"processor": "abacus"}
    return Results("2026-01-01", machine, {"CGAL": "5.5"}, {"VTK": "no wheel"}, {}, records)


def test_geometric_means() -> None:
    assert geometric_mean([2.0, 8.0]) == pytest.approx(4)
    assert geometric_mean([2.0, 8.0, 0.0, math.inf, None]) == pytest.approx(4)
    assert geometric_mean([0.0, None]) is None


def test_the_median_time_and_peak_of_a_record() -> None:
    three = record(BEST, 1.0, seconds=1.0)
    three = replace(three, seconds=[5.0, 1.0, 2.0], peak_bytes=[None, 58040, 58040])
    assert (three.time, three.peak, three.peak_per_face) == (2.0, 58040, 10.0)
    assert replace(three, peak_bytes=[None]).peak_per_face is None


def test_the_best_peer_is_not_ours_nor_above_the_target_nor_failed() -> None:
    above = record("VTK DecimatePro", 0.01, faces=3120)
    failed = record("OpenMesh quadric", 0.01, failure="refused")
    core = record(CORE_FAST, 0.01, peer=CORE)
    best = best_peer([*CASE, above, failed, core])
    assert best is not None
    assert best.policy == "CGAL Lindstrom-Turk"
    assert best_peer(CASE[:3]) is None


def test_standings_compare_with_the_best_peer_and_with_simplify_with_update() -> None:
    (standing,) = standings(CASE)
    assert standing.best == pytest.approx(0.8)
    assert standing.balanced == pytest.approx(0.9)
    assert standing.fast_time == pytest.approx(0.5)
    assert standing.fast_rms == pytest.approx(0.10 / 0.21)
    assert standing.core_time is None
    assert standing.missed == []


def test_the_core_is_held_to_the_time_of_simplify_with_update() -> None:
    (standing,) = standings([*CASE, record(CORE_FAST, 0.10, 1.1, peer=CORE)])
    assert standing.core_time == pytest.approx(1.1)
    assert standing.missed == ["its core's"]


@pytest.mark.parametrize(
    ("index", "worse", "missed"),
    [
        (0, {"rms": 0.091}, "Best"),
        (1, {"rms": 0.101}, "Balanced"),
        (2, {"rms": 0.22}, "Fast's RMS"),
        (2, {"rms": 0.1, "seconds": 1.1}, "Fast's time"),
    ],
)
def test_a_bar_that_is_not_reached_is_named(index: int, worse: dict, missed: str) -> None:
    records = list(CASE)
    records[index] = record(CASE[index].policy, **worse)
    assert standings(records)[0].missed == [missed]


def test_nothing_is_said_about_what_was_not_measured() -> None:
    (standing,) = standings([CASE[0], CASE[4]])
    assert standing.best == pytest.approx(0.8)
    assert (standing.balanced, standing.fast_time, standing.fast_rms) == (None, None, None)
    assert standings(CASE[:3]) == []
    assert standings(CASE[3:]) == []


def test_errors_are_no_ratio_where_the_baseline_fails() -> None:
    failing = [replace(r, mesh="fandisk.obj") for r in CASE]
    failing[3] = replace(failing[3], figures=CASE[3].figures | {"rms": 0.51})
    assert failed_baselines([*CASE, *failing]) == [("fandisk.obj", 0.2)]
    best = next(each for each in means([*CASE, *failing]) if each.policy == BEST)
    assert best.cases == 1
    assert best.means["rms"] == pytest.approx(0.4)
    assert best.means["time"] == pytest.approx(0.5)


def test_errors_of_more_faces_are_no_ratio() -> None:
    above = record("VTK DecimatePro", 0.01, faces=3120)
    mean = next(each for each in means([*CASE, above]) if each.policy == above.policy)
    assert mean.cases == 0
    assert mean.means["rms"] is None
    assert mean.means["time"] == pytest.approx(1 / 8)


# --- what is shown --------------------------------------------------------------------------------


def markdown(folder: Path, shown: list[tables.Table]) -> str:
    tables.save_markdown(folder / "peers.md", "Peers", [], shown)
    return (folder / "peers.md").read_text(encoding="utf-8").replace(" ", "")


def test_the_tables_have_every_policy_the_reasons_and_the_bars(tmp_path: Path) -> None:
    failed = record("OpenMesh quadric", 0.01, failure="OpenMesh on cow: exit code 3\nno manifold")
    text = markdown(tmp_path, every_table(results([*CASE, failed])))
    assert "cow.obj:5,804facesto20%,1,160" in text
    assert f"|{BASELINE}|1160|8000|1.000|0.058|10|0.2000|".replace(" ", "") in text
    assert "|OpenMeshquadric|cow.obj|20%|nomanifold|" in text
    assert "|VTK|nowheel|" in text
    assert "|cow.obj|20%|CGALLindstrom-Turk|0.1000|0.800|0.900|0.500|-|0.476||" in text


def test_without_a_baseline_there_are_no_ratios(tmp_path: Path) -> None:
    text = markdown(tmp_path, every_table(results([CASE[4]])))
    assert "|CGALLindstrom-Turk|1160|16000|-|" in text
    assert "Geometricmeans" not in text


def test_a_face_count_above_the_target_has_a_star(tmp_path: Path) -> None:
    text = markdown(tmp_path, every_table(results([*CASE, record("VTK x", 1.0, faces=3120)])))
    assert "|VTKx|3120*|" in text
    assert "1160*" not in text


def test_large_meshes_have_time_and_memory_only(tmp_path: Path) -> None:
    text = markdown(tmp_path, every_table(results([replace(CASE[3], figures={})])))
    assert "|policy|faces|ms|time|MB|B/face|\n" in text
    assert "|policy|cases|time|memory|\n" in text
    assert "flip" not in text


def test_results_come_back_from_their_file(tmp_path: Path) -> None:
    results(CASE).save(tmp_path / "deep/peers.json")
    assert load(tmp_path / "deep/peers.json") == results(CASE)


def test_labels_cover_neither_each_other_nor_a_point() -> None:
    frame = Box(0, 0, 800, 600)
    middle = [(400.0 + 3 * i, 300.0 + 2 * i) for i in range(12)]
    anchors = [*middle, (790.0, 590.0), (10.0, 10.0)]  # and two corners
    boxes = place(anchors, [(120.0, 14.0)] * len(anchors), frame)
    for i, box in enumerate(boxes):
        assert frame.contains(box)
        assert not any(box.overlaps(other) for other in boxes[:i])
        assert all(box.nearest(anchor) != anchor for anchor in anchors)


def test_the_picture_has_a_point_for_each_policy_with_an_error(tmp_path: Path) -> None:
    core = record(CORE_FAST, 0.10, peer=CORE)
    assert {point.policy for point in points([*CASE, core])} == {each.policy for each in CASE}
    draw_summary(CASE, tmp_path / "peers.png")
    assert np.ptp(imread(tmp_path / "peers.png")) > 0.5
    draw_summary([CASE[4]], tmp_path / "none.png")
    assert not (tmp_path / "none.png").exists()


# --- the command ----------------------------------------------------------------------------------


def options_of(monkeypatch: pytest.MonkeyPatch, *words: str) -> object:
    monkeypatch.setattr("sys.argv", ["compare_peers.py", *words])
    return compare_peers._options()


def test_what_is_saved_is_not_measured_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(compare_peers, "describe", lambda: {"processor": "abacus"})
    failed = replace(CASE[1], failure="late")
    results([CASE[0], failed]).save(tmp_path / "peers.json")
    options = options_of(monkeypatch, "--resume", "--fraction", "0.2")
    chosen = matching(POLICIES, [BEST, BALANCED])
    kept = compare_peers._start(options, look(), chosen, tmp_path / "peers.json")
    assert kept.records == [CASE[0]]
    mesh = MeshFiles("cow.obj", shipped("cow.obj"), tmp_path)
    todo = list(compare_peers._todo(options, chosen, [mesh], {r.key for r in kept.records}))
    assert [policy.name for policy in todo[0][2]] == [BALANCED]


def test_figures_of_two_machines_do_not_mix(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(compare_peers, "describe", lambda: {"processor": "slide rule"})
    results(CASE).save(tmp_path / "peers.json")
    options = options_of(monkeypatch, "--resume")
    with pytest.raises(SystemExit, match="another machine"):
        compare_peers._start(options, look(), POLICIES, tmp_path / "peers.json")


# --- the peers that are set up --------------------------------------------------------------------


def goal_on(folder: Path, mesh: Path, target: int = TARGET, patience: float = 120.0) -> Goal:
    return Goal(MeshFiles(mesh.name, mesh, folder), target, "a run", patience)


@pytest.fixture(scope="session")
def versions() -> dict[str, str]:
    """Of the peers that are there."""
    return look().versions


def tried() -> list:
    """The first policy of every peer, and whatever clusters or scales."""
    peers = set()
    chosen = []
    for policy in POLICIES:
        if policy.peer not in peers or policy.adapter.clusters or policy.diagonal:
            chosen.append(pytest.param(policy, id=policy.name))
        peers.add(policy.peer)
    return chosen


@pytest.mark.parametrize("policy", tried())
def test_a_peer_comes_near_the_target_in_the_mesh_s_own_unit(
    policy: object, versions: dict[str, str], tmp_path: Path
) -> None:
    if policy.peer not in versions:
        pytest.skip(f"{policy.peer} is not set up")
    goal = replace(goal_on(tmp_path, shipped("cow.obj")), diagonal=policy.diagonal)
    if policy.adapter.clusters:
        goal = replace(goal, cell=policy.adapter.find_cell(goal))
    outcome = policy.adapter.run(goal)
    assert len(outcome.faces) == pytest.approx(TARGET, rel=0.03)
    assert 0 < outcome.seconds < 60
    assert outcome.peak_bytes is None or 0 < outcome.peak_bytes < 100e6
    extent = np.ptp(goal.mesh.arrays[0], axis=0)
    used = outcome.vertices[np.unique(outcome.faces)]
    np.testing.assert_allclose(np.ptp(used, axis=0), extent, rtol=0.1)


@pytest.mark.parametrize(("peer", "policy"), [("CGAL", "plane"), ("OpenMesh", "quadric")])
def test_a_mesh_that_is_no_manifold_is_refused(
    peer: str, policy: str, versions: dict[str, str], tmp_path: Path
) -> None:
    if peer not in versions:
        pytest.skip(f"{peer} is not set up")
    write_binary(tmp_path / "fan.bin", *THREE_ON_AN_EDGE)
    with pytest.raises(FilterError, match="not an oriented manifold"):
        Program(peer.lower(), policy).run(goal_on(tmp_path, tmp_path / "fan.bin", 1))


def test_a_policy_that_a_program_does_not_know_is_an_error(
    versions: dict[str, str], tmp_path: Path
) -> None:
    if "meshoptimizer" not in versions:
        pytest.skip("meshoptimizer is not set up")
    with pytest.raises(FilterError, match="meshoptimizer: no Faster"):
        Program("meshoptimizer", "update+Faster").run(goal_on(tmp_path, shipped("cow.obj")))


def test_a_program_that_is_not_there_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(FilterError, match="no_such_program"):
        Program("no_such_program", "plane").run(goal_on(tmp_path, shipped("cow.obj")))


def test_patience_ends(tmp_path: Path) -> None:
    slow = next(policy for policy in POLICIES if policy.name == BASELINE)
    with pytest.raises(FilterError, match=r"MeshLab on cow.* no end after 0\.01 s"):
        slow.adapter.run(goal_on(tmp_path, shipped("cow.obj"), patience=0.01))
