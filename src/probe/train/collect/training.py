"""Which objects and which episodes are for training."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from probe.assets.library import Library
from probe.assets.pools.split import Split, part_of

FIRST_EPISODE = 2_000_000
"""Training seeds start at 2,000,000,000: no suite's episode comes that far."""


@dataclass(frozen=True)
class Training:
    """Opens the objects for training: of a split its training part; a value for workers.

    Attributes:
        opened: Opens the whole library.
        split: Which objects are for what; None to take all.
    """

    opened: Callable[[], Library]
    split: Split | None = None

    def __call__(self) -> Library:
        """The objects."""
        things = self.opened()
        return things if self.split is None else part_of(things, self.split, "train")
