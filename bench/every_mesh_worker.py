# SPDX-License-Identifier: GPL-3.0-or-later
"""Decimates one mesh to several levels by two filters and judges what comes out.

`every_mesh` starts it, so that a mesh that ends the judge ends no other. Reads a job as JSON from
standard input:

    {"mesh": path, "levels": [per cent of the faces], "plugin": path, "parameters": {...},
     "samples": a direction, "patience": seconds of a filter, "kept": folder of MeshLab's results}

and writes, as the last line of standard output, {"faces": ..., "before": {...}, "levels": [...]}:
the defects of the mesh, and a level's target with what the judge says of ours and of MeshLab's.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np
import pymeshlab
from decimators import Decimator, curvdecim, meshlab, run_once
from defects import defects
from judge import Judge
from kept import kept
from meshes import read_mesh
from surface import Surface
from workers import FilterError

LEAST_TARGET = 4  # faces: the least closed surface
_HERE = Path(__file__).parent
_JUDGES = [_HERE / name for name in ("judge.py", "surface.py", "shape.py", "defects.py")]
_FAILURES = (FilterError, ValueError, pymeshlab.PyMeshLabException)

Answer = dict[str, Any]


@dataclass(frozen=True, eq=False)
class Trial:
    """A mesh file, how it is judged, and where MeshLab's results on it are kept.

    samples: a direction. patience: seconds that a filter may take.
    """

    path: Path
    samples: int
    patience: float
    kept_in: Path

    @cached_property
    def surface(self) -> Surface:
        """The mesh as it is read."""
        return with_area(Surface(*read_mesh(self.path)))

    @cached_property
    def judge(self) -> Judge:
        """All levels share it."""
        return Judge(self.surface.vertices, self.surface.faces, samples=self.samples)

    def before(self) -> dict[str, int]:
        """The defects of the mesh itself."""
        flipped = self.judge.flipped(self.surface.vertices, self.surface.faces)
        return defects(self.surface) | {"flipped": flipped}

    def at(self, level: float, ours: Decimator) -> Answer:
        """Both filters at a level, in per cent of the faces."""
        target = self.target(level)
        return {
            "level": level,
            "target": target,
            "ours": or_failure(lambda: self.judged(target, ours)),
            "meshlab": or_failure(lambda: self._kept(target, meshlab())),
        }

    def target(self, level: float) -> int:
        """Faces at a level, in per cent."""
        return round(level / 100 * len(self.surface.faces))

    def judged(self, target: int, decimator: Decimator) -> Answer:
        """What the judge says of a filter's result."""
        outcome = run_once(self.path, target, decimator, self.patience)
        result = with_area(Surface(outcome.vertices, outcome.faces))
        figures = self.judge(result.vertices, result.faces)
        return {
            "faces": figures.faces,
            "seconds": outcome.seconds,
            "rms": figures.rms,
            "max": figures.max,
            "defects": defects(result) | {"flipped": figures.flipped},
        }

    def _kept(self, target: int, decimator: Decimator) -> Answer:
        """The same, from an earlier call if there was one."""
        question = self._question(target, decimator)
        return kept(self.kept_in, question, lambda: self.judged(target, decimator))

    def _question(self, target: int, decimator: Decimator) -> list[bytes]:
        """All that the filter's judged result depends on."""
        version = metadata.version("pymeshlab")
        asked = [version, decimator.filter, decimator.parameters, target, self.samples]
        files = [path.read_bytes() for path in (self.path, *_JUDGES)]
        return [*files, self.path.suffix.encode(), json.dumps(asked).encode()]


def with_area(surface: Surface) -> Surface:
    """The surface, if it can be judged."""
    if not np.isfinite(surface.corners).all():
        raise ValueError("a vertex is not finite")
    if not (surface.areas > 0).any():
        raise ValueError("no face has an area")
    return surface


def or_failure(answer: Callable[[], Answer]) -> Answer:
    """The answer, or why there is none."""
    try:
        return answer()
    except _FAILURES as failure:
        return {"failure": str(failure)}


def run(job: dict[str, Any]) -> Answer:
    """All levels that leave a surface."""
    trial = Trial(Path(job["mesh"]), job["samples"], job["patience"], Path(job["kept"]))
    ours = curvdecim(Path(job["plugin"]), **job["parameters"])
    levels = [level for level in job["levels"] if trial.target(level) >= LEAST_TARGET]
    return {
        "faces": len(trial.surface.faces),
        "before": trial.before(),
        "levels": [trial.at(level, ours) for level in levels],
    }


if __name__ == "__main__":
    print(json.dumps(run(json.load(sys.stdin))))
