"""What is told of a practice question."""

from __future__ import annotations

import io

import numpy as np
import pytest
from PIL import Image

from probe.assets.library import open_library
from probe.interfaces.human.feedback import explain, verdict_of
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from run_folders import DEMO, episode
from task_examples import FIND

BENEATH = DEMO["beneath-2da3b9f2"]


@pytest.mark.parametrize(
    ("chosen", "outcome", "words"),
    [
        ("B", "right", "Right: B, lime."),
        ("A", "wrong", "Wrong: you answered A, plum. Right is B, lime."),
        (None, "unanswered", "You gave no answer. Right is B, lime."),
        ("B", "no point", "is right (B, lime), but you pointed at nothing: that is wrong."),
        ("B", "missed", "is right (B, lime), but the point isn't on it: that is wrong."),
        ("B", "lost", "is right (B, lime), but it isn't on the table any more: that is wrong."),
        ("B", "covered", "but too little of it shows to be pointed at: that is wrong."),
    ],
)
def test_the_verdict_says_what_was_answered_and_what_is_right(chosen, outcome, words):
    assert verdict_of(FIND, chosen, outcome).endswith(words)


@pytest.mark.slow
def test_the_pictures_show_what_was_hidden_and_outline_it(cache):
    things = open_library("procedural", None, cache)
    with Renderer(cache / "light") as renderer:
        load_scene(renderer, BENEATH.scene, things, things.table(BENEATH.scene.table))
        told = explain(BENEATH, episode(BENEATH, right=False), things, renderer)
    assert not told.correct
    assert told.verdict == "Wrong: you answered A, tomato. Right is E, None of the above."
    assert told.reason == (
        "The second picture shows the same table without the clay flower pot. "
        "The answer rests on what is outlined: the lip balm."
    )
    start, bare = (np.asarray(Image.open(io.BytesIO(each))).astype(int) for each in told.pictures)
    changed = np.abs(start - bare).max(axis=2) > 40
    rows, columns = np.nonzero(changed)
    assert rows.min() > 316 - 25 and rows.max() < 535 + 25, "the pot's place alone"
    assert columns.min() > 443 - 25 and columns.max() < 662 + 25
    ink = (bare == (255, 40, 200)).all(axis=2)
    assert 100 < ink.sum() < 2000 and not (start == (255, 40, 200)).all(axis=2).any()
