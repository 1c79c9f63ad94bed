"""Random histories: whatever is done to a table, the truth about its start stays what it was."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace

from probe.agents.random import Random
from probe.assets.library import Library
from probe.episodes.circumstances import Circumstances
from probe.episodes.grading import grade_episode
from probe.episodes.play import play
from probe.episodes.record import EpisodeRecord
from probe.render.photograph import labels_of
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.seeds import generator
from probe.tasks.grading import whereabouts
from probe.tasks.task import Task
from probe.toolshed.result import Answer

HISTORIES = 3


def histories(task: Task, library: Library, renderer: Renderer) -> Iterator[EpisodeRecord]:
    """Episodes of an agent that does anything."""
    for number in range(HISTORIES):
        rng = generator(task.seed, "history", number)
        yield play(task, Random(rng), "random", library, renderer, Circumstances(number))


def history_problems(task: Task, record: EpisodeRecord, renderer: Renderer) -> Iterator[str]:
    """What a history changed that it mustn't; the renderer must have the task's objects."""
    first, last = (Counter(o.object_id for o in s.objects) for s in (task.scene, record.scenes[-1]))
    if first != last:
        yield "things came or went"
    places = Counter(whereabouts(o.pose, task.scene.setup) for o in record.scenes[-1].objects)
    if sum(places.values()) != len(task.scene.objects):
        yield "things are neither on the table, nor in the basket, nor off both"
    labels = labels_of(renderer, record.scenes[-1], record.viewpoint.camera)
    for option in task.options:
        answered = replace(record, answer=Answer(option.letter, None))
        grade = grade_episode(task, answered, labels)
        if grade.letter_correct != (option.letter == task.answer):
            yield f"afterwards {option.letter} is graded otherwise"


def is_reachable(task: Task, last: Scene) -> bool:
    """Whether everything that decides is still on the table or in the basket."""
    return all(
        whereabouts(last[number].pose, last.setup) != "off the table" for number in task.targets
    )
