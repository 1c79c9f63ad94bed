"""What else a manipulation did to things that had been seen, in words. Knows no motion."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.changes.compare import Change


def bystander_words(changes: Sequence[Change]) -> str:
    """A sentence for each way in which others have moved or gone; empty if none has."""
    lost = _of(changes, "lost")
    sentences = [
        _sentence("Also in the basket now", [_named(c) for c in _of(changes, "basket")]),
        _sentence("Also moved", [_moved(c) for c in _of(changes, "moved")]),
        _sentence("Covered now", [_left(c) for c in _of(changes, "covered")]),
        _sentence(
            "No longer to be seen on the table or in the basket",
            [_left(c) for c in lost if c.before.thing.nameable],
        ),
        # Whoever hasn't seen what it is can't rule out that it is one of those that show now.
        _sentence("Not found again", [_left(c) for c in lost if not c.before.thing.nameable]),
    ]
    return " ".join(sentence for sentence in sentences if sentence)


def _of(changes: Sequence[Change], fate: str) -> list[Change]:
    return [change for change in changes if change.fate == fate]


def _sentence(beginning: str, whom: Sequence[str]) -> str:
    return f"{beginning}: {'; '.join(whom)}." if whom else ""


def _moved(change: Change) -> str:
    assert change.after is not None
    distance = round(100 * float(np.linalg.norm(change.shift)))
    place = list(change.after.thing.point_px)
    return f"{_named(change)} by about {distance} cm, to {place}"


def _left(change: Change) -> str:
    return f"{_named(change)} that was at {list(change.before.thing.point_px)}"


def _named(change: Change) -> str:
    """What a thing is called: by its name as soon as one of its sightings tells it."""
    before, after = change.before.thing, change.after
    if before.nameable or after is None:
        return before.words.called
    return after.thing.words.name or before.words.description
