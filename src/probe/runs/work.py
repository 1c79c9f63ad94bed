"""What a worker process does: episode after episode, with its own library and renderer."""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from probe.agents.external.external_agent import ExternalAgent
from probe.assets.library import Library
from probe.engines.plan import TRIES
from probe.episodes.files import line_of
from probe.episodes.grading import question_of
from probe.episodes.participation import Participation
from probe.episodes.play import play
from probe.episodes.record import EpisodeRecord, TableState
from probe.episodes.turns import Agent
from probe.errors import OutputFailed
from probe.perception.choice import Perceiver, ideal
from probe.render.renderer import Renderer
from probe.render.renderers import Renderers
from probe.runs.live import LiveTable, Watched
from probe.runs.plan import Job, RunOrder
from probe.runs.viewpoints import circumstances_of, renderer_of
from probe.tasks.task import Task

AgentOf = Callable[[str, Task, int, Library, Renderer], Agent]
"""A fresh agent by its name, for a task and the number of a run; a function of a module.

It gets the objects, and a renderer whose loaded things it may replace.
"""


@dataclass(frozen=True)
class WorkerSetup:
    """All that a worker is told.

    Attributes:
        order: What is to be run.
        library: Opens the objects; a value that can be sent to another process.
        agent_of: Makes agents.
        perceiver: Makes what the tools see with; the order says the same.
        tables: Folder of this machine in which a page looks what happens; None for nobody.
    """

    order: RunOrder
    library: Callable[[], Library]
    agent_of: AgentOf
    perceiver: Perceiver = ideal
    tables: Path | None = None

    @contextmanager
    def __call__(self) -> Generator[Callable[[Job], bytes]]:
        """Open the library and renderers; gives what runs an episode to a record's line."""
        things = self.library()
        with Renderers(things.light_cache) as renderers:
            renderers.require(self.order.conditions.renderer)
            yield partial(self._line, things, renderers)

    def _line(self, things: Library, renderers: Renderers, job: Job) -> bytes:
        """The record of an episode; one that failed on our side is begun again, TRIES times."""
        renderer = renderers[renderer_of(job.task, self.order.conditions)]
        record = self._attempt(job, things, renderer)
        for _ in range(TRIES - 1):
            if record.end != "fault":
                break
            record = self._attempt(job, things, renderer)
        return line_of(record)

    def played(self, job: Job, things: Library, renderer: Renderer) -> EpisodeRecord:
        """One episode; whatever it raises is our fault."""
        agent = self.agent_of(self.order.agent, job.task, job.run, things, renderer)
        if not isinstance(agent, ExternalAgent):
            return self._play(job, agent, things, renderer)
        try:
            record = self._play(job, agent, things, renderer, pictures=agent.pictures)
        finally:
            agent.close()
        return (
            replace(record, participation=Participation("", faults=(agent.fault,)))
            if agent.fault
            else record
        )

    def _play(
        self,
        job: Job,
        agent: Agent,
        things: Library,
        renderer: Renderer,
        *,
        pictures: bool = False,
    ) -> EpisodeRecord:
        order, task = self.order, job.task
        if self.tables is not None:
            table = LiveTable(self.tables)
            agent = Watched(agent, table, task.id, job.run, pictures=pictures)
        return play(
            task,
            agent,
            order.agent,
            things,
            renderer,
            circumstances_of(order, job, things.assets),
            pictures=pictures or self.tables is not None,
            perceiver=self.perceiver,
        )

    def _attempt(self, job: Job, things: Library, renderer: Renderer) -> EpisodeRecord:
        try:
            record = self.played(job, things, renderer)
            line_of(record)  # one that can't be written down is a fault, too
            return record
        except OutputFailed:
            raise  # this machine's disk is full: another one may do it
        except Exception as error:
            # Whatever it is, it costs this episode alone and is told in its record.
            return failed(job, self.order, f"{type(error).__name__}: {error}")


def failed(job: Job, order: RunOrder, reason: str) -> EpisodeRecord:
    """The record of an episode that never got anywhere, through our fault."""
    return replace(stopped(job, order), end="fault", fault=reason)


def stopped(job: Job, order: RunOrder) -> EpisodeRecord:
    """The record of an episode that its agent ended at once."""
    start = TableState(job.task.scene, job.task.scene.setup.mount.parked)
    return EpisodeRecord(
        task=job.task.id,
        agent=order.agent,
        run=job.run,
        question=question_of(job.task),
        start=start,
        steps=(),
        answer=None,
        end="stopped",
        noise=order.noise,
        conditions=order.conditions,
        perception=order.perception,
        viewpoint=job.task.viewpoint,
    )
