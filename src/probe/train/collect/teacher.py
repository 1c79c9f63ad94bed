"""The scripted teacher in a worker process: it gives its reasons in words, as a model would.

What it says rests on the tools' results alone. Without tools it answers only what the first look
shows.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from probe.agents.phrases import PhraseBook, Say
from probe.agents.reading import read_graph
from probe.agents.scripted import Scripted
from probe.agents.type_plan import FirstLookAnswer, FirstLookQuestion, plan_for
from probe.assets.library import Library
from probe.episodes.circumstances import Circumstances
from probe.episodes.grading import question_of
from probe.episodes.participation import ModelReply, Participation, Points
from probe.episodes.play import set_table
from probe.episodes.record import EpisodeRecord
from probe.episodes.turns import Agent, Call, Question, Turn
from probe.render.renderer import Renderer
from probe.runs.plan import Job, RunOrder
from probe.runs.viewpoints import viewpoint_of
from probe.runs.work import WorkerSetup, stopped
from probe.scene.seeds import generator
from probe.tasks.task import Task
from probe.toolshed.result import Answer
from probe.transcripts.coordinates import as_whole, told

TEACHER = "scripted-teacher"


@dataclass(frozen=True)
class RoundedPlaces:
    """An agent whose places are whole numbers in the way in which a model will read them.

    Those in its words are told so, too; calls are recorded in pixels.
    """

    agent: Agent
    points: Points

    def act(self, question: Question, history: Sequence[Turn]) -> Call | None:
        """The agent's next call."""
        call = self.agent.act(question, history)
        if call is None:
            return None
        whole = as_whole(call, self.points)
        return replace(whole, words=told(whole.words, self.points))


def speaker(task: Task, run: int) -> PhraseBook:
    """What chooses the teacher's words in one episode."""
    return PhraseBook(generator(task.seed, "words", run))


def teacher(task: Task, run: int, points: Points = "pixels", say: Say | None = None) -> Agent:
    """The teacher with tools, fresh for one episode; it stops where it isn't sure.

    Args:
        task: What it is asked.
        run: Number of the run.
        points: How a model will count places.
        say: Chooses its words; by default its usual speaker().
    """
    rng, say = generator(task.seed, "teach", run), say or speaker(task, run)
    made = Scripted(task.question_type, task.subject, rng, form=task.form, say=say)
    return RoundedPlaces(made, points)


def teacher_for(points: Points) -> _Made:
    """What makes teachers for worker processes; see probe.runs.work.AgentOf.

    Args:
        points: How a model will count places.
    """
    return _Made(points)


@dataclass(frozen=True)
class _Made:
    points: Points

    def __call__(
        self, name: str, task: Task, run: int, library: Library, renderer: Renderer
    ) -> Agent:
        return teacher(task, run, self.points)


@dataclass(frozen=True)
class TeacherWorker(WorkerSetup):
    """Where the teacher works: its records tell of a seat, as a model's do."""

    def played(self, job: Job, things: Library, renderer: Renderer) -> EpisodeRecord:
        """One episode in the order's setting."""
        order = self.order
        if order.setting == "direct":
            return self._told(job, things, renderer)
        record = super().played(job, things, renderer)
        replies = tuple(ModelReply(1) for _ in record.steps)
        return replace(
            record, participation=Participation(order.setting, order.points, replies, cost=0.0)
        )

    def _told(self, job: Job, things: Library, renderer: Renderer) -> EpisodeRecord:
        order, task = self.order, job.task
        viewpoint = viewpoint_of(task, order.conditions, things.assets)
        tools, _ = set_table(
            task,
            things,
            renderer,
            Circumstances(job.run, conditions=order.conditions, viewpoint=viewpoint),
            pictures=False,
        )
        graph = read_graph(tools.call("perceive_scene", {}).text)
        asked = FirstLookQuestion(question_of(task), task.subject, task.form, graph)
        said = plan_for(task.question_type).at_sight(asked, speaker(task, job.run))
        return answered(replace(stopped(job, order), viewpoint=viewpoint), order, said)


def answered(record: EpisodeRecord, order: RunOrder, said: FirstLookAnswer | None) -> EpisodeRecord:
    """A record of an episode that was ended at once, with an answer in words, or with none."""
    if said is None:
        seat = Participation(order.setting, order.points, cost=0.0)
        return replace(record, participation=seat)
    place = f" ({said.point[0]}, {said.point[1]})" if said.point else ""
    words = told(f"{said.words}\nANSWER: {said.letter}{place}", order.points)
    seat = Participation(order.setting, order.points, (ModelReply(0, words),), cost=0.0)
    point = (float(said.point[0]), float(said.point[1])) if said.point else None
    answer = Answer(said.letter, point)
    return replace(record, answer=answer, end="answered", participation=seat)
