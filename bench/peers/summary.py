# SPDX-License-Identifier: GPL-3.0-or-later
"""Geometric means over all cases, the best peer of each case, and what ours is held to."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from tables import ratio

from peers.policies import (
    BALANCED,
    BASELINE,
    BEST,
    CORE,
    CORE_FAST,
    FAST,
    MESHOPTIMIZER_UPDATE,
    OURS,
)
from peers.records import Record, by_case

ERRORS = ("rms", "mean", "max", "rms_salient", "ndev")
RATIOS = ("time", "peak", *ERRORS, "angle_mean", "angle_low")
_ABOVE_TARGET = 1.02  # of the target: above, fewer errors come from more faces
_BASELINE_FAILED = 5.0  # times the best RMS: the baseline's errors are then no yardstick
_NO_DISTANCE = 1e-9  # % of the diagonal: rounding

# At most so much of the best peer's RMS; of simplifyWithUpdate's time and RMS for Fast.
BARS = {"Best": 0.9, "Balanced": 1, "Fast's time": 1, "its core's": 1, "Fast's RMS": 1}
BEST_MEAN_BAR = 0.8  # of Best in the geometric mean over all cases


@dataclass(frozen=True)
class Means:
    """A policy over all cases it ended: geometric means of its ratios to the baseline.

    means: by figure; None where no case has it. cases: of the errors.
    """

    policy: str
    cases: int
    means: dict[str, float | None]


@dataclass(frozen=True)
class Standing:
    """Ours in one case. Each ratio is None where one of the two was not measured."""

    mesh: str
    fraction: float
    best_peer: Record
    best: float | None  # RMS of Best over that of the best peer
    balanced: float | None  # RMS of Balanced over that of the best peer
    fast_time: float | None  # of Fast over that of meshoptimizer's simplifyWithUpdate
    core_time: float | None  # the same without the host
    fast_rms: float | None  # of Fast over that of simplifyWithUpdate

    @property
    def ratios(self) -> tuple[float | None, ...]:
        """In the order of the bars."""
        return self.best, self.balanced, self.fast_time, self.core_time, self.fast_rms

    @property
    def missed(self) -> list[str]:
        """Which bars are not reached."""
        pairs = zip(BARS.items(), self.ratios, strict=True)
        return [name for (name, bar), value in pairs if value is not None and value > bar]


def geometric_mean(values: Iterable[float | None]) -> float | None:
    """Of the positive, finite values; None if there are none."""
    usable = [v for v in values if v is not None and 0 < v < math.inf]
    return math.exp(sum(map(math.log, usable)) / len(usable)) if usable else None


def is_on_target(record: Record) -> bool:
    """Whether it ended, and with no more faces than a comparison of errors allows."""
    return not record.failure and record.faces <= _ABOVE_TARGET * record.target


def best_peer(case: Iterable[Record]) -> Record | None:
    """The peer, not ours, with the lowest RMS on the target; None where no error was judged."""
    others = (record for record in case if record.peer not in (OURS, CORE))
    peers = [r for r in others if is_on_target(r) and r.figure("rms") is not None]
    return min(peers, key=lambda record: record.figures["rms"], default=None)


def failed_baselines(records: Iterable[Record]) -> list[tuple[str, float]]:
    """Cases whose errors no ratio is taken of, since the baseline itself failed there."""
    failed = []
    for key, case in by_case(records).items():
        baseline, best = case.get(BASELINE), best_peer(case.values())
        rms = baseline.figure("rms") if baseline else None
        if best is not None and rms is not None and rms > _BASELINE_FAILED * best.figures["rms"]:
            failed.append(key)
    return failed


def means(records: Sequence[Record]) -> list[Means]:
    """One for every policy that ended a case, the lowest RMS first."""
    cases = by_case(records)
    failed = failed_baselines(records)
    names = list(dict.fromkeys(record.policy for record in records if not record.failure))
    found = [_means_of(name, cases, failed) for name in names]
    return sorted(found, key=lambda each: each.means["rms"] or math.inf)


def _means_of(
    policy: str,
    cases: dict[tuple[str, float], dict[str, Record]],
    failed: Sequence[tuple[str, float]],
) -> Means:
    ratios: dict[str, list[float | None]] = {name: [] for name in RATIOS}
    for key, case in cases.items():
        mine, baseline = case.get(policy), case.get(BASELINE)
        if mine is None or baseline is None:
            continue
        for name in RATIOS:
            if name in ("time", "peak") or (key not in failed and is_on_target(mine)):
                ratios[name].append(_ratio(mine, baseline, name))
    judged = sum(value is not None for value in ratios["rms"])
    return Means(policy, judged, {name: geometric_mean(all_) for name, all_ in ratios.items()})


def standings(records: Iterable[Record]) -> list[Standing]:
    """Every case in which a peer was judged."""
    found = []
    for (mesh, fraction), case in by_case(records).items():
        best = best_peer(case.values())
        if best is None:
            continue
        update = case.get(MESHOPTIMIZER_UPDATE)
        standing = Standing(
            mesh,
            fraction,
            best,
            best=_ratio(case.get(BEST), best, "rms"),
            balanced=_ratio(case.get(BALANCED), best, "rms"),
            fast_time=_ratio(case.get(FAST), update, "time"),
            core_time=_ratio(case.get(CORE_FAST), update, "time"),
            fast_rms=_ratio(case.get(FAST), update, "rms"),
        )
        if any(ratio is not None for ratio in standing.ratios):
            found.append(standing)
    return found


def _ratio(ours: Record | None, other: Record | None, name: str) -> float | None:
    if ours is None or other is None:
        return None
    mine, its = ours.figure(name), other.figure(name)
    if mine is None or its is None:
        return None
    return ratio(mine, its, _NO_DISTANCE if name in ERRORS else 0.0)
