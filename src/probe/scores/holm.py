"""Many tests at once: corrected p, and who can't be told apart."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Sequence
from typing import TypeVar

Name = TypeVar("Name", bound=Hashable)


def holm(chances: Sequence[float]) -> list[float]:
    """Adjusted p of each test of a family (Holm, Scand. J. Statist. 6(2), 1979).

    The family errs anywhere with at most the level at which the adjusted p are judged, however
    the tests depend on each other.
    """
    adjusted = [0.0] * len(chances)
    highest = 0.0
    for rank, place in enumerate(sorted(range(len(chances)), key=lambda i: chances[i])):
        highest = max(highest, min(1.0, chances[place] * (len(chances) - rank)))
        adjusted[place] = highest
    return adjusted


def ties(names: Sequence[Name], rejected: Iterable[tuple[Name, Name]]) -> list[tuple[Name, ...]]:
    """Largest groups of whom no two were shown to differ, in the order of the names.

    A name may be in several groups, since "not shown to differ" doesn't pass on. Insert and absorb
    (Piepho, J. Comput. Graph. Statist. 13(2), 2004).

    Args:
        names: All who were compared, best first.
        rejected: Pairs that were shown to differ.
    """
    groups = [frozenset(names)]
    for one, other in rejected:
        split = [g for g in groups if {one, other} <= g]
        kept = [g for g in groups if g not in split]
        parts = [part for g in split for part in (g - {one}, g - {other})]
        groups = list(dict.fromkeys([*kept, *parts]))
        groups = [g for g in groups if not any(g < other for other in groups)]
    ordered = [tuple(name for name in names if name in group) for group in groups]
    return sorted(ordered, key=lambda group: [names.index(name) for name in group])
