"""What a page is told of a table while an agent works at it."""

from __future__ import annotations

import io
import os

import numpy as np
from PIL import Image

from interfaces.painted import BLOCKS, QUESTION, SPECS
from probe.episodes.run import run_episode
from probe.episodes.turns import Call, Question
from probe.perception.oracle import Oracle
from probe.runs.live import LiveDocument, LiveTable, Watched
from probe.scene.setup import UR5_TABLE
from probe.toolshed.toolshed import Toolshed
from tabletops import Obedient, PaintedStation, paint

CALLS = (
    Call.of("find_object", {"description": "white ball"}, "Where is the ball?"),
    Call.of("grasp_and_remove", {"object_id": "object_1"}),
    Call.of("teleport"),
    Call.of("answer_question", {"choice": "B"}),
)


class _Reader:
    """Makes its calls, and looks each time what has been written down and what it is shown."""

    def __init__(self, folder):
        self.path = folder / f"{os.getpid()}.json"
        self.read: list[LiveDocument] = []
        self.seen: list[bool] = []

    def act(self, question, history):
        self.read.append(LiveDocument.model_validate_json(self.path.read_bytes()))
        pictures = [question.picture, *(turn.result.picture for turn in history)]
        self.seen.append(any(picture is not None for picture in pictures))
        return CALLS[len(history)]


def played(folder, *, pictures):
    station = PaintedStation(BLOCKS)
    tools = Toolshed(station, Oracle(SPECS), Obedient(), UR5_TABLE)
    question = Question(QUESTION.text, QUESTION.options, tools.first_picture())
    reader = _Reader(folder)
    agent = Watched(reader, LiveTable(folder), "duck-0815", 2, pictures=pictures)
    record = run_episode("duck-0815", question, agent, tools, station, agent_name="reader")
    return reader, record


def test_each_call_is_written_down_before_the_next(tmp_path):
    reader, record = played(tmp_path, pictures=True)
    first, *_, last = reader.read
    assert (first.task, first.run, first.question) == ("duck-0815", 2, QUESTION.text)
    assert first.options == QUESTION.options and (first.steps, first.pictures) == ([], 1)
    assert [len(said.steps) for said in reader.read] == [0, 1, 2, 3]
    told = [(step.tool, step.words, step.status, step.text) for step in last.steps]
    assert told == [(s.call.name, s.call.words, s.status, s.text) for s in record.steps[:-1]]
    end = LiveDocument.model_validate_json(reader.path.read_bytes())
    assert (end.steps[-1].tool, end.steps[-1].status) == ("answer_question", None)
    picture = np.asarray(Image.open(io.BytesIO(reader.path.with_suffix(".jpg").read_bytes())))
    left = paint([block for block in BLOCKS if block.instance != 702]).rgb
    assert np.abs(picture.astype(int) - left).mean() < 3
    assert all(reader.seen)


def test_an_agent_that_looks_at_no_pictures_gets_none(tmp_path):
    reader, record = played(tmp_path, pictures=False)
    assert not any(reader.seen) and reader.path.with_suffix(".jpg").exists()
    assert [step.call for step in record.steps] == list(CALLS)


def test_the_next_episode_takes_the_place_of_the_one_before(tmp_path):
    played(tmp_path, pictures=True)
    reader, _ = played(tmp_path, pictures=True)
    assert reader.read[0].steps == [] and len(list(tmp_path.iterdir())) == 2
