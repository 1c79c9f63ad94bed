"""What each type of task takes of a library, in words made of the numbers its generator goes by."""

from __future__ import annotations

from collections.abc import Mapping

from probe.generation import find, marked, object_selection, reduce
from probe.generation.alike import LOOSE_TOLERANCE, TWIN_TOLERANCE
from probe.generation.count import NESTS
from probe.generation.covers import NEEDS_COVER, NEEDS_LEAN, NEEDS_SHIELD, NEEDS_SLAB
from probe.tasks.options import CANDIDATES
from probe.tasks.task import QuestionType


def _alike(count: int, largest: float, tolerance: float) -> str:
    low, high = 100 * object_selection.SMALLEST, 100 * largest
    alike = f"alike in length to {tolerance:.0%}, unlike in name and colour"
    return f"{count} things {low:g} to {high:g} cm long, {alike}"


NEEDS: Mapping[QuestionType, str] = {
    "beneath": f"{_alike(CANDIDATES, object_selection.LARGEST, TWIN_TOLERANCE)}; "
    f"over any of them {NEEDS_COVER}",
    "compare": "two kinds of things, each in two paints of one shape, which scans never are "
    f"({marked.MARKABLE}); over either, two {NEEDS_SHIELD}",
    "count": f"{_alike(1 + NESTS, object_selection.LARGEST, LOOSE_TOLERANCE)}; "
    f"over any of them, {NESTS} times, {NEEDS_COVER}",
    "find": f"{_alike(CANDIDATES, find.LARGEST_HIDDEN, TWIN_TOLERANCE)}; "
    f"over any of them {NEEDS_COVER}. For every third task "
    f"{_alike(CANDIDATES, find.LARGEST_PARTLY, LOOSE_TOLERANCE)} but for the colour's name; "
    f"over any of them {NEEDS_LEAN}",
    "reduce": f"{_alike(CANDIDATES, reduce.LARGEST, TWIN_TOLERANCE)} "
    f"(beneath several, up to {100 * reduce.LARGEST_BENEATH_MORE:g} cm); "
    f"over any of them one to five flat things {NEEDS_SLAB}",
    "size": "two things of which one is clearly larger "
    f"({marked.MARKABLE}); over either, two {NEEDS_SHIELD}",
}
