# SPDX-License-Identifier: GPL-3.0-or-later
"""Every mesh: each defect is found where it is, and what ours falls short in is said."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import every_mesh
import every_mesh_worker
import numpy as np
import pytest
from decimators import Decimator, meshlab
from defects import defects
from every_mesh_rows import SHORTFALLS, Judged, Row, changes, from_json, of_answer, summary, to_json
from every_mesh_worker import Trial
from meshes import shipped, write_mesh
from surface import Surface
from test_judge import Mesh, grid, octasphere

SPHERE = octasphere(1.0, 2)
NO_DEFECTS = dict.fromkeys(defects(Surface(*SPHERE)), 0) | {"components": 1, "merged_components": 1}


def with_face(mesh: Mesh, *face: int) -> Mesh:
    """One more face."""
    return mesh[0], np.concatenate([mesh[1], [face]])


def unmerged(mesh: Mesh) -> Mesh:
    """Every face with three vertices of its own."""
    corners = mesh[0][mesh[1]]
    return corners.reshape(-1, 3), np.arange(corners.size // 3).reshape(-1, 3)


def with_fin() -> Mesh:
    """A third face at an edge of the sphere."""
    vertices, faces = SPHERE
    with_tip = np.concatenate([vertices, [(2.0, 2.0, 2.0)]])
    return with_face((with_tip, faces), *faces[0, :2], len(vertices))


def touching() -> Mesh:
    """Two squares with one vertex in common."""
    vertices, faces = grid(1)
    moved = np.concatenate([vertices, vertices[1:] + vertices[3]])
    return moved, np.concatenate([faces, np.where(faces == 0, 3, faces + 3)])


def folded() -> Mesh:
    """Two faces at one edge, the second turned onto the first."""
    return np.array([(0.0, 0, 0), (1, 0, 0), (0.5, 1, 0), (0.4, 0.8, 0)]), np.array(
        [(0, 1, 2), (1, 0, 3)]
    )


def folded_seam() -> Mesh:
    """The same, but each with its own vertices."""
    return unmerged(folded())


def needle() -> Mesh:
    """A face whose corners lie in a line."""
    return np.array([(0.0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 1, 0)]), np.array(
        [(0, 1, 2), (0, 2, 3)]
    )


@pytest.mark.parametrize(
    ("mesh", "found"),
    [
        (lambda: SPHERE, {}),
        (with_fin, {"nm_edges": 1, "boundary": 2}),
        (touching, {"nm_vertices": 1, "boundary": 8}),
        (folded, {"back_to_back": 2, "boundary": 4}),
        (lambda: with_face(SPHERE, *SPHERE[1][0, ::-1]), {"back_to_back": 2, "nm_edges": 3}),
        (needle, {"zero_area": 1, "boundary": 4}),
        (lambda: (SPHERE[0], SPHERE[1][1:]), {"boundary": 3}),
    ],
    ids=["none", "fin", "touching", "fold", "doubled", "needle", "hole"],
)
def test_each_defect_is_found_as_it_is_and_merged(
    mesh: Callable[[], Mesh], found: dict[str, int]
) -> None:
    merged = {f"merged_{name}": count for name, count in found.items()}
    assert defects(Surface(*mesh())) == NO_DEFECTS | found | merged


def test_merged_a_seam_is_no_border_and_a_missing_face_is_a_crack() -> None:
    vertices, faces = unmerged(SPHERE)
    whole, torn = Surface(vertices, faces), Surface(vertices, faces[1:])
    assert defects(whole)["boundary"] == 3 * len(faces)
    assert (defects(whole)["components"], defects(whole)["merged_components"]) == (len(faces), 1)
    assert defects(whole)["merged_boundary"] == 0
    assert defects(torn)["merged_boundary"] == 3


def test_a_face_that_merging_collapses_is_left_out() -> None:
    """A square whose two halves are joined by a face without width."""
    vertices = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (1, 1, 0)]
    found = defects(Surface(vertices, [(0, 1, 2), (0, 2, 4), (0, 4, 3)]))
    assert (found["boundary"], found["nm_edges"], found["zero_area"]) == (5, 0, 1)
    assert found["merged_boundary"] == 4
    assert found["merged_nm_edges"] == found["merged_zero_area"] == 0


def test_faces_back_to_back_across_a_seam_are_found_when_merged() -> None:
    found = defects(Surface(*folded_seam()))
    assert (found["back_to_back"], found["merged_back_to_back"]) == (0, 2)


def test_faces_turned_over_in_place_are_no_fold() -> None:
    vertices, faces = grid(3)
    faces[::2] = faces[::2, ::-1]
    assert defects(Surface(vertices, faces))["back_to_back"] == 0


def test_a_mesh_that_merging_leaves_no_face_of_has_no_merged_defects() -> None:
    found = defects(Surface([(0, 0, 0), (0, 0, 0), (-0.0, 0, 0)], [(0, 1, 2)]))
    assert found["zero_area"] == 1
    assert found["merged_zero_area"] == found["merged_components"] == 0


def row(faces: int = 20, mesh: str = "a.ply", rms: float = 1.0, **now: int) -> Row:
    """A sound mesh to 20 faces; now: the defects of ours."""
    sound = NO_DEFECTS | {"flipped": 0}
    other = Judged(20, 0.1, 0.5, 0.5, sound)
    ours = Judged(faces, 0.1, rms, 0.5, sound | now)
    return Row(mesh, 100, 20.0, 20, sound, ours, other)


@pytest.mark.parametrize(
    ("result", "what"),
    [
        (row(), []),
        (row(faces=21), []),
        (row(faces=22), ["target missed"]),
        (row(nm_vertices=1), ["manifold did not stay so"]),
        (row(boundary=3), ["closed did not stay so"]),
        (row(merged_boundary=3), ["cracks: closed, merged, did not stay so"]),
        (row(back_to_back=2), ["more back-to-back faces"]),
        (row(zero_area=1), ["more faces without area"]),
        (row(flipped=1), ["more flipped faces"]),
        (row(components=2), ["more pieces"]),
    ],
)
def test_what_ours_falls_short_in_is_named(result: Row, what: list[str]) -> None:
    named = [name for name, shown in SHORTFALLS.items() if shown(result, result.ours)]
    assert [name for name in named if name != "more border edges, merged"] == what
    assert not any(shown(result, result.meshlab) for shown in SHORTFALLS.values())


def test_new_defects_stand_in_the_row_once() -> None:
    assert row(boundary=3, merged_boundary=3).new == ["border edges 0>3/0"]
    assert row(boundary=0, merged_boundary=3).new == ["cracks 0>3/0"]


def test_a_result_that_failed_is_said_and_has_no_ratio() -> None:
    failed = replace(row(), ours=Judged(failure="exit code 1\nTraceback\nno such metric"))
    assert failed.ratio("rms") is None
    assert failed.cells()[-1] == "ours failed: no such metric"
    assert failed.new == []


def test_only_what_changed_is_listed_with_the_mean_of_all() -> None:
    before = [row(), row(mesh="b.ply"), row(mesh="c.ply")]
    now = [row(rms=4.0), row(mesh="b.ply", rms=1.005), row(mesh="c.ply", rms=0.25 / 1.005)]
    table = changes(before, now)
    assert list(table.columns[0].cells) == ["a.ply 20%", "c.ply 20%"]
    assert "3 cases: rms 1.000, max 1.000" in table.title


def test_means_leave_out_what_missed_its_target_and_the_summary_names_it() -> None:
    """Ratios 2 and 8 on target; the missed one would be 0.02."""
    rows = [row(rms=1.0), row(mesh="b.ply", rms=4.0), row(faces=40, mesh="c.ply", rms=0.01)]
    levels, shortfalls = ([list(column.cells) for column in each.columns] for each in summary(rows))
    all_cases = [cells[-1] for cells in levels]
    assert all_cases == ["all", "3", "1", "2", "4.000", "1.000", "2", "0", "0%"]
    named = dict(zip(shortfalls[0], shortfalls[-1], strict=True))
    assert named["target missed"] == "c.ply 20% (40 for 20)"
    assert (
        named["RMS above MeshLab's, MeshLab's above ours"] == "b.ply 20% (8.000), a.ply 20% (2.000)"
    )


def test_rows_are_saved_whole() -> None:
    rows = [row(nm_edges=2), replace(row(), ours=Judged(failure="crash"))]
    assert from_json(json.loads(json.dumps(to_json(rows)))) == rows


@pytest.fixture
def trial(tmp_path: Path) -> Trial:
    write_mesh(tmp_path / "sphere.ply", *octasphere(1.0, 3))
    return Trial(tmp_path / "sphere.ply", 1000, 60.0, tmp_path / "kept")


def test_meshlab_runs_once_and_ours_every_time(
    trial: Trial, monkeypatch: pytest.MonkeyPatch
) -> None:
    run, asked = every_mesh_worker.run_once, []

    def counted(path: Path, target: int, decimator: Decimator, patience: float) -> object:
        asked.append(decimator.name)
        return run(path, target, decimator, patience)

    monkeypatch.setattr(every_mesh_worker, "run_once", counted)
    first, second = (trial.at(20, meshlab("ours")) for _ in range(2))
    assert asked == ["ours", "MeshLab", "ours"]
    assert first["meshlab"] == second["meshlab"]
    trial.at(10, meshlab("ours"))
    replace(trial, samples=2000).at(10, meshlab("ours"))
    assert asked[3:] == ["ours", "MeshLab"] * 2


def test_a_trial_judges_both_at_the_level_of_the_faces_as_read(trial: Trial) -> None:
    answer = {"faces": 512, "before": trial.before(), "levels": [trial.at(20, meshlab("ours"))]}
    (result,) = of_answer("sphere.ply", answer)
    assert (result.target, result.ours.faces, result.meshlab.faces) == (102, 102, 102)
    assert result.before == NO_DEFECTS | {"flipped": 0}
    assert 0 < result.ours.rms < result.ours.max < 10
    assert result.ratio("rms") == 1


def test_a_filter_that_fails_is_told_in_its_row(trial: Trial) -> None:
    answer = trial.at(20, Decimator("Nobody", "no_such_filter"))
    assert "no_such_filter" in answer["ours"]["failure"]
    assert answer["meshlab"]["faces"] == 102


def test_a_filter_that_hangs_is_told_in_its_row(trial: Trial) -> None:
    assert (
        "no end after 0.01 s" in replace(trial, patience=0.01).at(20, meshlab())["ours"]["failure"]
    )


def test_files_of_one_name_are_told_apart(tmp_path: Path) -> None:
    for name in ("one/a.ply", "two/a.ply", "two/b.STL", "two/note.txt"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).touch()
    files = every_mesh.files_of([tmp_path / "one", tmp_path / "two"])
    assert list(every_mesh.named(files, "*")) == ["one/a.ply", "two/a.ply", "b.STL"]
    assert list(every_mesh.named(files, "b*")) == ["b.STL"]


def test_the_command_goes_on_after_a_mesh_that_cannot_be_read(tmp_path: Path) -> None:
    """Without a plugin to load ours fails; the row says so, and the JSON has both meshes."""
    (tmp_path / "broken.ply").write_text("no mesh", encoding="utf-8")
    (tmp_path / "no_plugin.so").touch()
    command = [sys.executable, every_mesh.__file__, tmp_path / "broken.ply", shipped("cube.obj")]
    command += ["--plugin", tmp_path / "no_plugin.so", "--levels", "50", "--samples", "1000"]
    done = subprocess.run(
        [*command, "--json", tmp_path / "out.json"],
        capture_output=True,
        encoding="utf-8",  # reading some formats, MeshLab sets the locale of this process to "C"
        check=False,
    )
    assert done.returncode == 1, done.stderr
    saved = json.loads((tmp_path / "out.json").read_text(encoding="utf-8"))
    assert list(saved["failures"]) == ["broken.ply"]
    assert [each["mesh"] for each in saved["rows"]] == ["cube.obj"]
    assert saved["rows"][0]["ours"]["failure"]
    assert saved["rows"][0]["meshlab"]["faces"] <= 6
