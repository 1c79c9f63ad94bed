"""What grading, suites and scores need to know of a question type. Knows no tools and no scenes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from probe.tasks.registry import part_of

Form = str
"""What exactly a type asks, one of its rules' forms; "plain" where it asks for one thing alone."""

Answers = Literal["objects", "numbers", "marks"]
"""What the options are: four of five objects, four of five numbers, or the two marked things."""

Searched = Literal["target", "copies", "table"]
"""What "none of the above" rests on: what is in the target's place, what is beneath all copies of
its cover, or all that is on the table."""


@dataclass(frozen=True)
class TypeRules:
    """The rules of a question type.

    Attributes:
        forms: What it may ask, and for each form the slots that its wordings have.
        answers: What its options are.
        fewest_targets: Objects that decide, at least.
        pointed: Whether a named option needs a point on the object.
        strata: Whether a little of its target may show at first: it is then reported in two parts.
        naive: Share that counting what shows makes right, where that is more than a guess.
        exact: Whether an answer counts only if what is named has left the table at the end and
            everything else is where it was; see grade().
        copies: Whether the thing that its subject names is there several times.
        rivals: Whether more candidates than the true one may be on the table, of unlike sizes.
        bystanders: How many more of the candidates are on the table, alike to the true one.
        searched: What has to be seen before "none of the above" is known to be right.
    """

    forms: Mapping[Form, frozenset[str]]
    answers: Answers
    fewest_targets: int
    pointed: bool = False
    strata: bool = False
    naive: float = 0.0
    exact: bool = False
    copies: bool = False
    rivals: bool = False
    bystanders: int = 0
    searched: Searched = "target"

    @property
    def paired(self) -> bool:
        """Whether it asks about two marked things."""
        return self.answers == "marks"

    @property
    def numbered(self) -> bool:
        """Whether its options are numbers."""
        return self.answers == "numbers"


def rules_of(question_type: str) -> TypeRules:
    """The rules of a question type.

    Raises:
        UnknownName: There is no such type.
        IncompleteType: Its rules can't be used.
    """
    return part_of(question_type, "rules", TypeRules)
