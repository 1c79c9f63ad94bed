"""A generated task of Nested, measured again from pictures alone."""

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
def test_only_taking_both_covers_away_tells_and_so_it_is_of_every_twin(
    library: Library, renderer: Renderer
):
    made = next(
        it
        for seed in itertools.count(3_000)
        if isinstance(it := generate("nested", seed, library, renderer, TABLES), TaskCandidate)
    )
    task = made.task
    (target,), outer = task.targets, task.cover
    assert outer is not None and task.certificate.measures["necessary"] == 2
    assert task.subject == library[task.scene[outer].object_id].name
    assert task.subject in task.question
    check_words(task, library)
    check_candidates(made, library)
    for twin in made.twins:
        first = shares(twin, library, renderer)
        once = shares(twin.without(outer), library, renderer)
        (inner,) = [n for n in once if first[n] <= 0.05 and once[n] >= 0.60]
        twice = shares(twin.without(outer, inner), library, renderer)
        assert first[target] <= 0.05 and once[target] <= 0.05 and twice[target] >= 0.60
        assert first[outer] >= 0.30
        assert max(twice[n] - first[n] for n in twice if n != target) <= 0.20
    again = generate("nested", task.seed, library, renderer, TABLES)
    assert isinstance(again, TaskCandidate) and again.task == task
