# SPDX-License-Identifier: GPL-3.0-or-later
"""pymeshlab.search, with our filters: its own index is made before they are loaded."""

import functools

from .description import read_filters
from .plugin import pymeshlab


def extend_search():
    """Makes pymeshlab.search print our filters that match the keyword, after PyMeshLab's own."""
    if hasattr(pymeshlab.search, "__wrapped__"):
        return
    original = pymeshlab.search

    @functools.wraps(original)
    def search(keyword):
        original(keyword)
        for each in matching(keyword):
            print(f"{each.python_name}: {each.info.splitlines()[0]}")

    pymeshlab.search = search


def matching(keyword):
    """Our filters whose names or texts have the keyword, in the order of the menu."""
    word = keyword.casefold()
    texts = {
        each: f"{each.menu_name} {each.python_name} {each.info}" for each in read_filters().values()
    }
    return [each for each, text in texts.items() if word in text.casefold()]
