# SPDX-License-Identifier: GPL-3.0-or-later
"""MeshLab with our plugin and its window, in each version: a private copy of the packaged one, or
a root tree of another Debian suite (scripts/fetch-meshlab-program).
"""

import os
import shutil
import subprocess
from pathlib import Path

import meshlab_2020

# The mounts are those of the process alone, and go with it.
ENTER = 'mount --rbind /proc "$0/proc" && mount --rbind /dev "$0/dev" && exec chroot "$0" "$@"'
OWN_MOUNTS = ("unshare", "--mount")
PLUGINS = "usr/lib/x86_64-linux-gnu/meshlab/plugins"


class InRootTree:
    """A MeshLab in a root tree, as in a container; the plugin is put beside its own."""

    def __init__(self, root, plugin):
        self.root = root
        self.home = root / "tmp" / "home"
        self.home.mkdir(parents=True, exist_ok=True)
        self.home.chmod(0o700)
        shutil.copy(plugin, root / PLUGINS)

    def command(self, mesh):
        """Opens a mesh file of the machine."""
        shutil.copy(mesh, self.root / "tmp")
        inside = ["meshlab", f"/tmp/{mesh.name}"]
        return [*OWN_MOUNTS, "sh", "-c", ENTER, str(self.root), *inside]

    def environment(self, **more):
        return {
            "PATH": "/usr/sbin:/usr/bin:/sbin:/bin",
            "HOME": "/tmp/home",
            "XDG_RUNTIME_DIR": "/tmp/home",
            "LC_ALL": "C.UTF-8",
            "LIBGL_ALWAYS_SOFTWARE": "1",
            **more,
        }


class Packaged(meshlab_2020.Tree):
    """The one that is installed."""

    def command(self, mesh):
        return [str(self.bin / "meshlab"), str(mesh)]


def why_absent(version, trees):
    """None when this version can be opened, else a sentence for pytest.skip."""
    if version == meshlab_2020.VERSION:
        return meshlab_2020.why_absent()
    if not (trees / version).is_dir():
        return f"MeshLab {version} is not in {trees} (scripts/fetch-meshlab-program)"
    return why_not_entered()


def why_not_entered():
    """None when a root tree can be entered; root of a container may be kept from it."""
    if os.geteuid() != 0:
        return "entering the root tree of MeshLab needs root"
    attempt = subprocess.run([*OWN_MOUNTS, "true"], capture_output=True, text=True, timeout=60)
    if attempt.returncode == 0:
        return None
    return f"entering the root tree of MeshLab is not allowed here: {attempt.stderr.strip()}"


def program(version, trees, plugin, directory):
    """The MeshLab of this version, with the plugin."""
    if version == meshlab_2020.VERSION:
        return Packaged(directory, Path(plugin))
    return InRootTree(trees / version, plugin)
