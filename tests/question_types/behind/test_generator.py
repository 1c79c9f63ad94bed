"""A generated task of Behind, measured again from pictures alone."""

from __future__ import annotations

import itertools

import pytest

from probe.assets.library import Library
from probe.assets.tables import load_table
from probe.generation.generate import generate
from probe.generation.result import TaskCandidate
from probe.render.photograph import load_scene, measure
from probe.render.renderer import Renderer
from probe.scene.cameras import View
from probe.scene.scene import Scene

TABLES = ("oak_planks",)


def shares(scene: Scene, view: View, library: Library, renderer: Renderer) -> dict[int, float]:
    load_scene(renderer, scene, library, load_table(TABLES[0], None))
    seen = measure(renderer, scene, scene.setup.camera(view))
    return {number: it.visible_px / it.alone_px for number, it in seen.items()}


@pytest.mark.slow
def test_one_alone_is_behind_it_and_so_is_every_twin(library: Library, renderer: Renderer):
    made = next(
        it
        for seed in itertools.count(11_000)
        if isinstance(it := generate("behind", seed, library, renderer, TABLES), TaskCandidate)
    )
    task = made.task
    (target,), front = task.targets, task.cover
    assert front is not None and task.camera == "front"
    names = [library[placed.object_id].name for placed in task.scene.objects]
    true_name = library[task.scene[target].object_id].name
    assert task.subject == library[task.scene[front].object_id].name
    assert task.subject in task.question and true_name not in task.question
    assert {option.text for option in task.options} & set(names) <= {true_name}
    texts = {option.letter: option.text for option in task.options}
    assert texts[task.answer] == (true_name if task.answer != "E" else "None of the above")
    assert len(made.twins) == 5 and task.scene in made.twins
    for twin, object_id in zip(made.twins, task.certificate.candidates, strict=True):
        assert twin[target].object_id == object_id
        before = shares(twin, "front", library, renderer)
        after = shares(twin.without(front), "front", library, renderer)
        above = shares(twin, "top", library, renderer)
        assert before[target] <= 0.05 and before[front] >= 0.50
        assert after[target] >= 0.60 and above[target] >= 0.50
        assert max(after[n] - before[n] for n in after if n != target) <= 0.20
    again = generate("behind", task.seed, library, renderer, TABLES)
    assert isinstance(again, TaskCandidate) and again.task == task
