"""An EpisodeRecord on disk: one line of versioned JSON, checked when it is read."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Literal

import pydantic

from probe.assets.pools.division import Shown, shown_of
from probe.episodes.conditions_document import ConditionsDocument
from probe.episodes.noise import Noise
from probe.episodes.participation_document import ParticipationDocument
from probe.episodes.perception_document import PerceptionDocument, used_of
from probe.episodes.record import End, EpisodeRecord, Seconds, Step, TableState
from probe.episodes.turns import Call, Question
from probe.episodes.viewpoint_document import ViewpointDocument
from probe.scene.document import SceneDocument
from probe.scene.setup import UR5_TABLE
from probe.scene.setup_file import MOST_PX
from probe.scene.viewpoint import Viewpoint
from probe.toolshed.result import Answer, Status

Pixel = Annotated[int, pydantic.Field(ge=0, lt=MOST_PX)]

FrameName = Annotated[str, pydantic.Field(pattern=r"^frames/[A-Za-z0-9_-]+/[0-9]{3}$")]
"""Of a picture in the run's folder, without an ending; it can't lead out of it."""


class _Document(pydantic.BaseModel, extra="forbid", allow_inf_nan=False):
    pass


class TableDocument(_Document):
    """Every object's pose, and the arm's joints in radians."""

    scene: SceneDocument
    joints: tuple[float, ...]


class CallDocument(_Document):
    """A call as an agent made it; its arguments are JSON text, since they needn't be valid."""

    name: str
    arguments: str
    words: str


class StepDocument(_Document):
    """One call; `after` is None where the table is as it was before."""

    call: CallDocument
    status: Status
    text: str
    point_px: tuple[Pixel, Pixel] | None
    after: TableDocument | None


class AnswerDocument(_Document):
    """Letter, and (u, v) in pixels if a point was given."""

    choice: str
    point_px: tuple[float, float] | None


class SecondsDocument(_Document):
    """Wall time of each step."""

    agent: tuple[float, ...]
    tools: tuple[float, ...]


class NoiseDocument(_Document):
    """Standard deviations of the hand's errors, metres."""

    grasp: float = pydantic.Field(ge=0)
    push: float = pydantic.Field(ge=0)


class EpisodeDocument(_Document, validate_by_name=True, serialize_by_alias=True):
    """One episode."""

    version: Literal[2] = 2
    task: str
    agent: str
    run: int = pydantic.Field(ge=0, le=10**9)
    question: str
    options: tuple[tuple[str, str], ...]
    manipulations: int | None = pydantic.Field(
        default=None, ge=1, le=10**6, exclude_if=lambda it: it is None
    )
    start: TableDocument
    steps: tuple[StepDocument, ...]
    answer: AnswerDocument | None
    end: End
    fault: str | None
    seconds: SecondsDocument | None
    noise: NoiseDocument
    # Records of before there were conditions are of none.
    conditions: ConditionsDocument = ConditionsDocument()
    viewpoint: Annotated[ViewpointDocument | None, pydantic.Field(alias="sight")] = None
    # None of agents that are no models, and in records of before there were any.
    participation: Annotated[ParticipationDocument | None, pydantic.Field(alias="seat")] = None
    # Release 0.1 had version 1 and didn't say so; its records keep their bytes.
    tools: int = pydantic.Field(default=1, ge=1, le=10**6, exclude_if=lambda version: version == 1)
    perception: PerceptionDocument | None = pydantic.Field(
        default=None, exclude_if=lambda it: it is None
    )
    frames: tuple[FrameName, ...] = pydantic.Field(default=(), exclude_if=lambda names: not names)
    # For what the built-in objects on its table are, unless for evaluation alone, as it should be
    # in evaluation and always was before some were set aside for training.
    pool: Literal["train", "both"] | None = pydantic.Field(
        default=None, exclude_if=lambda it: it is None
    )

    @pydantic.model_validator(mode="after")
    def _has_a_picture_of_each_step(self) -> EpisodeDocument:
        if self.frames and len(self.frames) != len(self.steps) + 1:
            raise ValueError(f"{len(self.frames)} frames don't go with {len(self.steps)} steps")
        return self

    @pydantic.model_validator(mode="after")
    def _says_what_is_for_training(self) -> EpisodeDocument:
        shown = _trained_on(shown_of(it.object_id for it in self.start.scene.objects))
        if self.pool != shown:
            raise ValueError(f"pool is {self.pool}, but by its objects it is {shown}")
        return self

    @pydantic.model_validator(mode="after")
    def _points_into_its_pictures(self) -> EpisodeDocument:
        usual = UR5_TABLE.picture_px
        side = (self.viewpoint.picture_px if self.viewpoint else None) or usual
        for number, step in enumerate(self.steps):
            if step.point_px is not None and max(step.point_px) >= side:
                raise ValueError(f"steps.{number}.point_px lies outside a picture of {side} pixels")
        return self

    @staticmethod
    def of(record: EpisodeRecord, *, timed: bool = True) -> EpisodeDocument:
        """The document of a record, on request without its timing."""
        answer, times = record.answer, record.seconds
        return EpisodeDocument(
            task=record.task,
            agent=record.agent,
            run=record.run,
            question=record.question.text,
            options=record.question.options,
            manipulations=record.question.manipulations,
            start=_table_document(record.start),
            steps=_step_documents(record),
            answer=answer and AnswerDocument(choice=answer.choice, point_px=answer.point_px),
            end=record.end,
            fault=record.fault,
            seconds=SecondsDocument(agent=times.agent, tools=times.tools) if timed else None,
            noise=NoiseDocument(grasp=record.noise.grasp, push=record.noise.push),
            conditions=ConditionsDocument.of(record.conditions, record.viewpoint),
            viewpoint=ViewpointDocument.of(record.viewpoint),
            participation=record.participation and ParticipationDocument.of(record.participation),
            tools=record.tools,
            perception=PerceptionDocument.of(record.perception),
            frames=record.frames,
            pool=_trained_on(record.pool),
        )

    def record(self) -> EpisodeRecord:
        """The record it describes."""
        answer, times = self.answer, self.seconds
        return EpisodeRecord(
            task=self.task,
            agent=self.agent,
            run=self.run,
            question=Question(self.question, self.options, manipulations=self.manipulations),
            start=_table(self.start),
            steps=_steps(self),
            answer=answer and Answer(answer.choice, answer.point_px),
            end=self.end,
            fault=self.fault,
            seconds=Seconds(times.agent, times.tools) if times else Seconds(),
            noise=Noise(self.noise.grasp, self.noise.push),
            conditions=self.conditions.conditions(),
            viewpoint=self.viewpoint.viewpoint() if self.viewpoint else Viewpoint(),
            participation=self.participation and self.participation.participation(),
            tools=self.tools,
            perception=used_of(self.perception),
            frames=self.frames,
        )


def _trained_on(shown: Shown | None) -> Literal["train", "both"] | None:
    return None if shown == "evaluation" else shown


def _step_documents(record: EpisodeRecord) -> tuple[StepDocument, ...]:
    before, documents = record.start, list[StepDocument]()
    for step in record.steps:
        call = step.call
        documents.append(
            StepDocument(
                call=CallDocument(name=call.name, arguments=call.arguments, words=call.words),
                status=step.status,
                text=step.text,
                point_px=step.point_px,
                after=None if step.after == before else _table_document(_bare(step.after)),
            )
        )
        before = step.after
    return tuple(documents)


def _bare(table: TableState) -> TableState:
    """The table without its set-up, which its start alone tells: it can't change."""
    return replace(table, scene=replace(table.scene, setup=UR5_TABLE))


def _steps(document: EpisodeDocument) -> tuple[Step, ...]:
    table, steps = _table(document.start), list[Step]()
    setup = table.scene.setup
    for step in document.steps:
        if step.after:
            table = _table(step.after)
            table = replace(table, scene=replace(table.scene, setup=setup))
        call = Call(step.call.name, step.call.arguments, step.call.words)
        steps.append(Step(call, step.status, step.text, step.point_px, table))
    return tuple(steps)


def _table_document(table: TableState) -> TableDocument:
    return TableDocument(scene=SceneDocument.of(table.scene), joints=table.joints)


def _table(document: TableDocument) -> TableState:
    return TableState(document.scene.scene(), document.joints)
