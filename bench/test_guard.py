# SPDX-License-Identifier: GPL-3.0-or-later
"""The speed guard: what it compares, and when it fails."""

from __future__ import annotations

import subprocess
from pathlib import Path

import commits
import guard
import numpy as np
import pytest
from judge import topology
from surface import Surface

BEFORE = {(mesh, preset): 1.0 for mesh in ("a", "b") for preset in guard.PRESETS}


def with_best(first: float, second: float) -> dict[tuple[str, str], float]:
    """The same times, but for Best on the two meshes."""
    return BEFORE | {("a", "Best"): first, ("b", "Best"): second}


def test_a_quarter_more_passes_and_what_is_above_fails() -> None:
    assert guard.slower(BEFORE, BEFORE) == {}
    assert guard.slower(BEFORE, with_best(1.25, 1.24)) == {}
    assert guard.slower(BEFORE, with_best(1.26, 1.26)) == {"Best": pytest.approx(1.26)}


def test_the_mean_over_the_meshes_counts() -> None:
    assert guard.slower(BEFORE, with_best(2.0, 0.5)) == {}
    assert guard.mean_ratio(BEFORE, with_best(2.0, 0.5), "Best") == pytest.approx(1)
    assert "Best" in guard.slower(BEFORE, with_best(2.0, 1.0))


def test_more_runs_only_take_time_away(monkeypatch: pytest.MonkeyPatch) -> None:
    noisy = iter([3.0, 1.0, 2.0, 5.0] * 3)
    monkeypatch.setattr(guard, "_seconds", lambda *_: next(noisy))
    times = guard._race((Path("old"), Path("new")), {Path("a.bin"): 1}, 2, ({}, {}))
    assert max(*times[0].values(), *times[1].values()) <= 3.0
    again = guard._race((Path("old"), Path("new")), {}, 1, times)
    assert again == times


def test_the_torus_is_closed_and_of_genus_1_and_the_ridges_have_a_boundary() -> None:
    torus = topology(Surface(*guard.bumpy_torus(24, 12)))
    assert (torus["boundary"], torus["euler"], torus["nm_edges"]) == (0, 0, 0)
    ridges = topology(Surface(*guard.ridges(9)))
    assert (ridges["boundary"], ridges["euler"], ridges["zero_area"]) == (4 * 8, 1, 0)
    assert np.ptp(guard.ridges(9)[0][:, 2]) > 0.05


@pytest.fixture
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A checkout with one commit, whose core is one file."""
    monkeypatch.setattr(commits, "REPOSITORY", tmp_path)
    git(tmp_path, "init", "--quiet")
    (tmp_path / "vcg_ext").mkdir()
    commit(tmp_path, "vcg_ext/decimate.h", "first")
    return tmp_path


def git(folder: Path, *words: str) -> str:
    identity = ["-c", "user.name=Nobody", "-c", "user.email=nobody@invalid"]
    command = ["git", *identity, *words]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True)
    return done.stdout.strip()


def commit(folder: Path, name: str, text: str) -> str:
    """The commit that makes the file this text."""
    (folder / name).write_text(text, encoding="utf-8")
    git(folder, "add", name)
    git(folder, "commit", "--quiet", "-m", text)
    return git(folder, "rev-parse", "HEAD")


def test_the_base_is_the_commit_before_the_core_changed(repository: Path) -> None:
    first = git(repository, "rev-parse", "HEAD")
    commit(repository, "vcg_ext/decimate.h", "second")
    commit(repository, "README.md", "only words")
    assert guard._base(None) == first


def test_a_core_that_is_not_committed_is_compared_with_the_last_commit(repository: Path) -> None:
    head = git(repository, "rev-parse", "HEAD")
    (repository / "vcg_ext/decimate.h").write_text("being edited", encoding="utf-8")
    assert guard._base(None) == head


def test_a_first_commit_has_nothing_to_compare_with(repository: Path) -> None:
    with pytest.raises(commits.IncomparableError, match="no earlier commit"):
        guard._base(None)


def test_an_unknown_base_is_said(repository: Path) -> None:
    with pytest.raises(commits.IncomparableError, match="v9"):
        guard._base("v9")


def test_outside_a_checkout_there_is_nothing_to_compare_with(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(commits, "REPOSITORY", tmp_path)
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(tmp_path.parent))
    with pytest.raises(commits.IncomparableError):
        guard._base(None)
