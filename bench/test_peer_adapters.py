# SPDX-License-Identifier: GPL-3.0-or-later
"""Each peer, by its adapter, where it is set up."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from binary_mesh import write_binary
from decimators import DEFAULT_PLUGIN
from meshes import shipped
from peers.adapters import Goal, Program
from peers.machine import look
from peers.mesh_files import MeshFiles
from peers.policies import (
    BASELINE,
)
from peers.policies import every_policy as policies_of
from workers import FilterError

POLICIES = policies_of(DEFAULT_PLUGIN)
TARGET = 1160  # faces of the cow
THREE_ON_AN_EDGE = (
    np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1)], dtype=float),
    np.array([(0, 1, 2), (1, 0, 3), (0, 1, 4)]),
)


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
