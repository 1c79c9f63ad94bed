"""Whether what a record states of its question and of how it came about can be so."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from probe.episodes.grading import question_of
from probe.episodes.record import EpisodeRecord
from probe.errors import UnknownName
from probe.runs.checks.calls import things_of
from probe.runs.viewpoints import camera_of
from probe.scene.lighting import lighting_of
from probe.scene.scene import Scene
from probe.tasks.task import Task
from probe.transcripts.prompts import check_setting
from probe.types import Camera, Pose

_SAME = 1e-9
"""Metres, and parts of a quaternion: physics normalises quaternions, which may change a bit."""


def amiss_beside_task(record: EpisodeRecord, task: Task) -> Iterator[str]:
    """In what a record isn't about its task: the question, its options, the table at the start."""
    asked = question_of(task)
    if record.question.text != asked.text:
        yield "its question isn't that of the suite"
    if record.question.options != asked.options:
        yield "its options aren't those of the suite"
    # Of a real table nobody knows where things are: its record tells the set-up alone.
    there = replace(task.scene, objects=()) if record.frames else task.scene
    if not _same_scene(record.start.scene, there):
        yield "its table at the start isn't that of the suite"
    camera = camera_of(task, record.conditions.camera)
    # What came to nothing may say nothing of how it would have been seen.
    if record.end != "fault" and not _same_camera(record.viewpoint.camera, camera):
        yield "its camera isn't where its conditions put it"


def amiss_as_stated(record: EpisodeRecord) -> Iterator[str]:
    """What no agent, run, luck, light, times or model's part can be like."""
    if not record.agent.strip():
        yield "its agent has no name"
    if min(record.noise.grasp, record.noise.push) < 0:
        yield "its noise is below 0"
    yield from _of_pictures(record)
    yield from _of_times(record)
    yield from _of_seat(record)


def _of_pictures(record: EpisodeRecord) -> Iterator[str]:
    scene, said, seen = record.start.scene, record.conditions, record.viewpoint
    own, light = scene.setup, lighting_of(scene.setup.lighting, scene.table)
    if said.lighting == "own" and seen.lighting != light:
        yield "its light isn't that of its conditions"
    if seen.renderer != (own.renderer if said.renderer == "own" else said.renderer):
        yield "its renderer isn't that of its conditions"


def _of_times(record: EpisodeRecord) -> Iterator[str]:
    for name, seconds in (("agent", record.seconds.agent), ("tools", record.seconds.tools)):
        if seconds and len(seconds) != len(record.steps):
            yield f"it has {len(seconds)} times of its {name} for {len(record.steps)} calls"
        if not all(math.isfinite(time) and time >= 0 for time in seconds):
            yield f"a time of its {name} is below 0"
    if bool(record.seconds.agent) != bool(record.seconds.tools):
        yield "it has times of one side alone"


def _of_seat(record: EpisodeRecord) -> Iterator[str]:
    seat = record.participation
    if seat is None:
        return
    try:
        # An agent that isn't a model, but whose own fault is noted, has none.
        if seat.setting:
            check_setting(seat.setting)
    except UnknownName as error:
        yield str(error).rstrip(".")
    counted = (seat.tokens_in, seat.tokens_out, seat.cost)
    if any(number is not None and number < 0 for number in counted):
        yield "its tokens or their cost are below 0"


def _same_scene(scene: Scene, other: Scene) -> bool:
    if (scene.seed, scene.table, scene.setup) != (other.seed, other.table, other.setup):
        return False
    if things_of(scene) != things_of(other):
        return False
    pairs = zip(scene.objects, other.objects, strict=True)
    return all(_same_pose(one.pose, two.pose) for one, two in pairs)


def _same_camera(one: Camera, other: Camera) -> bool:
    if (one.width_px, one.fov_y_deg) != (other.width_px, other.fov_y_deg):
        return False
    return _same_pose(one.world_from_camera, other.world_from_camera)


def _same_pose(one: Pose, other: Pose) -> bool:
    first, second = (*one.position, *one.wxyz), (*other.position, *other.wxyz)
    return bool(np.allclose(first, second, rtol=0, atol=_SAME))
