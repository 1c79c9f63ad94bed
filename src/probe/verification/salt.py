"""Does a private suite follow from the salt it was committed to? No pictures, no physics."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from probe.generation.attempt import Attempt
from probe.generation.build import in_order
from probe.tasks.suite import Suite


def salt_problems(suite: Suite, found: Mapping[str, Attempt]) -> Iterator[str]:
    """What of a suite isn't as its salt gives it: ids, seeds, letters, forms, order.

    Args:
        suite: A private one.
        found: Where its tasks come from; see origins().
    """
    for task in suite.tasks:
        if task.id not in found:
            yield f"{task.id}: doesn't come from this salt"
            continue
        if task.scene.seed != task.seed:
            yield f"{task.id}: its scene bears another seed"
        plan = found[task.id].plan
        if (task.answer, task.form) != (plan.letter, plan.form):
            yield f"{task.id}: {plan.letter} and {plan.form!r} were planned as answer and form"
    if list(suite.tasks) != in_order(suite.tasks):
        yield "tasks aren't in the order of their ids"
