# SPDX-License-Identifier: GPL-3.0-or-later
"""Simplification Error against MeshLab's own filter, against libigl, and on drawn layers."""

import sys

import igl
import numpy as np
import pymeshlab
import pytest
from drawn_meshes import mesh_set, sheet
from pymeshlab_curvdecim import filter_script
from samples import DECIMATE, ERROR, ROOT, load

sys.path.append(str(ROOT / "bench"))

from judge import Judge

SAMPLES = 100_000
NOISE = 0.02  # of MeshLab's random samples, relative
NEARLY = 0.97  # of a maximum inside faces, which others' samples may come closer to
CURVED = ("bone.ply", "cow.obj", "bunny10k_textured.obj", "horse.ply", "fandisk.obj")
SIDES = {"original_to_simplified": (0, 1), "simplified_to_original": (1, 0)}


def with_decimated(name, fraction=0.1):
    """A MeshSet of a sample and, as the second layer, its decimation."""
    meshes = load(name)
    original = meshes.current_mesh()
    meshes.add_mesh(pymeshlab.Mesh(original.vertex_matrix(), original.face_matrix()))
    meshes.apply_filter(DECIMATE, targetperc=fraction)
    return meshes


def layers(*shapes):
    """A MeshSet of drawn layers."""
    meshes = pymeshlab.MeshSet(verbose=False)
    for vertices, faces in shapes:
        meshes.add_mesh(pymeshlab.Mesh(vertices, np.asarray(faces, dtype=np.int32)))
    return meshes


def lifted(height, cells=12):
    vertices, faces = sheet(cells)
    return vertices + (0, 0, height), faces


def hausdorff(meshes, sampled, target):
    """MeshLab's own, from samples of faces alone."""
    return meshes.apply_filter(
        "get_hausdorff_distance",
        sampledmesh=sampled,
        targetmesh=target,
        samplevert=False,
        sampleface=True,
        samplenum=SAMPLES,
        maxdist=pymeshlab.PercentageValue(100),
    )


@pytest.mark.parametrize("name", CURVED)
def test_agrees_with_meshlabs_hausdorff_distance(name):
    meshes = with_decimated(name)
    error = meshes.apply_filter(ERROR)
    for side, (sampled, target) in SIDES.items():
        theirs = hausdorff(meshes, sampled, target)
        assert error[f"rms_{side}"] == pytest.approx(theirs["RMS"], rel=NOISE)
        assert error[f"mean_{side}"] == pytest.approx(theirs["mean"], rel=NOISE)
        assert error[f"max_{side}"] > NEARLY * theirs["max"]
    assert error["diagonal"] == pytest.approx(theirs["diag_mesh_1"])


@pytest.mark.parametrize("name", CURVED)
def test_agrees_with_the_judge_of_the_bench(name):
    """Which has the same definitions, random samples and the distances of libigl."""
    meshes = with_decimated(name)
    error = meshes.apply_filter(ERROR, relativeto="Diagonal")
    original, simplified = (meshes.mesh(number) for number in (0, 1))
    judge = Judge(original.vertex_matrix(), original.face_matrix(), samples=SAMPLES)
    figures = judge(simplified.vertex_matrix(), simplified.face_matrix())
    for side in SIDES:
        assert error[f"rms_{side}"] == pytest.approx(getattr(figures, f"rms_{side}"), rel=NOISE)
    assert error["rms"] == pytest.approx(figures.rms, rel=NOISE)
    assert error["mean"] == pytest.approx(figures.mean, rel=NOISE)
    assert error["rms_salient"] == pytest.approx(figures.rms_salient, rel=2 * NOISE)
    assert error["max"] > NEARLY * figures.max
    assert error["normal_deviation_deg"] == pytest.approx(figures.ndev, rel=NOISE)
    assert error["flipped"] == pytest.approx(figures.flipped, abs=1)  # an edge has two faces
    assert error["diagonal"] == pytest.approx(judge.diagonal)


def distances(points, mesh):
    faces = mesh.face_matrix().astype(np.int64)
    squared = igl.point_mesh_squared_distance(points, mesh.vertex_matrix(), faces)[0]
    return np.sqrt(np.maximum(squared, 0))


def test_layers_at_a_distance():
    error = layers(lifted(0.0), lifted(0.25, cells=5)).apply_filter(ERROR)
    for name in ("rms", "mean", "max", "rms_salient", *(f"max_{side}" for side in SIDES)):
        assert error[name] == pytest.approx(0.25, rel=1e-12)
    assert error["normal_deviation_deg"] == error["flipped"] == error["intersecting"] == 0
    assert error["parts"] == error["holes"] == 1
    assert error["area"] == pytest.approx(1)


def test_the_same_layer_twice_has_no_error():
    error = layers(lifted(0.0), lifted(0.0)).apply_filter(ERROR)
    assert error["max"] == error["rms"] == error["scale_end"] == 0


@pytest.mark.parametrize(("relative_to", "unit"), [("Diagonal", 0.02**0.5), ("Tolerance", 0.125)])
def test_relative_to(relative_to, unit):
    meshes = layers(lifted(0.0), lifted(0.25))
    error = meshes.apply_filter(ERROR, relativeto=relative_to, tolerance=pymeshlab.PureValue(0.125))
    unit = 2**0.5 / 100 if relative_to == "Diagonal" else unit
    assert error["rms"] == pytest.approx(0.25 / unit)
    assert error["beyond_tolerance"] == 100


def test_chooses_layers():
    meshes = layers(lifted(9.0), lifted(0.0), lifted(0.5))
    assert meshes.apply_filter(ERROR)["rms"] == pytest.approx(9.0)
    error = meshes.apply_filter(ERROR, originalmesh=2, simplifiedmesh=1)
    assert error["rms"] == pytest.approx(0.5)


def test_knows_where_a_layer_is_shown():
    meshes = layers(lifted(0.0), lifted(0.0))
    meshes.set_current_mesh(1)
    meshes.compute_matrix_from_translation(axisz=0.5, freeze=False)
    assert meshes.apply_filter(ERROR)["rms"] == pytest.approx(0.5)


def test_says_when_there_is_one_layer():
    with pytest.raises(pymeshlab.PyMeshLabException, match="only one layer"):
        mesh_set(*lifted(0.0)).apply_filter(ERROR)


def test_refuses_a_layer_twice_and_one_that_is_missing():
    meshes = layers(lifted(0.0), lifted(0.5))
    with pytest.raises(pymeshlab.PyMeshLabException, match="simplifiedmesh is a layer that"):
        meshes.apply_filter(ERROR, originalmesh=1, simplifiedmesh=1)
    with pytest.raises(pymeshlab.PyMeshLabException):
        meshes.apply_filter(ERROR, originalmesh=0, simplifiedmesh=7)


def test_writes_nothing_unless_asked():
    meshes = layers(lifted(0.0), lifted(0.25))

    def values():
        both = (meshes.mesh(number) for number in (0, 1))
        return [(mesh.vertex_scalar_array(), mesh.vertex_color_matrix()) for mesh in both]

    before = values()
    meshes.apply_filter(ERROR)
    for (value, colour), (value_now, colour_now) in zip(before, values(), strict=True):
        assert np.array_equal(value, value_now)
        assert np.array_equal(colour, colour_now)


def test_shows_distances_on_one_scale():
    ramp = sheet(12, lambda x, _: 0.1 * x)
    meshes = layers(lifted(0.0), ramp)
    error = meshes.apply_filter(ERROR, savequality=True)
    flat, tilted = meshes.mesh(0), meshes.mesh(1)
    assert flat.vertex_scalar_array().max() == pytest.approx(error["max"], rel=0.01)
    for mesh in (flat, tilted):
        exact = distances(mesh.vertex_matrix(), tilted if mesh is flat else flat)
        assert np.allclose(mesh.vertex_scalar_array(), exact, atol=1e-12)
        red, blue = mesh.vertex_color_matrix()[:, [0, 2]].T
        values = mesh.vertex_scalar_array()
        assert (red[values == 0] == 1).all()
        assert (blue[values > error["scale_end"]] == 1).all()
    same = np.isclose(flat.vertex_scalar_array(), tilted.vertex_scalar_array(), atol=1e-4)
    colours = flat.vertex_color_matrix() - tilted.vertex_color_matrix()
    assert np.abs(colours[same]).max() < 0.05


def test_texture_drift():
    def textured(shift):
        vertices, faces = sheet(6)
        corners = vertices[faces.ravel(), :2] * (0.5, 1) + (shift, 0)
        return pymeshlab.Mesh(vertices, faces, w_tex_coords_matrix=corners)

    meshes = pymeshlab.MeshSet(verbose=False)
    for shift in (0.0, 0.05):
        meshes.add_mesh(textured(shift))
    error = meshes.apply_filter(ERROR)
    assert error["texture_lost"] == pytest.approx(10 - 100 / 128, rel=0.05)  # but a cell beside it
    assert 0.09 < error["texture_drift_rms"] <= error["texture_drift_max"] < 0.11
    assert "texture_drift_rms" not in layers(lifted(0.0), lifted(0.1)).apply_filter(ERROR)


def test_meshlabserver_tells_the_same(meshlab, tmp_path):
    files = [tmp_path / "first.ply", tmp_path / "second.ply"]
    meshes = layers(lifted(0.0), sheet(12, lambda x, _: 0.1 * x))
    for number, file in enumerate(files):
        meshes.set_current_mesh(number)
        meshes.save_current_mesh(str(file))
    script = tmp_path / "script.mlx"
    script.write_text(filter_script(ERROR, originalmesh=0, simplifiedmesh=1, tolerance=0.01))
    run = meshlab.serve(files[0], script, tmp_path / "out.ply", more=["-i", files[1]])
    assert run.returncode == 0, run.stdout
    served = dict(line.split(": ", 1) for line in run.stdout.splitlines() if ": " in line)
    assert float(served["rms"]) == pytest.approx(meshes.apply_filter(ERROR)["rms"], rel=1e-4)
