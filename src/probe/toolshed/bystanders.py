"""What else a manipulation did to things that had been seen, in words. Knows no motion."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence

from probe.changes.change import Change, Changes
from probe.changes.sighting import Sighting
from probe.toolshed.outcomes import at_least, bracketed, lying, perhaps

_HIGHER_CM = 2


def bystander_words(changes: Changes, seen: Sighting, renamed: Mapping[int, str]) -> str:
    """A sentence for each way in which others have moved or gone; empty if none has.

    Args:
        changes: What became of everything.
        seen: What the manipulation was about; it isn't told of.
        renamed: New object_ids of what has moved, by the id() of the earlier sighting.
    """

    def with_id(told: str, change: Change) -> str:
        new = renamed.get(id(change.before))
        return f"{told} ({new} now)" if new else told

    others = changes.but(seen)
    alike = _of_one_name([c for c in others if c.fate == "moved" and c.before.thing.nameable])
    mixed = {id(c) for group in alike for c in group}
    moved = [c for c in others if c.fate in ("moved", "turned") and id(c) not in mixed]
    gone = [c for c in others if c.gone]
    # Whoever hasn't seen what it is can't rule out that it is one of those that show now.
    doubtful = [c for c in gone if c.doubtful or not c.before.thing.nameable]
    sure = [c for c in gone if c not in doubtful]
    in_basket = [_named(c) for c in _of(others, "basket")]
    in_basket += [bracketed(s.thing.words.called) for s in changes.back_in_basket]
    in_basket += [
        f"{bracketed(s.thing.words.called)}, not seen before" for s in changes.newly_in_basket
    ]
    sentences = [
        _sentence("Also in the basket now", in_basket),
        _sentence(
            "Shows in the basket, where it may have lain before",
            [bracketed(s.thing.words.called) for s in changes.maybe_in_basket],
        ),
        _sentence("Also moved", [with_id(_moved(c), c) for c in moved if c.before.thing.nameable]),
        _sentence("Also moved, and which is which can't be told", map(_together, alike)),
        _sentence(
            "May have moved, as only a part showed before",
            [with_id(_shown(c), c) for c in moved if not c.before.thing.nameable],
        ),
        _sentence(
            "Beside the basket, at the edge of the picture or outside it",
            map(_left, _of(others, "beside")),
        ),
        _sentence(
            "Out of sight, and something else is over that place", map(_left, _of(sure, "covered"))
        ),
        _sentence(
            "No longer to be seen on the table or in the basket", map(_left, _of(sure, "lost"))
        ),
        _sentence("Not found again", [_left(c) + perhaps(c) for c in doubtful]),
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
        return f"{_named(change)} turned or tipped, now at {place}"
    return f"{_named(change)} by {_way(change)}, to {place}{lying(change)}"


def _of_one_name(moved: Sequence[Change]) -> list[list[Change]]:
    """Groups of several things of one name; looks may have taken one for another."""
    groups: dict[str, list[Change]] = {}
    for change in moved:
        groups.setdefault(change.before.thing.words.called, []).append(change)
    return [group for group in groups.values() if len(group) > 1]


def _together(group: Sequence[Change]) -> str:
    was = [list(c.before.thing.point_px) for c in group]
    now = [list(c.after.thing.point_px) for c in group if c.after is not None]
    places = (" and ".join(map(str, some)) for some in (was, now))
    return f"{_named(group[0])} from {' to '.join(places)}"


def _shown(change: Change) -> str:
    """Of what showed in part, and shows another part of itself or elsewhere; no way can be told."""
    assert change.after is not None
    was, now = change.before.thing.point_px, change.after.thing.point_px
    return f"{_named(change)} from {list(was)} to {list(now)}"


def _way(change: Change) -> str:
    """How far along the table, and how far up or down if that is much.

    Of what has turned or tipped, another side shows, whose height tells little of the thing's.
    """
    shift = change.shift
    way = 100 * math.hypot(*shift[:2])
    down = 0 if change.turned else round(-100 * float(shift[2]))
    along = at_least(way) if change.at_least else round(way)
    about = "at least" if change.at_least and along else "about"
    told = [f"{about} {along} cm"] if along or abs(down) < _HIGHER_CM else []
    if abs(down) >= _HIGHER_CM:
        told.append(f"about {abs(down)} cm {'down' if down > 0 else 'up'} in height")
    return " and ".join(told)


def _left(change: Change) -> str:
    return f"{_named(change)} that was at {list(change.before.thing.point_px)}"


def _named(change: Change) -> str:
    """What a thing is called: by its name as soon as one of its sightings tells it."""
    before, after = change.before.thing, change.after
    if before.nameable or after is None:
        return bracketed(before.words.called)
    return after.thing.words.told_name or bracketed(before.words.description)
