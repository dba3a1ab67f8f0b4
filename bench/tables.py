# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables for the terminal and, from the same rows, for Markdown files."""

from __future__ import annotations

import io
from collections.abc import Iterable, Sequence
from copy import copy
from pathlib import Path

from rich import box
from rich.console import Console
from rich.table import Table

_LEAST_WIDTH = 210  # columns: the widest table in one line; a narrow terminal folds it
_MARKDOWN_WIDTH = 1000  # no wrapping


def console() -> Console:
    """Standard output, wide enough that no cell is cut."""
    return Console(width=max(_LEAST_WIDTH, Console().width))


def table(title: str, headings: Sequence[str], rows: Iterable[Sequence[str]] = ()) -> Table:
    """A table whose first column is text and whose others are aligned right."""
    result = Table(title=title, title_justify="left", box=box.SIMPLE_HEAD)
    for index, heading in enumerate(headings):
        result.add_column(heading, justify="right" if index else "left")
    for row in rows:
        result.add_row(*row)
    return result


def ratio(ours: float, other: float, least: float = 0.0) -> float:
    """ours / other; values up to `least` count as zero, and zero over zero as 1."""
    if ours <= least:
        return 1.0 if other <= least else 0.0
    return ours / other if other > least else float("inf")


def save_markdown(path: Path, heading: str, notes: Sequence[str], tables: Sequence[Table]) -> None:
    """Writes notes as paragraphs, then the tables, each under its title."""
    parts = [f"# {heading}", *notes]
    for each in tables:
        parts += [f"## {each.title}", markdown(each)]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n\n".join(parts) + "\n", encoding="utf-8")


def markdown(shown: Table) -> str:
    """A table without its title."""
    plain = copy(shown)
    plain.box, plain.title = box.MARKDOWN, None
    stream = io.StringIO()
    Console(file=stream, width=_MARKDOWN_WIDTH).print(plain)
    return stream.getvalue().strip("\n")
