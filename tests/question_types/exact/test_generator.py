"""A generated task of Exact, measured again from pictures alone."""

from __future__ import annotations

import itertools

import pytest

from probe.assets.library import Library
from probe.assets.tables import load_table
from probe.generation.generate import generate
from probe.generation.plan import plan
from probe.generation.result import TaskCandidate
from probe.question_types.exact.generator import REMOVALS
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
@pytest.mark.parametrize("removals", [1, 2])
def test_what_is_named_hides_the_answer_and_what_is_not_hides_something_too(
    library: Library, renderer: Renderer, removals: int
):
    made = next(
        it
        for seed in itertools.count(7_000, 1_000)
        if REMOVALS.of(plan("exact", seed)) == removals
        and isinstance(it := generate("exact", seed, library, renderer, TABLES), TaskCandidate)
    )
    task = made.task
    (target,) = task.targets
    assert len(task.named) == removals == task.certificate.measures["necessary"]
    for number in task.named:
        assert f"the {library[task.scene[number].object_id].name}" in task.question
    check_words(task, library)
    check_candidates(made, library)
    for twin in made.twins:
        first = shares(twin, library, renderer)
        assert first[target] <= 0.05 and min(first[n] for n in task.named) >= 0.50
        assert shares(twin.without(*task.named), library, renderer)[target] >= 0.60
    first = shares(task.scene, library, renderer)
    assert sum(share <= 0.05 for share in first.values()) >= 3
    again = generate("exact", task.seed, library, renderer, TABLES)
    assert isinstance(again, TaskCandidate) and again.task == task
