# SPDX-License-Identifier: GPL-3.0-or-later
"""What is wrong with a mesh by itself: holes, folds, edges and vertices that are not manifold."""

from __future__ import annotations

import numpy as np
from judge import topology
from numpy.typing import NDArray
from shape import components
from surface import Surface

MERGED = "merged_"
"""Prefix of a count on the mesh whose vertices of equal position are made one."""

_FOLD = (
    179.0  # degrees between the normals of two faces at an edge; above it they lie on each other
)
_OF_TOPOLOGY = ("nm_edges", "nm_vertices", "boundary", "zero_area")
_COUNTS = (*_OF_TOPOLOGY, "back_to_back", "components")


def defects(surface: Surface) -> dict[str, int]:
    """Counts by name, of the mesh as it is and, with the prefix, of the merged one."""
    welded = surface.welded()
    merged = _counts(welded) if welded else dict.fromkeys(_COUNTS, 0)
    return _counts(surface) | {MERGED + name: count for name, count in merged.items()}


def _counts(surface: Surface) -> dict[str, int]:
    of_topology = topology(surface)
    return {name: of_topology[name] for name in _OF_TOPOLOGY} | {
        "back_to_back": int(np.count_nonzero(folded(surface) | doubled(surface))),
        "components": components(surface),
    }


def folded(surface: Surface) -> NDArray[np.bool_]:
    """(m,): faces that lie on the other face of an edge of two; faces without area never do."""
    first, second = _edges_of_two(surface)
    start = surface.directed_edges[:, 0]
    same_way = start[first] == start[second]  # one of the two is turned over
    ours, others = first % len(surface.faces), second % len(surface.faces)
    cosine = np.einsum("ij,ij->i", surface.normals[ours], surface.normals[others])
    at_fold = np.where(same_way, -cosine, cosine) < np.cos(np.radians(_FOLD))
    result = np.zeros(len(surface.faces), dtype=bool)
    result[ours[at_fold]] = result[others[at_fold]] = True
    return result


def _edges_of_two(surface: Surface) -> NDArray[np.int64]:
    """(2, k): both places in `directed_edges` of every edge that two faces have."""
    ends = np.sort(surface.directed_edges, axis=1)
    _, edge, uses = np.unique(ends, axis=0, return_inverse=True, return_counts=True)
    edge = edge.reshape(-1)
    by_edge = np.argsort(edge, kind="stable")
    return by_edge[uses[edge[by_edge]] == 2].reshape(-1, 2).T


def doubled(surface: Surface) -> NDArray[np.bool_]:
    """(m,): faces whose three vertices another face has, too."""
    corners = np.sort(surface.faces, axis=1)
    _, index, uses = np.unique(corners, axis=0, return_inverse=True, return_counts=True)
    return uses[index.reshape(-1)] > 1
