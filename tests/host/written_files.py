# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of the textured sheet, written by hand in each format.

A writer puts its file, and the images that it names, in a folder and returns the file's path.
"""

import base64
import json
import zipfile

import numpy as np
from textured_sheet import (
    BANDS,
    COLOURS,
    IMAGES,
    MATRIX,
    draw_images,
    image_bytes,
    piece,
    textured_sheet,
)


def lines(values, start=""):
    """A line of text for each row of numbers."""
    return "".join(f"{start}{' '.join(f'{each:.9g}' for each in row)}\n" for row in values)


def written(file, text):
    file.write_text(text)
    return file


# --- OBJ ------------------------------------------------------------------------------------------


def write_obj(folder):
    """OBJ and MTL. The material of the last band has no image."""
    draw_images(folder, IMAGES[:2])
    images = (*(f"map_Kd {name}\n" for name in IMAGES[:2]), "")
    materials = (
        f"newmtl band{band}\n{lines([COLOURS[band, :3]], 'Kd ')}{images[band]}"
        for band in range(BANDS)
    )
    written(folder / "sheet.mtl", "".join(materials))
    sheet = textured_sheet()
    text = lines(sheet.vertices, "v ") + lines(sheet.coordinates.reshape(-1, 2), "vt ")
    faces = "".join(map(obj_faces, range(BANDS)))
    return written(folder / "sheet.obj", f"mtllib sheet.mtl\n{text}{faces}")


def obj_faces(band):
    """The faces of a band with its material. Each corner has coordinates of its own."""
    sheet = textured_sheet()
    text = f"usemtl band{band}\n"
    for face in np.flatnonzero(sheet.bands == band):
        corners = (f"{v + 1}/{3 * face + k + 1}" for k, v in enumerate(sheet.faces[face]))
        text += f"f {' '.join(corners)}\n"
    return text


# --- PLY ------------------------------------------------------------------------------------------

XYZ = ("float x", "float y", "float z")
UV = ("float texture_u", "float texture_v")
RGBA = ("uchar red", "uchar green", "uchar blue", "uchar alpha")
CORNERS = "list uchar int vertex_indices"
WEDGE = ("list uchar float texcoord", "int texnumber")


def write_ply(folder):
    """PLY with coordinates and images by wedge, and colours by face."""
    sheet = textured_sheet()
    wedges = counted(sheet.coordinates.reshape(-1, 6))
    colours = np.round(255 * COLOURS)[sheet.bands]
    faces = np.hstack([counted(sheet.faces), wedges, sheet.bands[:, None], colours])
    text = ply_element("vertex", XYZ, sheet.vertices)
    return write_ply_of(folder, IMAGES, text, ply_element("face", (CORNERS, *WEDGE, *RGBA), faces))


def write_vertex_ply(folder):
    """PLY with one image, and coordinates and colours by vertex."""
    x, y, _ = textured_sheet().vertices.T
    return write_ply_of_vertices(folder, IMAGES[:1], UV, np.column_stack([x, y]))


def write_coloured_ply(folder):
    """PLY with colours by vertex, and no image."""
    return write_ply_of_vertices(folder, (), (), np.empty((len(textured_sheet().vertices), 0)))


def write_ply_of_vertices(folder, images, properties, values):
    """PLY with these values and colours by vertex."""
    sheet = textured_sheet()
    vertices = np.hstack([sheet.vertices, values, np.round(255 * sheet.colours)])
    text = ply_element("vertex", (*XYZ, *properties, *RGBA), vertices)
    return write_ply_of(folder, images, text, ply_element("face", [CORNERS], counted(sheet.faces)))


def counted(values):
    """Rows of a PLY list, which begin with their length."""
    return np.insert(values, 0, values.shape[1], axis=1)


def ply_element(name, properties, values):
    """What the header says of an element, and its values."""
    header = f"element {name} {len(values)}\n"
    return header + "".join(f"property {each}\n" for each in properties), lines(values)


def write_ply_of(folder, images, *elements):
    draw_images(folder, images)
    comments = "".join(f"comment TextureFile {name}\n" for name in images)
    headers, values = map("".join, zip(*elements, strict=True))
    text = f"ply\nformat ascii 1.0\n{comments}{headers}end_header\n{values}"
    return written(folder / "sheet.ply", text)


# --- glTF -----------------------------------------------------------------------------------------


class Scene:
    """The sheet in glTF: each band is a primitive; the last has only a colour.

    content: the JSON part without images and buffer. data: the bytes of the buffer.
    """

    def __init__(self):
        self.data = b""
        self.content = {
            "asset": {"version": "2.0"},
            "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0, "matrix": MATRIX.T.ravel().tolist()}],
            "materials": [
                {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}},
                {"pbrMetallicRoughness": {"baseColorTexture": {"index": 1}}},
                {"pbrMetallicRoughness": {"baseColorFactor": COLOURS[2].tolist()}},
            ],
            "textures": [{"source": 0}, {"source": 1}],
            "accessors": [],
            "bufferViews": [],
        }
        primitives = [self.primitive(band) for band in range(BANDS)]
        self.content["meshes"] = [{"primitives": primitives}]

    def primitive(self, band):
        vertices, coordinates, faces = piece(band)
        attributes = {"POSITION": self.accessor(vertices.astype("<f4"), "VEC3")}
        if band < 2:
            attributes["TEXCOORD_0"] = self.accessor(coordinates.astype("<f4"), "VEC2")
        indices = self.accessor(faces.reshape(-1, 1).astype("<u4"), "SCALAR")
        return {"attributes": attributes, "indices": indices, "material": band}

    def accessor(self, values, kind):
        """The number of a new accessor of these values."""
        accessor = {
            "bufferView": self.view(values.tobytes()),
            "componentType": 5125 if kind == "SCALAR" else 5126,  # unsigned int, float
            "count": len(values),
            "type": kind,
            "min": values.min(axis=0).tolist(),
            "max": values.max(axis=0).tolist(),
        }
        self.content["accessors"].append(accessor)
        return len(self.content["accessors"]) - 1

    def view(self, data):
        """The number of a new view of these bytes."""
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data)}
        self.content["bufferViews"].append(view)
        self.data += padded(data, b"\0")
        return len(self.content["bufferViews"]) - 1


def padded(data, filler):
    """A multiple of four bytes."""
    return data + filler * (-len(data) % 4)


def write_gltf(folder, images=IMAGES[:2]):
    """glTF with the images in files and the buffer in the text."""
    draw_images(folder, images)
    scene = Scene()
    address = "data:application/octet-stream;base64," + base64.b64encode(scene.data).decode()
    scene.content["buffers"] = [{"byteLength": len(scene.data), "uri": address}]
    scene.content["images"] = [{"uri": name.replace(" ", "%20")} for name in images]
    return written(folder / "sheet.gltf", json.dumps(scene.content))


def write_glb(folder):
    """GLB: glTF as one binary file, with the images inside."""
    scene = Scene()
    views = [scene.view(image_bytes(band)) for band in (0, 1)]
    scene.content["images"] = [{"bufferView": each, "mimeType": "image/png"} for each in views]
    scene.content["buffers"] = [{"byteLength": len(scene.data)}]
    text = padded(json.dumps(scene.content).encode(), b" ")
    chunks = b"".join(
        np.uint32(len(chunk)).tobytes() + kind + chunk
        for kind, chunk in ((b"JSON", text), (b"BIN\0", scene.data))
    )
    file = folder / "sheet.glb"
    file.write_bytes(b"glTF" + np.array([2, 12 + len(chunks)], "<u4").tobytes() + chunks)
    return file


# --- X3D ------------------------------------------------------------------------------------------


def write_x3d(folder):
    """X3D. Each band is a shape."""
    draw_images(folder, IMAGES)
    shapes = "".join(map(x3d_shape, range(BANDS)))
    header = '<?xml version="1.0" encoding="UTF-8"?>'
    return written(
        folder / "sheet.x3d", f'{header}<X3D version="3.1"><Scene>{shapes}</Scene></X3D>'
    )


def x3d_shape(band):
    vertices, coordinates, faces = piece(band)
    index = lines(np.insert(faces, 3, -1, axis=1))
    return (
        f"<Shape><Appearance><ImageTexture url='\"{IMAGES[band]}\"'/></Appearance>"
        f'<IndexedFaceSet coordIndex="{index}" texCoordIndex="{index}">'
        f'<Coordinate point="{lines(vertices)}"/>'
        f'<TextureCoordinate point="{lines(coordinates)}"/></IndexedFaceSet></Shape>'
    )


# --- 3MF ------------------------------------------------------------------------------------------

SCHEMAS = "http://schemas.microsoft.com/3dmanufacturing"
PACKAGE = "http://schemas.openxmlformats.org/package/2006"
TYPES = {
    "rels": "application/vnd.openxmlformats-package.relationships+xml",
    "model": "application/vnd.ms-package.3dmanufacturing-3dmodel+xml",
    "png": "image/png",
}
CONTENT_TYPES = "".join(
    f'<Default Extension="{each}" ContentType="{kind}"/>' for each, kind in TYPES.items()
)


def write_3mf(folder):
    """3MF, a zip archive of the model and the images. The last band has only a colour."""
    parts = {
        "[Content_Types].xml": f'<Types xmlns="{PACKAGE}/content-types">{CONTENT_TYPES}</Types>',
        "_rels/.rels": relations("3dmodel", "/3D/3dmodel.model"),
        "3D/3dmodel.model": model_3mf(),
        "3D/_rels/3dmodel.model.rels": relations("3dtexture", "/3D/0.png", "/3D/1.png"),
        "3D/0.png": image_bytes(0),
        "3D/1.png": image_bytes(1),
    }
    with zipfile.ZipFile(folder / "sheet.3mf", "w") as archive:
        for name, content in parts.items():
            archive.writestr(name, content)
    return folder / "sheet.3mf"


def relations(kind, *targets):
    """Says of which kind these parts of the archive are."""
    text = "".join(
        f'<Relationship Id="r{i}" Target="{target}" Type="{SCHEMAS}/2013/01/{kind}"/>'
        for i, target in enumerate(targets)
    )
    return f'<Relationships xmlns="{PACKAGE}/relationships">{text}</Relationships>'


def model_3mf():
    """The model. Images are resources 1 and 2, what corners of each band refer to 3 to 5."""
    matrix = lines([MATRIX[:3].T.ravel()]).strip()
    return (
        f'<model unit="millimeter" xmlns="{SCHEMAS}/core/2015/02"'
        f' xmlns:m="{SCHEMAS}/material/2015/02"><resources>'
        '<m:texture2d id="1" path="/3D/0.png" contenttype="image/png"/>'
        '<m:texture2d id="2" path="/3D/1.png" contenttype="image/png"/>'
        f'<m:texture2dgroup id="3" texid="1">{coordinates_3mf()}</m:texture2dgroup>'
        f'<m:texture2dgroup id="4" texid="2">{coordinates_3mf()}</m:texture2dgroup>'
        f'<m:colorgroup id="5"><m:color color="{hexadecimal(COLOURS[2])}"/></m:colorgroup>'
        f'<object id="6" type="model"><mesh>{vertices_3mf()}{triangles_3mf()}</mesh></object>'
        f'</resources><build><item objectid="6" transform="{matrix}"/></build>'
        "</model>"
    )


def coordinates_3mf():
    coordinates = textured_sheet().coordinates.reshape(-1, 2)
    return "".join(f'<m:tex2coord u="{u:.9g}" v="{v:.9g}"/>' for u, v in coordinates)


def vertices_3mf():
    vertices = textured_sheet().vertices
    text = "".join(f'<vertex x="{x:.9g}" y="{y:.9g}" z="{z:.9g}"/>' for x, y, z in vertices)
    return f"<vertices>{text}</vertices>"


def triangles_3mf():
    sheet = textured_sheet()
    text = ""
    for face, (band, (a, b, c)) in enumerate(zip(sheet.bands, sheet.faces, strict=True)):
        p, q, r = 3 * face + np.arange(3) if band < 2 else (0, 0, 0)
        text += f'<triangle v1="{a}" v2="{b}" v3="{c}"'
        text += f' pid="{band + 3}" p1="{p}" p2="{q}" p3="{r}"/>'
    return f"<triangles>{text}</triangles>"


def hexadecimal(colour):
    return "#" + "".join(f"{round(255 * each):02X}" for each in colour)
