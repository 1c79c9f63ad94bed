"""`probe collect`: how it begins, and `--model` as users type it, against a local server."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from lessons import BY_KIND, FIRST_SEED
from model_server import Reply, serving
from probe.assets.library import open_library
from probe.cli.collect import CollectionSize
from probe.cli.collect import collect as begin
from probe.cli.teaching import TeachingSetup
from probe.episodes.folder import SUITE
from probe.errors import BadData
from probe.generation.build_folder import BuildFolder, TaskSlot
from probe.tasks.suite_file import read_suite
from probe.train.collect.batches import TASKS, batches
from probe.train.collect.settings import claim
from probe.train.collect.training import FIRST_EPISODE

PATIENCE = 240.0
ONE_COUNT = (
    *("--counts.count", "1", "--counts.find", "0", "--counts.compare", "0"),
    *("--counts.size", "0", "--counts.reduce", "0"),
)
TASK = replace(BY_KIND["count"], id="count-00000001", seed=FIRST_SEED)


def collect(out: Path, *words: str | Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "probe", "collect", "--out", out, "--model", "mine", *words]
    return subprocess.run(
        [*map(str, command), *ONE_COUNT], capture_output=True, text=True, timeout=PATIENCE,
        env=os.environ | {"COLUMNS": "1000"},
    )  # fmt: skip


def make_ready(out: Path, cache: Path) -> None:
    """The task that would be made first."""
    things = open_library("procedural", None, cache)
    BuildFolder(out / TASKS).keep(TaskSlot("count", 2_000_000), TASK, things)


@pytest.mark.slow
@pytest.mark.parametrize(("failures", "missing"), [(1, 0), (99, 1)])
def test_what_a_server_refuses_is_asked_for_again(tmp_path, cache, failures, missing):
    make_ready(tmp_path, cache)
    refused = list[int]()

    def script(number: int, body: dict[str, Any]) -> Reply:
        if "Say hello." in str(body["messages"]):
            return Reply("Hello.")
        if len(refused) < failures:
            refused.append(number)
            return Reply(status=400)
        return Reply(f"ANSWER: {TASK.answer}")

    with serving(script) as server:
        ended = collect(
            *(tmp_path, "--endpoint", server.url, "--settings", "direct", "--workers", "1"),
            *("--most-episodes", "1", "--pool", "procedural"),
        )
    assert ended.returncode == missing, ended.stdout + ended.stderr
    assert f"{missing} missing by our fault" in ended.stdout
    if missing:
        told = "1 of 1 successes are missing. The budget of episodes is spent"
        assert told in ended.stderr
    (grade,) = batches(tmp_path)[0].grades()
    assert grade.correct is (None if missing else True)
    assert len(refused) == (3 if missing else 1)


@pytest.mark.slow
def test_a_model_without_sight_plays_and_is_graded(tmp_path, cache):
    make_ready(tmp_path, cache)
    read = list[str]()

    def script(number: int, body: dict[str, Any]) -> Reply:
        if "Say hello." in str(body["messages"]):
            return Reply("Hello.")
        read.append(str(body["messages"][-1]["content"]))
        if len(read) == 1:
            return Reply(calls=(("perceive_scene", "{}"),))
        return Reply(calls=(("answer_question", f'{{"choice": "{TASK.answer}"}}'),))

    with serving(script) as server:
        ended = collect(
            *(tmp_path, "--endpoint", server.url, "--settings", "text-only", "--graphs", "short"),
            *("--workers", "1", "--most-episodes", "1", "--pool", "procedural"),
        )
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert read[1].startswith("# All that shows, from top to bottom")
    assert TASK.question in read[0] and "data:image" not in str(read)
    (batch,) = batches(tmp_path)
    (record,) = batch.records("text-only", read_suite(batch.folder / SUITE)).values()
    assert record.setting == "text-only, short graphs" and batch.grades()[0].correct


def test_a_collection_has_one_renderer(tmp_path):
    blender = TeachingSetup(renderer="blender")
    assert blender.conditions.label == "renderer blender"
    usual = TeachingSetup().settings("0/1", FIRST_EPISODE)
    # Files of before there was a choice say nothing of it, and go on.
    assert "renderer" not in usual.model_dump_json()
    claim(tmp_path, usual)
    with pytest.raises(BadData, match="was begun with renderer own, not blender"):
        claim(tmp_path, blender.settings("0/1", FIRST_EPISODE))


@pytest.mark.parametrize(
    ("asked", "reason"),
    [
        ({"extent": CollectionSize(settings="text-only")}, r"is for models \(--model\)"),
        ({"site": TeachingSetup(graphs="short")}, "does nothing without --settings text-only"),
    ],
)
def test_options_without_sight_go_together(tmp_path, asked, reason):
    with pytest.raises(BadData, match=reason):
        begin(tmp_path / "out", {"count": 1}, **asked)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("asked", "option"),
    [
        ({"site": TeachingSetup(endpoint="http://localhost:9/v1")}, "--endpoint"),
        ({"site": TeachingSetup(prices=Path("prices.yaml"))}, "--prices"),
        ({"extent": CollectionSize(most_cost=5.0)}, "--most-cost"),
    ],
)
def test_options_of_models_are_refused_without_one(tmp_path, monkeypatch, asked, option):
    monkeypatch.setattr("probe.cli.collect.claim", None)  # before it nothing is done
    told = f"{option}: does nothing without --model.*`probe collect --help`"
    with pytest.raises(BadData, match=told):
        begin(tmp_path / "out", {"count": 1}, **asked)
    assert not (tmp_path / "out").exists()


def test_how_lists_are_told_stays(tmp_path):
    usual = TeachingSetup().settings("0/1", FIRST_EPISODE)
    assert "graphs" not in usual.model_dump_json()
    claim(tmp_path, usual)
    with pytest.raises(BadData, match="was begun with graphs full, not short"):
        claim(tmp_path, TeachingSetup(graphs="short").settings("0/1", FIRST_EPISODE))


def test_a_budget_in_dollars_needs_a_price(tmp_path):
    prices = tmp_path / "prices.yaml"
    prices.write_text("another:\n  tokens_in: 2\n  tokens_out: 10\n")
    ended = collect(tmp_path / "out", "--most-cost", "5", "--prices", prices)
    assert ended.returncode != 0
    assert "--most-cost: nobody knows what tokens cost" in ended.stderr
    assert "with a price of mine" in ended.stderr
    assert not (tmp_path / "out").exists()
