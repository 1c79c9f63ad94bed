"""`probe serve` with real physics and real pictures, played by the official client."""

import os
import subprocess
import sys
from contextlib import ExitStack
from dataclasses import replace

import numpy as np
import psutil
import pytest

from interfaces import doomed
from interfaces.clients import Player, Reply, playing, wired
from interfaces.test_mcp_server import texts
from probe.agents.scripted import Scripted
from probe.assets.library import open_library
from probe.episodes.conditions import NO_DIALS
from probe.episodes.files import line_of, read_records
from probe.episodes.grading import question_of
from probe.episodes.noise import Noise
from probe.episodes.play import play, replay_afresh, score
from probe.episodes.replay import differences
from probe.episodes.turns import Question, Turn
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from probe.tasks.headline import HeadlineErrors
from probe.tasks.suite import part
from probe.tasks.suite_file import demo_suite, write_suite
from probe.toolshed.result import ToolResult

pytestmark = pytest.mark.slow

MUG = "beneath-8af85510"


@pytest.fixture(scope="module")
def library(cache):
    return open_library("procedural", None, cache)


@pytest.fixture(scope="module")
def task():
    return next(task for task in demo_suite().tasks if task.id == MUG)


@pytest.fixture(scope="module")
def server(task, tmp_path_factory):
    """A function from a folder for records to a command that serves the mug's task."""
    suite = tmp_path_factory.mktemp("suite") / "suite.json"
    write_suite(suite, part(demo_suite(), task))
    told = ("-m", "probe", "serve", "--suite", suite, "--task", MUG, "--out")
    return lambda out, *more: (*told, out, *more)


@pytest.fixture(autouse=True)
def surroundings(monkeypatch):
    monkeypatch.delenv("PROBE_ASSETS", raising=False)


def scripted(task):
    return Scripted(task.question_type, task.subject, generator(task.seed, "run", "scripted", 0))


class ByMcp:
    """Puts an agent of ours on the far side of the protocol."""

    def __init__(self, player: Player, question: Question) -> None:
        self.player = player
        self.question = question
        self.turns: list[Turn] = []
        self.replies: list[Reply] = []

    def play(self, agent: Scripted) -> None:
        while call := agent.act(self.question, tuple(self.turns)):
            reply = self.player.call(call.name, **call.values)
            self.replies.append(reply)
            self.turns.append(Turn(call, ToolResult(reply.text)))


def test_an_episode_over_mcp_is_the_benchmarks_episode(server, task, library, tmp_path):
    with playing(*server(tmp_path, "--agent", "scripted"), env=dict(os.environ)) as player:
        far = ByMcp(player, question_of(task))
        far.play(scripted(task))
    (record,) = read_records(tmp_path / "records.jsonl")
    assert record.end == "answered" and record.manipulations >= 1
    pictures = [reply.picture for reply in far.replies if reply.picture is not None]
    assert len(pictures) >= 3 and all(p.shape == (1024, 1024, 3) for p in pictures)
    assert np.abs(pictures[0].astype(int) - pictures[-1]).mean() > 1
    with Renderer() as renderer:
        near = play(task, scripted(task), "scripted", library, renderer)
        assert score(task, record, renderer).correct
    assert line_of(record, timed=False) == line_of(near, timed=False)


def test_two_sessions_do_not_see_each_other(server, tmp_path):
    command = server(tmp_path, "--renderer", "filament")
    with ExitStack() as stack:
        here, there = (
            stack.enter_context(playing(*command, env=dict(os.environ))) for _ in range(2)
        )
        here.call("find_object", description="green mug")
        assert "no object_id" in there.call("grasp_and_remove", object_id="object_1").text
        before = there.call("perceive_scene")
        assert here.call("grasp_and_remove", object_id="object_1").text.startswith("Done")
        after = there.call("perceive_scene")
        assert after.text == before.text and (after.picture == before.picture).all()  # type: ignore[union-attr]
        assert here.call("perceive_scene").text != before.text
        here.call("answer_question", choice="C")
        assert there.call("answer_question", choice="A").text.startswith("Your answer")
    records = read_records(tmp_path / "records.jsonl")
    answers = {record.run: record.answer and record.answer.choice for record in records}
    assert answers == {0: "C", 1: "A"}
    assert {record.label for record in records} == {"renderer filament"}


def test_a_record_says_with_which_luck_its_session_was_played(task, library, tmp_path):
    shaky = HeadlineErrors(grasp=0.018, push=0.004, dials=NO_DIALS)
    suite = replace(part(demo_suite(), task), name="shaky", headline=shaky)
    write_suite(tmp_path / "suite.json", suite)
    command = ("-m", "probe", "serve", "--suite", tmp_path / "suite.json", "--task", MUG)
    for _ in range(2):
        with playing(*command, "--out", tmp_path / "out", env=dict(os.environ)) as player:
            player.call("find_object", description="green mug")
            player.call("grasp_and_remove", object_id="object_1")
            player.call("answer_question", choice="C")
    records = read_records(tmp_path / "out" / "records.jsonl")
    assert [(record.run, record.noise) for record in records] == [
        (0, Noise(0.018, 0.004)),
        (1, Noise(0.018, 0.004)),
    ]
    with Renderer() as renderer:
        for record in records:
            again = replay_afresh(task, record, library, renderer)
            assert differences(record, again) == []


@pytest.mark.parametrize("state", ["idle", "busy"])
def test_a_client_that_is_killed_leaves_nothing_behind(server, tmp_path, state):
    command = [sys.executable, doomed.__file__, state, *map(str, server(tmp_path))]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as client:
        assert client.stdout is not None and client.stdout.readline() == b"ready\n"
        started = psutil.Process(client.pid).children(recursive=True)
        assert any("probe.render.worker" in p.cmdline() for p in started) and len(started) >= 3
        client.kill()
    _, alive = psutil.wait_procs(started, timeout=20)
    assert not alive
    (record,) = read_records(tmp_path / "records.jsonl")
    assert record.end == "stopped" and record.answer is None and len(record.steps) == 2
    assert sorted(path.name for path in tmp_path.iterdir()) == ["records.jsonl", "suite.json"]


def test_a_server_that_is_killed_leaves_nothing_behind(server, tmp_path):
    with wired(*server(tmp_path)) as wire:
        wire.call("perceive_scene", {})
        workers = psutil.Process(wire.process.pid).children(recursive=True)
        assert len(workers) >= 2
        wire.process.kill()
        _, alive = psutil.wait_procs(workers, timeout=20)
    assert not alive
    assert [path.name for path in tmp_path.iterdir()] == ["suite.json"]


def test_nothing_that_is_sent_tells_more_than_the_tools(server, task, tmp_path):
    with wired(*server(tmp_path)) as wire:
        assert "result" in wire.ask("prompts/get", {"name": "question"})
        wire.call("perceive_scene", {})
        wire.call("find_object", {"description": "green mug"})
        wire.call("find_object", {"description": task.certificate.candidates[0]})
        wire.call("grasp_and_remove", {"object_id": "object_1"})
        wire.call("answer_question", {"choice": "A"})
        words = "\n".join(text for message in wire.seen for text in texts(message))
    ids = {placed.object_id for placed in task.scene.objects} | set(task.certificate.candidates)
    for secret in (*ids, "proc_", task.id, str(task.seed), task.scene.table, "instance", "seed"):
        assert secret not in words, secret
    first = wire.seen[2]["result"]["content"][0]["text"]
    option = next(option.text for option in task.options if option.letter == task.answer)
    assert option not in first
