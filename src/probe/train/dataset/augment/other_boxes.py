"""Other boxes for two things of an episode, which still hold what showed of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from probe.agents.reading import Box, Seen

_MOST = 2.5
"""How many times as wide or high a thing may become, or the reverse."""
_SMALLEST, _LARGEST = 0.04, 0.35
"""Width and height of a box, as shares of the picture's side."""
_CLEARLY = 1.2
"""By how much one diagonal and one area must be larger than the other."""
_DRAWS = 1000
"""Until sizes fit what shows."""

Factors = Mapping[str, tuple[float, float]]
"""How many times as wide and high boxes become, by names."""


def other_factors(
    names: tuple[str, str],
    seen: Sequence[Seen],
    marks: Sequence[tuple[int, int]],
    side_px: int,
    rng: np.random.Generator,
) -> Iterator[Factors]:
    """Draw other sizes again and again; those in which no box loses a mark, a point or a part.

    One of the two is always clearly larger: first one that is drawn by lot, later the other one.

    Args:
        names: Of the things.
        seen: All entries of all lists.
        marks: Pixels (u, v) of the first picture.
        side_px: Of the picture.
        rng: Chooses the sizes.
    """
    held = {it: _held(it, seen, marks) for it in seen if it.name in names}
    largest = [
        max((it for it in held if it.name == name), key=lambda it: it.area) for name in names
    ]
    first = int(rng.integers(2))
    for larger in (first, 1 - first):
        for _ in range(_DRAWS):
            drawn = np.exp(rng.uniform(-np.log(_MOST), np.log(_MOST), (2, 2))).tolist()
            factors = {name: (w, h) for name, (w, h) in zip(names, drawn, strict=True)}
            now = {it: resized_box(it.box, factors[it.name or ""], side_px) for it in held}
            if not _is_clearly_larger(now[largest[larger]], now[largest[1 - larger]]):
                continue
            if all(_loses_nothing(it.box, now[it], inner) for it, inner in held.items()):
                yield factors


def _held(one: Seen, seen: Sequence[Seen], marks: Sequence[tuple[int, int]]) -> list[Box]:
    """What a thing's box may have in it: points, and what showed of it before it had a name."""
    points = [(*it, *it) for it in (one.point, *marks)]
    parts = [it.box for it in seen if it.name is None and it.object_id == one.object_id]
    return [*points, *parts]


def _is_clearly_larger(one: Box, other: Box) -> bool:
    """Whether a box is, whichever way one looks at it."""
    (w, h), (v, g) = ((box[2] - box[0] + 1, box[3] - box[1] + 1) for box in (one, other))
    return w * w + h * h > _CLEARLY**2 * (v * v + g * g) and w * h > _CLEARLY * v * g


def resized_box(box: Box, factor: tuple[float, float], side_px: int) -> Box:
    """A box so many times as wide and high about its middle, inside the picture."""
    left, right = _around(box[0], box[2], factor[0], side_px)
    top, bottom = _around(box[1], box[3], factor[1], side_px)
    return left, top, right, bottom


def _around(low: int, high: int, factor: float, side_px: int) -> tuple[int, int]:
    """First and last pixel of a side that is so many times as long."""
    shortest, longest = _SMALLEST * side_px, _LARGEST * side_px
    length = round(min(max((high + 1 - low) * factor, shortest), longest))
    first = min(max(round((low + high + 1 - length) / 2), 0), side_px - length)
    return first, first + length - 1


def _loses_nothing(old: Box, new: Box, inner: Sequence[Box]) -> bool:
    return all(_is_in(it, new) for it in inner if _is_in(it, old))


def _is_in(inner: Box, outer: Box) -> bool:
    return all(outer[i] <= inner[i] and inner[i + 2] <= outer[i + 2] for i in (0, 1))
