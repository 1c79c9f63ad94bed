"""What it takes for objects to stand for one another: alike in size, and told apart by words."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from probe.assets.spec import ObjectSpec
from probe.perception.colour_words import colour_words_in
from probe.tasks.task import DEPTH_RULES, RulesVersion
from probe.types import Array

TWIN_TOLERANCE = 0.10
"""Candidates' longest sides differ by at most this share where each must do in a twin scene."""

SIDES_TOLERANCE = 0.10
"""The same of each of their sides as they stand, where height may tell what a cover rests on."""

LEVEL = 0.001
"""Metres by which candidates' heights differ where a slab rests on them: by more, the gap below it,
measured exactly, told which it is in 36 of 110 scenes with five candidates."""

LOOSE_TOLERANCE = 0.25
"""Candidates' longest sides differ by at most this share where one alone is ever on the table."""

FREQUENCY_RATIO = 6.0
"""Most that the sizes of candidates' categories differ by; most small scans are one of a kind."""


def sides_of(rules: RulesVersion) -> float | None:
    """Share by which sides of what a cover rests on may differ; None where no rule limits it."""
    return SIDES_TOLERANCE if rules >= DEPTH_RULES else None


def level_of(rules: RulesVersion) -> float | None:
    """Metres by which heights of what a slab rests on may differ; None where no rule limits it."""
    return LEVEL if rules >= DEPTH_RULES else None


def whole_names_by(rules: RulesVersion) -> bool:
    """Whether no candidate's name may say in part what another's says."""
    return rules >= DEPTH_RULES


@dataclass(frozen=True)
class Likeness:
    """How alike the candidates of a question are.

    Attributes:
        length: Share by which their longest sides may differ.
        sides: The same of length, width and height as they stand; None for any.
        level: Metres by which their heights may differ; None for any.
        one_colour: Whether their names say the same colours, or none.
        whole_names: Whether no name says in part what another says.
    """

    length: float
    sides: float | None = None
    level: float | None = None
    one_colour: bool = False
    whole_names: bool = False

    def pairs(self, pool: Sequence[ObjectSpec], library: Sequence[ObjectSpec]) -> Array:
        """Which two of some things could stand for one another, shape (n, n).

        Args:
            pool: The n things.
            library: All objects: the categories of two are about equally common among them.
        """
        names = [spec.name for spec in pool]
        together = ~(_same(names) | _same([look(spec) for spec in pool]))
        together &= _within([longest(spec) for spec in pool], 1 + self.length)
        common = Counter(spec.category for spec in library)
        together &= _within([common[spec.category] for spec in pool], FREQUENCY_RATIO)
        if self.whole_names:
            together &= _whole_names(names)
        if self.sides is not None:
            for lengths in zip(*map(_sides, pool), strict=True):
                together &= _within(lengths, 1 + self.sides)
        if self.level is not None:
            together &= _level([spec.size[2] for spec in pool], self.level)
        if self.one_colour:
            together &= _same([colour_words_in(name) for name in names])
        return together


def longest(spec: ObjectSpec) -> float:
    """Longest side in metres."""
    return max(spec.size)


def sides_alike(specs: Sequence[ObjectSpec], tolerance: float) -> bool:
    """Whether length, width and height of things, as they stand, each differ by such a share."""
    lengths = zip(*map(_sides, specs), strict=True)
    return all(max(side) <= min(side) * (1 + tolerance) for side in lengths)


def are_level(specs: Sequence[ObjectSpec], tolerance: float) -> bool:
    """Whether heights of things, as they stand, differ by at most so many metres."""
    heights = [spec.size[2] for spec in specs]
    return max(heights) <= min(heights) + tolerance


def says_in_part(one: str, other: str) -> bool:
    """Whether a name is true of what another one names: "tea light" of a "red tea light"."""
    fewer, more = sorted((one.split(), other.split()), key=len)
    return fewer[-1] == more[-1] and set(fewer) < set(more)


def look(spec: ObjectSpec) -> tuple[str, ...]:
    """What is said of a thing beside its name: category and main colour."""
    return (spec.category, *spec.colours[:1])


def told_apart(specs: Sequence[ObjectSpec]) -> bool:
    """Whether no two share a name, or category and main colour."""
    looks = {look(spec) for spec in specs}
    return len({spec.name for spec in specs}) == len(looks) == len(specs)


def same_category(pool: Sequence[ObjectSpec]) -> Array:
    """Which two of n things are of one category, shape (n, n)."""
    return _same([spec.category for spec in pool])


def _within(values: Sequence[float], ratio: float) -> Array:
    below = np.array(values)[:, None] <= np.array(values)[None, :] * ratio
    return below & below.T


def _level(heights: Sequence[float], tolerance: float) -> Array:
    low, high = np.array(heights)[:, None], np.array(heights)[None, :]
    return np.abs(low - high) <= tolerance


def _whole_names(names: Sequence[str]) -> Array:
    whole = np.ones((len(names), len(names)), bool)
    kinds = defaultdict[str, list[int]](list)
    for number, name in enumerate(names):
        kinds[name.split()[-1]].append(number)
    for alike in kinds.values():
        for one, other in combinations(alike, 2):
            told = says_in_part(names[one], names[other])
            whole[one, other] = whole[other, one] = not told
    return whole


def _same(labels: Sequence[Hashable]) -> Array:
    codes = {label: code for code, label in enumerate(dict.fromkeys(labels))}
    numbers = np.array([codes[label] for label in labels])
    return numbers[:, None] == numbers[None, :]


def _sides(spec: ObjectSpec) -> tuple[float, ...]:
    """Width, length and height as it stands, in metres."""
    return (*sorted(spec.size[:2]), spec.size[2])
