"""Split a mesh into parts with small convex hulls by plane cuts. Knows no cavities."""

from __future__ import annotations

import heapq
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, cast

import numpy as np

from probe.assets.collision.hulls import hull_volume, principal_axes
from probe.types import Array

Part = tuple[Array, Array]

SHARES = (1 / 2, 1 / 3, 2 / 3, 1 / 6, 5 / 6)
EQUAL = 1e-4
NARROWEST = 2e-3
EVEN_SHARE = 0.02
ENOUGH = 1e-3


@dataclass(frozen=True)
class Cut:
    """A plane n.x = t, and the hull volume that cutting there saves, in cubic metres."""

    normal: Array
    offset: float
    gain: float


def cut_parts(parts: Sequence[Part], limit: int) -> list[Array]:
    """Points of at most `limit` parts whose convex hulls together cover the surface closely.

    Best first: the part whose best cut saves most hull volume is cut next. A part with no
    gain in sight still gets a little attention by its volume, as a bowl gains nothing from its
    first cut and much from the following ones. Stops when nothing is left to gain.

    Args:
        parts: Vertices in metres, shape (n, 3), and faces, shape (m, 3), of the parts to
            begin with; need not be watertight.
        limit: Most parts.
    """
    if not parts:
        return []
    enough = ENOUGH * hull_volume(np.vstack([vertices for vertices, _ in parts]))
    queue = [_entry(part, number) for number, part in enumerate(parts)]
    heapq.heapify(queue)
    count = len(queue)
    while len(queue) < limit and -queue[0][0] > enough:
        _, _, (vertices, faces), cut = heapq.heappop(queue)
        for sign in (1.0, -1.0):
            origin = cut.normal * cut.offset
            half = half_of((vertices, faces), sign * cut.normal, origin)
            heapq.heappush(queue, _entry(half, count))
            count += 1
    return [part[0] for _, _, part, _ in sorted(queue, key=lambda entry: entry[1])]


def half_of(part: Part, normal: Array, origin: Array) -> Part:
    """What of a part lies on the side of a plane that its normal points to."""
    # Its import takes 0.3 s, and most processes find their pieces in the cache.
    from trimesh import intersections

    half = cast(Any, intersections.slice_faces_plane(*part, normal, origin))
    return np.asarray(half[0]), np.asarray(half[1])


def _entry(part: Part, number: int) -> tuple[float, int, Part, Cut]:
    """A queue's entry; the smallest comes first, so the worth is negated."""
    used, faces = np.unique(part[1], return_inverse=True)
    vertices, faces = part[0][used], faces.reshape(-1, 3)
    volume = hull_volume(vertices)
    cut = _best_cut(vertices, faces, volume)
    worth = 0.0 if cut.gain == -np.inf else cut.gain + EVEN_SHARE * volume
    return (-worth, number, (vertices, faces), cut)


def _best_cut(vertices: Array, faces: Array, volume: float) -> Cut:
    """The plane across a principal or coordinate axis that saves most hull volume.

    Among equals the one through the middle of the longest direction: it halves a ring, which
    no first cut makes smaller.
    """
    best = Cut(np.zeros(3), 0.0, -np.inf)
    if volume == 0:
        return best
    edges = np.unique(np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)
    for normal in np.vstack([principal_axes(vertices)[::-1], np.eye(3)]):
        along = vertices @ normal
        low, high = float(along.min()), float(along.max())
        if high - low < NARROWEST:
            continue
        for share in SHARES:
            offset = low + share * (high - low)
            gain = volume - _halves_volume(vertices, edges, along - offset)
            if gain > best.gain + EQUAL * volume:
                best = Cut(normal, offset, gain)
    return best


def _halves_volume(vertices: Array, edges: Array, height: Array) -> float:
    """Sum of the hull volumes on both sides of a plane, given the heights above it."""
    first, second = height[edges[:, 0]], height[edges[:, 1]]
    crossing = first * second < 0
    share = (first[crossing] / (first[crossing] - second[crossing]))[:, None]
    a, b = vertices[edges[crossing, 0]], vertices[edges[crossing, 1]]
    outline = a + share * (b - a)
    below = np.vstack([vertices[height <= 0], outline])
    return hull_volume(below) + hull_volume(np.vstack([vertices[height >= 0], outline]))
