# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables: one a mesh and target, then the means, the standings and who is absent."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from rich.table import Table
from tables import table

from peers.policies import BASELINE, MESHOPTIMIZER_UPDATE
from peers.records import Record, Results, by_case
from peers.summary import (
    BARS,
    BEST_MEAN_BAR,
    RATIOS,
    Means,
    Standing,
    failed_baselines,
    geometric_mean,
    is_on_target,
    means,
    standings,
)

NOTES = (
    "Distances in % of the original's bounding-box diagonal, angles in degrees. ms: median time of "
    "the call alone, every run in a fresh process, all policies in turn. time: over that of "
    f"{BASELINE}. MB: how far the process grew during the call, at its peak; B/face: the same in "
    "bytes for a face of the input. angle: mean of the faces' smallest angles, and the angle that "
    "5 % of the faces are below. nm: edges of more than two faces/vertices without one fan. flip: "
    "faces turned more than 90 degrees. zero/dup: faces without area/on the same vertices as "
    "another. self: faces that cut another. bnd: boundary edges. comp: components. A face count "
    "with * is more than 2 % above the target: its errors stand, but are not compared.",
    "Clusterings take a cell, not a face count: the cell whose count is nearest is searched for "
    "first, and the last call alone is timed. 'diagonal 1000': the mesh is scaled so, for peers "
    "whose result depends on the unit of length.",
)

_BOTH = ("policy", "faces", "ms", "time", "MB", "B/face")
_HEADINGS = (
    *_BOTH,
    *("RMS", "mean", "max", "salient", "ndev", "angle", "5 %"),
    *("nm", "flip", "zero/dup", "self", "bnd", "comp"),
)
_DISTANCES = ("rms", "mean", "max", "rms_salient")
_MEANS_HEADINGS = {
    "peak": "memory",
    "rms": "RMS",
    "rms_salient": "salient",
    "angle_mean": "angle",
    "angle_low": "5 %",
}
_NONE = "-"
_MB = 1e6


def every_table(results: Results) -> list[Table]:
    """In the order in which they are shown."""
    shown = [
        _case_table(mesh, fraction, list(case.values()), results.originals.get(mesh, {}))
        for (mesh, fraction), case in by_case(results.records).items()
    ]
    shown += _means_tables(results.records)
    found = standings(results.records)
    if found:
        shown.append(_standings_table(found))
    shown += _failures(results)
    return shown


def _case_table(
    mesh: str, fraction: float, records: Sequence[Record], original: dict[str, Any]
) -> Table:
    first = records[0]
    title = f"{mesh}: {first.faces_before:,} faces to {fraction:.0%}, {first.target:,}"
    baseline = next((r for r in records if r.policy == BASELINE and not r.failure), None)
    ended = [record for record in records if not record.failure]
    judged = any(record.figures for record in ended)
    if not judged:
        rows = (_cost_cells(r, baseline) for r in sorted(ended, key=lambda r: r.time))
        return table(title, _BOTH, rows)
    ended.sort(key=lambda record: record.figures["rms"])
    before = ["original", f"{first.faces_before}", *[""] * 9, *_shape_cells(original)]
    rows = [_cost_cells(r, baseline) + _figure_cells(r.figures) for r in ended]
    return table(title, _HEADINGS, [*([before] if original else []), *rows])


def _cost_cells(record: Record, baseline: Record | None) -> list[str]:
    above = "" if is_on_target(record) else "*"
    peak, per_face = record.peak, record.peak_per_face
    return [
        record.policy,
        f"{record.faces}{above}",
        _significant(1000 * record.time),
        _NONE if baseline is None else f"{record.time / baseline.time:.3f}",
        _NONE if peak is None else _significant(peak / _MB),
        _NONE if per_face is None else f"{per_face:.0f}",
    ]


def _figure_cells(figures: dict[str, Any]) -> list[str]:
    distances = [f"{figures[name]:.4f}" for name in _DISTANCES]
    return [*distances, f"{figures['ndev']:.2f}", *_shape_cells(figures)]


def _shape_cells(figures: dict[str, Any]) -> list[str]:
    """Angles and defects; a mesh has them by itself, but for flipped faces."""
    if not figures:
        return []
    return [
        f"{figures['angle_mean']:.1f}",
        f"{figures['angle_low']:.1f}",
        f"{figures['nm_edges']}/{figures['nm_vertices']}",
        f"{figures.get('flipped', '')}",
        f"{figures['zero_area']}/{figures['dup_faces']}",
        f"{figures['self_intersecting']}",
        f"{figures['boundary']}",
        f"{figures['components']}",
    ]


def _means_tables(records: Sequence[Record]) -> Iterable[Table]:
    """One, or none where the baseline was not measured."""
    found = means(records)
    taken = [name for name in RATIOS if any(each.means[name] is not None for each in found)]
    if not taken:
        return
    title = f"Geometric means of the ratios to {BASELINE}, errors where the target is met"
    failed = ", ".join(f"{mesh} to {fraction:.0%}" for mesh, fraction in failed_baselines(records))
    if failed:
        title += f"; errors without {failed}, where {BASELINE} fails"
    headings = ("policy", "cases", *(_MEANS_HEADINGS.get(name, name) for name in taken))
    yield table(title, headings, (_means_cells(each, taken) for each in found))


def _means_cells(each: Means, taken: Sequence[str]) -> list[str]:
    return [each.policy, f"{each.cases}", *(_ratio(each.means[name]) for name in taken)]


def _standings_table(found: Sequence[Standing]) -> Table:
    headings = (
        "mesh",
        "to",
        "best peer",
        "its RMS",
        *(f"{name} (≤ {bar:g})" for name, bar in BARS.items()),
        "missed",
    )
    rows = [_standing_cells(each) for each in found]
    overall = [geometric_mean(column) for column in zip(*(s.ratios for s in found), strict=True)]
    missed = "Best" if overall[0] is not None and overall[0] > BEST_MEAN_BAR else ""
    mean_name = f"geometric mean (Best ≤ {BEST_MEAN_BAR})"
    rows.append([mean_name, "", "", "", *map(_ratio, overall), missed])
    title = (
        "Ours over the best peer by RMS of each case; Fast's time and RMS over those of "
        f"{MESHOPTIMIZER_UPDATE}"
    )
    return table(title, headings, rows)


def _standing_cells(each: Standing) -> list[str]:
    return [
        each.mesh,
        f"{each.fraction:.0%}",
        each.best_peer.policy,
        f"{each.best_peer.figures['rms']:.4f}",
        *map(_ratio, each.ratios),
        ", ".join(each.missed),
    ]


def _failures(results: Results) -> Iterable[Table]:
    failed = [record for record in results.records if record.failure]
    if failed:
        rows = [(r.policy, r.mesh, f"{r.fraction:.0%}", _one_line(r.failure)) for r in failed]
        yield table("Runs without a result", ("policy", "mesh", "to", "reason"), rows)
    if results.absent:
        yield table("Absent peers", ("peer", "reason"), results.absent.items())


def _one_line(failure: str) -> str:
    """The last line of a message, which is what the peer said."""
    return failure.strip().splitlines()[-1]


def _ratio(value: float | None) -> str:
    return _NONE if value is None else f"{value:.3f}"


def _significant(value: float) -> str:
    """Three digits, without an exponent."""
    return f"{value:.0f}" if value >= 100 else f"{value:.3g}"
