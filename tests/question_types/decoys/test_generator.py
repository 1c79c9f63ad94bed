"""A generated task of Decoys, measured again from pictures alone."""

from __future__ import annotations

import itertools

import pytest

from probe.assets.library import Library
from probe.assets.tables import load_table
from probe.generation.generate import generate
from probe.generation.result import TaskCandidate
from probe.render.photograph import load_scene, measure
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.tasks.task import Task

TABLES = ("oak_planks",)


def shares(scene: Scene, library: Library, renderer: Renderer) -> dict[int, float]:
    load_scene(renderer, scene, library, load_table(TABLES[0], None))
    seen = measure(renderer, scene)
    return {number: it.visible_px / it.alone_px for number, it in seen.items()}


def check_words(task: Task, library: Library) -> None:
    """The question names what it is about and not the answer; one option at most is there."""
    names = [library[placed.object_id].name for placed in task.scene.objects]
    true_name = library[task.scene[task.targets[0]].object_id].name
    assert true_name not in task.question
    assert {option.text for option in task.options} & set(names) <= {true_name}
    texts = {option.letter: option.text for option in task.options}
    assert texts[task.answer] == (true_name if task.answer != "E" else "None of the above")


def check_candidates(made: TaskCandidate, library: Library) -> None:
    """Each had its turn, and length, width and height tell nothing."""
    drawn, (target,) = made.task.certificate.candidates, made.task.targets
    assert [twin[target].object_id for twin in made.twins] == list(drawn)
    assert made.task.scene in made.twins
    sizes = [(*sorted(library[it].size[:2]), library[it].size[2]) for it in drawn]
    for sides in zip(*sizes, strict=True):
        assert max(sides) <= 1.1 * min(sides) + 1e-9


@pytest.mark.slow
def test_each_of_three_like_covers_hides_one_thing_in_every_twin(
    library: Library, renderer: Renderer
):
    made = next(
        it
        for seed in itertools.count(5_000, 1_000)
        if isinstance(it := generate("decoys", seed, library, renderer, TABLES), TaskCandidate)
    )
    task = made.task
    assert task.cover is not None
    like = task.scene[task.cover].object_id
    covers = [it.instance for it in task.scene.objects if it.object_id == like]
    assert len(covers) == 3 and task.subject == library[like].name
    check_words(task, library)
    check_candidates(made, library)
    assert task.certificate.measures["necessary"] == (3 if task.answer == "E" else 1)
    for twin in made.twins:
        first = shares(twin, library, renderer)
        shown = set()
        for cover in covers:
            after = shares(twin.without(cover), library, renderer)
            (found,) = [n for n in after if first[n] <= 0.05 and after[n] >= 0.60]
            assert first[cover] >= 0.50
            shown.add(found)
        assert len(shown) == 3 and task.targets[0] in shown
    again = generate("decoys", task.seed, library, renderer, TABLES)
    assert isinstance(again, TaskCandidate) and again.task == task
