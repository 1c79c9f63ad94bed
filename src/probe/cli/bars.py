"""How far long work is."""

from __future__ import annotations

from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)

_HOUR = 3600.0


def bar() -> Progress:
    """A bar with words, counts, time spent and time left."""
    return Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        TextColumn("left"),
        TimeRemainingColumn(),
        # The harness sets up rich's global console anew, which ends what is shown there.
        console=Console(),
        # Episodes and tasks take minutes; a rate over half a minute would know of none.
        speed_estimate_period=_HOUR,
    )
