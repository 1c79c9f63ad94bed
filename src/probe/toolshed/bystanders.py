"""What else a manipulation did to things that had been seen, in words. Knows no motion."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from probe.changes.compare import Change, Changes
from probe.changes.sighting import Sighting


def bystander_words(changes: Changes, seen: Sighting) -> str:
    """A sentence for each way in which others have moved or gone; empty if none has.

    Args:
        changes: What became of everything.
        seen: What the manipulation was about; it isn't told of.
    """
    others = changes.but(seen)
    gone = [c for c in others if c.fate in ("lost", "covered")]
    # Whoever hasn't seen what it is can't rule out that it is one of those that show now.
    doubtful = [c for c in gone if c.doubtful or not c.before.thing.nameable]
    sure = [c for c in gone if c not in doubtful]
    in_basket = [_named(c) for c in _of(others, "basket")]
    in_basket += [f"{s.thing.words.called}, not seen before" for s in changes.newly_in_basket]
    sentences = [
        _sentence("Also in the basket now", in_basket),
        _sentence("Also moved", [_moved(c) for c in others if c.fate in ("moved", "turned")]),
        _sentence("Out of the picture, beside the basket", map(_left, _of(others, "beside"))),
        _sentence("Covered now", map(_left, _of(sure, "covered"))),
        _sentence(
            "No longer to be seen on the table or in the basket", map(_left, _of(sure, "lost"))
        ),
        _sentence("Not found again", map(_left, doubtful)),
    ]
    return " ".join(sentence for sentence in sentences if sentence)


def _of(changes: Sequence[Change], fate: str) -> list[Change]:
    return [change for change in changes if change.fate == fate]


def _sentence(beginning: str, whom: Iterable[str]) -> str:
    told = "; ".join(whom)
    return f"{beginning}: {told}." if told else ""


def _moved(change: Change) -> str:
    assert change.after is not None
    place = list(change.after.thing.point_px)
    if change.fate == "turned":
        return f"{_named(change)} turned or tipped, to {place}"
    distance = round(100 * float(np.linalg.norm(change.shift)))
    return f"{_named(change)} by about {distance} cm, to {place}"


def _left(change: Change) -> str:
    return f"{_named(change)} that was at {list(change.before.thing.point_px)}"


def _named(change: Change) -> str:
    """What a thing is called: by its name as soon as one of its sightings tells it."""
    before, after = change.before.thing, change.after
    if before.nameable or after is None:
        return before.words.called
    return after.thing.words.name or before.words.description
