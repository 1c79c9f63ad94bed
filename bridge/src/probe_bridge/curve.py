"""A smooth curve through joint angles that never overshoots them."""

from __future__ import annotations

from typing import List, NamedTuple, Sequence, Tuple

Row = Tuple[float, ...]


class Sample(NamedTuple):
    """The curve at one place along it.

    Attributes:
        along: Distance along the curve, in the joint that moves most, radians.
        joints: Radians.
        slope: Change of the joints per radian along.
        bend: Largest second change per radian squared, on either side of this place.
    """

    along: float
    joints: Row
    slope: Row
    bend: Row


def sampled(path: Sequence[Row], step: float) -> List[Sample]:
    """Points along a monotone cubic through waypoints, each waypoint among them.

    It is the cubic of Fritsch and Butland (SIAM J. Sci. Stat. Comput. 5(2), 1984): between two
    waypoints each joint stays between their angles.

    Args:
        path: At least two waypoints; no two neighbours are alike.
        step: Largest distance between samples, radians of the joint that moves most.
    """
    lengths = [max(abs(b - a) for a, b in zip(p, q)) for p, q in zip(path, path[1:])]
    slopes = _slopes(path, lengths)
    samples: List[Sample] = []
    start = 0.0
    for number, length in enumerate(lengths):
        count = max(2, int(length / step) + 1)
        ends = (path[number], path[number + 1], slopes[number], slopes[number + 1])
        piece = [_at(start, length, i / count, ends) for i in range(count + 1)]
        if samples:
            last, first = samples.pop(), piece[0]
            bend = tuple(max(a, b) for a, b in zip(last.bend, first.bend))
            piece[0] = first._replace(bend=bend)
        samples.extend(piece)
        start += length
    return samples


def _slopes(path: Sequence[Row], lengths: Sequence[float]) -> List[Row]:
    """Slope of each joint at each waypoint; zero where a joint turns back."""
    chords = [
        tuple((b - a) / length for a, b in zip(p, q))
        for p, q, length in zip(path, path[1:], lengths)
    ]
    inner = [
        tuple(_mean(a, b, before, after) for a, b in zip(one, two))
        for one, two, before, after in zip(chords, chords[1:], lengths, lengths[1:])
    ]
    return [chords[0], *inner, chords[-1]]


def _mean(one: float, two: float, before: float, after: float) -> float:
    """Weighted harmonic mean of two chords' slopes."""
    if one * two <= 0.0:
        return 0.0
    first, second = 2 * after + before, after + 2 * before
    return (first + second) / (first / one + second / two)


def _at(start: float, length: float, share: float, ends: Tuple[Row, Row, Row, Row]) -> Sample:
    """A Hermite piece at a share of its length, 0 to 1."""
    t, h = share, length
    values, slopes, bends = [], [], []
    for a, b, m, n in zip(*ends):
        d = (b - a) / h
        # In powers of the distance u = t h: a + m u + c u^2 + e u^3.
        c = (3 * d - 2 * m - n) / h
        e = (m + n - 2 * d) / (h * h)
        u = t * h
        values.append(b if t == 1.0 else a + u * (m + u * (c + u * e)))
        slopes.append(m + u * (2 * c + u * 3 * e))
        bends.append(abs(2 * c + 6 * e * u))
    return Sample(start + t * h, tuple(values), tuple(slopes), tuple(bends))
