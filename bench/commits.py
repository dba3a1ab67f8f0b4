# SPDX-License-Identifier: GPL-3.0-or-later
"""Another commit of this repository, unpacked beside this tree, and how CMake can build it."""

from __future__ import annotations

import os
import shutil
import subprocess
import tarfile
from io import BytesIO
from pathlib import Path

from meshes import REPOSITORY


class IncomparableError(Exception):
    """There is no other commit, or it cannot be built; the message says why."""


def git(*words: str) -> str:
    """What git says of this repository, without the line's end."""
    done = subprocess.run(["git", *words], cwd=REPOSITORY, capture_output=True, text=True)
    if done.returncode != 0:
        raise IncomparableError(f"no earlier commit here (git {' '.join(words)} finds none)")
    return done.stdout.strip()


def full_name(commit: str) -> str:
    """The hash of a commit that is named by a tag, a branch or the first digits of its hash."""
    return git("rev-parse", "--verify", "--quiet", f"{commit}^{{commit}}")


def unpack(commit: str, folder: Path, paths: tuple[str, ...] = ()) -> None:
    """Writes these paths of a commit, by default all, into a folder unless it is there."""
    if folder.exists():
        return
    command = ["git", "archive", commit, "--", *paths]
    done = subprocess.run(command, cwd=REPOSITORY, capture_output=True)
    if done.returncode != 0:
        raise IncomparableError(f"commit {commit[:10]} has no {' and '.join(paths) or 'files'}")
    unfinished = folder.with_suffix(".part")
    shutil.rmtree(unfinished, ignore_errors=True)
    unfinished.mkdir(parents=True)
    with tarfile.open(fileobj=BytesIO(done.stdout)) as archive:
        archive.extractall(unfinished, filter="data")
    unfinished.rename(folder)


def meshlab_sources() -> str:
    """For CMake: what the user named, then what scripts/setup fetched."""
    named = os.environ.get("MESHLAB_SOURCE_DIR", "")
    fetched = sorted(str(file.parent) for file in REPOSITORY.glob("build/meshlab/*/ML_VERSION"))
    return ";".join([*([named] if named else []), *fetched])
