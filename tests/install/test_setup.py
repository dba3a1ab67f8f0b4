# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripts look at what they are given before they install anything."""

import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def setup(tmp_path):
    """Runs a script where apt-get and python3 are other programs, which note their calls."""
    calls = tmp_path / "calls"

    def run(purpose, python="exit 0", script="setup", **environment):
        for name, commands in (("apt-get", "exit 1"), ("python3", python)):
            program = tmp_path / name
            program.write_text(f'#!/bin/sh\necho "{name} $@" >>"{calls}"\n{commands}\n')
            program.chmod(0o755)
        return subprocess.run(
            [ROOT / "scripts" / script, purpose],
            env={**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}", **environment},
            capture_output=True,
            text=True,
            timeout=60,
        )

    run.calls = calls
    return run


def test_unknown_host_is_named_with_those_there_are(setup):
    answer = setup("demo", CURVDECIM_HOSTS="meshlab-2020.09 meshlab-2021")
    assert answer.returncode == 1
    hosts = [
        line.split()[0]
        for line in (ROOT / "cmake" / "hosts.txt").read_text().splitlines()
        if not line.startswith("#")
    ]
    assert f"no host 'meshlab-2021'. There are: {' '.join(hosts)}" in answer.stderr
    assert not setup.calls.exists()


@pytest.mark.parametrize("version", ["3.10", "3.15"])
def test_python_out_of_range_is_named(setup, version):
    look = f"import sys; sys.version_info = ({version.replace('.', ', ')}, 0); "
    python = (
        f'[ "$1" = --version ] && echo "Python {version}.0" && exit; '
        f'exec /usr/bin/env -i PATH=/usr/bin:/usr/local/bin python3 -c "{look}$2"'
    )
    answer = setup("demo", python)
    assert answer.returncode == 1
    assert "Python >=3.11,<3.15 is needed" in answer.stderr
    assert f"Python {version}.0" in answer.stderr
    assert "apt-get" not in setup.calls.read_text()


def test_unknown_purpose_is_answered_with_help(setup):
    answer = setup("everything")
    assert answer.returncode == 2
    assert "scripts/setup demo | bench | package | test" in answer.stdout


@pytest.mark.parametrize("option", ["-h", "--help"])
@pytest.mark.parametrize(
    "script", ["setup", "package", "test", "demo", "bench", "check", "sanitize"]
)
def test_help_is_the_head_of_the_script_and_sets_nothing_up(setup, script, option):
    answer = setup(option, script=script)
    assert (answer.returncode, answer.stderr) == (0, "")
    source = (ROOT / "scripts" / script).read_text()
    head = source[: source.index("\nset -euo")].splitlines()[2:]
    assert answer.stdout.splitlines() == [line.removeprefix("# ") for line in head]
    assert not setup.calls.exists()
