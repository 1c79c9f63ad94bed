"""A generated task of Nested, measured again from pictures alone."""

from __future__ import annotations

import itertools

import pytest

from probe.assets.library import Library
from probe.generation.generate import generate
from probe.generation.result import TaskCandidate
from probe.render.renderer import Renderer
from twins_again import TABLES, check_candidates, check_words, shares


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
