"""A generated task of Behind, measured again from pictures alone."""

from __future__ import annotations

import itertools

import pytest

from probe.assets.library import Library
from probe.generation.generate import generate
from probe.generation.result import TaskCandidate
from probe.render.renderer import Renderer
from twins_again import TABLES, check_words, shares


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
    assert task.subject == library[task.scene[front].object_id].name
    assert task.subject in task.question
    check_words(task, library)
    assert len(made.twins) == 5 and task.scene in made.twins
    for twin, object_id in zip(made.twins, task.certificate.candidates, strict=True):
        assert twin[target].object_id == object_id
        before = shares(twin, library, renderer, "front")
        after = shares(twin.without(front), library, renderer, "front")
        above = shares(twin, library, renderer)
        assert before[target] <= 0.05 and before[front] >= 0.50
        assert after[target] >= 0.60 and above[target] >= 0.50
        assert max(after[n] - before[n] for n in after if n != target) <= 0.20
