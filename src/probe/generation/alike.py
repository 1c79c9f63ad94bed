"""Draws objects that could stand for one another in a question."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Hashable, Sequence
from itertools import combinations

import numpy as np

from probe.assets.spec import ObjectSpec
from probe.generation.colour_words import colour_words_in
from probe.generation.result import Rejected
from probe.scene.turns import Leads, in_turn, nobody
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
"""The same where only one of them is ever on the table."""

FREQUENCY_RATIO = 6.0
"""Most that the sizes of candidates' categories differ by; most small scans are one of a kind."""

MOST_OF_A_KIND = 2
"""Things of one category in a set, if that can be: four balls that differ in colour say little."""

_TRIES, _VARIED_TRIES = 10, 30

_ENOUGH_LEADING = 3
"""Among things of which some lead, a set with so many of those is taken at once."""


def sides_of(rules: RulesVersion) -> float | None:
    """Share by which sides of what a cover rests on may differ; None where no rule limits it."""
    return SIDES_TOLERANCE if rules >= DEPTH_RULES else None


def level_of(rules: RulesVersion) -> float | None:
    """Metres by which heights of what a slab rests on may differ; None where no rule limits it."""
    return LEVEL if rules >= DEPTH_RULES else None


def whole_names_by(rules: RulesVersion) -> bool:
    """Whether no candidate's name may say in part what another's says."""
    return rules >= DEPTH_RULES


def longest(spec: ObjectSpec) -> float:
    """Longest side in metres."""
    return max(spec.size)


def is_lying(spec: ObjectSpec) -> bool:
    """Whether a thing lies along its longest side."""
    return max(spec.size[:2]) == longest(spec)


def sides_alike(specs: Sequence[ObjectSpec], tolerance: float) -> bool:
    """Whether length, width and height of things, as they stand, each differ by such a share."""
    lengths = zip(*map(_sides, specs), strict=True)
    return all(max(side) <= min(side) * (1 + tolerance) for side in lengths)


def are_level(specs: Sequence[ObjectSpec], tolerance: float) -> bool:
    """Whether heights of things, as they stand, differ by at most so many metres."""
    heights = [spec.size[2] for spec in specs]
    return max(heights) <= min(heights) + tolerance


def draw_alike(
    pool: Sequence[ObjectSpec],
    library: Sequence[ObjectSpec],
    tolerance: float,
    count: int,
    rng: np.random.Generator,
    *,
    one_colour: bool = False,
    sides: float | None = None,
    level: float | None = None,
    whole_names: bool = False,
    varied: bool = False,
    leads: Leads = nobody,
) -> tuple[ObjectSpec, ...]:
    """Draw objects alike in size and in how common their category is.

    They come in random order, those that lead first; of several sets that with most of them is
    taken.

    Args:
        pool: Those that qualify.
        library: All objects, to count categories.
        tolerance: Of the longest side, as a share.
        count: How many.
        rng: Draws them.
        one_colour: Whether their names are to say the same colours, or none.
        sides: Of length, width and height as they stand, as a share; None for any.
        level: Metres by which their heights may differ; None for any.
        whole_names: Whether no name may be what another's says in part.
        varied: Whether a set with at most MOST_OF_A_KIND of one category is looked for first.
        leads: Which are to be drawn wherever they can.

    Raises:
        Rejected: Nothing qualifies, or what was drawn first has too few like it, several times.
    """
    if not pool:
        raise Rejected("candidates", "nothing here is of the right size")
    common = Counter(spec.category for spec in library)
    enough = min(_ENOUGH_LEADING, sum(map(leads, pool)))
    together = _told_apart(pool, whole_names=whole_names) & _alike(pool, tolerance, sides, level)
    together &= _within([common[spec.category] for spec in pool], FREQUENCY_RATIO)
    if one_colour:
        together &= _same([colour_words_in(spec.name) for spec in pool])
    one_kind = _same([spec.category for spec in pool])
    place = {spec.id: number for number, spec in enumerate(pool)}

    drawn, best = list[ObjectSpec](), list[ObjectSpec]()
    limits = [MOST_OF_A_KIND] * _VARIED_TRIES if varied else []
    for most in [*limits, *[count] * _TRIES]:
        order = np.array([place[spec.id] for spec in in_turn(pool, leads, rng)])
        drawn = [pool[number] for number in _grown(order, count, most, together, one_kind)]
        if len(drawn) == count and (not best or sum(map(leads, drawn)) > sum(map(leads, best))):
            best = drawn
        if best and sum(map(leads, best)) >= enough:
            break
    if not best:
        found = f"only {len(drawn)} of {count} alike: {', '.join(spec.name for spec in drawn)}"
        raise Rejected("candidates", found)
    return tuple(best)


def _grown(order: Array, count: int, most: int, together: Array, one_kind: Array) -> list[int]:
    """The first that go together, so many at most, and at most so many of one category."""
    drawn = list[int]()
    while len(drawn) < count and len(order):
        drawn.append(first := int(order[0]))
        order = order[1:][together[first, order[1:]]]
        if one_kind[first, drawn].sum() == most:
            order = order[~one_kind[first, order]]
    return drawn


def _told_apart(pool: Sequence[ObjectSpec], *, whole_names: bool) -> Array:
    """Whether words tell two things apart, shape (n, n), and so any of which each two are."""
    names = [spec.name for spec in pool]
    apart = ~(_same(names) | _same([_look(spec) for spec in pool]))
    return apart & _whole_names(names) if whole_names else apart


def _alike(
    pool: Sequence[ObjectSpec], tolerance: float, sides: float | None, level: float | None
) -> Array:
    """Whether two things are of about one size, shape (n, n), and so any of which each two are."""
    together = _within([longest(spec) for spec in pool], 1 + tolerance)
    if sides is not None:
        for lengths in zip(*map(_sides, pool), strict=True):
            together &= _within(lengths, 1 + sides)
    if level is not None:
        together &= _level([spec.size[2] for spec in pool], level)
    return together


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


def _look(spec: ObjectSpec) -> tuple[str, ...]:
    return (spec.category, *spec.colours[:1])


def says_in_part(one: str, other: str) -> bool:
    """Whether a name is true of what another one names: "tea light" of a "red tea light"."""
    fewer, more = sorted((one.split(), other.split()), key=len)
    return fewer[-1] == more[-1] and set(fewer) < set(more)


def told_apart(specs: Sequence[ObjectSpec]) -> bool:
    """Whether no two share a name, or category and main colour."""
    looks = {_look(spec) for spec in specs}
    return len({spec.name for spec in specs}) == len(looks) == len(specs)


def unlike(specs: Sequence[ObjectSpec], taken: Sequence[ObjectSpec]) -> list[ObjectSpec]:
    """Those that can be told apart by name from every one of `taken`."""
    names, looks = {spec.name for spec in taken}, {_look(spec) for spec in taken}
    return [spec for spec in specs if spec.name not in names and _look(spec) not in looks]
