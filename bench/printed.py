# SPDX-License-Identifier: GPL-3.0-or-later
"""What a source prints, with our figures in the same row, and what is not to be had."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import tables

LOST = "lost"  # printed, but not in the text of the source that we have
NOT_PRINTED = "not printed"
NOTHING = "-"
NO_MESH = "no mesh like it at hand"


@dataclass(frozen=True)
class Row:
    """A row of a source's table.

    mesh: as the source names it. printed: its figures, or LOST, or NOT_PRINTED.
    our_mesh: the same mesh, or what stands in for it, as it says; NO_MESH where nothing does.
    """

    mesh: str
    printed: Sequence[str]
    our_mesh: str = NO_MESH
    ours: Sequence[str] = ()


def beside(
    title: str, printed: Sequence[str], ours: Sequence[str], rows: Iterable[Row]
) -> tables.Table:
    """A table of rows; printed and ours: the headings of their figures."""
    theirs = (f"{heading}, printed" for heading in printed)
    headings = ("their mesh", *theirs, "our mesh", *(f"{heading}, ours" for heading in ours))
    return tables.table(title, headings, (_cells(row, len(ours)) for row in rows))


def _cells(row: Row, count: int) -> list[str]:
    missing = [NOTHING] * (count - len(row.ours))
    return [row.mesh, *row.printed, row.our_mesh, *row.ours, *missing]


def instead(name: str) -> str:
    """Says of our mesh that it is another one than the source's."""
    return f"{name}, in its place"
