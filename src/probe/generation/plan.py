"""What an episode is to be like, fixed before any attempt, so that no check can tilt it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import TypeVar

from probe.generation.salt import Salt
from probe.scene.seeds import generator
from probe.tasks.task import LETTERS, PAIR, QUESTION_TYPES, Letter, QuestionType
from probe.tasks.type_rules import Form, rules_of
from probe.tasks.wordings import wordings

ATTEMPTS = 1000
"""Of one episode, at most: in a public suite attempt k of episode e has seed 1000 e + k."""

_COUNTS = tuple(product(range(4), range(3)))
_REMOVALS = (1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 5)
PAIRED: tuple[QuestionType, ...] = tuple(k for k in QUESTION_TYPES if rules_of(k).paired)
"""Types that ask about two marked things."""

_CROSSED = tuple(product(PAIR, (True, False), (True, False)))
_MORE_CUES = tuple(product((True, False), repeat=2))
_PARTLY = (False, False, True)
_LIGHTER = (True, False)
_BALANCED: Mapping[QuestionType, tuple[int, ...]] = {
    "beneath": (len(LETTERS),),
    "compare": (len(_CROSSED), len(_MORE_CUES)),
    "count": (len(LETTERS), len(_COUNTS)),
    "find": (len(LETTERS), len(_PARTLY)),
    "reduce": (len(LETTERS), len(_REMOVALS)),
    "size": (len(_CROSSED), len(_MORE_CUES), len(_LIGHTER)),
}
"""Episodes in which what a type is planned by, wordings apart, takes all its values."""

_T = TypeVar("_T")


@dataclass(frozen=True)
class TaskPlan:
    """What all attempts of an episode share.

    Attributes:
        letter: The right answer's; E means that the true candidate is the one left out.
        wording: Which of the type's wordings asks.
        form: That wording's.
        visible: Count: clear instances.
        hidden: Count: hidden instances.
        partly: Find: the target is partly visible rather than hidden.
        removals: Reduce: how many things are to be removed.
        cues: Compare: whether the patches that show tell the answer, and whether more pixels of the
            right thing show. Size: whether the larger thing shows by more pixels, whether what
            shows of it is longer, and whether more of its outline adjoins things.
        longer_cover: Size: whether the longer cover lies on the larger thing.
        lighter: Size: whether the larger thing is the lighter one.
    """

    letter: Letter
    wording: int
    form: Form
    visible: int
    hidden: int
    partly: bool
    removals: int
    cues: tuple[bool, bool, bool]
    longer_cover: bool
    lighter: bool


def plan(question_type: QuestionType, seed: int) -> TaskPlan:
    """The plan of the episode of a public suite that an attempt's seed belongs to."""
    return plan_of(question_type, seed // ATTEMPTS)


def plan_of(question_type: QuestionType, episode: int, salt: Salt | None = None) -> TaskPlan:
    """The plan of an episode, by its number.

    Each property runs through all its values in every block of consecutive episodes, in an order
    drawn for the block: letters balance over any suite. Whoever has this file can foretell them,
    but where a salt draws the orders.
    """
    texts = wordings(question_type)

    def turn(purpose: str, values: Sequence[_T]) -> _T:
        block, place = divmod(episode, len(values))
        if salt is None:
            rng = generator(block, "plan", question_type, purpose)
        else:
            rng = salt.generator("plan", question_type, purpose, block)
        return values[int(rng.permutation(len(values))[place])]

    wording = turn("wording", range(len(texts)))
    visible, hidden = turn("count", _COUNTS)
    crossed, first, second = turn("crossed", _CROSSED)
    third, longer_cover = turn("cues", _MORE_CUES)
    return TaskPlan(
        letter=crossed if question_type in PAIRED else turn("letter", LETTERS),
        wording=wording,
        form=texts[wording].form,
        visible=visible,
        hidden=hidden,
        partly=turn("partly", _PARTLY),
        removals=turn("removals", _REMOVALS),
        cues=(first, second, third),
        longer_cover=longer_cover,
        lighter=turn("lighter", _LIGHTER),
    )


def block_of(question_type: QuestionType, seed: int) -> int:
    """A public attempt's block: of episodes that together are even in all that is planned."""
    return seed // ATTEMPTS // math.lcm(len(wordings(question_type)), *_BALANCED[question_type])
