# SPDX-License-Identifier: GPL-3.0-or-later
"""What PyMeshLab shows of custom attributes, polygons, groups of faces and maps of vertices."""

import numpy as np
import pymeshlab
import pytest
from drawn_meshes import bumpy_sheet, mesh_set, sphere
from samples import CLUSTER, DECIMATE, REMOVE, STEPWISE

ALL = [*STEPWISE, CLUSTER]
NEAREST, RESULT = "nearest_input_vertex", "result_vertex"
TENTH_OF_A_CELL = 0.1 / 24
RED, BLUE = (1.0, 0.0, 0.0, 1.0), (0.0, 0.0, 1.0, 1.0)


@pytest.mark.parametrize("name", ALL)
def test_custom_attributes(name):
    vertices, faces = bumpy_sheet(24)
    meshes = mesh_set(vertices, faces)
    mesh = meshes.current_mesh()
    mesh.add_vertex_custom_scalar_attribute(vertices @ (1.0, 2.0, 3.0), "scalar")
    mesh.add_vertex_custom_point_attribute(vertices[:, ::-1].copy(), "point")
    mesh.add_face_custom_scalar_attribute(np.arange(len(faces), dtype=float), "number")
    meshes.apply_filter(name, targetperc=0.25)
    now = mesh.vertex_matrix()
    near = 0.06 if name == CLUSTER else 0.03  # of 2 and 1: a vertex may lie beside the surface
    assert (
        np.abs(mesh.vertex_custom_scalar_attribute_array("scalar") - now @ (1, 2, 3)).max() < near
    )
    assert np.abs(mesh.vertex_custom_point_attribute_matrix("point") - now[:, ::-1]).max() < near
    number = mesh.face_custom_scalar_attribute_array("number").astype(int)
    centres, before = now[mesh.face_matrix()].mean(axis=1), vertices[faces].mean(axis=1)
    assert len(set(number)) == len(number)
    assert np.linalg.norm(centres - before[number], axis=1).max() < 0.2


@pytest.mark.parametrize("name", ALL)
def test_a_mesh_of_polygons_is_saved_as_triangles(name, tmp_path):
    vertices, _ = bumpy_sheet(12)
    corner = np.arange(13 * 13).reshape(13, 13) + 1
    quads = np.stack([corner[:-1, :-1], corner[:-1, 1:], corner[1:, 1:], corner[1:, :-1]], axis=-1)
    lines = [f"v {x} {y} {z}" for x, y, z in vertices]
    lines += [f"f {a} {b} {c} {d}" for a, b, c, d in quads.reshape(-1, 4)]
    file = tmp_path / "quads.obj"
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(str(file))
    meshes.apply_filter(name, targetperc=0.5)
    meshes.save_current_mesh(str(file))
    saved = [line.split() for line in file.read_text(encoding="utf-8").splitlines()]
    corners = [len(words) - 1 for words in saved if words[:1] == ["f"]]
    assert corners == [3] * meshes.current_mesh().face_number()


@pytest.mark.parametrize("name", [DECIMATE, REMOVE])
def test_borders_of_colours_stay(name):
    vertices, faces = bumpy_sheet(24)
    left = vertices[faces].mean(axis=1)[:, 0] < 0.5
    meshes = mesh_set(vertices, faces, f_color_matrix=np.where(left[:, None], RED, BLUE))
    meshes.apply_filter(name, targetperc=0.1, keepbordersof="FaceColor")
    mesh = meshes.current_mesh()
    x = mesh.vertex_matrix()[mesh.face_matrix()][:, :, 0]
    is_left = (mesh.face_color_matrix() == RED).all(axis=1)
    assert x[is_left].max() < 0.5 + TENTH_OF_A_CELL
    assert x[~is_left].min() > 0.5 - TENTH_OF_A_CELL


@pytest.mark.parametrize("name", ALL)
def test_maps_of_vertices(name):
    before = sphere()[0]
    meshes = mesh_set(*sphere())
    meshes.apply_filter("compute_matrix_from_translation", axisx=5.0, freeze=False)
    meshes.apply_filter(name, targetperc=0.2, keepmap=True)
    assert (meshes.mesh_number(), meshes.current_mesh_id()) == (2, 0)
    mesh, original = meshes.current_mesh(), meshes.mesh(1)
    assert np.array_equal(original.vertex_matrix(), before)
    assert np.array_equal(original.transform_matrix(), mesh.transform_matrix())
    nearest = mesh.vertex_custom_scalar_attribute_array(NEAREST).astype(int)
    result = original.vertex_custom_scalar_attribute_array(RESULT).astype(int)
    now = mesh.vertex_matrix()
    least = np.linalg.norm(before[:, None] - now, axis=2).min(axis=0)
    assert np.allclose(np.linalg.norm(before[nearest] - now, axis=1), least, rtol=1e-9, atol=1e-12)
    assert set(result) == set(range(len(now)))
    assert np.linalg.norm(now[result] - before, axis=1).max() < 0.5


def test_a_run_without_maps_adds_no_layer():
    meshes = mesh_set(*sphere())
    meshes.apply_filter(DECIMATE, targetperc=0.2)
    assert meshes.mesh_number() == 1
    with pytest.raises(pymeshlab.PyMeshLabException):
        meshes.current_mesh().vertex_custom_scalar_attribute_array(NEAREST)
