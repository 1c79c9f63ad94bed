"""A list as the tools would give it of the mirrored picture.

Two things can't be read from a list, and are taken as they are mirrored. Where several pixels lie
equally deep inside a thing, its point is the first of them in reading order. And the columns of a
picture can't be shared out evenly among its ninths.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from probe.train.dataset.augment.listing import Box, ListedThing, Listing, Place, Relation

_SIDES = {"left_of": "right_of", "right_of": "left_of", "above": "above", "below": "below"}
_REGIONS = [
    f"{row} {side}" for row in ("top", "middle", "bottom") for side in ("left", "centre", "right")
]
_MIRRORED_REGION = {
    region: region.replace("left", "x").replace("right", "left").replace("x", "right")
    for region in _REGIONS
}  # fmt: skip


def mirrored_place(place: Place, side_px: int) -> Place:
    """A pixel (u, v) in the mirrored picture, which is so wide."""
    return side_px - 1 - place[0], place[1]


def mirrored_box(box: Box, side_px: int) -> Box:
    """A box in the mirrored picture, which is so wide."""
    left, top, right, bottom = box
    return side_px - 1 - right, top, side_px - 1 - left, bottom


def mirrored_list(listing: Listing, side_px: int) -> Listing:
    """A list of the mirrored picture; its things keep their object_ids, but not their order.

    Args:
        listing: The list.
        side_px: Width of its picture.
    """
    things = [_mirrored_thing(it, side_px) for it in listing.things]
    # From top to bottom, then left to right, as detectors sort.
    order = sorted(range(len(things)), key=lambda index: things[index].point[::-1])
    place = {old: new for new, old in enumerate(order)}
    return replace(
        listing,
        things=tuple(things[old] for old in order),
        relations=tuple(_mirrored_relations(listing.relations, place)),
        cluttered=_mirrored_regions(listing.cluttered),
        clear=_mirrored_regions(listing.clear),
    )


def level(things: Sequence[ListedThing]) -> list[tuple[ListedThing, ListedThing]]:
    """Neighbours in a list whose points are equally high: mirrored, they change places."""
    return [
        (one, other)
        for index, one in enumerate(things)
        for other in things[index + 1 :]
        if one.point[1] == other.point[1]
    ]


def _mirrored_thing(it: ListedThing, side_px: int) -> ListedThing:
    return replace(it, point=mirrored_place(it.point, side_px), box=mirrored_box(it.box, side_px))


def _mirrored_relations(relations: Sequence[Relation], place: Mapping[int, int]) -> list[Relation]:
    """Relations by the things' new places: first where they are, then how they meet."""
    sides = [
        _ordered(place[a], _SIDES[kind], place[b]) for a, kind, b in relations if kind in _SIDES
    ]
    contacts = [(place[a], kind, place[b]) for a, kind, b in relations if kind not in _SIDES]
    contacts = [
        (min(a, b), kind, max(a, b)) if kind == "touching" else (a, kind, b)
        for a, kind, b in contacts
    ]
    return [*sorted(sides, key=_pair), *sorted(contacts, key=_pair)]


def _ordered(a: int, kind: str, b: int) -> Relation:
    """The same, told of the first of both."""
    return (a, kind, b) if a < b else (b, _OPPOSITE[kind], a)


_OPPOSITE = {"left_of": "right_of", "right_of": "left_of", "above": "below", "below": "above"}


def _pair(relation: Relation) -> tuple[int, int]:
    a, _, b = relation
    return min(a, b), max(a, b)


def _mirrored_regions(regions: Sequence[str]) -> tuple[str, ...]:
    return tuple(sorted((_MIRRORED_REGION[it] for it in regions), key=_REGIONS.index))
