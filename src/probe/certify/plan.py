"""What an episode is to be like, fixed before any attempt, so that no check can tilt it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from typing import TypeVar

from probe.scene.seeds import generator
from probe.tasks.task import LETTERS, Letter, QuestionKind

ATTEMPTS = 1000
"""Seeds of one episode: attempt k of episode e has seed 1000 e + k, plus a base."""

_COUNTS = tuple(product(range(4), range(3)))
_T = TypeVar("_T")


@dataclass(frozen=True)
class Plan:
    """What all attempts of an episode share.

    Attributes:
        letter: The right answer's; E means that the true candidate is the one left out.
        visible: Count: clear instances.
        hidden: Count: hidden instances.
        partly: Find: the target is partly visible rather than hidden.
    """

    letter: Letter
    visible: int
    hidden: int
    partly: bool


def plan(kind: QuestionKind, seed: int) -> Plan:
    """The plan of the episode that an attempt's seed belongs to.

    Each property runs through all its values in every block of consecutive episodes, in an order
    drawn for the block: letters balance over any suite, yet none can be foretold.
    """
    episode = seed // ATTEMPTS
    visible, hidden = _turn(_COUNTS, episode, kind, "count")
    return Plan(
        letter=_turn(LETTERS, episode, kind, "letter"),
        visible=visible,
        hidden=hidden,
        partly=_turn((False, False, True), episode, kind, "partly"),
    )


def _turn(values: Sequence[_T], episode: int, kind: str, purpose: str) -> _T:
    block, place = divmod(episode, len(values))
    order = generator(block, "plan", kind, purpose).permutation(len(values))
    return values[int(order[place])]
