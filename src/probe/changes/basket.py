"""What has come into the basket, told apart from what lay there. Knows no truth, no words."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from probe.changes.change import Change, Changes
from probe.changes.likeness import likeness
from probe.changes.matching import Located, found_among
from probe.changes.parts import may_be, may_be_piece
from probe.changes.sighting import Look, Sighting


def with_held(
    things: tuple[Change, ...],
    in_basket: tuple[Sighting, ...],
    held: Sighting | None,
    arrived: Sequence[Sighting] = (),
) -> tuple[tuple[Change, ...], tuple[Sighting, ...]]:
    """With what was held in the basket, if it must be there though its looks don't tell.

    The thing shows nowhere, and something new lies in the basket: where outlines are exact, while
    nothing else has vanished; where they are guessed, it may be in one piece with what lay there.

    Args:
        things: What became of what the table showed.
        in_basket: What is new in the basket.
        held: What the fingers felt until they let go over the basket.
        arrived: Where outlines are guessed: what isn't in the basket as it was, even if it was
            taken for something that lay there.
    """
    vanished = [change for change in things if change.gone]
    lost = next((change for change in vanished if change.before is held), None)
    pieces = in_basket or arrived
    if held is None or lost is None or not pieces or not (arrived or len(vanished) == 1):
        return things, in_basket
    it = max(pieces, key=lambda other: likeness(held, other))
    found = replace(lost, fate="basket", after=it, doubtful=False)
    things = tuple(found if change is lost else change for change in things)
    return things, tuple(s for s in in_basket if s is not it)


def with_earlier(
    before: Look,
    things: tuple[Change, ...],
    left: Sequence[Located],
    rest: Sequence[Located],
    in_basket: tuple[Sighting, ...],
) -> Changes:
    """What is new in the basket, told apart from what had been seen at an earlier time.

    Args:
        before: The first look.
        things: What became of all that it showed.
        left: What it showed and wasn't found again.
        rest: What shows now and wasn't found before.
        in_basket: Of that, what shows in the basket and wasn't held.
    """
    shown = tuple(one.sighting for one in left if one.where == "basket")
    emerged = found_among(before.buried, in_basket)
    buried = (*shown, *(one for one in before.buried if id(one) not in emerged))
    in_basket = _others(in_basket, emerged.values())
    # A part of something that lies there already is nothing new.
    in_basket = tuple(s for s in in_basket if not any(may_be(one, s) for one in buried))
    if before.guessed:
        known = (*before.in_basket, *buried, *_dropped(things))
        in_basket = tuple(s for s in in_basket if not any(may_be_piece(one, s) for one in known))
    back = found_among(before.missing, in_basket)
    in_basket = _others(in_basket, back.values())
    unclear = tuple(s for s in in_basket if buried and not s.thing.nameable)
    here = found_among(before.missing, [other.sighting for other in rest if other.where == "table"])
    return Changes(
        things,
        _others(in_basket, unclear),
        unclear,
        tuple(back.values()),
        buried,
        (
            *(c.before for c in things if c.gone),
            *(one for one in before.missing if id(one) not in back.keys() | here.keys()),
        ),
    )


def _dropped(things: Sequence[Change]) -> tuple[Sighting, ...]:
    """What has come into the basket, as it was seen on the table and as it is seen now."""
    there = [change for change in things if change.fate == "basket"]
    return tuple(s for c in there for s in (c.before, c.after) if s is not None)


def _others(some: Sequence[Sighting], but: Iterable[Sighting]) -> tuple[Sighting, ...]:
    left_out = {id(sighting) for sighting in but}
    return tuple(sighting for sighting in some if id(sighting) not in left_out)
