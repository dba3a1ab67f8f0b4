# SPDX-License-Identifier: GPL-3.0-or-later
"""Vertex removal in PyMeshLab."""

import numpy as np
import pymeshlab
import pytest
from drawn_meshes import bumpy_sheet, mesh_set
from measures import flipped_faces, rms_distance, surface, topology
from pymeshlab_curvdecim.description import read_filters
from samples import REMOVE, load

CRITERIA = ("Heap", "Passes")
CELLS = 24
CLASSES = ("simple", "complex", "boundary", "interior_edge", "corner")


def removed(name="cow.obj", **parameters):
    """A sample and what the filter returned."""
    meshes = load(name)
    return meshes, getattr(meshes, REMOVE)(**parameters)


def left(**parameters):
    """Vertices and faces of the cow afterwards."""
    meshes, _ = removed(**parameters)
    return meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix()


def rows(matrix):
    return {tuple(row) for row in matrix}


@pytest.mark.parametrize("criterion", CRITERIA)
@pytest.mark.parametrize("fraction", [0.5, 0.2])
def test_reaches_the_target_and_keeps_the_topology(criterion, fraction):
    original = surface(load("cow.obj"))
    meshes, result = removed(targetperc=fraction, criterion=criterion)
    assert result["faces"] == meshes.current_mesh().face_number()
    assert result["faces"] in (int(fraction * 5804), int(fraction * 5804) - 1)
    assert result["stopped_by"] == "target"
    assert topology(surface(meshes)) == topology(original)


@pytest.mark.parametrize("criterion", CRITERIA)
def test_a_sheet_stays_near_and_unfolded(criterion):
    meshes = mesh_set(*bumpy_sheet(CELLS))
    original = surface(meshes)
    meshes.apply_filter(REMOVE, targetperc=0.2, criterion=criterion)
    assert topology(surface(meshes)) == topology(original)
    assert flipped_faces(original, surface(meshes)) == 0
    assert rms_distance(original, surface(meshes)) < 0.01


def test_leaves_vertices_of_the_input_with_all_that_they_carry():
    vertices, faces = bumpy_sheet(CELLS)
    numbers = np.arange(len(vertices), dtype=float)
    colours = np.random.default_rng(1).random((len(vertices), 4))
    meshes = mesh_set(vertices, faces, v_scalar_array=numbers, v_color_matrix=colours)
    before = meshes.current_mesh().vertex_color_matrix()
    meshes.apply_filter(REMOVE, targetperc=0.2)
    mesh = meshes.current_mesh()
    kept = mesh.vertex_scalar_array().astype(int)
    assert len(kept) < len(vertices) / 3
    assert np.array_equal(mesh.vertex_matrix(), vertices[kept])
    assert np.array_equal(mesh.vertex_color_matrix(), before[kept])


def test_wedge_texture_is_that_of_the_vertex_in_its_chart():
    meshes, _ = removed("bunny10k_textured.obj", targetperc=0.3)
    before = load("bunny10k_textured.obj")

    def corners(mesh):
        points = mesh.vertex_matrix()[mesh.face_matrix().ravel()]
        return rows(np.hstack([points, mesh.wedge_tex_coord_matrix()]))

    assert corners(meshes.current_mesh()) <= corners(before.current_mesh())


def test_a_bound_is_kept():
    original = surface(load("cow.obj"))
    bound = 0.01 * np.linalg.norm(np.ptp(original.vertices, axis=0))
    for name in ("distancebound", "maxerror"):
        meshes, result = removed(targetfacenum=0, **{name: pymeshlab.PercentageValue(1)})
        assert result["stopped_by"] == "error bound"
        assert 0 < result["max_error"] <= bound * (1 + 1e-6)
        assert result["faces"] < 2902
        before = load("cow.obj")
        before.add_mesh(meshes.current_mesh())
        for one, other in ((0, 1), (1, 0)):
            found = before.get_hausdorff_distance(
                sampledmesh=one, targetmesh=other, samplevert=True, sampleface=True, samplenum=20000
            )
            assert found["max"] <= result["max_error"] * (1 + 1e-6)


def test_corners_of_a_box_stay_with_features():
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.create_cube()
    meshes.meshing_surface_subdivision_midpoint(iterations=3)
    kept, result = [], None
    for features in (True, False):
        meshes.add_mesh(meshes.mesh(0))
        result = getattr(meshes, REMOVE)(targetfacenum=4, preservefeatures=features)
        kept.append(result["faces"])
    assert kept[0] == 12
    assert kept[1] < 12


def test_shows_the_classes():
    meshes, result = removed(targetperc=1.0, showclasses=True)
    mesh = meshes.current_mesh()
    assert mesh.face_number() == 5804
    quality = mesh.vertex_scalar_array()
    counts = [result[f"vertices_{name}"] for name in CLASSES]
    assert [int((quality == number).sum()) for number in range(len(CLASSES))] == counts
    assert sum(counts) == mesh.vertex_number()
    assert counts[0] > 1000
    assert min(counts[3:]) > 0
    assert len(rows(mesh.vertex_color_matrix())) == sum(count > 0 for count in counts)


def test_colours_stay_without_classes():
    meshes, result = removed(targetperc=0.5)
    assert "vertices_simple" not in result
    assert len(rows(meshes.current_mesh().vertex_color_matrix())) == 1


# Each option must do something: a value and settings for which it changes the result.
EFFECTIVE = {
    "criterion": ("Passes", {}),
    "distancebound": (pymeshlab.PercentageValue(0.05), {}),
    "maxerror": (pymeshlab.PercentageValue(0.05), {}),
    "aspectratiomin": (0.2, {}),
    "preservefeatures": (True, {}),
    "featureangle": (20.0, {}),
    "preservenormal": (False, {"targetperc": 0.03}),
    "normalangle": (40.0, {}),
    "targetvertnum": (500, {}),
    "boundaryweight": (20.0, {}),
}


@pytest.mark.parametrize("name", EFFECTIVE)
def test_option_has_an_effect(name):
    value, setting = EFFECTIVE[name]
    results = [left(**{"targetperc": 0.1, **setting, **each})[0] for each in ({}, {name: value})]
    assert not np.array_equal(*results)


def test_border_distances_count_unless_switched_off():
    borders = []
    for preserve in (True, False):
        meshes = mesh_set(*bumpy_sheet(CELLS))
        meshes.apply_filter(REMOVE, targetperc=0.2, preserveboundary=preserve)
        meshes.compute_selection_from_mesh_border()
        borders.append(meshes.current_mesh().selected_vertex_number())
    assert borders[1] < borders[0]


def test_has_the_parameters_that_mean_something_to_it():
    names = {each.python_name for each in read_filters()[REMOVE].parameters}
    assert set(EFFECTIVE) | {"targetfacenum", "targetperc", "selected", "threads"} < names
    assert "preservetopology" not in names


@pytest.mark.parametrize("threads", [1, 2, 3])
def test_threads_do_not_change_the_result(threads):
    one, other = (left(targetperc=0.1, threads=each) for each in (0, threads))
    assert np.array_equal(one[0], other[0])
    assert np.array_equal(one[1], other[1])
