"""The log of all that was commanded, on both sides of the wire."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Dict, List

import pytest

from bridges import TOKEN, practice, running
from probe_bridge.client import RobotClient
from probe_bridge.command_log import CommandLog, read_log
from probe_bridge.errors import BridgeError


def said(lines: List[Dict[str, Any]]) -> List[str]:
    return [
        " ".join(str(line[k]) for k in ("event", "do", "outcome") if k in line) for line in lines
    ]


COMMANDED = [
    "asked hello",
    "ended hello done",
    "asked follow",
    "ended follow done",
    "asked follow",
    "ended follow refused",
    "asked stop",
    "ended stop done",
]


def test_both_sides_log_all_that_was_commanded_and_what_came_of_it(tmp_path: Path):
    there, here = tmp_path / "robot" / "there.jsonl", tmp_path / "here.jsonl"
    log = CommandLog(there)
    with running(practice(), log=log) as bridge:
        client = RobotClient(bridge.address, TOKEN, log=here)
        start = client.joints()
        client.observe("table", rgb=False)
        goal = [start[0] + 0.1, *start[1:]]
        client.follow([start, goal], speed=0.5)
        with pytest.raises(BridgeError, match="begins"):
            client.follow([start, goal])
        client.stop()
        client.close()
    assert said(read_log(here)) == COMMANDED
    assert said(read_log(there)) == ["connected", *COMMANDED, "left"]
    for path in (here, there):
        asked = [line for line in read_log(path) if line["event"] == "asked"]
        assert asked[1]["arguments"]["path"] == [list(start), goal]
        assert asked[1]["arguments"]["speed"] == 0.5
        times = [line["time"] for line in read_log(path)]
        assert times == sorted(times)
        refused = next(line for line in read_log(path) if line.get("outcome") == "refused")
        assert "begins" in refused["text"]


def test_a_line_is_there_before_the_motion_is_over(tmp_path: Path):
    path = tmp_path / "log"
    log = CommandLog(path)
    log.asked("grip", 3, {"opening": 0.1})
    assert json.loads(path.read_text())["arguments"] == {"opening": 0.1}


def test_a_torn_line_is_left_out_and_the_next_one_is_whole(tmp_path: Path):
    path = tmp_path / "log"
    path.write_text('{"event":"asked","do":"home"}\n{"event":"asked","do":"fol')
    assert [line["do"] for line in read_log(path)] == ["home"]
    log = CommandLog(path)
    log.ended("home", 1)
    assert said(read_log(path)) == ["asked home", "ended home done"]


def test_where_nothing_can_be_logged_nothing_moves_but_a_stop_stops(tmp_path: Path):
    log = CommandLog(tmp_path / "log")
    with running(practice(), log=log) as bridge:
        client = RobotClient(bridge.address, TOKEN)
        (tmp_path / "log").unlink()
        (tmp_path / "log").mkdir()  # so that it can't be written, as on a full disk
        start = client.joints()
        for move in (lambda: client.follow([start, start]), client.home, lambda: client.grip(0.1)):
            with pytest.raises(BridgeError, match="can't be written") as fault:
                move()
            assert fault.value.kind == "fault"
        assert not bridge.driver.moves
        with pytest.raises(BridgeError, match="can't be written"):
            client.stop()
        assert bridge.driver.stops
        client.close()
    with pytest.raises(BridgeError, match="can't be written"):
        CommandLog(tmp_path)
