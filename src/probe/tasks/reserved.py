"""Whether a suite that bears the name of a packaged one is that one, or an honest part of it."""

from __future__ import annotations

from collections.abc import Callable

from probe.tasks.suite import Suite
from probe.tasks.task import Task

Difference = Callable[[Task, Task], str | None]
"""In what a task isn't as it should be beside the packaged one; None if in nothing."""


def difference(task: Task, packaged: Task) -> str | None:
    """The first field in which a task isn't the packaged one."""
    return next(
        (
            f"its {name} differs"
            for name, value in vars(packaged).items()
            if vars(task)[name] != value
        ),
        None,
    )


def unlike(suite: Suite, packaged: Suite, differs: Difference = difference) -> str | None:
    """In what a suite is neither the packaged one of its name nor a part of it; None if in nothing.

    Args:
        suite: What bears the name.
        packaged: What the name belongs to.
        differs: Compares a task with the packaged one of its id.
    """
    known = {task.id: task for task in packaged.tasks}
    for task in suite.tasks:
        if task.id not in known:
            return f"that has no task {task.id}"
        reason = differs(task, known[task.id])
        if reason:
            return f"task {task.id} is another one there: {reason}"
    places = [list(known).index(task.id) for task in suite.tasks]
    if places != sorted(places):
        return "its tasks stand in another order"
    for id, mark in suite.objects.items():
        if packaged.objects.get(id) != mark:
            return f"the fingerprint of {id} is another one there"
    return None
