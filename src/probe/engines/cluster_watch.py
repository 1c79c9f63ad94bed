"""Notices in mid-run that a cluster's first machine is gone, before Ray ends the process for it."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field

from probe.engines.cluster_address import ClusterAddress
from probe.engines.ray_errors import ClusterLost


@dataclass
class ClusterWatch:
    """Looks now and then whether the first machine answers.

    Attributes:
        address: Of the first machine.
        kept: Where finished results are, in words.
        tell: Is told when it falls silent.
        every: Seconds between two looks.
        patience: Seconds of silence after which it is gone; Ray itself takes 60.
    """

    address: ClusterAddress
    kept: str
    tell: Callable[[str], object]
    every: float = 5.0
    patience: float = 20.0
    _looked: float = field(default_factory=time.monotonic)
    _silent_since: float | None = None

    def look(self) -> None:
        """Look whether the first machine answers, if it is time to.

        Raises:
            ClusterLost: It hasn't for too long.
        """
        now = time.monotonic()
        if now - self._looked < self.every:
            return
        self._looked = now
        if self.address.answers():
            self._silent_since = None
        elif self._silent_since is None:
            self._silent_since = now
            self.tell(f"{self.address} doesn't answer; waiting {self.patience:.0f} s for it.")
        elif now - self._silent_since >= self.patience:
            raise ClusterLost(str(self.address), self.kept)
