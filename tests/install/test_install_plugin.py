# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/install-plugin on trees that look like an installed MeshLab."""

import os
import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "install-plugin"
PLUGIN = "libfilter_curvdecim.so"
VERSIONS = ("2020.09", "2022.02", "2025.07")
USER_FOLDER = "VCG/MeshLab_64bit_fp/MeshLabExtraPlugins"  # as MeshLab asks Qt for it


class Machine:
    """A build of ours, a user, and programs that answer as on another machine."""

    def __init__(self, root):
        self.root = root
        self.programs = root / "programs"
        self.programs.mkdir()
        self.program("id", "echo 1000")
        for version in VERSIONS:
            plugin = root / "build" / "plugins" / f"meshlab-{version}" / PLUGIN
            plugin.parent.mkdir(parents=True)
            plugin.write_text(f"for {version}")

    def program(self, name, commands):
        file = self.programs / name
        file.write_text(f"#!/bin/sh\n{commands}\n")
        file.chmod(0o755)
        return file

    def meshlab(self, version):
        plugins = self.root / f"meshlab {version}" / "lib" / "plugins"
        plugins.mkdir(parents=True)
        (plugins / "libfilter_other.so").touch()
        library = plugins.parent / "libmeshlab-common.so"
        library.write_bytes(f"Qt 2020.01 \0{version}\0/{version}/\0".encode())
        return plugins.parents[1]

    def install(self, *meshlabs):
        environment = {
            "PATH": f"{self.programs}:{os.environ['PATH']}",
            "HOME": str(self.root),
            "XDG_DATA_HOME": str(self.root / "data"),
            "CURVDECIM_BUILD": str(self.root / "build"),
        }
        command = [SCRIPT, *meshlabs]
        return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=60)

    def installed(self):
        """Where the plugin is outside of the build, and what it is for."""
        places = (file for file in self.root.rglob(PLUGIN) if "build" not in file.parts)
        return {str(file.parent.relative_to(self.root)): file.read_text() for file in places}


@pytest.fixture
def machine(tmp_path):
    return Machine(tmp_path)


@pytest.mark.parametrize("version", ["2022.02", "2025.07"])
def test_user_needs_no_root(machine, version):
    run = machine.install(machine.meshlab(version))
    assert run.returncode == 0, run.stderr
    assert machine.installed() == {f"data/{USER_FOLDER}/{version}": f"for {version}"}


def test_root_installs_for_everybody(machine):
    machine.program("id", "echo 0")
    assert machine.install(machine.meshlab("2022.02")).returncode == 0
    assert machine.installed() == {"meshlab 2022.02/lib/plugins": "for 2022.02"}


def test_old_meshlab_has_its_own_folder_only(machine):
    assert machine.install(machine.meshlab("2020.09")).returncode == 0
    assert machine.installed() == {"meshlab 2020.09/lib/plugins": "for 2020.09"}


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_folder_of_somebody_else_needs_root(machine):
    meshlab = machine.meshlab("2020.09")
    (meshlab / "lib" / "plugins").chmod(0o555)
    run = machine.install(meshlab)
    assert run.returncode == 1
    assert f"As root:  sudo bash {SCRIPT}" in run.stderr


def test_appimage_says_its_version(machine):
    image = machine.program("MeshLab.AppImage", '[ "$1" = --version ] && echo MeshLab 2025.07')
    assert machine.install(image).returncode == 0
    assert machine.installed() == {f"data/{USER_FOLDER}/2025.07": "for 2025.07"}


def test_appimages_of_the_user_are_found(machine):
    folder = machine.root / "Applications"
    folder.mkdir()
    machine.program("M", "echo MeshLab 2022.02").rename(folder / "MeshLab2022.02-linux.AppImage")
    # The MeshLab of the machine that runs the tests is found as well, and must stay as it is.
    (machine.root / "build" / "plugins" / "meshlab-2020.09" / PLUGIN).unlink()
    machine.install()
    assert f"data/{USER_FOLDER}/2022.02" in machine.installed()


def test_missing_libraries_are_named(machine):
    machine.program("ldd", "echo 'libqhull_r.so.8.0 => not found'")
    machine.program("dpkg-query", "echo 'libqhull-r8.0 (>= 2020.1), libgomp1'")
    run = machine.install(machine.meshlab("2022.02"))
    assert run.returncode == 1
    assert "libfilter_other.so needs libqhull_r.so.8.0" in run.stderr
    assert "apt-get install libqhull-r8.0 libgomp1\n" in run.stderr
    assert not machine.installed()


def test_plugin_is_not_loaded_twice(machine):
    meshlab = machine.meshlab("2022.02")
    (meshlab / "lib" / "plugins" / PLUGIN).write_text("older")
    run = machine.install(meshlab)
    assert run.returncode == 1
    assert "has the plugin already" in run.stderr


@pytest.mark.parametrize(
    ("version", "words"),
    [
        ("2022.02d", "in double precision"),
        ("2023.12", "no plugin for MeshLab 2023.12 here, only for: 2020.09 2022.02 2025.07"),
    ],
)
def test_what_does_not_fit_is_refused(machine, version, words):
    run = machine.install(machine.meshlab(version))
    assert run.returncode == 1
    assert words in run.stderr
    assert not machine.installed()


def test_one_that_fails_does_not_keep_another_out(machine):
    run = machine.install(machine.root / "nowhere", machine.meshlab("2022.02"))
    assert run.returncode == 1
    assert "there is no" in run.stderr
    assert list(machine.installed().values()) == ["for 2022.02"]


def test_folders_that_may_not_be_read_are_passed_over(machine):
    machine.program("find", "echo 'find: Permission denied' >&2; /usr/bin/find \"$@\"; exit 1")
    run = machine.install(machine.meshlab("2022.02"))
    assert (run.returncode, run.stderr) == (0, "")
    assert list(machine.installed().values()) == ["for 2022.02"]


def test_folder_without_meshlab_is_named(machine):
    run = machine.install(machine.programs)
    assert run.returncode == 1
    assert f"no MeshLab in {machine.programs}" in run.stderr


@pytest.mark.parametrize(("option", "code"), [("--help", 0), ("--nosuch", 1)])
def test_help(machine, option, code):
    run = machine.install(option)
    assert run.returncode == code
    assert "install-plugin [MESHLAB ...]" in run.stdout
