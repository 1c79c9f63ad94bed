"""`probe run --agent FILE.py`: whom it lets in, and what becomes of one that breaks."""

from __future__ import annotations

from dataclasses import replace

import pytest

from probe.agents.external.protocol import AgentReady, Confinement
from probe.agents.external.sandbox import Sandbox
from probe.api.agents import make_agent
from probe.api.grading import graded
from probe.api.rows import rows_of
from probe.cli.file_agents import FileAgents, who_acts
from probe.cli.run import AgentChoice, ModelChoice, run
from probe.episodes.files import read_records
from probe.errors import BadData, UnknownName
from probe.tasks.suite_file import demo_suite, read_suite, write_suite

STOPS = "class {name}:\n    def act(self, question, history):\n        return None\n"


@pytest.fixture
def file(tmp_path):
    def write(name="Mine", code=STOPS):
        path = tmp_path / "mine.py"
        path.write_text(code.format(name=name))
        return str(path)

    return write


def test_agents_of_ours_go_by_name(tmp_path):
    assert who_acts("random", None, Sandbox(), "demo", tmp_path) == ("random", make_agent)
    with pytest.raises(UnknownName, match=r"no agent called 'rnadom'. Did you mean random"):
        who_acts("rnadom", None, Sandbox(), "demo", tmp_path)


@pytest.mark.parametrize(
    ("name", "sandbox", "words"),
    [
        ("me", Sandbox(), "--agent-name: does nothing"),
        (None, Sandbox(5.0), "--sandbox: does nothing"),
    ],
)
def test_what_does_nothing_for_them_is_refused(tmp_path, name, sandbox, words):
    with pytest.raises(BadData, match=words):
        who_acts("random", name, sandbox, "demo", tmp_path)


def test_an_agent_of_a_file_goes_by_its_class(tmp_path, file, capsys):
    name, made = who_acts(file(), None, Sandbox(), "demo", tmp_path)
    assert name == "Mine" and isinstance(made, FileAgents)
    assert who_acts(file() + ":Mine", "me-2", Sandbox(), "demo", tmp_path)[0] == "me-2"
    assert "in a process of its own, kept from" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("confined", "sandbox", "words"),
    [
        (
            Confinement(files=False, network=True, processes=False),
            Sandbox(),
            "kept from the network.\nThis machine can't keep it from other files, other processes:",
        ),
        (
            Confinement(files=True, network=False, processes=True),
            Sandbox(network=True),
            "kept from other files, other processes.\nWhat it prints",
        ),
        (Confinement(files=False, network=False, processes=False), Sandbox(), "kept from nothing."),
    ],
)
def test_what_a_machine_cannot_keep_it_from_is_said(
    tmp_path, file, capsys, monkeypatch, confined, sandbox, words
):
    met = confined, AgentReady(name="Mine")
    monkeypatch.setattr("probe.cli.file_agents.introduced", lambda invitation: met)
    who_acts(file(), None, sandbox, "demo", tmp_path)
    assert words in capsys.readouterr().out


@pytest.mark.parametrize(
    ("cls", "name", "words"),
    [
        ("scripted", None, "scripted: is the name of an agent of ours. Say --agent-name NAME"),
        ("Ünsafe", None, "isn't made of 1 to 64 letters"),
        ("Mine", "=cmd()", "isn't made of 1 to 64 letters"),
        ("Mine", "a\x1b[2J", r"'a\\x1b\[2J': isn't made of"),
        ("Mine", "", "isn't made of"),
    ],
)
def test_names_are_safe_and_new(tmp_path, file, cls, name, words):
    with pytest.raises(BadData, match=words):
        who_acts(file(cls), name, Sandbox(), "demo", tmp_path)


def test_it_does_nothing_beside_a_model(tmp_path):
    with pytest.raises(BadData, match="--sandbox: does nothing with --model"):
        run(
            "demo",
            AgentChoice(sandbox=Sandbox(network=True)),
            ModelChoice("m"),
            out=tmp_path / "out",
        )
    with pytest.raises(BadData, match="--agent-name: does nothing with --model"):
        run("demo", AgentChoice(agent_name="me"), ModelChoice("m"), out=tmp_path / "out")


BREAKS = """
import os
from probe.episodes.turns import Call

class Breaks:
    pictures = True

    def act(self, question, history):
        print(len(history), question.picture.shape)
        if not history:
            return Call.of("perceive_scene")
        print(history[-1].result.picture.shape)
        os._exit(3)
"""


@pytest.mark.slow
def test_one_that_breaks_has_stopped_and_is_not_missing(tmp_path, file):
    demo, out = demo_suite(), tmp_path / "out"
    suite = tmp_path / "two.json"
    write_suite(suite, replace(demo, name="two", tasks=demo.tasks[:2]))
    agent = file(code=BREAKS.replace("{", "{{").replace("}", "}}"))
    run(str(suite), AgentChoice(agent), out=out, workers=2, noise="paper")
    records = read_records(out / "records.jsonl")
    assert {record.task for record in records} == {task.id for task in demo.tasks[:2]}
    for record in records:
        assert (record.agent, record.end, record.fault) == ("Breaks", "stopped", None)
        assert record.participation is not None
        assert record.participation.faults == ("ended its process with status 3",)
        assert [step.call.name for step in record.steps] == ["perceive_scene"]
    rows = rows_of(out, read_suite(out / "suite.json"), graded(out))
    assert [(row.correct, row.missing, row.answer) for row in rows] == [(False, False, None)] * 2
    told = (out / "agent.log").read_text()
    for task in demo.tasks[:2]:
        shapes = "0 (1024, 1024, 3)\n1 (1024, 1024, 3)\n(1024, 1024, 3)\n"
        assert f"== {task.id}, run 0 ==\n{shapes}" in told
    before = (out / "records.jsonl").read_bytes()
    run(str(suite), AgentChoice(agent), out=out, noise="paper")
    assert (out / "records.jsonl").read_bytes() == before
