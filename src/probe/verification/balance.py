"""Does a suite balance what a guesser could lean on? Counts over its tasks."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import product

from probe.tasks.task import LETTERS, PAIR, QUESTION_TYPES, QuestionType, Task


@dataclass(frozen=True)
class Balance:
    """How often each value of something occurs among a type's tasks.

    Attributes:
        question_type: The type.
        of: What is counted.
        counts: By value; values that should occur as often as each other.
    """

    question_type: QuestionType
    of: str
    counts: dict[str, int]

    @property
    def even(self) -> bool:
        """Whether none occurs more than once oftener than another."""
        return max(self.counts.values()) - min(self.counts.values()) <= 1


def balances(tasks: Sequence[Task]) -> Iterator[Balance]:
    """Letters of all types, and what the types cross or share out."""
    for question_type in QUESTION_TYPES:
        mine = [task for task in tasks if task.question_type == question_type]
        if not mine:
            continue
        letters = PAIR if mine[0].marks else LETTERS
        yield _balance(question_type, "letter", letters, [task.answer for task in mine])
        for of, values, value_of in _CROSSED.get(question_type, ()):
            yield _balance(question_type, of, values, [value_of(task) for task in mine])


def _balance(
    question_type: QuestionType, of: str, values: Sequence[str], found: Sequence[str]
) -> Balance:
    return Balance(question_type, of, {**dict.fromkeys(values, 0), **Counter(found)})


def _patches(task: Task) -> str:
    tell = "tell" if task.certificate.measures["patch_lead"] > 0 else "mislead"
    return f"{task.answer}, patches {tell}"


def _area(task: Task) -> str:
    """The letter, and whether more pixels of the right thing show."""
    seen = [task.certificate.visibility[mark.instance] for mark in task.marks]
    right, wrong = seen if task.answer == "A" else seen[::-1]
    return f"{task.answer}, more of it shows: {right.visible_px > wrong.visible_px}"


def _larger(task: Task) -> str:
    """What shows of the larger thing."""
    leads = (task.certificate.measures[name] > 0 for name in ("area_lead", "length_lead"))
    return "more: {}, longer: {}".format(*leads)


def _count(task: Task) -> str:
    measures = task.certificate.measures
    return f"{measures['clear']:.0f} clear, {measures['hidden']:.0f} hidden"


_Crossing = tuple[str, Sequence[str], Callable[[Task], str]]

_LETTER_AREA: _Crossing = (
    "letter x larger area",
    [f"{a}, more of it shows: {b}" for a, b in product(PAIR, (True, False))],
    _area,
)

_CROSSED: dict[QuestionType, tuple[_Crossing, ...]] = {
    "compare": (
        (
            "letter x patches",
            [f"{a}, patches {b}" for a, b in product(PAIR, ("tell", "mislead"))],
            _patches,
        ),
        _LETTER_AREA,
    ),
    "count": (
        (
            "clear x hidden",
            [f"{a} clear, {b} hidden" for a, b in product(range(4), range(3))],
            _count,
        ),
    ),
    "size": (
        _LETTER_AREA,
        (
            "what shows of the larger",
            [f"more: {a}, longer: {b}" for a, b in product((True, False), repeat=2)],
            _larger,
        ),
    ),
}
"""What is crossed in a type: its names, all values, and the value of a task."""
