# SPDX-License-Identifier: GPL-3.0-or-later
"""Answers that are kept on the disk, for the next call with the same question."""

from __future__ import annotations

import hashlib
import json
import os
import threading
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any


def kept(folder: Path, question: Iterable[bytes], answer: Callable[[], Any]) -> Any:
    """What `answer` returned (JSON) when it was first asked this; what it raises is not kept."""
    file = folder / f"{hashlib.sha256(b''.join(question)).hexdigest()}.json"
    if file.is_file():
        return json.loads(file.read_text(encoding="utf-8"))
    result = answer()
    folder.mkdir(parents=True, exist_ok=True)
    unfinished = file.with_suffix(f".{os.getpid()}-{threading.get_ident()}")
    unfinished.write_text(json.dumps(result), encoding="utf-8")
    unfinished.rename(file)
    return result
