# SPDX-License-Identifier: GPL-3.0-or-later
"""How much memory one call needs, on Linux; also for processes that have only the standard library.

The kernel knows the resident set of a process (VmRSS) and its peak (VmHWM). Before the call what
was freed is given back and the peak is forgotten; after it the peak says how far the process grew.
"""

from __future__ import annotations

import ctypes
import gc
import re
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

_STATUS = Path("/proc/self/status")
_CLEAR = Path("/proc/self/clear_refs")
_FORGET_PEAK = "5"  # see proc(5)
_KIB = 1024


def status_bytes(status: str, name: str) -> int | None:
    """The line 'VmRSS:  1234 kB' of /proc/<pid>/status in bytes; None without such a line."""
    found = re.search(rf"^{re.escape(name)}:\s+(\d+) kB$", status, re.MULTILINE)
    return int(found.group(1)) * _KIB if found else None


def growth(before: str, after: str) -> int | None:
    """Bytes from the resident set before a call to the peak after it, of two status texts."""
    resident, peak = status_bytes(before, "VmRSS"), status_bytes(after, "VmHWM")
    return None if resident is None or peak is None else peak - resident


def measure(call: Callable[[], Any]) -> tuple[Any, float, int | None]:
    """What the call returns, its seconds, and the bytes it grew by; None where nobody knows."""
    known = _forget_peak()
    before = _status() if known else ""
    begin = time.perf_counter()
    result = call()
    seconds = time.perf_counter() - begin
    return result, seconds, growth(before, _status()) if known else None


def _forget_peak() -> bool:
    gc.collect()
    trim = getattr(ctypes.CDLL(None), "malloc_trim", None)  # glibc only
    if trim:
        trim(0)
    try:
        _CLEAR.write_text(_FORGET_PEAK, encoding="ascii")
    except OSError:
        return False
    return True


def _status() -> str:
    return _STATUS.read_text(encoding="ascii", errors="replace")
