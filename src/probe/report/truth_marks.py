"""Where the things lie that a right answer is about, in each picture of an episode."""

from __future__ import annotations

import numpy as np

from probe.episodes.record import EpisodeRecord
from probe.scene.scene import Scene
from probe.tasks.task import Task
from probe.types import Camera

Place = tuple[float, float]
"""Across and down, as shares of the picture, 0 to 1."""


def truth_places(task: Task, record: EpisodeRecord) -> list[list[Place]]:
    """The places of the true things in the picture of the start and in that after each step.

    Things that have left the picture have none there; on a robot nothing has, for its records keep
    no poses.
    """
    wanted = _true_instances(task)
    camera = record.viewpoint.camera
    return [_places(scene, wanted, camera) for scene in record.scenes]


def _true_instances(task: Task) -> frozenset[int]:
    """Of two marked things the right one, else all that decide."""
    marked = [mark.instance for mark in task.marks if mark.letter == task.answer]
    return frozenset(marked or task.targets)


def _places(scene: Scene, wanted: frozenset[int], camera: Camera) -> list[Place]:
    points = [placed.pose.position for placed in scene.objects if placed.instance in wanted]
    if not points:
        return []
    shares = camera.project(np.array(points)) / (camera.width_px, camera.height_px)
    return [
        (round(float(u), 3), round(float(v), 3)) for u, v in shares if 0 <= u <= 1 and 0 <= v <= 1
    ]
