# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad parameters and bad meshes: a clear exception and an untouched mesh, or a valid result."""

import gc

import numpy as np
import pymeshlab
import pytest
from drawn_meshes import TETRAHEDRON, bumpy_sheet, mesh_set
from measures import non_manifold_edges, surface
from samples import DECIMATE, REMOVE, SPHERES, STEPWISE

NAN, INFINITY = float("nan"), float("inf")
BAD_PARAMETERS = [
    ("targetfacenum", -1),
    ("targetfacenum", -(2**31)),
    ("targetvertnum", -5),
    ("targetperc", -0.1),
    ("targetperc", 1.5),
    ("targetperc", NAN),
    ("targetperc", INFINITY),
    ("maxerror", pymeshlab.PureValue(-1.0)),
    ("maxerror", pymeshlab.PureValue(NAN)),
    ("pairdistance", pymeshlab.PureValue(-1.0)),
    ("pairdistance", pymeshlab.PureValue(NAN)),
    ("boundaryweight", -1.0),
    ("normalangle", -1.0),
    ("normalangle", 181.0),
    ("normalangle", NAN),
    ("featureangle", -1.0),
    ("featureangle", 200.0),
    ("threads", -1),
    ("alpha", NAN),
    ("curvaturefloor", 1.5),
    ("curvaturefloor", -0.5),
    ("lambda_", -1e-3),
    ("lambda_", NAN),
]


def state(mesh):
    return mesh.vertex_matrix().tobytes(), mesh.face_matrix().tobytes()


REMOVAL_PARAMETERS = [
    ("aspectratiomin", 0.6),
    ("aspectratiomin", -0.1),
    ("distancebound", pymeshlab.PureValue(-1.0)),
    ("targetvertnum", -1),
]
SPHERE_PARAMETERS = [
    ("targetfacenum", -1),
    ("targetperc", NAN),
    ("kernelscale", 0.9),
    ("kernelscale", 10.1),
]


def assert_refused(meshes, words, filter_name=DECIMATE, **options):
    """The filter says what is wrong, in these words, and leaves the mesh as it was."""
    before = state(meshes.current_mesh())
    with pytest.raises(pymeshlab.PyMeshLabException, match=f"(?is){words}"):
        meshes.apply_filter(filter_name, **options)
    assert state(meshes.current_mesh()) == before


@pytest.mark.parametrize(("name", "value"), BAD_PARAMETERS)
def test_bad_parameter_is_named(name, value):
    assert_refused(mesh_set(*bumpy_sheet()), name.rstrip("_"), **{name: value})


@pytest.mark.parametrize(("name", "value"), REMOVAL_PARAMETERS)
def test_bad_parameter_of_vertex_removal_is_named(name, value):
    assert_refused(mesh_set(*bumpy_sheet()), name, REMOVE, **{name: value})


@pytest.mark.parametrize(("name", "value"), SPHERE_PARAMETERS)
def test_bad_parameter_of_spheres_is_named(name, value):
    assert_refused(mesh_set(*bumpy_sheet()), name, SPHERES, **{name: value})


def test_bound_and_pairs_are_refused_together():
    length = pymeshlab.PureValue(0.1)
    options = {"targetfacenum": 60, "pairdistance": length, "maxerror": length}
    assert_refused(mesh_set(*bumpy_sheet()), "pairdistance and maxerror", **options)


def test_selected_without_a_selection_is_refused():
    assert_refused(mesh_set(*bumpy_sheet()), "select", selected=True, targetperc=0.5)


def test_quality_weight_needs_usable_quality():
    vertices, faces = bumpy_sheet()
    quality = np.full(len(vertices), NAN)
    meshes = mesh_set(vertices, faces, v_scalar_array=quality)
    assert_refused(meshes, "quality", qualityweight=True, targetperc=0.5)


def test_empty_mesh_is_refused():
    meshes = mesh_set(*bumpy_sheet())
    meshes.set_selection_all()
    meshes.meshing_remove_selected_vertices_and_faces()
    assert_refused(meshes, "not have any faces", targetperc=0.5)


def test_no_mesh_is_refused():
    with pytest.raises(pymeshlab.PyMeshLabException, match="mesh"):
        pymeshlab.MeshSet(verbose=False).apply_filter(DECIMATE)


def test_point_cloud_is_refused():
    assert_refused(mesh_set(bumpy_sheet()[0]), "no faces|face", targetperc=0.5)


def test_all_faces_deleted_is_refused():
    meshes = mesh_set(*bumpy_sheet())
    meshes.set_selection_all(allfaces=True, allverts=False)
    meshes.meshing_remove_selected_faces()
    assert_refused(meshes, "no faces|face", targetperc=0.5)


def test_error_does_not_harm_later_calls():
    """PyMeshLab leaves a filter that throws with the log of that MeshSet."""
    talking = mesh_set(*bumpy_sheet())
    talking.set_verbosity(True)
    assert_refused(talking, "targetperc", targetperc=-1.0)
    del talking
    gc.collect()
    for _ in range(20):
        silent = mesh_set(*bumpy_sheet())
        silent.apply_filter(DECIMATE, targetperc=0.5)
        assert silent.current_mesh().face_number() in (143, 144)  # on a border one may go alone


@pytest.mark.parametrize("value", [NAN, INFINITY, -INFINITY])
def test_coordinate_that_is_no_number(value):
    """Refused by name, or only its own faces stay as they are."""
    vertices, faces = bumpy_sheet()
    vertices[40, 1] = value
    meshes = mesh_set(vertices, faces)
    before = state(meshes.current_mesh())
    try:
        report = meshes.apply_filter(DECIMATE, targetperc=0.5)
    except pymeshlab.PyMeshLabException as error:
        assert "40" in str(error)
        assert state(meshes.current_mesh()) == before
    else:
        result = meshes.current_mesh().vertex_matrix()
        assert report["faces"] == meshes.current_mesh().face_number() < len(faces)
        assert (~np.isfinite(result).all(axis=1)).sum() == 1


def with_zero_area_faces():
    vertices, faces = bumpy_sheet()
    middle = vertices[faces[0, [0, 1]]].mean(axis=0)
    doubled = np.vstack([vertices, middle, vertices[5]])
    last = len(vertices)
    return doubled, np.vstack([faces, [faces[0, 0], last, faces[0, 1]], [5, 6, last + 1]])


def with_repeated_index():
    vertices, faces = bumpy_sheet()
    return vertices, np.vstack([faces, [7, 7, 8]])


def with_duplicate_faces():
    vertices, faces = bumpy_sheet()
    return vertices, np.vstack([faces, faces[:9], faces[9:12, [1, 2, 0]]])


def with_a_fin():
    """A third face on an inner edge."""
    vertices, faces = bumpy_sheet()
    fin = np.vstack([vertices, vertices[84] + (0, 0, 1)])
    return fin, np.vstack([faces, [84, 85, len(vertices)]])


def two_cones_at_one_vertex():
    """Two tetrahedra that share a vertex."""
    vertices, faces = (np.array(part, dtype=float) for part in TETRAHEDRON)
    other = np.where(faces == 0, 0, faces + 3).astype(int)
    return np.vstack([vertices, -vertices[1:]]), np.vstack([faces.astype(int), other])


def moebius_strip(cells=40):
    """A closed strip of quads with half a turn: no consistent orientation exists."""
    turn = np.linspace(0, 2 * np.pi, cells, endpoint=False)
    rim = [
        np.column_stack(
            [
                (1 + side * np.cos(turn / 2)) * np.cos(turn),
                (1 + side * np.cos(turn / 2)) * np.sin(turn),
                side * np.sin(turn / 2),
            ]
        )
        for side in (-0.3, 0.0, 0.3)
    ]
    index = np.arange(3 * cells).reshape(3, cells)
    index = np.column_stack([index, index[::-1, 0]])
    a, b, c, d = index[:-1, :-1], index[:-1, 1:], index[1:, :-1], index[1:, 1:]
    corners = [np.stack(triangle, axis=-1).reshape(-1, 3) for triangle in ((a, b, d), (a, d, c))]
    return np.vstack(rim), np.vstack(corners)


@pytest.mark.parametrize(
    "draw",
    [
        with_zero_area_faces,
        with_repeated_index,
        with_duplicate_faces,
        with_a_fin,
        two_cones_at_one_vertex,
        moebius_strip,
    ],
)
@pytest.mark.parametrize("fraction", [0.5, 0.05])
@pytest.mark.parametrize("name", STEPWISE)
def test_flawed_mesh_gives_a_valid_result_or_a_reason(draw, fraction, name):
    meshes = mesh_set(*draw())
    mesh = meshes.current_mesh()
    flaws, before = non_manifold_edges(surface(meshes)), state(mesh)
    try:
        report = meshes.apply_filter(name, targetperc=fraction)
    except pymeshlab.PyMeshLabException as error:
        assert len(str(error)) > 20
        assert state(mesh) == before
        return
    faces = mesh.face_matrix()
    assert report["faces"] == len(faces)
    assert np.isfinite(mesh.vertex_matrix()).all()
    assert faces.min() >= 0
    assert faces.max() < mesh.vertex_number()
    assert (np.diff(np.sort(faces, axis=1)) > 0).all()
    assert non_manifold_edges(surface(meshes)) <= flaws


def test_smallest_closed_mesh_stays():
    meshes = mesh_set(*TETRAHEDRON)
    report = getattr(meshes, DECIMATE)(targetfacenum=1)
    assert (meshes.current_mesh().face_number(), report["faces"]) == (4, 4)
    assert report["stopped_by"] == "nothing left to collapse"


def test_unreferenced_vertices_do_not_matter():
    vertices, faces = bumpy_sheet()
    padded = mesh_set(np.vstack([vertices, [[5, 5, 5]]]), faces)
    padded.apply_filter(DECIMATE, targetperc=0.5)
    assert padded.current_mesh().face_number() in (len(faces) // 2 - 1, len(faces) // 2)
