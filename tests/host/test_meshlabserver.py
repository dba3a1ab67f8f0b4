# SPDX-License-Identifier: GPL-3.0-or-later
"""The packaged meshlabserver 2020.09 runs our filters from a script, for real."""

import numpy as np
import pymeshlab
import pytest
from measures import flipped_faces, rms_distance, surface, topology
from pymeshlab_curvdecim import filter_script
from samples import CLUSTER, DECIMATE, IMPORTANCE, REMOVE, SPHERES, load

TARGET = 1160
# Single precision moves a vertex by 6e-8 of its coordinates, and may change the order of collapses
# of nearly equal cost; the surfaces then differ by less than either differs from the original.
NEARLY_SAME = 5e-4


@pytest.fixture
def cow(tmp_path):
    """PLY, since meshlabserver 2020.09 cannot read this OBJ file."""
    file = tmp_path / "cow.ply"
    load("cow.obj").save_current_mesh(str(file))
    return file


def read(file):
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(str(file))
    return meshes


def written(script, directory):
    file = directory / "script.mlx"
    file.write_text(script, encoding="utf-8")
    return file


@pytest.mark.parametrize(
    ("name", "options"),
    [
        (DECIMATE, {}),
        (DECIMATE, {"metric": "CurvatureAdditive"}),
        (DECIMATE, {"preventintersections": True}),
        (SPHERES, {}),
        (SPHERES, {"adaptivekernel": False}),
        (REMOVE, {}),
        (REMOVE, {"aspectratiomin": 0.1}),
    ],
)
def test_decimation_agrees_with_pymeshlab(meshlab, cow, tmp_path, name, options):
    script = written(filter_script(name, targetfacenum=TARGET, **options), tmp_path)
    run = meshlab.serve(cow, script, tmp_path / "out.ply")
    assert run.returncode == 0, run.stdout
    assert "\nfaces: 1160\n" in run.stdout

    original, ours = surface(read(cow)), read(cow)
    ours.apply_filter(name, targetfacenum=TARGET, **options)
    served = surface(read(tmp_path / "out.ply"))
    assert len(served.faces) == ours.current_mesh().face_number() == TARGET
    assert topology(served) == topology(original)
    assert flipped_faces(original, served) == 0
    assert rms_distance(surface(ours), served) < NEARLY_SAME


def test_default_target_is_left_to_meshlab(meshlab, cow, tmp_path):
    run = meshlab.serve(cow, written(filter_script(DECIMATE), tmp_path), tmp_path / "out.ply")
    assert run.returncode == 0, run.stdout
    assert len(surface(read(tmp_path / "out.ply")).faces) == 2902


@pytest.mark.parametrize("parameters", [{"targetfacenum": TARGET}, {"representative": "Median"}])
def test_clustering_agrees_with_pymeshlab(meshlab, cow, tmp_path, parameters):
    script = written(filter_script(CLUSTER, **parameters), tmp_path)
    run = meshlab.serve(cow, script, tmp_path / "out.ply")
    assert run.returncode == 0, run.stdout

    ours = read(cow)
    report = ours.apply_filter(CLUSTER, **parameters)
    served = surface(read(tmp_path / "out.ply"))
    assert f"\nfaces: {len(served.faces)}\n" in run.stdout
    assert len(served.faces) == report["faces"] == ours.current_mesh().face_number()
    assert rms_distance(surface(ours), served) < NEARLY_SAME


def test_importance_agrees_with_pymeshlab(meshlab, cow, tmp_path):
    script = written(filter_script(IMPORTANCE), tmp_path)
    run = meshlab.serve(cow, script, tmp_path / "out.ply", "vq", "vc")
    assert run.returncode == 0, run.stdout
    ours = read(cow)
    ours.apply_filter(IMPORTANCE)
    expected = ours.current_mesh().vertex_scalar_array()
    output = read(tmp_path / "out.ply")
    served = output.current_mesh()
    assert np.ptp(expected) > 0
    assert np.allclose(served.vertex_scalar_array(), expected, rtol=1e-3, atol=1e-3)
    assert len(np.unique(served.vertex_color_matrix(), axis=0)) > 10


@pytest.mark.parametrize(
    ("name", "value"), [("TargetFaceNum", -1), ("TargetPerc", 7.0), ("NormalAngle", -1.0)]
)
def test_bad_parameter_ends_with_a_message(meshlab, cow, tmp_path, name, value):
    script = written(filter_script(DECIMATE, **{name.lower(): value}), tmp_path)
    run = meshlab.serve(cow, script, tmp_path / "out.ply")
    assert run.returncode not in (0, 134), run.stdout
    assert f"({name}) is {value:g}" in run.stdout
    assert "Problem with filter" in run.stdout
    assert not (tmp_path / "out.ply").exists()
