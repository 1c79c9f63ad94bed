"""The page of a run: how far it is and what happens at its tables; it changes nothing."""

from __future__ import annotations

import json
import os
import urllib.request
from urllib.error import HTTPError

import numpy as np
import pytest

from probe.episodes.files import append_record
from probe.episodes.turns import Call, Question, Turn
from probe.interfaces.human.server import served
from probe.interfaces.watch.app import WatchedRun, app_of
from probe.interfaces.watch.progress import RecordCount
from probe.runs.live import LiveTable
from probe.toolshed.result import ToolResult
from run_folders import DEMO, episode

PICTURE = np.full((64, 64, 3), 90, np.uint8)
ASKED = Question("How many <b>mugs</b>?", (("A", "2"), ("B", "<i>3</i>")), PICTURE)


@pytest.fixture
def records(tmp_path):
    return tmp_path / "records.jsonl"


@pytest.fixture
def page(tmp_path, records):
    """Asks the server for an address; gives the body."""
    tables = tmp_path / "tables"
    tables.mkdir()
    run = WatchedRun("demo", "anna", 6, RecordCount(records, "anna", ""), tables)
    with served(app_of(run), 0) as address:

        def ask(path, method="GET", **headers):
            request = urllib.request.Request(address + path, method=method, headers=headers)
            with urllib.request.urlopen(request, timeout=20) as reply:
                return reply.read()

        yield ask


def test_the_page_tells_how_far_the_run_is(page, records):
    assert json.loads(page("state"))["done"] == 0
    append_record(records, episode(DEMO.tasks[0]))
    append_record(records, episode(DEMO.tasks[1], fault="a dead renderer"))
    append_record(records, episode(DEMO.tasks[1], agent="bea"))
    state = json.loads(page("state"))
    assert (state["done"], state["total"], state["agent"]) == (1, 6, "anna")
    append_record(records, episode(DEMO.tasks[1]))
    with records.open("ab") as file:
        file.write(b'{"task": "half a li')
    assert json.loads(page("state"))["done"] == 2


def test_a_table_is_shown_as_it_is_now(page, tmp_path):
    table = LiveTable(tmp_path / "tables")
    table.begin("count-1", 0, ASKED)
    table.call(Call.of("find_object", {"description": "mug"}, "I look."))
    (shown,) = json.loads(page("state"))["tables"]
    assert (shown["question"], shown["pictures"]) == (ASKED.text, 1)
    assert shown["steps"][0] == {
        "tool": "find_object",
        "arguments": '{"description": "mug"}',
        "words": "I look.",
        "status": None,
        "text": "",
    }
    table.result(Turn(Call("find_object"), ToolResult("object_id: object_1", PICTURE)))
    (shown,) = json.loads(page("state"))["tables"]
    assert (shown["pictures"], shown["steps"][0]["status"]) == (2, "done")
    assert page(f"picture?table={os.getpid()}").startswith(b"\xff\xd8")


def test_nothing_can_be_changed_and_nothing_else_be_read(page):
    for name in ("", "static/watch.js", "static/watch.css", "base.css"):
        assert page(name)
    for path in ("picture?table=1", "picture?table=../records", "picture", "records.jsonl"):
        with pytest.raises(HTTPError, match="404"):
            page(path)
    with pytest.raises(HTTPError, match="41"):
        page("state", method="POST")
    with pytest.raises(HTTPError, match="400"):
        page("state", host="elsewhere.example")
