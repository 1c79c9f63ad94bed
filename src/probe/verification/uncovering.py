"""Does one thing come to light once others are gone, and nothing else?"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from probe.generation.visibility_rules import LARGEST_GAIN, REVEALED_SHARE
from probe.scene.visibility import Visibility
from probe.verification.remeasure import Remeasurement


def uncovering_problems(
    when: str, after: Mapping[int, Visibility], item: int, anew: Remeasurement, what: str = "it"
) -> Iterator[str]:
    """What is wrong with what shows after a removal.

    Args:
        when: What was removed, as a message begins: "without its cover (frozen)".
        after: What shows of each object that is left, by instance.
        item: Instance that has to come to light, and nothing else.
        anew: What showed before.
        what: The instance in a message's words.
    """
    if after[item].fraction < REVEALED_SHARE:
        yield f"{when} only {after[item].fraction:.0%} of {what} show"
    gains = [after[n].fraction - anew.seen[n].fraction for n in after if n != item]
    if max(gains, default=0.0) > LARGEST_GAIN:
        yield f"{when} another thing gains {max(gains):.0%}"
