# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters, their parameters and results, as the plugin describes them in parameters.json."""

import html
import json
import operator
import re
from dataclasses import dataclass
from typing import Any, Literal

from .plugin import parameters_file, pymeshlab

Length = float | pymeshlab.PureValue | pymeshlab.PercentageValue
DEPENDS_ON_MESH = "dynamic"


@dataclass(frozen=True)
class Parameter:
    """One parameter; its default is None when it depends on the mesh."""

    name: str
    python_name: str
    type: str
    default: Any
    label: str
    help: str
    values: tuple[str, ...]
    meanings: tuple[str, ...]

    @property
    def annotation(self):
        types = {"int": int, "float": float, "bool": bool, "length": Length, "layer": int}
        plain = Literal[self.values] if self.type == "enum" else types[self.type]
        return plain if self.default is not None else plain | None

    def checked(self, value):
        """The value as PyMeshLab wants it; an error names the parameter."""
        try:
            return _CONVERSIONS[self.type](value, self.values)
        except (IndexError, TypeError, ValueError) as error:
            kind = "one of " + ", ".join(self.values) if self.values else f"of type {self.type}"
            problem = TypeError if isinstance(error, TypeError) else ValueError
            raise problem(f"{self.python_name} must be {kind}, not {value!r}") from None


@dataclass(frozen=True)
class Result:
    """An entry of what a filter returns; one with labels is the number of a label in PyMeshLab."""

    name: str
    unit: str
    meaning: str
    labels: tuple[str, ...]


@dataclass(frozen=True)
class Dialog:
    """A filter as an entry of MeshLab's menu."""

    menu_name: str
    parameters: tuple[Parameter, ...]

    def lacks(self, names):
        """Those of the Python names that it does not ask for, in words."""
        return ", ".join(sorted(names - {each.python_name for each in self.parameters}))


@dataclass(frozen=True)
class Filter:
    """A filter by its name in MeshLab's menu and in Python."""

    menu_name: str
    python_name: str
    info: str
    parameters: tuple[Parameter, ...]
    results: tuple[Result, ...]
    flat_dialogs: tuple[Dialog, ...]

    def whole_dialog(self):
        """Its entry where a dialog unfolds."""
        return Dialog(self.menu_name, self.parameters)

    def flat_dialog(self, names):
        """The entry with all these parameters, by Python name, where a dialog does not unfold."""
        for dialog in self.flat_dialogs:
            if not dialog.lacks(names):
                return dialog
        apart = "; ".join(
            f"'{each.menu_name}' lacks {each.lacks(names)}" for each in self.flat_dialogs
        )
        raise ValueError(f"no filter of MeshLab 2020.09 has all of these: {apart}")

    def checked(self, given):
        """The given values by Python name, as PyMeshLab wants them."""
        known = {each.python_name: each for each in self.parameters}
        if unknown := ", ".join(given.keys() - known.keys()):
            raise TypeError(f"{self.python_name} has no {unknown}, only {', '.join(known)}")
        return {name: known[name].checked(value) for name, value in given.items()}

    def readable(self, report):
        """What the filter returned, with labels instead of numbers: PyMeshLab passes no texts."""
        labels = {each.name: each.labels for each in self.results if each.labels}
        return {
            name: labels[name][value] if name in labels else value for name, value in report.items()
        }


def read_filters():
    """The plugin's filters by Python name."""
    described = json.loads(parameters_file().read_text(encoding="utf-8"))
    return {each["python_name"]: _filter(each) for each in described["filters"]}


def _filter(described):
    parameters = tuple(_parameter(each) for each in described["parameters"])
    return Filter(
        described["menu_name"],
        described["python_name"],
        _plain_text(described["info"]),
        parameters,
        tuple(_result(each) for each in described["results"]),
        tuple(_dialog(each, parameters) for each in described["flat_dialogs"]),
    )


def _dialog(described, parameters):
    asked = [each for each in parameters if each.name in described["parameters"]]
    return Dialog(described["menu_name"], tuple(asked))


def _parameter(described):
    default = described["default"]
    return Parameter(
        described["name"],
        described["python_name"],
        described["type"],
        None if default == DEPENDS_ON_MESH else default,
        _plain_text(described["label"]),
        _plain_text(described["help"]),
        tuple(each["name"] for each in described["values"]),
        tuple(_plain_text(each["meaning"]) for each in described["values"]),
    )


def _result(described):
    meaning = _plain_text(described["meaning"])
    return Result(described["name"], described["unit"], meaning, tuple(described["labels"]))


def _plain_text(rich):
    return html.unescape(re.sub(r"<[^>]*>", "", re.sub(r"<br ?/?>", "\n", rich))).strip()


def _choice(value, choices):
    """A choice by its name or its index."""
    name = value if isinstance(value, str) else choices[operator.index(value)]
    return choices[choices.index(name)]


def _length(value, _):
    """A plain number is a length in the mesh's unit."""
    given = isinstance(value, pymeshlab.PureValue | pymeshlab.PercentageValue)
    return value if given else pymeshlab.PureValue(float(value))


def _truth(value, _):
    if value in (True, False):
        return bool(value)
    raise TypeError


_CONVERSIONS = {
    "int": lambda value, _: operator.index(value),
    "float": lambda value, _: float(value),
    "bool": _truth,
    "enum": _choice,
    "length": _length,
    "layer": lambda value, _: operator.index(value),
}
