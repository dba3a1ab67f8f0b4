# SPDX-License-Identifier: GPL-3.0-or-later
"""What a mesh in the host holds beside its shape, and how much of it another mesh holds too."""

import re
from typing import NamedTuple

import igl
import numpy as np
import pymeshlab
from measures import Surface, double_area_normals, surface
from textured_sheet import IMAGES, WIDTHS, draw_images

VERTEX_COORDINATES, VERTEX_COLOURS = "vertex coordinates", "vertex colours"
WEDGES, PAGES, FACE_COLOURS = "wedge coordinates", "pages", "face colours"
NO_PAGE = -1
ALLOWED = 0.02  # of an image's side, or of a colour's range
INNER_POINTS = np.array([[0.8, 0.1, 0.1], [0.1, 0.8, 0.1], [0.1, 0.1, 0.8]])  # of a face


class Held(NamedTuple):
    """What a mesh holds. Normals and values are those of the corners of faces.

    values: by kind, (m, 3, k). The page of a face is the width of its image.
    """

    surface: Surface
    normals: np.ndarray
    matrix: np.ndarray
    images: tuple
    values: dict


class Trip(NamedTuple):
    """A mesh when it was saved, and when it was loaded again."""

    before: Held
    after: Held


def round_trip(meshes, file, images, **options):
    """Saves a mesh with these images as a file in an empty folder, and loads it."""
    for name in images:
        (file.parent / name).parent.mkdir(exist_ok=True)  # the host makes no folder
    meshes.save_current_mesh(str(file), **options)
    if not options.get("save_textures", True):
        draw_images(file.parent, images)
    return Trip(held(meshes), held(load(file), widths_in(file)))


def load(file):
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(str(file), **({"usecolors": True} if file.suffix == ".3mf" else {}))
    return meshes


def widths_in(file):
    """The widths of the images of an X3D file, whose names the host writes but does not read."""
    if file.suffix != ".x3d":
        return None
    names = re.findall(r"<ImageTexture url=.&quot;(.*?)&quot;", file.read_text())
    return [WIDTHS[IMAGES.index(name)] for name in names]


def held(meshes, widths=None):
    """What the current mesh holds. Its images have these widths where the host knows none.

    Changes the quality of the faces.
    """
    mesh = meshes.current_mesh()
    faces = mesh.face_matrix()
    values = {}
    if mesh.has_vertex_color():
        values[VERTEX_COLOURS] = mesh.vertex_color_matrix()[faces]
    if mesh.has_face_color():
        values[FACE_COLOURS] = on_corners(mesh.face_color_matrix())
    if mesh.has_vertex_tex_coord():
        values[VERTEX_COORDINATES] = mesh.vertex_tex_coord_matrix()[faces]
    if mesh.has_wedge_tex_coord():
        values[WEDGES] = mesh.wedge_tex_coord_matrix().reshape(-1, 3, 2)
        values[PAGES] = on_corners(pages(meshes, widths)[:, None])
    images = tuple(sorted(mesh.textures()))
    normals = mesh.vertex_normal_matrix()[faces]
    return Held(surface(meshes), normals, mesh.transform_matrix(), images, values)


def on_corners(values):
    """Values of faces at each of their corners."""
    return np.repeat(values[:, None], 3, axis=1)


def pages(meshes, widths):
    """The page of each face. The host's number of a page is no name: saving changes it."""
    mesh = meshes.current_mesh()
    if widths is None:
        widths = [mesh.texture(i).width() for i in range(mesh.texture_number())]
    meshes.compute_scalar_by_function_per_face(q="ti")  # the host offers no array of it
    numbers = mesh.face_scalar_array().astype(int)
    return np.where(numbers < 0, NO_PAGE, np.array(widths)[numbers]) if widths else numbers


def misplaced(result, original, seams=(), near_seam=0.0):
    """For each kind, the share of points where the result has another value than the original.

    Points near a seam do not count. Seams are lines of one x.
    """
    points = at_inner_points(corners(result))
    faces, weights = nearest_places(points, original.surface)
    x = at_places(faces, weights, corners(original))[:, 0]
    counts = (np.abs(x[:, None] - seams) > near_seam).all(axis=1)
    assert counts.mean() > 0.3, "too few points count"
    shares = {}
    for kind in result.values.keys() & original.values.keys():
        there = at_places(faces, weights, original.values[kind])
        differs = np.abs(at_inner_points(result.values[kind]) - there) > ALLOWED
        shares[kind] = np.mean(differs.any(axis=1)[counts])
    return shares


def corners(one):
    """(m, 3, 3): the points at the corners of the faces."""
    return one.surface.vertices[one.surface.faces]


def at_inner_points(values):
    """Values at the inner points of the faces, from those at their corners."""
    return np.einsum("pi,fij->fpj", INNER_POINTS, values).reshape(-1, values.shape[2])


def nearest_places(points, shape):
    """Where a surface is nearest to the points: the faces, and the weights of their corners."""
    _, faces, feet = igl.point_mesh_squared_distance(points, *shape)
    a, b, c = (np.ascontiguousarray(shape.vertices[shape.faces[faces, k]]) for k in range(3))
    return faces, igl.barycentric_coordinates(feet, a, b, c)


def at_places(faces, weights, values):
    """Values at places on faces, from those at their corners."""
    return np.einsum("pi,pij->pj", weights, values[faces])


def normals_fit(one):
    """For each corner, the cosine of the angle between the normals of its vertex and its face."""
    across = double_area_normals(one.surface)[:, None]
    lengths = np.linalg.norm(one.normals, axis=2) * np.linalg.norm(across, axis=2)
    return (one.normals * across).sum(axis=2) / lengths
