# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line that the scripts under papers/ share."""

from __future__ import annotations

import argparse
from pathlib import Path

from decimators import DEFAULT_PLUGIN


def paper_options(doc: str) -> argparse.Namespace:
    """doc: the script's docstring; its first line describes it."""
    parser = argparse.ArgumentParser(description=doc.splitlines()[0])
    parser.add_argument("--plugin", type=Path, default=DEFAULT_PLUGIN)
    parser.add_argument("--save", action="store_true", help="write bench/results")
    return parser.parse_args()
