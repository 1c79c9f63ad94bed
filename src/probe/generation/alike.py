"""Draws objects that could stand for one another in a question."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence

import numpy as np

from probe.assets.spec import ObjectSpec
from probe.generation.colour_words import colour_words_in
from probe.generation.result import Rejected
from probe.scene.turns import Leads, in_turn, nobody
from probe.tasks.task import DEPTH_RULES, RulesVersion

TWIN_TOLERANCE = 0.10
"""Candidates' longest sides differ by at most this share where each must do in a twin scene."""

SIDES_TOLERANCE = 0.10
"""The same of each of their sides as they stand, where height may tell what a cover rests on."""

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


def longest(spec: ObjectSpec) -> float:
    """Longest side in metres."""
    return max(spec.size)


def is_lying(spec: ObjectSpec) -> bool:
    """Whether a thing lies along its longest side."""
    return max(spec.size[:2]) == longest(spec)


def sides_alike(specs: Sequence[ObjectSpec], tolerance: float) -> bool:
    """Whether length, width and height of things, as they stand, each differ by such a share."""
    # Plain numbers: for a handful of things an array costs ten times as much, a million times.
    lengths = zip(*[(*sorted(spec.size[:2]), spec.size[2]) for spec in specs], strict=True)
    return all(max(side) <= min(side) * (1 + tolerance) for side in lengths)


def draw_alike(
    pool: Sequence[ObjectSpec],
    library: Sequence[ObjectSpec],
    tolerance: float,
    count: int,
    rng: np.random.Generator,
    *,
    one_colour: bool = False,
    sides: float | None = None,
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
        varied: Whether a set with at most MOST_OF_A_KIND of one category is looked for first.
        leads: Which are to be drawn wherever they can.

    Raises:
        Rejected: Nothing qualifies, or what was drawn first has too few like it, several times.
    """
    if not pool:
        raise Rejected("candidates", "nothing here is of the right size")
    common = Counter(spec.category for spec in library)
    enough = min(_ENOUGH_LEADING, sum(map(leads, pool)))

    def go_together(specs: Sequence[ObjectSpec]) -> bool:
        if sides is not None and not sides_alike(specs, sides):
            return False
        return _alike(specs, tolerance, common) and not (one_colour and _colours_differ(specs))

    drawn, best = list[ObjectSpec](), list[ObjectSpec]()
    limits = [MOST_OF_A_KIND] * _VARIED_TRIES if varied else []
    for most in [*limits, *[count] * _TRIES]:
        drawn = _grown(in_turn(pool, leads, rng), count, most, go_together)
        if len(drawn) == count and (not best or sum(map(leads, drawn)) > sum(map(leads, best))):
            best = drawn
        if best and sum(map(leads, best)) >= enough:
            break
    if not best:
        found = f"only {len(drawn)} of {count} alike: {', '.join(spec.name for spec in drawn)}"
        raise Rejected("candidates", found)
    return tuple(best)


def _grown(
    order: Sequence[ObjectSpec],
    count: int,
    most: int,
    go_together: Callable[[Sequence[ObjectSpec]], bool],
) -> list[ObjectSpec]:
    """The first that go together, so many at most, and at most so many of one category."""
    drawn, kinds = list[ObjectSpec](), Counter[str]()
    for spec in order:
        if len(drawn) == count:
            break
        if kinds[spec.category] < most and go_together([*drawn, spec]):
            drawn.append(spec)
            kinds[spec.category] += 1
    return drawn


def _alike(specs: Sequence[ObjectSpec], tolerance: float, common: Counter[str]) -> bool:
    sizes = [longest(spec) for spec in specs]
    counts = [common[spec.category] for spec in specs]
    return (
        max(sizes) <= min(sizes) * (1 + tolerance)
        and max(counts) <= min(counts) * FREQUENCY_RATIO
        and told_apart(specs)
    )


def _colours_differ(specs: Sequence[ObjectSpec]) -> bool:
    return len({colour_words_in(spec.name) for spec in specs}) > 1


def told_apart(specs: Sequence[ObjectSpec]) -> bool:
    """Whether no two share a name, or category and main colour."""
    looks = {(spec.category, *spec.colours[:1]) for spec in specs}
    return len({spec.name for spec in specs}) == len(looks) == len(specs)


def unlike(specs: Sequence[ObjectSpec], taken: Sequence[ObjectSpec]) -> list[ObjectSpec]:
    """Those that can be told apart by name from every one of `taken`."""
    return [spec for spec in specs if all(told_apart([spec, other]) for other in taken)]
