"""Which tasks ask about the same things as another one: a suite has each pair of things once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from probe.files import alone
from probe.generation.build_folder import BuildFolder, TaskSlot
from probe.tasks.suite_file import read_suite
from probe.tasks.task import ONCE_RULES, Task

Roles = tuple[str, frozenset[str]]
"""A question type and the ids of the objects that play its parts."""


def roles_of(task: Task) -> Roles:
    """A task's type, with the objects that decide it and the named ones that hide them.

    Where nothing on the table does (none of what is counted is there), the thing that is named.
    """
    hiding = task.named if task.cover is None else (task.cover,)
    objects = frozenset(task.scene[instance].object_id for instance in (*task.targets, *hiding))
    return task.question_type, objects or frozenset({task.subject})


def repeated(tasks: Mapping[TaskSlot, Task]) -> tuple[TaskSlot, ...]:
    """Places whose task has the roles of an earlier one, in the order of their numbers."""
    seen, found = set[Roles](), list[TaskSlot]()
    for place in sorted(tasks):
        roles = roles_of(tasks[place])
        if roles in seen:
            found.append(place)
        seen.add(roles)
    return tuple(found)


def turned_back(parts: BuildFolder, places: Sequence[TaskSlot]) -> tuple[TaskSlot, ...]:
    """Reject tasks that ask about the same things as an earlier one; gives their places.

    Which these are depends on the tasks alone, and not on who made which when.

    Raises:
        BadData: A task can't be read.
    """
    with alone(parts.folder):
        there = [place for place in places if parts.task_path(place).exists()]
        tasks = {place: read_suite(parts.task_path(place)).tasks[0] for place in there}
        again = repeated({at: task for at, task in tasks.items() if task.version >= ONCE_RULES})
        for place in again:
            # Not which things: the log of a private suite is for everyone.
            parts.turn_back(place, tasks[place], "another task is about the same things")
    return again
