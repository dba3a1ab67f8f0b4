# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes each filter a Python function, and that function a method of pymeshlab.MeshSet.

PyMeshLab makes methods of its filters when it is imported, so it cannot know of ours.
"""

import functools
import inspect
import textwrap

import numpy

from .description import read_filters
from .plugin import load_plugin, pymeshlab
from .search import extend_search


@functools.cache
def load():
    """Loads the plugin once; returns the filters by name, each now a method of MeshSet too."""
    filters = read_filters()
    if not filters.keys() <= set(pymeshlab.filter_list()):
        load_plugin()
    extend_search()
    functions = {name: filter_function(each) for name, each in filters.items()}
    for name, function in functions.items():
        setattr(pymeshlab.MeshSet, name, function)
    return functions


def filter_function(description):
    """A function of a MeshSet and the filter's parameters, with a true signature and help."""

    def function(mesh_set, /, **given):
        name, values = description.python_name, description.checked(given)
        try:
            return description.readable(mesh_set.apply_filter(name, **values))
        except pymeshlab.PyMeshLabException:
            let_go_of_log()
            raise

    function.__name__ = function.__qualname__ = description.python_name
    function.__module__ = __package__
    function.__signature__ = _signature(description)
    function.__doc__ = _documentation(description)
    return function


def let_go_of_log():
    """Makes PyMeshLab forget the log of a mesh set, which a filter that failed leaves it with.

    It would write there when it next reads a file, also after the end of that mesh set, and crash.
    After a filter that succeeded it forgets.
    """
    triangle = pymeshlab.Mesh(numpy.eye(3), numpy.array([[0, 1, 2]]))
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.add_mesh(triangle)
    meshes.apply_filter("compute_normal_per_vertex")


def _signature(description):
    mesh_set = inspect.Parameter(
        "mesh_set", inspect.Parameter.POSITIONAL_ONLY, annotation=pymeshlab.MeshSet
    )
    options = [
        inspect.Parameter(
            each.python_name,
            inspect.Parameter.KEYWORD_ONLY,
            default=each.default,
            annotation=each.annotation,
        )
        for each in description.parameters
    ]
    return inspect.Signature([mesh_set, *options], return_annotation=dict)


def _documentation(description):
    sections = [description.info, "Parameters\n----------"]
    sections += [_parameter_help(each) for each in description.parameters]
    sections += ["Returns\n-------", "A dictionary with"]
    return "\n\n".join(sections + [_result_help(each) for each in description.results])


def _parameter_help(parameter):
    choices = zip(parameter.values, parameter.meanings, strict=True)
    lines = [parameter.label + ".", parameter.help]
    lines += [f"{name}: {meaning}." for name, meaning in choices]
    return f"{parameter.python_name} : {parameter.type}\n{_indented(lines)}"


def _result_help(result):
    lines = [f"{result.meaning}."]
    lines += [f"One of {', '.join(result.labels)}."] if result.labels else []
    heading = f"{result.name} ({result.unit})" if result.unit else result.name
    return f"{heading}\n{_indented(lines)}"


def _indented(lines):
    return textwrap.indent("\n".join(lines), "    ")
