"""What checking a frozen task needs of its question type. Knows none of the types."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from probe.assets.library import Library
from probe.tasks.options import CANDIDATES
from probe.tasks.registry import part_of
from probe.tasks.task import NEWEST_RULES, RulesVersion, Task
from probe.verification.remeasure import Remeasurement

TextCheck = Callable[[Task, Library], Iterator[str]]
TableCheck = Callable[[Task, Remeasurement], Iterator[str]]
"""Yield what is wrong, in words."""


@dataclass(frozen=True)
class Makeup:
    """What every task of a type has.

    Attributes:
        targets: How many; None for any number.
        candidates: How many its certificate lists.
        measures: Numbers that its certificate must state.
        cover: Whether it names a cover.
        named: Whether it names things to remove.
        manipulations: Grasps and pushes that its question allows; None for as many as usual.
    """

    targets: int | None
    candidates: int = CANDIDATES
    measures: tuple[str, ...] = ()
    cover: bool = False
    named: bool = False
    manipulations: int | None = None


@dataclass(frozen=True)
class Crossing:
    """What a suite should balance of a type, beside its letters.

    Attributes:
        of: Its name.
        values: That should occur as often as each other.
        value_of: The value of a task.
        since: The first version of the rules by which it is balanced.
        until: The last one.
    """

    of: str
    values: Sequence[str]
    value_of: Callable[[Task], str]
    since: RulesVersion = 2
    until: RulesVersion = NEWEST_RULES


def nothing_wrong(task: Task, anew: Remeasurement | Library) -> Iterator[str]:
    """A check that a type has no use for."""
    yield from ()


@dataclass(frozen=True)
class Verifier:
    """How tasks of a type are checked; the part "verifier" of a question type.

    Attributes:
        makeup: What they are made of.
        slots: What fills their wordings' slots, from the table where it can be.
        subject: Is what they ask about what is said to be there, and does the catalogue give the
            answer?
        hidden: Is the answer hidden, and does it come to light as the type's rule says?
        true_text: The option that is true, by the truth of the starting scene alone. Raises
            ValueError where several could be.
        listed: Further checks that the text relies on, once all objects are known.
        clear: Further ways in which the answer could be understood otherwise.
        crossed: What a suite balances.
    """

    makeup: Makeup
    slots: Callable[[Task, Library], Mapping[str, str]]
    subject: TextCheck
    hidden: TableCheck
    true_text: Callable[[Task, Remeasurement], str]
    listed: TextCheck = nothing_wrong
    clear: TableCheck = nothing_wrong
    crossed: tuple[Crossing, ...] = ()


def verifier_of(question_type: str) -> Verifier:
    """How tasks of a type are checked.

    Raises:
        UnknownName: There is no such type.
        IncompleteType: Its verifier can't be used.
    """
    return part_of(question_type, "verifier", Verifier)
