"""Are so many removals necessary as a certificate says? Searched for anew."""

from __future__ import annotations

from collections.abc import Iterator

from probe.generation.necessary import NECESSARY, RemovalSearch
from probe.tasks.task import Task
from probe.verification.remeasure import Remeasurement


def necessary_problems(task: Task, anew: Remeasurement) -> Iterator[str]:
    """What is wrong with the number of removals that a task is said to need."""
    stated = task.certificate.measures[NECESSARY]
    found = RemovalSearch(task.scene, anew.view, anew.restaged).necessary(task)
    if found is None or len(found) != stated:
        needs = "more than can be tried" if found is None else str(len(found))
        yield f"it needs {needs} removals, not {stated:g}"
