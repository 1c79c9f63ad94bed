"""The scripted teacher says the same episode in other words."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from probe.agents.phrases import PhraseBook
from probe.episodes.grading import question_of
from probe.episodes.participation import ModelReply, Participation
from probe.episodes.record import EpisodeRecord
from probe.episodes.run import run_episode
from probe.episodes.turns import Call
from probe.perception.oracle import Oracle
from probe.scene.setup import UR5_TABLE
from probe.tasks.suite_file import packaged_suite
from probe.toolshed.toolshed import Toolshed
from probe.train.collect.teacher import TEACHER, teacher
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.rephrasing import rephrased
from tabletops import Block, Obedient, PaintedStation, spec

SIZE = next(task for task in packaged_suite("v1").tasks if task.question_type == "size")
SPECS = {1: spec("red mug", "red"), 2: spec("blue book", "blue"), 3: spec("white ball", "white")}


def taught() -> EpisodeRecord:
    """The teacher compares two marked things at a painted table; a ball lies on one of them."""
    (a, b) = (mark.point for mark in SIZE.marks)
    station = PaintedStation(
        [
            Block(1, (a[0] - 130, a[1] - 50, a[0] + 19, a[1] + 49), 0.02),
            Block(2, (b[0] - 60, b[1] - 30, b[0] + 59, b[1] + 29), 0.02, (30, 60, 150)),
            Block(3, (a[0] - 180, a[1] - 100, a[0] - 11, a[1] + 99), 0.08, (240, 240, 240)),
        ]
    )
    tools = Toolshed(station, Oracle(SPECS), Obedient(), UR5_TABLE, pictures=False)
    agent = teacher(SIZE, 0, "0-1000")
    record = run_episode(SIZE.id, question_of(SIZE), agent, tools, station, agent_name=TEACHER)
    replies = tuple(ModelReply(1) for _ in record.steps)
    return replace(record, participation=Participation("text-only", "0-1000", replies))


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
