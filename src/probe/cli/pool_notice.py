"""Says it if objects are used that were set aside for something else."""

from __future__ import annotations

from probe.assets.library import Library
from probe.assets.pools.division import Part, parts_shown
from probe.cli.screen import say

_OTHER: dict[Part, Part] = {"train": "evaluation", "evaluation": "train"}
_FOR: dict[Part, str] = {"train": "training", "evaluation": "evaluation"}


def tell_other_pool(things: Library, meant: Part, where: str) -> None:
    """Say how many of some objects are set aside for the other purpose, if any are.

    Args:
        things: The objects that may appear.
        meant: What they are used for.
        where: What will say so, too.
    """
    count = parts_shown(spec.id for spec in things.specs)[_OTHER[meant]]
    if count:
        purpose = _FOR[_OTHER[meant]]
        say(
            f"{count} of these {len(things.specs)} objects are set aside for {purpose} (--pool "
            f"{things.pool}): a model that is trained on them has seen them. {where}"
        )
