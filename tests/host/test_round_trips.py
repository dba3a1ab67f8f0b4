# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes with textures and colours, loaded, decimated and saved in the formats of the host.

A decimated mesh has to keep what the host keeps of a file that it only loads and saves.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import pymeshlab
import pytest
import samples
from held_values import (
    FACE_COLOURS,
    NO_PAGE,
    PAGES,
    VERTEX_COLOURS,
    VERTEX_COORDINATES,
    WEDGES,
    corners,
    load,
    misplaced,
    normals_fit,
    round_trip,
)
from PIL import Image
from textured_sheet import BANDS, IMAGES, LEFT, MATRIX, MIDDLE, RIGHT, SEAMS
from written_files import (
    write_3mf,
    write_coloured_ply,
    write_glb,
    write_gltf,
    write_obj,
    write_ply,
    write_vertex_ply,
    write_x3d,
)

FILTERS = (*samples.STEPWISE, samples.CLUSTER)
FRACTION = 0.3  # of the faces
NEAR_SEAM = 0.005  # of the sheet
NEAR_SEAM_OF_CELLS = 0.15  # of clustering: on a seam one colour, which neighbours' faces share


class Case(NamedTuple):
    """What the host keeps of a file that it loads and saves. pages: the page of each band."""

    write: Callable
    extension: str
    images: tuple
    kinds: set
    pages: tuple = ()
    options: dict | None = None

    def trip(self, meshes, folder):
        file = folder / f"sheet.{self.extension}"
        return round_trip(meshes, file, self.images, **(self.options or {}))


WITH_PAGES = {WEDGES, PAGES}
ALL_PAGES, LAST_BARE = (LEFT, MIDDLE, RIGHT), (LEFT, MIDDLE, NO_PAGE)
TWO, THREE = tuple(sorted(IMAGES[:2])), tuple(sorted(IMAGES))
NO_IMAGES = {"save_textures": False}  # the host cannot save images without an extension
NO_NORMALS = {"save_vertex_normal": False}  # OFF: the host reads them as colours
BY_WEDGE = {"save_wedge_texcoord": True, "save_vertex_coord": False}  # X3D: not by default

BY_FACE, BY_VERTEX = {*WITH_PAGES, FACE_COLOURS}, {VERTEX_COORDINATES, VERTEX_COLOURS}
MIXED = {*WITH_PAGES, VERTEX_COLOURS}

# What the host itself loses. OBJ: a material without image gets the first one. OFF: coordinates by
# wedge. WRL: all pages but one. X3D: images are named but not read. 3MF: all but the shape.
CASES = {
    "obj": Case(write_obj, "obj", TWO, BY_FACE, (LEFT, MIDDLE, LEFT)),
    "ply": Case(write_ply, "ply", THREE, BY_FACE, ALL_PAGES),
    "ply to dae": Case(write_ply, "dae", THREE, WITH_PAGES, ALL_PAGES),
    "ply to x3d": Case(write_ply, "x3d", (), WITH_PAGES, ALL_PAGES, BY_WEDGE),
    "ply to off": Case(write_ply, "off", (), {FACE_COLOURS}),
    "ply to wrl": Case(write_ply, "wrl", (), {WEDGES}),
    "vertex ply": Case(write_vertex_ply, "ply", IMAGES[:1], BY_VERTEX),
    "vertex ply to obj": Case(write_vertex_ply, "obj", (), BY_VERTEX),
    "coloured ply to off": Case(write_coloured_ply, "off", (), {VERTEX_COLOURS}, (), NO_NORMALS),
    "gltf to ply": Case(write_gltf, "ply", TWO, MIXED, LAST_BARE),
    "glb to ply": Case(write_glb, "ply", ("texture_0", "texture_1"), MIXED, LAST_BARE, NO_IMAGES),
    "x3d to ply": Case(write_x3d, "ply", (), {WEDGES}),
    "3mf": Case(write_3mf, "3mf", (), set(), (), NO_IMAGES),
    "3mf to ply": Case(write_3mf, "ply", ("1", "2"), BY_FACE, LAST_BARE, NO_IMAGES),
}


@pytest.fixture(scope="module", params=CASES)
def trip(request, tmp_path_factory):
    """A case, its file, and the file's round trip. The folder has a blank in its name."""
    case = CASES[request.param]
    folder = tmp_path_factory.mktemp("a folder")
    (folder / "saved").mkdir()
    file = case.write(folder)
    return case, file, case.trip(load(file), folder / "saved")


def reduced(name, meshes):
    """The meshes, the current one with fewer faces by this filter."""
    faces = meshes.current_mesh().face_number()
    meshes.apply_filter(name, targetfacenum=round(FRACTION * faces))
    return meshes


def assert_in_place(kinds, result, original, near_seam=NEAR_SEAM):
    """The result has values of these kinds, all where the original has them."""
    shares = misplaced(result, original, SEAMS, near_seam)
    assert {kind: shares[kind] for kind in kinds} == dict.fromkeys(kinds, 0)


def assert_same(kinds, result, original, near_seam):
    """All that a decimated mesh has in common with the one that it was made of."""
    assert result.images == original.images
    assert set(result.values) == set(original.values)
    assert np.array_equal(result.matrix, original.matrix)
    assert (normals_fit(result) > 0.5).all()
    assert_in_place(kinds, result, original, near_seam)


def pages_of_bands(one):
    bands = np.floor(BANDS * corners(one).mean(axis=1)[:, 0])
    of_faces = one.values[PAGES][:, 0, 0]
    return tuple(tuple(np.unique(of_faces[bands == each])) for each in range(BANDS))


def test_the_host_keeps(trip):
    case, _, kept = trip
    assert kept.after.images == case.images
    assert_in_place(case.kinds - {PAGES}, kept.after, kept.before)
    if case.pages:
        assert pages_of_bands(kept.after) == tuple((page,) for page in case.pages)


@pytest.mark.parametrize("name", FILTERS)
def test_decimated_keeps_what_the_host_keeps(trip, name, tmp_path):
    case, file, kept = trip
    made = case.trip(reduced(name, load(file)), tmp_path)
    fraction = len(made.before.surface.faces) / len(kept.before.surface.faces)
    assert 0.2 < fraction < 0.4
    assert len(made.after.surface.faces) == len(made.before.surface.faces)
    near_seam = NEAR_SEAM_OF_CELLS if name == samples.CLUSTER else NEAR_SEAM
    assert_same(kept.before.values, made.before, kept.before, near_seam)
    assert_same(case.kinds, made.after, kept.after, near_seam)


@pytest.mark.parametrize("name", FILTERS)
def test_images_keep_blanks_in_their_names(name, tmp_path):
    """The host reads such names from glTF only."""
    images = ("left page.png", "deep folder/middle page.png")
    meshes = reduced(name, load(write_gltf(tmp_path, images)))
    saved = tmp_path / "saved"
    (saved / images[1]).parent.mkdir(parents=True)
    meshes.save_current_mesh(str(saved / "sheet.ply"))
    header = (saved / "sheet.ply").read_bytes().partition(b"end_header")[0].decode()
    listed = [line for line in header.splitlines() if "TextureFile" in line]
    assert listed == [f"comment TextureFile {image}" for image in images]
    for image in images:
        assert Image.open(saved / image).size == Image.open(tmp_path / image).size


@pytest.mark.parametrize("name", FILTERS)
@pytest.mark.parametrize("write", [write_gltf, write_3mf])
def test_layer_keeps_its_matrix(write, name, tmp_path):
    """Only a project holds the matrix: the host saves meshes without it."""
    meshes = load(write(tmp_path))
    assert np.array_equal(meshes.current_mesh().transform_matrix(), MATRIX)
    faces = reduced(name, meshes).current_mesh().face_number()
    meshes.save_current_mesh(str(tmp_path / "saved.ply"), save_textures=False)
    meshes.save_project(str(tmp_path / "saved.mlp"))
    again = pymeshlab.MeshSet(verbose=False)
    again.load_project(str(tmp_path / "saved.mlp"))
    assert np.array_equal(again.current_mesh().transform_matrix(), MATRIX)
    assert again.current_mesh().face_number() == faces


IMAGES_INSIDE = {"duck.glb": ("texture_0",)}
# Of the points: near seams the nearest point of the original may be of another chart.
MISPLACED = {name: 0.15 if name == samples.CLUSTER else 0.05 for name in FILTERS}
MISPLACED_PAGES = 0.01


@pytest.mark.parametrize("name", FILTERS)
@pytest.mark.parametrize("file", ["duck.glb", "doorman.obj", "fuze.obj", "animal_checker.obj"])
def test_real_mesh(file, name, tmp_path):
    for original, result in zip(*trips_of_real_mesh(file, name, tmp_path), strict=True):
        assert result.images == original.images
        assert set(result.values) == set(original.values) >= WITH_PAGES
        assert np.array_equal(result.matrix, original.matrix)
        shares = misplaced(result, original)
        assert shares.pop(PAGES) < MISPLACED_PAGES
        assert max(shares.values()) < MISPLACED[name]


def trips_of_real_mesh(file, name, folder):
    """Two round trips: of the mesh as it is, and of the mesh reduced by this filter."""
    images = IMAGES_INSIDE.get(file, ())
    options = NO_IMAGES if images else {}
    meshes = samples.load(f"real/{file}"), reduced(name, samples.load(f"real/{file}"))
    for number, each in enumerate(meshes):
        (folder / str(number)).mkdir()
        yield round_trip(each, folder / str(number) / "mesh.ply", images, **options)
