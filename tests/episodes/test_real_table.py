"""The whole line with the real arm: scripted calls, physics, record, replay elsewhere, pictures."""

import subprocess
import sys

import numpy as np
import pytest

from episodes import real_table
from probe.agents.scripted import Scripted
from probe.episodes.files import line_of, write_records
from probe.episodes.run import run_episode
from probe.episodes.turns import Question
from probe.render.photograph import photograph
from probe.render.renderer import Renderer

QUESTION = Question("?", (("A", "black pen"), ("B", "white cube"), ("E", "None of the above")))


@pytest.fixture(scope="module")
def renderer():
    with Renderer() as it:
        yield it


@pytest.fixture(scope="module", params=["grasp", "push"])
def record(renderer, request):
    station, tools = real_table.fresh(renderer)
    agent = Scripted("beneath", "red lid", np.random.default_rng(0), request.param)
    return run_episode("real", QUESTION, agent, tools, station, agent_name=request.param)


@pytest.mark.slow
def test_the_arm_uncovers_what_the_question_is_about(record):
    assert record.answer and record.answer.choice == "B" and record.manipulations >= 1
    start, end = record.scenes[0], record.scenes[-1]
    moved = np.subtract(end[1].pose.position, start[1].pose.position)
    assert np.linalg.norm(moved) > 0.05
    assert end[2] == start[2]
    assert "white" not in record.steps[0].text


@pytest.mark.slow
def test_another_process_replays_the_same_bytes(record, tmp_path):
    path = tmp_path / "records.jsonl"
    write_records(path, [record])
    again = subprocess.run(
        [sys.executable, real_table.__file__, str(path)], capture_output=True, check=True
    )
    assert again.stdout == line_of(record, timed=False)


@pytest.mark.slow
def test_pictures_are_drawn_from_the_record_alone(record, renderer):
    station, _ = real_table.fresh(renderer)
    start, end = (photograph(renderer, record.scenes[place]) for place in (0, -1))
    first = station.observe(rgb=True)
    assert start.rgb is not None and np.array_equal(start.rgb, first.rgb)
    assert end.labels is not None and not np.array_equal(end.labels, first.labels)
