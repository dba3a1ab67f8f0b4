# SPDX-License-Identifier: GPL-3.0-or-later
"""The proof of same results: that it sees the least difference, and what it asks of the filters."""

from __future__ import annotations

import re
from argparse import ArgumentTypeError
from collections.abc import Iterator

import numpy as np
import pymeshlab
import pytest
import same_bits
import same_bits_worker
from judge import topology
from meshes import REPOSITORY, shipped
from same_bits_cases import (
    CASES,
    COARSE,
    COARSE_LAYER,
    MOST_FACES_OF_SLOW,
    SPHERES,
    THREADED,
    cases_for,
)
from same_bits_meshes import hubs
from surface import Surface

POINTS = np.array([(0.1, 0.2, 0.3), (0.4, 0.0, np.nan)])
SECTION = re.compile(r"^In Python: `(\w+)`$", re.MULTILINE)
PARAMETER = re.compile(r" In Python: `(\w+)`\. Type: (\w+)")
CHOICE = re.compile(r"^\* `(\w+)`: ", re.MULTILINE)


def result(vertices: np.ndarray = POINTS, error: str = "", **report: str) -> dict:
    """What the worker says of a case."""
    arrays = {"vertex_matrix": same_bits_worker.digest(vertices)}
    return {"arrays": arrays, "report": report, "error": error}


def found(before: dict, now: dict, **renamed: str) -> list[str]:
    """The names of what differs."""
    return list(same_bits.differences(before, now, renamed))


def test_the_same_is_the_same() -> None:
    assert found(result(faces="12"), result(POINTS.copy(), faces="12")) == []


def test_one_bit_of_one_coordinate_is_found() -> None:
    moved = POINTS.copy()
    moved[1, 0] = np.nextafter(moved[1, 0], 1)
    assert found(result(), result(moved)) == ["vertex_matrix"]


def test_a_negative_zero_is_not_zero() -> None:
    negative = POINTS.copy()
    negative[1, 1] = -0.0
    assert found(result(), result(negative)) == ["vertex_matrix"]


def test_a_transposed_array_is_not_the_same() -> None:
    square = np.ones((3, 2))
    assert found(result(square), result(square.T)) == ["vertex_matrix"]


def test_a_value_that_was_returned_is_found() -> None:
    assert found(result(faces="12", cost="1e-9"), result(faces="12", cost="2e-9")) == ["cost"]
    assert found(result(faces="12"), result()) == ["faces"]
    assert found(result(), result(faces="12")) == ["faces"]


def test_a_renamed_value_is_the_same_under_its_new_name_only() -> None:
    before, now = result(faces_left="12"), result(faces="12")
    assert found(before, now, faces_left="faces") == []
    assert found(before, now) == ["faces_left", "faces"]
    assert found(before, result(faces="13"), faces_left="faces") == ["faces"]


def test_an_array_that_is_there_only_once_and_another_message_are_found() -> None:
    coloured = result()
    coloured["arrays"]["face_color_matrix"] = "2x4 00"
    assert found(result(), coloured) == ["face_color_matrix"]
    assert found(result(error="no target"), result()) == ["error"]


def documented() -> dict[str, dict[str, tuple[str, ...]]]:
    """Filter to parameter to the values of its enum, as docs/parameters.md has them."""
    text = (REPOSITORY / "docs/parameters.md").read_text(encoding="utf-8")
    names, filters = SECTION.findall(text), SECTION.split(text)[2::2]
    return {name: dict(parameters(part)) for name, part in zip(names, filters, strict=True)}


def parameters(part: str) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Each parameter of a filter's part of the documentation with its choices."""
    for section in part.split("\n## ")[0].split("\n### "):
        if described := PARAMETER.search(section):
            name, kind = described.groups()
            yield name, tuple(CHOICE.findall(section)) if kind == "enum" else ()


def test_every_filter_is_asked_only_for_parameters_that_it_has() -> None:
    described = documented()
    assert {case.filter for case in CASES} == set(described)
    unknown = [
        case for case in CASES if not case.parameters.keys() <= described[case.filter].keys()
    ]
    assert unknown == []
    assert {name for name in described if "threads" in described[name]} == THREADED


def test_every_choice_and_every_parameter_is_asked_for() -> None:
    asked: dict[tuple[str, str], set[str]] = {}
    for case in CASES:
        for parameter, value in case.parameters.items():
            asked.setdefault((case.filter, parameter), set()).add(str(value))
    for name, described in documented().items():
        for parameter, choices in described.items():
            values = asked.get((name, parameter), set())
            assert values or parameter == "threads", f"{name}: {parameter}"
            assert not choices or values == set(choices), f"{name}: {parameter}"


def test_no_case_is_there_twice() -> None:
    names = [(case.filter, case.name) for case in CASES]
    assert len(set(names)) == len(names)


def test_slow_cases_are_for_small_meshes() -> None:
    assert cases_for(MOST_FACES_OF_SLOW) == list(CASES)
    assert not any(case.slow for case in cases_for(MOST_FACES_OF_SLOW + 1))
    assert all(case.slow for case in CASES if case.filter == SPHERES)


def test_the_states_select_half_of_the_faces_and_paint_every_vertex() -> None:
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(str(shipped("cow.obj")))
    mesh = meshes.current_mesh()
    same_bits_worker.prepare(meshes, "half selected")
    assert 0.4 < mesh.selected_face_number() / mesh.face_number() < 0.6
    same_bits_worker.prepare(meshes, "painted")
    assert 1 <= mesh.vertex_scalar_array().min() < mesh.vertex_scalar_array().max() <= 10
    assert len(np.unique(mesh.vertex_color_matrix(), axis=0)) > 100
    assert {case.state for case in CASES} == set(same_bits_worker.STATES)


def test_the_coarse_mesh_is_the_layer_that_cases_name() -> None:
    assert same_bits_worker.STATES.index(COARSE) + 1 == COARSE_LAYER
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(str(shipped("cow.obj")))
    before = meshes.current_mesh().face_number()
    same_bits_worker.prepare(meshes, COARSE)
    assert 0 < meshes.current_mesh().face_number() < before


def test_hubs_are_closed_and_have_the_vertices_of_many_faces() -> None:
    vertices, faces = hubs(70, 2)
    seen = topology(Surface(vertices, faces))
    assert (seen["boundary"], seen["nm_edges"], seen["euler"]) == (0, 0, 4)
    assert np.sort(np.bincount(faces.ravel()))[-4:].tolist() == [70, 70, 70, 70]


def test_a_worker_applies_each_case_to_the_mesh_as_it_was_read(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """MeshLab's own filter serves as the filter under test."""
    monkeypatch.setattr(pymeshlab, "load_plugin", lambda plugin: None)
    flip = {"filter": "meshing_invert_face_orientation", "state": "plain", "parameters": {}}
    refused = {**flip, "parameters": {"no_such_parameter": 1}}
    job = {"plugin": "", "mesh": str(shipped("cow.obj")), "cases": [flip, refused, flip]}
    first, second, third = same_bits_worker.run(job)["results"]
    assert (first, first["error"]) == (third, "")
    assert "no_such_parameter" in second["error"]
    assert "face_matrix" in found(first, second)


def test_a_plugin_that_is_not_there_is_said() -> None:
    with pytest.raises(ArgumentTypeError, match="no file no_such_plugin"):
        same_bits._plugin("no_such_plugin.so")
