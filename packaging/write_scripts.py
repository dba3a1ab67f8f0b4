# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a script for meshlabserver 2020.09 for each filter:  write_scripts.py FOLDER

Complete ones, as examples of a release: meshlabserver aborts on a script that leaves something out.
"""

import sys
from pathlib import Path

from pymeshlab_curvdecim import filter_script
from pymeshlab_curvdecim.description import read_filters

NUMBERS = {  # to change; defaults that depend on the mesh are none
    "targetperc": 0.5,
    "originalmesh": 0,
    "simplifiedmesh": 1,
    "tolerance": 0.01,
}


def short_name(filter_name):
    """meshing_decimation_curvature_edge_collapse is edge_collapse."""
    return "_".join(filter_name.split("_")[-2:])


def example(description):
    asked = {each.python_name for each in description.parameters}
    given = {name: value for name, value in NUMBERS.items() if name in asked}
    return filter_script(description.python_name, meshlab="2020.09", **given)


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for name, description in read_filters().items():
        file = folder / f"{short_name(name)}.mlx"
        file.write_text(example(description), encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
