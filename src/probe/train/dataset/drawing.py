"""Draws the pictures of many episodes in worker processes, and keeps them for a while."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial

import numpy as np

from probe.assets.cache import Cache, content_key
from probe.assets.library import Library
from probe.engines.plan import Engine, LostUnit, WorkPlan
from probe.episodes.files import line_of
from probe.episodes.record import EpisodeRecord
from probe.errors import ProbeError
from probe.report.scene_renderer import SceneRenderer
from probe.tasks.suite import Suite
from probe.tasks.task import Task
from probe.train.dataset.showing import EpisodePictures, shown
from probe.types import Array

Drawing = tuple[Task, EpisodeRecord]

_EDITION = "1"
"""To be raised when the same episode is drawn differently."""


class NotDrawn(ProbeError):
    """The pictures of an episode couldn't be drawn."""

    def __init__(self, record: EpisodeRecord, reason: str) -> None:
        super().__init__(f"The pictures of {record.task} can't be drawn: {reason}")


@dataclass(frozen=True)
class DrawingWorker:
    """A worker that draws; see probe.processes.serving.Opening.

    Attributes:
        suite: All tasks, and what their objects looked like.
        library: Opens the objects.
        kept: Where pictures go.
        side_px: Their width and height.
    """

    suite: Suite
    library: Callable[[], Library]
    kept: Cache
    side_px: int

    @contextmanager
    def __call__(self) -> Generator[Callable[[Drawing], bytes]]:
        """Make a darkroom; gives what draws an episode."""
        with SceneRenderer(self.suite, self.library) as scene_renderer:
            yield partial(self._drawn, scene_renderer)

    def key(self, record: EpisodeRecord) -> str:
        """Under which an episode's pictures are kept."""
        return content_key("pictures", _EDITION, line_of(record, timed=False), str(self.side_px))

    def _drawn(self, scene_renderer: SceneRenderer, job: Drawing) -> bytes:
        task, record = job
        try:
            self.kept.store(
                self.key(record), _packed(shown(task, record, scene_renderer, self.side_px))
            )
        except ProbeError as error:
            return str(error).encode()
        return b""


def draw(worker: DrawingWorker, episodes: Sequence[Drawing], engine: Engine) -> Iterator[None]:
    """Draw what isn't kept yet; yields once for each episode.

    Raises:
        NotDrawn: One can't be drawn; an object has changed, or perception was no oracle.
        OutputFailed: Pictures can't be kept.
    """
    waiting = [it for it in episodes if not worker.kept.path(worker.key(it[1])).exists()]
    yield from [None] * (len(episodes) - len(waiting))
    plan = WorkPlan("pictures", worker, waiting, lambda it: worker.key(it[1]))
    results = engine.carry_out(plan)
    try:
        for (_, record), result in results:
            reason = result.reason if isinstance(result, LostUnit) else result.decode()
            if reason:
                raise NotDrawn(record, reason)
            yield
    finally:
        results.close()


def pictures_of(worker: DrawingWorker, record: EpisodeRecord) -> EpisodePictures:
    """The pictures that draw() kept.

    Raises:
        NotDrawn: They are gone.
    """
    arrays = worker.kept.load(worker.key(record))
    if arrays is None:
        raise NotDrawn(record, "they have been taken away. Run it again")
    return _unpacked(arrays, len(record.steps))


def _packed(pictures: EpisodePictures) -> dict[str, Array]:
    named = {f"first {n}": it for n, it in enumerate(pictures.first)}
    named |= {f"later {n}": it for n, it in enumerate(pictures.later) if it is not None}
    return {name: np.frombuffer(file, np.uint8) for name, file in named.items()}


def _unpacked(arrays: Mapping[str, Array], steps: int) -> EpisodePictures:
    files = {name: array.tobytes() for name, array in arrays.items()}
    first = tuple(files[name] for name in sorted(files) if name.startswith("first"))
    return EpisodePictures(first, tuple(files.get(f"later {n}") for n in range(steps)))
