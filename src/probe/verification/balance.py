"""Does a suite balance what a guesser could lean on? Counts over its tasks."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from probe.generation.necessary import is_answerable_at_sight
from probe.tasks.task import LETTERS, PAIR, QUESTION_TYPES, QuestionType, Task
from probe.verification.type_verifier import verifier_of


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
        oldest = min(task.version for task in mine)
        for crossing in verifier_of(question_type).crossed:
            if not crossing.since <= oldest <= crossing.until:
                continue
            # What lies open tells the answer, and isn't crossed with anything.
            hidden = [it for it in mine if not is_answerable_at_sight(it)]
            found = [crossing.value_of(task) for task in hidden]
            yield _balance(question_type, crossing.of, crossing.values, found)


def _balance(
    question_type: QuestionType, of: str, values: Sequence[str], found: Sequence[str]
) -> Balance:
    return Balance(question_type, of, {**dict.fromkeys(values, 0), **Counter(found)})
