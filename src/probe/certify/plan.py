"""What an episode is to be like, fixed before any attempt, so that no check can tilt it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import TypeVar

from probe.scene.seeds import generator
from probe.tasks.task import LETTERS, PAIR, Form, Letter, QuestionKind
from probe.tasks.wordings import wordings

ATTEMPTS = 1000
"""Seeds of one episode: attempt k of episode e has seed 1000 e + k, plus a base."""

_COUNTS = tuple(product(range(4), range(3)))
_REMOVALS = (1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 5)
PAIRED: tuple[QuestionKind, ...] = "compare", "size"
"""Types that ask about two marked things."""

_CROSSED = tuple(product(PAIR, (True, False), (True, False)))
_MORE_CUES = tuple(product((True, False), repeat=2))
_PARTLY = (False, False, True)
_LIGHTER = (True, False)
_BALANCED: Mapping[QuestionKind, tuple[int, ...]] = {
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
class Plan:
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


def plan(kind: QuestionKind, seed: int) -> Plan:
    """The plan of the episode that an attempt's seed belongs to.

    Each property runs through all its values in every block of consecutive episodes, in an order
    drawn for the block: letters balance over any suite, yet none can be foretold.
    """
    episode = seed // ATTEMPTS
    texts = wordings(kind)
    wording = _turn(range(len(texts)), episode, kind, "wording")
    visible, hidden = _turn(_COUNTS, episode, kind, "count")
    crossed, first, second = _turn(_CROSSED, episode, kind, "crossed")
    form = texts[wording].form
    third, longer_cover = _turn(_MORE_CUES, episode, kind, "cues")
    return Plan(
        letter=crossed if kind in PAIRED else _turn(LETTERS, episode, kind, "letter"),
        wording=wording,
        form=form,
        visible=visible,
        hidden=hidden,
        partly=_turn(_PARTLY, episode, kind, "partly"),
        removals=_turn(_REMOVALS, episode, kind, "removals"),
        cues=(first, second, third),
        longer_cover=longer_cover,
        lighter=_turn(_LIGHTER, episode, kind, "lighter"),
    )


def block_of(kind: QuestionKind, seed: int) -> int:
    """Number of an attempt's block: of episodes that together are even in all that is planned."""
    return seed // ATTEMPTS // math.lcm(len(wordings(kind)), *_BALANCED[kind])


def _turn(values: Sequence[_T], episode: int, kind: str, purpose: str) -> _T:
    block, place = divmod(episode, len(values))
    order = generator(block, "plan", kind, purpose).permutation(len(values))
    return values[int(order[place])]
