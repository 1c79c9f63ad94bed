"""Which tasks ask about the same things as another one: a suite has each pair of things once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from probe.generation.build_folder import BuildFolder, TaskSlot
from probe.tasks.suite_file import read_suite
from probe.tasks.task import ONCE_RULES, Task

Roles = tuple[str, frozenset[str]]
"""A question type and the ids of the objects that play its parts."""


def roles_of(task: Task) -> Roles:
    """A task's type, what decides it and what the question names as hiding that."""
    instances = {*task.targets, *([] if task.cover is None else [task.cover])}
    placed = {item.instance: item.object_id for item in task.scene.objects}
    return task.question_type, frozenset(placed[instance] for instance in instances)


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
    tasks = {place: read_suite(parts.task_path(place)).tasks[0] for place in places}
    tasks = {place: task for place, task in tasks.items() if task.version >= ONCE_RULES}
    again = repeated(tasks)
    for place in again:
        _, ids = roles_of(tasks[place])
        parts.turn_back(place, f"another task is about {' and '.join(sorted(ids))}")
    return again
