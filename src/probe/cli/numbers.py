"""Between which numbers each option of the command line may be; others are refused at once."""

from __future__ import annotations

import math
from collections.abc import Mapping

from probe.episodes.ordered import MOST_RUNS
from probe.errors import BadData

_MANY, _SEED = 1_000_000, 2**63 - 1
_PROCESSES = (1, 256)
_RANGES: Mapping[str, tuple[float, float]] = {
    "--at-once": (1, 40),
    "--batch": (1, 10_000),
    "--buried": (0, 200),
    "--counts": (0, _MANY),
    "--direct-runs": (1, MOST_RUNS),
    "--epochs": (1, MOST_RUNS),
    "--first": (0, 10**12),
    "--first-seed": (0, _SEED),
    "--gallery": (0, 100_000),
    "--grasps": (0, _MANY),
    "--heads": (1, 1024),
    "--histories": (0, _MANY),
    "--layers": (1, 1024),
    "--least": (0, 1000),
    "--limit": (1, _MANY),
    "--most-cost": (0, 1e9),
    "--most-episodes": (1, 10**9),
    "--objects": (1, 200),
    "--most-tokens": (1, _MANY),
    "--page-port": (0, 65_535),
    "--port": (0, 65_535),
    "--pose-jitter": (0, 0.1),
    "--pushes": (0, _MANY),
    "--rebuild": (0, _MANY),
    "--run": (0, MOST_RUNS),
    "--runs": (1, MOST_RUNS),
    "--seats": (1, 256),
    "--seed": (0, _SEED),
    "--views": (1, 24),
    "SEED": (0, _SEED),
    "--share": (0, 1),
    "--side-px": (32, 8192),
    "--sigma": (0, 0.5),
    "--slack": (0, 1000),
    "--slow-motions": (0, _MANY),
    "--temperature": (0, 2),
    "--timeout": (1, 86_400),
    "--total": (1, _MANY),
    "--vision-layers": (1, 1024),
    "--vision-width": (1, 65_536),
    "--width": (1, 65_536),
    "--words": (300, _MANY),
    "--workers": _PROCESSES,
}


def check_numbers(given: Mapping[str, float | None]) -> None:
    """See that numbers of the command line make sense.

    Args:
        given: Values of options by name; None where nothing was said. Of several values of one
            option ("--counts.find"), the name before the full stop says the range.

    Raises:
        BadData: One is out of its range, or no number.
    """
    for name, value in given.items():
        low, high = _RANGES[name.partition(".")[0]]
        if value is not None and not (math.isfinite(value) and low <= value <= high):
            raise BadData(name, f"{value} is out of range", f"Say {low:,} to {high:,}")
