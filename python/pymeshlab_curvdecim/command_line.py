# SPDX-License-Identifier: GPL-3.0-or-later
"""The curvdecim command: simplifies one mesh file."""

import argparse
import re
import sys
from pathlib import Path

from .description import read_filters
from .filter_functions import load
from .plugin import pymeshlab

FILTER = "meshing_decimation_curvature_edge_collapse"


def main(arguments=None):
    """Ends the program with a message on any error, before the output is written."""
    try:
        options = vars(_parser().parse_args(arguments))
        quiet = options.pop("quiet")
        report = simplify(options.pop("input"), options.pop("output"), **options)
    except (OSError, pymeshlab.PyMeshLabException, TypeError, ValueError) as error:
        sys.exit(f"curvdecim: {str(error).strip()}")
    if not quiet:
        print(*(f"{name}: {value}" for name, value in report.items()), sep="\n")


def simplify(source, target, verbose=False, **options):
    """Reads, simplifies and writes a mesh; returns the filter's report."""
    if not Path(source).is_file():
        raise FileNotFoundError(f"there is no file {source}")
    meshes = pymeshlab.MeshSet(verbose=verbose)
    meshes.load_new_mesh(source)
    report = load()[FILTER](meshes, **options)
    meshes.save_current_mesh(target)
    return report


def _parser():
    parser = argparse.ArgumentParser(
        prog="curvdecim",
        description="Simplifies a triangle mesh and keeps what is curved.",
        argument_default=argparse.SUPPRESS,
    )
    parser.add_argument("input", help="mesh file in a format that MeshLab reads")
    parser.add_argument("output", help="mesh file to write; its ending chooses the format")
    amount = parser.add_mutually_exclusive_group()
    amount.add_argument(
        "--quiet", action="store_true", default=False, help="print nothing but errors"
    )
    amount.add_argument(
        "--verbose", action="store_true", help="print what PyMeshLab says, too: progress and log"
    )
    for parameter in read_filters()[FILTER].parameters:
        parser.add_argument(_flag(parameter.name), **_argument(parameter))
    return parser


def _flag(name):
    """TargetPerc is --target-perc."""
    return "--" + re.sub(r"(?<!^)(?=[A-Z])", "-", name).lower()


def _argument(parameter):
    """What argparse needs to know of a parameter."""
    default = "" if parameter.default is None else f" Default: {parameter.default}."
    text = f"{parameter.label}. {parameter.help}{default}".replace("%", "%%")
    common = {"dest": parameter.python_name, "help": text}
    if parameter.type == "bool":
        return common | {"action": argparse.BooleanOptionalAction}
    if parameter.type == "enum":
        return common | {"choices": parameter.values}
    types = {"int": int, "float": float, "length": _length}
    return common | {"type": types[parameter.type], "metavar": parameter.type.upper()}


def _length(text):
    """0.01 in the mesh's unit, or 0.5% of the bounding box's diagonal."""
    if text.endswith("%"):
        return pymeshlab.PercentageValue(float(text[:-1]))
    return pymeshlab.PureValue(float(text))
