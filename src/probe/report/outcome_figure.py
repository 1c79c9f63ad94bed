"""The outcome figure: how many episodes manipulated or not, right or wrong. Geometry only."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from probe.scores.breakdown import Outcomes
from probe.scores.row import Entrant
from probe.scores.scorecard import Scorecard

CLASSES: tuple[tuple[str, str], ...] = (
    ("used_right", "manipulated, right"),
    ("used_wrong", "manipulated, wrong"),
    ("unused_right", "not manipulated, right"),
    ("unused_wrong", "not manipulated, wrong"),
    ("missing", "missing"),
)
"""Fields of Outcomes in the order of the bar, and their words."""

WIDTH = 100.0
"""Of a whole bar, in percent."""


@dataclass(frozen=True)
class Segment:
    """A part of a bar.

    Attributes:
        name: The class of episodes, as in CLASSES.
        words: The same for people.
        count: Episodes.
        x, width: Where it lies.
    """

    name: str
    words: str
    count: int
    x: float
    width: float


@dataclass(frozen=True)
class Bar:
    """Episodes of one question type."""

    question_type: str
    episodes: int
    segments: tuple[Segment, ...]


@dataclass(frozen=True)
class Panel:
    """One entrant's bars."""

    entrant: Entrant
    bars: tuple[Bar, ...]


def panels(cards: Iterable[Scorecard]) -> list[Panel]:
    """The bars of each entrant that has an episode; lengths are shares of a type's episodes."""
    return [
        Panel(card.entrant, tuple(_bar(each) for each in card.outcomes))
        for card in cards
        if card.outcomes
    ]


def _bar(outcomes: Outcomes) -> Bar:
    counts = [int(getattr(outcomes, name)) for name, _ in CLASSES]
    total, x = sum(counts), 0.0
    segments: list[Segment] = []
    for (name, words), count in zip(CLASSES, counts, strict=True):
        width = WIDTH * count / total
        if count:
            segments.append(Segment(name, words, count, x, width))
        x += width
    return Bar(outcomes.question_type, total, tuple(segments))
