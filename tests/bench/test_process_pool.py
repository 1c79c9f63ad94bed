"""Tables that die, runs that are killed: nothing is lost, nothing is asked twice."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import pytest

from bench.painted import demo, plan
from bench.sitting_in import (
    FIND,
    GRASP,
    LOOK,
    answer,
    kept,
    metrics_of,
    replies_so_far,
    run_in,
    seat_of,
    values_of,
)
from model_server import Reply, serving
from probe.episodes.files import line_of
from probe.episodes.record import EpisodeRecord
from probe.tasks.suite_file import write_suite

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]

SUITE = demo(2)
PATIENCE = 600.0


def script(number: int, body: dict) -> Reply:
    return Reply("So.", calls=((LOOK, FIND, GRASP, LOOK, answer("E"))[replies_so_far(body)],))


def unfaulted(record: EpisodeRecord) -> bytes:
    seat = replace(seat_of(record), faults=())
    return line_of(replace(record, participation=seat), timed=False)


def test_a_table_that_dies_costs_no_reply(tmp_path):
    (tmp_path / "calm").mkdir()
    (tmp_path / "wild").mkdir()
    (tmp_path / "wild" / "deaths").write_text("2")
    asked = []
    for name in ("calm", "wild"):
        with serving(script) as server:
            log = run_in(plan(tmp_path / name, "agentic", demo(1)), server.url)
        asked.append(len(server.bodies))
        assert set(values_of(log).values()) <= {"C", "I"}
    assert asked == [5, 5]
    (calm,), (wild,) = (kept(tmp_path / name).values() for name in ("calm", "wild"))
    assert unfaulted(calm) == unfaulted(wild)
    assert seat_of(wild).faults == ("A worker process ended with status 9",) * 2
    assert seat_of(calm).faults == ()


def test_a_table_that_always_dies_costs_one_episode(tmp_path):
    (tmp_path / "deaths").write_text("3")
    with serving(script) as server:
        log = run_in(plan(tmp_path, "agentic", SUITE, workers=1), server.url)
    ends = sorted(record.end for record in kept(tmp_path).values())
    assert ends == ["answered", "fault"]
    assert metrics_of(log)["missing"] == 1


RUN = """
import sys
from pathlib import Path
from bench.painted import plan
from bench.sitting_in import run_in
from probe.tasks.suite_file import read_suite

if __name__ == "__main__":
    out, suite, url = Path(sys.argv[1]), read_suite(Path(sys.argv[2])), sys.argv[3]
    run_in(plan(out, "agentic", suite, workers=1), url)
"""


def start(out: Path, suite: Path, url: str) -> subprocess.Popen:
    path = suite.with_name("run.py")
    path.write_text(RUN)
    places = [str(Path(__file__).resolve().parents[1]), os.environ.get("PYTHONPATH", "")]
    cache = {"INSPECT_CACHE_DIR": str(suite.parent / "replies")}
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(places)} | cache
    return subprocess.Popen([sys.executable, str(path), str(out), str(suite), url], env=environment)


def test_a_killed_run_goes_on_without_paying_twice(tmp_path):
    write_suite(tmp_path / "small.json", SUITE)
    with serving(script) as server:
        process = start(tmp_path / "whole", tmp_path / "small.json", server.url)
        assert process.wait(PATIENCE) == 0
    whole = len(server.bodies)
    with serving(lambda n, body: replace(script(n, body), wait=0.5)) as server:
        process = start(tmp_path / "cut", tmp_path / "small.json", server.url)
        end = time.monotonic() + PATIENCE
        while len(server.bodies) < 8 and time.monotonic() < end:
            time.sleep(0.05)
        process.send_signal(signal.SIGKILL)
        process.wait(PATIENCE)
        assert start(tmp_path / "cut", tmp_path / "small.json", server.url).wait(PATIENCE) == 0
    # The one that was under way when it was killed may have been lost on its way.
    assert whole <= len(server.bodies) <= whole + 1
    first, second = (
        {id: unfaulted(it) for id, it in kept(tmp_path / name).items()} for name in ("whole", "cut")
    )
    assert first == second
