"""The look-alikes check: whether what shows of a hidden thing tells it from the other options.

A can that stands upright shows its lid alone, and so does any other: whoever has uncovered it still
can't say which one it is.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from probe.assets.library import Library
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject
from probe.tasks.task import APART_RULES, Task
from probe.types import Array

LEAST_APART = 0.1
"""Share of the pixels of either that have to differ, where one stands in the other's place. Of 30
pairs that readers were shown, those that they couldn't tell were at most 0.01 apart, all others
0.23 or more."""

_OTHER_COLOUR = 40
"""Difference of a colour channel, 0 to 255, from which on a pixel differs."""


def look_alike(task: Task, library: Library, renderer: Renderer) -> str | None:
    """Which candidate looks like what decides, for people; None if none does.

    Each thing that decides and is a candidate is compared with each other candidate, in the same
    pose, with nothing around it. Tasks of rules before APART_RULES aren't checked.

    Args:
        task: What is asked.
        library: Has its objects, and all candidates if they are objects.
        renderer: What it had loaded is replaced.
    """
    known = {spec.id for spec in library.specs}
    candidates = [id for id in dict.fromkeys(task.certificate.candidates) if id in known]
    decide = [task.scene[n] for n in task.targets if task.scene[n].object_id in candidates]
    if task.version < APART_RULES or len(candidates) < 2 or not decide:
        return None
    meshes = {id: library.body(id, task.scene.setup.looks).mesh for id in candidates}
    load_scene(renderer, task.scene, library, more=meshes)
    for target in decide:
        own = _Seen(target, task, renderer)
        for other in candidates:
            twin = _Seen(PlacedObject(target.instance, other, target.pose), task, renderer)
            if other != target.object_id and own.apart(twin) < LEAST_APART:
                one, two = library[target.object_id].name, library[other].name
                return f"what shows of {one} is like what would show of {two}"
    return None


class _Seen:
    """A thing alone, seen by a task's camera; each picture is drawn once, if it is needed."""

    def __init__(self, thing: PlacedObject, task: Task, renderer: Renderer) -> None:
        self._thing, self._camera, self._renderer = thing, task.viewpoint.camera, renderer

    @cached_property
    def mask(self) -> Array:
        return self._renderer.outlines([self._thing], self._camera)[self._thing.instance]

    @cached_property
    def picture(self) -> Array:
        return self._renderer.paint([self._thing], self._camera).astype(int)

    def apart(self, other: _Seen) -> float:
        """Share of the pixels of either that differ; by outlines alone if these do enough."""
        either = self.mask | other.mask
        beyond = _share(self.mask ^ other.mask, either)
        if beyond >= LEAST_APART:
            return beyond
        differs = np.abs(self.picture - other.picture).max(axis=2) > _OTHER_COLOUR
        return _share(differs & either, either)


def _share(some: Array, all_: Array) -> float:
    return float(np.count_nonzero(some) / max(1, np.count_nonzero(all_)))
