"""What a report found, in a sentence or two."""

from __future__ import annotations

from collections.abc import Sequence

from probe.report.episodes import name_of
from probe.report.formats import between, percent, surest
from probe.scores.row import Entrant
from probe.scores.scorecard import Scorecard
from probe.scores.summary import Scores
from probe.texts import plural

TOO_FEW = "too few tasks to tell"
"""The verdict on two entrants of whom nobody was shown to be better."""

_NAMED = 3
"""So many entrants are named; more are counted."""

_OPEN, _CLOSE = "\N{FIRST STRONG ISOLATE}", "\N{POP DIRECTIONAL ISOLATE}"


def result_words(scores: Scores) -> str:
    """The result: who scored what, how sure that is, and who can be told apart."""
    if not scores.cards:
        return "No episode was played."
    if any(card.macro.headline.missing for card in scores.cards):
        return _incomplete(scores.cards)
    chance = f"A blind guess scores {percent(scores.cards[0].macro.chance, 0)}."
    return " ".join(filter(None, (_leaders(scores.cards), chance, _told(scores))))


def _leaders(cards: Sequence[Scorecard]) -> str:
    top = cards[0].macro
    first = [card.entrant for card in cards if card.macro.headline.value == top.headline.value]
    value = f"{percent(top.headline.value, 0)} on {plural(top.tasks, 'task')}"
    scored = f"{value} (95 % interval {between(surest(top))})"
    if len(first) < len(cards):
        return f"{names_of(first)} scored highest of {len(cards)}: {scored}."
    alike = {1: "", 2: "both "}.get(len(first), "all ")
    return f"{names_of(first)} {alike}scored {scored}."


def _incomplete(cards: Sequence[Scorecard]) -> str:
    lacking = sum(card.macro.headline.missing for card in cards)
    rows = sum(card.macro.headline.rows for card in cards)
    bounds = _bounds(cards[0]) if len(cards) == 1 else ""
    return f"Incomplete: {lacking:,} of {plural(rows, 'run')} are missing.{bounds}"


def _bounds(card: Scorecard) -> str:
    top = card.macro.headline
    ends = f"{percent(top.worst, 0)} and {percent(top.best, 0)}"
    return f" The score of {names_of([card.entrant])} lies between {ends}."


def _told(scores: Scores) -> str:
    """From whom the first can be told, and from whom not."""
    best = scores.cards[0].entrant
    mine = [pair for pair in scores.all_pairs if best in (pair.first, pair.second)]
    tied = [_other(best, pair.first, pair.second) for pair in mine if pair.tie]
    apart = [_other(best, pair.first, pair.second) for pair in mine if not pair.tie]
    few = "These are too few tasks to tell"
    if not mine:
        return ""
    if not tied:
        return "The difference from every other is more than chance."
    if not apart:
        return f"{few} {names_of([best])} from {names_of(tied)}."
    shown = f"The difference from {names_of(apart)} is more than chance."
    return f"{shown} {few} it from {names_of(tied)}."


def _other(one: Entrant, first: Entrant, second: Entrant) -> Entrant:
    return second if one == first else first


def names_of(entrants: Sequence[Entrant]) -> str:
    """Names as a list; isolated, so that a name can't turn the sentence from right to left."""
    if len(entrants) > _NAMED:
        return f"{len(entrants)} agents"
    *most, last = (f"{_OPEN}{name_of(who)}{_CLOSE}" for who in entrants)
    return f"{', '.join(most)} and {last}" if most else last
