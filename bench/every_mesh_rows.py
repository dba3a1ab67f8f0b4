# SPDX-License-Identifier: GPL-3.0-or-later
"""The rows of `every_mesh`: one mesh at one level, what ours falls short in, and the tables."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import tables
from compare import NO_DISTANCE
from defects import MERGED
from peers.summary import geometric_mean
from rich.markup import escape

ERRORS = ("rms", "max")
_CHANGE = 0.01  # of an error or of the faces; a smaller change is not listed

HEADINGS = (
    *("mesh", "faces", "to", "target", "ours", "MeshLab's", "ms", "time"),
    *("RMS %", "MeshLab's %", "RMS", "max", "new defects: before>ours/MeshLab's"),
)
WIDTHS = (26, 7, 4, 7, 7, 9, 6, 6, 9, 11, 7, 7, 0)
"""Of the cells, in characters, where rows are printed one by one."""


@dataclass(frozen=True)
class Judged:
    """What the judge says of one result. Distances in % of the input's diagonal, both directions.

    failure: why there is no result; everything else is then empty.
    """

    faces: int = 0
    seconds: float = 0.0  # of the filter alone
    rms: float = 0.0
    max: float = 0.0
    defects: dict[str, int] = field(default_factory=dict)
    failure: str = ""


@dataclass(frozen=True)
class Row:
    """One mesh at one level, in per cent of its faces, by our filter and by MeshLab's."""

    mesh: str
    faces: int  # of the mesh
    level: float
    target: int  # faces
    before: dict[str, int]  # the defects of the mesh
    ours: Judged
    meshlab: Judged

    @property
    def name(self) -> str:
        """Of the mesh and the level."""
        return f"{self.mesh} {self.level:g}%"

    def ratio(self, error: str) -> float | None:
        """Ours over MeshLab's; None without both."""
        if self.ours.failure or self.meshlab.failure:
            return None
        ours, other = getattr(self.ours, error), getattr(self.meshlab, error)
        return tables.ratio(ours, other, NO_DISTANCE)

    @property
    def on_unequal_terms(self) -> bool:
        """One of the two missed the target: more faces have a smaller error."""
        return is_missed(self, self.ours) or is_missed(self, self.meshlab)

    @property
    def new(self) -> list[str]:
        """Defects that ours has more of than the mesh, as 'name before>ours/MeshLab's'."""
        more = {name: count for name, count in self.ours.defects.items() if self._is_news(name)}
        return [
            f"{_label(name)} {self.before[name]}>{count}/{self.meshlab.defects.get(name, '-')}"
            for name, count in more.items()
        ]

    def _is_news(self, name: str) -> bool:
        """More than before, and not the same said again of the merged mesh."""
        plain = name.removeprefix(MERGED)
        counts, plain_counts = self._counts(name), self._counts(plain)
        return counts[1] > counts[0] and (name == plain or counts != plain_counts)

    def _counts(self, name: str) -> tuple[int, int]:
        return self.before[name], self.ours.defects[name]

    def cells(self) -> list[str]:
        """In the order of the headings."""
        ours, other = self.ours, self.meshlab
        time = ours.seconds / other.seconds if other.seconds else None
        return [
            *(self.mesh, str(self.faces), f"{self.level:g}%", str(self.target)),
            *("-" if each.failure else str(each.faces) for each in (ours, other)),
            *(f"{1000 * ours.seconds:.0f}", _number(time)),
            *("-" if each.failure else f"{each.rms:.4f}" for each in (ours, other)),
            *(_number(self.ratio(error)) for error in ERRORS),
            "; ".join([*self._failures(), *self.new]),
        ]

    def _failures(self) -> Iterable[str]:
        for name, judged in (("ours", self.ours), ("MeshLab", self.meshlab)):
            if judged.failure:
                yield f"{name} failed: {judged.failure.splitlines()[-1]}"


def of_answer(mesh: str, answer: Mapping[str, Any]) -> list[Row]:
    """The rows of what the worker says of a mesh."""
    return [
        Row(
            *(mesh, answer["faces"], level["level"], level["target"], answer["before"]),
            *(Judged(**level["ours"]), Judged(**level["meshlab"])),
        )
        for level in answer["levels"]
    ]


def to_json(rows: Sequence[Row]) -> list[dict[str, Any]]:
    """Rows as they are saved."""
    return [asdict(row) for row in rows]


def from_json(saved: Sequence[dict[str, Any]]) -> list[Row]:
    """Rows that were saved."""
    return [
        Row(**{**row, "ours": Judged(**row["ours"]), "meshlab": Judged(**row["meshlab"])})
        for row in saved
    ]


def _label(name: str) -> str:
    known = {"boundary": "border edges", "merged_boundary": "cracks"}
    return known.get(name, name.replace("_", " "))


def _number(value: float | None) -> str:
    return "-" if value is None else f"{value:.3f}"


Shown = Callable[[Row, Judged], str | None]
"""A figure of a result that falls short, or None where it does not."""


def is_missed(row: Row, judged: Judged) -> bool:
    """More than a face above the target."""
    return judged.faces > row.target + 1


def _missed(row: Row, judged: Judged) -> str | None:
    return f"{judged.faces} for {row.target}" if is_missed(row, judged) else None


def _appeared(*names: str) -> Shown:
    """None of these defects before, some now."""

    def shown(row: Row, judged: Judged) -> str | None:
        now = sum(judged.defects[name] for name in names)
        return str(now) if now and not any(row.before[name] for name in names) else None

    return shown


def _grew(name: str) -> Shown:
    """More of a defect than before."""

    def shown(row: Row, judged: Judged) -> str | None:
        before, now = row.before[name], judged.defects[name]
        return f"{before}>{now}" if now > before else None

    return shown


SHORTFALLS: dict[str, Shown] = {
    "target missed": _missed,
    "manifold did not stay so": _appeared("nm_edges", "nm_vertices"),
    "closed did not stay so": _appeared("boundary"),
    "cracks: closed, merged, did not stay so": _appeared(MERGED + "boundary"),
    "more border edges, merged": _grew(MERGED + "boundary"),
    "more non-manifold edges, merged": _grew(MERGED + "nm_edges"),
    "more back-to-back faces": _grew("back_to_back"),
    "more back-to-back faces, merged": _grew(MERGED + "back_to_back"),
    "more faces without area": _grew("zero_area"),
    "more flipped faces": _grew("flipped"),
    "more pieces": _grew("components"),
    "more pieces, merged": _grew(MERGED + "components"),
}
"""What is counted of our results and of MeshLab's alike; merged: vertices of equal position."""


def row_table(rows: Sequence[Row]) -> tables.Table:
    """All rows."""
    cells = ([escape(cell) for cell in row.cells()] for row in rows)
    return tables.table(
        "Every mesh at every level: ratios are ours over MeshLab's", HEADINGS, cells
    )


def summary(rows: Sequence[Row]) -> list[tables.Table]:
    """By level, and what ours falls short in."""
    return [_level_table(rows), _shortfall_table(rows)]


def _level_table(rows: Sequence[Row]) -> tables.Table:
    levels = sorted({row.level for row in rows}, reverse=True)
    parts = {f"{level:g}%": [row for row in rows if row.level == level] for level in levels}
    headings = (
        "to",
        "cases",
        "missed",
        "compared",
        "RMS",
        "max",
        "RMS above",
        "max above",
        "share",
    )
    return tables.table(
        "Geometric means where both met the target",
        headings,
        [_level_cells(name, part) for name, part in {**parts, "all": rows}.items()],
    )


def _level_cells(name: str, rows: Sequence[Row]) -> list[str]:
    fair = [row for row in rows if not row.on_unequal_terms]
    ratios = {error: [row.ratio(error) for row in fair] for error in ERRORS}
    above = {error: sum(r is not None and r > 1 for r in ratios[error]) for error in ERRORS}
    judged = sum(ratio is not None for ratio in ratios["max"])
    return [
        *(name, str(len(rows)), str(sum(is_missed(row, row.ours) for row in rows)), str(judged)),
        *(_number(geometric_mean(ratios[error])) for error in ERRORS),
        *(str(above[error]) for error in ERRORS),
        f"{above['max'] / judged:.0%}" if judged else "-",
    ]


def _shortfall_table(rows: Sequence[Row]) -> tables.Table:
    cells = [_failed(rows), *(_above(rows, error) for error in ERRORS)]
    cells += [_fallen_short(rows, what) for what in SHORTFALLS]
    headings = (
        "where ours falls short",
        "ours",
        "MeshLab's",
        "meshes",
        "which of ours (the first)",
    )
    result = tables.table("Cases of a mesh at a level", headings, cells)
    result.columns[-1].justify = "left"
    return result


def _failed(rows: Sequence[Row]) -> list[str]:
    ours = [(row, row.ours.failure.splitlines()[-1]) for row in rows if row.ours.failure]
    return _line("failed", ours, sum(bool(row.meshlab.failure) for row in rows))


def _above(rows: Sequence[Row], error: str) -> list[str]:
    ratios = [(row, ratio) for row in rows if (ratio := row.ratio(error)) is not None]
    above = sorted((pair for pair in ratios if pair[1] > 1), key=lambda pair: -pair[1])
    what = {"rms": "RMS above MeshLab's, MeshLab's above ours", "max": "maximum, likewise"}[error]
    below = sum(ratio < 1 for _, ratio in ratios)
    return _line(what, [(row, _number(ratio)) for row, ratio in above], below)


def _fallen_short(rows: Sequence[Row], what: str) -> list[str]:
    shown = SHORTFALLS[what]
    ours = [(row, text) for row in rows if not row.ours.failure and (text := shown(row, row.ours))]
    others = [row for row in rows if not row.meshlab.failure and shown(row, row.meshlab)]
    return _line(what, ours, len(others))


def _line(what: str, ours: Sequence[tuple[Row, str]], others: int) -> list[str]:
    cases: dict[str, list[tuple[Row, str]]] = {}
    for row, shown in ours:
        cases.setdefault(row.mesh, []).append((row, shown))
    named = [_of_one_mesh(mesh, pairs) for mesh, pairs in cases.items()]
    return [what, str(len(ours)), str(others), str(len(cases)), escape(", ".join(named))]


def _of_one_mesh(mesh: str, cases: Sequence[tuple[Row, str]]) -> str:
    """The levels, and the figure of the first."""
    levels = " ".join(f"{row.level:g}" for row, _ in cases)
    return f"{mesh} {levels}% ({cases[0][1]})"


def changes(before: Sequence[Row], now: Sequence[Row]) -> tables.Table:
    """The rows in which our result is another one than in an earlier run."""
    earlier = {row.name: row for row in before if not row.ours.failure}
    pairs = [(earlier[row.name], row) for row in now if row.name in earlier]
    pairs = [pair for pair in pairs if not pair[1].ours.failure]
    means = [
        f"{error} {_number(geometric_mean(_new_over_old(*pair, error) for pair in pairs))}"
        for error in ERRORS
    ]
    return tables.table(
        f"Ours now over before, means of {len(pairs)} cases: {', '.join(means)}",
        ("changed by more than 1 %", "RMS", "max", "faces", "defects"),
        [_change_cells(*pair) for pair in pairs if _is_changed(*pair)],
    )


def _new_over_old(before: Row, now: Row, error: str) -> float:
    return tables.ratio(getattr(now.ours, error), getattr(before.ours, error), NO_DISTANCE)


def _is_changed(before: Row, now: Row) -> bool:
    ratios = [_new_over_old(before, now, error) for error in ERRORS]
    ratios.append(now.ours.faces / before.ours.faces)
    return any(abs(ratio - 1) > _CHANGE for ratio in ratios) or bool(_changed_defects(before, now))


def _changed_defects(before: Row, now: Row) -> list[str]:
    old, new = before.ours.defects, now.ours.defects
    return [f"{_label(name)} {old[name]}>{new[name]}" for name in new if old[name] != new[name]]


def _change_cells(before: Row, now: Row) -> list[str]:
    return [
        escape(now.name),
        *(_number(_new_over_old(before, now, error)) for error in ERRORS),
        f"{before.ours.faces}>{now.ours.faces}",
        escape("; ".join(_changed_defects(before, now))),
    ]
