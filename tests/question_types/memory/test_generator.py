"""A generated task of Memory, measured again from pictures alone."""

from __future__ import annotations

import itertools

import pytest

from probe.assets.library import Library
from probe.generation.generate import generate
from probe.generation.result import TaskCandidate
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from twins_again import TABLES, shares


def hidden_by(cover: int, items: list[int], scene: Scene, library: Library, renderer: Renderer):
    """Object ids of those of some things that can't be seen beside this one alone."""
    seen = shares(scene.only(cover, *items), library, renderer)
    return [scene[number].object_id for number in items if seen[number] <= 0.05]


@pytest.mark.slow
def test_each_candidate_had_its_turn_under_each_cover(library: Library, renderer: Renderer):
    made = next(
        it
        for seed in itertools.count(7_000, 1_000)
        if isinstance(it := generate("memory", seed, library, renderer, TABLES), TaskCandidate)
    )
    task, drawn = made.task, list(made.task.certificate.candidates)
    assert task.cover in task.named and len(task.named) == 3
    assert task.certificate.measures["necessary"] == 3
    names = [library[task.scene[number].object_id].name for number in task.named]
    assert f"the {names[0]}, the {names[1]} and the {names[2]}" in task.question
    texts = {option.letter: option.text for option in task.options}
    true_name = library[task.scene[task.targets[0]].object_id].name
    assert texts[task.answer] == (true_name if task.answer != "E" else "None of the above")
    beneath = dict[int, list[str]]((number, []) for number in task.named)
    for twin in made.twins:
        first = shares(twin, library, renderer)
        bare = shares(twin.without(*task.named), library, renderer)
        shown = [number for number in bare if first[number] <= 0.05 and bare[number] >= 0.60]
        assert len(shown) == 3 and min(first[number] for number in task.named) >= 0.50
        for cover in task.named:
            beneath[cover] += hidden_by(cover, shown, twin, library, renderer)
    assert beneath[task.cover] == drawn
    assert all(sorted(found) == sorted(drawn) for found in beneath.values())
