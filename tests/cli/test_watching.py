"""`probe run --watch`: a page beside a run, which changes none of its results."""

from __future__ import annotations

import json
import re
import urllib.request

import pytest

from model_server import Reply, serving
from probe.api.agents import make_agent
from probe.api.resources import everything
from probe.cli import model_run
from probe.cli.model_run import ModelRunOptions, run_model
from probe.cli.running import run_order
from probe.cli.watching import watching
from probe.engines.local import LocalEngine
from probe.episodes.conditions import AS_FROZEN
from probe.episodes.files import line_of, read_records
from probe.episodes.noise import NO_NOISE
from probe.runs.plan import RunOrder
from probe.tasks.suite import part
from probe.types import Shard
from run_folders import DEMO

SUITE = part(DEMO, DEMO.tasks[2])


def test_the_page_is_there_as_long_as_the_run(tmp_path, capsys):
    with watching(tmp_path, SUITE, "scripted", "", 6, on=True) as tables:
        (address,) = re.findall(r"http://127\.0\.0\.1:\d+/", capsys.readouterr().out)
        with urllib.request.urlopen(f"{address}state", timeout=20) as reply:
            state = json.load(reply)
        assert state == {
            "suite": "demo", "agent": "scripted", "done": 0, "total": 6, "tables": []
        }  # fmt: skip
        assert tables is not None and tables.is_dir()
    assert not tables.exists()
    with pytest.raises(OSError):
        urllib.request.urlopen(f"{address}state", timeout=20)


def test_without_it_there_is_nothing(tmp_path, capsys):
    with watching(tmp_path, SUITE, "scripted", "", 6, on=False) as tables:
        assert tables is None
    assert capsys.readouterr().out == ""


class Watched(Exception):
    """Enough is known: the run needn't begin."""


@pytest.mark.parametrize(
    ("pointer", "setting"),
    [
        ("oracle", "agentic"),
        ("self", "agentic, pointer self"),
        ("eyes", "agentic, pointer openai-api/endpoint/eyes"),
    ],
)
def test_records_are_counted_under_the_name_of_the_one_that_points(
    tmp_path, monkeypatch, pointer, setting
):
    def watched(out, suite, agent, setting, total, *, on):
        raise Watched(agent, setting, total, on)

    monkeypatch.setattr(model_run, "watching", watched)
    with serving(lambda number, body: Reply("Hello.")) as server:
        options = ModelRunOptions(
            library=everything, model="mine", setting="agentic", epochs=2, points=None,
            pointer=pointer, endpoint=server.url, prices=None, noise=NO_NOISE,
            conditions=AS_FROZEN, shard=Shard(), workers=1, watch=True,
        )  # fmt: skip
        with pytest.raises(Watched) as told:
            run_model(SUITE, options, tmp_path / "out")
    assert told.value.args == ("mine", setting, 2, True)


@pytest.mark.slow
def test_records_are_the_same_with_it_and_without(tmp_path):
    lines = set[bytes]()
    for watch in (True, False):
        out = tmp_path / str(watch)
        order = RunOrder("always-A")
        engine = LocalEngine()
        assert not run_order(SUITE, order, make_agent, everything(), out, engine, watch=watch)
        (record,) = read_records(out / "records.jsonl")
        lines.add(line_of(record, timed=False))
    assert len(lines) == 1
