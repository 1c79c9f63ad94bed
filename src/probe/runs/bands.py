"""Whether a task's rule of visibility still holds where its table is seen otherwise."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from probe.generation.visibility_rules import is_clear, is_hidden, is_little, is_partly_visible
from probe.scene.visibility import Visibility
from probe.tasks.task import QuestionType, Task
from probe.tasks.type_rules import rules_of

Band = Literal["hidden", "partly", "between", "little", "clear"]


def broken_rule(task: Task, now: Mapping[int, Visibility]) -> str | None:
    """What deciding object shows more or less than the task's type allows, in words; else None.

    Args:
        task: As it was frozen, with what was measured then.
        now: Visibility by instance as it is now.
    """
    for number in dict.fromkeys((*task.targets, *task.named)):
        was, is_ = (
            _band(task.question_type, seen[number]) for seen in (task.certificate.visibility, now)
        )
        if was != is_:
            share = now[number].fraction
            return f"object {number} was {was}, is {is_} ({share:.0%} visible)"
    return None


def _band(question_type: QuestionType, seen: Visibility) -> Band:
    if rules_of(question_type).paired:
        return "little" if is_little(seen) else "between"
    if is_hidden(seen):
        return "hidden"
    if is_clear(seen):
        return "clear"
    return "partly" if is_partly_visible(seen) else "between"
