"""`probe run --model` and `inspect eval` as users type them, against a local server."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from model_server import Reply, Served, serving
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS
from probe.scores.row_files import read_csv
from probe.tasks.suite import selection
from probe.tasks.suite_file import demo_suite, write_suite
from probe.tasks.task import Task

pytestmark = pytest.mark.slow
DEMO = demo_suite()
COUNT, FIND = (
    next(task for task in DEMO.tasks if task.question_type == question_type)
    for question_type in ("count", "find")
)
PATIENCE = 240.0
CALL = ("answer_question", '{"choice": "A"}')


def says_a(number: int, body: dict[str, Any]) -> Reply:
    """Answers A: by a call where there are tools, else in words."""
    return Reply(calls=(CALL,)) if body.get("tools") else Reply("ANSWER: A")


def typed(*words: str | Path, **more: str) -> str:
    """What a command prints; it must end well."""
    ended = subprocess.run(
        [*map(str, words)],
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        env=os.environ | more,
    )
    assert ended.returncode == 0, ended.stdout + ended.stderr
    return ended.stdout


def refused(*words: str | Path) -> str:
    """What a command prints that must end with status 1."""
    ended = subprocess.run(
        [sys.executable, "-m", "probe", *map(str, words)],
        capture_output=True,
        text=True,
        timeout=PATIENCE,
    )
    assert ended.returncode == 1, ended.stdout + ended.stderr
    return ended.stdout


def probe(*words: str | Path) -> str:
    return typed(sys.executable, "-m", "probe", *words)


def suite_file(tmp_path: Path, tasks: tuple[Task, ...]) -> Path:
    write_suite(tmp_path / "some.json", selection(DEMO, tasks, "some"))
    return tmp_path / "some.json"


def asked(server: Served) -> list[Any]:
    """All requests but the first to each run's model, which only sees that it answers."""
    return [body for body in server.bodies if "Say hello." not in str(body["messages"])]


def pictures_in(body: dict[str, Any]) -> int:
    contents = [it["content"] for it in body["messages"] if isinstance(it["content"], list)]
    return sum(part["type"] == "image_url" for content in contents for part in content)


def test_shards_are_run_merged_and_reported(tmp_path):
    suite = suite_file(tmp_path, (COUNT, FIND))
    with serving(says_a) as server:
        for number in range(2):
            probe(
                *("run", suite, "--model", "mine", "--endpoint", server.url, "--setting", "direct"),
                *("--epochs", "1", "--workers", "1", "--shard", f"{number}/2"),
                *("--out", tmp_path / str(number)),
            )
    # Find is asked twice, for want of a point.
    assert [pictures_in(body) for body in asked(server)] == [1] * 3
    whole = tmp_path / "whole"
    probe("merge", tmp_path / "0", tmp_path / "1", "--out", whole)
    probe("report", whole)
    rows = {row.task: row for row in read_csv(whole / "rows.csv")}
    assert {(row.agent, row.setting) for row in rows.values()} == {("mine", "direct")}
    # Find needs a point as well, which nobody gave.
    assert (rows[COUNT.id].correct, rows[FIND.id].correct) == (COUNT.answer == "A", False)
    assert "mine" in (whole / "index.html").read_text()


@pytest.mark.parametrize(("setting", "pictures"), [("blind", 0), ("oracle-view", 2)])
def test_other_settings_show_what_they_should(tmp_path, setting, pictures):
    suite = suite_file(tmp_path, (COUNT,))
    with serving(says_a) as server:
        probe(
            *("run", suite, "--model", "mine", "--endpoint", server.url, "--setting", setting),
            *("--epochs", "1", "--workers", "1", "--out", tmp_path / "out"),
        )
    assert [pictures_in(body) for body in asked(server)] == [pictures]
    (record,) = read_records(tmp_path / "out" / RECORDS)
    assert record.setting == setting
    said = refused("audit", tmp_path / "out", "--replay", "all")
    assert f"1 can't be replayed: a model answered in words (setting {setting})" in said


def looks_then_says_a(number: int, body: dict[str, Any]) -> Reply:
    """Looks twice, then answers A."""
    turn = sum(message["role"] == "assistant" for message in body["messages"])
    return Reply(calls=(("perceive_scene", "{}") if turn < 2 else CALL,))


def test_a_model_that_sees_no_picture_acts_by_words(tmp_path):
    suite, out = suite_file(tmp_path, (COUNT,)), tmp_path / "out"
    with serving(looks_then_says_a) as server:
        probe(
            *("run", suite, "--model", "mine", "--endpoint", server.url, "--epochs", "1"),
            *("--setting", "text-only", "--graphs", "short", "--workers", "1", "--out", out),
        )
    bodies = asked(server)
    assert [pictures_in(body) for body in bodies] == [0, 0, 0]
    results = [it["content"] for it in bodies[-1]["messages"] if it["role"] == "tool"]
    assert "- object_1 " in str(results[0]) and "boxes are in pixels" not in str(results[0])
    assert "# Nothing has changed since the last list." in str(results[1])
    (record,) = read_records(out / RECORDS)
    assert record.setting == "text-only, short graphs"
    # The record keeps lists whole, and calls can be done again.
    assert "boxes are in pixels" in record.steps[0].text
    assert record.steps[0].text == record.steps[1].text
    assert "can't be replayed" not in probe("audit", out, "--replay", "all")
    assert "text-only, short graphs" in probe("report", out)


def test_a_model_sits_at_a_changed_table(tmp_path):
    suite = suite_file(tmp_path, (COUNT,))
    with serving(says_a) as server:
        probe(
            *("run", suite, "--model", "mine", "--endpoint", server.url, "--epochs", "1"),
            *("--table", "other", "--camera", "moved", "--pose-jitter", "0.003"),
            *("--workers", "1", "--out", tmp_path / "out"),
        )
    (record,) = read_records(tmp_path / "out" / RECORDS)
    assert record.end == "answered"
    assert record.start.scene.table != COUNT.scene.table
    moved = zip(record.start.scene.objects, COUNT.scene.objects, strict=True)
    assert all(now.pose != then.pose for now, then in moved)
    assert record.conditions.camera == "moved"
    said = probe("audit", tmp_path / "out", "--replay", "all")
    assert "audited: 1 of 1 replayed, all equal" in said


def test_the_harness_finds_our_tasks_by_name(tmp_path):
    suite = suite_file(tmp_path, (COUNT,))
    inspect = Path(sys.executable).with_name("inspect")
    with serving(says_a) as server:
        typed(
            *(inspect, "eval", "probe/direct", "--model", "openai-api/local/mine"),
            *("-T", f"suite={suite}", "-T", f"out={tmp_path / 'out'}", "-T", "epochs=1"),
            *("--display", "plain", "--log-dir", tmp_path / "logs"),
            LOCAL_BASE_URL=server.url,
            LOCAL_API_KEY="none",
        )
    (record,) = read_records(tmp_path / "out" / RECORDS)
    assert (record.setting, record.answer and record.answer.choice) == ("direct", "A")


def test_a_pointer_is_asked_at_the_endpoint_too(tmp_path):
    """Whoever has no provider before its name is there; its price is its own."""
    suite, prices = suite_file(tmp_path, (COUNT,)), tmp_path / "prices.yaml"
    prices.write_text(
        "eyes:\n  tokens_in: 1000000\n  tokens_out: 0\nmine:\n  tokens_in: 0\n  tokens_out: 0\n"
    )

    def says(number: int, body: dict[str, Any]) -> Reply:
        if not body.get("tools"):
            return Reply("[512, 512]")
        look = ("find_object", '{"description": "the thing in the middle"}')
        found = any(message["role"] == "tool" for message in body["messages"])
        return Reply(calls=(CALL if found else look,))

    with serving(says) as server:
        probe(
            *("run", suite, "--model", "mine", "--pointer", "eyes", "--endpoint", server.url),
            *("--epochs", "1", "--workers", "1", "--prices", prices, "--out", tmp_path / "out"),
        )
    (record,) = read_records(tmp_path / "out" / RECORDS)
    assert record.setting == "agentic, pointer openai-api/endpoint/eyes"
    models = [str(body["model"]) for body in asked(server)]
    assert (models[0], models[-1]) == ("mine", "mine") and "eyes" in models
    # The server counts 100 tokens for each request, a dollar each; only the pointer's cost any.
    assert record.participation and record.participation.cost == 100 * models.count("eyes")
    said = refused("audit", tmp_path / "out", "--replay", "all")
    assert "1 can't be replayed: perception asked a model (pointer openai-api/" in said


def test_a_server_that_isnt_there_is_named_and_nothing_is_left(tmp_path):
    suite = suite_file(tmp_path, (COUNT,))
    ended = subprocess.run(
        [sys.executable, "-m", "probe", "run", str(suite), "--model", "mine", "--endpoint",
         "http://127.0.0.1:9/v1", "--out", str(tmp_path / "out")],
        capture_output=True, text=True, timeout=PATIENCE,
    )  # fmt: skip
    assert ended.returncode == 1
    assert "http://127.0.0.1:9/v1 can't be reached (" in ended.stderr
    assert "--endpoint" in ended.stderr and "RetryError" not in ended.stderr
    assert "Traceback" not in ended.stderr
    assert not (tmp_path / "out" / RECORDS).exists()


def test_what_is_missing_is_counted_and_a_failure(tmp_path):
    """A server that dies after its first word: each episode is a fault that names the reason."""
    suite = suite_file(tmp_path, (COUNT, FIND))

    def dies(number: int, body: dict[str, Any]) -> Reply:
        return Reply("Hello.") if number == 0 else Reply(status=400)

    with serving(dies) as server:
        ended = subprocess.run(
            [sys.executable, "-m", "probe", "run", str(suite), "--model", "mine", "--endpoint",
             server.url, "--setting", "blind", "--epochs", "1", "--out", str(tmp_path / "out")],
            capture_output=True, text=True, timeout=PATIENCE,
        )  # fmt: skip
    assert ended.returncode == 1
    told = "probe: 2 of 2 episodes are missing. The same command tries them again.\n"
    assert ended.stderr.endswith(told)
