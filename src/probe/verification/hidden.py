"""Is the answer hidden? Measured anew, by what the certificate states and by the type's rule."""

from __future__ import annotations

from collections.abc import Iterator

from probe.generation.necessary import NECESSARY
from probe.tasks.task import STEP_RULES, Task
from probe.verification.necessary import necessary_problems
from probe.verification.remeasure import Remeasurement
from probe.verification.type_verifier import verifier_of

_SAME = 0.02
_SAME_PX = 40
"""How far pixels may differ from the certificate's on another kind of machine: by share, or few."""


def hidden_problems(task: Task, anew: Remeasurement) -> Iterator[str]:
    """What is wrong with what shows of a task's first picture and after ghost removal."""
    for number, stated in task.certificate.visibility.items():
        found = anew.seen[number].visible_px
        if abs(found - stated.visible_px) > max(_SAME * stated.visible_px, _SAME_PX):
            yield f"{found} px of object {number} show, not {stated.visible_px}"
    verifier = verifier_of(task.question_type)
    yield from verifier.hidden(task, anew)
    if task.version >= STEP_RULES and NECESSARY not in verifier.makeup.measures:
        yield from necessary_problems(task, anew)
