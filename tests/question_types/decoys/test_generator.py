"""A generated task of Decoys, measured again from pictures alone."""

from __future__ import annotations

import itertools

import pytest

from probe.assets.library import Library
from probe.generation.generate import generate
from probe.generation.plan import plan
from probe.generation.result import TaskCandidate
from probe.generation.toppings import TOPPED
from probe.render.renderer import Renderer
from twins_again import TABLES, check_candidates, check_words, shares


@pytest.mark.slow
def test_each_of_three_like_covers_hides_one_thing_in_every_twin(
    library: Library, renderer: Renderer
):
    made = next(
        it
        for seed in itertools.count(5_000, 1_000)
        if not TOPPED.of(plan("decoys", seed))
        and isinstance(it := generate("decoys", seed, library, renderer, TABLES), TaskCandidate)
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
