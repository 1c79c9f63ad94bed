"""Which things are next to, on or over each other: from their masks and the depth alone."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from probe.perception.scene_graph import Contact, Relation, Side
from probe.perception.things import Thing
from probe.types import Array, Frame

NEAR_PX = 60
"""Boxes no further apart than this are neighbours."""

EDGE_PX = 15
"""Pixels of common outline from which on two things meet."""

STEP = 0.010
"""Metres of height between two sides of an outline that count as a step."""

ON_SHARE = 0.5
"""Share of its outline that a thing has in common with another one it is on."""

_REACH_PX = 3


@dataclass
class _Edge:
    """What two neighbouring patches have in common: pixels, and how much the first is higher."""

    pixels: int
    step: float


def relations(things: Sequence[Thing], frame: Frame) -> list[Relation]:
    """Relations between neighbours: where they are in the picture, then how they meet.

    A thing stands higher than another one where their common outline has a step; it is "on" the
    other if half of its outline is such an edge, else "covering" it; without a step they touch.
    """
    sides = [
        Relation(i, _side(first, second), j)
        for i, first in enumerate(things)
        for j, second in enumerate(things[i + 1 :], start=i + 1)
        if _gap(first, second) <= NEAR_PX
    ]
    return sides + _contacts(things, frame)


def _gap(first: Thing, second: Thing) -> int:
    a, b = first.box_px, second.box_px
    across = max(a[0] - b[2], b[0] - a[2], 0)
    down = max(a[1] - b[3], b[1] - a[3], 0)
    return max(across, down)


def _side(first: Thing, second: Thing) -> Side:
    du = second.point_px[0] - first.point_px[0]
    dv = second.point_px[1] - first.point_px[1]
    if abs(du) >= abs(dv):
        return "left_of" if du > 0 else "right_of"
    return "above" if dv > 0 else "below"


def _contacts(things: Sequence[Thing], frame: Frame) -> list[Relation]:
    number = np.zeros(frame.depth.shape, dtype=np.int32)
    for index, thing in enumerate(things, start=1):
        number[thing.mask] = index
    edges = _edges(number, frame)
    found: list[Relation] = []
    for (a, b), edge in sorted(edges.items()):
        if a == 0 or b == 0 or a > b or edge.pixels < EDGE_PX:
            continue
        if abs(edge.step) < STEP:
            found.append(Relation(a - 1, "touching", b - 1))
            continue
        upper, lower = (a, b) if edge.step > 0 else (b, a)
        outline = sum(e.pixels for (one, _), e in edges.items() if one == upper)
        kind: Contact = "on" if edge.pixels >= ON_SHARE * outline else "covering"
        found.append(Relation(upper - 1, kind, lower - 1))
    return found


def _edges(number: Array, frame: Frame) -> dict[tuple[int, int], _Edge]:
    """Common outlines by pair, in both orders; 0 is the table."""
    steps: defaultdict[tuple[int, int], list[Array]] = defaultdict(list)
    for down, across in ((_REACH_PX, 0), (0, _REACH_PX)):
        h, w = number.shape
        here, there = number[: h - down, : w - across], number[down:, across:]
        rows, columns = np.nonzero(here != there)
        rise = _heights(frame, rows, columns) - _heights(frame, rows + down, columns + across)
        for one, other, chosen in _by_pair(here[rows, columns], there[rows, columns], rise):
            steps[one, other].append(chosen)
            steps[other, one].append(-chosen)
    return {
        # Looking a few pixels on meets each crossing as many times.
        pair: _Edge(sum(map(len, parts)) // _REACH_PX, float(np.median(np.concatenate(parts))))
        for pair, parts in steps.items()
    }


def _by_pair(ones: Array, others: Array, values: Array) -> Iterator[tuple[int, int, Array]]:
    """Values by their pair of numbers; all of shape (n,)."""
    order = np.lexsort((others, ones))
    ones, others, values = ones[order], others[order], values[order]
    changes = np.flatnonzero((np.diff(ones) != 0) | (np.diff(others) != 0)) + 1
    for part in np.split(np.arange(len(order)), changes):
        if len(part):
            yield int(ones[part[0]]), int(others[part[0]]), values[part]


def _heights(frame: Frame, rows: Array, columns: Array) -> Array:
    """Heights of pixels above the table, metres, shape (n,)."""
    centres = np.column_stack([columns, rows]) + 0.5
    return frame.camera.lift(centres, frame.depth[rows, columns])[:, 2]
