"""A policy through the wire and real physics is the same policy in this process."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import partial

import pytest

from bench.painted import demo, plan
from bench.sitting_in import kept, sit_in, task_of
from model_server import Reply, serving
from probe.assets.library import open_library
from probe.assets.tables import load_table
from probe.cli.agents import make_agent
from probe.episodes.files import line_of
from probe.episodes.play import play
from probe.render.renderer import Renderer
from probe.runs.table import TablePlace

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]

SUITE = demo(2)


class Recited:
    """Says over the wire what a record says, whatever it is told."""

    def __init__(self, records) -> None:
        self._records = records

    def __call__(self, number: int, body: dict) -> Reply:
        record = self._records[task_of(body, SUITE).id]
        turn = sum(message["role"] == "assistant" for message in body["messages"])
        call = record.steps[turn].call
        return Reply(call.words or None, calls=((call.name, call.arguments),))


def test_the_same_calls_give_the_same_bytes(tmp_path):
    things = open_library("procedural", None, tmp_path / "cache")
    with Renderer() as renderer:
        direct = {
            task.id: play(
                task, make_agent("scripted", task, 0, things, renderer), "scripted", things,
                load_table(task.scene.table, None), renderer,
            )
            for task in SUITE.tasks
        }  # fmt: skip
    library = partial(open_library, "procedural", None, tmp_path / "cache")
    order = replace(
        plan(tmp_path / "out", "agentic", SUITE), library=library, cache=None, workers=1
    )
    with serving(Recited(direct)) as server:
        sit_in(replace(order, called="scripted"), server.url, TablePlace)
    for id, record in kept(tmp_path / "out").items():
        assert record.seat is not None and record.seat.faults == ()
        alone = replace(record, seat=None)
        assert line_of(alone, timed=False) == line_of(direct[id], timed=False)
        assert json.loads(line_of(record))["seat"]["tokens_in"] == 100 * len(record.steps)
