"""The pictures of an episode as a model was sent them, drawn from its record without physics."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from PIL import Image

from probe.episodes.conditions import NO_DIALS
from probe.episodes.record import EpisodeRecord, Step
from probe.errors import BadData, ProbeError
from probe.perception.things import Thing, Words
from probe.report.scene_renderer import SceneRenderer
from probe.scene.scene import Scene
from probe.scene.setup import UR5_TABLE
from probe.tasks.marks import drawn
from probe.tasks.task import Task
from probe.toolshed.pictures import outlined
from probe.toolshed.result import DID_NOTHING
from probe.transcripts.pictures import jpeg
from probe.transcripts.prompts import setting_named
from probe.types import Array

_NOTHING = Words(None, "", (), "")


class OtherPerception(ProbeError):
    """An episode whose pictures can't be drawn again."""

    def __init__(self, record: EpisodeRecord, why: str) -> None:
        super().__init__(
            f"{record.task}, {record.agent}, run {record.run}: its pictures can't be drawn from "
            f"the record, since {why}. Collect with --pointer oracle and without --dials, in the "
            "settings direct and agentic."
        )


@dataclass(frozen=True)
class EpisodePictures:
    """An episode's pictures, as JPEG files.

    Attributes:
        first: Those that came with the question.
        later: Of each step, the one that its result came with; None where there was none.
    """

    first: tuple[bytes, ...]
    later: tuple[bytes | None, ...]

    @property
    def all(self) -> tuple[bytes, ...]:
        """In the order in which a model sees them."""
        return (*self.first, *(each for each in self.later if each is not None))


def shown(
    task: Task,
    record: EpisodeRecord,
    scene_renderer: SceneRenderer,
    side_px: int = UR5_TABLE.picture_px,
) -> EpisodePictures:
    """Draw an episode's pictures.

    Args:
        task: What it was about.
        record: What happened.
        scene_renderer: Of a suite that has the task.
        side_px: Width and height; by default as models are sent them.

    Raises:
        BadData: The episode was played without pictures.
        OtherPerception: Perception wasn't the oracle's, or the setting is another.
    """
    _check(record)
    start = _picture(task, record, record.start.scene, scene_renderer)
    scenes = record.scenes
    later = [
        _result(task, record, step, scenes[number], scene_renderer)
        for number, step in enumerate(record.steps)
    ]
    files = [None if it is None else jpeg(_sized(it, side_px)) for it in later]
    return EpisodePictures((jpeg(_sized(drawn(start, task.marks), side_px)),), tuple(files))


def _check(record: EpisodeRecord) -> None:
    if record.setting and setting_named(record.setting) == "text-only":
        reason = f"{record.task} was played without pictures"
        raise BadData("--setting", reason, "Say --setting text-only")
    if record.setting and setting_named(record.setting) not in ("agentic", "direct"):
        raise OtherPerception(record, f"its setting is {record.setting}")
    if "," in record.setting:
        raise OtherPerception(record, "a model pointed for perception")
    if record.conditions.dials != NO_DIALS:
        raise OtherPerception(record, "perception made errors")
    if record.perception.label:
        raise OtherPerception(record, f"it was played with {record.perception.label}")


def _result(
    task: Task, record: EpisodeRecord, step: Step, before: Scene, scene_renderer: SceneRenderer
) -> Array | None:
    """What a step's result showed: nothing if nothing was done, else the table after it."""
    if step.status in DID_NOTHING or step.call.name == "answer_question":
        return None
    if step.call.name != "find_object":
        return _picture(task, record, step.after.scene, scene_renderer)
    picture = _picture(task, record, before, scene_renderer)
    if step.status != "done" or step.point_px is None:
        return picture
    labels = scene_renderer.frame(task, before, record.viewpoint).labels
    assert labels is not None
    u, v = step.point_px
    return outlined(picture, Thing.of(labels == labels[v, u], _NOTHING))


def _picture(
    task: Task, record: EpisodeRecord, scene: Scene, scene_renderer: SceneRenderer
) -> Array:
    frame = scene_renderer.frame(task, scene, record.viewpoint)
    assert frame.rgb is not None
    return frame.rgb


def _sized(picture: Array, side_px: int) -> Array:
    if picture.shape[0] == side_px:
        return picture
    return np.asarray(Image.fromarray(picture).resize((side_px, side_px), Image.Resampling.BOX))
