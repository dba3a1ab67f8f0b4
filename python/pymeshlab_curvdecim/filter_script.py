# SPDX-License-Identifier: GPL-3.0-or-later
"""Filter scripts (.mlx) for MeshLab and meshlabserver.

meshlabserver 2020.09 as packaged aborts on a script that leaves out any parameter but the first,
so scripts are better made than typed.
"""

from xml.etree import ElementTree

from .description import read_filters
from .plugin import pymeshlab

HEADER = "<!DOCTYPE FilterScript>\n"
TYPES = {
    "bool": "RichBool",
    "enum": "RichEnum",
    "float": "RichFloat",
    "int": "RichInt",
    "length": "RichAbsPerc",
    "layer": "RichMesh",
}


def filter_script(filter_name, /, meshlab="2020.09", **given):
    """The text of a script that runs one filter, by its Python name, with these parameters.

    The others have their default; a default that depends on the mesh is left to MeshLab, or is
    that of a mesh without a selection. MeshLab and meshlabserver 2020.09 have filters of their own
    for the settings of papers and for assemblies, and a script for them cannot mix these; name
    another version of MeshLab for a script that it shall run.
    """
    description = read_filters()[filter_name]
    values = description.checked(given)
    is_flat = meshlab == "2020.09"
    dialog = description.flat_dialog(values.keys()) if is_flat else description.whole_dialog()
    root = ElementTree.Element("FilterScript")
    action = ElementTree.SubElement(root, "filter", name=dialog.menu_name)
    for parameter in dialog.parameters:
        value = values.get(parameter.python_name, parameter.default)
        if value is not None or parameter.type == "bool":
            ElementTree.SubElement(action, "Param", _attributes(parameter, value))
    ElementTree.indent(root)
    return HEADER + ElementTree.tostring(root, encoding="unicode") + "\n"


def _attributes(parameter, value):
    common = {"name": parameter.name, "type": TYPES[parameter.type]}
    common |= {"description": parameter.label, "tooltip": ""}
    return common | _WRITERS.get(parameter.type, _number)(parameter, value)


def _number(_, value):
    return {"value": repr(value)}


def _truth(_, value):
    return {"value": "true" if value else "false"}


def _choice(parameter, value):
    names = {f"enum_val{index}": name for index, name in enumerate(parameter.values)}
    index = parameter.values.index(value)
    return {"value": str(index), "enum_cardinality": str(len(names)), **names}


def _length(parameter, value):
    if isinstance(value, pymeshlab.PercentageValue):
        name = parameter.python_name
        raise ValueError(f"{name} must be a length: a script knows no mesh to take a share of")
    length = repr(value.value() if isinstance(value, pymeshlab.PureValue) else value)
    return {"value": length, "min": "0", "max": length}


_WRITERS = {"bool": _truth, "enum": _choice, "length": _length}
