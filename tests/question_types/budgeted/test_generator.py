"""A generated task of Budgeted, measured again from pictures alone."""

from __future__ import annotations

import itertools

import pytest

from probe.assets.library import Library
from probe.generation.generate import generate
from probe.generation.result import TaskCandidate
from probe.render.renderer import Renderer
from twins_again import TABLES, check_turns, check_words, shares


@pytest.mark.slow
def test_in_every_twin_one_of_five_covers_hides_what_is_asked_for(
    library: Library, renderer: Renderer
):
    made = next(
        it
        for seed in itertools.count(5_000, 1_000)
        if isinstance(it := generate("budgeted", seed, library, renderer, TABLES), TaskCandidate)
    )
    task = made.task
    names = task.subject.split(", ")
    objects = task.scene.objects
    covers = [it.instance for it in objects if library[it.object_id].name in names]
    assert len(covers) == 5 and task.cover in covers and task.manipulations == 3
    assert task.certificate.measures["necessary"] == 1
    check_words(task, library)
    check_turns(made)
    lengths = [max(library[it].size) for it in task.certificate.candidates]
    assert max(lengths) <= 1.1 * min(lengths) + 1e-9
    for twin in made.twins:
        first = shares(twin, library, renderer)
        shown = set()
        for cover in covers:
            after = shares(twin.without(cover), library, renderer)
            (found,) = [n for n in after if first[n] <= 0.05 and after[n] >= 0.60]
            shown.add(found)
        assert len(shown) == 5 and task.targets[0] in shown
        sizes = {n: max(library[twin[n].object_id].size) for n in shown}
        long = sizes.pop(task.targets[0])
        assert all(long >= 1.25 * size for size in sizes.values())
    again = generate("budgeted", task.seed, library, renderer, TABLES)
    assert isinstance(again, TaskCandidate) and again.task == task
