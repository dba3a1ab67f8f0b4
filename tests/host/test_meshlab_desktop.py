# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of windows are left out, with the reason, where a root tree cannot be entered."""

import os

import meshlab_desktop
import pytest


@pytest.fixture
def trees(tmp_path, monkeypatch):
    """A folder with a root tree, and with programs that come before those of the machine."""
    (tmp_path / "2025.07").mkdir()
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=os.pathsep)
    return tmp_path


@pytest.mark.parametrize(
    ("commands", "reason"),
    [
        ("echo 'unshare failed: Operation not permitted' >&2; exit 1", "Operation not permitted"),
        ("exit 0", None),
    ],
)
def test_reason_is_what_unshare_says(trees, commands, reason):
    program = trees / "unshare"
    program.write_text(f"#!/bin/sh\n{commands}\n")
    program.chmod(0o755)
    said = meshlab_desktop.why_absent("2025.07", trees)
    assert said is None if reason is None else reason in said


def test_users_are_told_that_root_is_needed(trees, monkeypatch):
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    assert "needs root" in meshlab_desktop.why_absent("2025.07", trees)
