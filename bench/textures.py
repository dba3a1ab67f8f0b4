# SPDX-License-Identifier: GPL-3.0-or-later
"""Textured meshes by our filters and by MeshLab's: where the texture goes, and what it costs.

python bench/textures.py MESH... [--plugin FILE] [--fraction 0.2] [--only 'Curv*']
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fnmatch import fnmatch
from pathlib import Path

import pymeshlab
from decimators import DEFAULT_PLUGIN, Decimator, curvdecim, meshlab_textured, save_once
from judge import Judge
from tables import console, table
from texture import TextureFigures, TextureJudge, read_textured

FRACTIONS = (0.2, 0.05)
_HEADINGS = (
    "mesh",
    "to",
    "decimator",
    "faces",
    "RMS",
    "drift",
    "worst",
    "far",
    "bleed",
    "turned",
    "cracks",
    "ms",
)


def decimators(plugin: Path) -> list[Decimator]:
    """Ours, also without the weight of the texture, the removal that moves nothing, MeshLab's."""
    removal = Decimator("Vertex removal", "meshing_decimation_vertex_removal", plugin)
    presets = ("Fast", "Balanced", "Best")
    return [
        *(curvdecim(plugin, f"CurvDecim {preset}", preset=preset) for preset in presets),
        curvdecim(plugin, "CurvDecim, AttributeWeight 0", attributeweight=0.0),
        removal,
        meshlab_textured(),
    ]


@dataclass(frozen=True)
class Row:
    """One decimator on one mesh."""

    mesh: str
    fraction: float
    decimator: str
    faces: int
    rms: float  # % of the diagonal
    texture: TextureFigures
    seconds: float

    def cells(self) -> list[str]:
        """As _HEADINGS has them."""
        figures = self.texture
        distances = (self.rms, figures.drift_rms, figures.drift_max, figures.far, figures.bleed)
        counts = (figures.turned, figures.cracks)
        return [
            *(self.mesh, f"{self.fraction:.0%}", self.decimator, str(self.faces)),
            *(f"{each:.4f}" for each in distances),
            *map(str, counts),
            f"{1000 * self.seconds:.1f}",
        ]


def compare(mesh: Path, fractions: Sequence[float], chosen: Sequence[Decimator]) -> Iterator[Row]:
    """Each of the decimators on the mesh, to each of the fractions of its faces."""
    with tempfile.TemporaryDirectory() as folder:
        original, result = Path(folder) / "original.ply", Path(folder) / "simplified.ply"
        save_with_wedges(mesh, original)
        surface = read_textured(original).surface
        texture = TextureJudge(read_textured(original))
        shape = Judge(surface.vertices, surface.faces)
        for fraction in fractions:
            for each in chosen:
                target = round(fraction * len(surface.faces))
                seconds = save_once(original, target, each, result)
                now = read_textured(result)
                rms = shape(now.surface.vertices, now.surface.faces).rms
                faces = len(now.surface.faces)
                yield Row(mesh.name, fraction, each.name, faces, rms, texture(now), seconds)


def main() -> None:
    options = _options()
    chosen = [each for each in decimators(options.plugin) if fnmatch(each.name, options.only)]
    shown = table("Textures: distances in % of the diagonal, shares in %", _HEADINGS)
    for mesh in options.mesh:
        for row in compare(mesh, options.fraction or FRACTIONS, chosen):
            shown.add_row(*row.cells())
    console().print(shown)


def save_with_wedges(mesh: Path, copy: Path) -> None:
    """Copies the mesh with texture coordinates by wedge: what MeshLab's filter asks for."""
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(str(mesh))
    if not meshes.current_mesh().has_wedge_tex_coord():
        meshes.compute_texcoord_transfer_vertex_to_wedge()
    meshes.save_current_mesh(str(copy), save_textures=False, save_wedge_texcoord=True)


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mesh", type=Path, nargs="+")
    parser.add_argument("--plugin", type=Path, default=DEFAULT_PLUGIN)
    parser.add_argument("--fraction", type=float, action="append", help="0.2 and 0.05")
    parser.add_argument("--only", default="*", help="decimators whose names match")
    return parser.parse_args()


if __name__ == "__main__":
    main()
