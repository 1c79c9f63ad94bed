"""A generated task of Ranked, measured again from pictures alone."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from probe.assets.library import Library
from probe.generation.generate import generate
from probe.generation.plan import plan
from probe.generation.result import TaskCandidate
from probe.generation.toppings import TOPPED
from probe.question_types.ranked.rules import RANKS
from probe.render.photograph import labels_of, load_scene
from probe.render.renderer import Renderer
from twins_again import TABLES, shares


def side(mask: np.ndarray) -> int:
    """Longer side of the box around what shows, in pixels."""
    return max(int(np.ptp(places)) + 1 for places in np.nonzero(mask))


@pytest.mark.slow
@pytest.mark.parametrize("form", RANKS)
def test_in_every_twin_the_candidate_has_the_rank_and_looks_it(
    library: Library, renderer: Renderer, form: str
):
    made = next(
        it
        for seed in itertools.count(5_000, 1_000)
        if plan("ranked", seed).form == form
        and not TOPPED.of(plan("ranked", seed))
        and isinstance(it := generate("ranked", seed, library, renderer, TABLES), TaskCandidate)
    )
    task, drawn = made.task, made.task.certificate.candidates
    assert task.cover is not None and len(task.targets) == 3
    assert task.certificate.measures["necessary"] == 3
    covers = task.scene.like(task.cover)
    texts = {option.letter: option.text for option in task.options}
    true_name = library[task.scene[task.targets[0]].object_id].name
    assert texts[task.answer] == (true_name if task.answer != "E" else "None of the above")
    for candidate, twin in zip(drawn, made.twins, strict=True):
        first = shares(twin, library, renderer)
        bare = shares(twin.without(*covers), library, renderer)
        shown = [n for n in bare if first[n] <= 0.05 and bare[n] >= 0.60]
        assert len(shown) == 3
        load_scene(renderer, twin, library)
        labels = labels_of(renderer, twin.without(*covers), twin.setup.camera("top"))
        order = sorted(shown, key=lambda it: side(labels == it), reverse=True)
        sizes = [max(library[twin[it].object_id].size) for it in order]
        assert sizes[0] >= 1.25 * sizes[1] and sizes[1] >= 1.25 * sizes[2]
        assert twin[order[RANKS.index(form)]].object_id == candidate
