"""`probe human` with real physics and pictures: questions solved in a browser."""

import os
import re
import signal
import subprocess
import sys

import psutil
import pytest

from browser import Browser, chromium
from interfaces.human.page import AtPage
from probe.agents.scripted import Scripted
from probe.assets.library import open_library
from probe.episodes.files import read_records
from probe.episodes.grading import question_of
from probe.episodes.play import play, score
from probe.episodes.turns import Turn
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from probe.tasks.suite import selection
from probe.tasks.suite_file import packaged_suite, write_suite
from probe.toolshed.result import ToolResult

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(chromium() is None, reason="there is no Chromium"),
]

V1 = packaged_suite("v1")
TASKS = tuple(
    next(task for task in V1.tasks if task.id == name)
    for name in ("find-6e1e81c8", "reduce-315f5ffc", "beneath-2f08b6d9")
)
"""One whose answer has a point, one that names what to remove, one with a cover."""


@pytest.fixture
def server(tmp_path, monkeypatch):
    """Starts the command over three tasks; gives its port."""
    monkeypatch.delenv("PROBE_ASSETS", raising=False)
    suite = tmp_path / "some.json"
    write_suite(suite, selection(V1, TASKS, "some"))
    told = ("human", str(suite), "--out", str(tmp_path / "out"), "--port", "0")
    command = [sys.executable, "-m", "probe", *told]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=os.environ) as process:
        assert process.stdout is not None
        found = re.search(r":(\d+)/", process.stdout.readline())
        assert found is not None
        yield int(found[1])
        workers = psutil.Process(process.pid).children(recursive=True)
        process.send_signal(signal.SIGINT)
        assert "the same command goes on" in process.stdout.read()
        assert process.wait(60) == 0
    assert not psutil.wait_procs(workers, timeout=20)[1]


def scripted(task):
    return Scripted(task.question_type, task.subject, generator(task.seed, "run", "scripted", 0))


def solve(page, task):
    """Let the scripted agent see and act through the page alone."""
    agent, turns = scripted(task), list[Turn]()
    while call := agent.act(question_of(task), tuple(turns)):
        turns.append(Turn(call, ToolResult(page.do(call))))
    if turns[-1].call.name != "answer_question":
        page.give_up()


def test_a_person_can_do_what_an_agent_can(server, cache, tmp_path):
    with Browser() as browser:
        page = AtPage(browser, server)
        page.begin("Ada")
        for task in TASKS:
            page.wait_for_table()
            assert browser.run("question.textContent") == task.question
            solve(page, task)
            if task is not TASKS[-1]:
                page.click("#next")
        assert not browser.complaints
    records = read_records(tmp_path / "out" / "records.jsonl")
    assert [record.task for record in records] == [task.id for task in TASKS]
    things = open_library("procedural", None, cache)
    solved = set[str]()
    with Renderer() as renderer:
        for task, record in zip(TASKS, records, strict=True):
            near = play(task, scripted(task), "Ada", things, renderer)
            correct = score(task, record, renderer).correct
            assert correct == score(task, near, renderer).correct
            solved |= {task.question_type} if correct else set()
            # A click is a pixel or so off, and the page sends whole numbers without a point.
            assert [_seen(step) for step in record.steps[:-1]] == [
                _seen(step) for step in near.steps[:-1]
            ]
    assert solved == {task.question_type for task in TASKS}


def _seen(step):
    return step.call.name, step.call.values, step.status, step.text, step.after
