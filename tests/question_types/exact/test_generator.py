"""A generated task of Exact, measured again from pictures alone."""

from __future__ import annotations

import itertools

import pytest

from probe.assets.library import Library
from probe.generation.generate import generate
from probe.generation.plan import plan
from probe.generation.result import TaskCandidate
from probe.question_types.exact.generator import REMOVALS
from probe.render.renderer import Renderer
from twins_again import TABLES, check_candidates, check_words, shares


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
