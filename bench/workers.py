# SPDX-License-Identifier: GPL-3.0-or-later
"""Asks a program, in a fresh process, to simplify a mesh; its last line of output is its answer."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Sequence
from typing import Any

PATIENCE = 1800.0  # seconds; then a run counts as hung
_LAST_WORDS = 2000  # characters of standard error that a failure quotes


class FilterError(RuntimeError):
    """A filter ended with an error; the message says which, on what, and its last words."""


def ask(
    command: Sequence[str], job: dict[str, Any] | None, what: str, patience: float = PATIENCE
) -> dict[str, Any]:
    """The answer (JSON) of a program that gets the job as JSON on its standard input.

    what: for the message of the FilterError that a failure or an end of patience raises.
    """
    try:
        done = subprocess.run(
            command,
            input=json.dumps(job),
            capture_output=True,
            text=True,
            timeout=patience,
            check=False,
        )
    except subprocess.TimeoutExpired as late:
        raise FilterError(f"{what}: no end after {patience:g} s") from late
    except OSError as error:
        raise FilterError(f"{what}: {error}") from error
    if done.returncode != 0:
        words = done.stderr.strip()[-_LAST_WORDS:]
        raise FilterError(f"{what}: exit code {done.returncode}\n{words}")
    return json.loads(done.stdout.splitlines()[-1])
