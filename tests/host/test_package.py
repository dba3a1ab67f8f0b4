# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python package: loading, methods with true signatures, scripts, and the command."""

import inspect
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Literal, get_args, get_origin
from xml.etree import ElementTree

import numpy as np
import pymeshlab
import pymeshlab_curvdecim
import pytest
from drawn_meshes import bumpy_sheet, mesh_set
from pymeshlab_curvdecim import filter_script
from pymeshlab_curvdecim.description import read_filters
from samples import CLUSTER, DECIMATE, ERROR, IMPORTANCE, SHIPPED, STEPWISE

COW = str(SHIPPED / "cow.obj")
METHOD = getattr(pymeshlab.MeshSet, DECIMATE)
ALL = (*STEPWISE, CLUSTER, IMPORTANCE, ERROR)


def sheets(name):
    """A mesh set that the filter of this name runs on: one layer, or two to compare."""
    meshes = mesh_set(*bumpy_sheet())
    if name == ERROR:
        meshes.add_mesh(pymeshlab.Mesh(*bumpy_sheet(6)))
    return meshes


PYTHON = Path(pymeshlab_curvdecim.__file__).parents[1]


def python(code, *folders, **environment):
    """Runs code in a fresh interpreter that finds the package, and before it what is in folders."""
    path = os.pathsep.join(map(str, (*folders, PYTHON)))
    return subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "PYTHONPATH": path, **environment},
        capture_output=True,
        text=True,
        timeout=120,
    )


def test_loading_twice_is_loading_once():
    plugins = pymeshlab.plugin_number()
    assert pymeshlab_curvdecim.load() == pymeshlab_curvdecim.load()
    assert pymeshlab.plugin_number() == plugins


def test_plugin_that_is_loaded_already_is_used():
    code = (
        "import os, pymeshlab; pymeshlab.load_plugin(os.environ['CURVDECIM_PLUGIN']);"
        f"import pymeshlab_curvdecim; print(hasattr(pymeshlab.MeshSet, '{DECIMATE}'))"
    )
    answer = python(code)
    assert answer.stdout.endswith("True\n"), answer.stderr


@pytest.mark.parametrize("name", ALL)
def test_filters_are_methods_and_functions(name):
    assert getattr(pymeshlab.MeshSet, name) is getattr(pymeshlab_curvdecim, name)


def test_method_function_and_apply_filter_agree():
    sets = [mesh_set(*bumpy_sheet()) for _ in range(3)]
    getattr(sets[0], DECIMATE)(targetperc=0.4)
    getattr(pymeshlab_curvdecim, DECIMATE)(sets[1], targetperc=0.4)
    sets[2].apply_filter(DECIMATE, targetperc=0.4)
    results = [each.current_mesh().vertex_matrix() for each in sets]
    assert len(results[0]) < len(bumpy_sheet()[0])
    assert all(np.array_equal(results[0], each) for each in results)


def test_signature_has_types_and_defaults():
    parameters = inspect.signature(METHOD).parameters
    metric = parameters["metric"]
    assert get_origin(metric.annotation) is Literal
    assert get_args(metric.annotation) == ("Quadric", "CurvatureWeighted", "CurvatureAdditive")
    assert metric.default == "CurvatureWeighted"
    assert (parameters["targetperc"].annotation, parameters["targetperc"].default) == (float, 0.0)
    assert parameters["preserveboundary"].default is True
    assert parameters["targetfacenum"].default is None
    assert all(each.kind is each.KEYWORD_ONLY for each in list(parameters.values())[1:])


def test_documentation_names_every_parameter_in_plain_text():
    text = METHOD.__doc__
    assert all(f"\n{name} : " in text for name in list(inspect.signature(METHOD).parameters)[1:])
    assert all(f"\n{each.name}" in text for each in read_filters()[DECIMATE].results)
    assert "<" not in text


@pytest.mark.parametrize("name", ALL)
def test_returns_what_is_described(name):
    report = getattr(sheets(name), name)()
    described = [each.name for each in read_filters()[name].results]
    assert set(report) <= set(described)
    assert len(report) >= 3


@pytest.mark.parametrize("name", ALL)
def test_stated_defaults_are_the_plugins(name):
    """Giving every stated default changes nothing."""
    function = getattr(pymeshlab_curvdecim, name)
    parameters = list(inspect.signature(function).parameters.values())[1:]
    stated = {each.name: each.default for each in parameters if each.default is not None}
    without, with_defaults = (sheets(name) for _ in range(2))
    function(without)
    function(with_defaults, **stated)
    for array in ("vertex_matrix", "face_matrix", "vertex_scalar_array", "vertex_color_matrix"):
        one, other = (getattr(each.current_mesh(), array) for each in (without, with_defaults))
        if not array.startswith("vertex_") or without.current_mesh().has_vertex_color():
            assert np.array_equal(one(), other())


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"nosuch": 1}, "has no nosuch, only targetfacenum"),
        ({"metric": "Cubic"}, "metric must be one of Quadric, .*'Cubic'"),
        ({"metric": 9}, "metric must be one of"),
        ({"targetfacenum": 2.5}, "targetfacenum must be of type int, not 2.5"),
        ({"targetperc": "half"}, "targetperc must be of type float, not 'half'"),
        ({"preserveboundary": "yes"}, "preserveboundary must be of type bool"),
    ],
)
def test_wrong_argument_is_named(options, words):
    with pytest.raises((TypeError, ValueError), match=words):
        METHOD(mesh_set(*bumpy_sheet()), **options)


def test_length_may_be_a_number_or_a_share():
    diagonal = float(np.linalg.norm(np.ptp(bumpy_sheet()[0], axis=0)))
    results = []
    for length in (0.02 * diagonal, pymeshlab.PercentageValue(2)):
        meshes = mesh_set(*bumpy_sheet())
        METHOD(meshes, targetfacenum=0, maxerror=length)
        results.append(meshes.current_mesh().face_number())
    assert results[0] == results[1]


def test_failure_does_not_harm_the_next_mesh_set():
    """PyMeshLab kept the log of the set that failed, and wrote to it after its end."""
    code = f"""
import gc, pymeshlab, pymeshlab_curvdecim
for _ in range(4):
    failing = pymeshlab.MeshSet()
    failing.load_new_mesh({COW!r})
    try:
        failing.{DECIMATE}(targetperc=-1.0)
    except pymeshlab.PyMeshLabException as error:
        print(error)
    del failing
    gc.collect()
    pymeshlab.MeshSet().load_new_mesh({COW!r})
print("done")
"""
    answer = python(code)
    assert answer.stdout.endswith("done\n"), answer.stderr
    assert answer.stdout.count("targetperc is -1; it must be at least 0") == 4


@pytest.mark.parametrize("word", ["decimate", "Reduce", "simplify"])
def test_search_finds_all_filters(word, capfd):
    pymeshlab.search(word)
    found = capfd.readouterr().out
    assert all(name in found for name in ALL)


def test_search_finds_nothing_of_ours_by_another_word(capfd):
    pymeshlab.search("hausdorff")
    assert not any(name in capfd.readouterr().out for name in ALL)


def menu_name_and_parameters(script):
    root = ElementTree.fromstring(script)
    return root[0].get("name"), {each.get("name") for each in root[0]}


def test_script_for_2020_has_a_filter_for_daily_use_and_one_for_papers():
    daily, parameters = menu_name_and_parameters(filter_script(DECIMATE, preservetopology=True))
    assert {"TargetPerc", "PreserveTopology"} <= parameters
    assert "Lambda" not in parameters
    paper, parameters = menu_name_and_parameters(filter_script(DECIMATE, lambda_=0.1))
    assert paper == f"{daily} (Paper Settings)"
    assert {"Lambda", "Preset"} <= parameters
    assert "PreserveTopology" not in parameters


def test_script_for_2020_keeps_parts_apart_by_a_filter_for_assemblies():
    given = {"preventintersections": True, "preservetopology": True, "maxerror": 0.1}
    name, parameters = menu_name_and_parameters(filter_script(DECIMATE, **given))
    assert name.endswith(" (Assemblies)")
    assert {"PreventIntersections", "TargetPerc", "JoinBorders"} <= parameters
    assert "Lambda" not in parameters


def test_script_for_2020_cannot_mix_them():
    with pytest.raises(ValueError, match=r"lacks lambda_;.*Paper Settings.*lacks preservetopology"):
        filter_script(DECIMATE, lambda_=0.1, preservetopology=True)


def test_script_for_newer_versions_has_every_parameter():
    script = filter_script(DECIMATE, meshlab="2025.07", lambda_=0.1, preservetopology=True)
    name, parameters = menu_name_and_parameters(script)
    assert "Paper" not in name
    assert {"Lambda", "PreserveTopology"} <= parameters


@pytest.fixture
def stand_in(tmp_path):
    """Makes a folder with another pymeshlab, which is no more than its version and this code."""

    def make(version, code=""):
        for folder, file, text in (
            ("pymeshlab", "__init__.py", code),
            (
                f"pymeshlab-{version}.dist-info",
                "METADATA",
                f"Name: pymeshlab\nVersion: {version}\n",
            ),
        ):
            (tmp_path / folder).mkdir()
            (tmp_path / folder / file).write_text(text)
        return tmp_path

    return make


def last_error_line(answer):
    assert answer.returncode == 1
    return answer.stderr.splitlines()[-1]


@pytest.mark.parametrize("version", ["2022.2.post4", "2023.12.post3"])
def test_another_pymeshlab_is_named_before_it_lacks_a_name(stand_in, version):
    last = last_error_line(python("import pymeshlab_curvdecim", stand_in(version)))
    assert f"CurvDecim needs PyMeshLab 2025.7, and {version} is installed: pip install" in last


def test_no_pymeshlab_is_named():
    code = (
        "from importlib import metadata\n"
        "def version(name): raise metadata.PackageNotFoundError(name)\n"
        "metadata.version = version\n"
        "import pymeshlab_curvdecim"
    )
    assert "2025.7, and none is installed: pip install" in last_error_line(python(code))


NOT_THERE = "cannot open shared object file: No such file or directory"
WITHOUT_GL = f'raise ImportError("libGL.so.1: {NOT_THERE}")'
WITHOUT_OPENGL = f"""
import ctypes
class MeshSet: pass
def missing(name): raise OSError(f"{{name}}: {NOT_THERE}")
ctypes.CDLL = missing
print("Warning: Unable to load the following plugins")
"""


@pytest.mark.parametrize(
    ("code", "library"), [(WITHOUT_GL, "libGL.so.1"), (WITHOUT_OPENGL, "libOpenGL.so.0")]
)
def test_missing_graphics_library_is_named_with_the_remedy(stand_in, code, library):
    answer = python("import pymeshlab_curvdecim", stand_in("2025.7.post1", code))
    last = last_error_line(answer)
    assert f"{library}: {NOT_THERE}" in last
    assert last.endswith("sudo apt install libgl1 libopengl0")
    assert not answer.stdout


def test_another_error_of_pymeshlab_stays_as_it_is(stand_in):
    code = "raise ImportError('libother.so.1')"
    last = last_error_line(python("import pymeshlab_curvdecim", stand_in("2025.7.post1", code)))
    assert last == "ImportError: libother.so.1"


def test_what_pymeshlab_says_when_it_is_imported_is_passed_on(stand_in):
    code = "print('Warning: said'); MeshSet = type('MeshSet', (), {'NAME': 0})".replace(
        "NAME", "meshing_decimation_quadric_edge_collapse"
    )
    answer = python("import pymeshlab_curvdecim.plugin", stand_in("2025.7.post1", code))
    assert answer.stdout == "Warning: said\n"


def test_missing_plugin_says_what_to_do():
    answer = python("import pymeshlab_curvdecim", CURVDECIM_PLUGIN="/nowhere/plugin.so")
    assert answer.returncode == 1
    assert "CURVDECIM_PLUGIN names /nowhere/plugin.so, which does not exist" in answer.stderr
    assert "pip install ." in answer.stderr


def test_plugin_for_another_host_says_what_to_do(tmp_path):
    fake = tmp_path / "libfilter_curvdecim.so"
    fake.write_bytes(b"not a library")
    described = Path(os.environ["CURVDECIM_PLUGIN"]).with_name("parameters.json")
    (tmp_path / "parameters.json").write_bytes(described.read_bytes())
    answer = python("import pymeshlab_curvdecim", CURVDECIM_PLUGIN=str(fake))
    assert answer.returncode == 1
    assert f"cannot load {fake}" in answer.stderr
    assert "A plugin fits one version of PyMeshLab" in answer.stderr


def curvdecim(*arguments, folders=()):
    return python(f"import curvdecim.__main__ as c; c.main({arguments!r})", *folders)


def test_command_simplifies_a_file(tmp_path):
    output = str(tmp_path / "cow.ply")
    run = curvdecim(COW, output, "--target-perc", "0.2", "--no-preserve-boundary")
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(output)
    assert meshes.current_mesh().face_number() == 1160
    assert "\nfaces: 1160\n" in run.stdout


def test_command_prints_the_report_only(tmp_path):
    run = curvdecim(COW, str(tmp_path / "cow.ply"), "--target-face-num", "500")
    lines = run.stdout.splitlines()
    assert {"faces: 500", "stopped_by: target"} <= set(lines)
    assert all(re.fullmatch(r"\w+: [\w. -]+", line) for line in lines)
    assert len(lines) == len(set(lines))
    assert not run.stderr


def test_verbose_command_prints_what_pymeshlab_says_and_then_the_report(tmp_path):
    output = str(tmp_path / "cow.ply")
    run = curvdecim(COW, output, "--verbose", "--target-perc", "0.2", "--no-preserve-boundary")
    assert "'preserveboundary': False" in run.stdout
    assert "[ 100% ]" in run.stdout + run.stderr
    assert run.stdout.index("Saving file") < run.stdout.index("\nfaces: 1160\n")


def test_quiet_command_prints_nothing(tmp_path):
    run = curvdecim(COW, str(tmp_path / "cow.ply"), "--quiet", "--target-face-num", "500")
    assert (run.returncode, run.stdout, run.stderr) == (0, "", "")
    assert (tmp_path / "cow.ply").is_file()


@pytest.mark.parametrize(
    ("version", "code", "words"),
    [("2022.2.post4", "", "2022.2.post4 is installed"), ("2025.7.post1", WITHOUT_GL, "libGL.so.1")],
)
def test_command_names_a_pymeshlab_that_does_not_fit_in_one_line(stand_in, version, code, words):
    run = curvdecim(COW, "out.ply", folders=[stand_in(version, code)])
    assert run.returncode == 1
    assert run.stderr.startswith("curvdecim: ")
    assert words in run.stderr
    assert run.stderr.count("\n") == 1


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["nowhere.ply", "out.ply"], "there is no file nowhere.ply"),
        ([COW, "out.ply", "--target-perc", "-3"], "targetperc is -3"),
        ([COW, "out.ply", "--metric", "Cubic"], "invalid choice: 'Cubic'"),
        ([COW, "out.nosuchformat", "--target-perc", "0.5"], "nosuchformat"),
    ],
)
def test_command_refuses_clearly(arguments, words, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    run = curvdecim(*arguments)
    assert run.returncode in (1, 2)
    assert words in run.stderr
    assert "Traceback" not in run.stderr
    assert not list(tmp_path.iterdir())
