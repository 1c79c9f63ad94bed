"""A question about a starting scene, with its answer and the proof that it is hard. Data only."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, get_args

from probe.scene.scene import Scene
from probe.scene.visibility import Visibility

QuestionKind = Literal["beneath", "count", "find"]
KINDS: tuple[QuestionKind, ...] = get_args(QuestionKind)

Letter = Literal["A", "B", "C", "D", "E"]
LETTERS: tuple[Letter, ...] = get_args(Letter)

NONE_OF_THE_ABOVE = "None of the above"
"""Text of the last option, E."""

TASK_VERSION = 1
"""To be raised when rules change so that scores do."""


@dataclass(frozen=True)
class Option:
    """One answer to choose from."""

    letter: Letter
    text: str


@dataclass(frozen=True)
class Certificate:
    """What was measured in the starting scene; for auditors, never for agents.

    Attributes:
        visibility: Of each object, by instance.
        measures: The numbers of the rule of the task's type, by name.
        candidates: What the options were drawn from, the one that was left out included: object
            ids, or numbers in Count.
    """

    visibility: Mapping[int, Visibility]
    measures: Mapping[str, float]
    candidates: tuple[str, ...]


@dataclass(frozen=True)
class Task:
    """A question, its answer, and the table it is about.

    Attributes:
        id: Says nothing of the answer.
        kind: Its type.
        seed: What it was made from; never shown to an agent.
        subject: The words of the question that name a thing: the cover, or what is counted, in
            the singular; empty in Find.
        question: What the agent is asked.
        options: A to E; E is "None of the above".
        answer: The right letter.
        scene: The table at the start.
        targets: Instances whose presence decides: the hidden one, or all that are counted.
        cover: Instance of Beneath's cover, else None.
        certificate: Why it can't be answered by looking.
        version: Of the rules it was made by.
    """

    id: str
    kind: QuestionKind
    seed: int
    subject: str
    question: str
    options: tuple[Option, ...]
    answer: Letter
    scene: Scene
    targets: tuple[int, ...]
    cover: int | None
    certificate: Certificate
    version: int = TASK_VERSION
