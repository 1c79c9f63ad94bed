"""The tasks of a suite on tables that differ a little: another top, another view, small moves."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from probe.assets.library import Library
from probe.assets.tables import table_ids
from probe.episodes.conditions import Conditions
from probe.generation.marked import widest
from probe.generation.result import Rejected
from probe.render.photograph import labels_of, load_scene, measure
from probe.render.renderer import Renderer
from probe.runs.bands import broken_rule
from probe.runs.jitter import jitter
from probe.runs.viewpoints import camera_of
from probe.scene.perturb import other_table
from probe.scene.seeds import generator
from probe.tasks.task import Mark, Task


@dataclass(frozen=True)
class VariedTask:
    """A task under other conditions.

    Attributes:
        task: With its scene, its marks and their places in the question as they are now; its
            certificate is still of what was frozen.
        note: What is amiss, in words: a rule that no longer holds, things that couldn't be moved.
    """

    task: Task
    note: str | None = None


def changes_scenes(conditions: Conditions) -> bool:
    """Whether tasks have to be varied; light alone leaves them as they are."""
    return changes_labels(conditions) or conditions.table != "own"


def changes_labels(conditions: Conditions) -> bool:
    """Whether other pixels show other things than when the tasks were frozen."""
    return conditions.camera != "fixed" or conditions.pose_jitter > 0


def vary(
    tasks: Sequence[Task], conditions: Conditions, library: Library, renderer: Renderer
) -> Iterator[VariedTask]:
    """Each task under other conditions, in order; its own seed draws how they differ."""
    for task in tasks:
        scene, note = task.scene, None
        if conditions.table == "other":
            tables, rng = table_ids(library.assets), generator(task.seed, "table")
            scene = other_table(scene, tables, rng)
        if conditions.pose_jitter:
            moved = jitter(scene, conditions.pose_jitter, library)
            note = None if moved else "its things can't be moved without something giving way"
            scene = moved or scene
        made = VariedTask(replace(task, scene=scene), note)
        yield (
            _seen_anew(made, conditions, library, renderer) if changes_labels(conditions) else made
        )


def _seen_anew(
    made: VariedTask, conditions: Conditions, library: Library, renderer: Renderer
) -> VariedTask:
    """Measured in the new view, with marks where they belong in it."""
    task, camera = made.task, camera_of(made.task, conditions.camera)
    load_scene(renderer, task.scene, library)
    notes = [made.note, broken_rule(task, measure(renderer, task.scene, camera))]
    if task.marks:
        labels = labels_of(renderer, task.scene, camera)
        try:
            marks = tuple(replace(it, point=widest(labels == it.instance)) for it in task.marks)
            task = replace(task, marks=marks, question=with_places(task.question, marks))
        except Rejected as failure:
            notes.append(str(failure))
    return VariedTask(task, "; ".join(note for note in notes if note) or None)


def with_places(question: str, marks: Sequence[Mark]) -> str:
    """The question with the marks' new pixels."""
    for mark in marks:
        place = f"{mark.letter} at ({mark.point[0]}, {mark.point[1]})"
        question = re.sub(rf"\b{mark.letter} at \(\d+, \d+\)", place, question)
    return question
