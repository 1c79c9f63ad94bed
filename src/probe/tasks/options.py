"""Which answers are offered, and under which letters. Knows candidates as mere texts."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.tasks.task import (
    LETTERS,
    NONE_OF_THE_ABOVE,
    SIX_RULES,
    Letter,
    Option,
    RulesVersion,
)

MOST_HIDDEN = 2
"""Instances that lie beneath something in Count, at most."""

CANDIDATES = 5
"""Alike answers that the options are drawn from."""


def drop_one(
    candidates: Sequence[str], truth: int, letter: Letter, rng: np.random.Generator
) -> tuple[Option, ...]:
    """Offer four of five candidates, so that the true one ends up under the wanted letter.

    With the letter uniform over A to E this is the same as leaving out one of the five at random
    and shuffling the rest: the true one is left out, and E right, one time in five. That the
    letter is given lets a suite balance it.

    Args:
        candidates: Five texts, any of which could be true.
        truth: Index of the true one.
        letter: Where it goes; E leaves it out.
        rng: Chooses which other is left out, and the order of the rest.
    """
    if len(set(candidates)) != CANDIDATES:
        raise ValueError(f"Five different candidates are needed, not {list(candidates)}.")
    others = [text for index, text in enumerate(candidates) if index != truth]
    texts = [others[int(index)] for index in rng.permutation(len(others))]
    if letter != "E":
        texts[LETTERS.index(letter)] = candidates[truth]
    texts.append(NONE_OF_THE_ABOVE)
    return tuple(Option(name, text) for name, text in zip(LETTERS, texts, strict=True))


def most_counted(rules: RulesVersion) -> int:
    """Highest number that is ever offered in Count."""
    return 6 if rules >= SIX_RULES else 5


def count_candidates(
    visible: int, rng: np.random.Generator, rules: RulesVersion
) -> tuple[str, ...]:
    """Five numbers in ascending order: the visible count, one and two more, and two others.

    What hides more doesn't matter to them. Since SIX_RULES both others are smaller or both larger:
    of five with one on either side the middle one would be right too often.

    Args:
        visible: How many instances are in plain view, so that two more is offered at most.
        rng: Chooses the two others.
        rules: By which the task is made.
    """
    near = [visible + hidden for hidden in range(MOST_HIDDEN + 1)]
    others = [number for number in range(most_counted(rules) + 1) if number not in near]
    if rules >= SIX_RULES:
        sides = [n for n in others if n < visible], [n for n in others if n > visible]
        enough = [side for side in sides if len(side) >= CANDIDATES - len(near)]
        others = enough[int(rng.integers(len(enough)))]
    drawn: list[int] = rng.choice(others, size=CANDIDATES - len(near), replace=False).tolist()
    return tuple(str(number) for number in sorted(near + drawn))
