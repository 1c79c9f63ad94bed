"""Patches joined pair by pair, the likeliest first, until no pair seems to be one thing."""

from __future__ import annotations

import heapq
from collections.abc import Callable

import numpy as np

from probe.perception.patches import Patches
from probe.types import Array

Sameness = Callable[[Array, Array, Array], Array]
"""Probability of being one thing, from counts of borders and of the patches on either side."""

OUTLINE = 7
"""Which count of a patch is its outline."""


class Merging:
    """The patches that are left, by number; a joined one gets the next number."""

    def __init__(self, start: Patches, sameness: Sameness) -> None:
        self.inside = {n: row for n, row in enumerate(start.inside) if n > 0}
        self.borders: dict[int, dict[int, Array]] = {n: {} for n in self.inside}
        self.parts: dict[int, tuple[int, int]] = {}
        for (one, other), counts in zip(start.pairs.tolist(), start.borders, strict=True):
            self.borders[one][other] = self.borders[other][one] = counts
        self._sameness = sameness
        self._heap: list[tuple[float, int, int]] = []
        self._push([(a, b) for a, others in self.borders.items() for b in others if a < b])

    def likeliest(self, at_least: float) -> tuple[int, int] | None:
        """The pair that is most probably one thing; None if none reaches that probability."""
        while self._heap and -self._heap[0][0] >= at_least:
            _, one, other = heapq.heappop(self._heap)
            if one in self.inside and other in self.inside:
                return one, other
        return None

    def join(self, one: int, other: int) -> int:
        """Make one patch of two that meet, and say its number."""
        number = max(self.inside) + 1
        both = self.inside.pop(one) + self.inside.pop(other)
        beside, more = self.borders.pop(one), self.borders.pop(other)
        both[OUTLINE] -= 2 * beside.pop(other)[0]
        del more[one]
        for neighbour, counts in more.items():
            beside[neighbour] = beside[neighbour] + counts if neighbour in beside else counts
        for neighbour, counts in beside.items():
            self.borders[neighbour].pop(one, None)
            self.borders[neighbour].pop(other, None)
            self.borders[neighbour][number] = counts
        self.inside[number], self.borders[number] = both, beside
        self.parts[number] = (one, other)
        self._push([(neighbour, number) for neighbour in beside])
        return number

    def counts(self, pairs: list[tuple[int, int]]) -> tuple[Array, Array, Array]:
        """Counts of the borders of pairs, and of their first and second patches."""
        return (
            np.array([self.borders[a][b] for a, b in pairs]),
            np.array([self.inside[a] for a, _ in pairs]),
            np.array([self.inside[b] for _, b in pairs]),
        )

    def _push(self, pairs: list[tuple[int, int]]) -> None:
        if not pairs:
            return
        chances = self._sameness(*self.counts(pairs)).tolist()
        for chance, (one, other) in zip(chances, pairs, strict=True):
            heapq.heappush(self._heap, (-chance, one, other))


def merged(start: Patches, sameness: Sameness, at_least: float) -> Array:
    """Number of the joined patch of each cell, 0 for the table, shape (h, w)."""
    merging = Merging(start, sameness)
    while pair := merging.likeliest(at_least):
        merging.join(*pair)
    owner = np.arange(max(merging.inside, default=0) + 1)
    for number in sorted(merging.parts, reverse=True):
        owner[list(merging.parts[number])] = owner[number]
    return owner[start.numbers]
