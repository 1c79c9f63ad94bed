"""How frozen tasks of Count are checked."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import product

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.likeness import told_apart
from probe.generation.visibility_rules import is_clear, is_hidden
from probe.tasks.english import plural
from probe.tasks.options import MOST_HIDDEN
from probe.tasks.task import SIX_RULES, Task
from probe.tasks.truth import how_many
from probe.verification.remeasure import Remeasurement
from probe.verification.subjects import instances_called
from probe.verification.type_verifier import Crossing, Makeup, Verifier


def _slots(task: Task, library: Library) -> Mapping[str, str]:
    return {"names": str(plural(task.subject))}


def _subject(task: Task, library: Library) -> Iterator[str]:
    if plural(task.subject) is None:
        yield f"{task.subject!r} has no plural"
    measures = task.certificate.measures
    if measures["clear"] + measures["hidden"] != len(task.targets):
        yield f"it counts {len(task.targets)} and states other numbers of clear and hidden ones"
    if sorted(task.targets) != sorted(instances_called(task.subject, task, library)):
        yield f"it doesn't count all that is called {task.subject!r}"
    if task.targets:
        return
    # None is there: then nothing there may be taken for one.
    shown = {library[placed.object_id] for placed in task.scene.objects}
    if not any(told_apart([*shown, spec]) for spec in _called(task.subject, library)):
        yield f"{task.subject!r} isn't in the catalogue, or is like something on the table"


def _called(name: str, library: Library) -> list[ObjectSpec]:
    return [spec for spec in library.specs if spec.name == name]


def _hidden(task: Task, anew: Remeasurement) -> Iterator[str]:
    shown = [anew.seen[number] for number in task.targets]
    clear, hidden = sum(map(is_clear, shown)), sum(map(is_hidden, shown))
    measures = task.certificate.measures
    if (clear, hidden) != (measures["clear"], measures["hidden"]):
        yield f"{clear} are clear and {hidden} hidden"
    if clear + hidden != len(shown):
        yield "one is neither clear nor hidden"


def _true_text(task: Task, anew: Remeasurement) -> str:
    scene, library = task.scene, anew.library
    named = [o.object_id for o in scene.objects if library[o.object_id].name == task.subject]
    return str(how_many(scene, named[0]) if named else 0)


def _instances(task: Task) -> str:
    measures = task.certificate.measures
    return f"{measures['clear']:.0f} clear, {measures['hidden']:.0f} hidden"


def _numbers(most_clear: int) -> Sequence[str]:
    pairs = product(range(most_clear + 1), range(MOST_HIDDEN + 1))
    return [f"{clear} clear, {hidden} hidden" for clear, hidden in pairs]


VERIFIER = Verifier(
    makeup=Makeup(None, measures=("clear", "hidden")),
    slots=_slots,
    subject=_subject,
    hidden=_hidden,
    true_text=_true_text,
    crossed=(
        Crossing(
            "clear x hidden",
            _numbers(most_clear=3),
            _instances,
            until=2,
        ),
        Crossing(
            "clear x hidden",
            _numbers(most_clear=4),
            _instances,
            since=SIX_RULES,
        ),
    ),
)
