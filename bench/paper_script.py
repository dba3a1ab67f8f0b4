# SPDX-License-Identifier: GPL-3.0-or-later
"""What the scripts under papers/ share: the command line, and where tables and pictures go."""

from __future__ import annotations

import argparse
import datetime
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import tables
from decimators import DEFAULT_PLUGIN
from error_picture import Shown, draw_errors
from meshes import REPOSITORY
from panels import View
from rich.table import Table
from workers import FilterError

_RESULTS, _IMAGES = REPOSITORY / "bench/results", REPOSITORY / "docs/images"

PictureRows = Sequence[tuple[View, Sequence[Shown]]]


@dataclass(frozen=True)
class Study:
    """What a script found.

    holds: the verdict that its head states. picture: makes the rows of docs/images/<script>.png.
    """

    tables: Sequence[Table]
    holds: bool
    picture: Callable[[], PictureRows]


@dataclass(frozen=True)
class Script:
    """A script by its file, what its results are called, and how it comes to them.

    times: measures times alone; they need an otherwise idle machine, so they are asked for by
    --times and kept in a file of their own.
    """

    file: str
    doc: str
    heading: str
    study: Callable[[Path], Study]
    times: Callable[[Path], Sequence[Table]] | None = None

    @property
    def name(self) -> str:
        return Path(self.file).stem

    def main(self) -> int:
        """Prints every table; the exit code is the verdict."""
        options = self._options()
        console = tables.console()
        try:
            if options.times:
                return self._tell_times(options, self.times(options.plugin))
            return self._tell(options, self.study(options.plugin))
        except FilterError as failure:
            console.print(f"failed: {failure}", markup=False)
            return 1

    def _options(self) -> argparse.Namespace:
        parser = argparse.ArgumentParser(description=self.doc.splitlines()[0])
        parser.add_argument("--plugin", type=Path, default=DEFAULT_PLUGIN)
        parser.add_argument("--save", action="store_true", help="write results and the picture")
        if self.times:
            parser.add_argument("--times", action="store_true", help="measure times alone")
        parser.set_defaults(times=False)
        return parser.parse_args()

    def _tell(self, options: argparse.Namespace, study: Study) -> int:
        self._print(study.tables)
        if options.save:
            self._save(study.tables, "", "--save")
            draw_errors(_IMAGES / f"{self.name}.png", study.picture())
        return 0 if study.holds else 1

    def _tell_times(self, options: argparse.Namespace, shown: Sequence[Table]) -> int:
        self._print(shown)
        if options.save:
            self._save(shown, "-times", "--times --save")
        return 0

    @staticmethod
    def _print(shown: Sequence[Table]) -> None:
        for each in shown:
            tables.console().print(each)

    def _save(self, shown: Sequence[Table], suffix: str, command: str) -> None:
        today = datetime.date.today().isoformat()
        measured = f"Measured on {today} with `python bench/papers/{self.name}.py {command}`."
        path = _RESULTS / f"{self.name}{suffix}.md"
        tables.save_markdown(path, self.heading, [self.doc.strip(), measured], shown)
