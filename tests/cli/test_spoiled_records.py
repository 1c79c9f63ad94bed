"""Records and suites that nobody could have made are refused in one line that names the place."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import probe.cli
from probe.checksum import with_sum, without_sum
from probe.episodes.folder import RECORDS
from run_folders import DEMO, episode, write_run

FIND = next(task for task in DEMO.tasks if task.question_type == "find")


def refused(monkeypatch: pytest.MonkeyPatch, *words: object) -> str:
    monkeypatch.setattr(sys, "argv", ["probe", *map(str, words)])
    with pytest.raises(SystemExit) as ended:
        probe.cli.main()
    assert isinstance(ended.value.code, str)
    return ended.value.code


def run_before(record: Any) -> None:
    record["run"] = -5


def unknown(record: Any) -> None:
    record["start"]["scene"]["objects"][0]["object_id"] = "nothing"


def swapped(record: Any) -> None:
    one, other, *_ = record["start"]["scene"]["objects"]
    one["object_id"], other["object_id"] = other["object_id"], one["object_id"]


def gone_in_the_end(record: Any) -> None:
    left = json.loads(json.dumps(record["start"]))
    objects = left["scene"]["objects"]
    left["scene"]["objects"] = [it for it in objects if it["instance"] not in FIND.targets]
    record["steps"][-1]["after"] = left


def twice(record: Any) -> None:
    objects = record["start"]["scene"]["objects"]
    objects.append(objects[0])


def no_turn(record: Any) -> None:
    record["start"]["scene"]["objects"][0]["wxyz"] = [0, 0, 0, 0]


def far(record: Any) -> None:
    record["start"]["scene"]["objects"][0]["position"] = [0, 0, 1e30]


def outside(record: Any) -> None:
    record["steps"][0]["point_px"] = [5000, -3]


def beside_the_picture(record: Any) -> None:
    record["steps"][0]["point_px"] = [3, 1024]


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (run_before, "line 1: run: Input should be greater than or equal to 0"),
        (unknown, "its table at the start isn't that of the suite"),
        (swapped, "its table at the start isn't that of the suite"),
        (gone_in_the_end, "the table is another one afterwards, though it moves nothing"),
        (twice, "instance 1 is there twice"),
        (no_turn, "a rotation is a quaternion of length 1, not 0"),
        (far, "position.2: Input should be less than or equal to 1000000000000"),
        (outside, "point_px.0: Input should be less than 4096"),
        (beside_the_picture, "steps.0.point_px lies outside a picture of 1024 pixels"),
    ],
)
def test_spoiled_records(tmp_path, monkeypatch, spoil: Callable[[Any], None], words):
    write_run(tmp_path, [episode(FIND)], pictures=False)
    path: Path = tmp_path / RECORDS
    record = json.loads(without_sum(path.read_bytes()))
    spoil(record)
    path.write_bytes(with_sum(json.dumps(record).encode()))
    told = refused(monkeypatch, "rescore", tmp_path)
    assert told.startswith(f"probe: {path}") and words in told


def test_find_without_anything_to_find(tmp_path, monkeypatch):
    write_run(tmp_path, [], pictures=False)
    path = tmp_path / "suite.json"
    suite = json.loads(without_sum(path.read_bytes()))
    for task in suite["tasks"]:
        if task["kind"] == "find":
            task["targets"] = []
    path.write_bytes(with_sum(json.dumps(suite).encode()))
    assert "find is about 1 targets or more" in refused(monkeypatch, "suite", "show", path)


def test_memory_that_isnt_there(monkeypatch):
    def greedy(words: list[str]) -> None:
        raise MemoryError

    monkeypatch.setattr("probe.cli._run", greedy)
    told = refused(monkeypatch, "demo")
    assert told.startswith("probe: Memory ran out") and "--workers 1" in told
