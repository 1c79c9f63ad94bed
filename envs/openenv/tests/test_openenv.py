"""PROBE's table as an OpenEnv environment: its server and its client, at painted tables."""

from __future__ import annotations

import threading
import time
from collections.abc import Generator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager

import pytest

pytest.importorskip("openenv", reason="`make .venv/.openenv` installs OpenEnv")

import httpx
import uvicorn
from probe_openenv import ProbeTable, ToolCall
from probe_openenv.server.making import application, serving
from probe_openenv.server.settings import Settings

from interfaces.training.painted_tables import TASKS, painted_tables
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS
from probe.errors import BadData
from probe.interfaces.training.permission import NotForTraining
from probe.tasks.suite_file import demo_suite, write_suite

pytestmark = pytest.mark.slow


@contextmanager
def served(tables) -> Generator[str]:
    server = uvicorn.Server(uvicorn.Config(serving(tables), port=0, log_level="warning"))
    thread = threading.Thread(target=server.run)
    thread.start()
    try:
        while not server.started:
            assert thread.is_alive()
            time.sleep(0.05)
        port = server.servers[0].sockets[0].getsockname()[1]
        yield f"http://127.0.0.1:{port}"
    finally:
        server.should_exit = True
        thread.join()


def played(url: str, number: int) -> float | None:
    """Look, remove a thing and answer: rightly on even tries."""
    task = TASKS[number % len(TASKS)]
    wrong = next(letter for letter in "AB" if letter != task.answer)
    with ProbeTable(base_url=url).sync() as table:
        told = table.reset(task=task.id).observation
        assert [it["role"] for it in told.messages][0] == "system" and not told.done
        assert len(told.tools) == 5
        listed = table.step(ToolCall(tool="perceive_scene"))
        assert listed.observation.text.startswith("# All that shows") and listed.reward is None
        removed = {"object_id": "object_1"}
        came = table.step(ToolCall(tool="grasp_and_remove", arguments=removed))
        assert "lifted and dropped into the basket" in came.observation.text
        choice = task.answer if number % 2 == 0 else wrong
        last = table.step(ToolCall(tool="answer_question", arguments={"choice": choice}))
        assert last.done and table.state().step_count == 3
        return last.reward


def test_connections_play_side_by_side_and_none_is_lost(tmp_path):
    out = tmp_path / "out"
    tables = painted_tables(tmp_path, most=4, out=out)
    with served(tables) as url, ThreadPoolExecutor(4) as threads:
        rewards = list(threads.map(lambda number: played(url, number), range(8)))
    assert rewards == [1.0, 0.0] * 4
    records = read_records(out / RECORDS)
    assert len({(it.task, it.run) for it in records}) == 8
    assert all(it.end == "answered" for it in records)


def test_a_task_comes_by_its_id_by_a_seed_or_in_turn(tmp_path):
    with served(painted_tables(tmp_path)) as url, ProbeTable(base_url=url).sync() as table:

        def task(**chosen: object) -> str | None:
            table.reset(**chosen)
            return table.state().task

        assert task(task=TASKS[2].id) == TASKS[2].id
        assert task(seed=1) == task(seed=1 + len(TASKS)) == TASKS[1].id
        assert [task(), task()] == [TASKS[0].id, TASKS[1].id]


def test_what_fits_no_tool_costs_a_turn_and_is_told_off(tmp_path):
    with served(painted_tables(tmp_path)) as url, ProbeTable(base_url=url).sync() as table:
        table.reset(task=TASKS[0].id)
        for call in (ToolCall(tool="fly"), ToolCall(tool="push", arguments={"object_id": "x"})):
            reply = table.step(call)
            assert not reply.done and reply.reward is None
            assert "no tool" in reply.observation.text or "missing" in reply.observation.text
        assert table.state().step_count == 2


def test_a_connection_that_goes_gives_its_seat_to_others(tmp_path):
    with served(painted_tables(tmp_path, most=1)) as url:
        with ProbeTable(base_url=url).sync() as table:
            table.reset(task=TASKS[0].id)
            table.step(ToolCall(tool="perceive_scene"))
        assert played(url, 0) == 1.0


def test_a_seat_that_is_still_being_left_is_waited_for(tmp_path):
    """Its table is still being set when the connection goes."""
    with served(painted_tables(tmp_path, most=1)) as url:
        with ProbeTable(base_url=url).sync() as table:
            table.reset(task=TASKS[0].id)
        assert played(url, 0) == 1.0


def test_a_reply_that_comes_too_late_is_nobodys(tmp_path):
    tables = painted_tables(tmp_path, most=2)
    with served(tables) as url:
        with ProbeTable(base_url=url, message_timeout_s=0.02).sync() as hasty:
            with pytest.raises(TimeoutError, match=r"nothing for 0.02 seconds.*message_timeout_s"):
                hasty.reset(task=TASKS[0].id)
                hasty.step(ToolCall(tool="perceive_scene"))
            with pytest.raises((TimeoutError, RuntimeError)):
                hasty.step(ToolCall(tool="fly"))
        assert played(url, 0) == 1.0


def test_an_episode_whose_table_always_dies_ends_without_a_reward(tmp_path):
    (tmp_path / "deaths").write_text("3")
    tables = painted_tables(tmp_path, most=1)
    with served(tables) as url, ProbeTable(base_url=url).sync() as table:
        table.reset(task=TASKS[0].id)
        table.step(ToolCall(tool="perceive_scene"))
        call = ToolCall(tool="grasp_and_remove", arguments={"object_id": "object_1"})
        lost = table.step(call)
        assert lost.done and lost.reward is None
        assert "ended with status 9 (3 times in all)" in lost.observation.text


def test_a_request_without_a_connection_takes_no_seat(tmp_path):
    with served(painted_tables(tmp_path, most=1)) as url:
        for path in ("/reset", "/step"):
            assert httpx.post(url + path, json={}).status_code == 404
        assert httpx.get(f"{url}/health").status_code == 200
        assert played(url, 0) == 1.0


def test_tasks_of_evaluation_are_refused(tmp_path):
    write_suite(tmp_path / "demo.json", demo_suite())
    with pytest.raises(NotForTraining):
        application(Settings(tmp_path / "demo.json"))


def test_settings_are_said_by_variables():
    settings = Settings.of_environment({"PROBE_SUITE": "a.json", "PROBE_TABLES": "3"})
    assert settings.tables == 3 and Settings.of_environment(settings.variables()) == settings
    with pytest.raises(BadData, match="PROBE_SUITE: is not set"):
        Settings.of_environment({})
    with pytest.raises(BadData, match="PROBE_TABLES: '-1' is no number"):
        Settings.of_environment({"PROBE_SUITE": "a.json", "PROBE_TABLES": "-1"})
