# SPDX-License-Identifier: GPL-3.0-or-later
"""The peer benchmark's table of policies, records, summary, reports and pictures."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import compare_peers
import library_worker
import numpy as np
import pytest
import tables
from decimators import DEFAULT_PLUGIN
from matplotlib.image import imread
from meshes import shipped
from peers.adapters import Library
from peers.labels import Box, place
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

POLICIES = policies_of(DEFAULT_PLUGIN)
COW_FACES, TARGET = 5804, 1160

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
        *("VTK", "libigl", "fast-simplification", "MeshLib", "Open3D", "Blender"),
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
