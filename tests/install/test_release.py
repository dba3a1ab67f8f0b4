# SPDX-License-Identifier: GPL-3.0-or-later
"""What scripts/package makes: complete, true in what it says, and the same bits twice."""

import hashlib
import os
import platform
import re
import shutil
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import pymeshlab
import pytest

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build"
HOST_WITH_SERVER = "meshlab-2020.09"
HOSTS = (HOST_WITH_SERVER, "meshlab-2022.02", "meshlab-2025.07")
PLUGIN = "libfilter_curvdecim.so"
SAMPLE = ROOT / "sample_meshes" / "bumpy_sphere.ply"
EXAMPLES = [  # in the order of their names
    f"examples/{name}.mlx"
    for name in (
        "algebraic_sphere",
        "curvature_importance",
        "edge_collapse",
        "simplification_error",
        "vertex_clustering",
        "vertex_removal",
    )
]
MINUTES = 600  # seconds; nothing is compiled


def make_release(folder, **environment):
    run = subprocess.run(
        [ROOT / "scripts" / "package", folder],
        env={**os.environ, "CURVDECIM_HOSTS": "", **environment},  # all of them
        capture_output=True,
        text=True,
        timeout=MINUTES,
    )
    assert run.returncode == 0, run.stdout + run.stderr
    return folder


@pytest.fixture(scope="session")
def release(tmp_path_factory):
    missing = [host for host in HOSTS if not (BUILD / "plugins" / host / PLUGIN).is_file()]
    if missing:
        pytest.skip(f"not built in {BUILD}: {', '.join(missing)}")
    return make_release(tmp_path_factory.mktemp("release"))


@pytest.fixture(params=HOSTS)
def desktop_zip(release, request):
    """The zip for a host, and the folder in it."""
    (file,) = release.glob(f"*-{request.param}-*.zip")
    return zipfile.ZipFile(file), file.stem, request.param


@pytest.fixture(scope="session")
def debian_package(release):
    file = next(release.glob("*.deb"), None)
    if file is None:
        pytest.skip("no Debian package: the installed MeshLab is of no version in cmake/hosts.txt")
    return file


def said_by(*command, **options):
    run = subprocess.run(command, capture_output=True, text=True, timeout=MINUTES, **options)
    assert run.returncode == 0, run.stdout + run.stderr
    return run.stdout


def test_every_file_is_in_the_sums(release):
    sums = dict(reversed(line.split()) for line in (release / "SHA256SUMS").open())
    files = [file for file in release.iterdir() if file.name != "SHA256SUMS"]
    assert sums == {file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in files}
    assert len(list(release.glob("*.zip"))) == len(HOSTS)
    assert len(list(release.glob("*.whl"))) == 1


def test_same_bits_twice(release, tmp_path):
    other = make_release(tmp_path, TZ="Asia/Tokyo", LC_ALL="C")
    assert (other / "SHA256SUMS").read_text() == (release / "SHA256SUMS").read_text()


def test_zip_is_complete(desktop_zip):
    archive, folder, host = desktop_zip
    files = {name for name in archive.namelist() if not name.endswith("/")}
    wanted = ["INSTALL.txt", "LICENSE", "install-plugin", f"plugins/{host}/{PLUGIN}"]
    wanted += EXAMPLES if host == HOST_WITH_SERVER else []
    assert files == {f"{folder}/{name}" for name in wanted}
    text = archive.read(f"{folder}/INSTALL.txt").decode()
    assert f"MeshLab {host.partition('-')[2]}" in text
    assert f"plugins/{host}/{PLUGIN}" in text
    assert "@" not in text


def test_examples_run_each_filter_by_all_its_numbers(release):
    (file,) = release.glob(f"*-{HOST_WITH_SERVER}-*.zip")
    archive = zipfile.ZipFile(file)
    names = set()
    for example in EXAMPLES:
        (action,) = ElementTree.fromstring(archive.read(f"{file.stem}/{example}"))
        names.add(action.get("name"))
        values = {each.get("name"): each.get("value") for each in action}
        assert values.get("TargetPerc", "0.5") == "0.5"
        assert len(values) > 5
        assert None not in values.values()
    assert len(names) == len(EXAMPLES)
    instructions = archive.read(f"{file.stem}/INSTALL.txt").decode()
    assert re.search(r"-s (examples/\S+)", instructions)[1] in EXAMPLES


def test_plugin_does_not_name_where_it_was_built(desktop_zip):
    archive, folder, host = desktop_zip
    assert str(ROOT).encode() not in archive.read(f"{folder}/plugins/{host}/{PLUGIN}")


@pytest.mark.skipif(
    "Debian GNU/Linux 12" not in platform.freedesktop_os_release()["PRETTY_NAME"],
    reason="releases are built on Debian 12",
)
def test_instructions_name_the_libraries_it_needs(desktop_zip, tmp_path):
    archive, folder, host = desktop_zip
    plugin = archive.extract(f"{folder}/plugins/{host}/{PLUGIN}", tmp_path)
    needed = said_by("readelf", "--version-info", "--wide", plugin)
    text = archive.read(f"{folder}/INSTALL.txt").decode()
    assert f"glibc {newest('GLIBC', needed)}" in text
    assert f"GLIBCXX_{newest('GLIBCXX', needed)}" in text


def newest(library, needed):
    versions = re.findall(rf"\b{library}_([0-9.]+)", needed)
    return max(versions, key=lambda version: [int(part) for part in version.split(".")])


def test_plugin_can_be_installed_from_the_zip(desktop_zip, tmp_path):
    archive, folder, host = desktop_zip
    archive.extractall(tmp_path)
    version = host.partition("-")[2]
    own_plugins = tmp_path / "meshlab" / "plugins"
    own_plugins.mkdir(parents=True)
    (own_plugins / "libfilter_other.so").touch()
    (own_plugins.parent / "libmeshlab-common.so").write_bytes(f"\0{version}\0".encode())
    home = {**os.environ, "XDG_DATA_HOME": str(tmp_path / "home")}
    said_by("bash", tmp_path / folder / "install-plugin", own_plugins.parent, env=home)
    (installed,) = [*own_plugins.glob(PLUGIN), *(tmp_path / "home").rglob(PLUGIN)]
    assert installed.read_bytes() == archive.read(f"{folder}/plugins/{host}/{PLUGIN}")


def test_debian_package_has_the_plugin_and_its_documents(debian_package):
    listed = said_by("dpkg-deb", "--contents", debian_package)
    files = [line.split()[-1] for line in listed.splitlines() if line.startswith("-")]
    documents = "./usr/share/doc/meshlab-plugin-curvdecim"
    machine = f"{platform.machine()}-linux-gnu"
    has_server = "meshlab (>= 2020.09)" in said_by("dpkg-deb", "--field", debian_package, "Depends")
    assert files == [
        f"./usr/lib/{machine}/meshlab/plugins/{PLUGIN}",
        f"{documents}/changelog.Debian.gz",
        f"{documents}/copyright",
        *(f"{documents}/{name}" for name in EXAMPLES if has_server),
    ]
    assert all(line.split()[1] == "root/root" for line in listed.splitlines())


def test_debian_package_depends_on_the_meshlab_it_is_for(debian_package):
    depends = said_by("dpkg-deb", "--field", debian_package, "Depends").strip().split(", ")
    low, high = (
        re.fullmatch(rf"meshlab \({sign} (.*)\)", each)[1]
        for sign, each in zip((">=", "<<"), depends[:2], strict=True)
    )
    installed = said_by("dpkg-query", "--show", "--showformat", "${Version}", "meshlab")
    for operator, bound in (("ge", low), ("lt", high)):
        subprocess.run(["dpkg", "--compare-versions", installed, operator, bound], check=True)
    assert any(each.startswith("libstdc++6 (>=") for each in depends)


def test_lintian_finds_nothing(debian_package):
    if not shutil.which("lintian"):
        pytest.skip("lintian is not installed")
    # It is not meant for Debian's archive, where a first upload closes a request.
    command = ["lintian", "--suppress-tags", "initial-upload-closes-no-bugs", debian_package]
    assert said_by(*command) == ""


@pytest.fixture(scope="session")
def fresh(release, tmp_path_factory):
    """Runs a program of a new environment with the wheel, where PyMeshLab is that of the tests."""
    folder = tmp_path_factory.mktemp("fresh")
    said_by(sys.executable, "-m", "venv", folder)
    python = folder / "bin" / "python"
    (site,) = folder.glob("lib/python*/site-packages")
    (site / "tests.pth").write_text(str(Path(pymeshlab.__file__).parents[1]))
    (wheel,) = release.glob("*.whl")
    # Those of the tests may have the package, too.
    offline = ("--no-index", "--no-deps", "--ignore-installed")
    said_by(python, "-m", "pip", "install", *offline, wheel)
    said_by(python, "-m", "pip", "check")
    clean = {k: v for k, v in os.environ.items() if k not in ("CURVDECIM_PLUGIN", "PYTHONPATH")}

    def run(program, *arguments):
        command = [folder / "bin" / program, *arguments]
        return subprocess.run(
            command, cwd=folder, env=clean, capture_output=True, text=True, timeout=60
        )

    return run


def test_wheel_decimates(fresh, tmp_path):
    run = fresh("curvdecim", SAMPLE, tmp_path / "small.ply", "--target-perc", "0.05")
    assert "\nfaces: 256\n" in run.stdout, run.stderr
    assert (tmp_path / "small.ply").is_file()


def test_wheel_is_imported_within_a_second(fresh):
    code = "import time; t = time.monotonic(); import pymeshlab_curvdecim as c; "
    code += "print(c.__file__, time.monotonic() - t)"
    seconds = []
    for _ in range(3):  # the first reads from the disk
        file, passed = fresh("python", "-c", code).stdout.split()
        seconds.append(float(passed))
    assert "fresh" in file
    assert min(seconds) < 1


def test_another_pymeshlab_is_one_clear_error(fresh):
    code = "from importlib import metadata; metadata.version = lambda name: '2023.12.post3'; "
    run = fresh("python", "-c", code + "import pymeshlab_curvdecim")
    assert run.returncode == 1
    last = run.stderr.splitlines()[-1]
    assert "CurvDecim needs PyMeshLab 2025.7, and 2023.12.post3 is installed" in last
    assert "pip install 'pymeshlab==2025.7.*'" in last


def test_one_version_of_pymeshlab_is_required_everywhere():
    source = (ROOT / "python" / "pymeshlab_curvdecim" / "plugin.py").read_text()
    version = re.search('PYMESHLAB_VERSION = "(.*)"', source)[1]
    pin = f"pymeshlab=={version}.*"
    stated = tomllib.loads((ROOT / "pyproject.toml").read_text())
    assert pin in stated["project"]["dependencies"]
    assert pin in stated["build-system"]["requires"]
