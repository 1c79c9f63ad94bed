"""Tables in worker processes that ask, hang, or can't be set up."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from probe.episodes.turns import Call
from probe.errors import ProbeError
from probe.runs.episode_worker import EpisodeWorkerSetup
from probe.runs.worker_messages import (
    CallResult,
    EpisodeFinished,
    EpisodeStarted,
    FinishEpisode,
    PointerRequest,
    Request,
    Response,
)

PATIENCE = 300.0
"""Seconds that a table hangs."""


class Curious:
    """Asks where with each find_object; leaving, it tells the calls that were made at it."""

    def __init__(self, place: EpisodeWorkerSetup) -> None:
        self._place = place
        self._calls: list[str] = []

    def do(self, request: Request) -> Response:
        if isinstance(request, FinishEpisode):
            return EpisodeFinished(" ".join(self._calls).encode(), None)
        if not isinstance(request, Call):
            return EpisodeStarted(())
        self._calls.append(request.name)
        said = ""
        if request.name == "find_object":
            assert self._place.asking is not None
            self._place.asking.send(PointerRequest((), "where?"))
            said = str(self._place.asking.recv())
        return CallResult(said, None, False)


@dataclass(frozen=True)
class CuriousPlace(EpisodeWorkerSetup):
    @contextmanager
    def __call__(self) -> Generator[Callable[[Request], Response]]:
        yield Curious(self).do


@dataclass(frozen=True)
class HangingPlace(EpisodeWorkerSetup):
    """Sits down, and never comes back from a call."""

    @contextmanager
    def __call__(self) -> Generator[Callable[[Request], Response]]:
        def do(request: Request) -> Response:
            if isinstance(request, Call):
                time.sleep(PATIENCE)
            return EpisodeStarted(())

        yield do


@dataclass(frozen=True)
class StillbornPlace(EpisodeWorkerSetup):
    """Dies while it is set up."""

    @contextmanager
    def __call__(self) -> Generator[Callable[[Request], Response]]:
        os._exit(9)
        yield


@dataclass(frozen=True)
class UnfitPlace(EpisodeWorkerSetup):
    """Can't be set up, and leaves a file beside the records each time."""

    @contextmanager
    def __call__(self) -> Generator[Any]:
        assert self.cache is not None
        with self.cache.open("a") as file:
            file.write("tried\n")
        raise ProbeError("there is no driver")
        yield
