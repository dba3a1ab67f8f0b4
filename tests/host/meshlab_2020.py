# SPDX-License-Identifier: GPL-3.0-or-later
"""The packaged MeshLab 2020.09 with our plugin, without touching the system's plugin directory.

MeshLab looks for its plugins relative to its own executable, so a private tree of links to the
package's libraries and plugins, ours among them, and copies of the executables is enough.
"""

import os
import shutil
import subprocess
from pathlib import Path

VERSION = "2020.09"
PLUGIN_NAME = "libfilter_curvdecim.so"
SERVER_SECONDS = 120


def why_absent():
    """None when MeshLab 2020.09 can be run, else a sentence for pytest.skip."""
    if not shutil.which("meshlabserver"):
        return f"no meshlabserver: the packaged MeshLab is not {VERSION} or is not installed"
    answer = subprocess.run(
        ["meshlabserver"], env=environment(), capture_output=True, text=True, timeout=60
    ).stdout
    return None if VERSION in answer else f"the installed meshlabserver is not {VERSION}"


def environment(**more):
    """Software rendering without a window system unless a display is given."""
    return {**os.environ, "QT_QPA_PLATFORM": "offscreen", "LIBGL_ALWAYS_SOFTWARE": "1", **more}


class Tree:
    """bin/ and lib/ of the package as a private tree, plus one plugin."""

    def __init__(self, root, plugin):
        self.bin = root / "bin"
        self.home = root / "home"
        package = _package_libraries()
        libraries = root / package.relative_to(package.parents[2])
        plugins = libraries / "plugins"
        for directory in (self.bin, self.home, plugins):
            directory.mkdir(parents=True)
        self.home.chmod(0o700)
        for name in ("meshlab", "meshlabserver"):
            shutil.copy(shutil.which(name), self.bin)
        _link_files(package, libraries)
        _link_files(package / "plugins", plugins)
        ours = plugins / PLUGIN_NAME
        ours.unlink(missing_ok=True)  # one that is installed may be another version
        ours.symlink_to(plugin)

    def environment(self, **more):
        """Settings are read from and written to the tree, never the user's home."""
        return environment(HOME=str(self.home), XDG_RUNTIME_DIR=str(self.home), **more)

    def serve(self, mesh, script, output, *mask, more=()):
        """Runs meshlabserver; returns its process with everything it printed as text.

        more: further arguments before the output.
        """
        command = ["xvfb-run", "-a", self.bin / "meshlabserver", "-i", mesh, *more, "-o", output]
        command += [*(("-m", *mask) if mask else ()), "-s", script]
        return subprocess.run(
            command,
            env=self.environment(),
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=SERVER_SECONDS,
        )


def _package_libraries():
    prefix = Path(shutil.which("meshlabserver")).resolve().parent.parent
    return next(prefix.glob("lib/*/meshlab/libmeshlab-common.so")).parent


def _link_files(source, target):
    for file in source.iterdir():
        if file.is_file():
            (target / file.name).symlink_to(file)
