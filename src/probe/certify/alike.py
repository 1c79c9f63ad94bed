"""Draws objects that could stand for one another in a question."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

import numpy as np

from probe.assets.spec import ObjectSpec
from probe.certify.colour_words import colour_words_in
from probe.certify.result import Rejected

TWIN_TOLERANCE = 0.10
"""Candidates' longest sides differ by at most this share where each must do in a twin scene."""

LOOSE_TOLERANCE = 0.25
"""The same where only one of them is ever on the table."""

FREQUENCY_RATIO = 6.0
"""Most that the sizes of candidates' categories differ by; most small scans are one of a kind."""

_TRIES = 10


def longest(spec: ObjectSpec) -> float:
    """Longest side in metres."""
    return max(spec.size)


def draw_alike(
    pool: Sequence[ObjectSpec],
    library: Sequence[ObjectSpec],
    tolerance: float,
    count: int,
    rng: np.random.Generator,
    *,
    one_colour: bool = False,
) -> tuple[ObjectSpec, ...]:
    """Draw objects alike in size and in how common their category is, in random order.

    Args:
        pool: Those that qualify.
        library: All objects, to count categories.
        tolerance: Of the longest side, as a share.
        count: How many.
        rng: Draws them.
        one_colour: Whether their names are to say the same colours, or none.

    Raises:
        Rejected: What was drawn first has too few like it, several times over.
    """
    common = Counter(spec.category for spec in library)
    drawn: list[ObjectSpec] = []
    for _ in range(_TRIES):
        drawn = []
        for index in rng.permutation(len(pool)):
            more = [*drawn, pool[int(index)]]
            if _alike(more, tolerance, common) and not (one_colour and _colours_differ(more)):
                drawn = more
            if len(drawn) == count:
                return tuple(drawn)
    raise Rejected("candidates", f"only {len(drawn)} like {drawn[0].name if drawn else 'nothing'}")


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
