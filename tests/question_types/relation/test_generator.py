"""A generated task of Relation, measured again from pictures alone."""

from __future__ import annotations

import itertools
import math
from collections import Counter

import numpy as np
import pytest

from probe.assets.library import Library
from probe.generation.generate import generate
from probe.generation.plan import plan
from probe.generation.result import TaskCandidate
from probe.render.photograph import labels_of, load_scene
from probe.render.renderer import Renderer
from twins_again import TABLES, shares


def turned_to(one: np.ndarray, other: np.ndarray, middle: np.ndarray) -> float:
    """Degrees from one place to another around a middle, clockwise in the picture."""
    angles = [math.atan2(v, u) for u, v in (one - middle, other - middle)]
    return math.degrees(angles[1] - angles[0]) % 360


@pytest.mark.slow
@pytest.mark.parametrize("form", ["clockwise", "anticlockwise"])
def test_in_every_twin_the_candidate_is_next_to_what_is_named(
    library: Library, renderer: Renderer, form: str
):
    made = next(
        it
        for seed in itertools.count(5_000, 1_000)
        if plan("relation", seed).form == form
        and isinstance(it := generate("relation", seed, library, renderer, TABLES), TaskCandidate)
    )
    task, drawn = made.task, made.task.certificate.candidates
    assert task.cover is not None and len(task.targets) == 2
    assert task.certificate.measures["necessary"] == 2
    named = task.scene[task.targets[1]].object_id
    assert library[named].name in task.question and named not in drawn
    texts = {option.letter: option.text for option in task.options}
    true_name = library[task.scene[task.targets[0]].object_id].name
    assert texts[task.answer] == (true_name if task.answer != "E" else "None of the above")
    covers, beside = task.scene.like(task.cover), Counter[str]()
    for candidate, twin in zip(drawn, made.twins, strict=True):
        first = shares(twin, library, renderer)
        bare = shares(twin.without(*covers), library, renderer)
        shown = [n for n in bare if first[n] <= 0.05 and bare[n] >= 0.60]
        load_scene(renderer, twin, library)
        labels = labels_of(renderer, twin.without(*covers), twin.setup.camera("top"))
        at = {twin[it].object_id: np.argwhere(labels == it).mean(axis=0)[::-1] for it in shown}
        assert len(at) == 3
        way = turned_to(at[named], at[candidate], np.mean(list(at.values()), axis=0))
        assert (60 < way < 180) if form == "clockwise" else (180 < way < 300)
        (other,) = set(at) - {named, candidate}
        beside[other] += 1
    assert beside == Counter(drawn)
