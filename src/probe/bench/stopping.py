"""When a run with a model stops before its end: where no other episode would fare better."""

from __future__ import annotations

from probe.errors import BadData, ModelFailed, OutputFailed, ProbeError, WorkerDied
from probe.processes.serving import WorkerUnfit

MUTE = 8
"""After so many episodes one after another in which a model said nothing at all, a run stops."""

HOPELESS = (BadData, OutputFailed, WorkerUnfit, WorkerDied, ModelFailed)
"""What an episode raises that stands for all: the folder, the disk, tables that can't be set up,
a model that never says anything. Whatever concerns one alone is in its record."""


class RunStopped(ProbeError):
    """A run can't go on."""


class SilenceLimit:
    """With a model that says nothing."""

    def __init__(self) -> None:
        self._mute = 0

    def heard(self, unheard: bool, fault: str | None) -> None:
        """Take in how an episode ended.

        Args:
            unheard: Whether the model was asked and said nothing at all.
            fault: Why.

        Raises:
            ModelFailed: It isn't worth while to ask on.
        """
        self._mute = self._mute + 1 if unheard else 0
        if self._mute >= MUTE:
            many = f"{MUTE} episodes one after another came to nothing"
            raise ModelFailed(f"{many}: {fault}. Once it answers, the same command goes on.")
