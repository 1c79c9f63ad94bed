"""The scripted teacher says the same episode in other words."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from painted_teacher import SIZE, taught
from probe.agents.phrases import PhraseBook
from probe.episodes.turns import Call
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.rephrasing import rephrased


def unspoken(record):
    return [replace(step, call=replace(step.call, words="")) for step in record.steps]


def test_asked_again_it_says_the_same():
    record = taught()
    assert [step.call.name for step in record.steps[-3:]] == [
        "grasp_and_remove", "perceive_scene", "answer_question",
    ]  # fmt: skip
    assert rephrased(SIZE, record).untimed() == record.untimed()


def test_sizes_are_said_as_students_read_them():
    """120 of 1,024 pixels are 117 thousandths."""
    assert "[117, 59]" in taught().steps[-1].call.words


def test_other_phrases_change_no_call():
    record = taught()
    some = [rephrased(SIZE, record, PhraseBook(np.random.default_rng(n))) for n in range(6)]
    assert all(unspoken(it) == unspoken(record) for it in some)
    assert len({it.steps[0].call.words for it in some}) > 2


def test_whose_words_arent_known_is_left_alone():
    record = taught()
    with pytest.raises(NotCertain, match="isn't the scripted one"):
        rephrased(SIZE, replace(record, agent="a-model"))
    other = replace(record.steps[0], call=Call.of("find_object", {"description": "mug"}))
    with pytest.raises(NotCertain, match="would do something else today"):
        rephrased(SIZE, replace(record, steps=(other, *record.steps[1:])))
    longer = replace(record, steps=(*record.steps, record.steps[0]))
    with pytest.raises(NotCertain, match="would do something else today"):
        rephrased(SIZE, longer)
