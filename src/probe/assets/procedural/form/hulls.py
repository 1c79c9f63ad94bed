"""Convex pieces that wrap solids: whole hulls, slices, and rings that keep cavities open."""

from __future__ import annotations

import math

import numpy as np
from scipy.spatial import ConvexHull

from probe.assets.procedural.form.curves import arc_length, at_length
from probe.assets.procedural.form.lathe import Base
from probe.types import Array

MAX_CORNERS = 60
BAND_STOPS = 26  # places along a wall at which a band may end
GOOD_ENOUGH = 2e-4  # metres by which a point may stick out of a hull


def hull(points: Array) -> Array:
    """Corners of a convex hull of points, shape (k, 3), k <= 60.

    Where the true hull has more, it starts from the outermost points along 14 directions and
    adds the point that sticks out most until none sticks out by more than 0.2 mm. What still
    sticks out then is halved by enlarging the hull about its middle.
    """
    corners = points[ConvexHull(points).vertices]
    if len(corners) <= MAX_CORNERS:
        return corners
    ways = np.array([[x, y, z] for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)])
    ways = ways[np.isin(np.abs(ways).sum(axis=1), (1, 3))]
    chosen = np.unique(np.argmax(corners @ ways.T, axis=0)).tolist()
    while True:
        planes = np.asarray(ConvexHull(corners[chosen]).equations)
        outside = (corners @ planes[:, :3].T + planes[:, 3]).max(axis=1)
        worst = int(np.argmax(outside))
        if outside[worst] < GOOD_ENOUGH or len(chosen) == MAX_CORNERS:
            break
        chosen.append(worst)
    found = corners[chosen]
    found = found[ConvexHull(found).vertices]
    middle = found.mean(axis=0)
    spokes = found - middle
    growth = max(float(outside[worst]), 0) / 2 / np.linalg.norm(spokes, axis=1, keepdims=True)
    return middle + spokes * (1 + growth)


def slices(profile: Array, base: Base, cuts: list[float]) -> list[Array]:
    """Hulls of a turned solid between heights.

    Args:
        profile: (r, z) in metres, shape (n, 2).
        base: What the profile is led around.
        cuts: Heights at which it is cut, metres, ascending; may be empty.
    """
    bounds = [-np.inf, *cuts, np.inf]
    found: list[Array] = []
    for low, high in zip(bounds[:-1], bounds[1:], strict=True):
        part = _between(profile, low, high)
        found.append(hull(base.grid(part).reshape(-1, 3)))
    return found


def _between(profile: Array, low: float, high: float) -> Array:
    """The part of a profile between two heights, with points where it crosses them."""
    rows = [profile[(profile[:, 1] >= low) & (profile[:, 1] <= high)]]
    for cut in (low, high):
        start, end = profile[:-1], profile[1:]
        crossing = (start[:, 1] - cut) * (end[:, 1] - cut) < 0
        share = (cut - start[crossing, 1]) / (end[crossing, 1] - start[crossing, 1])
        rows.append(start[crossing] + share[:, None] * (end[crossing] - start[crossing]))
    return np.vstack(rows)


def shell(
    outer: Array, inner: Array, rim: Array, base: Base, bands: int, sectors: int
) -> list[Array]:
    """Pieces of a hollow turned wall: sectors of a ring in bands, and the floor.

    Args:
        outer: Outer profile (r, z) in metres from the bottom's middle to the rim, shape (n, 2).
        inner: Inner profile, likewise, shape (m, 2). Both start on the axis if there is a floor.
        rim: Points of the profile on the outer half of the rim, shape (k, 2).
        base: What the profiles are led around.
        bands: Number of bands of the wall; they end where that fills least of the cavity.
        sectors: Number of sectors of a full turn; a straight side adds one a band.
    """
    found: list[Array] = []
    start = _floor_end(inner)
    breaks, outer_breaks = _band_ends(outer, inner, start, bands)
    if start > 0:
        rows = np.vstack([_span(outer, 0, outer_breaks[0]), _span(inner, 0, start)])
        found.append(hull(base.grid(rows).reshape(-1, 3)))
    for k in range(bands):
        outside = _span(outer, outer_breaks[k], outer_breaks[k + 1])
        inside = _span(inner, breaks[k], breaks[k + 1])
        wall = float(np.linalg.norm(outside[-1] - inside[-1]))
        if k == bands - 1:
            outside = np.vstack([outside, rim])
        found += _ring(outside, inside, wall, base, sectors)
    return found


def _band_ends(outer: Array, inner: Array, start: float, bands: int) -> tuple[Array, Array]:
    """Lengths along the inner and the outer profile at which bands end, shape (bands + 1,) each.

    The bands are those whose deepest filled hollow is least, by dynamic programming.
    """
    total = float(arc_length(inner)[-1])
    stops = np.linspace(start, total, BAND_STOPS)
    outer_stops = np.array([_nearest(outer, point) for point in at_length(inner, stops)])
    outer_stops[0] *= start > 0
    outer_stops[-1] = arc_length(outer)[-1]
    outer_stops = np.maximum.accumulate(outer_stops)
    cost = np.full((BAND_STOPS, BAND_STOPS), np.inf)
    for i in range(BAND_STOPS):
        for j in range(i + 1, BAND_STOPS):
            outside = _filled(_span(outer, outer_stops[i], outer_stops[j]))
            inside = _filled(_span(inner, stops[i], stops[j])[::-1])
            cost[i, j] = max(outside, inside)
    best, came = cost[0], [np.zeros(BAND_STOPS, dtype=int)]
    for _ in range(bands - 1):
        through = np.maximum(best[:, None], cost)
        came.append(np.argmin(through, axis=0))
        best = through.min(axis=0)
    ends = [BAND_STOPS - 1]
    for step in reversed(came):
        ends.append(int(step[ends[-1]]))
    order = ends[::-1]
    return stops[order], outer_stops[order]


def _filled(curve: Array) -> float:
    """Greatest depth of a stretch of profile, solid to its left, beneath its chord, metres."""
    chord = curve[-1] - curve[0]
    length = max(float(np.hypot(*chord)), 1e-9)
    away = curve - curve[0]
    return max(0.0, float((chord[0] * away[:, 1] - chord[1] * away[:, 0]).max()) / length)


def _floor_end(inner: Array) -> float:
    """Length along the inner profile at which the level floor ends, metres."""
    if inner[0, 0] > 1e-6:
        return 0.0
    rise = np.abs(inner[:, 1] - inner[0, 1])
    return float(arc_length(inner)[np.argmax(rise > 8e-4) - 1 if rise.max() > 8e-4 else -1])


def _nearest(profile: Array, point: Array) -> float:
    """Length along a profile at which it is nearest to a point, metres."""
    length = arc_length(profile)
    where = np.linspace(0, float(length[-1]), 400)
    return float(where[np.argmin(np.linalg.norm(at_length(profile, where) - point, axis=1))])


def _span(profile: Array, start: float, end: float) -> Array:
    """The stretch of a profile between two lengths along it."""
    length = arc_length(profile)
    inside = length[(length > start) & (length < end)]
    return at_length(profile, np.concatenate([[start], inside, [end]]))


def _ring(outside: Array, inside: Array, wall: float, base: Base, sectors: int) -> list[Array]:
    """Hulls of the sectors of one band of a wall."""
    found: list[Array] = []
    room = max(0.0, wall - 6e-4)
    for angles, side in _sectors(base, sectors):
        # A hull closes the hollow of a curved wall by the sagitta; half of it is given back.
        relief = inside[:, 0] * (1 - math.cos(np.ptp(angles) / 2)) * 0.5
        inner_radii = inside[:, 0] + np.minimum(relief, room)
        outer = [base.ring(angles, side, float(r), float(z)) for r, z in outside]
        inner = [
            base.ring(angles[[0, -1]], side[[0, -1]], float(r), float(z))
            for r, z in zip(inner_radii, inside[:, 1], strict=True)
        ]
        found.append(hull(np.vstack([*outer, *inner])))
    return found


def _sectors(base: Base, sectors: int) -> list[tuple[Array, Array]]:
    """Directions of each sector and the quarters that they belong to."""
    edges = np.linspace(0, 2 * math.pi, sectors + 1)
    steps = min(4, base.segments // sectors + 1)  # a six-sided nut is not round
    arcs: list[Array] = [
        np.linspace(low, high, steps) for low, high in zip(edges[:-1], edges[1:], strict=True)
    ]
    if base.half == (0.0, 0.0):
        return [(arc, np.zeros(steps, dtype=int)) for arc in arcs]
    curved = [(arc, np.full(steps, int(arc[1] // (math.pi / 2)))) for arc in arcs]
    straight = [
        (np.full(2, k * math.pi / 2), np.array([k - 1, k]))
        for k in range(4)
        if base.half[(k + 1) % 2] > 0
    ]
    return curved + straight
