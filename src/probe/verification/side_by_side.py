"""Tasks with several covers side by side: does each hide one thing, and alone?"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from probe.generation.visibility_rules import is_clear, is_hidden
from probe.tasks.task import Task
from probe.tasks.truth import beneath_each, on_top
from probe.verification.remeasure import Remeasurement
from probe.verification.uncovering import uncovering_problems


def hiding_problems(task: Task, anew: Remeasurement, covers: Sequence[int]) -> Iterator[str]:
    """That one thing lies under each of some covers, is hidden, and comes to light without it."""
    shapes = anew.silhouettes
    for cover, under in beneath_each(covers, shapes).items():
        if len(under) != 1:
            yield f"{len(under)} things lie under cover {cover}"
            continue
        yield from _covered(cover, under[0], on_top(cover, shapes), anew)


def _covered(cover: int, item: int, above: Collection[int], anew: Remeasurement) -> Iterator[str]:
    """That a thing is hidden, and that its cover, with what lies on it, alone hides it."""
    if not is_hidden(anew.seen[item]):
        yield f"what is under cover {cover} shows by {anew.seen[item].fraction:.0%}"
    if not is_clear(anew.seen[cover]):
        yield f"only {anew.seen[cover].fraction:.0%} of cover {cover} show"
    for how, after in anew.removals([cover, *above]):
        when = f"without cover {cover} ({how})"
        yield from uncovering_problems(when, after, item, anew, "what it hides")
