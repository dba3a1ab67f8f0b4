# SPDX-License-Identifier: GPL-3.0-or-later
"""The sample meshes are what their generator writes, and each is explained."""

from __future__ import annotations

from pathlib import Path

import generate
import pytest

FOLDER = Path(__file__).resolve().parent
SIZE_LIMIT = 1_500_000  # bytes, of all meshes together


@pytest.fixture(scope="module")
def regenerated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("sample_meshes")
    generate.write(folder)
    return folder


@pytest.mark.parametrize("name", generate.MESHES)
def test_regenerating_gives_the_same_bytes(name: str, regenerated: Path) -> None:
    assert (regenerated / name).read_bytes() == (FOLDER / name).read_bytes()


def test_the_folder_has_these_meshes_and_no_others() -> None:
    files = {path.name for path in FOLDER.iterdir() if path.suffix in (".ply", ".obj")}
    assert files == set(generate.MESHES)


def test_the_readme_says_why_each_mesh_is_there() -> None:
    readme = (FOLDER / "README.md").read_text(encoding="utf-8")
    rows = {line.split("|")[1].strip(" `") for line in readme.splitlines() if line.startswith("|")}
    assert set(generate.MESHES) <= rows


def test_the_meshes_are_small() -> None:
    assert sum((FOLDER / name).stat().st_size for name in generate.MESHES) < SIZE_LIMIT
