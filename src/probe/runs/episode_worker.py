"""What a worker process does for a model: sets a table, does call after call, hands in the record.

Knows no model: what perception has to ask one goes through a pipe of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from multiprocessing.connection import Connection
from pathlib import Path

import numpy as np

from probe.assets.library import Library
from probe.episodes.episode import Episode
from probe.episodes.files import line_of, record_of
from probe.episodes.grading import grade_episode, needs_labels
from probe.episodes.participation import has_tools
from probe.episodes.play import open_episode, score
from probe.episodes.record import EpisodeRecord
from probe.episodes.turns import Call
from probe.errors import ModelFailed
from probe.perception.choice import Perceiver, ideal, pointing
from probe.perception.points import Convention
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from probe.render.renderers import Renderers
from probe.runs.live import LiveTable
from probe.runs.plan import Job, RunOrder
from probe.runs.stills import stills
from probe.runs.viewpoints import circumstances_of, renderer_of, viewpoint_of
from probe.runs.work import failed
from probe.runs.worker_messages import (
    CallResult,
    EpisodeFailed,
    EpisodeFinished,
    EpisodeStarted,
    FinishEpisode,
    GradeRecord,
    NoReply,
    PointerRequest,
    Request,
    Response,
    StartEpisode,
)
from probe.tasks.grading import Score
from probe.tasks.task import Task
from probe.transcripts.pictures import jpeg
from probe.transcripts.prompts import Setting, setting_named
from probe.types import Array


@dataclass(frozen=True)
class EpisodeWorkerSetup:
    """All that a worker is told before its first table; see probe.processes.serving.Opening.

    Attributes:
        order: Who acts, and under which conditions.
        library: Opens the objects; a value that can be sent to another process.
        cache: Folder for prepared light.
        asking: The way to a model that points; None for a perceiver that asks nobody.
        convention: How that model writes points down.
        perceiver: Makes what the tools see with, without a model; the order says the same.
        tables: Folder of this machine in which a page looks what happens; None for nobody.
    """

    order: RunOrder
    library: Callable[[], Library]
    cache: Path | None = None
    asking: Connection | None = None
    convention: Convention = "pixels"
    perceiver: Perceiver = ideal
    tables: Path | None = None

    @contextmanager
    def __call__(self) -> Generator[Callable[[Request], Response]]:
        """Open the library and renderers; gives what does a request."""
        things = self.library()
        with Renderers(self.cache) as renderers:
            renderers.require(self.order.conditions.renderer)
            yield EpisodeWorker(self, things, renderers).do


class EpisodeWorker:
    """One table after another; between Sit and Leave there is one."""

    def __init__(self, place: EpisodeWorkerSetup, things: Library, renderers: Renderers) -> None:
        self._place = place
        self._order = place.order
        self._things = things
        self._renderers = renderers
        self._setting: Setting = setting_named(place.order.setting)
        self._sees = self._setting != "text-only"
        self._job: Job | None = None
        self._episode: Episode | None = None
        self._live = LiveTable(place.tables) if place.tables else None

    def do(self, request: Request) -> Response:
        """Do one request; whatever goes wrong costs this table alone."""
        try:
            match request:
                case StartEpisode(job):
                    return self._sit(job)
                case Call():
                    return self._call(request)
                case FinishEpisode():
                    return self._leave(request)
                case GradeRecord(job, line):
                    return EpisodeFinished(line, self._worth(job.task, record_of(line)))
        except Exception as error:
            # The model's side decides whether it is tried again, and the record says what it was.
            return EpisodeFailed(f"{type(error).__name__}: {error}")

    def _sit(self, job: Job) -> EpisodeStarted:
        self._job, self._episode = job, None
        if not has_tools(self._setting):
            return EpisodeStarted(tuple(map(jpeg, self._stills(job))))
        self._episode = self._open(job)
        question = self._episode.record.question
        if self._live:
            self._live.begin(job.task.id, job.run, question)
        if not self._sees:
            return EpisodeStarted(())
        assert question.picture is not None
        return EpisodeStarted((jpeg(question.picture),))

    def _open(self, job: Job) -> Episode:
        order, task = self._order, job.task
        return open_episode(
            task,
            order.agent,
            self._things,
            self._renderer(task),
            circumstances_of(order, job, self._things.assets),
            self._perceiver(),
            # Whoever looks on sees pictures all the same.
            pictures=self._sees or self._live is not None,
        )

    def _stills(self, job: Job) -> Sequence[Array]:
        """What a model without tools is shown."""
        viewpoint = viewpoint_of(job.task, self._order.conditions, self._things.assets)
        return stills(self._setting, job.task, viewpoint, self._things, self._renderer(job.task))

    def _call(self, call: Call) -> CallResult | EpisodeFailed:
        assert self._episode is not None, "a call needs a table that is set"
        if self._live:
            self._live.call(call)
        turn = self._episode.step(call)
        if self._live:
            self._live.result(turn)
        result = turn.result
        record = self._episode.record
        if record.end == "fault":
            return EpisodeFailed(record.fault or "unknown")
        shown = result.picture if self._sees else None
        picture = None if shown is None else jpeg(shown)
        return CallResult(result.text, picture, result.ended)

    def _leave(self, leave: FinishEpisode) -> EpisodeFinished:
        assert self._job is not None, "nobody sits at the table"
        record = replace(self._record(self._job, leave), participation=leave.participation)
        self._episode = None
        return EpisodeFinished(line_of(record), self._worth(self._job.task, record))

    def _worth(self, task: Task, record: EpisodeRecord) -> Score | None:
        if record.end == "fault":
            return None
        if not needs_labels(task, record):
            return grade_episode(task, record, np.zeros((0, 0), np.int32))
        renderer = self._renderer(task)
        load_scene(renderer, task.scene, self._things)
        return score(task, record, renderer)

    def _renderer(self, task: Task) -> Renderer:
        """What draws a task's pictures under the order's conditions."""
        return self._renderers[renderer_of(task, self._order.conditions)]

    def _record(self, job: Job, leave: FinishEpisode) -> EpisodeRecord:
        order = self._order
        viewpoint = viewpoint_of(job.task, order.conditions, self._things.assets)
        if self._episode is None:
            record = replace(failed(job, order, leave.fault or ""), viewpoint=viewpoint)
            if leave.fault is None:
                end = "answered" if leave.answer else "stopped"
                record = replace(record, answer=leave.answer, end=end, fault=None)
            return record
        record = self._episode.record.under(circumstances_of(order, job, self._things.assets))
        return replace(record, end="fault", fault=leave.fault) if leave.fault else record

    def _perceiver(self) -> Perceiver:
        if self._place.asking is None:
            return self._place.perceiver
        return pointing(self._ask, convention=self._place.convention)

    def _ask(self, images: Sequence[Array], text: str) -> str:
        """Ask the model that points; see probe.types.Ask."""
        assert self._place.asking is not None
        self._place.asking.send(PointerRequest(tuple(map(jpeg, images)), text))
        reply = self._place.asking.recv()
        if isinstance(reply, NoReply):
            raise ModelFailed(reply.reason)
        return reply
