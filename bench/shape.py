# SPDX-License-Identifier: GPL-3.0-or-later
"""What a mesh is like by itself: the angles of its faces, its pieces, where it cuts itself."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pymeshlab
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from surface import Floats, Surface

_LOW_QUANTILE = 0.05  # the angle that only so many faces are below


@dataclass(frozen=True)
class Shape:
    """Angles in degrees; 60 is an equilateral face."""

    angle_mean: float  # of the smallest angles of the faces
    angle_low: float  # 5 % of the faces have a smaller one
    components: int  # pieces that share no vertex
    self_intersecting: int  # faces that cut another one


def shape_of(surface: Surface) -> Shape:
    """The shape of any mesh with a face."""
    angles = smallest_angles(surface)
    return Shape(
        angle_mean=float(angles.mean()),
        angle_low=float(np.quantile(angles, _LOW_QUANTILE)),
        components=components(surface),
        self_intersecting=_self_intersecting(surface),
    )


def smallest_angles(surface: Surface) -> Floats:
    """(m,), degrees; 0 for a face without area."""
    along = np.roll(surface.corners, -1, axis=1) - surface.corners  # (m, 3, 3)
    back = -np.roll(along, 1, axis=1)
    sine = np.linalg.norm(np.cross(along, back), axis=2)
    angles = np.degrees(np.arctan2(sine, np.einsum("fij,fij->fi", along, back)))
    return np.where(surface.areas > 0, angles.min(axis=1), 0.0)


def components(surface: Surface) -> int:
    """Pieces that share no vertex."""
    compact = surface.without_unreferenced()
    start, end = compact.directed_edges.T
    size = len(compact.vertices)
    graph = coo_array((np.ones(len(start), dtype=np.int8), (start, end)), shape=(size, size))
    return int(connected_components(graph, directed=False)[0])


def _self_intersecting(surface: Surface) -> int:
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.add_mesh(pymeshlab.Mesh(surface.vertices, surface.faces.astype("int32")))
    meshes.apply_filter("compute_selection_by_self_intersections_per_face")
    return meshes.current_mesh().selected_face_number()
