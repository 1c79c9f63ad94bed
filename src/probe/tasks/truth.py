"""What is true of a starting scene. Pure functions of it: nothing that happens later matters."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

import numpy as np

from probe.assets.colour.difference import ciede2000
from probe.scene.scene import PlacedObject, Scene
from probe.tasks.task import Letter
from probe.tasks.type_rules import Form
from probe.types import Array

COVERED_SHARE = 0.7
"""Share of an object's silhouette that lies within the silhouette of what it is under."""

ON_SHARE = 0.5
"""Share of an object's silhouette that lies within the silhouette of what it lies on."""

LONGER = 1.25
"""Ratio of longest sides from which on one thing is longer than another."""

LARGER = 2.0
"""Ratio of hull volumes from which on one thing is larger, if it is in no way smaller."""

DIFFERENT, DARKER = 15.0, 15.0
"""CIEDE2000 difference, and difference of L*, from which on two main colours are told apart."""

ALIKE = 12.0
"""CIEDE2000 difference up to which a main colour counts as that of something else."""


@dataclass(frozen=True)
class Extent:
    """How large an object is: longest side (m), footprint (m2), volume of its hull (m3)."""

    longest: float
    footprint: float
    volume: float


@dataclass(frozen=True, eq=False)
class Silhouette:
    """An object of the starting scene as if it stood there alone.

    Attributes:
        mask: Where it shows in the top-down picture, bool, shape (h, w).
        top: Height of its highest point in metres.
    """

    mask: Array
    top: float


def how_many(scene: Scene, object_id: str) -> int:
    """Count: instances of an object on the table."""
    return sum(placed.object_id == object_id for placed in scene.objects)


def which_on_table(scene: Scene, candidates: Collection[str]) -> PlacedObject:
    """Find: the one candidate, by object id, that is on the table.

    Raises:
        ValueError: Not exactly one is; the question would be ambiguous.
    """
    return _only([placed for placed in scene.objects if placed.object_id in candidates])


def which_beneath(
    scene: Scene, candidates: Collection[str], cover: int, silhouettes: Mapping[int, Silhouette]
) -> PlacedObject:
    """Beneath: the one candidate, by object id, that lies under the cover.

    Args:
        scene: The table at the start.
        candidates: Object ids.
        cover: Instance of the cover.
        silhouettes: Of the cover and of the candidates that are on the table, by instance.

    Raises:
        ValueError: Not exactly one does; the question would be ambiguous.
    """
    known = [placed for placed in scene.objects if placed.object_id in candidates]
    roof = silhouettes[cover]
    return _only([placed for placed in known if lies_under(silhouettes[placed.instance], roof)])


def lies_under(item: Silhouette, cover: Silhouette) -> bool:
    """Whether most of an object's silhouette is within the cover's and its top is lower."""
    return covered_share(item, cover) >= COVERED_SHARE and item.top < cover.top


def lies_on(item: Silhouette, cover: Silhouette) -> bool:
    """Whether half or more of an object's silhouette is within the cover's, and its top higher."""
    return covered_share(item, cover) >= ON_SHARE and item.top > cover.top


def on_top(cover: int, silhouettes: Mapping[int, Silhouette]) -> tuple[int, ...]:
    """Instances that lie on a cover."""
    roof = silhouettes[cover]
    return tuple(it for it, shape in silhouettes.items() if it != cover and lies_on(shape, roof))


def beneath_each(
    covers: Collection[int], silhouettes: Mapping[int, Silhouette]
) -> dict[int, tuple[int, ...]]:
    """What lies under each of some covers: instances by that of the cover.

    Args:
        covers: Instances; none of them counts as lying under another one.
        silhouettes: Of the covers and of all that may lie under one, by instance.
    """
    items = [number for number in silhouettes if number not in covers]
    return {
        cover: tuple(it for it in items if lies_under(silhouettes[it], silhouettes[cover]))
        for cover in covers
    }


def covered_share(item: Silhouette, cover: Silhouette) -> float:
    """Share of an object's silhouette within the cover's, 0 to 1."""
    whole = np.count_nonzero(item.mask)
    return float(np.count_nonzero(item.mask & cover.mask) / whole) if whole else 0.0


def which_size(form: Form, a: Extent, b: Extent) -> Letter:
    """Size: A or B.

    Raises:
        ValueError: They are too alike, or it depends on how one measures.
    """
    if form == "longer":
        ratio, agree = a.longest / b.longest, True
        needed = LONGER
    else:
        ratio, needed = a.volume / b.volume, LARGER
        agree = (a.longest > b.longest) == (a.footprint > b.footprint) == (ratio > 1)
    if not agree or max(ratio, 1 / ratio) < needed:
        raise ValueError(f"Neither of the two is clearly {form}.")
    return "A" if (ratio > 1) != (form == "smaller") else "B"


def which_darker(a: Array, b: Array) -> Letter:
    """Compare: which of two main colours, CIELAB, shape (3,), is darker.

    Raises:
        ValueError: They are too alike.
    """
    if abs(float(a[0] - b[0])) < DARKER or float(ciede2000(a, b)) < DIFFERENT:
        raise ValueError("Neither of the two is clearly darker.")
    return "A" if a[0] < b[0] else "B"


def which_like(a: Array, b: Array, wanted: Array) -> Letter:
    """Compare: which of two main colours, CIELAB, shape (3,), is like a third.

    Raises:
        ValueError: They are too alike, or none is like it, or both are.
    """
    first, second = float(ciede2000(a, wanted)), float(ciede2000(b, wanted))
    if float(ciede2000(a, b)) < DIFFERENT or max(first, second) < DIFFERENT:
        raise ValueError("The two are too alike.")
    if min(first, second) > ALIKE:
        raise ValueError("None of the two is like it.")
    return "A" if first < second else "B"


def which_fits(form: Form, a: Array, b: Array, wanted: Array) -> Letter:
    """Compare: which of two main colours is what a form asks for; only "darker" has no third.

    Raises:
        ValueError: Neither is, clearly.
    """
    return which_darker(a, b) if form == "darker" else which_like(a, b, wanted)


def _only(found: list[PlacedObject]) -> PlacedObject:
    if len(found) != 1:
        raise ValueError(f"Exactly one candidate should answer the question, not {len(found)}.")
    return found[0]
