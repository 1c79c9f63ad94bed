"""The movable check: whether the hand can take away what a question wants taken away.

A question that names removals, or whose answer lies under a cover, is fair only if the skills can
move these things on the table as it is. Each is tried by the skills alone, with a hand that errs.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence

import numpy as np

from probe.assets.library import Library
from probe.episodes.arm_skills import ArmSkills
from probe.episodes.evidence import TableSight
from probe.episodes.noise import NOISES
from probe.generation.necessary import NECESSARY
from probe.generation.visibility_rules import LITTLE
from probe.perception.oracle import NOTICED_PX
from probe.render.photograph import labels_of, load_scene
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from probe.station.simulated import SimulatedStation
from probe.tasks.grading import whereabouts
from probe.tasks.task import Task
from probe.toolshed.skills import Direction
from probe.world.world import World

TRIES, ENOUGH = 5, 3
"""Tries of each thing on the restored table, and how many have to work."""

FIRST_RUN = 2_000_000
"""Number of the first try's run: neither a benchmark's run nor the solvable check has its luck."""

ASIDE = 0.08
"""Metres by which a cover that was pushed must have gone aside."""

_PUSH = 0.15
_GRASPS = 2
_DIRECTIONS: tuple[Direction, ...] = ("up", "down", "left", "right")


def immovable(task: Task, library: Library, renderer: Renderer) -> str | None:
    """Which of the things that have to go can't be moved, for people; None if all can."""
    load_scene(renderer, task.scene, library)
    for instance, first in steps(task, renderer):
        worked = failed = 0
        while worked < ENOUGH and failed <= TRIES - ENOUGH:
            if _goes(task, instance, first, worked + failed, library, renderer):
                worked += 1
            else:
                failed += 1
        if worked < ENOUGH:
            name = library[task.scene[instance].object_id].name
            return f"{name} went in {worked} of {worked + failed} tries"
    return None


def necessary(task: Task, renderer: Renderer, gone: Collection[int] = ()) -> tuple[int, ...]:
    """Instances that have to go before the answer shows, topmost first.

    They are what the question wants removed, its cover, and whatever hides most of a target that
    doesn't show, once some are gone. The renderer must have the task's objects loaded.
    """
    scene, camera = task.scene.without(*gone), task.viewpoint.camera
    labels = labels_of(renderer, scene, camera)
    found = {*task.named, *([task.cover] if task.cover is not None else [])} - {*gone}
    alone = renderer.outlines([scene[target] for target in task.targets], camera)
    for target, mask in alone.items():
        over = np.bincount(labels[mask], minlength=target + 1)
        if over[target] > LITTLE[1] * over.sum():
            continue
        over[[0, *(other for other in alone if other < len(over))]] = 0
        if over.any():
            found.add(int(over.argmax()))
    return tuple(sorted(found, key=lambda number: -scene[number].pose.position[2]))


def steps(task: Task, renderer: Renderer) -> Iterator[tuple[int, Sequence[int]]]:
    """What has to go, each with what goes before it: covers under covers come after those.

    These, and what lies on a cover, are looked for where a certificate says how many have to go;
    older types have none. The renderer must have the task's objects loaded.
    """
    gone = list(necessary(task, renderer))
    deeper = NECESSARY in task.certificate.measures
    sight = TableSight(task.scene, renderer, task.setup.camera("top"))
    toppings = {it: tuple(sorted(sight.on_top([it]))) for it in gone} if deeper else {}
    highest = list(dict.fromkeys(above for over in toppings.values() for above in over))
    for instance in highest:
        yield instance, ()
    for instance in gone:
        if instance not in highest:
            yield instance, (*_over(task, instance), *toppings.get(instance, ()))
    if not deeper:
        return
    gone += highest
    while beneath := [n for n in necessary(task, renderer, gone) if n not in gone]:
        for instance in beneath:
            yield instance, tuple(gone)
        gone += beneath


def _goes(
    task: Task,
    instance: int,
    first: Sequence[int],
    number: int,
    library: Library,
    renderer: Renderer,
) -> bool:
    """Whether a thing leaves its place: into the basket, or if need be and it will do, aside."""
    station = SimulatedStation(World(task.scene, library), renderer, task.viewpoint.camera)
    skills = ArmSkills(NOISES["paper"], task.seed, FIRST_RUN + number)
    for other in first:
        station.take_away(other)
    for _ in range(_GRASPS):
        frame = station.observe(rgb=False)
        assert frame.labels is not None
        mask = frame.labels == instance
        if np.count_nonzero(mask) < NOTICED_PX:
            return instance not in task.named
        skills.grasp_and_remove(station, frame, mask, task.setup)
        if whereabouts(station.snapshot()[instance].pose, task.setup) == "basket":
            return True
    return instance not in task.named and _goes_aside(task, instance, number, station, skills)


def _over(task: Task, instance: int) -> Sequence[int]:
    """Other named things that stand higher: whoever follows the question removes them first."""
    height = task.scene[instance].pose.position[2]
    return [n for n in task.named if task.scene[n].pose.position[2] > height]


def _goes_aside(
    task: Task, instance: int, number: int, station: SimulatedStation, skills: ArmSkills
) -> bool:
    rng = generator(task.seed, "aside", instance, number)
    frame = station.observe(rgb=False)
    assert frame.labels is not None
    mask = frame.labels == instance
    if not mask.any():
        return True
    skills.push(station, frame, mask, _DIRECTIONS[int(rng.integers(4))], _PUSH, task.setup)
    start, now = task.scene[instance].pose.position, station.snapshot()[instance].pose.position
    return math.dist(start, now) > ASIDE
